// Input files: their bytes as they arrive, and what kind of file a path is.
#include "io/input_file.hpp"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstring>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "error.hpp"
#include "io/system.hpp"

namespace tcb {
namespace {

constexpr std::size_t read_size = 256UL * 1024;

/// An open file that closes itself; standard input stays open.
struct Descriptor {
  int number = 0;
  explicit Descriptor(int opened) : number(opened) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (number > system::standard_error) (void)system::close(number);
  }
};

/// Why a file cannot be opened or read.
Error failed_to_be(std::string_view used, const std::string& path) {
  const Error error =
      system::failed_as_folder()
          ? usage_error(
                "this is a folder; expected a file; give --recursive and --output-dir to process the files in it")
          : usage_error("cannot be {}: {}", used, system::error_text());
  return error.in(shown_name(path));
}

int open_for_reading(const std::string& path) {
  if (path == "-") return system::standard_input;
  const int descriptor = system::open_to_read(path);
  if (descriptor < 0) throw failed_to_be("opened", path);
  return descriptor;
}

/// A number that other bytes hardly ever have, in a fraction of the time that they take to be read as numbers.
std::uint64_t checksum(std::string_view bytes) {
  constexpr std::uint64_t factor = 0x9E3779B97F4A7C15;  // odd, so that each word counts
  std::uint64_t sum = bytes.size();
  for (std::uint64_t word = 0; bytes.size() >= sizeof word; bytes.remove_prefix(sizeof word)) {
    std::memcpy(&word, bytes.data(), sizeof word);
    sum = sum * factor + word;
  }
  for (const char c : bytes) sum = sum * factor + static_cast<unsigned char>(c);
  return sum;
}

/// The parts of a regular file that were read, as far as they tell whether it still has the same bytes.
class ReadParts {
 public:
  explicit ReadParts(int descriptor)
      : descriptor_(descriptor),
        begin_(system::place_in(descriptor)),
        before_(system::status_of(descriptor).value_or(system::FileStatus())) {}

  const system::FileStatus& before() const { return before_; }

  void add(std::string_view bytes) {
    if (before_.is_regular) parts_.push_back({bytes.size(), checksum(bytes)});
  }

  /// Whether the whole file was read as it was in the beginning. Where only its links, name or mode may have changed,
  /// it is read once more.
  bool are_whole() const {
    if (!before_.is_regular) return true;
    const auto now = system::status_of(descriptor_);
    if (!now || !now->seems_unmodified_since(before_)) return false;
    return now->changed == before_.changed || have_same_bytes();
  }

 private:
  struct Part {
    std::size_t size;
    std::uint64_t sum;
  };

  bool have_same_bytes() const {
    std::uint64_t place = begin_;
    std::string bytes;
    return std::ranges::all_of(parts_, [&](const Part& part) {
      bytes.resize(part.size);
      for (std::size_t read = 0; read < part.size;) {
        const std::ptrdiff_t count = system::read_at(descriptor_, place + read, bytes.data() + read, part.size - read);
        if (count <= 0) return false;
        read += static_cast<std::size_t>(count);
      }
      place += part.size;
      return checksum(bytes) == part.sum;
    });
  }

  int descriptor_;
  std::uint64_t begin_;  ///< the place of the first part; standard input may begin within a file
  system::FileStatus before_;
  std::vector<Part> parts_;
};

/// Waits for a live input, so long in total.
class Patience {
 public:
  using Milliseconds = std::chrono::milliseconds;

  explicit Patience(Milliseconds total) : left_(total) {}

  /// Whether there are bytes or the end at once, or after a wait of at most `most`.
  bool wait(int descriptor, Milliseconds most) {
    const auto begin = Clock::now();
    const bool arrives = system::wait_to_read(descriptor, std::min(most, std::chrono::ceil<Milliseconds>(left_)));
    left_ -= std::min(left_, Clock::now() - begin);
    return arrives;
  }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::duration left_;
};

/// Reads parts of an input. While the first lines of a live one arrive, it gathers what comes without a pause.
class FirstParts {
 public:
  explicit FirstParts(bool is_regular) : lines_(is_regular ? 0 : gathered_lines) {}

  /// Fills the text as far as possible; how many bytes it got, 0 at the end, or -1.
  std::ptrdiff_t read(int descriptor, std::string& bytes) {
    if (is_at_end_) return 0;
    constexpr Patience::Milliseconds pause(100), total(250);
    Patience patience(total);
    std::ptrdiff_t count = system::read(descriptor, bytes.data(), bytes.size());
    while (count > 0 && lines_ > 0 && patience.wait(descriptor, pause)) {
      const std::size_t filled = static_cast<std::size_t>(count);
      const std::ptrdiff_t more = system::read(descriptor, bytes.data() + filled, bytes.size() - filled);
      is_at_end_ = more == 0 && filled < bytes.size();
      if (more <= 0) break;
      count += more;
    }
    if (count > 0 && lines_ > 0) lines_ -= std::min(lines_, std::count(bytes.begin(), bytes.begin() + count, '\n'));
    return count;
  }

 private:
  static constexpr std::ptrdiff_t gathered_lines = 16;
  std::ptrdiff_t lines_;  ///< to be gathered
  bool is_at_end_ = false;
};

}  // namespace

std::string shown_name(const std::string& path) { return path == "-" ? "standard input" : path; }

bool is_terminal(const std::string& path) { return path == "-" && system::is_terminal(system::standard_input); }

bool is_live(const std::string& path) {
  const auto status = path == "-" ? system::status_of(system::standard_input) : system::status_of(path);
  return status && !status->is_regular;
}

ChangeWatch::ChangeWatch(std::string path) : path_(std::move(path)) {
  const auto status = path_ == "-" ? std::nullopt : system::status_of(path_);
  if (status && status->is_regular) before_ = status;
}

FileChange ChangeWatch::change() const {
  if (!before_) return FileChange::none;
  const auto now = system::status_of(path_);
  if (!now || !now->seems_unmodified_since(*before_)) return FileChange::contents;
  return now->changed == before_->changed ? FileChange::none : FileChange::contents_or_status;
}

InputBytes open_file(const std::string& path) {
  const auto file = std::make_shared<Descriptor>(open_for_reading(path));
  const auto parts = std::make_shared<ReadParts>(file->number);
  const system::FileStatus& before = parts->before();
  const bool small = before.is_regular && before.size < read_size;
  const std::size_t room = small ? static_cast<std::size_t>(before.size) + 1 : read_size;
  const auto read = [file, path, parts, room,
                     parts_read = FirstParts(before.is_regular)]() mutable -> std::optional<std::string> {
    std::string bytes(room, '\0');
    const std::ptrdiff_t count = parts_read.read(file->number, bytes);
    if (count < 0) throw failed_to_be("read", path);
    if (count == 0) {
      if (!parts->are_whole())
        throw usage_error(
            "the file changed while it was read; expected a complete file; wait until it is written, or read what it "
            "holds so far through a pipe, as in cat FILE | tcbsample")
            .in(shown_name(path));
      return std::nullopt;
    }
    bytes.resize(static_cast<std::size_t>(count));
    parts->add(bytes);
    return bytes;
  };
  if (before.is_regular) return {read, [] { return true; }};
  const std::chrono::milliseconds most = std::chrono::seconds(1);
  return {read, [file, most, patience = Patience(most)]() mutable { return patience.wait(file->number, most); }};
}

}  // namespace tcb
