// Sample columns: the time, the groups, and every other column of numbers.
#include "schema/columns.hpp"

#include <gmock/gmock.h>

namespace tcb {
namespace {

using testing::ElementsAre;
using Names = std::vector<std::string>;

std::vector<Role> roles_of_samples(const Columns& columns) {
  std::vector<Role> result;
  for (const auto& cell : columns.cells) result.push_back(cell.role);
  return result;
}

/// Columns of samples whose columns all hold numbers.
Columns find_samples(const Names& header, const SampleNames& names, bool timeless = false) {
  return find_sample_columns(header, std::vector<bool>(header.size(), true), names, timeless);
}

TEST(SampleColumns, all_but_the_time_are_channels) {
  const Columns columns = find_samples({"frame", "T", "bias", "x"}, {"clock"});
  EXPECT_EQ(columns.time, "frame");
  EXPECT_THAT(columns.channels, ElementsAre("T", "bias", "x"));
}

TEST(SampleColumns, the_time_has_the_name_that_it_has_in_the_keys_or_a_usual_one) {
  const Columns columns = find_samples({"t", "clock", "x"}, {"clock"});
  EXPECT_EQ(columns.time, "clock");
  EXPECT_THAT(columns.channels, ElementsAre("t", "x"));
  EXPECT_FALSE(find_samples({"s", "x"}, {"clock"}).has(Role::time));
}

TEST(SampleColumns, groups_are_used_if_all_are_there) {
  EXPECT_THAT(find_samples({"x", "take", "t", "id"}, {"t", {"id", "take"}}).groups, ElementsAre("id", "take"));
  const Columns without = find_samples({"x", "t", "id"}, {"t", {"id", "take"}});
  EXPECT_TRUE(without.groups.empty());
  EXPECT_THAT(without.channels, ElementsAre("x", "id"));
}

TEST(SampleColumns, labels_are_ignored) {
  const Columns columns = find_samples({"t", "x", "pose"}, {"t", {}, {"pose"}});
  EXPECT_THAT(columns.channels, ElementsAre("x"));
  EXPECT_THAT(columns.ignored, ElementsAre("pose"));
}

TEST(SampleColumns, without_names_groups_come_first_then_the_time) {
  const auto find = [](bool timeless) {
    return find_sample_columns({}, std::vector<bool>(4, true), {"t", {"column1"}}, timeless);
  };
  EXPECT_THAT(roles_of_samples(find(false)), ElementsAre(Role::group, Role::time, Role::position, Role::position));
  EXPECT_THAT(roles_of_samples(find(true)), ElementsAre(Role::group, Role::position, Role::position, Role::position));
}

}  // namespace
}  // namespace tcb
