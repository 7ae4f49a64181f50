// Sources: pulled one item at a time, in order, and never earlier than asked for.
#include "stream.hpp"

#include <gmock/gmock.h>

#include <memory>
#include <string>
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

TEST(Streams, an_item_stands_in_front_once) {
  int asked = 0;
  const auto source = preceded_by(7, numbers(2, asked));
  EXPECT_EQ(source(), 7);
  EXPECT_EQ(asked, 0) << "the source behind is not asked for the item in front";
  EXPECT_THAT(all(source), ElementsAre(1, 2));
  EXPECT_EQ(source(), std::nullopt) << "the end stays the end";
}

TEST(Streams, an_item_may_stand_before_nothing) {
  int asked = 0;
  EXPECT_THAT(all(preceded_by(7, numbers(0, asked))), ElementsAre(7));
}

TEST(Streams, a_map_keeps_the_order_and_may_change_the_type) {
  int asked = 0;
  const auto text = [](int item) { return std::to_string(item * item); };
  EXPECT_THAT(all(ordered_map(numbers(4, asked), text)), ElementsAre("1", "4", "9", "16"));
  EXPECT_THAT(all(ordered_map(numbers(0, asked), text)), ElementsAre());
}

TEST(Streams, a_map_makes_an_item_when_it_is_asked_for) {
  int asked = 0, made = 0;
  const auto source = ordered_map(numbers(5, asked), [&made](int item) {
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
  const auto boxed = ordered_map(numbers(2, asked), [](int item) { return std::make_unique<int>(item); });
  const auto opened = ordered_map(boxed, [](std::unique_ptr<int> box) { return *box; });
  EXPECT_THAT(all(opened), ElementsAre(1, 2));
}

}  // namespace
}  // namespace tcb
