// Threads of ordered maps: those of oneTBB, started when there is work for a second thread.
#include "stream/ordered_map.hpp"

#include <tbb/global_control.h>
#include <tbb/task_group.h>

#include <mutex>
#include <optional>

namespace tcb {
namespace {

std::mutex waiting_mutex;  ///< of all waiting tasks; taking one is quick

}  // namespace

/// Passed to oneTBB with the first work for a second thread, because its initialization takes longer than small work.
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

/// Tasks wait in a queue of our own, and each task of oneTBB takes one from it: the packaged library is not
/// instrumented, so the thread sanitizer does not see the objects that it passes between threads, but it does see the
/// lock. This file is compiled without the sanitizer, too, as it includes oneTBB's headers.
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
      group->tasks.wait();  // oneTBB allocates its memory here, and may fail: better now than within a task
      group_ = std::move(group);
    }
    {
      const std::lock_guard lock(waiting_mutex);
      group_->waiting.push_back(std::move(task));
    }
    group_->tasks.run([group = group_.get()] { group->run_one(); });
  } catch (const std::exception&) {  // no memory, or no thread available
    has_threads_ = false;
  }
}

}  // namespace tcb
