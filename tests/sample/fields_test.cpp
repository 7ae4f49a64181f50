// Fields: the table has unique names, and rows have the cells of its columns, with and without columns.
#include "sample/fields.hpp"
#include "schema/schema.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

namespace tcb {
namespace {

TEST(Fields, names_are_unique) {
  for (const Field& field : fields()) EXPECT_EQ(std::ranges::count(fields(), field.name, &Field::name), 1);
}

TEST(Fields, a_row_has_a_cell_for_each_channel_or_one) {
  const std::array chosen{field_of("time"), field_of("velocity"), field_of("speed")};
  EXPECT_EQ(cells_in_row(chosen, {3, {}}), 5U);
  Schema schema;
  schema.time.name = "frame";
  schema.channels = {"x", "y"};
  std::vector<std::string> names;
  for (const OutputColumn& column : output_columns(chosen, schema)) names.push_back(column.name);
  EXPECT_EQ(names, (std::vector<std::string>{"frame", "x_v", "y_v", "speed"}));
}

TEST(Fields, motion_is_that_of_channels_without_rotation) {
  Schema schema;
  schema.channels = {"x", "qx", "qy", "qz", "qw"};
  schema.rotations = {{{{{1, 2, 3, 4}}}}};
  const std::array chosen{field_of("velocity"), field_of("angular_velocity"), field_of("angular_speed")};
  std::string names;
  for (const OutputColumn& column : output_columns(chosen, schema)) names += column.name + " ";
  EXPECT_EQ(names, "x_v angular_velocity_x angular_velocity_y angular_velocity_z angular_speed ");
  EXPECT_EQ(cells_in_row(chosen, {5, rotation_columns(schema)}), 5U);
  schema.rotations.push_back({{{{4, 3, 2, 1}}}});
  EXPECT_EQ(output_columns(std::array{field_of("angular_speed")}, schema)[1].name, "angular_speed2");
}

TEST(Fields, columns_of_times_and_positions_are_what_points_have) {
  const std::array cubics{spline::cubic<double>(0.1, 2, 3, -1), spline::cubic<double>(5, 4, 0.3, 7)};
  const CurveSegment segment{0.0, 2.0, {}, {}, cubics, {}, true};
  Located located;
  for (const double t : {0.0, 0.3, 0.4, 1.1, 1.9, 2.0}) {
    located.samples.push_back({t, spline::TimeMap<double>(segment.start, segment.end)(t)});
  }
  const std::array chosen{field_of("time"), field_of("position"), field_of("key")};
  const std::size_t width = cells_in_row(chosen, {2, {}});
  std::vector<Cell> by_column(located.samples.size() * width), by_row(by_column);
  Point<double> point;
  write_rows(by_column.data(), width, chosen, segment, located, point);
  for (const Sample& sample : located.samples) located.outside.push_back({sample.t});
  write_rows(by_row.data(), width, chosen, segment, located, point);
  for (std::size_t i = 0; i < by_row.size(); ++i) {
    EXPECT_TRUE(by_column[i] == by_row[i] || (is_empty(by_column[i]) && is_empty(by_row[i]))) << i;
  }
}

}  // namespace
}  // namespace tcb
