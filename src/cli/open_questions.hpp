// Open questions: the errors that would follow an error of the data once its remedy is applied, so that one run names
// all of them.
#pragma once

#include <string>
#include <vector>

#include "error.hpp"

namespace tcb {

/// An error, with those that follow it as others.
struct OpenQuestions {
  Error error;
  std::string settled_by;  ///< the options that settle all; empty where the error is alone
};

/// The questions that an error of a command leaves open, if options settle all of them; else the error alone. Each is
/// found by explaining the files with the options that the remedies so far name. These are read again for that, unless
/// one is a pipe or large.
OpenQuestions open_questions(const std::vector<std::string>& words, const Error& error);

}  // namespace tcb
