// Usual names: those of times and their units, of positions, of coordinates and of labels.
#include "schema/usual_names.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace tcb {
namespace {

TEST(UsualTime, names_of_times_have_any_case_and_a_unit) {
  for (const char* name :
       {"sec",       "secs",      "Seconds",    "SECS",          "time_s",       "time_ms",      "Time (s)",
        "time [s]",  "Time[ms]",  "time-us",    "TimeNs",        "t_s",          "t (ms)",       "T [s]",
        "T_s",       "frame",     "Frame No",   "Frame Number",  "frame_no",     "FrameIndex",   "keyframe",
        "Key Frame", "stamp",     "time stamp", "timestamp_ns",  "timestamps",   "elapsed",      "elapsed_time",
        "date",      "DateTime",  "ts",         "ts_ms",         "times",        "header.stamp", "field.header.stamp",
        "%time",     "unix_time", "ms",         "millis",        "milliseconds", "nanoseconds",  "time (\xC2\xB5s)",
        "time_min",  "time [h]",  "minutes",    "ticks",         "/odom/time",   "rosTime",      "clock",
        "t in s",    "Zeit in s", "Sekunden",   "secondsElapsed"}) {
    EXPECT_TRUE(is_usual_time(name)) << name;
  }
}

TEST(TimePart, is_told_by_the_last_word) {
  const auto part = time_part_of("header.stamp.nanosec");
  ASSERT_TRUE(part);
  EXPECT_EQ(part->part, TimePart::nanoseconds);
  EXPECT_EQ(part->stem, "header.stamp");
  EXPECT_EQ(time_part_of("secs")->stem, "");
  EXPECT_EQ(time_part_of("stamp_Secs")->part, TimePart::seconds);
  EXPECT_FALSE(time_part_of("stamp.ns"));
  EXPECT_FALSE(time_part_of("second"));
}

TEST(UsualCounter, is_a_sequence_or_frame_id) {
  EXPECT_TRUE(is_usual_counter("field.header.seq"));
  EXPECT_TRUE(is_usual_counter("frame_id"));
  EXPECT_FALSE(is_usual_counter("sequence.x"));
}

TEST(UsualTime, other_names_are_not_of_times) {
  for (const char* name : {"",         "T",       "x",          "s",        "S",           "min",   "m",  "h",
                           "second",   "tension", "tide",       "temp",     "temperature", "T [K]", "tx", "timer",
                           "lifetime", "update",  "frame_rate", "stamps_x", "period",      "us"}) {
    EXPECT_FALSE(is_usual_time(name)) << name;
  }
}

TEST(WithoutUnit, finds_the_only_name_that_has_a_unit) {
  const std::vector<std::string> names{"t [s]", "x [m]", "y (m)", "Y, mm", "z in mm", "w/m"};
  EXPECT_EQ(find_without_unit(names, "x"), 1U);
  EXPECT_EQ(find_without_unit(names, "Z"), 4U);
  EXPECT_EQ(find_without_unit(names, "w"), 5U);
  EXPECT_FALSE(find_without_unit(names, "y"));  // two
  EXPECT_FALSE(find_without_unit(names, "x [mm]"));
}

TEST(UnitOfTime, is_that_of_the_name) {
  const auto unit = [](std::string_view name) {
    const auto found = unit_of_time(name);
    return found ? row_of(*found).name : "none";
  };
  for (const char* name : {"timestamp [ns]", "time_ns", "t (ns)", "timeNanoseconds", "ns"}) {
    EXPECT_EQ(unit(name), "ns") << name;
  }
  for (const char* name : {"time_ms", "ms", "elapsed [ms]", "timestamp_ms", "milliseconds"})
    EXPECT_EQ(unit(name), "ms");
  for (const char* name : {"seconds", "sec", "t [s]", "t_s", "time (s)", "unix_time_s", "t in s", "seconds_elapsed"})
    EXPECT_EQ(unit(name), "s");
  for (const char* name : {"frame", "Frame Number", "frames", "keyframe", "t [frames]"})
    EXPECT_EQ(unit(name), "frames");
  EXPECT_EQ(unit("time [min]"), "min");
  EXPECT_EQ(unit("hours"), "h");
  for (const char* name : {"t", "time", "times", "ts", "timestamp", "ticks", "date", "x", "frame_time"}) {
    EXPECT_EQ(unit(name), "none") << name;
  }
}

TEST(Coordinates, have_the_usual_names_numbers_and_axes) {
  for (const char* name : {"x", "Y", "pos_x", "position.z", "x_m", "x (mm)", "tx", "qw", "p1", "c12", "lat",
                           "Longitude", "value", "roll", "field.pose.x"}) {
    EXPECT_TRUE(is_coordinate(name)) << name;
  }
  for (const char* name : {"", "sample", "idx", "index", "count", "foo", "step", "seq", "n"}) {
    EXPECT_FALSE(is_coordinate(name)) << name;
  }
}

TEST(UsualPosition, is_the_name_of_a_vector) {
  for (const char* name : {"pos", "Position", "translation", "xyz", "coords"}) {
    EXPECT_TRUE(is_usual_position(name)) << name;
  }
  for (const char* name : {"", "x", "meta", "rotation"}) EXPECT_FALSE(is_usual_position(name)) << name;
}

TEST(UsualLabel, is_the_name_of_what_distinguishes_curves) {
  for (const char* name : {"id", "ID", "track_id", "TrackId", "object", "bone"}) {
    EXPECT_TRUE(is_usual_label(name)) << name;
  }
  for (const char* name : {"", "x", "level", "weight"}) EXPECT_FALSE(is_usual_label(name)) << name;
}

TEST(UsualChannel, names_of_numbers_over_time) {
  for (const char* name : {"x", "ax", "pos_y", "p12", "fov", "value", "Temperature [C]", "imu.yaw", "R"}) {
    EXPECT_TRUE(is_usual_channel(name)) << name;
  }
  for (const char* name : {"Spannung", "tensione", "sample", "state"}) EXPECT_FALSE(is_usual_channel(name)) << name;
}

}  // namespace
}  // namespace tcb
