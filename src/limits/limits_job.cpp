// Limits job: certified maxima of the curves of a file, against limits, from the bytes of keys to the report.
#include "limits/limits_job.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>

#include "exact/ball_angle.hpp"
#include "exact/exact_curve.hpp"
#include "formats/formats.hpp"
#include "io/atomic_output.hpp"
#include "io/input_file.hpp"
#include "io/input_list.hpp"
#include "keys/curves.hpp"
#include "limits/report.hpp"
#include "picture/scene.hpp"
#include "read/input.hpp"
#include "read/input_options.hpp"
#include "run/batch.hpp"
#include "run/curve_pipeline.hpp"
#include "run/file_notes.hpp"
#include "run/progress.hpp"
#include "schema/texts.hpp"
#include "stream/ordered_map.hpp"
#include "text/suggest.hpp"
#include "text/utf8.hpp"

namespace tcb {
namespace limits {
namespace {

/// Measures of a channel, such as velocity_x, and those over the metric channels.
struct Quantity {
  std::string_view name;
  int derivative;
};
constexpr std::array of_channels{Quantity{"position", 0}, Quantity{"velocity", 1}, Quantity{"acceleration", 2},
                                 Quantity{"jerk", 3}};
constexpr std::array norms{Quantity{"speed", 1}, Quantity{"acceleration", 2}, Quantity{"jerk", 3}};

/// What can be measured of a curve.
struct MeasuredChannels {
  std::vector<std::string> names;
  std::vector<std::size_t> numbers;    ///< of those that are none of a rotation
  std::vector<std::size_t> positions;  ///< of those of them that are no angles, which have no range
  std::vector<std::size_t> metric;
  std::vector<spline::KeyRotation> rotations;
  spline::RotationCurve rotation_curve;
};

MeasuredChannels channels_of(const CurveSpec& spec, const std::vector<std::string>& names) {
  MeasuredChannels channels{names,
                            {},
                            {},
                            spline::metric_of(spec.rules, names.size()),
                            spec.rules.rotations,
                            spec.rules.rotation_rules.curve};
  if (spline::is_turn(channels.metric)) channels.metric.clear();
  if (channels.metric.empty() && spec.rules.rotations.empty() && spec.rules.angles.empty()) {
    for (std::size_t i = 0; i < names.size(); ++i) channels.metric.push_back(i);
  }
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (!spline::is_in_rotation(spec.rules.rotations, i)) channels.numbers.push_back(i);
    if (spline::is_plain(spec.rules, i)) channels.positions.push_back(i);
  }
  return channels;
}

/// All measures of a curve, as sizes.
std::vector<Measure> known_measures(const MeasuredChannels& channels) {
  std::vector<Measure> known;
  for (const Quantity& norm : norms) {
    if (!channels.metric.empty())
      known.push_back({std::string(norm.name), Measure::Kind::size, norm.derivative, channels.metric});
  }
  if (channels.metric.size() > 1) known.push_back({"curvature", Measure::Kind::curvature, 0, channels.metric});
  for (std::size_t i = 0; i < channels.rotations.size(); ++i) {
    Measure one{channels.rotations.size() == 1 ? "angular_speed" : fmt::format("angular_speed{}", i + 1),
                Measure::Kind::size,
                1,
                {channels.names.size() + i}};
    one.is_of_rotation = true;
    if (channels.rotation_curve == spline::RotationCurve::components) {
      one.kind = Measure::Kind::angular_speed;
      one.channels.assign(channels.rotations[i].channels.begin(), channels.rotations[i].channels.end());
    } else if (channels.rotation_curve != spline::RotationCurve::slerp) {
      continue;  // no bound is proved
    }
    known.push_back(std::move(one));
  }
  for (const Quantity& quantity : of_channels) {
    for (const std::size_t channel : quantity.derivative == 0 ? channels.positions : channels.numbers) {
      known.push_back({fmt::format("{}_{}", quantity.name, channels.names[channel]),
                       Measure::Kind::size,
                       quantity.derivative,
                       {channel},
                       true});
    }
  }
  return known;
}

/// A maximum that is asked for, with its limit.
struct Wanted {
  Measure measure;
  std::optional<Rational> limit = {};
};

/// Throws: Error (usage) for a limit of something that the curve does not have.
std::vector<Wanted> wanted_of(const LimitOptions& options, const MeasuredChannels& channels) {
  const std::vector<Measure> known = known_measures(channels);
  std::vector<Wanted> wanted;
  const auto add = [&](Measure measure, Measure::Kind kind, const std::optional<Rational>& limit) {
    measure.kind = kind;
    wanted.push_back({std::move(measure), limit});
  };
  const auto add_range = [&](const Measure& measure, const Limit& limit) {
    add(measure, Measure::Kind::smallest, limit.least);
    add(measure, Measure::Kind::largest, limit.most);
  };
  for (const Limit& limit : options.limits) {
    const auto measure = std::ranges::find(known, limit.name, &Measure::name);
    if (measure == known.end()) {
      std::vector<std::string> names;
      for (const Measure& one : known) names.push_back(one.name);
      const bool is_unproved = limit.name.starts_with("angular_speed") && !channels.rotations.empty();
      const std::string reason =
          is_unproved ? "it has a proved maximum with --rotation-curve slerp or components; " : "";
      throw usage_error("nothing is measured as {}; {}expected one of {}{}", in_quotes(limit.name), reason,
                        listed(names), did_you_mean(limit.name, names))
          .about("--limits");
    }
    if (limit.least && !measure->is_signed) {
      throw usage_error("{} is never below 0; expected {}=LIMIT; give its largest value", limit.name, limit.name)
          .about("--limits");
    }
    if (limit.least || (!limit.most && measure->derivative == 0 && measure->is_signed))
      add_range(*measure, limit);
    else
      add(*measure, measure->kind, limit.most);
  }
  if (!options.limits.empty()) return wanted;
  for (const Measure& measure : known) {
    const bool is_position = measure.derivative == 0 && measure.is_signed;
    if (is_position)
      add_range(measure, {});
    else
      add(measure, measure.kind, {});
  }
  return wanted;
}

/// A segment of floats of many digits as rationals.
spline::Segments<Rational> rational(const spline::Segments<RealBall>& from) {
  const auto exact = [](const RealBall& x) { return x.middle().rational(); };
  spline::Segments<Rational> to{from.channels, {exact(from.times[0]), exact(from.times[1])}, {}, {}};
  for (const auto& x : from.cubics) {
    const Rational out = exact(x.out), in = exact(x.in), c = exact(x.c) + exact(x.c_low);
    const Rational d = (in - out - 2 * c) / 3;  // so that a rest at the end is one
    to.cubics.push_back({exact(x.p0), out, c, 0, exact(x.p1), in, exact(x.e), exact(x.e_low), d});
  }
  for (const auto& warp : from.warps) {
    if (warp.is_cubic()) {
      to.warps.push_back(spline::Warp<Rational>::cubic(exact(warp.first_derivative(RealBall(0.0), {})),
                                                       exact(warp.first_derivative(RealBall(1.0), {}))));
    } else if (warp.has_ease()) {
      const Rational first = exact(warp.end_of_first_part()), last = exact(warp.start_of_last_part());
      const Rational k = Rational(1) + (first - last) / 2;
      to.warps.emplace_back(first / k, (Rational(1) - last) / k);
    } else {
      to.warps.emplace_back();
    }
  }
  return to;
}

/// Segments with a further channel for each rotation: the angle that it turns at a constant rate.
template <class S>
void add_angles(spline::Segments<S>& segments) {
  if (segments.size() == 0) return;
  const spline::Segments<S> before = segments;
  const std::size_t rotations = segments.rotations.size() / segments.size();
  segments.channels += rotations;
  segments.cubics.clear();
  for (std::size_t i = 0; i < before.size(); ++i) {
    segments.cubics.insert(segments.cubics.end(), before[i].begin(), before[i].end());
    for (const spline::RotationSegment<S>& rotation : before.rotations_of(i)) {
      using std::sqrt;
      const auto [x, y, z] = rotation.rate({S(0), S(-1)});
      const S zero(0), rate = sqrt(x * x + (y * y + z * z));
      segments.cubics.push_back({zero, rate, zero, zero, rate, rate, zero, zero, zero});
    }
  }
}

/// A segment of a curve by its number, as exact numbers; where these are irrational, of so many bits.
std::function<spline::Segments<Rational>(std::size_t)> exact_segments(ExactCurve exact, int bits,
                                                                      bool with_rotations = false) {
  if (exact.keys.size() == 1) {
    auto one = spline::constant_segment(exact.keys, exact.rules);
    one.channels += exact.rules.rotations.size();
    one.cubics.resize(one.channels);
    return [one](std::size_t) { return one; };
  }
  if (!with_rotations) exact.rules.rotations.clear();
  if (exact.is_rational() && !with_rotations) {
    return [curve = std::shared_ptr(curve_at<Rational>(exact))](std::size_t number) {
      return curve->segments(number, number + 1);
    };
  }
  const RealPrecision precision(bits, true);
  return [bits, curve = std::shared_ptr(curve_at<RealBall>(exact))](std::size_t number) {
    const RealPrecision used(bits, true);
    auto segment = curve->segments(number, number + 1);
    if (!segment.rotations.empty()) add_angles(segment);
    return rational(segment);
  };
}

/// The limit in the form of an Extreme.
Rational as_measured(const Measure& measure, const Rational& limit) {
  if (measure.is_size()) return limit * limit;
  return measure.kind == Measure::Kind::smallest ? -limit : limit;
}

/// Whether the velocity changes its direction, among some of the channels.
bool turns(const Corner& corner, const MeasuredChannels& channels, const std::vector<std::size_t>& measured) {
  std::vector<double> in, out;
  for (std::size_t i = 0; i < channels.numbers.size(); ++i) {
    if (std::ranges::count(measured, channels.numbers[i]) == 0) continue;
    in.push_back(corner.in[i]);
    out.push_back(corner.out[i]);
  }
  const auto norm = [](const std::vector<double>& v) {
    double size = 0;
    for (const double x : v) size = std::hypot(size, x);
    return size;
  };
  const double in_size = norm(in), out_size = norm(out);
  if (in_size == 0 || out_size == 0) return false;
  std::vector<double> change;
  for (std::size_t i = 0; i < in.size(); ++i) change.push_back(in[i] / in_size - out[i] / out_size);
  return norm(change) > 0x1p-40;
}

void measure(const MeasuredCurve& curve, const std::vector<std::string>& title, const MeasuredChannels& channels,
             const std::vector<Wanted>& wanted, LimitsReport& report) {
  std::vector<Measure> measures;
  for (const Wanted& one : wanted) measures.push_back(one.measure);
  Extremes found = extremes(curve, measures, channels.numbers);
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    const Measure& one = measures[i];
    LimitResult result{title, one, std::move(found.maxima[i]), wanted[i].limit};
    if (result.limit && result.extreme) {
      if (result.extreme->is_unproved) {
        throw data_error("numbers are too far apart to bound the {}; expected fewer such keys; remove this limit",
                         one.name);
      }
      const auto breaks = [&](const Corner& corner) {
        if (one.kind == Measure::Kind::curvature) return turns(corner, channels, one.channels);
        return one.derivative > 1 && std::ranges::any_of(corner.channels, [&](std::size_t channel) {
                 return std::ranges::count(one.channels, channel) > 0;
               });
      };
      const Extreme& extreme = *result.extreme;
      result.is_broken = std::ranges::any_of(found.corners, breaks);
      result.passed = !result.is_broken && !extreme.is_unbounded && extreme.high <= as_measured(one, *result.limit);
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
    if (scene_.channels.empty()) begin(schema, spec);
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
  void begin(const Schema& schema, const CurveSpec& spec) {
    scene_.time = schema.time.name;
    scene_.time_scale = time_scale_of(schema);
    scene_.channels = schema.channels;
    scene_.require_few_strips();
    scene_.is_path_requested = !options_.axes.empty();
    if (spec.lacks_metric && !scene_.is_path_requested) return;
    scene_.path = path_axes(schema.channels, options_.axes, spec.rules.metric);
  }

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
    const std::vector<std::string> title = group_title(input.schema.groups, keys->group);
    const MeasuredChannels channels = channels_of(pipeline.spec(), input.schema.channels);
    const std::vector<Wanted> wanted = wanted_of(job.options, channels);
    const bool turns = std::ranges::any_of(wanted, [](const Wanted& one) { return one.measure.is_of_rotation; });
    const auto with_angles = [](SegmentBlock block) {
      add_angles(block.segments);
      return block;
    };
    constexpr int bits = 400, bits_of_directions = 2400;
    const MeasuredCurve curve{[=] { return turns ? mapped(streamed.segments(), with_angles) : streamed.segments(); },
                              exact_segments(pipeline.exact(streamed), bits),
                              exact_segments(pipeline.exact(streamed), bits_of_directions),
                              turns ? exact_segments(pipeline.exact(streamed), bits, true) : nullptr,
                              pipeline.spec().frames,
                              pipeline.request().from,
                              pipeline.request().to,
                              streamed.extent.closed};
    measure(curve, title, channels, wanted, report);
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

Rational power_of(const Rational& x, int exponent) {
  Rational power = 1;
  for (int i = 0; i < exponent; ++i) power *= x;
  return power;
}

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

/// The smallest factor of 14 digits by which all limits hold, with a margin for the rounding of times.
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
    const Rational limit = as_measured(measure, *result.limit), &high = result.extreme->high;
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
    const Rational margin = power_of(Rational(1 + 0x1p-44), pace.power);
    factor = std::max(factor, root_above(pace.ratio * margin, pace.power));
  }
  for (const Pace& pace : most) {
    if (power_of(factor, pace.power) > pace.ratio) throw refuse(pace.name, "slower times break it");
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
