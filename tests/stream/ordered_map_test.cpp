// Sources: pulled one item at a time, in order, and never earlier than asked for.
#include "stream/ordered_map.hpp"
#include "stream/source.hpp"

#include <gmock/gmock.h>

#include <chrono>
#include <cmath>
#include <memory>
#include <mutex>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace tcb {
namespace {

using testing::ElementsAre;

/// 1, 2, … last; counts how often it was asked.
Source<int> numbers(int last, int& asked) {
  return [last, &asked, next = 1]() mutable -> std::optional<int> {
    ++asked;
    return next <= last ? std::optional(next++) : std::nullopt;
  };
}

template <class T>
std::vector<T> all(const Source<T>& source) {
  std::vector<T> items;
  while (auto item = source()) items.push_back(std::move(*item));
  return items;
}

TEST(Streams, an_item_is_added_in_front_once) {
  int asked = 0;
  const auto source = preceded_by(7, numbers(2, asked));
  EXPECT_EQ(source(), 7);
  EXPECT_EQ(asked, 0) << "the item in front is not pulled from the source";
  EXPECT_THAT(all(source), ElementsAre(1, 2));
  EXPECT_EQ(source(), std::nullopt) << "an ended source remains ended";
}

TEST(Streams, an_item_may_precede_an_empty_source) {
  int asked = 0;
  EXPECT_THAT(all(preceded_by(7, numbers(0, asked))), ElementsAre(7));
}

TEST(Streams, a_map_keeps_the_order_and_may_change_the_type) {
  int asked = 0;
  const auto text = [](int item) { return std::to_string(item * item); };
  EXPECT_THAT(all(mapped(numbers(4, asked), text)), ElementsAre("1", "4", "9", "16"));
  EXPECT_THAT(all(mapped(numbers(0, asked), text)), ElementsAre());
}

TEST(Streams, a_map_computes_an_item_on_demand) {
  int asked = 0, made = 0;
  const auto source = mapped(numbers(5, asked), [&made](int item) {
    ++made;
    return item;
  });
  EXPECT_EQ(made + asked, 0);
  EXPECT_EQ(source(), 1);
  EXPECT_EQ(made, 1);
  EXPECT_EQ(asked, 1);
}

TEST(Streams, items_are_moved_through) {
  int asked = 0;
  const auto boxed = mapped(numbers(2, asked), [](int item) { return std::make_unique<int>(item); });
  const auto opened = mapped(boxed, [](std::unique_ptr<int> box) { return *box; });
  EXPECT_THAT(all(opened), ElementsAre(1, 2));
}

/// Takes longer for some items than for others.
int slowly_squared(int item) {
  std::this_thread::sleep_for(std::chrono::microseconds(item * 7919 % 300));
  return item * item;
}

TEST(OrderedMap, results_are_in_order_for_any_number_of_threads) {
  std::vector<int> squares;
  for (int i = 1; i <= 500; ++i) squares.push_back(i * i);
  for (const unsigned threads : {1U, 2U, 3U, 8U, 16U}) {
    const ThreadPool pool(threads);
    int asked = 0;
    EXPECT_EQ(all(ordered_map(numbers(500, asked), slowly_squared, threads)), squares) << threads;
  }
}

/// The threads that worked on these items, the one that pulls not counted.
std::size_t other_threads(unsigned limit, int items) {
  std::mutex mutex;
  std::set<std::thread::id> ids;
  const ThreadPool pool(limit);
  int asked = 0;
  const std::thread::id pulling = std::this_thread::get_id();
  const auto note_thread = [&](int item) {
    const std::lock_guard lock(mutex);
    if (std::this_thread::get_id() != pulling) ids.insert(std::this_thread::get_id());
    return item;
  };
  EXPECT_EQ(all(ordered_map(numbers(items, asked), note_thread, 8)).size(), static_cast<std::size_t>(items));
  return ids.size();
}

TEST(OrderedMap, small_work_has_no_thread_and_other_work_at_most_those_of_the_pool) {
  EXPECT_EQ(other_threads(8, 2), 0U);
  EXPECT_EQ(other_threads(1, 1000), 0U);
  EXPECT_LE(other_threads(3, 1000), 2U);
  EXPECT_GE(available_threads(), 1U);
}

TEST(OrderedMap, maps_may_follow_one_another) {
  const ThreadPool pool(4);
  int asked = 0;
  const auto squares = ordered_map(numbers(100, asked), slowly_squared, 4);
  const auto roots = all(ordered_map(
      squares, [](int square) { return std::lround(std::sqrt(square)); }, 4));
  ASSERT_EQ(roots.size(), 100U);
  EXPECT_EQ(roots.front(), 1);
  EXPECT_EQ(roots.back(), 100);
}

TEST(OrderedMap, an_error_follows_the_earlier_results) {
  const ThreadPool pool(4);
  for (const bool in_source : {false, true}) {
    int asked = 0;
    const auto fail_at_ten = [](int item) {
      if (item == 10) throw std::runtime_error("ten");
      return item;
    };
    const auto items = in_source ? ordered_map(mapped(numbers(50, asked), fail_at_ten), slowly_squared, 4)
                                 : ordered_map(numbers(50, asked), fail_at_ten, 4);
    for (int i = 1; i < 10; ++i) EXPECT_TRUE(items().has_value());
    EXPECT_THROW((void)items(), std::runtime_error);
  }
}

TEST(OrderedMap, each_number_has_one_call) {
  for (const unsigned threads : {1U, 4U}) {
    std::vector<int> calls(100);
    for_each_number(calls.size(), threads, [&](std::size_t number) { ++calls[number]; });
    EXPECT_THAT(calls, testing::Each(1));
  }
  for_each_number(0, 4, [](std::size_t number) { ADD_FAILURE() << number; });
}

TEST(OrderedMap, may_be_destroyed_before_its_end) {
  const ThreadPool pool(4);
  int asked = 0;
  {
    const auto items = ordered_map(numbers(1000, asked), slowly_squared, 4);
    EXPECT_EQ(items(), 1);
  }
  EXPECT_LE(asked, 8) << "only so many items are pulled ahead";
}

}  // namespace
}  // namespace tcb
