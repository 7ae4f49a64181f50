// Run: the job of a command line is done by the entry of its product.
#include "cli/run.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <string>
#include <variant>
#include <vector>

#include "cli/open_questions.hpp"
#include "cli/plan.hpp"
#include "io/atomic_output.hpp"
#include "io/system.hpp"
#include "io/terminal.hpp"
#include "run/batch.hpp"

namespace tcb {
namespace {

Exit refuse(Exit exit, const std::string& text) {
  (void)std::fprintf(stderr, "%s\n", text.c_str());
  return exit;
}

Exit print(const PrintText& job) {
  if (job.exit != Exit::done) return refuse(job.exit, job.text);
  Output output("-");
  output.write(job.text + "\n");
  output.commit();
  return Exit::done;
}

struct Run {
  Exit operator()(const PrintText& job) const { return print(job); }
  Exit operator()(const ResampleJob& job) const { return resample(job); }
  Exit operator()(const ExplainJob& job) const { return explain(job); }
  Exit operator()(const PlotJob& job) const { return plot(job); }
  Exit operator()(const FitJob& job) const { return fit(job); }
  Exit operator()(const CompareJob& job) const { return compare(job); }
  Exit operator()(const LimitsJob& job) const { return measure_limits(job); }
  Exit operator()(const RetimeJob& job) const {
    const RetimedKeys keys = retimed_within(job.limits);
    return std::visit(
        [&](auto rows) {
          rows.keys.rules.retiming = keys.retiming;
          rows.keys.standard_input = keys.standard_input;
          return (*this)(rows);
        },
        job.rows);
  }
};

Exit run(const std::vector<std::string>& words) {
  ColorWhen color = ColorWhen::by_terminal;
  try {
    return std::visit(Run(), parse(words, &color));
  } catch (const std::exception& failure) {
    const OpenQuestions open = open_questions(words, failure_of(failure));
    const bool has_colors = colors_messages(color);
    std::string text = error_text(open.error, has_colors);
    if (!open.settled_by.empty()) {
      text += fmt::format("\n{}{} settle these errors; check whether each is what you mean",
                          message_head("tcbsample", MessageKind::note, has_colors), open.settled_by);
    }
    return refuse(open.error.exit(), text);
  }
}

}  // namespace

int run(int argc, char** argv) {
  system::keep_standard_streams();
  end_when_interrupted();
  return static_cast<int>(run(system::arguments(argc, argv)));
}

}  // namespace tcb
