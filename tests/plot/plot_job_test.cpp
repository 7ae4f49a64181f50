// Plot: the scene of the curves of files: their names, titles, axes and samples.
#include "plot/plot_job.hpp"

#include <gmock/gmock.h>

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "error.hpp"
#include "tcb/spline/rules.hpp"
#include "temporary_folder.hpp"

namespace tcb {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

/// The picture of files named a.csv, b.csv, ….
std::string drawn(PlotJob job, const std::vector<std::string>& texts) {
  const TemporaryFolder folder;
  char name = 'a';
  for (const std::string& text : texts) {
    job.files.files.push_back(folder.path(std::string(1, name++) + ".csv"));
    std::ofstream(job.files.files.back()) << text;
  }
  job.files.outputs.file = folder.path("picture.svg");
  job.verbosity.quiet = true;
  std::ostringstream bytes;
  if (plot(job) == Exit::done) bytes << std::ifstream(job.files.outputs.file).rdbuf();
  return bytes.str();
}

PlotJob sampled() {
  PlotJob job;
  job.samples.request.mode = Mode::count;
  job.samples.request.count = 5;
  return job;
}

const std::string keys = "time,x,y\n0,0,0\n1,2,1\n2,3,5\n";

TEST(Plot, the_title_is_the_file_and_what_is_done_with_it) {
  EXPECT_THAT(drawn(sampled(), {keys}),
              AllOf(HasSubstr(">a.csv<"), HasSubstr("preset tcb · 3 keys · 5, equally spaced in time · 5 rows")));
  PlotJob job = sampled();
  job.picture.title = "A <title>";
  EXPECT_THAT(drawn(job, {keys}), HasSubstr(">A &lt;title&gt;<"));
}

TEST(Plot, rules_other_than_those_of_the_preset_are_named) {
  PlotJob job = sampled();
  job.keys.rules.ends = {ends_in("natural"), {}};
  EXPECT_THAT(drawn(job, {keys}), Not(HasSubstr("preset")));
  job = sampled();
  job.keys.rules.preset = spline::Preset::vtk;
  EXPECT_THAT(drawn(job, {keys}), HasSubstr("preset vtk"));
}

TEST(Plot, several_files_have_a_colour_each) {
  const std::string svg = drawn(sampled(), {keys, keys});
  EXPECT_THAT(svg, AllOf(HasSubstr(">a.csv and 1 more<"), HasSubstr(">b.csv<"), HasSubstr("class=\"c1\"")));
  EXPECT_THROW(drawn(sampled(), {keys, "time,x,z\n0,0,0\n1,2,1\n"}), Error);
}

TEST(Plot, axes_are_channels) {
  PlotJob job = sampled();
  job.picture.axes = {"2", "x"};
  EXPECT_THAT(drawn(job, {keys}), HasSubstr("class=\"n\">x<"));
  for (const auto& axes : {std::vector<std::string>{"x", "w"}, {"x", "1"}}) {
    job.picture.axes = axes;
    EXPECT_THROW(drawn(job, {keys}), Error);
  }
}

TEST(Plot, a_single_key_is_drawn_without_samples) {
  EXPECT_THAT(drawn(sampled(), {"time,x,y\n3,1,2\n"}), AllOf(HasSubstr("1 key ·"), HasSubstr("· 0 rows")));
}

TEST(Plot, curves_beyond_the_most_are_counted) {
  PlotJob job = sampled();
  job.keys.input.columns.roles = {{Role::group, {"id"}, "--group"}};
  std::string text = "id,time,x\n";
  for (int i = 0; i < 402; ++i) text += fmt::format("{0},0,{0}\n{0},1,0\n", i);
  EXPECT_THAT(drawn(job, {text}), HasSubstr("400 of 402 curves"));
}

}  // namespace
}  // namespace tcb
