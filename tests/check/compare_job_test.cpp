// Comparisons from both files to the report: its format and the exit code.
#include "check/compare_job.hpp"

#include <gmock/gmock.h>

#include <fstream>
#include <sstream>
#include <string>

#include "comparing.hpp"
#include "formats/formats.hpp"

namespace tcb {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

const std::string keys = "time,x,y\n0,0,0\n1,1,2\n2,4,4\n";

std::string report_of(const Comparing& files) {
  std::stringstream report;
  report << std::ifstream(files.path("report")).rdbuf();
  return report.str();
}

std::string drawn(const Comparing& files) {
  CompareJob job;
  job.comparison = files.comparison;
  job.output = files.path("report");
  job.format = find_format("svg");
  compare(job);
  return report_of(files);
}

TEST(Compare, returns_whether_the_samples_agree) {
  const Comparing files("t,x\n0,0\n1,1\n", "t,x\n0,0\n1,1\n");
  CompareJob job;
  job.comparison = files.comparison;
  job.output = files.path("report");
  job.format = find_format("csv");
  EXPECT_EQ(compare(job), Exit::done);
  std::ofstream(files.path("rows.csv")) << "t,x\n0,0\n1,2\n";
  job.format = find_format("json");
  EXPECT_EQ(compare(job), Exit::data);
  EXPECT_THAT(report_of(files), testing::StartsWith("{\"passed\":false,"));
}

TEST(ComparePicture, the_largest_difference_is_marked_in_its_channel) {
  const Comparing comparing(keys, "time,x,y\n0,0,0\n1,1,2.5\n2,4,4\n");
  const std::string svg = drawn(comparing);
  EXPECT_THAT(svg, AllOf(HasSubstr("rows.csv against keys.csv"), HasSubstr("1 mismatches · largest difference 0.5"),
                         HasSubstr(">y, difference<")));
  std::size_t marks = 0;
  for (std::size_t at = 0; (at = svg.find("class=\"w\"", at)) != std::string::npos; ++at) ++marks;
  EXPECT_EQ(marks, 4U);  // the path, y, its difference, and the legend
}

TEST(ComparePicture, equal_samples_have_no_mark) {
  const Comparing comparing(keys, "time,x,y\n0,0,0\n1,1,2\n2,4,4\n");
  EXPECT_THAT(drawn(comparing), AllOf(HasSubstr("check passed"), Not(HasSubstr("class=\"w\""))));
}

TEST(ComparePicture, channels_that_are_not_compared_are_not_drawn) {
  const Comparing comparing(keys, "time,y\n0,0\n2,4\n");
  EXPECT_THAT(drawn(comparing), AllOf(HasSubstr(">y<"), Not(HasSubstr(">x<"))));
}

TEST(ComparePicture, positions_are_needed) {
  const Comparing comparing(keys, "time,speed\n0,1\n2,1\n");
  EXPECT_THAT(error_of([&] { drawn(comparing); }).message(), HasSubstr("no column of positions"));
}

}  // namespace
}  // namespace tcb
