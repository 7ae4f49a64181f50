// Inputs: keys that can be read again, and tables of samples in the notations that programs write.
#include "compare/inputs.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "comparing.hpp"

namespace tcb {
namespace {

using testing::ElementsAre;

SampleTable table_of(const std::string& rows) {
  const Comparing files("t,x\n0,0\n1,1\n", rows);
  return read_samples(files.path("rows.csv"), keep(files.job).input, false, 1);
}

TEST(KeptCurves, can_be_read_more_than_once) {
  const Comparing files("id,t,x\na,0,1\nb,0,2\na,1,3\n", "");
  Job job = files.job;
  job.input.roles = {{Role::group, {"id"}}};
  const KeptCurves kept = keep(job);
  ASSERT_EQ(kept.curves.size(), 2U);
  EXPECT_EQ(kept.curves[0].key_count(), 2U);
  EXPECT_EQ(kept.curves[1].key_count(), 1U);
  for (int times = 0; times < 2; ++times) {
    std::vector<double> positions;
    const auto keys = kept.curves[0].keys();
    while (const auto block = keys()) {
      positions.insert(positions.end(), block->keys.positions.begin(), block->keys.positions.end());
    }
    EXPECT_THAT(positions, ElementsAre(1, 3));
  }
}

TEST(SampleTable, has_the_decimal_mark_that_its_cells_have) {
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

TEST(ComparisonInputs, errors_name_the_file) {
  const Comparing bad_keys("t,x\n0,0\n0,1\n", "t,x\n0,0\n");
  EXPECT_EQ(error_of([&] { read_inputs(bad_keys.job, {}); }).position().file, bad_keys.path("keys.csv"));
  const Comparing bad_rows("t,x\n0,0\n1,1\n", "t,x\n0,o\n");
  const Error error = error_of([&] { read_inputs(bad_rows.job, {}); });
  EXPECT_EQ(error.position().file, bad_rows.path("rows.csv"));
}

TEST(ComparisonInputs, have_places_in_time_or_in_arc_length) {
  const Comparing in_time("clock,x\n0,0\n1,1\n", "clock,x\n0,0\n");
  Job job = in_time.job;
  job.input.roles = {{Role::time, {"clock"}}};
  EXPECT_EQ(read_inputs(job, {}).place_name(), "clock");
  const Comparing in_length("t,x\n0,0\n1,1\n", "s,x\n0,0\n");
  EXPECT_EQ(read_inputs(in_length.job, {}).place_name(), "s");
}

}  // namespace
}  // namespace tcb
