// Fuzzer of the whole program: for any options and any input it prints valid rows or an error, and the same with one
// thread and with four.
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

#include "cli/plan.hpp"
#include "error.hpp"
#include "invariant.hpp"
#include "io/terminal.hpp"
#include "numbers/parse_number.hpp"
#include "read/reader.hpp"
#include "sample/fields.hpp"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

namespace tcb::fuzz {
namespace {

constexpr std::uint64_t most_rows = 300;

std::vector<std::string_view> split(std::string_view text, char delimiter) {
  std::vector<std::string_view> parts;
  for (;;) {
    parts.push_back(text.substr(0, text.find(delimiter)));
    if (parts.back().size() == text.size()) return parts;
    text.remove_prefix(parts.back().size() + 1);
  }
}

/// A file in memory that replaces standard input or output.
class MemoryFile {
 public:
  explicit MemoryFile(int descriptor) : descriptor_(descriptor) {
    const int file = ::memfd_create("fuzz", MFD_CLOEXEC);
    require(file >= 0 && ::dup2(file, descriptor) == descriptor, "no file in memory", "");
    ::close(file);
  }

  void set(std::string_view text) const {
    const bool emptied = ::ftruncate(descriptor_, 0) == 0 && ::lseek(descriptor_, 0, SEEK_SET) == 0;
    const ssize_t count = ::pwrite(descriptor_, text.data(), text.size(), 0);
    require(emptied && count == static_cast<ssize_t>(text.size()), "a file in memory fails", "");
  }

  std::string text() const {
    std::string text(static_cast<std::size_t>(::lseek(descriptor_, 0, SEEK_END)), '\0');
    const ssize_t count = ::pread(descriptor_, text.data(), text.size(), 0);
    require(count == static_cast<ssize_t>(text.size()), "a file in memory fails", "");
    return text;
  }

 private:
  int descriptor_;
};

/// Slashes are allowed in ratios only: the fuzzer uses no file but standard input.
bool names_a_file(std::string_view options) {
  for (std::size_t i = 0; i < options.size(); ++i) {
    const bool ratio = i > 0 && std::isdigit(static_cast<unsigned char>(options[i - 1])) != 0;
    if (options[i] == '@' || (options[i] == '/' && !ratio)) return true;
  }
  return false;
}

/// Jobs that read keys or recordings and write rows, a picture or an explanation.
template <class Product>
concept ReadsFiles = requires(Product job) {
  job.files;
};

/// The job of a line of options, from standard input to standard output with few rows; nothing for other jobs.
std::optional<Job> job_of(std::string_view line) {
  if (names_a_file(line) || find_invalid_utf8(line) != std::string_view::npos) return std::nullopt;
  std::vector<std::string> words{"tcbsample"};
  for (const std::string_view word : split(line, ' ')) {
    if (!word.empty()) words.emplace_back(word.substr(0, word.find('\0')));
  }
  std::vector<const char*> arguments;
  for (const std::string& word : words) arguments.push_back(word.c_str());
  try {
    Job job = tcb::parse(static_cast<int>(arguments.size()), arguments.data());
    const auto limit = []<class Product>(Product& one) {
      if constexpr (ReadsFiles<Product>) {
        one.files = {};
        one.files.files = {"-"};
        if constexpr (requires { one.verbosity; }) one.verbosity = {.quiet = true};
        if constexpr (requires { one.samples; }) {
          std::uint64_t& most = one.samples.request.max_rows;
          most = std::min(most, most_rows);
        }
      }
      return ReadsFiles<Product>;
    };
    return std::visit(limit, job) ? std::optional(job) : std::nullopt;
  } catch (const Error& error) {
    require(error.exit() == Exit::usage, "options refused as if they were data", error_text(error));
    require(error_text(error).starts_with("tcbsample: error: "), "options refused elsewhere", error_text(error));
    return std::nullopt;
  }
}

/// job_of() with a cache of recent lines, because parsing takes longer than everything else.
const std::optional<Job>& parsed(std::string_view line) {
  static std::map<std::string, std::optional<Job>, std::less<>> known;
  constexpr std::size_t most = 4096;
  if (const auto found = known.find(line); found != known.end()) return found->second;
  if (known.size() == most) known.clear();
  return known.emplace(line, job_of(line)).first->second;
}

/// The result: rows, or an error.
struct Outcome {
  std::string out, refusal;
};

/// Runs a job by the entry of its product.
struct Entry {
  Exit operator()(const ResampleJob& job) const { return resample(job); }
  Exit operator()(const ExplainJob& job) const { return explain(job); }
  Exit operator()(const PlotJob& job) const { return plot(job); }
  Exit operator()(const FitJob& job) const { return fit(job); }
  Exit operator()(const auto&) const { return Exit::usage; }
};

Outcome run(Job job, unsigned threads, std::string_view input) {
  static const MemoryFile in(STDIN_FILENO), out(STDOUT_FILENO);
  in.set(input);
  out.set("");
  const auto set_threads = [threads](auto& one) {
    if constexpr (requires { one.threads; }) one.threads.requested = threads;
  };
  std::visit(set_threads, job);
  try {
    require(std::visit(Entry(), job) == Exit::done, "a failure without a refusal", input);
    return {out.text(), {}};
  } catch (const Error& error) {
    require(error.exit() == Exit::data || error.exit() == Exit::usage, "no exit code", error_text(error));
    require_refusal(error_text(error), "standard input");
    return {{}, error_text(error)};
  }
}

/// Every cell of delimited rows is a finite number or empty, and time does not go back.
void require_sound_rows(std::string_view rows, char delimiter, bool ordered) {
  std::optional<Time> last;
  for (const std::string_view row : split(rows, '\n')) {
    if (row.starts_with('#')) continue;  // provenance
    const std::vector<std::string_view> cells = split(row, delimiter);
    for (const std::string_view cell : cells) {
      const bool undefined = cell.empty() || (delimiter == ' ' && cell == "NA");
      require(undefined || parse_number(cell).has_value(), "a cell that is no number", rows);
    }
    const auto time = parse_time(cells[0]);
    require(!ordered || !last || !time || !(*time < *last), "time goes back", rows);
    last = time;  // an empty row begins a new curve
  }
}

/// Checks the rows of a job. Requires: it ended without an error.
template <class Product>
void require_sound(const Product& job, std::string_view text, std::string_view rows) {
  const Format& format = format_of(job.rows.format);
  if (format.family == FormatFamily::array || format.family == FormatFamily::picture) return;
  if (format.name == "json") return require(nlohmann::json::accept(rows), "not JSON", rows);
  if (format.name == "jsonl") {
    for (const std::string_view row : split(rows, '\n')) {
      require(row.empty() || nlohmann::json::accept(row), "not JSON", rows);
    }
    return;
  }
  const auto bytes = [text, read = false]() mutable {
    return std::exchange(read, true) ? std::nullopt : std::optional(std::string(text));
  };
  const Input input = open_input("-", bytes, job.keys.input);
  if (!input.schema.groups.empty() || !input.schema.labels.empty()) return;  // their texts may be anything
  if (job.rows.time_notation || input.schema.time.notation != TimeNotation::seconds) return;  // times are words
  const auto drop_line = [&rows] { rows.remove_prefix(std::min(rows.size(), rows.find('\n') + 1)); };
  while (rows.starts_with('#')) drop_line();  // provenance
  if (job.rows.header.value_or(input.schema.named)) {
    if (rows.substr(0, rows.find('\n')).find('"') != std::string_view::npos) return;
    drop_line();
  }
  bool in_order = true;
  if constexpr (std::is_same_v<Product, ResampleJob>) {
    const Mode mode = job.samples.request.mode;
    in_order = mode != Mode::at && mode != Mode::arc_at;
  }
  const char delimiter = format.name == "csv" ? ',' : format.name == "tsv" ? '\t' : ' ';
  require_sound_rows(rows, delimiter, in_order && fields()[job.rows.fields[0]].name == "time");
}

}  // namespace
}  // namespace tcb::fuzz

namespace {

/// Whole options: bytes that are changed one by one hardly ever make several valid ones.
constexpr auto whole_options = std::to_array<std::string_view>({"--step=0.25",
                                                                "--step=1/3",
                                                                "--step=1e-9",
                                                                "--rate=7",
                                                                "--count=1",
                                                                "--count=4",
                                                                "--segments=3",
                                                                "--per-segment=3",
                                                                "--at=0.5,2,1",
                                                                "--at=-7,9",
                                                                "--arc-step=0.5",
                                                                "--arc-count=1",
                                                                "--arc-count=4",
                                                                "--arc-at=0,1",
                                                                "--tolerance=0.5",
                                                                "--tolerance=1e-9",
                                                                "--tolerance=1,2deg",
                                                                "--tolerance=0.1rad",
                                                                "--fit=0.5",
                                                                "--fit=0.01,x=1",
                                                                "--fit-keys=hermite",
                                                                "--corner=30",
                                                                "--emit=hermite",
                                                                "--emit=bezier",
                                                                "--emit=poly8",
                                                                "--from=1",
                                                                "--from=-3",
                                                                "--from=99",
                                                                "--to=2",
                                                                "--to=99",
                                                                "--to=-3",
                                                                "--end=drop",
                                                                "--end=keep",
                                                                "--end=fit",
                                                                "--end=fit-up",
                                                                "--keys",
                                                                "--extrapolate=hold",
                                                                "--extrapolate=linear",
                                                                "--extrapolate=repeat",
                                                                "--extrapolate=offset",
                                                                "--extrapolate=oscillate",
                                                                "--closed",
                                                                "--period=9",
                                                                "--period=1/3",
                                                                "--equal-speed",
                                                                "--normalize",
                                                                "--rotation=none",
                                                                "--rotation=quaternion=1:2:3:4",
                                                                "--rotation=matrix=1:2:3:5:6:7:9:10:11",
                                                                "--rotation=euler=x:y:z,order=ZYX",
                                                                "--rotation=axis-angle=x:y:z:w,relative",
                                                                "--rotation-output=euler=XZX",
                                                                "--rotation-output=axis-angle",
                                                                "--rotation-output=matrix",
                                                                "--angles=degrees",
                                                                "--metric=rotation",
                                                                "--angle=x=degrees",
                                                                "--angle=1=radians",
                                                                "--rotation-curve=casteljau",
                                                                "--rotation-curve=components",
                                                                "--no-ease",
                                                                "--golden",
                                                                "--exact-input",
                                                                "--preset=3dsmax",
                                                                "--preset=vtk",
                                                                "--tangents=interval-c",
                                                                "--ends=natural",
                                                                "--ends=velocity=1:2",
                                                                "--parameter=0.5",
                                                                "--metric=1",
                                                                "--side=left",
                                                                "--missing=skip-cell",
                                                                "--missing=break",
                                                                "--missing=skip-row",
                                                                "--duplicates=last",
                                                                "--duplicates=break",
                                                                "--sort",
                                                                "--group=1",
                                                                "--columns=carry=2",
                                                                "--no-header",
                                                                "--no-output-header",
                                                                "--meta",
                                                                "--digits=3",
                                                                "--fixed=2",
                                                                "--hex",
                                                                "--output-format=json",
                                                                "--output-format=npy",
                                                                "--input-format=ssv",
                                                                "--decimal=,",
                                                                "--fields=time,s,speed,curvature,torsion",
                                                                "--fields=time,position,key,segment,u",
                                                                "--fields=jerk,arc_error",
                                                                "--fields=s,length",
                                                                "--input-fps=24",
                                                                "--input-fps=30000/1001",
                                                                "--time-unit=ms",
                                                                "--time-format=clock",
                                                                "--time-format=smpte",
                                                                "--time-format=iso",
                                                                "--scale=1=1/3",
                                                                "--rename=2=3"});

/// The line with a whole option more, less, or in the place of another.
std::string with_other_option(std::string_view line, unsigned seed) {
  std::vector<std::string_view> words;
  for (const std::string_view word : tcb::fuzz::split(line, ' ')) {
    if (!word.empty()) words.push_back(word);
  }
  const std::string_view option = whole_options[seed / 64 % whole_options.size()];
  const bool removes = seed / 8 % 4 == 0, replaces = seed / 8 % 4 == 1;
  if ((removes || replaces) && !words.empty()) words.erase(words.begin() + (seed / 32) % words.size());
  if (!removes) words.push_back(option);
  std::string result;
  for (const std::string_view word : words) (result += result.empty() ? "" : " ") += word;
  return result;
}

}  // namespace

/// libFuzzer's mutations, mostly of the input alone, because new options take longer to parse than an input to
/// resample; and other whole options.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed) {
  const std::string_view all(reinterpret_cast<const char*>(data), size);
  const std::size_t input = std::min(all.find('\n'), all.size()) + 1;
  if (seed % 8 == 4 && input <= size) {
    const std::string changed =
        with_other_option(all.substr(0, input - 1), seed) + '\n' + std::string(all.substr(input));
    if (changed.size() <= most) return static_cast<std::size_t>(std::ranges::copy(changed, data).out - data);
  }
  if (seed % 4 == 0 || input > size || input >= most) return LLVMFuzzerMutate(data, size, most);
  return input + LLVMFuzzerMutate(data + input, size - input, most - input);
}

/// The first line is the options, the rest the input.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tcb::fuzz;
  const std::string_view all(reinterpret_cast<const char*>(data), size);
  const std::string_view line = all.substr(0, all.find('\n'));
  const std::string_view input = all.substr(std::min(all.size(), line.size() + 1));
  const auto& plan = parsed(line);
  if (!plan) return 0;
  const Outcome outcome = run(*plan, 1, input);
  const auto check_rows = [&](const auto& job) {
    if constexpr (requires { job.rows; }) require_sound(job, input, outcome.out);
  };
  if (outcome.refusal.empty()) std::visit(check_rows, *plan);
  if (size % 4 != 0) return 0;
  const Outcome threaded = run(*plan, 4, input);
  require_same(outcome.out, threaded.out, "-j 1 and -j 4");
  require_same(outcome.refusal, threaded.refusal, "-j 1 and -j 4");
  return 0;
}
