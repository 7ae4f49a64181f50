// Threads for streams: oneTBB's, and none of them until there is work for a second thread.
#include "stream/stream.hpp"

#include <tbb/global_control.h>
#include <tbb/task_group.h>

#include <mutex>
#include <optional>

namespace tcb {
namespace {

std::mutex waiting_mutex;  ///< of all tasks that wait; taking one is quick

}  // namespace

/// oneTBB hears of it with the first work for a second thread, for it takes longer to set itself up than small work.
struct ThreadLimit::Control {
  explicit Control(unsigned most) : threads(most) {}

  static inline std::mutex mutex;
  static inline Control* current = nullptr;

  unsigned threads;
  std::optional<tbb::global_control> limit;
};

ThreadLimit::ThreadLimit(unsigned threads) : control_(std::make_unique<Control>(threads)) {
  const std::lock_guard lock(Control::mutex);
  Control::current = control_.get();
}

ThreadLimit::~ThreadLimit() {
  const std::lock_guard lock(Control::mutex);
  if (Control::current == control_.get()) Control::current = nullptr;
}

void ThreadLimit::apply() {
  const std::lock_guard lock(Control::mutex);
  if (Control::current == nullptr || Control::current->limit) return;
  Control::current->limit.emplace(tbb::global_control::max_allowed_parallelism, Control::current->threads);
}

/// Tasks wait in a queue of our own, and oneTBB's task is to take one: the packaged library is not instrumented, so
/// the thread sanitizer does not see what it hands from thread to thread, but it does see the lock. This file is
/// not instrumented for it either: oneTBB's headers are in it.
struct Background::Group {
  void run_one() {
    std::function<void()> task;
    {
      const std::lock_guard lock(waiting_mutex);
      task = std::move(waiting.front());
      waiting.pop_front();
    }
    task();
  }

  std::deque<std::function<void()>> waiting;
  tbb::task_group tasks;
};

Background::Background() = default;

Background::~Background() {
  if (!group_) return;
  group_->tasks.cancel();
  group_->tasks.wait();
}

void Background::run(std::function<void()> task) {
  if (!has_threads_) return;
  try {
    if (!group_) {
      ThreadLimit::apply();
      auto group = std::make_unique<Group>();
      group->tasks.wait();  // oneTBB sets itself up, and may lack the memory: better here than with a task half begun
      group_ = std::move(group);
    }
    {
      const std::lock_guard lock(waiting_mutex);
      group_->waiting.push_back(std::move(task));
    }
    group_->tasks.run([group = group_.get()] { group->run_one(); });
  } catch (const std::exception&) {  // no memory, or no thread to be had
    has_threads_ = false;
  }
}

}  // namespace tcb
