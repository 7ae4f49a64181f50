// Atomic outputs: temporary files, which get their final name when they are complete; interruptions.
#include "io/atomic_output.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <mutex>
#include <optional>
#include <random>
#include <set>
#include <span>
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

/// Threads: only this one receives the signals, so it may call any function.
[[noreturn]] void wait_for_interruption(const sigset_t& signals) {
  int signal = 0;
  while (::sigwait(&signals, &signal) != 0) {
  }
  const std::lock_guard lock(temporary_files().mutex);
  for (const std::string& name : temporary_files().all) ::unlink(name.c_str());
  end_interrupted();
}

/// A hidden name in the folder of `path`, with random letters.
std::string unfinished_name(const std::filesystem::path& path) {
  constexpr std::size_t longest = 200;  // file systems allow 255 bytes
  constexpr std::string_view letters = "abcdefghijklmnopqrstuvwxyz";
  std::random_device random;
  std::uniform_int_distribution<std::size_t> letter(0, letters.size() - 1);
  std::string name = "." + path.filename().string().substr(0, longest) + ".";
  for (int i = 0; i < 10; ++i) name += letters[letter(random)];
  return path.parent_path() / (name + ".tcbsample");
}

/// Calls make(name) with unused names of temporary files, and returns the descriptor or 0 that it returns, or -1 with
/// errno set. `name` becomes the name of the file that it made.
template <class Make>
int make_temporary(const std::string& path, std::string& name, const Make& make) {
  constexpr int most_attempts = 100;
  const std::lock_guard lock(temporary_files().mutex);
  for (int attempt = 0; attempt < most_attempts; ++attempt) {
    std::string unused = unfinished_name(path);
    const int result = make(unused.c_str());
    if (result >= 0) name = *temporary_files().all.insert(std::move(unused)).first;
    if (result >= 0 || errno != EEXIST) return result;
  }
  return -1;
}

/// Opens a new file in the folder of `path` for writing, with these permissions as far as the umask grants them. It has
/// no name, so that nothing is left if the program is killed; it has a temporary one on file systems that do not have
/// such files, and without /proc, through which it gets its name. The descriptor is -1 with errno set if that fails.
void open_new(OutputTarget& target, const std::string& path, mode_t permissions) {
  target.is_file = true;
  if (::access("/proc/self/fd", X_OK) == 0) {
    const std::string folder = folder_of(path);
    target.descriptor = ::open(folder.empty() ? "." : folder.c_str(), O_WRONLY | O_TMPFILE | O_CLOEXEC, permissions);
    if (target.descriptor >= 0 || (errno != EOPNOTSUPP && errno != EISDIR && errno != EINVAL)) return;
  }
  target.descriptor = make_temporary(path, target.temporary, [permissions](const char* name) {
    return ::open(name, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, permissions);
  });
}

/// Gives a new file a temporary name, unless it has one. Promises: false with errno set if that fails.
bool name_temporarily(OutputTarget& target, const std::string& path) {
  if (!target.temporary.empty()) return true;
  const std::string open_file = "/proc/self/fd/" + std::to_string(target.descriptor);
  return make_temporary(path, target.temporary, [&open_file](const char* name) {
           return ::linkat(AT_FDCWD, open_file.c_str(), AT_FDCWD, name, AT_SYMLINK_FOLLOW);
         }) == 0;
}

/// The file that a path leads to. A path that does not lead anywhere, or is too long for the system, stays as it is.
/// Throws: Error (usage) for a link that cannot be followed.
std::string target_of(const std::string& path) {
  std::error_code error, none;
  std::string target = std::filesystem::canonical(path, error);
  if (!error) return target;
  if (std::filesystem::is_symlink(path, none)) throw cannot_write(error.message()).in(path);
  return path;
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

OutputTarget::~OutputTarget() {
  if (!temporary.empty()) {
    const std::lock_guard lock(temporary_files().mutex);
    ::unlink(temporary.c_str());
    temporary_files().all.erase(temporary);
  }
  if (descriptor > STDERR_FILENO) ::close(descriptor);
}

Output::Output(std::string path, bool begins_last) : path_(std::move(path)) {
  const Compression compression = compression_of(path_);
  open();
  if (compression != Compression::none) compressor_.emplace(compression);
  if (!begins_last || (open_.is_file && !compressor_)) return;
  spool_.reset(std::tmpfile());
  if (spool_ == nullptr) throw cannot_create_temporary(std::strerror(errno)).in(shown_name());
}

void Output::open() {
  if (path_ == "-") return;
  if (const auto own = own_descriptor(path_)) {
    open_.descriptor = ::dup(*own);
    if (open_.descriptor < 0) fail_to_write();
    return;
  }
  struct stat before {};
  const bool exists = ::stat(path_.c_str(), &before) == 0;
  if (exists && !S_ISREG(before.st_mode)) {  // /dev/null or a pipe: written in place
    open_.descriptor = ::open(path_.c_str(), O_WRONLY | O_CLOEXEC);
    if (open_.descriptor < 0) fail_to_write();
    return;
  }
  if (exists) path_ = target_of(path_);
  if (exists && ::faccessat(AT_FDCWD, path_.c_str(), W_OK, AT_EACCESS) != 0) fail_to_write();
  open_new(open_, path_, exists ? S_IRUSR | S_IWUSR : 0666);
  if (open_.descriptor < 0) fail_to_write();
  constexpr mode_t permissions = 0777;  // without setuid and setgid
  if (exists && ::fchmod(open_.descriptor, before.st_mode & permissions) != 0) fail_to_write();
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
  compressor_ ? send(open_.descriptor, compressor_->add(bytes, last)) : send(open_.descriptor, bytes);
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
  const int descriptor = spool_ == nullptr ? open_.descriptor : ::fileno(spool_.get());
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
  if (open_.is_file && !name_temporarily(open_, path_)) fail_to_write();
  if (::close(std::exchange(open_.descriptor, -1)) != 0) fail_to_write();  // writing may fail as late as here
  if (!open_.is_file) return;
  const std::lock_guard lock(temporary_files().mutex);
  if (std::rename(open_.temporary.c_str(), path_.c_str()) != 0) fail_to_write();
  temporary_files().all.erase(std::exchange(open_.temporary, ""));
}

void end_when_interrupted() {
  (void)std::signal(SIGPIPE, SIG_DFL);
  (void)std::signal(SIGXFSZ, SIG_IGN);
  sigset_t signals;
  ::sigemptyset(&signals);
  add_unless_ignored(signals, interruptions);
  struct sigaction action {};
  action.sa_handler = [](int) { end_interrupted(); };
  for (const int signal : interruptions) {
    if (::sigismember(&signals, signal) == 1) ::sigaction(signal, &action, nullptr);
  }
}

void remove_unfinished_when_interrupted() {
  sigset_t signals;
  ::sigemptyset(&signals);
  add_unless_ignored(signals, interruptions);
  add_unless_ignored(signals, further_signals);
  ::pthread_sigmask(SIG_BLOCK, &signals, nullptr);  // in all threads created from here on
  try {
    std::thread(wait_for_interruption, signals).detach();
  } catch (const std::system_error&) {
    ::pthread_sigmask(SIG_UNBLOCK, &signals, nullptr);  // no thread available: they end the program without cleanup
  }
}

}  // namespace tcb
