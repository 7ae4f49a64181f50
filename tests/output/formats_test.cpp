// Output formats: layouts that can be read again, and the head, bytes and limits of NumPy files.

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

#include "error.hpp"
#include "input/reading.hpp"
#include "output/layout.hpp"

namespace tcb {
namespace {

TEST(OutputFormat, each_layout_writes_what_its_format_reads) {
  const std::vector<OutputColumn> columns{{"t", CellKind::time}, {"the x", CellKind::real}};
  for (const Format& format : formats) {
    if (!format.can_read || !format.can_write) continue;
    const Layout layout = output_format(format.id).layout(columns, true);
    std::string text = layout.head;
    append_rows(text, layout, columns, {Cell(0), Cell(0.1), Cell(1), Cell(-2)}, true);
    text += layout.tail + layout.end;
    InputOptions options;
    options.format = format.id;
    const std::string keys = read(text, options);
    EXPECT_TRUE(keys.starts_with("t the x\n")) << keys;
    EXPECT_NE(keys.find(": 0 0.1\n"), std::string::npos) << keys;
    EXPECT_NE(keys.find(": 1 -2\n"), std::string::npos) << keys;
  }
}

const std::vector<OutputColumn> npy_columns{{"t", CellKind::time}, {"x", CellKind::real}, {"key", CellKind::whole}};

/// Eight bytes, the lowest first, as a double.
double number_at(const std::string& bytes, std::size_t number) {
  std::uint64_t bits = 0;
  for (std::size_t i = 8; i-- > 0;) bits = bits << 8 | static_cast<unsigned char>(bytes[number * 8 + i]);
  return std::bit_cast<double>(bits);
}

TEST(Npy, the_head_has_the_same_size_for_any_number_of_rows) {
  for (const std::uint64_t rows : {std::uint64_t{0}, std::uint64_t{1}, std::numeric_limits<std::uint64_t>::max()}) {
    const std::string head = npy_head(3, rows);
    ASSERT_EQ(head.size(), 128U);
    EXPECT_EQ(head.substr(0, 10), std::string("\x93NUMPY\x01\x00\x76\x00", 10));
    EXPECT_EQ(head.back(), '\n');
    EXPECT_NE(head.find("'shape': (" + std::to_string(rows) + ", 3), }"), std::string::npos) << head;
  }
}

TEST(Npy, cells_are_the_bytes_of_doubles_and_nan_where_not_defined) {
  std::string bytes;
  append_rows(bytes, npy_layout(npy_columns), npy_columns,
              {Cell(0.1), Cell(-0.0), Cell(7), Cell(1), empty_cell, empty_cell}, true);
  ASSERT_EQ(bytes.size(), 48U);
  EXPECT_EQ(number_at(bytes, 0), 0.1);
  EXPECT_TRUE(std::signbit(number_at(bytes, 1)));
  EXPECT_EQ(number_at(bytes, 2), 7);
  EXPECT_TRUE(std::isnan(number_at(bytes, 4)));
  EXPECT_TRUE(std::isnan(number_at(bytes, 5)));
}

TEST(Npy, a_time_beyond_doubles_is_refused) {
  std::string bytes;
  const auto append = [&](const Cell& time) {
    append_rows(bytes, npy_layout(npy_columns), npy_columns, {time, Cell(0), Cell(0)}, true);
  };
  append({9007199254740992.0, 0});
  EXPECT_EQ(number_at(bytes, 0), 9007199254740992.0);
  EXPECT_THROW(append({9007199254740992.0, 1}), Error);
}

}  // namespace
}  // namespace tcb
