// Keys without faults: the faults of all blocks in one error.
#include "keys/curves.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "error.hpp"

namespace tcb {
namespace {

/// The message of the fault on a line, of a kind of its own.
std::string fault_on(std::uint64_t line) { return "fault " + std::string(line, 'x'); }

/// Blocks with faults on these lines.
Source<KeyBlock> blocks(std::vector<std::vector<std::uint64_t>> lines, bool ends_badly = false,
                        std::string (*message)(std::uint64_t) = fault_on) {
  return [=, next = std::size_t{0}]() mutable -> std::optional<KeyBlock> {
    if (next == lines.size() && ends_badly) throw data_error("ends").at({"", 99, 1});
    if (next == lines.size()) return std::nullopt;
    KeyBlock block;
    for (const std::uint64_t line : lines[next]) {
      block.faults.errors.push_back(data_error("{}", message(line)).at({"", line, 1}));
    }
    ++next;
    return block;
  };
}

/// The lines of the faults.
std::string lines_of(const Source<KeyBlock>& source) {
  try {
    while (source()) {
    }
  } catch (const Error& error) {
    std::string lines = fmt::format("{} ", error.position().line);
    for (const Error& other : error.others()) lines += fmt::format("{} ", other.position().line);
    return lines;
  }
  return "";
}

TEST(WithoutFaults, all_are_reported_in_the_order_of_their_lines) {
  EXPECT_EQ(lines_of(without_faults(blocks({{}, {5, 3}, {}, {8}}))), "3 5 8 ");
}

TEST(WithoutFaults, at_most_ten_are_reported) {
  EXPECT_EQ(lines_of(without_faults(blocks({{1, 2, 3, 4}, {5, 6, 7, 8}, {9, 10, 11}, {12}}))),
            "1 2 3 4 5 6 7 8 9 10 0 ")
      << "the last one says that further errors are not shown";
}

TEST(WithoutFaults, one_kind_is_one_error_with_a_count) {
  const auto number = [](std::uint64_t line) { return fmt::format("x: \"{}\" is not a number of {}", line, line); };
  const auto message = [&](bool arrive) {
    try {
      without_faults(blocks({{2, 3}, {7}}, false, number), [&] { return arrive; })();
    } catch (const Error& error) {
      return error.message() + (error.others().empty() ? "" : " and others");
    }
    return std::string();
  };
  EXPECT_EQ(message(true), "x: \"2\" is not a number of 2 (3 errors of this kind, the last in line 7)");
  EXPECT_EQ(message(false), "x: \"2\" is not a number of 2 (at least 2 errors of this kind, the last in line 3)");
}

TEST(WithoutFaults, what_does_not_arrive_is_not_waited_for) {
  EXPECT_EQ(lines_of(without_faults(blocks({{1}, {2}}), [] { return false; })), "1 ");
}

TEST(WithoutFaults, an_error_that_ends_the_reading_comes_last) {
  EXPECT_EQ(lines_of(without_faults(blocks({{1}}, true))), "1 99 ");
}

TEST(WithoutFaults, blocks_without_faults_pass) {
  const auto source = without_faults(blocks({{}, {}}));
  EXPECT_TRUE(source().has_value());
  EXPECT_TRUE(source().has_value());
  EXPECT_FALSE(source().has_value());
}

}  // namespace
}  // namespace tcb
