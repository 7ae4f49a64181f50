// Compare job: checks samples, or identifies the rules that made them, from both files to the report.
#include "check/compare_job.hpp"

#include <algorithm>
#include <span>
#include <string>
#include <vector>

#include "check/check.hpp"
#include "check/ranking.hpp"
#include "io/atomic_output.hpp"
#include "io/input_file.hpp"
#include "io/input_list.hpp"
#include "picture/differences.hpp"
#include "run/curve_pipeline.hpp"
#include "run/progress.hpp"
#include "sample/build.hpp"
#include "stream/ordered_map.hpp"

namespace tcb {
namespace {

Exit write(const CompareJob& job, const std::string& report, bool agrees) {
  Output output(job.output);
  output.write(report);
  output.commit();
  return agrees ? Exit::done : Exit::data;
}

class ComparisonPicture {
 public:
  explicit ComparisonPicture(const CompareJob& job)
      : picture_(job.picture, shown_name(job.comparison.keys_file), shown_name(job.comparison.file)) {}

  /// Adds a curve with the samples that are on it. Throws: Error (data) if no position is compared.
  void add(const CheckedPair& pair) {
    if (!picture_.has_begun()) begin(pair.inputs);
    if (picture_.is_full()) return;
    CurvePipeline pipeline = pair.pipeline;
    const StreamedCurve curve = pipeline.streamed(pair.curve.keys());
    picture_.add(curve, pipeline.spec().channels(), samples_of(pair));
  }

  std::string svg(const std::string& result) { return picture_.svg(result); }

 private:
  void begin(const ComparisonInputs& inputs) {
    const std::vector<std::string>& channels = inputs.kept.schema.channels;
    for (std::size_t channel = 0; channel < channels.size(); ++channel) {
      const auto column = std::ranges::find(inputs.columns.compared, channels[channel], &MatchedColumn::name);
      if (column == inputs.columns.compared.end()) continue;
      channels_.push_back(channel);
      given_.push_back(column->given);
    }
    if (channels_.empty()) throw no_position_column(channels);
    picture_.begin(inputs.kept.schema, channels_);
  }

  std::vector<ComparedSample> samples_of(const CheckedPair& pair) const {
    MatchedColumns columns = pair.inputs.columns;
    columns.fields = {field_of("time"), field_of("position")};
    const std::vector<std::string>& names = pair.inputs.kept.schema.channels;
    for (MatchedColumn& column : columns.compared) {
      column.computed = 1 + static_cast<std::size_t>(std::ranges::find(names, column.name) - names.begin());
    }
    std::vector<ComparedSample> samples;
    for_each_row(pair.rows, pair.places, columns, pair.indexed, pair.side, pair.inputs.threads,
                 [&](std::size_t row, std::span<const Cell> cells) {
                   ComparedSample& sample = samples.emplace_back(ComparedSample{cells[0], {}, {}});
                   const auto given = pair.rows.row(row);
                   for (const std::size_t column : given_) sample.given.push_back(given[column]);
                   for (const std::size_t channel : channels_) sample.computed.push_back(cells[1 + channel].hi);
                 });
    return samples;
  }

  DifferencePicture picture_;
  std::vector<std::size_t> channels_;  ///< of the keys: those that are compared
  std::vector<std::size_t> given_;     ///< their columns in the table of samples
};

Exit draw(const CompareJob& job, FileProgress* progress) {
  ComparisonPicture picture(job);
  const auto observe = [&picture](const CheckedPair& pair) { picture.add(pair); };
  if (!job.identify) {
    const Check result = check(job.comparison, read_inputs(job.comparison, job.comparison.fields, progress), observe);
    return write(job, picture.svg(in_short(result)), result.passed());
  }
  const ComparisonInputs inputs = read_positions(job.comparison, progress);
  const Identification result = identify(job.comparison, inputs);
  (void)check_best(job.comparison, result, inputs, observe);
  return write(job, picture.svg(in_short(result)), result.fits());
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
  const bool as_json = job.format->has_reports;
  if (job.format->is_picture) return draw(job, progress.get());
  if (job.identify) {
    const Identification result = identify(job.comparison, read_positions(job.comparison, progress.get()));
    return write(job, as_json ? json(result) : text(result), result.fits());
  }
  const Check result = check(job.comparison, read_inputs(job.comparison, job.comparison.fields, progress.get()));
  return write(job, as_json ? json(result) : text(result), result.passed());
}

}  // namespace tcb
