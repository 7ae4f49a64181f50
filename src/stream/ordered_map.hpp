// Ordered map: a pure function of the items of a source on several threads, the results in order.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>

#include "stream/source.hpp"

namespace tcb {

/// How many threads the machine runs for this process at the same time.
unsigned available_threads();

/// The threads that ordered maps share during its lifetime: the newest pool is the one in use. A thread is started when
/// there is a task for it, so small work has none.
class ThreadPool {
 public:
  /// `threads`: the most that work at a time, including the one that pulls.
  explicit ThreadPool(unsigned threads);
  /// Requires: no ordered map that uses the pool is left.
  ~ThreadPool();

 private:
  friend class Background;
  class Threads;
  std::unique_ptr<Threads> threads_;
};

/// Runs tasks on the threads of the pool, as far as the system provides them: a task may never be run, so whoever needs
/// its result computes it itself. The destructor waits for the tasks that have begun.
class Background {
 public:
  Background();
  ~Background();
  Background(const Background&) = delete;
  Background& operator=(const Background&) = delete;
  void run(std::function<void()> task);

 private:
  ThreadPool::Threads* threads_;  ///< null: none
};

/// f(item), computed by the thread that claims it first.
template <class In, class Out>
class Result {
 public:
  Result(In item, const std::function<Out(In&&)>& f) : item_(std::move(item)), f_(f) {}

  /// Computes it, unless another thread does or did.
  bool claim_and_run() {
    if (claimed_.exchange(true)) return false;
    try {
      out_.emplace(f_(std::move(*item_)));
    } catch (...) {
      error_ = std::current_exception();
    }
    item_.reset();
    const std::lock_guard lock(mutex_);
    done_.store(true);
    ends_.notify_one();
    return true;
  }

  bool is_done() const { return done_.load(); }

  /// Waits for the thread that computes it. Throws: what f threw.
  Out take() {
    std::unique_lock lock(mutex_);
    ends_.wait(lock, [this] { return is_done(); });
    if (error_) std::rethrow_exception(error_);
    return std::move(*out_);
  }

 private:
  std::optional<In> item_;
  const std::function<Out(In&&)>& f_;
  std::optional<Out> out_;
  std::exception_ptr error_;
  std::atomic<bool> claimed_ = false, done_ = false;
  std::mutex mutex_;  // as the waits of atomics lose notifications where libstdc++ has no futexes
  std::condition_variable ends_;
};

/// The source of f(item), in order, computed on `threads` threads including the one that pulls: the only place where
/// threads share data. Requires: f is a pure function. With more than one thread some items are pulled ahead.
template <class In, class Out>
class OrderedMap {
 public:
  OrderedMap(Source<In> source, std::function<Out(In&&)> f, unsigned threads)
      : source_(std::move(source)), f_(std::move(f)), ahead_(threads * std::size_t{2}) {}

  std::optional<Out> next() {
    fill();
    if (results_.empty() && failure_) std::rethrow_exception(failure_);
    if (results_.empty()) return std::nullopt;
    const auto result = results_.front();
    result->claim_and_run();
    for (auto other = results_.begin() + 1; other != results_.end() && !result->is_done(); ++other) {
      (*other)->claim_and_run();
    }
    results_.pop_front();
    return result->take();
  }

 private:
  using Slot = Result<In, Out>;

  /// So many items are left to the thread that pulls: small work is done before another thread has started.
  static constexpr std::size_t alone = 2;

  /// The source's next item. What the source throws is rethrown after the items pulled before.
  std::optional<In> pull() {
    try {
      return source_();
    } catch (...) {
      failure_ = std::current_exception();
      return std::nullopt;
    }
  }

  /// Pulls some items ahead.
  void fill() {
    while (!ended_ && results_.size() < ahead_) {
      std::optional<In> item = pull();
      ended_ = !item;
      if (ended_) return;
      results_.push_back(std::make_shared<Slot>(std::move(*item), f_));
      ++pulled_;
      if (pulled_ > alone) background_.run([result = results_.back()] { result->claim_and_run(); });
    }
  }

  Source<In> source_;
  std::function<Out(In&&)> f_;
  std::size_t ahead_;
  std::size_t pulled_ = 0;
  bool ended_ = false;
  std::exception_ptr failure_;
  std::deque<std::shared_ptr<Slot>> results_;
  Background background_;  // destroyed first, so that no thread uses the others any more
};

template <class In, class F>
auto ordered_map(Source<In> source, F f, unsigned threads) {
  using Out = decltype(f(std::declval<In>()));
  if (threads <= 1) return mapped(std::move(source), std::move(f));
  const auto map = std::make_shared<OrderedMap<In, Out>>(std::move(source), std::move(f), threads);
  return Source<Out>([map] { return map->next(); });
}

/// The numbers from 0 to `count`, which is left out.
inline Source<std::size_t> numbers_to(std::size_t count) {
  return [count, next = std::size_t{0}]() mutable { return next < count ? std::optional(next++) : std::nullopt; };
}

/// Calls a function for each number below `count`, on several threads.
void for_each_number(std::size_t count, unsigned threads, const std::function<void(std::size_t)>& f);

}  // namespace tcb
