// Comparisons from both files to the report: its format and the exit code.
#include "check/compare_job.hpp"

#include <gmock/gmock.h>

#include <fstream>
#include <sstream>
#include <string>

#include "comparing.hpp"

namespace tcb {
namespace {

TEST(Compare, returns_whether_the_samples_agree) {
  const Comparing files("t,x\n0,0\n1,1\n", "t,x\n0,0\n1,1\n");
  CompareJob job;
  job.comparison = files.comparison;
  job.output = files.path("report");
  EXPECT_EQ(compare(job), Exit::done);
  std::ofstream(files.path("rows.csv")) << "t,x\n0,0\n1,2\n";
  job.format = FormatId::json;
  EXPECT_EQ(compare(job), Exit::data);
  std::stringstream report;
  report << std::ifstream(files.path("report")).rdbuf();
  EXPECT_THAT(report.str(), testing::StartsWith("{\"passed\":false,"));
}

}  // namespace
}  // namespace tcb
