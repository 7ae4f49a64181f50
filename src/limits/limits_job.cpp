// Limits job: certified maxima of the curves of a file, against limits, from the bytes of keys to the report.
#include "limits/limits_job.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

#include "formats/formats.hpp"
#include "io/atomic_output.hpp"
#include "io/input_file.hpp"
#include "io/input_list.hpp"
#include "keys/curves.hpp"
#include "limits/exact_segments.hpp"
#include "limits/factor.hpp"
#include "limits/report.hpp"
#include "limits/wanted.hpp"
#include "picture/scene.hpp"
#include "read/input.hpp"
#include "read/input_options.hpp"
#include "run/batch.hpp"
#include "run/curve_pipeline.hpp"
#include "run/file_notes.hpp"
#include "run/progress.hpp"
#include "schema/texts.hpp"
#include "stream/ordered_map.hpp"

namespace tcb {
namespace limits {
namespace {

/// Adds what is asked for of a curve to the report, and its corners.
void measure(const MeasuredCurve& curve, const std::vector<std::size_t>& compared,
             const std::vector<std::string>& title, std::vector<LimitResult> wanted, LimitsReport& report) {
  std::vector<Measure> measures;
  for (const LimitResult& one : wanted) {
    measures.push_back(one.measure);
    if (one.limit) measures.back().limit = one.measure.as_measured(*one.limit);
  }
  Extremes found = extremes(curve, measures, compared);
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    LimitResult& result = wanted[i];
    const Measure& one = measures[i];
    result.extreme = std::move(found.maxima[i]);
    if (result.limit && result.extreme) {
      const Extreme& extreme = *result.extreme;
      if (extreme.is_unproved) {
        throw data_error("numbers are too far apart to bound the {}; expected fewer such keys; remove this limit",
                         one.name);
      }
      result.is_broken = std::ranges::any_of(found.corners, [&](const Corner& corner) {
        if (one.kind == Measure::Kind::curvature) return corner.turns(compared, one.channels);
        return one.derivative > 1 && std::ranges::any_of(corner.channels, [&](std::size_t channel) {
                 return std::ranges::count(one.channels, channel) > 0;
               });
      });
      result.passed = !result.is_broken && !extreme.is_unbounded && extreme.high <= *one.limit;
    }
    report.results.push_back(std::move(result));
  }
  for (Corner& corner : found.corners) report.corners.push_back({title, std::move(corner)});
}

/// Draws the curves of a report, and the place of its tightest limit.
class LimitsPicture {
 public:
  /// The options outlive this.
  explicit LimitsPicture(const PictureOptions& options) : options_(options) {}

  void add(const StreamedCurve& streamed, const Schema& schema, const CurveSpec& spec, std::string title) {
    if (scene_.channels.empty()) {
      scene_.begin(schema, schema.channels, options_.axes, spec.rules.metric, spec.lacks_metric);
      scene_.require_few_strips();
    }
    if (scene_.curves.size() == Scene::most_curves) return;
    scene_.names.push_back(std::move(title));
    const auto segments = [streamed] { return streamed.segments(); };
    scene_.curves.push_back({scene_.names.size() - 1, streamed.keys,
                             with_rotations_as_cubics(segments, spec.channels()), streamed.extent.closed});
  }

  /// The picture as SVG. Throws: Error as picture() does.
  std::string svg(const LimitsReport& report) {
    scene_.title = options_.title.value_or(report.keys.substr(report.keys.rfind('/') + 1));
    scene_.subtitle = in_short(report);
    const LimitResult* const tightest = report.tightest();
    if (tightest != nullptr && !tightest->measure.is_of_rotation) {
      const Extreme& extreme = *tightest->extreme;
      scene_.worst = SceneMark{nearest_time(extreme.time), extreme.position, tightest->measure.channels};
      scene_.worst_in_words = tightest->measure.name;
    }
    return picture(std::move(scene_), options_.size);
  }

 private:
  const PictureOptions& options_;
  Scene scene_;
};

/// `drawing`: what draws the curves, if anything does.
LimitsReport report_of(const LimitsJob& job, Report& progress, LimitsPicture* drawing = nullptr) {
  LimitsReport report{shown_name(job.keys_file), {}};
  FileNotes notes(progress, job.keys_file);
  const auto file = progress.begin_file(job.keys_file, 0);
  InputOptions options = job.keys.input;
  options.threads = job.threads.count();
  const Input input = open_input(job.keys_file, file->observe_bytes(job.keys.bytes_of(job.keys_file)), options);
  notes.add_input(input, job.keys);
  report.channels = input.schema.channels;
  Curves curves(input.schema, input.keys, job.keys.curves, false);
  while (const std::optional<InputCurve> keys = curves.next()) {
    const CurveRequest request{.samples = job.part, .rules = job.keys.rules, .threads = options.threads};
    CurvePipeline pipeline(request, input.schema, input.keys.traits, *keys->curve_info, keys->part);
    StreamedCurve streamed = pipeline.streamed(keys->keys);
    streamed.options.expanded = true;
    if (!report.first) report.first = exact_number(streamed.keys.key(0).times[0], false, pipeline.spec().frames);
    for (const spline::EndRule rule : {pipeline.spec().rules.start.rule, pipeline.spec().rules.end.rule}) {
      if (rule == spline::EndRule::lightwave && !pipeline.spec().closed) report.has_ends_by_seconds = true;
    }
    const std::vector<std::string> title = group_title(input.schema.groups, keys->group);
    std::vector<std::size_t> compared;
    for (std::size_t i = 0; i < report.channels.size(); ++i) {
      if (!spline::is_in_rotation(pipeline.spec().rules.rotations, i)) compared.push_back(i);
    }
    std::vector<LimitResult> wanted = wanted_of(job.options, pipeline.spec(), report.channels, title);
    const bool turns = std::ranges::any_of(wanted, [](const LimitResult& one) { return one.measure.is_of_rotation; });
    const auto with_angles = [](SegmentBlock block) {
      add_angles(block.segments);
      return block;
    };
    ExactSegments exact(pipeline.exact(streamed), turns);
    const MeasuredCurve curve{[=] { return turns ? mapped(streamed.segments(), with_angles) : streamed.segments(); },
                              [&](std::size_t number) { return exact.in_balls(number); },
                              [&](std::size_t number, bool directions) { return exact(number, directions); },
                              pipeline.spec().frames,
                              pipeline.request().from,
                              pipeline.request().to,
                              streamed.extent.closed};
    measure(curve, compared, title, std::move(wanted), report);
    const std::string name = title.empty() ? report.keys : fmt::format("{}", fmt::join(title, ", "));
    if (drawing != nullptr) drawing->add(streamed, input.schema, pipeline.spec(), name);
  }
  notes.end(curves);
  const auto is_measured = [](const LimitResult& result) { return result.extreme.has_value(); };
  if (!report.results.empty() && std::ranges::none_of(report.results, is_measured)) {
    throw usage_error("no curve is in the range of times; give times on a curve")
        .about(job.part.from ? "--from" : "--to");
  }
  return report;
}

}  // namespace
}  // namespace limits

RetimedKeys retimed_within(LimitsJob job) {
  if (job.keys_file == "-") {
    const Source<std::string> bytes = read_file(job.keys_file);
    std::string all;
    while (const std::optional<std::string> part = bytes()) all += *part;
    job.keys.standard_input = std::make_shared<const std::string>(std::move(all));
  }
  Verbosity quiet = job.verbosity;
  quiet.quiet = true;
  Retiming retiming{1, 0};
  {
    const ThreadPool pool(job.threads.count());
    Report silent(quiet);
    in_file(shown_name(job.keys_file), [&] {
      const limits::LimitsReport report = limits::report_of(job, silent);
      retiming = {limits::factor_within(report, job.options.fits), report.first.value_or(0)};
    });
  }
  Report(job.verbosity)
      .note(job.keys_file, {fmt::format("the times are scaled by {}, so that all limits hold",
                                        time_text(nearest_time(retiming.factor))),
                            true});
  return {retiming, job.keys.standard_input};
}

Exit measure_limits(const LimitsJob& job) {
  std::vector<std::string> inputs = job.other_inputs;
  inputs.push_back(job.keys_file);
  require_no_input_replaced(job.output, inputs);
  if (job.output != "-") remove_unfinished_when_interrupted();
  const ThreadPool pool(job.threads.count());
  Report progress(job.verbosity);
  progress.expect(1, 0);
  limits::LimitsPicture drawing(job.picture);
  limits::LimitsPicture* const drawn = job.format->is_picture ? &drawing : nullptr;
  const limits::LimitsReport report =
      in_file(shown_name(job.keys_file), [&] { return limits::report_of(job, progress, drawn); });
  Output output(job.output);
  output.write(drawn != nullptr ? drawing.svg(report) : job.format->has_reports ? json(report) : text(report));
  output.commit();
  return report.passed() ? Exit::done : Exit::data;
}

}  // namespace tcb
