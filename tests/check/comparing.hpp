// Comparisons for tests: keys and samples as texts, written to files of a temporary folder.
#pragma once

#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <utility>

#include "check/compare_job.hpp"
#include "error.hpp"
#include "temporary_folder.hpp"

namespace tcb {

/// Files keys.csv and rows.csv in a folder of their own, and their comparison.
class Comparing {
 public:
  Comparing(const std::string& keys, const std::string& rows) {
    std::ofstream(path("keys.csv")) << keys;
    std::ofstream(path("rows.csv")) << rows;
    comparison.keys_file = path("keys.csv");
    comparison.file = path("rows.csv");
    comparison.from_left = false;
    comparison.threads.requested = 2;
  }

  std::string path(const std::string& name) const { return folder_.path(name); }

  Comparison comparison;

 private:
  TemporaryFolder folder_;
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
