// The pipeline of one curve: rows and facts for each way to place samples, and settings that do not fit.
#include "run/curve_pipeline.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "error.hpp"
#include "keys.hpp"
#include "sample/build.hpp"
#include "sample/kept_curve.hpp"
#include "sample/rows.hpp"

namespace tcb {
namespace {

constexpr const char* line = "0 0\n1 2\n2 4\n3 6\n";  // positions on x = 2 t, so the length is 6

Schema schema_of_x(bool timed = true) {
  Schema schema;
  schema.time.is_given = timed;
  schema.channels = {"x"};
  return schema;
}

/// The cells of the fields time and position.
std::vector<double> cells_of(const CurveSamples& samples) {
  std::vector<double> cells;
  const std::vector<std::size_t> fields{0, 1};
  while (const auto block = samples.blocks()) {
    for (const Cell& cell : samples.evaluate(*block, fields).cells) cells.push_back(cell.hi);
  }
  return cells;
}

SamplingRequest request_of(Mode mode, std::uint64_t count) {
  SamplingRequest request;
  request.mode = mode;
  request.count = count;
  return request;
}

std::vector<double> rows(const SamplingRequest& request, const CurveSettings& settings = {},
                         const std::optional<GoldenOptions>& golden = {}) {
  CurvePipeline pipeline({request, settings, {0, 1}, golden}, schema_of_x(), {}, {});
  return cells_of(pipeline.samples(keys_of(line, 2)));
}

TEST(CurvePipeline, rows_in_order_need_no_end_and_have_no_facts) {
  SamplingRequest request;
  request.step = 1;
  CurvePipeline pipeline({request, {}, {0, 1}}, schema_of_x(), {}, {});
  const CurveSamples samples = pipeline.samples(keys_of(line, 2));
  EXPECT_FALSE(samples.facts.last);
  EXPECT_EQ(cells_of(samples), (std::vector<double>{0, 0, 1, 2, 2, 4, 3, 6}));
}

TEST(CurvePipeline, a_grid_over_the_whole_curve_has_its_extent_and_step) {
  const SamplingRequest request = request_of(Mode::arc_count, 3);
  CurvePipeline pipeline({request, {}, {0, 1}}, schema_of_x(), {}, {});
  const CurveSamples samples = pipeline.samples(keys_of(line, 2));
  EXPECT_EQ(samples.facts.length, 6.0);
  EXPECT_EQ(samples.facts.step, Time(3.0));
  EXPECT_EQ(cells_of(samples), (std::vector<double>{0, 0, 1.5, 3, 3, 6}));
}

TEST(CurvePipeline, places_may_lie_outside_an_extended_curve) {
  SamplingRequest request = request_of(Mode::at, 0);
  request.places = {4, 1, -1};
  CurveSettings settings;
  settings.ends = TextSetting{"natural"};  // so that it is straight to its ends
  settings.extrapolate = TextSetting{"linear"};
  EXPECT_EQ(rows(request, settings), (std::vector<double>{4, 8, 1, 2, -1, -2}));
}

TEST(CurvePipeline, exact_rows_are_at_the_same_places) {
  EXPECT_EQ(rows(request_of(Mode::count, 3), {}, GoldenOptions{}), (std::vector<double>{0, 0, 1.5, 3, 3, 6}));
}

TEST(CurvePipeline, keys_without_times_get_times) {
  CurveSettings settings;
  settings.parameter = TextSetting{"uniform"};
  const Schema schema = schema_of_x(false);
  const SamplingRequest request = request_of(Mode::count, 2);
  CurvePipeline pipeline({request, settings, {0, 1}}, schema, {}, {});
  EXPECT_FALSE(pipeline.spec().timed);
  const Source<KeyBlock> untimed = mapped(keys_of("0 5\n0 7\n", 2), [](KeyBlock block) {
    block.keys.times.clear();
    return block;
  });
  EXPECT_EQ(cells_of(pipeline.samples(untimed)), (std::vector<double>{0, 5, 1, 7}));
}

/// The message of the error that making the pipeline ends with, and the line of its position.
std::pair<std::string, std::uint64_t> refusal(const CurveSettings& settings, const CurveInfo& info = {}) {
  try {
    CurvePipeline pipeline({request_of(Mode::count, 2), settings, {0, 1}}, schema_of_x(), {}, info);
  } catch (const Error& error) {
    return {error.message(), error.position().line};
  }
  return {};
}

TEST(CurvePipeline, a_parameterization_is_refused_with_a_time_column) {
  CurveSettings settings;
  settings.parameter = TextSetting{"chordal"};
  EXPECT_EQ(
      refusal(settings).first,
      "--parameter: column \"t\" has times already; expected keys without times; remove --parameter, or choose the "
      "columns with --columns");
}

TEST(CurvePipeline, a_wrong_setting_of_the_input_is_an_error_at_its_member) {
  CurveInfo info;
  info.settings.preset = TextSetting{"no such preset", {"preset", {"", 7, 1}}};
  EXPECT_EQ(refusal({}, info).second, 7U);
}

}  // namespace
}  // namespace tcb
