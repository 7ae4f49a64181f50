// The program: command line in, exit code out.
#include <cstdio>
#include <exception>
#include <string>
#include <variant>
#include <vector>

#include "check/compare_job.hpp"
#include "cli/plan.hpp"
#include "error.hpp"
#include "fit/fit_job.hpp"
#include "io/atomic_output.hpp"
#include "io/system.hpp"
#include "io/terminal.hpp"
#include "limits/limits_job.hpp"
#include "plot/plot_job.hpp"
#include "run/batch.hpp"
#include "run/pipeline.hpp"

namespace {

tcb::Exit refuse(tcb::Exit exit, const std::string& text) {
  (void)std::fprintf(stderr, "%s\n", text.c_str());
  return exit;
}

tcb::Exit print(const tcb::PrintText& job) {
  if (job.exit != tcb::Exit::done) return refuse(job.exit, job.text);
  tcb::Output output("-");
  output.write(job.text + "\n");
  output.commit();
  return tcb::Exit::done;
}

/// Runs a job by the entry of its product.
struct Run {
  tcb::Exit operator()(const tcb::PrintText& job) const { return print(job); }
  tcb::Exit operator()(const tcb::ResampleJob& job) const { return tcb::resample(job); }
  tcb::Exit operator()(const tcb::ExplainJob& job) const { return tcb::explain(job); }
  tcb::Exit operator()(const tcb::PlotJob& job) const { return tcb::plot(job); }
  tcb::Exit operator()(const tcb::FitJob& job) const { return tcb::fit(job); }
  tcb::Exit operator()(const tcb::CompareJob& job) const { return tcb::compare(job); }
  tcb::Exit operator()(const tcb::LimitsJob& job) const { return tcb::measure_limits(job); }
  tcb::Exit operator()(const tcb::RetimeJob& job) const {
    const tcb::RetimedKeys keys = tcb::retimed_within(job.limits);
    return std::visit(
        [&](auto rows) {
          rows.keys.rules.retiming = keys.retiming;
          rows.keys.standard_input = keys.standard_input;
          return (*this)(rows);
        },
        job.rows);
  }
};

tcb::Exit run(const std::vector<std::string>& words) {
  tcb::ColorWhen color = tcb::ColorWhen::by_terminal;
  try {
    return std::visit(Run(), tcb::parse(words, &color));
  } catch (const std::exception& failure) {
    const tcb::Error error = tcb::failure_of(failure);
    return refuse(error.exit(), tcb::error_text(error, tcb::colors_messages(color)));
  }
}

}  // namespace

int main(int argc, char** argv) {
  tcb::system::keep_standard_streams();
  tcb::end_when_interrupted();
  return static_cast<int>(run(tcb::system::arguments(argc, argv)));
}
