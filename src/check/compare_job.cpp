// Compare job: checks samples, or identifies the rules that made them, from both files to the report.
#include "check/compare_job.hpp"

#include <string>
#include <vector>

#include "check/check.hpp"
#include "check/check_picture.hpp"
#include "check/ranking.hpp"
#include "check/report.hpp"
#include "io/atomic_output.hpp"
#include "io/input_list.hpp"
#include "run/progress.hpp"
#include "stream/ordered_map.hpp"

namespace tcb {
namespace {

Exit write(const CompareJob& job, const std::string& report, bool agrees) {
  Output output(job.output);
  output.write(report);
  output.commit();
  return agrees ? Exit::done : Exit::data;
}

Exit draw(const CompareJob& job, FileProgress* progress) {
  CheckPicture picture(job.picture);
  const auto observe = [&picture](const CheckedPair& pair) { picture.add(pair); };
  if (!job.identify) {
    const Check result = check(job.comparison, observe, progress);
    return write(job, picture.svg(result, in_short(result)), result.passed());
  }
  const ComparisonInputs inputs = read_positions(job.comparison, progress);
  const Identification result = identify(job.comparison, inputs);
  (void)check_best(job.comparison, result, inputs, observe);
  return write(job, picture.svg(result, in_short(result)), result.fits());
}

}  // namespace

Exit compare(const CompareJob& job) {
  std::vector<std::string> inputs = job.other_inputs;
  inputs.insert(inputs.end(), {job.comparison.keys_file, job.comparison.file});
  require_no_input_replaced(job.output, inputs);
  if (job.output != "-") remove_unfinished_when_interrupted();
  const ThreadPool pool(job.comparison.threads.count());
  Report report(job.verbosity);
  report.expect(1, 0);
  const auto progress = report.begin_file(job.comparison.keys_file, 0);
  const bool as_json = job.format == FormatId::json;
  if (format_of(job.format).family == FormatFamily::picture) return draw(job, progress.get());
  if (job.identify) {
    const Identification result = identify(job.comparison, read_positions(job.comparison, progress.get()));
    return write(job, as_json ? json(result) : text(result), result.fits());
  }
  const Check result = check(job.comparison, {}, progress.get());
  return write(job, as_json ? json(result) : text(result), result.passed());
}

}  // namespace tcb
