// Fit job: keys for recordings, from the bytes of samples to the bytes of keys or of a picture.
#include "fit/fit_job.hpp"

#include <fmt/format.h>

#include <memory>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "error.hpp"
#include "fit/fitting.hpp"
#include "formats/formats.hpp"
#include "io/atomic_output.hpp"
#include "io/input_file.hpp"
#include "keys/curves.hpp"
#include "numbers/decimal_time.hpp"
#include "numbers/print_number.hpp"
#include "picture/differences.hpp"
#include "read/input.hpp"
#include "read/input_options.hpp"
#include "run/batch.hpp"
#include "run/curve_pipeline.hpp"
#include "run/file_notes.hpp"
#include "run/progress.hpp"
#include "sample/build.hpp"
#include "sample/places.hpp"
#include "sample/rows.hpp"
#include "sample/table.hpp"
#include "schema/format.hpp"
#include "stream/ordered_map.hpp"
#include "stream/source.hpp"
#include "write/labels.hpp"
#include "write/writer.hpp"

namespace tcb {
namespace {

/// An output of the keys of one file of recordings or of several.
class FittedKeys final : public BatchOutput {
 public:
  FittedKeys(const FitJob& job, Report& report, const std::string& path)
      : job_(job), report_(report), writer_(job.rows, path), zero_(given_zero(job.rows)) {}

  /// The stages of a fit, with their observers. Returns the number of keys.
  std::uint64_t add(const InputFile& file, unsigned threads) override {
    const bool live = is_live(file.path);
    const std::shared_ptr<FileProgress> progress = report_.begin_file(file.path, file.size);
    FileNotes notes(report_, file.path);
    ProvenanceRecorder& provenance = writer_.recorder();
    InputBytes opened = open_file(file.path);
    Source<std::string> bytes = progress->observe_bytes(std::move(opened.bytes));
    bytes = provenance.observe_bytes(file.path, std::move(bytes));
    InputOptions options = job_.keys.input;
    options.threads = job_.threads.for_reading(threads, live);
    const Input input = open_input(file.path, bytes, options);  // split, parse
    notes.add_input(input, job_.keys);
    Curves curves(input.schema, input.keys, job_.keys.curves, opened.arrive);  // group, order, split into recordings
    const Schema keys = keys_of_fit(input, job_.keys.rules, job_.options);
    for (const Note& note : notes_of_columns(input.schema, job_.options)) notes.add(note);
    writer_.begin(keys, live, preset_in_words(CurveSpec()), shown_name(file.path));
    const FitReport report = write(fitted_rows(samples(input.schema, curves, *progress), *progress, options.threads));
    if (report.keys > 0) {
      const Note note = note_of(report, job_.options);
      notes.add(note);
      provenance.set_results({{"fit", note.text}});
    }
    provenance.end_input();
    notes.end(curves);
    return report.keys;
  }

  void commit() override { writer_.commit(); }

 private:
  /// The samples of each recording.
  Source<Samples> samples(const Schema& schema, Curves& curves, FileProgress& progress) {
    return [this, &schema, &curves, &progress, expected = 0.0]() mutable -> std::optional<Samples> {
      std::optional<InputCurve> curve = curves.next();
      if (!curve) return std::nullopt;
      const Format& format = *job_.rows.format;
      if (expected > 0 && curve->group.empty() && format.offers(offer::marks) && format.delimiter != ' ') {
        throw data_error(
            "there are several curves, and {} does not show where one curve ends; give --output-format ssv or json, or "
            "name a column of groups with --group",
            format.name);
      }
      curve->keys = writer_.recorder().observe_keys(std::move(curve->keys));
      if (job_.rows.time_zero) {
        const auto frames = named_times(notation_of_times(job_.rows, schema.time), job_.rows.frame_rate, schema.time);
        if (!zero_) zero_ = {first_time(curve->keys, frames).value_or(0), true};
        require_times(*zero_, schema.time);
        count_from(*curve, zero_->time, frames);
      }
      Samples read = recorded_samples(*curve, schema, job_.keys.rules, job_.options);
      progress.expect_rows(expected += static_cast<double>(read.times.size()));
      return read;
    };
  }

  /// The keys of each recording, which is fitted on a thread of its own.
  Source<FittedRows> fitted_rows(Source<Samples> recordings, FileProgress& progress, unsigned threads) const {
    const auto keys_of = [this, &progress, threads](const Samples& recording) {
      std::size_t counted = 0;
      const auto done = [&](std::size_t number) {
        progress.add_rows((counted + number) / fit_passes - counted / fit_passes);
        counted += number;
      };
      return rows_of(recording, fitted(recording, job_.options, done, threads), job_.options);
    };
    return ordered_map(std::move(recordings), keys_of, threads);
  }

  FitReport write(const Source<FittedRows>& fits) {
    FitReport report;
    while (const std::optional<FittedRows> rows = fits()) {
      writer_.begin_curve(rows->group);
      writer_.write([&, done = false]() mutable -> std::optional<std::string> {
        if (std::exchange(done, true)) return std::nullopt;
        return writer_.print(rows->table, true);
      });
      writer_.recorder().count_rows(rows->report.keys);
      report.add(rows->report);
    }
    return report;
  }

  const FitJob& job_;
  Report& report_;
  Writer writer_;
  std::optional<CountedFrom> zero_;  ///< from which times count; nothing: not known yet
};

/// The samples of a recording beside its curve. A computed quaternion is negated where that is nearer to the sample, as
/// both are the same rotation.
std::vector<ComparedSample> compared_samples(const Samples& samples, const std::shared_ptr<const KeptCurve>& curve) {
  std::vector<Time> times;
  for (const Time& time : samples.times) {
    times.push_back(curve->extent().decimals > 0 ? with_all_digits(time) : as_double(time));
  }
  const std::vector fields{field_of("time"), field_of("position")};
  const Recording& recording = samples.recording;
  const FoundRows rows = find_rows(curve, {.places = std::move(times)}, false, spline::Side::left);
  std::vector<ComparedSample> compared;
  while (const std::optional<SampleBlock> block = rows.blocks()) {
    const std::vector<Cell> cells = evaluate(*block, *rows.locator, fields);
    for (auto cell = cells.begin(); cell != cells.end();) {
      ComparedSample& sample = compared.emplace_back(ComparedSample{*cell++, {}, {}});
      for (std::size_t channel = 0; channel < recording.channels; ++channel) {
        sample.given.push_back(recording.position(compared.size() - 1, channel));
        sample.computed.push_back((cell++)->hi);
      }
      for (const FitGroup& group : recording.groups) {
        double cosine = 0;
        for (const std::size_t i : group.channels) cosine += sample.computed[i] * sample.given[i];
        if (!group.angle || !(cosine < 0)) continue;
        for (const std::size_t i : group.channels) sample.computed[i] *= -1;
      }
    }
  }
  return compared;
}

FitReport add_fits(DifferencePicture& picture, const FitJob& job, const std::string& path) {
  const Input input = open_input(path, read_file(path), job.keys.input);
  const Schema keys = curve_of_fit(input, job.keys.rules, job.options);
  std::vector<std::size_t> all(keys.channels.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  picture.begin(keys, all);
  FitReport report;
  Curves curves(input.schema, input.keys, job.keys.curves);
  while (const std::optional<InputCurve> curve = curves.next()) {
    const Samples samples = recorded_samples(*curve, input.schema, job.keys.rules, job.options);
    const FitResult result = fitted(samples, job.options);
    report.add(rows_of(samples, result, job.options).report);
    const auto blocks = [&result]() -> Source<KeyBlock> {
      KeyBlock fitted_keys;
      fitted_keys.text_positions.lines.assign(result.keys.size(), 1);
      fitted_keys.keys = result.keys;
      return [block = std::optional(fitted_keys)]() mutable { return std::exchange(block, std::nullopt); };
    };
    SamplingRequest request;
    request.mode = Mode::at;
    CurvePipeline pipeline({.samples = request, .rules = job.keys.rules, .threads = job.threads.count()}, keys, {}, {});
    const StreamedCurve streamed = pipeline.streamed(blocks());
    picture.add(streamed, pipeline.spec().channels(), compared_samples(samples, pipeline.kept(blocks())));
  }
  return report;
}

/// Fits the recordings of the one input of a job, and writes the picture.
Exit draw_fit(const FitJob& job) {
  const OutputPaths& outputs = job.files.outputs;
  const Inputs inputs = find_inputs(job.files);  // which refuses an output that would replace an input
  if (inputs.files.size() != 1 || outputs.folder) {
    throw usage_error(
        "a picture of --fit shows one recording; expected one input and one output; draw each file by itself");
  }
  const std::string& path = inputs.files[0].path;
  if (outputs.file != "-") remove_unfinished_when_interrupted();
  const ThreadPool pool(job.threads.count());
  Report notes(job.verbosity);
  DifferencePicture picture(job.picture, "keys", shown_name(path));
  const FitReport report = in_file(shown_name(path), [&] { return add_fits(picture, job, path); });
  Output output(outputs.file);
  output.write(picture.svg(fmt::format("{} samples · {} keys · at least {} are needed", with_thousands(report.samples),
                                       with_thousands(report.keys), with_thousands(report.least_keys))));
  output.commit();
  notes.note(path, note_of(report, job.options));
  return Exit::done;
}

}  // namespace

Exit fit(const FitJob& job) {
  if (job.rows.format->is_picture) return draw_fit(job);
  Report report(job.verbosity);
  return convert_files(job, report,
                       [&](const std::string& path) { return std::make_unique<FittedKeys>(job, report, path); });
}

}  // namespace tcb
