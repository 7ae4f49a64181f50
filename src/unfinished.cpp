// Unfinished files: they have no name, or another one, until they are complete; interruptions and crashes leave none.
#include "unfinished.hpp"

#include <fcntl.h>
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

std::string unused_name(const std::string& path) { return path + ".XXXXXX"; }

bool rename_it(const std::string& name, const std::string& path) {
  const std::lock_guard lock(names().mutex);
  if (std::rename(name.c_str(), path.c_str()) != 0) return false;
  names().all.erase(name);
  return true;
}

/// Gives a nameless file its name; where another file has that, by way of a third name, for only rename() replaces.
bool name_it(int descriptor, const std::string& path) {
  const std::string file = "/proc/self/fd/" + std::to_string(descriptor);
  const auto link = [&](const std::string& name) {
    return ::linkat(AT_FDCWD, file.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0;
  };
  if (link(path)) return true;
  if (errno != EEXIST) return false;
  std::string name = unused_name(path);
  {
    const std::lock_guard lock(names().mutex);
    const int placeholder = ::mkostemp(name.data(), O_CLOEXEC);  // a name that nobody else takes
    if (placeholder < 0) return false;
    ::close(placeholder);
    ::unlink(name.c_str());
    if (!link(name)) return false;
    names().all.insert(name);
  }
  if (rename_it(name, path)) return true;
  const int reason = errno;
  discard(name);
  errno = reason;
  return false;
}

}  // namespace

int create_unfinished(const std::string& path, std::string& name) {
  name.clear();
  const std::string folder = std::filesystem::path(path).parent_path() / ".";
  // It is named by way of /proc, which need not be there.
  const bool can_be_named = ::access("/proc/self/fd", X_OK) == 0;
  const int nameless = !can_be_named ? -1 : ::open(folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, S_IRUSR | S_IWUSR);
  if (nameless >= 0) return nameless;
  const std::lock_guard lock(names().mutex);
  name = unused_name(path);
  const int descriptor = ::mkostemp(name.data(), O_CLOEXEC);
  if (descriptor >= 0) names().all.insert(name);
  return descriptor;
}

bool finish(int descriptor, const std::string& name, const std::string& path) {
  const int other = ::dup(descriptor);  // closing it tells what closing the file would, before that has its name
  const bool sound = other >= 0 && ::close(other) == 0;
  const bool finished = sound && (name.empty() ? name_it(descriptor, path) : rename_it(name, path));
  const int reason = errno;
  ::close(descriptor);
  errno = reason;
  return finished;
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
