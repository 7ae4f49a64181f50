// System: files, terminals and interruptions by POSIX.
#include <fcntl.h>
#include <poll.h>
#include <sys/file.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <span>
#include <system_error>
#include <thread>

#include "io/system.hpp"

namespace tcb::system {
namespace {

std::int64_t nanoseconds(const timespec& time) { return std::int64_t{time.tv_sec} * 1'000'000'000 + time.tv_nsec; }

std::optional<FileStatus> as_status(int result, const struct stat& status) {
  if (result != 0) return std::nullopt;
  constexpr mode_t permissions = 0777;  // without setuid and setgid
  return FileStatus{S_ISREG(status.st_mode),        static_cast<std::uintmax_t>(status.st_size),
                    nanoseconds(status.st_mtim),    nanoseconds(status.st_ctim),
                    {status.st_dev, status.st_ino}, status.st_mode & permissions};
}

/// Whether a failed read or write has to be repeated; waits until it may succeed. `events`: those of poll().
bool is_to_repeat(int descriptor, short events) {
  if (errno == EINTR) return true;
  if (errno != EAGAIN && errno != EWOULDBLOCK) return false;
  pollfd ready{descriptor, events, 0};
  (void)::poll(&ready, 1, -1);
  return true;
}

constexpr std::array interruptions{SIGINT, SIGTERM, SIGHUP};

/// The other signals that end a program unless it handles them, without those of faults in it.
constexpr std::array further_signals{SIGQUIT, SIGALRM, SIGVTALRM, SIGPROF, SIGXCPU, SIGUSR1, SIGUSR2};

/// Adds those of the signals that the caller of the program does not ignore.
void add_unless_ignored(sigset_t& set, std::span<const int> signals) {
  for (const int signal : signals) {
    struct sigaction action {};
    if (::sigaction(signal, nullptr, &action) == 0 && action.sa_handler != SIG_IGN) ::sigaddset(&set, signal);
  }
}

void (*end_program)() = nullptr;

}  // namespace

std::vector<std::string> arguments(int argc, char** argv) { return {argv + std::min(argc, 1), argv + argc}; }

std::string error_text() { return std::strerror(errno); }
bool already_exists() { return errno == EEXIST; }
bool failed_as_folder() { return errno == EISDIR; }
bool failed_as_closed_pipe() { return errno == EPIPE; }

std::optional<FileStatus> status_of(const std::string& path) {
  struct stat status {};
  return as_status(::stat(path.c_str(), &status), status);
}

std::optional<FileStatus> status_of(int descriptor) {
  struct stat status {};
  return as_status(::fstat(descriptor, &status), status);
}

bool may_write(const std::string& path) { return ::faccessat(AT_FDCWD, path.c_str(), W_OK, AT_EACCESS) == 0; }

void make_older(const std::string& path, const std::string& than) {
  struct stat status {};
  if (::stat(than.c_str(), &status) != 0) return;
  timespec time = status.st_mtim;
  if (--time.tv_nsec < 0) {
    time.tv_nsec = 999'999'999;
    --time.tv_sec;
  }
  const std::array times{timespec{0, UTIME_OMIT}, time};
  (void)::utimensat(AT_FDCWD, path.c_str(), times.data(), 0);
}

int open_to_read(const std::string& path) { return ::open(path.c_str(), O_RDONLY | O_CLOEXEC); }
int open_to_write(const std::string& path) { return ::open(path.c_str(), O_WRONLY | O_CLOEXEC); }
int duplicate(int descriptor) { return ::dup(descriptor); }

/// An interrupted call has closed the descriptor, too.
bool close(int descriptor) { return ::close(descriptor) == 0 || errno == EINTR; }

/// File systems report late failures whenever one of the descriptors of a file is closed.
bool complete(int descriptor) {
  const int other = ::dup(descriptor);
  return other >= 0 && close(other);
}

std::ptrdiff_t read(int descriptor, char* bytes, std::size_t size) {
  ssize_t count = 0;
  do {
    count = ::read(descriptor, bytes, size);
  } while (count < 0 && is_to_repeat(descriptor, POLLIN));
  return count;
}

bool wait_to_read(int descriptor, std::chrono::milliseconds most) {
  pollfd ready{descriptor, POLLIN, 0};
  return ::poll(&ready, 1, static_cast<int>(most.count())) != 0;  // if it fails, reading tells why
}

std::ptrdiff_t read_at(int descriptor, std::uint64_t place, char* bytes, std::size_t size) {
  ssize_t count = 0;
  do {
    count = ::pread(descriptor, bytes, size, static_cast<off_t>(place));
  } while (count < 0 && errno == EINTR);
  return count;
}

std::uint64_t place_in(int descriptor) {
  const off_t place = ::lseek(descriptor, 0, SEEK_CUR);
  return place < 0 ? 0 : static_cast<std::uint64_t>(place);
}

bool write(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::write(descriptor, bytes.data(), bytes.size());
    if (count < 0 && is_to_repeat(descriptor, POLLOUT)) continue;
    if (count < 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

bool go_to_begin(int descriptor) { return ::lseek(descriptor, 0, SEEK_SET) >= 0; }
bool go_to_end(int descriptor) { return ::lseek(descriptor, 0, SEEK_END) >= 0; }

void keep_standard_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (::fcntl(stream, F_GETFD) < 0) (void)::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
  }
}

/// Not all file systems have such files, and /proc gives them their names.
int create_unnamed(const std::string& folder, unsigned permissions) {
  if (::access("/proc/self/fd", X_OK) != 0) return -1;
  return ::open(folder.empty() ? "." : folder.c_str(), O_WRONLY | O_TMPFILE | O_CLOEXEC, permissions);
}

bool give_name(int descriptor, const std::string& name) {
  const std::string open_file = "/proc/self/fd/" + std::to_string(descriptor);
  return ::linkat(AT_FDCWD, open_file.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0;
}

int create(const std::string& name, unsigned permissions) {
  return ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, permissions);
}

int create_temporary() {
  std::FILE* const file = std::tmpfile();
  if (file == nullptr) return -1;
  const int descriptor = ::dup(::fileno(file));
  (void)std::fclose(file);
  return descriptor;
}

bool set_permissions(int descriptor, unsigned permissions) { return ::fchmod(descriptor, permissions) == 0; }
bool replace(const std::string& name, const std::string& replaced) {
  return std::rename(name.c_str(), replaced.c_str()) == 0;
}
void remove(const std::string& name) { (void)::unlink(name.c_str()); }

/// Waits for a program that is about to remove the file.
void mark_as_written(int descriptor) { (void)::flock(descriptor, LOCK_EX); }

bool has_name(int descriptor) {
  struct stat status {};
  return ::fstat(descriptor, &status) != 0 || status.st_nlink > 0;
}

void remove_unless_written(const std::string& name) {
  const int descriptor = ::open(name.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  if (descriptor < 0) return;
  if (::flock(descriptor, LOCK_EX | LOCK_NB) == 0) remove(name);
  (void)::close(descriptor);
}

bool is_terminal(int descriptor) { return ::isatty(descriptor) != 0; }

std::size_t terminal_width() {
  constexpr std::size_t usual = 80;
  winsize size{};
  const bool known = ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return known ? size.ws_col : usual;
}

bool has_colors() {
  const char* const type = std::getenv("TERM");
  return is_terminal(STDERR_FILENO) && type != nullptr && *type != '\0' && std::string_view(type) != "dumb";
}

void end_now(int exit) { ::_exit(exit); }

void end_by_closed_pipe() {
  (void)std::signal(SIGPIPE, SIG_DFL);
  sigset_t signals;
  ::sigemptyset(&signals);
  ::sigaddset(&signals, SIGPIPE);
  ::pthread_sigmask(SIG_UNBLOCK, &signals, nullptr);
  (void)std::raise(SIGPIPE);
  end_now(128 + SIGPIPE);  // not reached
}

void call_when_interrupted(void (*end)()) {
  end_program = end;
  (void)std::signal(SIGPIPE, SIG_IGN);
  (void)std::signal(SIGXFSZ, SIG_IGN);
  sigset_t signals;
  ::sigemptyset(&signals);
  add_unless_ignored(signals, interruptions);
  struct sigaction action {};
  action.sa_handler = [](int) { end_program(); };
  for (const int signal : interruptions) {
    if (::sigismember(&signals, signal) == 1) ::sigaction(signal, &action, nullptr);
  }
}

void call_in_thread_when_interrupted(void (*end)()) {
  sigset_t signals;
  ::sigemptyset(&signals);
  add_unless_ignored(signals, interruptions);
  add_unless_ignored(signals, further_signals);
  ::pthread_sigmask(SIG_BLOCK, &signals, nullptr);  // in all threads created from here on
  const auto wait = [end, signals] {  // only this thread receives the signals, so it may call any function
    int signal = 0;
    while (::sigwait(&signals, &signal) != 0) {
    }
    end();
  };
  try {
    std::thread(wait).detach();
  } catch (const std::system_error&) {
    ::pthread_sigmask(SIG_UNBLOCK, &signals, nullptr);  // no thread available: they end the program without cleanup
  }
}

}  // namespace tcb::system
