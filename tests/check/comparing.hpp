// Comparisons for tests: keys and samples as texts, written to files of a temporary folder.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <utility>

#include "check/compare_job.hpp"
#include "error.hpp"

namespace tcb {

/// Files keys.csv and rows.csv in a folder of their own, and their comparison.
class Comparing {
 public:
  Comparing(const std::string& keys, const std::string& rows)
      : folder_(std::filesystem::path(testing::TempDir()) /
                testing::UnitTest::GetInstance()->current_test_info()->test_suite_name() /
                testing::UnitTest::GetInstance()->current_test_info()->name()) {
    std::filesystem::create_directories(folder_);
    std::ofstream(folder_ / "keys.csv") << keys;
    std::ofstream(folder_ / "rows.csv") << rows;
    comparison.keys_file = path("keys.csv");
    comparison.file = path("rows.csv");
    comparison.from_left = false;
    comparison.threads.requested = 2;
  }
  Comparing(const Comparing&) = delete;
  Comparing& operator=(const Comparing&) = delete;
  ~Comparing() { std::filesystem::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  Comparison comparison;

 private:
  std::filesystem::path folder_;
};

/// The error that f ends with.
template <class F>
Error error_of(F f) {
  try {
    f();
  } catch (const Error& error) {
    return error;
  }
  ADD_FAILURE() << "no error";
  return {Exit::done, ""};
}

}  // namespace tcb
