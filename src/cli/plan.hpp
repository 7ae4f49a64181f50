// Plan: from arguments to typed options, and from these to the job of a product.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "check/compare_job.hpp"
#include "cli/options.hpp"
#include "error.hpp"
#include "fit/fit_job.hpp"
#include "limits/limits_job.hpp"
#include "plot/plot_job.hpp"
#include "run/pipeline.hpp"

namespace tcb {

/// A text that is printed instead of work.
struct PrintText {
  std::string text;
  Exit exit = Exit::done;  ///< after the text; where it is another one, the text is an error message
};

/// Samples or a picture of curves whose times are scaled so that limits hold.
struct RetimeJob {
  LimitsJob limits;
  std::variant<ResampleJob, PlotJob> rows;
};

/// What the command line requests.
using Job = std::variant<PrintText, ResampleJob, ExplainJob, PlotJob, FitJob, CompareJob, LimitsJob, RetimeJob>;

/// Reads the words of a command line, without the program's name. Throws: Error (usage) that names the option, what was
/// expected, and the remedy. `color`: as requested, so that errors have it too.
Job parse(const std::vector<std::string>& words, ColorWhen* color = nullptr);

}  // namespace tcb
