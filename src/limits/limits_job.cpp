// Limits job: certified maxima of the curves of a file, against limits, from the bytes of keys to the report.
//
// report_of() reads the curves. Of each it takes the measures that are wanted, and their maxima (extremes.hpp) into the
// report. measure_limits() prints this as text, as JSON, or as a picture with the tightest limit; retimed_within()
// finds the factor of the times by which all limits hold.
#include "limits/limits_job.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <unordered_map>
#include <utility>
#include <vector>

#include "formats/formats.hpp"
#include "io/atomic_output.hpp"
#include "io/input_file.hpp"
#include "io/input_list.hpp"
#include "keys/curves.hpp"
#include "limits/exact_segments.hpp"
#include "limits/polynomial.hpp"
#include "limits/report.hpp"
#include "picture/scene.hpp"
#include "read/input.hpp"
#include "read/input_options.hpp"
#include "run/batch.hpp"
#include "run/curve_pipeline.hpp"
#include "run/file_notes.hpp"
#include "run/progress.hpp"
#include "sample/build.hpp"
#include "schema/texts.hpp"
#include "stream/ordered_map.hpp"
#include "text/suggest.hpp"
#include "text/utf8.hpp"

namespace tcb {
namespace limits {
namespace {

// What is asked for: the measures by name.

/// Measures of a channel, such as velocity_x, and those over the metric channels.
struct Quantity {
  std::string_view name;
  int derivative;
};
constexpr std::array of_channels{Quantity{"position", 0}, Quantity{"velocity", 1}, Quantity{"acceleration", 2},
                                 Quantity{"jerk", 3}};
constexpr std::array norms{Quantity{"speed", 1}, Quantity{"acceleration", 2}, Quantity{"jerk", 3}};

/// All measures of a curve with channels of these names, as sizes.
std::vector<Measure> known_measures(const CurveSpec& spec, const std::vector<std::string>& names) {
  const auto& [rotations, angles] = std::tie(spec.rules.rotations, spec.rules.angles);
  std::vector<std::size_t> metric = spline::metric_of(spec.rules, names.size());
  if (metric.empty() && rotations.empty() && angles.empty()) {
    for (std::size_t i = 0; i < names.size(); ++i) metric.push_back(i);
  }
  std::vector<Measure> known;
  for (const Quantity& norm : norms) {
    if (!metric.empty()) known.push_back({std::string(norm.name), Measure::Kind::size, norm.derivative, metric});
  }
  if (metric.size() > 1) known.push_back({"curvature", Measure::Kind::curvature, 0, metric});
  for (std::size_t i = 0; i < rotations.size(); ++i) {
    Measure one{rotations.size() == 1 ? "angular_speed" : fmt::format("angular_speed{}", i + 1),
                Measure::Kind::size,
                1,
                {names.size() + i}};
    one.is_of_rotation = true;
    const spline::RotationCurve curve = spec.rules.rotation_rules.curve;
    if (curve == spline::RotationCurve::components) {
      one.kind = Measure::Kind::angular_speed;
      one.channels.assign(rotations[i].channels.begin(), rotations[i].channels.end());
    } else if (curve != spline::RotationCurve::slerp) {
      continue;  // no bound is proved
    }
    known.push_back(std::move(one));
  }
  const std::vector<bool> are_in_rotations = spline::in_rotations(rotations, names.size());
  const std::vector<bool> are_plain = spline::plain_channels(rotations, angles, names.size());
  for (const auto& [name, derivative] : of_channels) {
    for (std::size_t i = 0; i < names.size(); ++i) {
      const bool has_it = derivative > 0 ? !are_in_rotations[i] : are_plain[i];  // angles have no range
      if (has_it) known.push_back({fmt::format("{}_{}", name, names[i]), Measure::Kind::size, derivative, {i}, true});
    }
  }
  return known;
}

/// What is asked for, with its limits; without any names all measures. Throws: Error (usage) for a limit of something
/// that the curve does not have.
std::vector<LimitResult> wanted_of(const LimitOptions& options, const CurveSpec& spec,
                                   const std::vector<std::string>& channels, const std::vector<std::string>& title) {
  const std::vector<Measure> known = known_measures(spec, channels);
  std::vector<std::string> names;
  std::unordered_map<std::string_view, const Measure*> by_name;  // of equal names the first one
  for (const Measure& one : known) {
    names.push_back(one.name);
    by_name.emplace(one.name, &one);
  }
  std::vector<Limit> limits = options.limits;
  if (limits.empty()) {
    for (const std::string& name : names) limits.push_back({name, {}, {}});
  }
  std::vector<LimitResult> wanted;
  for (const Limit& limit : limits) {
    const auto known_one = by_name.find(limit.name);
    if (known_one == by_name.end()) {
      const bool is_unproved = limit.name.starts_with("angular_speed") && !spec.rules.rotations.empty();
      const std::string reason =
          is_unproved ? "it has a proved maximum with --rotation-curve slerp or components; " : "";
      throw usage_error("nothing is measured as {}; {}expected one of {}{}", in_quotes(limit.name), reason,
                        listed(names), did_you_mean(limit.name, names))
          .about("--limits");
    }
    Measure measure = *known_one->second;
    if (limit.least && !measure.is_signed) {
      throw usage_error("{} is never below 0; expected {}=LIMIT; give its largest value", limit.name, limit.name)
          .about("--limits");
    }
    const bool is_position = measure.derivative == 0 && measure.is_signed;
    if (!limit.least && (limit.most || !is_position)) {
      wanted.push_back({title, std::move(measure), {}, limit.most});
      continue;
    }
    measure.kind = Measure::Kind::smallest;
    wanted.push_back({title, measure, {}, limit.least});
    measure.kind = Measure::Kind::largest;
    wanted.push_back({title, std::move(measure), {}, limit.most});
  }
  return wanted;
}

// Measuring.

/// Adds what is asked for of a curve to the report, and its corners.
void measure(const MeasuredCurve& curve, const std::vector<std::size_t>& compared,
             const std::vector<std::string>& title, std::vector<LimitResult> wanted, LimitsReport& report) {
  std::vector<Measure> measures;
  for (const LimitResult& one : wanted) measures.push_back(one.measure);
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
        return one.derivative > 1 && std::ranges::any_of(one.channels, [&](std::size_t channel) {
                 return std::ranges::binary_search(corner.channels, channel);
               });
      });
      result.passed = !result.is_broken && !extreme.is_unbounded && extreme.high <= one.as_measured(*result.limit);
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
  const Input input = open_input(job.keys_file, file->observe_bytes(job.keys.bytes_of(job.keys_file).bytes), options);
  notes.add_input(input, job.keys);
  report.channels = input.schema.channels;
  Curves curves(input.schema, input.keys, job.keys.curves);
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
    const std::vector<bool> are_in_rotations =
        spline::in_rotations(pipeline.spec().rules.rotations, report.channels.size());
    for (std::size_t i = 0; i < report.channels.size(); ++i) {
      if (!are_in_rotations[i]) compared.push_back(i);
    }
    std::vector<LimitResult> wanted = wanted_of(job.options, pipeline.spec(), report.channels, title);
    const bool turns = std::ranges::any_of(wanted, [](const LimitResult& one) { return one.measure.is_of_rotation; });
    const ExactSegments exact(pipeline.exact(streamed), turns);
    const auto key_time = [&](std::size_t number) {
      return number < streamed.keys.size() ? streamed.keys.key(number).times[0] : *streamed.extent.last;
    };
    const MeasuredCurve curve{exact.size(),
                              key_time,
                              [&](std::size_t first, std::size_t to) { return exact.bounded(first, to); },
                              [&](std::size_t number) { return exact(number); },
                              exact.is_rational(),
                              pipeline.request().from,
                              pipeline.request().to,
                              streamed.extent.closed,
                              drawing != nullptr};
    measure(curve, compared, title, std::move(wanted), report);
    const std::string name = title.empty() ? report.keys : fmt::format("{}", fmt::join(title, ", "));
    if (drawing != nullptr) drawing->add(streamed, input.schema, pipeline.spec(), name);
  }
  notes.end(curves, job.keys);
  const auto is_measured = [](const LimitResult& result) { return result.extreme.has_value(); };
  if (!report.results.empty() && std::ranges::none_of(report.results, is_measured)) {
    throw usage_error("no curve is in the range of times; give times on a curve")
        .about(job.part.from ? "--from" : "--to");
  }
  return report;
}

// The factor of the times by which all limits hold.

/// The smallest number of 14 digits whose power is at least x. Requires: x > 0.
Rational root_above(const Rational& x, int power) {
  Rational unit = 1, root = 0;
  while (power_of(unit, power) <= x) unit *= 10;
  while (power_of(unit / 10, power) > x) unit /= 10;
  for (int digit = 0; digit < 14; ++digit) {
    unit /= 10;
    while (power_of(root + unit, power) < x) root += unit;
  }
  return root + unit;
}

/// The smallest factor of 14 digits by which all limits hold, at least 1 unless it `fits`. Throws: Error for limits
/// that no factor meets.
Rational factor_within(const LimitsReport& report, bool fits) {
  if (report.passed() && !fits) return 1;
  struct Pace {
    Rational ratio;  ///< of the maximum to its limit
    int power;       ///< of the factor, by which the maximum becomes smaller
    std::string name;
  };
  std::vector<Pace> least, most;  // what the factor has to reach, and what it cannot exceed
  const auto refuse = [](const std::string& name, std::string_view reason) {
    return data_error("no factor of the times meets the limit of {}: {}; give another limit", name, reason)
        .about("--limits");
  };
  for (const LimitResult& result : report.results) {
    if (!result.limit || !result.extreme) continue;
    const Measure& measure = result.measure;
    if (result.is_broken) throw refuse(measure.name, "the velocity jumps");
    if (measure.derivative == 0 && !result.passed) throw refuse(measure.name, "it does not depend on time");
    if (measure.derivative == 0) continue;
    const Rational limit = measure.as_measured(*result.limit), &high = result.extreme->high;
    const int power = measure.derivative * (measure.is_size() ? 2 : 1);
    if (limit < 0) {  // slower is farther from it
      if (!result.passed) throw refuse(measure.name, "the curve is too slow");
      most.push_back({high / limit, power, measure.name});
    } else if (high > 0) {
      if (limit == 0) throw refuse(measure.name, "only rest would meet it");
      least.push_back({high / limit, power, measure.name});
    }
  }
  if (least.empty()) {
    throw data_error("no limit depends on the pace; expected one of a speed, acceleration or jerk; add one")
        .about("--limits");
  }
  Rational factor = fits ? 0 : 1;
  for (const Pace& pace : least) {
    const double ratio = nearest_double(pace.ratio);
    if (!std::isfinite(ratio) || ratio < 1e-300) throw refuse(pace.name, "it is too far from the maximum");
    factor = std::max(factor, root_above(pace.ratio, pace.power));
  }
  for (const Pace& pace : most) {
    if (power_of(factor, pace.power) > pace.ratio) throw refuse(pace.name, "slower times break it");
  }
  if (factor != 1 && report.has_ends_by_seconds) {
    throw usage_error(
        "the end rule lightwave depends on 1/3600 of a second, so that other times make another curve; name another "
        "end rule with --ends")
        .about("--retime");
  }
  return factor;
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
