// Unfinished files: they have other names until they are complete, and are removed when the program is interrupted.
#include "unfinished.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
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

}  // namespace

int create_unfinished(const std::string& path, std::string& name) {
  const std::lock_guard lock(names().mutex);
  name = path + ".XXXXXX";
  const int descriptor = ::mkostemp(name.data(), O_CLOEXEC);
  if (descriptor >= 0) names().all.insert(name);
  return descriptor;
}

bool finish(const std::string& name, const std::string& path) {
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
