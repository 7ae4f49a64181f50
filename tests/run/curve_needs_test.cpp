// Curve needs: which requests need all keys, random access and lengths, and the words for that.
#include "run/curve_pipeline.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "sample/fields.hpp"

namespace tcb {
namespace {

std::string needs(Mode mode, const std::vector<std::size_t>& fields = {}, const CurveSpec& spec = {},
                  bool may_miss = false, bool exact = false) {
  SamplingRequest request;
  request.mode = mode;
  request.count = 3;
  return in_words(curve_needs(request, fields, spec, may_miss, exact));
}

TEST(CurveNeeds, a_step_needs_a_few_keys_at_a_time) {
  EXPECT_EQ(needs(Mode::step), "a few keys at a time");
  EXPECT_EQ(needs(Mode::per_segment), "a few keys at a time");
  EXPECT_EQ(needs(Mode::arc_step), "a few keys at a time, the length of each segment");
  EXPECT_EQ(needs(Mode::step, {field_of("s")}), "a few keys at a time, the length of each segment");
}

TEST(CurveNeeds, a_number_of_rows_needs_all_keys_or_the_whole_length) {
  EXPECT_EQ(needs(Mode::count), "all keys before the first row");
  EXPECT_EQ(needs(Mode::arc_count), "all keys and the length of the curve before the first row");
}

TEST(CurveNeeds, places_need_segments_in_any_order) {
  EXPECT_EQ(needs(Mode::at), "all keys before the first row, segments in any order");
  EXPECT_EQ(needs(Mode::tolerance), "all keys before the first row, segments in any order");
  EXPECT_EQ(needs(Mode::arc_at), "all keys before the first row, segments in any order, the length of each segment");
  CurveSpec extended;
  extended.extrapolations.after = Extrapolation::hold;
  EXPECT_EQ(needs(Mode::step, {}, extended), "all keys before the first row, segments in any order");
}

TEST(CurveNeeds, closed_curves_missing_positions_angles_and_exact_numbers_need_all_keys) {
  CurveSpec closed, angles;
  closed.closed = true;
  angles.angles = {{}};
  EXPECT_EQ(needs(Mode::step, {}, closed), "all keys before the first row");
  EXPECT_EQ(needs(Mode::step, {}, angles), "all keys before the first row");
  EXPECT_EQ(needs(Mode::step, {}, {}, true), "all keys before the first row");
  EXPECT_EQ(needs(Mode::step, {}, {}, false, true), "all keys before the first row");
}

TEST(CurveNeeds, the_metric_is_needed_for_lengths_or_for_the_path) {
  SamplingRequest request;
  const auto metric = [&](const std::vector<std::size_t>& fields, bool timed = true) {
    CurveSpec spec;
    spec.parameter = 0.5;
    spec.timed = timed;
    return curve_needs(request, fields, spec, false, false).metric;
  };
  EXPECT_EQ(metric({}), MetricUse::nothing);
  EXPECT_EQ(metric({field_of("s")}), MetricUse::lengths);
  EXPECT_EQ(metric({field_of("speed")}), MetricUse::path);
  EXPECT_EQ(metric({}, false), MetricUse::path) << "distances make the times";
}

}  // namespace
}  // namespace tcb
