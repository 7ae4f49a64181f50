// Explanation: a line for each fact that was detected, and for the curve or the curves.
#include "run/explain.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "formats/formats.hpp"
#include "option_names.hpp"

namespace tcb {
namespace {

/// The explanation of a file with this text, for `count` rows per curve.
std::string explained(const std::string& text, std::uint64_t count, const std::vector<std::string>& groups = {}) {
  const auto path = std::filesystem::temp_directory_path() / ("explain_test." + std::to_string(getpid()) + ".csv");
  std::ofstream(path) << text;
  ExplainJob job;
  job.format = find_format("csv");
  job.samples.request.mode = Mode::count;
  job.samples.request.count = count;
  job.fields = {0, 1};
  if (!groups.empty()) job.keys.input.columns.roles.push_back({Role::group, groups, option::group});
  std::string result;
  explain(path.string(), job, [&result](std::string_view text) { result += text; });
  std::filesystem::remove(path);
  return result;
}

void expect_lines(const std::string& text, const std::vector<std::string>& lines) {
  for (const std::string& wanted : lines)
    EXPECT_NE(text.find("\n" + wanted + "\n"), std::string::npos) << wanted << " in " << text;
}

TEST(Explain, what_was_detected_and_one_curve) {
  const std::string text = explained("t;x;y\n0;1;2\n2;3;4\n", 5);
  expect_lines(text, {"delimiter: ;", "header: yes", "time: t", "keys: 2", "step: 0.5", "rows: 5"});
}

TEST(Explain, several_curves_have_one_line_each_and_totals) {
  const std::string text = explained("id,t,x\na,0,1\na,1,2\nb,0,1\nb,3,2\n", 4, {"id"});
  expect_lines(text, {"curves: 2", "curve id=b: 2 keys, from 0 to 3, step 1, 4 rows", "keys: 4", "rows: 8"});
}

}  // namespace
}  // namespace tcb
