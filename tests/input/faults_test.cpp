// Faults: all of them in the order of lines, ten at most, and of a live input those at hand.
#include "input/faults.hpp"

#include <gtest/gtest.h>

#include "input/reading.hpp"

namespace tcb {
namespace {

/// Blocks with faults on these lines.
Source<KeyBlock> blocks(std::vector<std::vector<std::uint64_t>> lines, bool ends_badly = false) {
  return [lines, ends_badly, next = std::size_t{0}]() mutable -> std::optional<KeyBlock> {
    if (next == lines.size() && ends_badly) throw Error(Exit::data, TextPosition{"", 99, 1}, "bad");
    if (next == lines.size()) return std::nullopt;
    KeyBlock block;
    for (const std::uint64_t line : lines[next])
      block.faults.emplace_back(Exit::data, TextPosition{"", line, 1}, "bad");
    ++next;
    return block;
  };
}

/// The lines that are said to be bad.
std::string said(const Source<KeyBlock>& source) {
  const std::string text = error_of([&] {
    while (source()) {
    }
  });
  std::string lines;
  for (std::size_t at = text.find("f:"); at != std::string::npos; at = text.find("f:", at + 1)) {
    lines += text.substr(at + 2, text.find(':', at + 2) - at - 2) + " ";
  }
  return lines;
}

TEST(Faults, all_are_said_in_the_order_of_their_lines) {
  EXPECT_EQ(said(without_faults(blocks({{}, {5, 3}, {}, {8}}), false)), "3 5 8 ");
}

TEST(Faults, ten_are_enough) {
  EXPECT_EQ(said(without_faults(blocks({{1, 2, 3, 4}, {5, 6, 7, 8}, {9, 10, 11}, {12}}), false)),
            "1 2 3 4 5 6 7 8 9 10 ");
}

TEST(Faults, a_live_input_is_not_waited_for) { EXPECT_EQ(said(without_faults(blocks({{1}, {2}}), true)), "1 "); }

TEST(Faults, what_ends_the_reading_comes_last) { EXPECT_EQ(said(without_faults(blocks({{1}}, true), false)), "1 99 "); }

TEST(Faults, blocks_without_any_go_through) {
  const auto source = without_faults(blocks({{}, {}}), false);
  EXPECT_TRUE(source().has_value());
  EXPECT_TRUE(source().has_value());
  EXPECT_FALSE(source().has_value());
}

}  // namespace
}  // namespace tcb
