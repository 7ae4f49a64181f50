// Threads of ordered maps: a pool, whose threads are started when there are tasks for them.
#include "stream/ordered_map.hpp"

#include <sched.h>

#include <algorithm>
#include <system_error>
#include <thread>
#include <vector>

namespace tcb {
namespace {

std::mutex newest_mutex;

}  // namespace

/// std::thread::hardware_concurrency() reads a file, which takes longer than small work.
unsigned available_threads() {
#ifdef CPU_COUNT  // Linux
  cpu_set_t set;
  if (::sched_getaffinity(0, sizeof set, &set) == 0) return static_cast<unsigned>(CPU_COUNT(&set));
#endif
  return std::max(1U, std::thread::hardware_concurrency());
}

/// Threads, and the tasks that wait for one, each with its owner. Threads: any.
class ThreadPool::Threads {
 public:
  explicit Threads(unsigned working) : most_(std::max(working, 1U) - 1) {}

  ~Threads() {
    const std::lock_guard lock(mutex_);
    ending_ = true;
    task_comes_.notify_all();
  }

  /// Adds a task, and starts a thread for it if all are busy. Promises: false if there is no thread at all.
  bool add(const Background& owner, std::function<void()> run) {
    const std::lock_guard lock(mutex_);
    if (waiting_.size() >= all_.size() - running_.size() && all_.size() < most_) start_thread();
    if (all_.empty()) return false;
    waiting_.push_back({&owner, std::move(run)});
    task_comes_.notify_one();
    return true;
  }

  /// Drops the owner's tasks that have not begun, and waits for the others.
  void finish(const Background& owner) {
    std::unique_lock lock(mutex_);
    std::erase_if(waiting_, [&](const Task& task) { return task.owner == &owner; });
    task_ends_.wait(lock, [&] { return std::ranges::count(running_, &owner) == 0; });
  }

  static inline Threads* newest = nullptr;

 private:
  struct Task {
    const Background* owner;
    std::function<void()> run;
  };

  void start_thread() {
    running_.reserve(all_.size() + 1);  // so that no thread of ours runs out of memory
    try {
      all_.emplace_back([this] { work(); });
    } catch (const std::system_error&) {
      most_ = all_.size();  // the system has no more
    }
  }

  /// What each thread does.
  void work() {
    std::unique_lock lock(mutex_);
    while (true) {
      task_comes_.wait(lock, [this] { return ending_ || !waiting_.empty(); });
      if (ending_) return;
      Task task = std::move(waiting_.front());
      waiting_.pop_front();
      running_.push_back(task.owner);
      lock.unlock();
      task.run();
      task.run = nullptr;  // what it refers to may end with its owner
      lock.lock();
      running_.erase(std::ranges::find(running_, task.owner));
      task_ends_.notify_all();
    }
  }

  std::mutex mutex_;
  std::condition_variable task_comes_, task_ends_;
  std::deque<Task> waiting_;
  std::vector<const Background*> running_;  ///< the owner of each task that has begun
  std::size_t most_;
  bool ending_ = false;
  std::vector<std::jthread> all_;  // destroyed first, which waits for their ends
};

ThreadPool::ThreadPool(unsigned threads) : threads_(std::make_unique<Threads>(threads)) {
  const std::lock_guard lock(newest_mutex);
  Threads::newest = threads_.get();
}

ThreadPool::~ThreadPool() {
  const std::lock_guard lock(newest_mutex);
  if (Threads::newest == threads_.get()) Threads::newest = nullptr;
}

Background::Background() {
  const std::lock_guard lock(newest_mutex);
  threads_ = ThreadPool::Threads::newest;
}

Background::~Background() {
  if (threads_ != nullptr) threads_->finish(*this);
}

void Background::run(std::function<void()> task) {
  if (threads_ == nullptr) return;
  try {
    if (!threads_->add(*this, std::move(task))) threads_ = nullptr;
  } catch (const std::bad_alloc&) {  // the caller does the work
  }
}

void for_each_number(std::size_t count, unsigned threads, const std::function<void(std::size_t)>& f) {
  const auto call = [&f](std::size_t number) {
    f(number);
    return number;
  };
  for (const auto calls = ordered_map(numbers_to(count), call, threads); calls();) {
  }
}

}  // namespace tcb
