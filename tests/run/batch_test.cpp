// Batches: files that fail, files that are current, threads for large files.
#include "run/batch.hpp"

#include <gtest/gtest.h>

#include <new>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>

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

/// Standard error of a batch, and its summary.
template <class F>
std::pair<std::string, Summary> run(F convert) {
  testing::internal::CaptureStderr();
  tcb::Report report({});
  const Summary summary = convert(report);
  return {testing::internal::GetCapturedStderr(), summary};
}

std::uint64_t fail_at_threes(const InputFile& file, unsigned) {
  const auto number = std::stoull(file.path);
  if (number % 3 == 0) throw Error(Exit::data, "it is a three");
  return number;
}

TEST(Batch, a_file_that_fails_does_not_stop_the_others) {
  for (const unsigned threads : {1U, 2U, 5U}) {
    const Inputs inputs = numbered_files(10);
    const auto [errors, summary] =
        run([&](tcb::Report& report) { return convert_all(inputs, threads, report, fail_at_threes); });
    EXPECT_EQ(summary.done, 6);
    EXPECT_EQ(summary.failed, 4);
    EXPECT_EQ(summary.rows, 1 + 2 + 4 + 5 + 7 + 8);
    EXPECT_EQ(errors,
              "0: error: it is a three\n3: error: it is a three\n6: error: it is a three\n9: error: it is a three\n");
  }
}

TEST(Batch, texts_of_libraries_reach_nobody) {
  const auto message = [](const std::exception& failure) { return tcb::failure_of(failure).message(); };
  EXPECT_EQ(message(Error(Exit::data, "of a person")), "of a person");
  EXPECT_EQ(message(std::bad_alloc()), "out of memory");
  EXPECT_EQ(message(std::length_error("basic_string::append")), "out of memory");
  EXPECT_EQ(message(std::system_error(std::make_error_code(std::errc::filename_too_long), "status")),
            "the system refused a part of the work: File name too long");
  EXPECT_EQ(message(std::out_of_range("vector::_M_range_check")),
            "the program failed by a fault of its own, and wrote no output; report the command and its input");
  const auto fail = [](const InputFile&, unsigned) -> std::uint64_t { throw std::runtime_error("of a library"); };
  const auto [errors, summary] =
      run([&](tcb::Report& report) { return convert_all(numbered_files(1), 1, report, fail); });
  EXPECT_EQ(errors.find("of a library"), std::string::npos) << errors;
  EXPECT_EQ(summary.failed, 1);
}

TEST(Batch, current_files_are_skipped) {
  Inputs inputs = numbered_files(6);
  for (const std::size_t i : {0UL, 3UL, 5UL}) inputs.files[i].is_current = true;
  inputs.others = 7;
  const auto [errors, summary] =
      run([&](tcb::Report& report) { return convert_all(inputs, 3, report, fail_at_threes); });
  EXPECT_EQ(errors, "");
  EXPECT_EQ(summary.done, 3);
  EXPECT_EQ(summary.skipped, 3);
  EXPECT_EQ(summary.ignored, 7);
}

TEST(Batch, a_large_file_gets_all_threads_and_small_ones_one) {
  Inputs inputs = numbered_files(2);
  inputs.files[1].size = std::uintmax_t{1} << 30;
  const auto [errors, summary] = run([&](tcb::Report& report) {
    return convert_all(inputs, 3, report, [](const InputFile& file, unsigned threads) {
      EXPECT_EQ(threads, file.path == "1" ? 3 : 1);
      return 0;
    });
  });
  EXPECT_EQ(summary.done, 2);
}

}  // namespace
