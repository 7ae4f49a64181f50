// Tables of samples in the notations that programs write.

#include <gmock/gmock.h>

#include <cmath>

#include "check/inputs.hpp"
#include "comparing.hpp"
#include "io/input_file.hpp"

namespace tcb {
namespace {

using testing::ElementsAre;

SampleTable table_of(const std::string& rows) {
  const Comparing files("t,x\n0,0\n1,1\n", rows);
  const Comparison& comparison = files.comparison;
  const Schema keys = keep_input(comparison, read_file(comparison.keys_file)).schema;
  return read_samples(comparison, read_file(comparison.file), keys, 0);
}

TEST(SampleTable, has_the_decimal_mark_of_its_cells) {
  EXPECT_THAT(table_of("t;x\n0;1,5\n").curves.at(0).numbers, ElementsAre(1.5));
  EXPECT_THAT(table_of("t;x\n0;1.5\n").curves.at(0).numbers, ElementsAre(1.5));
  EXPECT_THAT(table_of("t\tx\n0\t1,5\n").curves.at(0).numbers, ElementsAre(1.5));
  EXPECT_THAT(table_of("t,x,y\n0,1,5\n").curves.at(0).numbers, ElementsAre(1, 5));
}

TEST(SampleTable, has_rows_in_any_order_with_missing_numbers) {
  const SampleTable table = table_of("t,x,y\n3,1,\n2,,4\n");
  EXPECT_THAT(table.columns, ElementsAre("x", "y"));
  const SampleRows& rows = table.curves.at(0);
  EXPECT_THAT(rows.lines, ElementsAre(2, 3));
  EXPECT_EQ(rows.times[0].hi, 3);
  EXPECT_EQ(rows.times[1].hi, 2);
  EXPECT_THAT(rows.numbers, ElementsAre(1, testing::IsNan(), testing::IsNan(), 4));
}

TEST(SampleTable, ignores_columns_of_text_by_their_whole_names) {
  EXPECT_THAT(table_of("t,x,\"note, extra\"\n0,1,b\n").ignored, ElementsAre("note, extra"));
}

}  // namespace
}  // namespace tcb
