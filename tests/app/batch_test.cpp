// Tests of batches: what becomes of files when some fail, some are current, and some are to stop the others.
#include "app/batch.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <string>

#include "error.hpp"

namespace {

using tcb::Error;
using tcb::Exit;
using tcb::InputFile;
using tcb::Inputs;
using tcb::Summary;

Inputs numbered_files(int count) {
  Inputs inputs;
  for (int i = 0; i < count; ++i) inputs.files.push_back({std::to_string(i)});
  return inputs;
}

/// What is said on standard error while `batch` runs, and what came of it.
template <class SampleBlock>
std::pair<std::string, Summary> run(SampleBlock batch) {
  testing::internal::CaptureStderr();
  tcb::Report report({});
  const Summary summary = batch(report);
  return {testing::internal::GetCapturedStderr(), summary};
}

std::uint64_t fail_at_threes(const InputFile& file, unsigned) {
  const auto number = std::stoull(file.path);
  if (number % 3 == 0) throw Error(Exit::data, "it is a three");
  return number;
}

TEST(SampleBlock, a_file_that_fails_stops_no_other) {
  for (const unsigned threads : {1U, 2U, 5U}) {
    const Inputs inputs = numbered_files(10);
    const auto [said, summary] =
        run([&](tcb::Report& report) { return convert_all(inputs, {}, threads, report, fail_at_threes); });
    EXPECT_EQ(summary.done, 6);
    EXPECT_EQ(summary.failed, 4);
    EXPECT_EQ(summary.rows, 1 + 2 + 4 + 5 + 7 + 8);
    EXPECT_EQ(said,
              "0: error: it is a three\n3: error: it is a three\n6: error: it is a three\n9: error: it is a three\n");
  }
}

TEST(SampleBlock, the_first_failure_stops_the_rest_where_that_is_asked) {
  Inputs inputs = numbered_files(1000);
  inputs.files.erase(inputs.files.begin());
  tcb::Job plan;
  plan.batch.fail_fast = true;
  for (const unsigned threads : {1U, 4U}) {
    const auto [said, summary] =
        run([&](tcb::Report& report) { return convert_all(inputs, plan, threads, report, fail_at_threes); });
    EXPECT_EQ(said.substr(0, said.find('\n')), "3: error: it is a three");
    EXPECT_GE(summary.done, 2);
    EXPECT_LT(summary.done + summary.failed, 3 + 2 * threads);
  }
}

TEST(SampleBlock, what_is_current_is_left_out) {
  Inputs inputs = numbered_files(6);
  for (const std::size_t i : {0UL, 3UL, 5UL}) inputs.files[i].is_current = true;
  inputs.left_alone = 7;
  const auto [said, summary] =
      run([&](tcb::Report& report) { return convert_all(inputs, {}, 3, report, fail_at_threes); });
  EXPECT_EQ(said, "");
  EXPECT_EQ(summary.done, 3);
  EXPECT_EQ(summary.skipped, 3);
  EXPECT_EQ(summary.left_alone, 7);
}

TEST(SampleBlock, a_large_file_gets_all_threads_and_small_ones_one) {
  Inputs inputs = numbered_files(2);
  inputs.files[1].size = std::uintmax_t{1} << 30;
  const auto [said, summary] = run([&](tcb::Report& report) {
    return convert_all(inputs, {}, 3, report, [](const InputFile& file, unsigned threads) {
      EXPECT_EQ(threads, file.path == "1" ? 3 : 1);
      return 0;
    });
  });
  EXPECT_EQ(summary.done, 2);
}

}  // namespace
