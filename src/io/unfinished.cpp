// Unfinished files have another name until they are complete; interruptions leave none, and the next run clears up.
#include "io/unfinished.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <mutex>
#include <set>
#include <system_error>
#include <thread>

#include "error.hpp"

namespace tcb {
namespace {

/// The names of all unfinished files; not destroyed, for a signal may come while the program ends.
struct Names {
  std::mutex mutex;
  std::set<std::string> all;
};
Names& names() {
  static Names& known = *new Names;
  return known;
}

/// Threads: this one alone gets the signals, so it may do anything.
[[noreturn]] void wait_for_interruption(const sigset_t& signals) {
  int signal = 0;
  while (::sigwait(&signals, &signal) != 0) {
  }
  const std::lock_guard lock(names().mutex);
  for (const std::string& name : names().all) ::unlink(name.c_str());
  ::_exit(static_cast<int>(Exit::interrupted));
}

/// The names that an unfinished `path` may have, most of them for programs that write the same one at the same time.
std::string name_beside(const std::filesystem::path& path, int attempt) {
  constexpr std::size_t longest = 200;  // file systems take 255 bytes
  const std::string ending = attempt == 0 ? ".tcbsample" : ".tcbsample" + std::to_string(attempt);
  return path.parent_path() / ("." + path.filename().string().substr(0, longest) + ending);
}

bool is_name_of(const std::string& name, int descriptor) {
  struct stat named {};
  struct stat opened {};
  return ::lstat(name.c_str(), &named) == 0 && ::fstat(descriptor, &opened) == 0 && named.st_dev == opened.st_dev &&
         named.st_ino == opened.st_ino;
}

/// Removes the file if no program holds a lock on it.
void remove_abandoned(const std::string& name) {
  constexpr int flags = O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC;
  int descriptor = ::open(name.c_str(), O_RDWR | flags);  // some network file systems lock only what may be written
  if (descriptor < 0) descriptor = ::open(name.c_str(), O_RDONLY | flags);
  if (descriptor < 0) return;
  if (::flock(descriptor, LOCK_EX | LOCK_NB) == 0 && is_name_of(name, descriptor)) ::unlink(name.c_str());
  ::close(descriptor);
}

/// A new file with a lock on it, or -1 with errno set, EEXIST if another program has the name. Between making it and
/// the lock another program may take it for abandoned; then the name is that program's.
int create_locked(const std::string& name, mode_t permissions) {
  const int descriptor = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, permissions);
  if (descriptor < 0) return -1;
  const bool lost = ::flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;  // some systems have no locks
  if (!lost && is_name_of(name, descriptor)) return descriptor;
  ::close(descriptor);
  errno = EEXIST;
  return -1;
}

}  // namespace

int create_unfinished(const std::string& path, mode_t permissions, std::string& name) {
  constexpr int most_attempts = 1000;
  const std::lock_guard lock(names().mutex);
  for (int attempt = 0; attempt < most_attempts; ++attempt) {
    name = name_beside(path, attempt);
    int descriptor = create_locked(name, permissions);
    if (descriptor < 0 && errno == EEXIST) {
      remove_abandoned(name);
      descriptor = create_locked(name, permissions);
    }
    if (descriptor >= 0) names().all.insert(name);
    if (descriptor >= 0) return descriptor;
    if (errno != EEXIST) break;
  }
  name.clear();
  return -1;
}

bool finish(int descriptor, const std::string& name, const std::string& path) {
  const int other = ::dup(descriptor);  // closing it tells what closing the file would, before that has its name
  if (other < 0 || ::close(other) != 0) return false;
  const std::lock_guard lock(names().mutex);
  if (std::rename(name.c_str(), path.c_str()) != 0) return false;
  names().all.erase(name);
  return true;
}

void discard(const std::string& name) {
  const std::lock_guard lock(names().mutex);
  ::unlink(name.c_str());
  names().all.erase(name);
}

void end_when_interrupted() {
  (void)std::signal(SIGPIPE, SIG_DFL);
  sigset_t signals;
  ::sigemptyset(&signals);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction action {};
    if (::sigaction(signal, nullptr, &action) == 0 && action.sa_handler != SIG_IGN) ::sigaddset(&signals, signal);
  }
  ::pthread_sigmask(SIG_BLOCK, &signals, nullptr);  // in all threads that are to come
  try {
    std::thread(wait_for_interruption, signals).detach();
  } catch (const std::system_error&) {
    ::pthread_sigmask(SIG_UNBLOCK, &signals, nullptr);  // no room for a thread: the signals end the program as ever
  }
}

}  // namespace tcb
