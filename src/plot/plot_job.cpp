// Plot: pictures of curves and their samples, from the bytes of keys to the bytes of SVG.
#include "plot/plot_job.hpp"

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "io/input_file.hpp"
#include "keys/curves.hpp"
#include "plot/drawing.hpp"
#include "read/reader.hpp"
#include "run/batch.hpp"
#include "run/curve_pipeline.hpp"
#include "run/file_notes.hpp"
#include "run/progress.hpp"
#include "sample/fields.hpp"

namespace tcb {
namespace {

/// A picture of the curves of one file or of several.
class Picture final : public BatchOutput {
 public:
  Picture(const PlotJob& job, Report& report, const std::string& path)
      : job_(job), report_(report), drawing_(job.picture, job.samples.request, path) {}

  std::uint64_t add(const InputFile& file, unsigned threads) override {
    const bool live = is_live(file.path);
    const auto progress = report_.begin_file(file.path, file.size);
    FileNotes notes(report_, file.path);
    const Source<std::string> bytes = progress->observe_bytes(read_file(file.path));
    InputOptions options = job_.keys.input;
    options.threads = job_.threads.for_reading(threads, live);
    const Input input = open_input(file.path, bytes, options);  // split, parse
    notes.add_input(input, job_.keys, job_.samples.request);
    Curves curves(input.schema, input.keys, job_.keys.curves, live);  // group, order, split into curves
    std::uint64_t rows = 0;
    for (bool is_first = true; const std::optional<CurveKeys> curve = curves.next(); is_first = false) {
      CurvePipeline pipeline = pipeline_of(input, *curve, options.threads);
      const RuleFacts rules = pipeline.facts();
      if (is_first) drawing_.begin(file.path, input.schema, rules);
      StoredCurve stored = pipeline.stored(curve->keys);  // segments, measure, place
      std::optional<PlacedCurve>& placed = stored.placed;
      if (placed) placed->blocks = progress->observe_rows(std::move(placed->blocks), placed->expected_rows, rows);
      drawing_.add(curve->group, stored, short_rules(rules));  // evaluate, draw
      if (placed) notes.add_samples(*placed, job_.samples.request, rules.spec.closed);
    }
    notes.end(curves);
    return rows;
  }

  void commit() override { drawing_.commit(); }

 private:
  CurvePipeline pipeline_of(const Input& input, const CurveKeys& curve, unsigned threads) const {
    const CurveRequest request{.samples = job_.samples.of(curve, input.schema),
                               .rules = job_.keys.rules,
                               .fields = {field_of("time"), field_of("position")},
                               .threads = threads};
    return {request, input.schema, input.keys.traits, *curve.curve_info};
  }

  const PlotJob& job_;
  Report& report_;
  Drawing drawing_;
};

}  // namespace

Exit plot(const PlotJob& job) {
  Report report(job.verbosity);
  return convert_files(job.files, job.fail_fast, job.threads, report,
                       [&](const std::string& path) { return std::make_unique<Picture>(job, report, path); });
}

}  // namespace tcb
