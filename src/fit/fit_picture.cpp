// Pictures of fits: the recording over the curve of its keys, and their differences over time.
//
// It is the picture of a check of the recording against the keys.
#include "fit/fit_picture.hpp"

#include <fmt/format.h>

#include <utility>

#include "check/check_picture.hpp"
#include "fit/errors.hpp"
#include "fit/fitting.hpp"
#include "io/atomic_output.hpp"
#include "io/input_file.hpp"
#include "option_names.hpp"
#include "read/reader.hpp"
#include "run/pipeline.hpp"

namespace tcb {
namespace {

KeyBlock block_of(Keys keys) {
  KeyBlock block;
  block.lines.assign(keys.size(), 1);
  block.keys = std::move(keys);
  return block;
}

/// The recordings of the input of a job, and their keys. Adds to the report.
ComparisonInputs fitted_inputs(const Job& job, FitReport& report) {
  ComparisonInputs inputs;
  inputs.file = shown_name(job.files[0]);
  inputs.keys = "keys";
  inputs.threads = job.threads();
  const Input input = open_input(job.files[0], read_file(job.files[0]), job.input);
  Schema& keys = inputs.kept.schema;
  keys = curve_of_fit(input, job);
  Curves curves(input.schema, input.keys, job.curves, false);
  while (const std::optional<CurveKeys> curve = curves.next()) {
    Samples samples = recorded_samples(*curve, input.schema, sampling_of(*curve, input.schema, job).places, job);
    FitResult result = fitted(samples, job.fit);
    report.add(rows_of(samples, result, job.fit).report);
    inputs.kept.curves.push_back(
        {curve->group, std::make_shared<const CurveInfo>(), {block_of(std::move(result.keys))}});
    inputs.table.curves.push_back(
        {curve->group, std::move(samples.times), std::move(samples.recording.positions), std::move(samples.lines)});
  }
  inputs.table.named = inputs.table.timed = true;
  inputs.table.time = keys.time.name;
  inputs.table.columns = keys.channels;
  inputs.columns = match_columns(inputs.table, keys, {});
  return inputs;
}

}  // namespace

Exit draw_fit(const Job& job) {
  if (job.files.size() != 1 || job.output_folder || job.batch.recursive) {
    throw fit_picture_of_several_files();
  }
  const ThreadPool pool(job.threads());
  Report notes(job.verbosity);
  FitReport report;
  CheckPicture picture(job);
  Job check_job = job;
  check_job.comparison = Comparison{job.files[0], false, job.fit.tolerances, {}, {}};
  const Check result = in_file(shown_name(job.files[0]), [&] {
    return check(check_job, fitted_inputs(job, report), [&](const CheckedPair& pair) { picture.add(pair); });
  });
  Output output(job.output);
  output.write(picture.svg(result, fmt::format("{} samples · {} keys · at least {} are needed", report.samples,
                                               report.keys, report.least_keys)));
  output.commit();
  notes.note(job.files[0], note_of(report, job.fit));
  return Exit::done;
}

}  // namespace tcb
