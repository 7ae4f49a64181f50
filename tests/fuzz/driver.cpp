// The main program of a fuzzer for compilers without libFuzzer, such as GCC. It takes the options of libFuzzer that
// tests/fuzz/run gives, and folders of a corpus: it runs the files of the corpus, and then mutations of these and of
// inputs of random bytes. An input that crashes the program, or takes too long, is saved as crash-input.
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <random>
#include <string>
#include <string_view>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
extern "C" __attribute__((weak)) std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                                                     std::size_t most, unsigned seed);
extern "C" __attribute__((weak)) int LLVMFuzzerInitialize(int* count, char*** arguments);

namespace {

using Bytes = std::vector<std::uint8_t>;

std::mt19937 random_number(1);
std::vector<std::string> words;  // of the dictionary
Bytes input;                     // that is running

std::size_t below(std::size_t end) { return end == 0 ? 0 : random_number() % end; }

void save_input(int) {
  if (FILE* const file = std::fopen("crash-input", "wb")) {
    (void)std::fwrite(input.data(), 1, input.size(), file);
    (void)std::fclose(file);
  }
  (void)std::fputs("the input is in crash-input\n", stderr);
  ::_exit(1);
}

/// The words in quotes of a dictionary, with its escapes \xHH, \\ and \".
void read_dictionary(const std::string& path) {
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    const std::size_t begin = line.find('"');
    if (line.starts_with('#') || begin == std::string::npos) continue;
    std::string word;
    for (std::size_t i = begin + 1; i + 1 < line.size(); ++i) {
      if (line[i] == '\\' && line[i + 1] == 'x') {
        word += static_cast<char>(std::stoi(line.substr(i + 2, 2), nullptr, 16));
        i += 3;
      } else {
        word += line[i] == '\\' ? line[++i] : line[i];
      }
    }
    words.push_back(word);
  }
}

}  // namespace

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most) {
  Bytes bytes(data, data + size);
  for (std::size_t changes = 1 + below(4); changes > 0; --changes) {
    const auto at = bytes.begin() + static_cast<std::ptrdiff_t>(below(bytes.size() + 1));
    const auto end = at + static_cast<std::ptrdiff_t>(
                              below(std::min<std::size_t>(16, static_cast<std::size_t>(bytes.end() - at) + 1)));
    switch (below(5)) {
      case 0:
        if (at != bytes.end()) *at = static_cast<std::uint8_t>(below(256));
        break;
      case 1: bytes.insert(at, static_cast<std::uint8_t>(below(256))); break;
      case 2: bytes.erase(at, end); break;
      case 3: {
        const Bytes copy(at, end);
        const std::size_t place = below(bytes.size() + 1);
        bytes.insert(bytes.begin() + static_cast<std::ptrdiff_t>(place), copy.begin(), copy.end());
        break;
      }
      default:
        if (!words.empty()) {
          const std::string& word = words[below(words.size())];
          bytes.insert(at, word.begin(), word.end());
        }
    }
  }
  size = std::min(bytes.size(), most);
  std::copy_n(bytes.begin(), size, data);
  return size;
}

int main(int count, char** arguments) {
  std::map<std::string, std::size_t, std::less<>> options{
      {"seed", 1}, {"runs", 1000}, {"max_len", 256}, {"timeout", 10}, {"rss_limit_mb", 1024}};
  if (LLVMFuzzerInitialize != nullptr) LLVMFuzzerInitialize(&count, &arguments);
  std::vector<Bytes> corpus{{}};
  for (int i = 1; i < count; ++i) {
    const std::string argument = arguments[i];
    const std::size_t equals = argument.find('=');
    if (argument.starts_with("-dict=")) {
      read_dictionary(argument.substr(equals + 1));
    } else if (argument.starts_with("-")) {
      options[argument.substr(1, equals - 1)] = std::stoull(argument.substr(equals + 1));
    } else {
      for (const auto& entry : std::filesystem::directory_iterator(argument)) {
        std::ifstream file(entry.path(), std::ios::binary);
        corpus.emplace_back(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
      }
    }
  }
  std::ranges::sort(corpus);
  random_number.seed(static_cast<unsigned>(options["seed"]));
  const rlimit memory{options["rss_limit_mb"] << 20, options["rss_limit_mb"] << 20};
  (void)::setrlimit(RLIMIT_DATA, &memory);
  for (const int fault : {SIGSEGV, SIGABRT, SIGFPE, SIGBUS, SIGILL, SIGALRM}) (void)std::signal(fault, save_input);

  const std::size_t most = options["max_len"];
  for (std::size_t run = 0; run < options["runs"]; ++run) {
    input = run < corpus.size() ? corpus[run] : corpus[below(corpus.size())];
    if (run >= corpus.size()) {
      if (below(4) == 0) {
        input.resize(1 + below(most));
        for (std::uint8_t& byte : input) byte = static_cast<std::uint8_t>(below(256));
      }
      const std::size_t size = std::min(input.size(), most);
      input.resize(most);
      input.resize(LLVMFuzzerCustomMutator != nullptr
                       ? LLVMFuzzerCustomMutator(input.data(), size, most, static_cast<unsigned>(random_number()))
                       : LLVMFuzzerMutate(input.data(), size, most));
    }
    ::alarm(static_cast<unsigned>(options["timeout"]));
    LLVMFuzzerTestOneInput(input.data(), input.size());
  }
  ::alarm(0);
  (void)std::fprintf(stderr, "stat::number_of_executed_units: %zu\n", options["runs"]);
  return 0;
}
