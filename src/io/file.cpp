// Files: bytes in as they come; bytes out, whole or not at all.
#include "io/file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cstring>
#include <filesystem>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>

#include "error.hpp"
#include "io/unfinished.hpp"

namespace tcb {
namespace {

constexpr std::size_t read_size = 256UL * 1024;
constexpr std::size_t write_size = 32UL * 1024;

/// An open file that closes itself; standard input stays open.
struct Descriptor {
  int number = 0;
  explicit Descriptor(int opened) : number(opened) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (number > 2) ::close(number);
  }
};

struct stat status_of(int descriptor) {
  struct stat status {};
  (void)::fstat(descriptor, &status);
  return status;
}

bool is_same(const struct stat& a, const struct stat& b) {
  return a.st_size == b.st_size && a.st_mtim.tv_sec == b.st_mtim.tv_sec && a.st_mtim.tv_nsec == b.st_mtim.tv_nsec;
}

/// Whether what failed is to be tried again; waits until it may succeed.
bool is_to_repeat(int descriptor, short events) {
  if (errno == EINTR) return true;
  if (errno != EAGAIN && errno != EWOULDBLOCK) return false;
  pollfd ready{descriptor, events, 0};
  (void)::poll(&ready, 1, -1);
  return true;
}

[[noreturn]] void fail(const std::string& path, const char* what) {
  const char* const remedy = errno == EISDIR ? "; give --recursive and --output-dir for the files in it" : "";
  throw Error(Exit::usage, TextPosition{shown_name(path)}, fmt::format("{}: {}{}", what, std::strerror(errno), remedy));
}

[[noreturn]] void refuse_change(const std::string& path) {
  throw Error(Exit::usage, TextPosition{shown_name(path)},
              "it changed while it was read; expected a file at rest; wait until it is written, or read what is there "
              "of it from a pipe, as in cat FILE | tcbsample");
}

/// The number of a descriptor that the program was given, from a name such as /dev/stdout or /dev/fd/3: what is written
/// there goes on behind what others wrote, also where that is a file.
std::optional<int> own_descriptor(std::string_view path) {
  if (path == "/dev/stdout") return STDOUT_FILENO;
  if (path == "/dev/stderr") return STDERR_FILENO;
  for (const std::string_view folder : {"/dev/fd/", "/proc/self/fd/"}) {
    if (!path.starts_with(folder)) continue;
    const std::string_view number = path.substr(folder.size());
    int descriptor = -1;
    const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), descriptor);
    if (error == std::errc() && end == number.data() + number.size()) return descriptor;
  }
  return std::nullopt;
}

int open_for_reading(const std::string& path) {
  if (path == "-") return STDIN_FILENO;
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) fail(path, "cannot be opened");
  return descriptor;
}

}  // namespace

void keep_standard_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (::fcntl(stream, F_GETFD) < 0) (void)::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
  }
}

std::string shown_name(const std::string& path) { return path == "-" ? "standard input" : path; }

bool is_live(const std::string& path) {
  struct stat status {};
  const int failed = path == "-" ? ::fstat(STDIN_FILENO, &status) : ::stat(path.c_str(), &status);
  return failed == 0 && !S_ISREG(status.st_mode);
}

Source<std::string> read_file(const std::string& path) {
  const auto file = std::make_shared<Descriptor>(open_for_reading(path));
  const struct stat before = status_of(file->number);
  const bool small = S_ISREG(before.st_mode) && static_cast<std::size_t>(before.st_size) < read_size;
  const std::size_t room = small ? static_cast<std::size_t>(before.st_size) + 1 : read_size;
  return [file, path, before, room]() -> std::optional<std::string> {
    std::string bytes(room, '\0');
    ssize_t count = 0;
    do {
      count = ::read(file->number, bytes.data(), bytes.size());
    } while (count < 0 && is_to_repeat(file->number, POLLIN));
    if (count < 0) fail(path, "cannot be read");
    if (count == 0) {
      if (S_ISREG(before.st_mode) && !is_same(before, status_of(file->number))) refuse_change(path);
      return std::nullopt;
    }
    bytes.resize(static_cast<std::size_t>(count));
    return bytes;
  };
}

std::string folder_of(const std::string& path) { return std::filesystem::path(path).parent_path(); }

void make_folder(const std::string& path) {
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error) throw Error(Exit::usage, TextPosition{path}, fmt::format("cannot be made: {}", error.message()));
}

Output::Output(std::string path, bool begins_last) : path_(std::move(path)) {
  open();
  if (!begins_last || unfinished_) return;
  spool_.reset(std::tmpfile());
  if (spool_ == nullptr) fail("needs a temporary file, which cannot be made");
}

void Output::open() {
  if (path_ == "-") return;
  if (const auto own = own_descriptor(path_)) {
    descriptor_ = ::dup(*own);
    if (descriptor_ < 0) fail("cannot be written");
    return;
  }
  std::error_code none;
  const auto kind = std::filesystem::status(path_, none).type();
  if (kind == std::filesystem::file_type::regular) path_ = std::filesystem::canonical(path_, none);  // behind any link
  const bool device = kind != std::filesystem::file_type::regular && kind != std::filesystem::file_type::not_found;
  if (device) {  // /dev/null or a pipe: written to as it is
    descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CLOEXEC);
    if (descriptor_ < 0) fail("cannot be written");
    return;
  }
  struct stat before {};
  const bool replaces = ::stat(path_.c_str(), &before) == 0;  // it keeps the permissions of the file before it
  descriptor_ = create_unfinished(path_, replaces ? S_IRUSR | S_IWUSR : 0666, temporary_);
  unfinished_ = descriptor_ >= 0;
  if (!unfinished_) fail("cannot be written");
  if (replaces && ::fchmod(descriptor_, before.st_mode & 07777U) != 0) {
    const int reason = errno;
    remove();
    errno = reason;
    fail("cannot be written");
  }
}

Output::~Output() { remove(); }

void Output::remove() {
  if (!temporary_.empty()) discard(temporary_);  // while it has the lock
  temporary_.clear();
  if (descriptor_ > 2) ::close(std::exchange(descriptor_, -1));
}

void Output::fail(const char* what) const {
  const std::string name = path_ == "-" ? "standard output" : path_;
  throw Error(Exit::usage, TextPosition{name}, fmt::format("{}: {}", what, std::strerror(errno)));
}

void Output::write(std::string_view text) {
  if (!live_ && text.size() < write_size) {
    pending_ += text;
    if (pending_.size() >= write_size) flush();
    return;
  }
  flush();
  put(text);
}

void Output::flush() {
  put(pending_);
  pending_.clear();
}

void Output::put(std::string_view text) { send(spool_ == nullptr ? descriptor_ : ::fileno(spool_.get()), text); }

void Output::send(int descriptor, std::string_view bytes) const {
  while (!bytes.empty()) {
    const ssize_t count = ::write(descriptor, bytes.data(), bytes.size());
    if (count < 0 && is_to_repeat(descriptor, POLLOUT)) continue;
    if (count < 0) fail("cannot be written");
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
}

void Output::write_beginning(std::string_view bytes) {
  flush();
  const int descriptor = spool_ == nullptr ? descriptor_ : ::fileno(spool_.get());
  if (::lseek(descriptor, 0, SEEK_SET) < 0) fail("cannot be written");
  send(descriptor, bytes);
  if (::lseek(descriptor, 0, SEEK_END) < 0) fail("cannot be written");
}

void Output::send_spooled() {
  const int spool = ::fileno(spool_.get());
  if (::lseek(spool, 0, SEEK_SET) < 0) fail("cannot be written");
  std::string bytes(write_size, '\0');
  for (ssize_t count = 1; count != 0;) {
    count = ::read(spool, bytes.data(), bytes.size());
    if (count < 0 && errno != EINTR) fail("cannot be read back from the temporary file");
    if (count > 0) send(descriptor_, {bytes.data(), static_cast<std::size_t>(count)});
  }
  spool_.reset();
}

void Output::commit() {
  flush();
  if (spool_ != nullptr) send_spooled();
  if (path_ == "-") return;
  if (unfinished_) {
    if (!finish(descriptor_, temporary_, path_)) fail("cannot be written");
    temporary_.clear();
  }
  if (::close(std::exchange(descriptor_, -1)) != 0) fail("cannot be written");
}

}  // namespace tcb
