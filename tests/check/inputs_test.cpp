// Inputs of a comparison: keys that can be read again, and errors that name the file.
#include "check/inputs.hpp"

#include <gmock/gmock.h>

#include "comparing.hpp"
#include "io/input_file.hpp"

namespace tcb {
namespace {

using testing::ElementsAre;

TEST(KeptInput, can_be_read_more_than_once) {
  const Comparing files("id,t,x\na,0,1\nb,0,2\na,1,3\n", "");
  Comparison comparison = files.comparison;
  comparison.keys.input.columns.roles = {{Role::group, {"id"}}};
  const KeptInput kept = keep_input(comparison, read_file(comparison.keys_file));
  ASSERT_EQ(kept.curves.size(), 2U);
  EXPECT_EQ(kept.curves[0].blocks.at(0).size(), 2U);
  EXPECT_EQ(kept.curves[1].blocks.at(0).size(), 1U);
  for (int times = 0; times < 2; ++times) {
    std::vector<double> positions;
    const auto next_block = kept.curves[0].keys();
    while (const auto block = next_block()) {
      positions.insert(positions.end(), block->keys.positions.begin(), block->keys.positions.end());
    }
    EXPECT_THAT(positions, ElementsAre(1, 3));
  }
}

TEST(ComparisonInputs, errors_name_the_file) {
  const Comparing bad_keys("t,x\n0,0\n0,1\n", "t,x\n0,0\n");
  EXPECT_EQ(error_of([&] { read_inputs(bad_keys.comparison, {}); }).position().file, bad_keys.path("keys.csv"));
  const Comparing bad_rows("t,x\n0,0\n1,1\n", "t,x\n0,o\n");
  const Error error = error_of([&] { read_inputs(bad_rows.comparison, {}); });
  EXPECT_EQ(error.position().file, bad_rows.path("rows.csv"));
}

TEST(ComparisonInputs, have_places_in_time_or_in_arc_length) {
  const Comparing in_time("clock,x\n0,0\n1,1\n", "clock,x\n0,0\n");
  Comparison comparison = in_time.comparison;
  comparison.keys.input.columns.roles = {{Role::time, {"clock"}}};
  EXPECT_EQ(read_inputs(comparison, {}).place_name(), "clock");
  const Comparing in_length("t,x\n0,0\n1,1\n", "s,x\n0,0\n");
  EXPECT_EQ(read_inputs(in_length.comparison, {}).place_name(), "s");
}

}  // namespace
}  // namespace tcb
