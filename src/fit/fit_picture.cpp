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
#include "read/reader.hpp"
#include "run/progress.hpp"
#include "stream/ordered_map.hpp"

namespace tcb {
namespace {

KeyBlock block_of(Keys keys) {
  KeyBlock block;
  block.text_positions.lines.assign(keys.size(), 1);
  block.keys = std::move(keys);
  return block;
}

/// The recordings of the input of a job, and their keys. Adds to the report.
ComparisonInputs fitted_inputs(const FitJob& job, FitReport& report) {
  ComparisonInputs inputs;
  const std::string& path = job.files.files[0];
  inputs.file = shown_name(path);
  inputs.keys = "keys";
  inputs.threads = job.threads.count();
  const Input input = open_input(path, read_file(path), job.keys.input);
  Schema& keys = inputs.kept.schema;
  keys = curve_of_fit(input, job.keys.rules, job.options);
  Curves curves(input.schema, input.keys, job.keys.curves, false);
  while (const std::optional<CurveKeys> curve = curves.next()) {
    Samples samples = recorded_samples(*curve, input.schema, job.keys.rules, job.options);
    FitResult result = fitted(samples, job.options);
    report.add(rows_of(samples, result, job.options).report);
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

Exit draw_fit(const FitJob& job) {
  const OutputPaths& outputs = job.files.outputs;
  if (job.files.files.size() != 1 || outputs.folder || job.files.recursive) throw fit_picture_of_several_files();
  const std::string& path = job.files.files[0];
  (void)find_inputs(job.files);  // refuses an output that would replace an input
  if (outputs.file != "-") remove_unfinished_when_interrupted();
  const ThreadPool pool(job.threads.count());
  Report notes(job.verbosity);
  FitReport report;
  CheckPicture picture(job.picture);
  Comparison comparison;
  comparison.keys = job.keys;
  comparison.abs = job.options.tolerances;
  const Check result = in_file(shown_name(path), [&] {
    return check(comparison, fitted_inputs(job, report), [&](const CheckedPair& pair) { picture.add(pair); });
  });
  Output output(outputs.file);
  output.write(picture.svg(result, fmt::format("{} samples · {} keys · at least {} are needed", report.samples,
                                               report.keys, report.least_keys)));
  output.commit();
  notes.note(path, note_of(report, job.options));
  return Exit::done;
}

}  // namespace tcb
