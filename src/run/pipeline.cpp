// Pipeline: the stages from the bytes of keys to the bytes of samples, in the order of the flow.
#include "run/pipeline.hpp"
#include "formats/formats.hpp"
#include "read/input.hpp"
#include "read/input_options.hpp"

#include <fmt/format.h>

#include <memory>
#include <utility>

#include "io/input_file.hpp"
#include "keys/curves.hpp"
#include "run/batch.hpp"
#include "run/curve_pipeline.hpp"
#include "run/file_notes.hpp"
#include "run/progress.hpp"
#include "stream/ordered_map.hpp"
#include "stream/source.hpp"
#include "text/suggest.hpp"
#include "write/labels.hpp"
#include "write/writer.hpp"

namespace tcb {
namespace {

/// One file on its way into an output.
class FileRun {
 public:
  /// `zero`: from which times count; set by the first key, unless it is known.
  FileRun(const InputFile& file, unsigned threads, const ResampleJob& job, Report& report, Writer& writer,
          std::optional<CountedFrom>& zero)
      : path_(file.path),
        live_(is_live(path_)),
        threads_(job.threads.for_reading(threads, live_)),
        job_(job),
        progress_(report.begin_file(path_, file.size)),
        notes_(report, path_),
        writer_(writer),
        zero_(zero) {}

  /// The stages of the flow, with their observers. Returns the number of rows.
  std::uint64_t run() {
    ProvenanceRecorder& provenance = writer_.recorder();
    InputBytes file = job_.keys.bytes_of(path_);
    Source<std::string> bytes = progress_->observe_bytes(std::move(file.bytes));
    bytes = provenance.observe_bytes(path_, std::move(bytes));
    InputOptions options = job_.keys.input;
    options.threads = threads_;
    const Input input = open_input(path_, bytes, options);  // split, parse
    notes_.add_input(input, job_.keys, job_.samples.request, job_.rows.fields);
    Curves curves(input.schema, input.keys, job_.keys.curves, file.arrive);  // group, order, split into curves
    std::uint64_t rows = 0;
    while (std::optional<InputCurve> curve = curves.next()) {
      if (job_.rows.time_zero && !zero_) {
        const auto frames =
            named_times(notation_of_times(job_.rows, input.schema.time), job_.rows.frame_rate, input.schema.time);
        zero_ = {first_time(curve->keys, frames).value_or(0), true};
      }
      begin(input, *curve);
      const auto labels = labels_of(input);
      Source<KeyBlock> keys = provenance.observe_keys(curve->keys);
      if (labels != nullptr) keys = Labels::observe(labels, std::move(keys));
      CurveSamples samples = pipeline_->samples(std::move(keys));  // segments, measure, place
      if (curve->part && !has_rows(samples)) {                     // the range does not meet it
        provenance.end_curve();
        continue;
      }
      begin_rows(input, *curve);
      samples.blocks = progress_->observe_rows(std::move(samples.blocks), samples.expected_rows, rows);
      samples.blocks = provenance.observe_rows(std::move(samples.blocks));
      writer_.write(printed(samples, labels));  // evaluate, print
      provenance.end_curve();
      notes_.add_samples(samples, job_.samples.request, pipeline_->spec().closed);
    }
    provenance.end_input();
    notes_.end(curves, job_.keys);
    return rows;
  }

 private:
  /// Begins the rows of the next curve. Curves with the same information share their rules.
  void begin(const Input& input, const InputCurve& curve) {
    if (curve.curve_info != curve_info_ || !job_.samples.grouped_places.empty() || curve.part) {
      const CurveRequest request{job_.samples.of(curve, input.schema),
                                 job_.keys.rules,
                                 job_.rows.fields,
                                 job_.golden,
                                 threads_,
                                 notation_of_times(job_.rows, input.schema.time),
                                 job_.rows.frame_rate,
                                 zero_,
                                 may_have_empty_cells(),
                                 !job_.verbosity.quiet};
      pipeline_.emplace(request, input.schema, input.keys.traits, *curve.curve_info, curve.part);
    }
    if (curve_info_ == nullptr) {
      writer_.begin(input.schema, live_, preset_in_words(pipeline_->spec()), shown_name(path_));
      if (RowKeeper* const keeper = writer_.keeper()) begin_keeper(*keeper, input, *curve.curve_info);
    }
    curve_info_ = curve.curve_info;
  }

  /// Neither keyframes nor poses.
  bool may_have_empty_cells() const { return job_.rows.format->offers(offer::any_columns); }

  void begin_keeper(RowKeeper& keeper, const Input& input, const CurveInfo& info) {
    if (const auto others = keeper.channels_in_extras(); !others.empty()) {
      notes_.add({fmt::format("in the extras of the animation, as they are not a translation, rotation or scale: {}",
                              listed(others)),
                  true});
    }
    if (const auto frames = played_frames(input, info)) keeper.set_frames(*frames);
  }

  void begin_rows(const Input& input, const InputCurve& curve) {
    const auto euler = input.facts.euler_tracks.find(curve.group);
    writer_.begin_curve(curve.group,
                        euler == input.facts.euler_tracks.end() ? std::nullopt : std::optional(euler->second));
  }

  /// The frames that are asked for, where rows have the same distance in time; nothing: their rate follows from the
  /// rows.
  std::optional<PlayedFrames> played_frames(const Input& input, const CurveInfo& info) const {
    if (job_.samples.takes_frames()) return PlayedFrames{info.frames->rate, info.frames->seconds};
    const SamplingRequest& request = pipeline_->request();
    const bool is_even = !request.keys && (request.end == EndPolicy::drop || request.end == EndPolicy::keep);
    if (request.mode != Mode::step || !is_even) return std::nullopt;
    return PlayedFrames{units_per_second(input.schema.time.unit.value_or(TimeUnit::s)) / request.step};
  }

  /// Whether a curve has rows. Reads its blocks up to the first one with some.
  static bool has_rows(CurveSamples& samples) {
    std::optional<SampleBlock> block = samples.blocks();
    while (block && block->parts.empty()) block = samples.blocks();
    if (!block) return false;
    samples.blocks = preceded_by(std::move(*block), std::move(samples.blocks));
    return true;
  }

  /// The labels of a curve, which are the texts of its keys after those of groups; null if there are none.
  static std::shared_ptr<Labels> labels_of(const Input& input) {
    if (input.schema.labels.empty()) return nullptr;
    return std::make_shared<Labels>(input.keys.traits.own_curves ? 0 : input.schema.groups.size());
  }

  /// The rows of a curve as text.
  Source<std::string> printed(const CurveSamples& samples, const std::shared_ptr<Labels>& labels) const {
    const bool shares_lengths = job_.golden && by_length(job_.samples.request);  // with earlier rows
    const unsigned threads = shares_lengths ? 1 : threads_;
    if (labels == nullptr) {
      const auto print = [this, &samples](const SampleBlock& block) {
        return writer_.print(samples.evaluate(block, job_.rows.fields), block.first);
      };
      return ordered_map(samples.blocks, print, threads);
    }
    const auto row_end = [this](std::span<const std::string_view> texts) { return writer_.row_end(texts); };
    const auto print = [this, &samples](const LabelledBlock& block) { return writer_.print(block, samples.evaluate); };
    return ordered_map(Labels::attach(labels, samples.blocks, row_end, samples.in_order), print, threads);
  }

  const std::string& path_;
  const bool live_;
  const unsigned threads_;
  const ResampleJob& job_;
  const std::shared_ptr<FileProgress> progress_;
  FileNotes notes_;
  Writer& writer_;
  std::optional<CountedFrom>& zero_;
  std::shared_ptr<const CurveInfo> curve_info_;  ///< of the curve before
  std::optional<CurvePipeline> pipeline_;
};

/// An output of the rows of one file or of several.
class Rows final : public BatchOutput {
 public:
  Rows(const ResampleJob& job, Report& report, const std::string& path)
      : job_(job), report_(report), writer_(job.rows, path), zero_(given_zero(job.rows)) {}

  std::uint64_t add(const InputFile& file, unsigned threads) override {
    return FileRun(file, threads, job_, report_, writer_, zero_).run();
  }
  void commit() override { writer_.commit(); }

 private:
  const ResampleJob& job_;
  Report& report_;
  Writer writer_;
  std::optional<CountedFrom> zero_;
};

}  // namespace

Exit resample(const ResampleJob& job) {
  Report report(job.verbosity);
  return convert_files(job, report, [&](const std::string& path) { return std::make_unique<Rows>(job, report, path); });
}

}  // namespace tcb
