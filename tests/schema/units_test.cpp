// Units: frames as seconds, factors of channels, and other names.
#include <gmock/gmock.h>

#include "read/reading.hpp"

namespace tcb {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Input opened_with_units(const std::string& text, const InputOptions& options) {
  return open_input("keys.csv", pieces(text), options);
}

TEST(Units, frames_become_seconds_rounded_once) {
  InputOptions options;
  options.units.frame_rate = Rational(30000, 1001);
  const Input input = opened_with_units("frame,x\n0,1\n1,2\n107892,3\n", options);
  EXPECT_EQ(input.schema.time.name, "time");
  EXPECT_EQ(input.schema.time.unit, TimeUnit::s);
  const auto block = input.keys.blocks();
  EXPECT_THAT(block->keys.times, ElementsAre(Time(0.0), Time(1001.0 / 30000), Time(107892.0 * 1001 / 30000)));
}

TEST(Units, of_whole_numbers_since_1970_are_told_by_their_size) {
  const auto unit = [](const std::string& time) {
    return opened_with_units("t,x\n" + time + ",1\n", {}).schema.time.epoch_unit;
  };
  EXPECT_EQ(unit("946684800000"), TimeUnit::ms);
  EXPECT_EQ(unit("1700000000000000"), TimeUnit::us);
  EXPECT_EQ(unit("1700000000000000001"), TimeUnit::ns);
  for (const char* time : {"0", "1700000000", "946684799999", "4102444800000", "1700000000000.5"}) {
    EXPECT_EQ(unit(time), std::nullopt) << time;
  }
  EXPECT_EQ(opened_with_units("time_ms,x\n1700000000000,1\n", {}).schema.time.epoch_unit, std::nullopt)
      << "its unit is known";
}

TEST(Units, channels_are_scaled_from_their_decimals) {
  InputOptions options;
  options.units.scales = {{"x", Rational(1, 10)}};
  options.keys.keeps_decimals = true;
  const auto block = opened_with_units("t,x,y\n0,3,3\n1,0.7,2\n", options).keys.blocks();
  EXPECT_THAT(block->keys.positions, ElementsAre(0.3, 3, 0.07, 2)) << "3 * 0.1 is another double than 0.3";
  EXPECT_EQ(block->decimals[NumberOfKey::position], "3/10");
  options.units.scales = {{"z", 2}};
  EXPECT_THAT(error_of([&] { opened_with_units("t,x\n0,3\n1,2\n", options); }), HasSubstr("no column \"z\""));
  options.units.scales = {{"x", Rational(parse_rational("1e308").value())}};
  EXPECT_THAT(error_of([&] {
                const auto keys = opened_with_units("t,x\n0,3\n1,2\n", options).keys.blocks();
                throw keys->faults.errors.at(0);
              }),
              HasSubstr("x: \"3\" is not a finite double"));
}

TEST(Units, that_contradict_the_name_are_refused) {
  InputOptions options;
  options.units.time = TimeUnit::ms;
  EXPECT_THAT(error_of([&] { opened_with_units("time_ns,x\n0,1\n1,2\n", options); }),
              HasSubstr("in ms by this option, but in ns"));
  EXPECT_EQ(opened_with_units("t,x\n0,1\n1,2\n", options).schema.time.unit, TimeUnit::ms);
  options = {};
  options.units.frame_rate = 24;
  EXPECT_THAT(error_of([&] { opened_with_units("time_ns,x\n0,1\n1,2\n", options); }),
              HasSubstr("in frames by this option, but in ns"));
}

TEST(Names, of_columns_are_replaced_at_once) {
  InputOptions options;
  options.renamings = {{"x", "y"}, {"y", "x"}, {"t", "seconds"}};
  const Input input = opened_with_units("t,x,y\n0,1,2\n1,2,3\n", options);
  EXPECT_EQ(input.schema.time.name, "seconds");
  EXPECT_THAT(input.schema.channels, ElementsAre("y", "x"));
  options.renamings = {{"x", "y"}};
  EXPECT_THAT(error_of([&] { opened_with_units("t,x,y\n0,1,2\n1,2,3\n", options); }), HasSubstr("\"y\""));
}

}  // namespace
}  // namespace tcb
