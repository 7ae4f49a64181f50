// Input files: their bytes as they arrive, and what kind of file a path is.
#include "io/input_file.hpp"

#include <memory>
#include <optional>
#include <utility>

#include "io/errors.hpp"
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

Error reading_failed() { return system::failed_as_folder() ? input_is_folder() : cannot_read(system::error_text()); }

int open_for_reading(const std::string& path) {
  if (path == "-") return system::standard_input;
  const int descriptor = system::open_to_read(path);
  if (descriptor >= 0) return descriptor;
  const Error error = system::failed_as_folder() ? input_is_folder() : cannot_open(system::error_text());
  throw error.in(shown_name(path));
}

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

bool ChangeWatch::has_changed() const { return before_ && system::status_of(path_) != before_; }

Source<std::string> read_file(const std::string& path) {
  const auto file = std::make_shared<Descriptor>(open_for_reading(path));
  const system::FileStatus before = system::status_of(file->number).value_or(system::FileStatus());
  const bool small = before.is_regular && before.size < read_size;
  const std::size_t room = small ? static_cast<std::size_t>(before.size) + 1 : read_size;
  return [file, path, before, room]() -> std::optional<std::string> {
    std::string bytes(room, '\0');
    const std::ptrdiff_t count = system::read(file->number, bytes.data(), bytes.size());
    if (count < 0) throw reading_failed().in(shown_name(path));
    if (count == 0) {
      const bool changed = before.is_regular && system::status_of(file->number) != before;
      if (changed) throw input_changed().in(shown_name(path));
      return std::nullopt;
    }
    bytes.resize(static_cast<std::size_t>(count));
    return bytes;
  };
}

}  // namespace tcb
