// Atomic outputs: temporary files with locks, which get their final name when they are complete; interruptions.
#include "io/atomic_output.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <mutex>
#include <optional>
#include <set>
#include <system_error>
#include <thread>
#include <utility>

#include "io/errors.hpp"
#include "io/input_file.hpp"
#include "io/terminal.hpp"

namespace tcb {
namespace {

constexpr std::size_t write_size = 32UL * 1024;

/// The names of all unfinished files; never destroyed, because a signal may arrive while the program ends.
struct TemporaryFiles {
  std::mutex mutex;
  std::set<std::string> all;
};
TemporaryFiles& temporary_files() {
  static TemporaryFiles& known = *new TemporaryFiles;
  return known;
}

/// The signals that interrupt the program: of these three, those that its caller does not ignore.
sigset_t interruptions() {
  sigset_t signals;
  ::sigemptyset(&signals);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction action {};
    if (::sigaction(signal, nullptr, &action) == 0 && action.sa_handler != SIG_IGN) ::sigaddset(&signals, signal);
  }
  return signals;
}

/// Threads: only this one receives the signals, so it may call any function.
[[noreturn]] void wait_for_interruption(const sigset_t& signals) {
  int signal = 0;
  while (::sigwait(&signals, &signal) != 0) {
  }
  const std::lock_guard lock(temporary_files().mutex);
  for (const std::string& name : temporary_files().all) ::unlink(name.c_str());
  end_interrupted();
}

/// The names that an unfinished `path` may have: more than one, for processes that write the same file at the same
/// time.
std::string unfinished_name(const std::filesystem::path& path, int attempt) {
  constexpr std::size_t longest = 200;  // file systems allow 255 bytes
  const std::string ending = attempt == 0 ? ".tcbsample" : ".tcbsample" + std::to_string(attempt);
  return path.parent_path() / ("." + path.filename().string().substr(0, longest) + ending);
}

bool is_name_of(const std::string& name, int descriptor) {
  struct stat named {};
  struct stat opened {};
  return ::lstat(name.c_str(), &named) == 0 && ::fstat(descriptor, &opened) == 0 && named.st_dev == opened.st_dev &&
         named.st_ino == opened.st_ino;
}

/// Removes the file if no process holds a lock on it.
void remove_abandoned(const std::string& name) {
  constexpr int flags = O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC;
  int descriptor = ::open(name.c_str(), O_RDWR | flags);  // some network file systems lock only files open for writing
  if (descriptor < 0) descriptor = ::open(name.c_str(), O_RDONLY | flags);
  if (descriptor < 0) return;
  if (::flock(descriptor, LOCK_EX | LOCK_NB) == 0 && is_name_of(name, descriptor)) ::unlink(name.c_str());
  ::close(descriptor);
}

/// A new file with a lock on it, or -1 with errno set, EEXIST if another process uses the name. Another
/// process may take the file for abandoned and remove it before it is locked; then that process gets the name.
int create_locked(const std::string& name, mode_t permissions) {
  const int descriptor = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, permissions);
  if (descriptor < 0) return -1;
  const bool lost = ::flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;  // some systems lack locks
  if (!lost && is_name_of(name, descriptor)) return descriptor;
  ::close(descriptor);
  errno = EEXIST;
  return -1;
}

/// Creates a file in the folder of `path`, open for writing and with these permissions as far as the umask grants them.
/// Returns its descriptor, or -1 with errno set. `name` becomes its name: that of `path` between a dot and
/// ".tcbsample". The program holds a lock on it, so other processes do not touch it; a file without a lock was left by
/// a process that was killed, and is replaced.
int create_unfinished(const std::string& path, mode_t permissions, std::string& name) {
  constexpr int most_attempts = 1000;
  const std::lock_guard lock(temporary_files().mutex);
  for (int attempt = 0; attempt < most_attempts; ++attempt) {
    name = unfinished_name(path, attempt);
    int descriptor = create_locked(name, permissions);
    if (descriptor < 0 && errno == EEXIST) {
      remove_abandoned(name);
      descriptor = create_locked(name, permissions);
    }
    if (descriptor >= 0) temporary_files().all.insert(name);
    if (descriptor >= 0) return descriptor;
    if (errno != EEXIST) break;
  }
  name.clear();
  return -1;
}

/// Gives the file its final name, replacing any file of that name. The caller closes the descriptor.
/// Promises: false with errno set if that fails, or if writing the file failed.
bool finish(int descriptor, const std::string& name, const std::string& path) {
  const int other = ::dup(descriptor);  // closing it reports write errors before the file gets its name
  if (other < 0 || ::close(other) != 0) return false;
  const std::lock_guard lock(temporary_files().mutex);
  if (std::rename(name.c_str(), path.c_str()) != 0) return false;
  temporary_files().all.erase(name);
  return true;
}

/// Removes the file that create_unfinished() created. The caller then closes the descriptor, which has the lock.
void discard(const std::string& name) {
  const std::lock_guard lock(temporary_files().mutex);
  ::unlink(name.c_str());
  temporary_files().all.erase(name);
}

/// The number of a descriptor that the program inherited, from a name such as /dev/stdout or /dev/fd/3: writing
/// continues at its offset, also if it is a file.
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

}  // namespace

std::string folder_of(const std::string& path) { return std::filesystem::path(path).parent_path(); }

void make_folder(const std::string& path) {
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error) throw cannot_create_folder(error.message()).in(path);
}

Output::Output(std::string path, bool begins_last) : path_(std::move(path)) {
  const Compression compression = compression_of(path_);
  open();
  if (compression != Compression::none) compressor_.emplace(compression);
  if (!begins_last || (unfinished_ && !compressor_)) return;
  spool_.reset(std::tmpfile());
  if (spool_ == nullptr) throw cannot_create_temporary(std::strerror(errno)).in(shown_name());
}

void Output::open() {
  if (path_ == "-") return;
  if (const auto own = own_descriptor(path_)) {
    descriptor_ = ::dup(*own);
    if (descriptor_ < 0) fail_to_write();
    return;
  }
  std::error_code none;
  const auto kind = std::filesystem::status(path_, none).type();
  if (kind == std::filesystem::file_type::regular)
    path_ = std::filesystem::canonical(path_, none);  // the target of a link
  const bool device = kind != std::filesystem::file_type::regular && kind != std::filesystem::file_type::not_found;
  if (device) {  // /dev/null or a pipe: written in place
    descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CLOEXEC);
    if (descriptor_ < 0) fail_to_write();
    return;
  }
  struct stat before {};
  const bool replaces = ::stat(path_.c_str(), &before) == 0;  // the new file gets the permissions of that file
  descriptor_ = create_unfinished(path_, replaces ? S_IRUSR | S_IWUSR : 0666, temporary_);
  unfinished_ = descriptor_ >= 0;
  if (!unfinished_) fail_to_write();
  if (replaces && ::fchmod(descriptor_, before.st_mode & 07777U) != 0) {
    const int reason = errno;
    remove();
    errno = reason;
    fail_to_write();
  }
}

Output::~Output() { remove(); }

void Output::remove() {
  if (!temporary_.empty()) discard(temporary_);  // while it is locked
  temporary_.clear();
  if (descriptor_ > 2) ::close(std::exchange(descriptor_, -1));
}

void Output::fail_to_write() const { throw cannot_write(std::strerror(errno)).in(shown_name()); }

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

void Output::put(std::string_view text) {
  spool_ == nullptr ? send_compressed(text) : send(::fileno(spool_.get()), text);
}

void Output::send_compressed(std::string_view bytes, bool last) {
  compressor_ ? send(descriptor_, compressor_->add(bytes, last)) : send(descriptor_, bytes);
}

void Output::send(int descriptor, std::string_view bytes) const {
  while (!bytes.empty()) {
    const ssize_t count = ::write(descriptor, bytes.data(), bytes.size());
    if (count < 0 && is_to_repeat(descriptor, POLLOUT)) continue;
    if (count < 0) fail_to_write();
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
}

void Output::write_beginning(std::string_view bytes) {
  flush();
  const int descriptor = spool_ == nullptr ? descriptor_ : ::fileno(spool_.get());
  if (::lseek(descriptor, 0, SEEK_SET) < 0) fail_to_write();
  send(descriptor, bytes);
  if (::lseek(descriptor, 0, SEEK_END) < 0) fail_to_write();
}

void Output::send_spooled() {
  const int spool = ::fileno(spool_.get());
  if (::lseek(spool, 0, SEEK_SET) < 0) fail_to_write();
  std::string bytes(write_size, '\0');
  for (ssize_t count = 1; count != 0;) {
    count = ::read(spool, bytes.data(), bytes.size());
    if (count < 0 && errno != EINTR) throw cannot_read_temporary(std::strerror(errno)).in(shown_name());
    if (count > 0) send_compressed({bytes.data(), static_cast<std::size_t>(count)});
  }
  spool_.reset();
}

void Output::commit() {
  flush();
  if (spool_ != nullptr) send_spooled();
  if (compressor_) send_compressed("", true);
  if (path_ == "-") return;
  if (unfinished_) {
    if (!finish(descriptor_, temporary_, path_)) fail_to_write();
    temporary_.clear();
  }
  if (::close(std::exchange(descriptor_, -1)) != 0) fail_to_write();
}

void end_when_interrupted() {
  (void)std::signal(SIGPIPE, SIG_DFL);
  struct sigaction action {};
  action.sa_handler = [](int) { end_interrupted(); };
  const sigset_t signals = interruptions();
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    if (::sigismember(&signals, signal) == 1) ::sigaction(signal, &action, nullptr);
  }
}

void remove_unfinished_when_interrupted() {
  const sigset_t signals = interruptions();
  ::pthread_sigmask(SIG_BLOCK, &signals, nullptr);  // in all threads created from here on
  try {
    std::thread(wait_for_interruption, signals).detach();
  } catch (const std::system_error&) {
    ::pthread_sigmask(SIG_UNBLOCK, &signals, nullptr);  // no thread available: they end the program without cleanup
  }
}

}  // namespace tcb
