// Preloaded library that makes reading and writing fail in the way that TCBSAMPLE_FAULT names.
//
// FAULT or FAULT:NUMBER, such as write-full:1000, a disk with room for 1000 bytes; the script run uses all of them.
#include <fcntl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdarg>
#include <cstdlib>
#include <string>
#include <string_view>

namespace {

/// The number after the fault's name if that fault is chosen, else -1.
long fault(std::string_view name) {
  const char* const text = std::getenv("TCBSAMPLE_FAULT");
  const std::string_view given = text == nullptr ? "" : text;
  const std::size_t colon = std::min(given.find(':'), given.size());
  if (given.substr(0, colon) != name) return -1;
  return colon == given.size() ? 0 : std::atol(text + colon + 1);
}

bool is_fault(std::string_view name) { return fault(name) >= 0; }

long fail(int reason) {
  errno = reason;
  return -1;
}

bool is_regular(int descriptor) {
  struct stat status {};
  return ::fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode);
}

/// Changes the file of a descriptor as another program would.
void change(int descriptor, bool grow) {
  const std::string path = "/proc/self/fd/" + std::to_string(descriptor);
  const int other = ::open(path.c_str(), O_WRONLY | (grow ? O_APPEND : O_TRUNC));
  if (grow) (void)::syscall(SYS_write, other, "9", 1);
  ::close(other);
}

constexpr std::size_t few = 7;
long bytes_read = 0, bytes_written = 0;
bool fails_next = true;

}  // namespace

extern "C" {

ssize_t read(int descriptor, void* buffer, std::size_t size) {
  fails_next = !fails_next;
  if (is_fault("read-interrupted") && !fails_next) return fail(EINTR);
  if (is_fault("read-again") && !fails_next) return fail(EAGAIN);
  if (is_fault("read-short")) size = std::min(size, few);
  if (const long most = fault("read-fails"); most >= 0) {
    if (bytes_read >= most) return fail(EIO);
    size = std::min(size, static_cast<std::size_t>(most - bytes_read));
  }
  const bool changes = is_fault("grows") || is_fault("shrinks");
  if (changes) size = std::min<std::size_t>(size, 1000);
  const ssize_t count = ::syscall(SYS_read, descriptor, buffer, size);
  if (changes && bytes_read == 0 && is_regular(descriptor)) change(descriptor, is_fault("grows"));
  bytes_read += std::max<ssize_t>(count, 0);
  return count;
}

ssize_t write(int descriptor, const void* buffer, std::size_t size) {
  fails_next = !fails_next;
  if (is_fault("write-interrupted") && !fails_next) return fail(EINTR);
  if (is_fault("write-again") && !fails_next) return fail(EAGAIN);
  if (is_fault("write-short")) size = std::min(size, few);
  if (const long most = fault("write-full"); most >= 0) {
    if (bytes_written >= most) return fail(ENOSPC);
    size = std::min(size, static_cast<std::size_t>(most - bytes_written));
  }
  if (const long signal = fault("signal"); signal > 0 && bytes_written > 0) {
    ::kill(::getpid(), static_cast<int>(signal));
    for (;;) ::pause();
  }
  const ssize_t count = ::syscall(SYS_write, descriptor, buffer, size);
  bytes_written += std::max<ssize_t>(count, 0);
  return count;
}

int open(const char* path, int flags, ...) {
  std::va_list arguments;
  va_start(arguments, flags);
  const bool creates = (flags & O_CREAT) != 0 || (flags & O_TMPFILE) == O_TMPFILE;
  const mode_t mode = creates ? va_arg(arguments, mode_t) : 0;
  va_end(arguments);
  if ((flags & O_TMPFILE) == O_TMPFILE && is_fault("no-unnamed")) return static_cast<int>(fail(EOPNOTSUPP));
  if (creates && is_fault("read-only")) return static_cast<int>(fail(EROFS));
  return static_cast<int>(::syscall(SYS_openat, AT_FDCWD, path, flags, mode));
}

int fchmod(int descriptor, mode_t mode) {
  if (is_fault("fchmod-fails")) return static_cast<int>(fail(EPERM));
  return static_cast<int>(::syscall(SYS_fchmod, descriptor, mode));
}

int close(int descriptor) {
  const bool written = (::fcntl(descriptor, F_GETFL) & O_ACCMODE) != O_RDONLY;
  const long result = ::syscall(SYS_close, descriptor);
  return static_cast<int>(written && is_fault("close-fails") ? fail(EDQUOT) : result);
}

int rename(const char* from, const char* to) {
  if (is_fault("rename-fails")) return static_cast<int>(fail(EIO));
  return static_cast<int>(::syscall(SYS_rename, from, to));
}
}
