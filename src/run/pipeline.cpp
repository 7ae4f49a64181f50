// Pipeline: the stages from the bytes of keys to the bytes of samples, in the order of the flow.
#include "run/pipeline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

#include "fit/errors.hpp"
#include "fit/fitting.hpp"
#include "io/atomic_output.hpp"
#include "io/input_file.hpp"
#include "numbers/print_number.hpp"
#include "option_names.hpp"
#include "plot/drawing.hpp"
#include "read/reader.hpp"
#include "run/errors.hpp"
#include "stream/ordered_map.hpp"
#include "stream/source.hpp"

namespace tcb {
namespace {

WriterOptions writer_options(const Job& job) {
  return {job.output_format, job.output_header, job.notation,      job.fields,
          job.meta,          job.file_column,   job.time_notation, job.input.units.frame_rate};
}

InputOptions input_options(const Job& job, unsigned threads, bool live) {
  InputOptions options = job.input;
  options.threads = live && !job.jobs ? 1 : threads;  // with more, a row would wait for later keys
  if (format_of(job.output_format).family == FormatFamily::picture) options.rotation.as_curves = true;
  return options;
}

InputListOptions input_list_options(const Job& job) {
  const BatchOptions& batch = job.batch;
  const OutputPaths outputs{job.output, job.output_folder, batch.suffix, format_of(job.output_format).ending};
  return {.files = job.files,
          .list = batch.list,
          .nul = batch.nul,
          .recursive = batch.recursive,
          .endings = job.input.format ? std::vector<std::string_view>{} : input_endings(),
          .update = batch.update,
          .outputs = outputs};
}

/// One file on its way into an output.
class FileRun {
 public:
  FileRun(const InputFile& file, const Job& job, Report& report, Sink& sink)
      : path_(file.path),
        live_(is_live(path_)),
        job_(job),
        report_(report),
        progress_(report.begin_file(path_, file.size)),
        sink_(sink) {}

  /// The stages of the flow, with their observers. Returns the number of rows.
  std::uint64_t run(unsigned threads) {
    if (is_terminal(path_)) report_.note(path_, reads_terminal());
    Source<std::string> bytes = progress_->observe_bytes(read_file(path_));
    if (sink_.writer) bytes = sink_.writer->recorder().observe_bytes(shown_name(path_), std::move(bytes));
    const InputOptions options = input_options(job_, threads, live_);
    const Input input = open_input(path_, bytes, options);  // split, parse
    note_input(input);
    Curves curves(input.schema, input.keys, job_.curves, live_);  // order, group, split into curves
    if (job_.sampling.mode == Mode::fit) {
      fit(input, curves, *sink_.writer, options.threads);
    } else {
      while (const std::optional<CurveKeys> curve = curves.next()) {
        begin(input, *curve, options.threads);
        sink_.writer ? print(input, *curve, *sink_.writer, options.threads) : draw(*curve, *sink_.drawing);
      }
    }
    if (sink_.writer) sink_.writer->recorder().end_input();
    if (remainders_ > 1) report_.note(path_, more_remainders(remainders_ - 1));
    if (curves.skipped() > 0) report_.note(path_, skipped_rows(curves.skipped()));
    return rows_;
  }

 private:
  /// Begins the output of the next curve. Curves with the same information share their rules.
  void begin(const Input& input, const CurveKeys& curve, unsigned threads) {
    if (curve.curve_info != curve_info_ || !job_.grouped_places.empty()) {
      pipeline_.emplace(sampling_of(curve, input.schema, job_), job_.curve, job_.fields, job_.golden, input.schema,
                        input.keys.traits, *curve.curve_info, threads);
    }
    if (curve_info_ == nullptr) sink_.begin(path_, input.schema, pipeline_->facts());
    curve_info_ = curve.curve_info;
    if (sink_.writer) sink_.writer->begin_curve(curve.group);
  }

  /// The stages from the keys of a curve to its rows.
  void print(const Input& input, const CurveKeys& curve, Writer& writer, unsigned threads) {
    ProvenanceRecorder& provenance = writer.recorder();
    const auto labels = labels_of(input);
    Source<KeyBlock> keys = provenance.observe_keys(curve.keys);
    if (labels != nullptr) keys = Labels::observe(labels, std::move(keys));
    PlacedCurve placed = pipeline_->place(std::move(keys));  // segments, measure, place
    placed.blocks = provenance.observe_rows(counted(placed));
    writer.write(printed(writer, placed, labels, threads));  // evaluate, print
    provenance.end_curve();
    note_curve(placed);
  }

  /// From the samples of each recording to its keys.
  void fit(const Input& input, Curves& curves, Writer& writer, unsigned threads) {
    ProvenanceRecorder& provenance = writer.recorder();
    const Source<Samples> samples = [&, expected = 0.0]() mutable -> std::optional<Samples> {
      std::optional<CurveKeys> curve = curves.next();
      if (!curve) return std::nullopt;
      const Format& format = format_of(job_.output_format);
      if (expected > 0 && curve->group.empty() && format.family == FormatFamily::delimited && format.delimiter != ' ') {
        throw fit_of_sequence(format.name);
      }
      curve->keys = provenance.observe_keys(std::move(curve->keys));
      Samples read = recorded_samples(*curve, input.schema, sampling_of(*curve, input.schema, job_).places, job_);
      progress_->expect_rows(expected += static_cast<double>(read.times.size()));
      return read;
    };
    sink_.begin(path_, keys_of_fit(input, job_), RuleFacts{{}, true});
    const FitReport report = write_fits(samples, job_.fit, writer, *progress_, threads);
    rows_ = report.keys;
    if (report.keys == 0) return;
    const Note note = note_of(report, job_.fit);
    report_.note(path_, note);
    provenance.set_results({{"fit", note.text}});
  }

  /// The stages from the keys of a curve to its part of a picture.
  void draw(const CurveKeys& curve, Drawing& drawing) {
    StoredCurve stored = pipeline_->stored(curve.keys);  // segments, measure, place
    if (stored.placed) stored.placed->blocks = counted(*stored.placed);
    drawing.add(curve.group, stored, short_rules(pipeline_->facts()));  // evaluate, draw
    if (stored.placed) note_curve(*stored.placed);
  }

  /// The samples of a curve, counted as done.
  Source<SampleBlock> counted(PlacedCurve& placed) {
    return progress_->observe_rows(std::move(placed.blocks), placed.expected_rows, rows_);
  }

  /// The labels of a curve, which are the texts of its keys after those of groups; null if there are none.
  static std::shared_ptr<Labels> labels_of(const Input& input) {
    if (input.schema.labels.empty()) return nullptr;
    return std::make_shared<Labels>(input.keys.traits.own_curves ? 0 : input.schema.groups.size());
  }

  /// The rows of a curve as text.
  Source<std::string> printed(const Writer& writer, const PlacedCurve& placed, const std::shared_ptr<Labels>& labels,
                              unsigned threads) const {
    if (job_.golden) threads = 1;  // exact rows share results of earlier ones
    if (labels == nullptr) {
      const auto print = [this, &writer, &placed](const SampleBlock& block) {
        return writer.print(placed.evaluate(block, job_.fields), block.first);
      };
      return ordered_map(placed.blocks, print, threads);
    }
    const auto row_end = [&writer](std::span<const std::string_view> texts) { return writer.row_end(texts); };
    const auto print = [&writer, &placed](const LabelledBlock& block) { return writer.print(block, placed.evaluate); };
    return ordered_map(Labels::attach(labels, placed.blocks, row_end, placed.sampler != nullptr), print, threads);
  }

  void note_input(const Input& input) {
    if (job_.sampling.mode == Mode::fit) {
      for (const Note& note : notes_of_columns(input.schema, job_.fit)) report_.note(path_, note);
    }
    const bool takes_likely = !job_.input.rotation.none && job_.input.rotation.requests.empty();
    if (takes_likely && input.facts.likely_rotation) {
      const bool is_matrix = input.facts.likely_rotation == spline::RotationForm::matrix;
      report_.note(path_, is_matrix ? likely_matrix() : likely_quaternion());
    }
    if (!input.schema.time.is_given && !job_.curve.parameter) report_.note(path_, no_time_column());
    if (job_.sampling.is_rate && input.schema.time.unit == TimeUnit::frames) {
      report_.note(path_, rate_of_frames(input.schema.time.name));
    }
    const bool chosen = std::ranges::count(job_.input.columns.roles, Role::position, &RoleRequest::role) > 0;
    if (input.facts.ignored.empty()) return;
    report_.note(path_, chosen ? unchosen_columns(input.facts.ignored) : ignored_columns(input.facts.ignored));
  }

  void note_curve(const PlacedCurve& placed) {
    const auto distance = placed.remainder();
    const bool ends_at_key = !job_.sampling.to && !pipeline_->facts().spec.closed;
    if (distance && remainders_++ == 0) report_.note(path_, remainder_note(nearest_time(*distance).hi, ends_at_key));
    if (placed.facts.step && job_.sampling.end != EndPolicy::drop) {
      report_.note(path_, step_is(time_text(*placed.facts.step)));
    }
  }

  const std::string& path_;
  const bool live_;
  const Job& job_;
  Report& report_;
  const std::shared_ptr<FileProgress> progress_;
  Sink& sink_;
  std::shared_ptr<const CurveInfo> curve_info_;  ///< of the curve before
  std::optional<CurvePipeline> pipeline_;
  std::uint64_t rows_ = 0;
  std::uint64_t remainders_ = 0;  ///< number of curves whose end is not a row
};

/// The files of a job, and what they share.
class JobRun {
 public:
  JobRun(const Job& job)
      : job_(job),
        options_(writer_options(job)),
        threads_(job.threads()),
        pool_(threads_),
        files_(input_list_options(job)),
        inputs_(find_inputs(files_)),
        report_(job.verbosity) {}

  void explain() const {
    Output output("-");
    for (const InputFile& file : inputs_.files) {
      in_file(shown_name(file.path), [&] { output.write(explanation(file.path, job_)); });
    }
    output.commit();
  }

  Exit resample() {
    warn_of_other_program();
    std::uintmax_t bytes = 0;
    for (const InputFile& file : inputs_.files) bytes += file.size;
    report_.expect(inputs_.files.size(), bytes);
    if (job_.output_folder) return resample_each();
    resample_together();
    return Exit::done;
  }

 private:
  /// An output for each file.
  Exit resample_each() {
    make_folder(*job_.output_folder);
    const auto convert = [this](const InputFile& file, unsigned threads) {
      const std::string path = output_path(file, files_.outputs);
      if (file.inside > 0) make_folder(folder_of(path));
      Sink sink(job_, options_, path);
      const std::uint64_t rows = FileRun(file, job_, report_, sink).run(threads);
      sink.commit();
      return rows;
    };
    const InputFile& first = inputs_.files.front();
    if (inputs_.files.size() + inputs_.others == 1 && !first.is_current) {  // its errors end the program
      in_file(shown_name(first.path), [&] { convert(first, threads_); });
      return Exit::done;
    }
    const Summary summary = convert_all(inputs_, job_.batch.fail_fast, threads_, report_, convert);
    report_.summary(summary);
    return summary.failed == 0 ? Exit::done : Exit::data;
  }

  /// One output for all files.
  void resample_together() {
    Sink sink(job_, options_, job_.output);
    for (const InputFile& file : inputs_.files) {
      in_file(shown_name(file.path), [&] { FileRun(file, job_, report_, sink).run(threads_); });
    }
    sink.commit();
  }

  /// Warns if another version made the earlier output, as its last digits may differ.
  void warn_of_other_program() {
    if (!job_.meta || job_.meta->from.empty()) return;
    const std::string &earlier = job_.meta->earlier.program, &current = job_.meta->meta.program;
    if (earlier != current) report_.warning(job_.meta->from, other_program(earlier, current));
  }

  const Job& job_;
  const WriterOptions options_;
  const unsigned threads_;
  const ThreadPool pool_;
  const InputListOptions files_;
  const Inputs inputs_;
  Report report_;
};

}  // namespace

SamplingRequest sampling_of(const CurveKeys& curve, const Schema& schema, const Job& job) {
  SamplingRequest request = job.sampling;
  if (job.grouped_places.empty()) return request;
  const auto places = job.grouped_places.find(contents(curve.group));
  if (places == job.grouped_places.end()) {
    throw group_without_places(group_title(schema.groups, curve.group))
        .about(request.mode == Mode::at ? option::at : option::arc_at);
  }
  request.places = places->second;
  return request;
}

Exit resample(const Job& job) {
  JobRun run(job);
  if (!job.explain) return run.resample();
  run.explain();
  return Exit::done;
}

}  // namespace tcb
