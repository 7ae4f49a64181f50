// Command lines in tests: the names of options, and the job that a line makes, or its error.
#pragma once

#include <gmock/gmock.h>

#include <string>
#include <variant>
#include <vector>

#include "cli/options.hpp"
#include "cli/plan.hpp"
#include "error.hpp"

namespace tcb {

/// The names of all options, with their dashes.
inline std::vector<std::string> option_names() {
  std::vector<std::string> all;
  for (const OptionRow& row : option_table()) {
    for (const std::string_view name : row.all_names()) all.emplace_back(name);
  }
  return all;
}

/// The job that this command line makes, which is one of this type.
template <class Product = ResampleJob>
Product job_of(const std::vector<std::string>& words) {
  return std::get<Product>(parse(words));
}

/// The text that this command line prints.
inline std::string printed_text(const std::vector<std::string>& words) { return job_of<PrintText>(words).text; }

/// The words of the error of usage that this command line causes; "" where there is none.
inline std::string refusal(const std::vector<std::string>& words) {
  try {
    parse(words);
  } catch (const Error& error) {
    EXPECT_EQ(error.exit(), Exit::usage);
    return error.message();
  }
  return "";
}

/// The job of these words after --step 1.
inline ResampleJob stepped(std::vector<std::string> words) {
  words.insert(words.begin(), "--step=1");
  return job_of(words);
}

/// The words of the error of these words after --step 1.
inline std::string stepped_refusal(std::vector<std::string> words) {
  words.insert(words.begin(), "--step=1");
  return refusal(words);
}

}  // namespace tcb
