// Input files: their bytes as they arrive, what kind of file a path is, and SHA-256 of bytes.
#include "io/input_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <nettle/sha2.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <memory>
#include <optional>
#include <utility>

#include "io/errors.hpp"

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
    if (number > 2) ::close(number);
  }
};

struct stat status_of(int descriptor) {
  struct stat status {};
  (void)::fstat(descriptor, &status);
  return status;
}

bool is_same(const struct stat& a, const struct stat& b) {
  const auto same_time = [](const timespec& x, const timespec& y) {
    return x.tv_sec == y.tv_sec && x.tv_nsec == y.tv_nsec;
  };
  return a.st_dev == b.st_dev && a.st_ino == b.st_ino && a.st_size == b.st_size && same_time(a.st_mtim, b.st_mtim) &&
         same_time(a.st_ctim, b.st_ctim);
}

int open_for_reading(const std::string& path) {
  if (path == "-") return STDIN_FILENO;
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) throw cannot_open(std::strerror(errno)).in(shown_name(path));
  return descriptor;
}

}  // namespace

bool is_to_repeat(int descriptor, short events) {
  if (errno == EINTR) return true;
  if (errno != EAGAIN && errno != EWOULDBLOCK) return false;
  pollfd ready{descriptor, events, 0};
  (void)::poll(&ready, 1, -1);
  return true;
}

void keep_standard_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (::fcntl(stream, F_GETFD) < 0) (void)::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
  }
}

std::string shown_name(const std::string& path) { return path == "-" ? "standard input" : path; }

bool is_terminal(const std::string& path) { return path == "-" && ::isatty(STDIN_FILENO) != 0; }

bool is_live(const std::string& path) {
  struct stat status {};
  const int failed = path == "-" ? ::fstat(STDIN_FILENO, &status) : ::stat(path.c_str(), &status);
  return failed == 0 && !S_ISREG(status.st_mode);
}

ChangeWatch::ChangeWatch(std::string path) : path_(std::move(path)) {
  struct stat status {};
  if (path_ != "-" && ::stat(path_.c_str(), &status) == 0 && S_ISREG(status.st_mode)) before_ = status;
}

bool ChangeWatch::has_changed() const {
  struct stat now {};
  return before_ && (::stat(path_.c_str(), &now) != 0 || !is_same(*before_, now));
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
    if (count < 0) throw(errno == EISDIR ? input_is_folder() : cannot_read(std::strerror(errno))).in(shown_name(path));
    if (count == 0) {
      const bool changed = S_ISREG(before.st_mode) && !is_same(before, status_of(file->number));
      if (changed) throw input_changed().in(shown_name(path));
      return std::nullopt;
    }
    bytes.resize(static_cast<std::size_t>(count));
    return bytes;
  };
}

struct Sha256::State {
  sha256_ctx context;
};

Sha256::Sha256() : state_(std::make_unique<State>()) { sha256_init(&state_->context); }
Sha256::Sha256(Sha256&&) noexcept = default;
Sha256& Sha256::operator=(Sha256&&) noexcept = default;
Sha256::~Sha256() = default;

void Sha256::add(std::string_view bytes) {
  sha256_update(&state_->context, bytes.size(), reinterpret_cast<const std::uint8_t*>(bytes.data()));
}

std::string Sha256::digest() {
  std::array<std::uint8_t, SHA256_DIGEST_SIZE> digest{};
  sha256_digest(&state_->context, digest.size(), digest.data());
  std::string text;
  for (const std::uint8_t byte : digest) text += fmt::format("{:02x}", byte);
  return text;
}

}  // namespace tcb
