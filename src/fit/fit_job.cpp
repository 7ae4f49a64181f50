// Fit job: keys for recordings, from the bytes of samples to the bytes of keys or of a picture.
#include "fit/fit_job.hpp"

#include <memory>
#include <optional>
#include <utility>

#include "fit/errors.hpp"
#include "fit/fit_picture.hpp"
#include "fit/fitting.hpp"
#include "io/input_file.hpp"
#include "keys/curves.hpp"
#include "read/reader.hpp"
#include "run/batch.hpp"
#include "run/file_notes.hpp"
#include "run/in_words.hpp"
#include "run/progress.hpp"
#include "schema/formats.hpp"
#include "stream/ordered_map.hpp"
#include "stream/source.hpp"

namespace tcb {
namespace {

/// One file of recordings on its way into an output.
class FitRun {
 public:
  FitRun(const InputFile& file, unsigned threads, const FitJob& job, Report& report, Writer& writer)
      : path_(file.path),
        live_(is_live(path_)),
        threads_(job.threads.for_reading(threads, live_)),
        job_(job),
        progress_(report.begin_file(path_, file.size)),
        notes_(report, path_),
        writer_(writer) {}

  /// The stages of a fit, with their observers. Returns the number of keys.
  std::uint64_t run() {
    ProvenanceRecorder& provenance = writer_.recorder();
    Source<std::string> bytes = progress_->observe_bytes(read_file(path_));
    bytes = provenance.observe_bytes(shown_name(path_), std::move(bytes));
    InputOptions options = job_.keys.input;
    options.threads = threads_;
    const Input input = open_input(path_, bytes, options);  // split, parse
    for (const Note& note : notes_of_columns(input.schema, job_.options)) notes_.add(note);
    notes_.add_input(input, job_.keys);
    Curves curves(input.schema, input.keys, job_.keys.curves, live_);  // group, order, split into recordings
    begin(input);
    const FitReport report = write(fitted_rows(samples(input.schema, curves)));
    if (report.keys > 0) {
      const Note note = note_of(report, job_.options);
      notes_.add(note);
      provenance.set_results({{"fit", note.text}});
    }
    provenance.end_input();
    notes_.end(curves);
    return report.keys;
  }

 private:
  void begin(const Input& input) {
    const Schema keys = keys_of_fit(input, job_.keys.rules, job_.options);
    writer_.begin(keys, live_, preset_in_words(RuleFacts{{}, true}), shown_name(path_));
  }

  /// The samples of each recording.
  Source<Samples> samples(const Schema& schema, Curves& curves) {
    return [this, &schema, &curves, expected = 0.0]() mutable -> std::optional<Samples> {
      std::optional<CurveKeys> curve = curves.next();
      if (!curve) return std::nullopt;
      const Format& format = format_of(job_.rows.format);
      if (expected > 0 && curve->group.empty() && format.family == FormatFamily::delimited && format.delimiter != ' ') {
        throw fit_of_sequence(format.name);
      }
      curve->keys = writer_.recorder().observe_keys(std::move(curve->keys));
      Samples read = recorded_samples(*curve, schema, job_.keys.rules, job_.options);
      progress_->expect_rows(expected += static_cast<double>(read.times.size()));
      return read;
    };
  }

  /// The keys of each recording, which is fitted on a thread of its own.
  Source<FittedRows> fitted_rows(Source<Samples> recordings) const {
    const auto keys_of = [this](const Samples& recording) {
      std::size_t counted = 0;
      const auto done = [&](std::size_t number) {
        progress_->add_rows((counted + number) / fit_passes - counted / fit_passes);
        counted += number;
      };
      return rows_of(recording, fitted(recording, job_.options, done, threads_), job_.options);
    };
    return ordered_map(std::move(recordings), keys_of, threads_);
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

  const std::string& path_;
  const bool live_;
  const unsigned threads_;
  const FitJob& job_;
  const std::shared_ptr<FileProgress> progress_;
  FileNotes notes_;
  Writer& writer_;
};

/// An output of the keys of one file of recordings or of several.
class FittedKeys final : public BatchOutput {
 public:
  FittedKeys(const FitJob& job, Report& report, const std::string& path)
      : job_(job), report_(report), writer_(job.rows, path) {}

  std::uint64_t add(const InputFile& file, unsigned threads) override {
    return FitRun(file, threads, job_, report_, writer_).run();
  }
  void commit() override { writer_.commit(); }

 private:
  const FitJob& job_;
  Report& report_;
  Writer writer_;
};

}  // namespace

Exit fit(const FitJob& job) {
  if (format_of(job.rows.format).family == FormatFamily::picture) return draw_fit(job);
  Report report(job.verbosity);
  warn_of_other_program(report, job.rows.provenance);
  return convert_files(job.files, job.fail_fast, job.threads, report,
                       [&](const std::string& path) { return std::make_unique<FittedKeys>(job, report, path); });
}

}  // namespace tcb
