// The pipeline of one curve: which stages its keys go through to become placed samples, and in which order.
#include "run/curve_pipeline.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <utility>

#include "error.hpp"
#include "exact/exact_rows.hpp"
#include "keys/prepare.hpp"
#include "option_names.hpp"
#include "sample/anywhere.hpp"
#include "sample/build.hpp"
#include "sample/tolerance.hpp"
#include "schema/doubts.hpp"
#include "text/utf8.hpp"

namespace tcb {
namespace {

/// The channels called x, y and z as the metric; nothing where there are no such, or all channels are.
std::optional<TextSetting> metric_by_names(const Schema& schema) {
  std::string names;
  for (const std::size_t channel : spatial_channels(schema.channels)) {
    const bool is_of_rotation = std::ranges::any_of(
        schema.rotations, [&](const RotationSchema& rotation) { return rotation.columns.has(channel); });
    const bool is_angle = std::ranges::count(schema.angles, channel, &AngleColumn::channel) > 0;
    const std::string& name = schema.channels[channel];
    if (is_of_rotation || is_angle || name.find(',') != std::string::npos) return std::nullopt;
    names += (names.empty() ? "" : ",") + name;
  }
  return names.empty() ? std::nullopt : std::optional(TextSetting{names, {option::metric}});
}

/// Also checks the settings of the input, even those that the command line replaces. The extrapolation of an input
/// matters only for samples that may be outside the keys. Its metric is that of lengths and speeds, while a tolerance
/// limits all channels.
CurveSpec spec_of(const CurveSettings& settings, CurveSettings of_input, const Schema& schema,
                  const SamplingRequest& request) {
  const std::vector<RotationColumns> rotations = rotation_columns(schema);
  (void)make_spec(of_input, schema.channels, rotations, schema.angles);
  if (!may_leave_curve(request)) of_input.extrapolate.reset();
  if (request.mode == Mode::tolerance) of_input.metric.reset();
  CurveSettings all = merged(settings, of_input);
  if (!all.metric && request.mode != Mode::tolerance) all.metric = metric_by_names(schema);
  return make_spec(all, schema.channels, rotations, schema.angles);
}

PlacedCurve no_samples(const Time& first_key) {
  PlacedCurve none;
  none.first_key = first_key;
  none.blocks = []() -> std::optional<SampleBlock> { return std::nullopt; };
  none.expected_rows = [] { return 0.0; };
  none.limited_tangents = [] { return std::size_t{0}; };
  return none;
}

/// The times that the texts of rows name: where these are times in words, frames, or counted from another time than 0;
/// nothing: they are numbers.
std::optional<FrameTimes> named_times(const CurveRequest& request, const TimeSchema& time) {
  if (!time.is_given) return std::nullopt;
  const TimeNotation notation = request.time_notation.value_or(time.notation);
  if (is_date(notation) || notation == TimeNotation::clock || request.counts_from_zero) return FrameTimes::decimals();
  if (time.frame_rate) return FrameTimes(*time.frame_rate);
  const bool shows_frames = counts_frames(notation) && request.frame_rate && time.unit != TimeUnit::frames;
  if (!shows_frames) return std::nullopt;
  return FrameTimes(*request.frame_rate / (time.unit ? units_per_second(*time.unit) : Rational(1)));
}

}  // namespace

CurvePipeline::CurvePipeline(const CurveRequest& request, const Schema& schema, const KeyTraits& traits,
                             const CurveInfo& curve_info)
    : request_(request.samples),
      spec_(spec_of(request.rules, curve_info.settings, schema, request.samples)),
      golden_(request.golden),
      timed_(schema.time.is_given),
      may_be_timed_(schema.time.may_be_first_channel),
      has_tcb_scale_(traits.has_tcb_scale),
      needs_(curve_needs(request_, request.fields, spec_, {timed_, traits.may_miss}, golden_.has_value())),
      threads_(request.threads),
      channels_(schema.channels),
      rotations_{schema.rotations, schema.sources, spec_.rules.rotation_rules.curve,
                 spec_.preset == spline::Preset::nel, spec_.closed} {
  const auto unit = schema.time.unit;
  const bool has_duration = request_.in_seconds.has_duration || spec_.is_period_in_seconds;
  if (has_duration && unit == TimeUnit::frames)
    throw usage_error(
        "the times in column {} are frames, which have no duration; expected their rate; give it with {}, as in {} 24, "
        "or give frames without a unit",
        in_quotes(schema.time.name), option::input_fps, option::input_fps);
  if (unit && unit != TimeUnit::frames) {
    request_.convert_seconds(units_per_second(*unit));
    if (spec_.is_period_in_seconds) *spec_.period *= units_per_second(*unit);
  }
  if (!unit) request_.likely_unit = schema.time.epoch_unit;
  request_.frames = spec_.frames = named_times(request, schema.time);
  const auto take_frame = [this](Rational& time) {  // whose printed time it is
    if (const auto frame = request_.frames->exact(nearest_time(time))) time = *frame;
  };
  if (request_.frames && !request_.frames->are_decimals() && !by_length(request_.mode)) {
    for (auto* const bound : {&request_.from, &request_.to}) {
      if (*bound) take_frame(**bound);
    }
    std::ranges::for_each(request_.places, take_frame);
  }
  if (timed_ && spec_.parameter) {
    throw data_error(
        "column \"{}\" has times already; expected keys without times; remove {}, or choose the columns with {}",
        schema.time.name, option::parameter, option::columns)
        .about(option::parameter);
  }
  require_rotations(spec_, request.fields, request_);
  require_fitting_rotations(spec_, needs_.metric, request_.mode == Mode::emit);
}

/// The keys with times, checked. `least`: how many, unless a single key is enough. Sets the signs of angles.
Source<KeyBlock> CurvePipeline::prepared(Source<KeyBlock> blocks, std::size_t least) {
  blocks = with_quaternions(with_signs(std::move(blocks), spec_.angles), rotations_);
  blocks = with_clear_angles(std::move(blocks), spec_.angles, channels_, spec_.closed);
  if (may_be_timed_) blocks = with_clear_times(std::move(blocks), channels_[0]);
  if (!timed_) blocks = parameterized(std::move(blocks), spec_.parameter.value_or(0), spec_.rules.metric);
  const auto shown_scale = has_tcb_scale_ ? std::nullopt : shown_tcb_scale(spec_.preset);
  if (shown_scale) blocks = within_tcb_scale(std::move(blocks), *shown_scale);
  if (!spec_.ease) blocks = without_ease(std::move(blocks));
  if (spec_.rules.timing == spline::Timing::monotone) blocks = with_rules_alone(std::move(blocks));
  blocks = with_complete_velocities(std::move(blocks), channels_, spec_.rules.equal_speed);
  return checked(std::move(blocks), needs_.single_key ? 1 : least);
}

/// The same keys, also added to `exact`. Times made from distances are then computed exactly and rounded.
Source<KeyBlock> CurvePipeline::recorded(Source<KeyBlock> blocks, const std::shared_ptr<ExactKeys>& exact) const {
  return mapped(std::move(blocks), [this, exact](KeyBlock block) {
    exact->add(block);
    if (time_exponent() != 0) exact->set_times(block, time_exponent(), spec_.rules.metric);
    return block;
  });
}

/// Takes the origin of a part's grid. Returns how many keys it needs: where rows are at steps or given times, a key
/// between two gaps is enough.
std::size_t CurvePipeline::set_part(const std::optional<CurvePart>& part) {
  if (!part) return 2;
  request_.origin = request_.exact(part->origin);
  return request_.mode == Mode::step || request_.mode == Mode::at ? 1 : 2;
}

/// Leaves the places that are on a part of a curve, and those after it up to the next part. Throws: Error (usage) for a
/// time in the gap after it, where nothing extends the curve. Requires: its keys were read to the end.
bool CurvePipeline::takes_places_of(const CurvePart& part, const Extent& extent) {
  const std::optional<Time> next = part.next();
  const Rational first = request_.exact(extent.first), last = request_.exact(*extent.last);
  std::erase_if(request_.places, [&](const Rational& place) {
    const bool is_before = part.number > 0 && place < first, is_after = next && place >= exact_time(*next);
    return is_before || is_after;
  });
  for (const Rational& place : request_.places) {
    if (!next || place <= last || spec_.extrapolations.after != Extrapolation::error) continue;
    throw usage_error("time {} is in the gap from {} to {}; give a time on the curve, or {}", text(place), text(last),
                      time_text(*next), option::extrapolate)
        .about(option::at);
  }
  return !request_.places.empty();
}

PlacedCurve CurvePipeline::place(Source<KeyBlock> blocks, const std::optional<CurvePart>& part) {
  blocks = prepared(std::move(blocks), set_part(part));
  if (!needs_.all_keys) return place_as_read(std::move(blocks));
  const auto exact =
      std::make_shared<ExactKeys>(golden_ && golden_->decimal, converted_rotations(rotations_), spec_.frames);
  if (golden_) blocks = recorded(std::move(blocks), exact);
  KeyStore keys(blocks);
  const Extent range = extent(keys);
  if (part && request_.mode == Mode::at && !takes_places_of(*part, range)) return no_samples(range.first);
  if (has_exact_times()) set_key_times(keys, range, *exact);
  return place_stored(keys, range, *exact);
}

/// Frames are counted from the curve's first key.
void CurvePipeline::set_origin(const Time& first) {
  if (spec_.frames) spec_.frames = spec_.frames->from(first);
}

/// Rows segment after segment, each as soon as its keys are read.
PlacedCurve CurvePipeline::place_as_read(Source<KeyBlock> blocks) {
  std::optional<KeyBlock> first = blocks();
  while (first->size() == 0) first = blocks();
  const Extent extent{first->keys.times.front(), {}, {}};
  set_origin(extent.first);
  const auto estimate = std::make_shared<RowEstimate>(request_, extent);
  Source<Keys> keys = mapped(preceded_by(std::move(*first), std::move(blocks)), [estimate](KeyBlock block) {
    estimate->add(block);
    return std::move(block.keys);
  });
  auto segments = segment_blocks(std::move(keys), spec_.rules,
                                 {.measured = needs_.lengths, .threads = threads_, .frames = spec_.frames});
  segments = mapped(std::move(segments), [estimate](SegmentBlock block) {
    estimate->add(block);
    return block;
  });
  return place_in_order(std::move(segments), extent, estimate);
}

/// The exact time of the end of a curve with so many keys. `end`: as it is rounded.
Rational CurvePipeline::exact_end(const ExactKeys& exact, std::size_t keys, const Time& end) const {
  if (keys < exact.size()) return exact.times()[keys];  // of the key that repeats the first one
  if (spec_.period && golden_->decimal) return exact.times()[0] + *spec_.period;
  return exact_number(end, golden_->decimal, spec_.frames);
}

/// Requests take the times of keys with all their digits.
void CurvePipeline::set_key_times(const KeyStore& keys, const Extent& extent, const ExactKeys& exact) {
  std::map<Time, Rational> times;
  const Keys rounded = keys.all();
  for (std::size_t key = 0; key < rounded.size(); ++key) times.emplace(rounded.times[key], exact.times()[key]);
  if (spec_.closed) times.emplace(*extent.last, exact_end(exact, keys.size(), *extent.last));
  request_.key_times = std::make_shared<const std::map<Time, Rational>>(std::move(times));
}

/// The segments of a curve whose keys are all known.
Source<SegmentBlock> CurvePipeline::segments(const KeyStore& keys, const Extent& extent, bool measured) const {
  const bool expanded = request_.mode == Mode::emit;  // where coefficients are printed, not positions
  return segment_blocks(keys, spec_.closed ? extent.last : std::nullopt, spec_.rules,
                        {measured, expanded, threads_, spec_.frames});
}

/// Rows segment after segment.
PlacedCurve CurvePipeline::place_in_order(Source<SegmentBlock> segments, const Extent& extent,
                                          std::shared_ptr<const RowEstimate> estimate) const {
  const std::shared_ptr<Sampler> sampler = make_sampler(request_, extent);
  const auto limited = std::make_shared<std::size_t>(0);
  if (spec_.rules.no_overshoot) {
    segments = mapped(std::move(segments), [limited](SegmentBlock block) {
      *limited += block.segments.limited_tangents;
      return block;
    });
  }
  Source<SampleBlock> blocks = tcb::place(std::move(segments), sampler, spec_.channels(), request_.side());
  const auto expected = [estimate = std::move(estimate)] { return estimate->rows(); };
  return {std::move(blocks), sampler, sampler, {}, fast_rows(sampler), expected, {}, extent.first, [limited] {
            return *limited;
          }};
}

/// The first and the last time of the curve.
Extent CurvePipeline::extent(KeyStore& keys) {
  if (keys.are_sparse()) {
    if (const auto error = spline::find_position_error(keys.all())) throw curve_error(*error, keys, channels_);
  }
  Extent extent{keys.key(0).times[0], {}, {}, spec_.closed, keys.decimals()};
  set_origin(extent.first);
  extent.last = spec_.closed ? take_closing(keys, spec_, timed_, channels_) : keys.key(keys.size() - 1).times[0];
  return extent;
}

/// The curve, kept.
std::shared_ptr<const ShownCurve> CurvePipeline::shown(const KeyStore& keys, const Extent& extent) const {
  const std::size_t count = spec_.closed ? keys.size() : std::max<std::size_t>(keys.size() - 1, 1);
  return std::make_shared<const ShownCurve>(
      kept_curve(segments(keys, extent, needs_.lengths), spec_.rules, spec_.closed, count), spec_.channels());
}

WholeCurve CurvePipeline::whole(Source<KeyBlock> blocks) {
  KeyStore keys(prepared(std::move(blocks), 1));
  const Extent range = extent(keys);
  return {shown(keys, range), range, spec_.extrapolations};
}

StoredCurve CurvePipeline::stored(Source<KeyBlock> blocks, bool sampled, const std::optional<CurvePart>& part) {
  (void)set_part(part);
  KeyStore keys(prepared(std::move(blocks), 1));
  const Extent range = extent(keys);
  if (part && sampled && request_.mode == Mode::at) sampled = takes_places_of(*part, range);
  const auto again = [pipeline = *this, keys, range] { return pipeline.segments(keys, range, false); };
  StoredCurve curve{keys, again, spec_.closed, {}};
  if (sampled && (keys.size() > 1 || needs_.single_key)) curve.placed = place_stored(keys, range, ExactKeys(false));
  return curve;
}

/// Rows once all keys are known: counts, closed curves, and rows in any order.
PlacedCurve CurvePipeline::place_stored(const KeyStore& keys, Extent extent, const ExactKeys& exact) const {
  if (golden_ && spec_.closed && time_exponent() != 0 && !spec_.period && keys.size() == exact.size()) {
    extent.last = exact.time_back(time_exponent(), spec_.rules.metric);
  }
  PlacedCurve placed;
  std::vector<Rational> times;
  if (needs_.random_access) {
    if (golden_ && golden_->decimal) times = exact_places(extent);
    placed = place_anywhere(keys, extent, times);
  } else {
    placed = place_on_grid(keys, extent);
  }
  if (!golden_) return placed;
  placed.golden = exact_rows(exact, keys.size(), extent, std::move(times));
  placed.evaluate = [rows = placed.golden, locator = placed.locator](const auto& block, const auto& chosen) {
    return rows->evaluate(block, *locator, chosen);
  };
  return placed;
}

/// Rows on a grid that depends on the whole curve. By arc length, the curve is measured first.
PlacedCurve CurvePipeline::place_on_grid(const KeyStore& keys, Extent& extent) const {
  PlacementFacts facts{extent.first, extent.last, {}, {}};
  std::optional<Lengths> lengths;
  if (needs_.whole_length) {
    lengths = all_lengths(segments(keys, extent, true));
    facts.length = extent.length = total_length(*lengths);
  }
  if (!by_segment(request_.mode)) facts.step = nearest_time(spacing(request_, extent).grid.step());
  auto all = segments(keys, extent, needs_.lengths && !lengths);
  if (lengths) all = with_lengths(std::move(all), std::move(*lengths));
  const auto estimate = std::make_shared<RowEstimate>(request_, extent);
  estimate->add_all(extent, keys.size() - (spec_.closed ? 0 : 1));
  PlacedCurve placed = place_in_order(std::move(all), extent, estimate);
  placed.facts = facts;
  return placed;
}

/// The times of a grid that may leave the curve.
std::vector<Time> CurvePipeline::grid_times(const Extent& extent) const {
  const auto spacing = tcb::spacing(request_, extent);
  if (spacing.rows == 0) return {};
  const bool single = spacing.grid.step() == 0;
  const int digits = extent.decimals;
  const Time end = nearest_time(*spacing.end, digits);
  if (!single) require_resolution(spacing.grid, end, digits);
  const std::uint64_t rows = single ? spacing.rows : std::min(spacing.rows, spacing.grid.rows_through(end, digits));
  std::vector<Time> times;
  for (std::uint64_t row = 0; row < rows; ++row) times.push_back(spacing.grid.time(row, digits));
  if (request_.end == EndPolicy::keep && (times.empty() || times.back() < end)) times.push_back(end);
  return times;
}

/// The times or arc lengths of rows that need random access to the curve. Sets facts about them.
std::vector<Time> CurvePipeline::places(const ShownCurve& curve, const Extent& extent, PlacementFacts& facts) const {
  std::vector<Time> places;
  if (request_.mode == Mode::tolerance) {
    ToleranceRows rows = rows_within_tolerance(curve, request_.tolerance, request_.max_rows, request_.keys);
    places = std::move(rows.times);
    if (request_.tolerance.limits_distance()) facts.least_rows = rows.least;
  } else if (request_.places.empty()) {
    places = grid_times(extent);
  } else {
    const int digits = request_.mode == Mode::at ? extent.decimals : only_doubles;
    std::ranges::transform(request_.places, std::back_inserter(places),
                           [&](const Rational& place) { return nearest_time(place, digits); });
  }
  if (!request_.keys) return places;
  const auto bound = [&](const std::optional<Rational>& given, const Time& end) {
    return given ? nearest_time(*given, extent.decimals) : end;
  };
  return with_keys(places, curve.curve().times(), bound(request_.from, extent.first), bound(request_.to, *extent.last),
                   Time(1e-9));
}

/// The exact times of rows in any order; nothing where only the rows decide them, or where they are lengths.
std::vector<Rational> CurvePipeline::exact_places(const Extent& extent) const {
  const bool merges_computed_keys = request_.keys && !request_.key_times;
  if (by_length(request_.mode) || request_.mode == Mode::tolerance || merges_computed_keys) return {};
  const Rational first = request_.exact(extent.first), last = request_.exact(*extent.last);
  std::vector<Rational> places = request_.places;
  if (request_.mode == Mode::at) {
    for (std::size_t i = 0; request_.key_times && i < places.size(); ++i) {
      require_extended_to(option::at, places[i], {End::first_key, first}, {End::last_key, last});
    }
    return places;
  }
  const Spacing spacing = tcb::spacing(request_, extent);
  const Rational &from = spacing.grid.start(), &step = spacing.grid.step(), &to = *spacing.end;
  if (spacing.rows == 0) return {};
  const bool is_counted = spacing.rows != Spacing::unlimited;
  const std::uint64_t rows = is_counted ? spacing.rows : whole_number(floor(steps_between(from, to, step))) + 1;
  for (std::uint64_t row = 0; row < rows; ++row) places.push_back(from + step * row);
  if (request_.end == EndPolicy::keep && places.back() < to) places.push_back(to);
  if (!request_.keys) return places;
  std::vector<Rational> keys;
  for (const auto& [rounded, exact] : *request_.key_times) keys.push_back(exact);
  return with_keys<Rational>(places, keys, request_.from.value_or(first), request_.to.value_or(last),
                             Rational(1, 1'000'000'000));
}

/// Throws: Error (usage) for a time outside the keys where nothing extends the curve.
void CurvePipeline::require_extended_to(std::string_view option, const Rational& time, const Bound& first,
                                        const Bound& last) const {
  if (spec_.extrapolations.before == Extrapolation::error) require_not_before(option, time, first);
  if (spec_.extrapolations.after == Extrapolation::error) require_not_after(option, time, last);
}

/// Rows at places in any order, also outside the curve. `exact`: their times, or nothing.
PlacedCurve CurvePipeline::place_anywhere(const KeyStore& keys, const Extent& extent,
                                          const std::vector<Rational>& exact) const {
  if (spec_.extrapolations.extend_curve() && may_leave_curve(request_) && !request_.origin) {
    const Bound first = first_key(extent.first), last = last_key(*extent.last);
    if (request_.from) require_extended_to(option::from, *request_.from, first, last);
    if (request_.to) require_extended_to(option::to, *request_.to, first, last);
  }
  const std::shared_ptr<const ShownCurve> curve = shown(keys, extent);
  std::vector<Time> places;
  std::ranges::transform(exact, std::back_inserter(places),
                         [&](const Rational& place) { return nearest_time(place, extent.decimals); });
  PlacementFacts facts{extent.first, extent.last, {}, {}};
  if (exact.empty()) places = this->places(*curve, extent, facts);
  const std::uint64_t rows = places.size();
  if (facts.least_rows) facts.rows = rows;
  const auto place = [places = std::move(places)](std::uint64_t row) { return places[row]; };
  const auto expected = [rows] { return static_cast<double>(rows); };
  const auto limited = [curve] { return curve->curve().limited_tangents(); };
  if (request_.mode == Mode::arc_at) {
    const auto locator = std::make_shared<const AnywhereInLength>(place, rows, curve->curve().length().value);
    return {look_up(curve, locator, request_.side()),
            locator,
            nullptr,
            facts,
            fast_rows(locator),
            expected,
            {},
            extent.first,
            limited};
  }
  const Time& end = *extent.last;
  const auto locator =
      std::make_shared<const AnywhereInTime>(place, rows, spec_.extrapolations, extent.first, end, spec_.frames);
  return {look_up(curve, locator, request_.side()),
          locator,
          nullptr,
          facts,
          fast_rows(locator),
          expected,
          {},
          extent.first,
          limited};
}

/// Evaluates rows exactly, and rounds each number once.
std::shared_ptr<ExactRows> CurvePipeline::exact_rows(const ExactKeys& exact, std::size_t keys, const Extent& extent,
                                                     std::vector<Rational> times) const {
  std::optional<Rational> end;
  if (spec_.closed) end = exact_end(exact, keys, *extent.last);
  ExactCurve curve = exact.curve(keys, spec_.rules, end);
  curve.channels = spec_.channels();
  if (time_exponent() != 0) {
    curve.exponent = time_exponent();
    if (!spec_.period) curve.end.reset();
  }
  curve.closed = spec_.closed;
  curve.extrapolations = spec_.extrapolations;
  return std::make_shared<ExactRows>(std::move(curve), request_, extent, golden_->notation, std::move(times));
}

}  // namespace tcb
