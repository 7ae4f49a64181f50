// NumPy's files: their head, their bytes, and what they cannot hold.
#include "output/npy.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <limits>

#include "error.hpp"

namespace tcb {
namespace {

const std::vector<OutputColumn> columns{{"t", CellKind::time}, {"x", CellKind::real}, {"key", CellKind::whole}};

/// Eight bytes, the lowest first, as a double.
double read(const std::string& bytes, std::size_t number) {
  std::uint64_t bits = 0;
  for (std::size_t i = 8; i-- > 0;) bits = bits << 8 | static_cast<unsigned char>(bytes[number * 8 + i]);
  return std::bit_cast<double>(bits);
}

TEST(Npy, the_head_is_as_long_for_any_number_of_rows) {
  for (const std::uint64_t rows : {std::uint64_t{0}, std::uint64_t{1}, std::numeric_limits<std::uint64_t>::max()}) {
    const std::string head = npy_head(3, rows);
    ASSERT_EQ(head.size(), 128U);
    EXPECT_EQ(head.substr(0, 10), std::string("\x93NUMPY\x01\x00\x76\x00", 10));
    EXPECT_EQ(head.back(), '\n');
    EXPECT_NE(head.find("'shape': (" + std::to_string(rows) + ", 3), }"), std::string::npos) << head;
  }
}

TEST(Npy, cells_are_the_bytes_of_doubles_and_what_is_not_defined_is_no_number) {
  std::string bytes;
  append_rows(bytes, npy_layout(columns), columns, {Cell(0.1), Cell(-0.0), Cell(7), Cell(1), empty_cell, empty_cell},
              true);
  ASSERT_EQ(bytes.size(), 48U);
  EXPECT_EQ(read(bytes, 0), 0.1);
  EXPECT_TRUE(std::signbit(read(bytes, 1)));
  EXPECT_EQ(read(bytes, 2), 7);
  EXPECT_TRUE(std::isnan(read(bytes, 4)));
  EXPECT_TRUE(std::isnan(read(bytes, 5)));
}

TEST(Npy, a_time_that_is_no_double_is_refused) {
  std::string bytes;
  const auto append = [&](const Cell& time) {
    append_rows(bytes, npy_layout(columns), columns, {time, Cell(0), Cell(0)}, true);
  };
  append({9007199254740992.0, 0});
  EXPECT_EQ(read(bytes, 0), 9007199254740992.0);
  EXPECT_THROW(append({9007199254740992.0, 1}), Error);
}

}  // namespace
}  // namespace tcb
