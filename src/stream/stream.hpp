// Streams that are pulled: a source is asked for its next item until it has none.
#pragma once

#include <atomic>
#include <cstddef>
#include <deque>
#include <exception>
#include <functional>
#include <memory>
#include <optional>
#include <utility>

namespace tcb {

/// The next item, or nothing at the end. An item is made when it is asked for, not before, so memory
/// stays bounded and a slow pipe shows each row as soon as it can be known.
template <class T>
using Source = std::function<std::optional<T>()>;

/// A source with one more item in front.
template <class T>
Source<T> preceded_by(T item, Source<T> source) {
  return [first = std::optional<T>(std::move(item)), source = std::move(source)]() mutable {
    return first ? std::exchange(first, std::nullopt) : source();
  };
}

/// The source of f(item), in order, on the thread that pulls.
template <class In, class F>
auto mapped(Source<In> source, F f) {
  using Out = decltype(f(std::declval<In>()));
  return Source<Out>([source = std::move(source), f = std::move(f)]() mutable -> std::optional<Out> {
    std::optional<In> item = source();
    if (!item) return std::nullopt;
    return f(std::move(*item));
  });
}

/// How many threads the program may use, the one that pulls among them, for as long as this lives.
class ThreadLimit {
 public:
  explicit ThreadLimit(unsigned threads);
  ~ThreadLimit();

  /// Has the limit that was made last hold from here on. Threads: any.
  static void apply();

 private:
  struct Control;
  std::unique_ptr<Control> control_;
};

/// Tasks for other threads, as far as there are any and the system has room for them; whoever needs the answer of one
/// that is not taken up does it. The destructor waits for those that have begun.
class Background {
 public:
  Background();
  ~Background();
  void run(std::function<void()> task);

 private:
  struct Group;
  std::unique_ptr<Group> group_;
  bool has_threads_ = true;
};

/// f(item), worked out by whichever thread claims it first.
template <class In, class Out, class F>
class Answer {
 public:
  Answer(In item, const F& f) : item_(std::move(item)), f_(f) {}

  /// Works it out, unless another thread does or did.
  bool claim_and_run() {
    if (claimed_.exchange(true)) return false;
    try {
      out_.emplace(f_(std::move(*item_)));
    } catch (...) {
      error_ = std::current_exception();
    }
    item_.reset();
    done_.store(true);
    done_.notify_one();
    return true;
  }

  bool is_done() const { return done_.load(); }

  /// Waits for the thread that works it out. Throws: what f threw.
  Out take() {
    done_.wait(false);
    if (error_) std::rethrow_exception(error_);
    return std::move(*out_);
  }

 private:
  std::optional<In> item_;
  const F& f_;
  std::optional<Out> out_;
  std::exception_ptr error_;
  std::atomic<bool> claimed_ = false, done_ = false;
};

/// The source of f(item), in order, worked out on `threads` threads, the one that pulls among them: the only place
/// where threads meet data. f is a pure function of the item. With more than one thread some items are pulled ahead.
template <class In, class F>
class OrderedMap {
 public:
  using Out = decltype(std::declval<const F&>()(std::declval<In>()));

  OrderedMap(Source<In> source, F f, unsigned threads)
      : source_(std::move(source)), f_(std::move(f)), ahead_(threads * std::size_t{2}) {}

  std::optional<Out> next() {
    fill();
    if (answers_.empty() && failure_) std::rethrow_exception(failure_);
    if (answers_.empty()) return std::nullopt;
    const auto answer = answers_.front();
    answer->claim_and_run();
    for (auto other = answers_.begin() + 1; other != answers_.end() && !answer->is_done(); ++other) {
      (*other)->claim_and_run();
    }
    answers_.pop_front();
    return answer->take();
  }

 private:
  using Slot = Answer<In, Out, F>;

  /// So many items are left to the one who pulls: small work is done before another thread has begun.
  static constexpr std::size_t alone = 2;

  /// The source's next item. What it throws is for the one who asks for the item behind those pulled ahead.
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
    while (!ended_ && answers_.size() < ahead_) {
      std::optional<In> item = pull();
      ended_ = !item;
      if (ended_) return;
      answers_.push_back(std::make_shared<Slot>(std::move(*item), f_));
      ++pulled_;
      if (pulled_ > alone) background_.run([answer = answers_.back()] { answer->claim_and_run(); });
    }
  }

  Source<In> source_;
  F f_;
  std::size_t ahead_;
  std::size_t pulled_ = 0;
  bool ended_ = false;
  std::exception_ptr failure_;
  std::deque<std::shared_ptr<Slot>> answers_;
  Background background_;  // goes first, so that no thread still needs the others
};

template <class In, class F>
auto ordered_map(Source<In> source, F f, unsigned threads) {
  using Out = typename OrderedMap<In, F>::Out;
  if (threads <= 1) return mapped(std::move(source), std::move(f));
  const auto map = std::make_shared<OrderedMap<In, F>>(std::move(source), std::move(f), threads);
  return Source<Out>([map] { return map->next(); });
}

}  // namespace tcb
