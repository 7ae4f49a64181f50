// The pipeline of one curve: which stages its keys go through to become placed samples, and in which order.
#include "run/curve_pipeline.hpp"

#include <algorithm>
#include <utility>

#include "error.hpp"
#include "exact/precision_levels.hpp"
#include "keys/parameterize.hpp"
#include "keys/velocities.hpp"
#include "option_names.hpp"
#include "run/errors.hpp"
#include "sample/build.hpp"
#include "sample/curve_errors.hpp"

namespace tcb {
namespace {

/// Settings of the input that those of the command line replace are checked as well.
CurveSpec spec_of(const CurveSettings& settings, const CurveSettings& of_input, const Schema& schema) {
  const std::vector<RotationColumns> rotations = rotation_columns(schema);
  (void)make_spec(of_input, schema.channels, rotations, schema.angles);
  return make_spec(merged(settings, of_input), schema.channels, rotations, schema.angles);
}

}  // namespace

CurvePipeline::CurvePipeline(const SamplingRequest& request, const CurveSettings& settings,
                             std::vector<std::size_t> fields, const std::optional<GoldenOptions>& golden,
                             const Schema& schema, const KeyTraits& traits, const CurveInfo& curve_info,
                             unsigned threads)
    : request_(request),
      spec_(spec_of(settings, curve_info.settings, schema)),
      fields_(std::move(fields)),
      golden_(golden),
      timed_(schema.time.is_given),
      may_be_timed_(schema.time.may_be_first_channel),
      has_tcb_scale_(traits.has_tcb_scale),
      threads_(threads),
      may_miss_(traits.may_miss),
      channels_(schema.channels),
      rotations_{schema.rotations, schema.sources, spec_.rules.rotation_rules.curve,
                 spec_.preset == spline::Preset::nel, spec_.closed} {
  request_.frame_rate = schema.time.frame_rate;
  for (auto* const bound : {&request_.from, &request_.to}) {
    // The printed time of a frame is the frame.
    const Time nearest = *bound ? nearest_time(**bound) : Time();
    if (*bound && request_.exact(nearest) != exact_time(nearest)) *bound = request_.exact(nearest);
  }
  const bool is_in_seconds = request_.is_rate && schema.time.unit && *schema.time.unit != TimeUnit::frames;
  if (is_in_seconds) request_.step *= units_per_second(*schema.time.unit);
  if (timed_ && spec_.parameter) {
    throw parameter_with_times(schema.time.name).about(option::parameter);
  }
  require_rotations(spec_, fields_, request_);
  require_fitting_rotations(spec_, metric_use(), request_.mode == Mode::emit);
}

bool CurvePipeline::is_single() const {
  const bool is_count = request_.mode == Mode::count || request_.mode == Mode::arc_count;
  return (is_count && request_.count == 1) || request_.places.size() == 1;
}

bool CurvePipeline::needs_random_access() const {
  return spec_.extrapolation != Extrapolation::error || needs_curve(request_.mode);
}

bool CurvePipeline::needs_lengths() const {
  return by_length(request_.mode) ||
         std::ranges::any_of(fields_, [](std::size_t field) { return fields()[field].needs_lengths; });
}

MetricUse CurvePipeline::metric_use() const {
  const auto is_of_path = [](std::size_t field) {
    return fields()[field].over_metric && !fields()[field].needs_lengths;
  };
  const bool has_path_field = std::ranges::any_of(fields_, is_of_path);
  const bool is_near_path = request_.mode == Mode::tolerance && request_.tolerance.limits_distance();
  if (has_path_field || time_exponent() != 0 || is_near_path) return MetricUse::path;
  return needs_lengths() ? MetricUse::lengths : MetricUse::nothing;
}

/// The keys with times, checked.
Source<KeyBlock> CurvePipeline::prepared(Source<KeyBlock> blocks, std::size_t least) const {
  blocks = with_quaternions(std::move(blocks), rotations_);
  blocks = with_clear_angles(std::move(blocks), spec_.angles, channels_, spec_.closed);
  if (may_be_timed_) blocks = with_clear_times(std::move(blocks), channels_[0]);
  if (!timed_) blocks = parameterized(std::move(blocks), spec_.parameter.value_or(0), spec_.rules.metric);
  const auto shown_scale = has_tcb_scale_ ? std::nullopt : shown_tcb_scale(spec_.preset);
  if (shown_scale) blocks = within_tcb_scale(std::move(blocks), *shown_scale);
  if (!spec_.ease) blocks = without_ease(std::move(blocks));
  blocks = with_complete_velocities(std::move(blocks), channels_, spec_.rules.equal_speed);
  return checked(std::move(blocks), is_single() ? 1 : least);
}

/// The same keys, also added to `exact`. Times made from distances are then computed exactly and rounded.
Source<KeyBlock> CurvePipeline::recorded(Source<KeyBlock> blocks, const std::shared_ptr<ExactKeys>& exact) const {
  return mapped(std::move(blocks), [this, exact](KeyBlock block) {
    exact->add(block);
    if (time_exponent() != 0) exact->set_times(block, time_exponent(), spec_.rules.metric);
    return block;
  });
}

/// The part of a curve whose keys were read.
struct CurvePipeline::KnownPart {
  Time first, end;    ///< of its keys
  Time made;          ///< end of its segments
  double length = 0;  ///< of these
  std::uint64_t segments = 0;
};

/// About the number of rows on a part of a curve.
double CurvePipeline::rows_on(const KnownPart& part, const SamplingRequest& request,
                              const std::optional<Spacing>& spacing) {
  const auto segments = static_cast<double>(part.segments);
  const double keys = request.keys ? segments + 1 : 0;
  if (!spacing) return segments * static_cast<double>(request.count) + keys + 1;
  Time end = part.end;
  if (by_length(request.mode)) end = Time(part.length * ((part.end - part.first) / (part.made - part.first)).hi);
  if (spacing->end) end = std::min(end, nearest_time(*spacing->end));
  const double rows = spacing->grid.is_single() ? 1 : std::max(1.0, spacing->grid.rough_rows(end));
  return std::min(rows, static_cast<double>(spacing->rows)) + keys;
}

PlacedCurve CurvePipeline::place(Source<KeyBlock> blocks) {
  blocks = prepared(with_signs(std::move(blocks), spec_.angles), 2);
  const auto exact = std::make_shared<ExactKeys>(golden_ && golden_->decimal, converted_rotations(rotations_));
  if (golden_) blocks = recorded(std::move(blocks), exact);
  if (spec_.closed || needs_random_access() || may_miss_ || golden_ || needs_end(request_)) {
    KeyStore keys(blocks);
    const Extent range = extent(keys);
    return place_stored(keys, range, *exact);
  }
  const auto known = std::make_shared<KnownPart>();
  Source<Keys> keys = mapped(std::move(blocks), [known](KeyBlock block) {
    if (!block.keys.times.empty()) known->end = block.keys.times.back();
    known->segments += block.size();
    return std::move(block.keys);
  });
  std::optional<Keys> first = keys();
  while (first && first->size() == 0) first = keys();
  const Extent extent{first->times.front(), {}, {}};
  known->first = extent.first;
  LinkedKeys linked{preceded_by(std::move(*first), std::move(keys))};
  auto segments = segment_blocks(std::move(linked), spec_.rules, needs_lengths(), threads_);
  return place_in_order(std::move(segments), extent, 0, known);
}

/// The segments of a curve whose keys are all known.
Source<SegmentBlock> CurvePipeline::segments(const KeyStore& keys, const Extent& extent, bool measured) const {
  const auto end = spec_.closed ? extent.last : std::nullopt;
  const bool expanded = request_.mode == Mode::emit;  // where coefficients are printed, not positions
  if (keys.are_sparse()) return sparse_segment_blocks(keys, end, spec_.rules, measured, expanded);
  return segment_blocks(linked(keys, end), spec_.rules, measured, threads_);
}

/// Rows segment after segment, each as soon as it is known. `known`: what is read of the curve; null: all of it.
PlacedCurve CurvePipeline::place_in_order(Source<SegmentBlock> segments, const Extent& extent, std::uint64_t count,
                                          std::shared_ptr<KnownPart> known) const {
  const std::shared_ptr<Sampler> sampler = make_sampler(request_, extent);
  if (known == nullptr) {
    known = std::make_shared<KnownPart>(
        KnownPart{extent.first, *extent.last, *extent.last, extent.length.value_or(0), count});
  } else {
    segments = mapped(std::move(segments), [known](SegmentBlock block) {
      if (!block.segments.times.empty()) known->made = block.segments.times.back();
      for (const auto& length : block.lengths) known->length += length.value;
      return block;
    });
  }
  std::optional<Spacing> spacing;
  if (!by_segment(request_.mode)) spacing = tcb::spacing(request_, extent);
  const auto expected = [known, spacing, request = &request_] { return rows_on(*known, *request, spacing); };
  Source<SampleBlock> blocks = tcb::place(std::move(segments), sampler, spec_.channels());
  return {std::move(blocks), sampler, sampler, {}, fast_rows(sampler), expected};
}

/// The first and the last time of the curve.
Extent CurvePipeline::extent(KeyStore& keys) const {
  if (keys.are_sparse()) {
    if (const auto error = spline::find_position_error(keys.all())) throw curve_error(*error, keys, channels_);
  }
  Extent extent{keys.key(0).times[0], {}, {}, spec_.closed, keys.decimals()};
  extent.last = spec_.closed ? take_closing(keys, spec_, timed_, channels_) : keys.key(keys.size() - 1).times[0];
  return extent;
}

IndexedCurve CurvePipeline::whole(Source<KeyBlock> blocks) {
  KeyStore keys(prepared(with_signs(std::move(blocks), spec_.angles), 1));
  const Extent range = extent(keys);
  return {std::make_shared<const CurveIndex>(segments(keys, range, needs_lengths()), spec_.channels()), range,
          spec_.extrapolation};
}

StoredCurve CurvePipeline::stored(Source<KeyBlock> blocks, bool sampled) {
  KeyStore keys(prepared(with_signs(std::move(blocks), spec_.angles), 1));
  const Extent range = extent(keys);
  const auto again = [pipeline = *this, keys, range] { return pipeline.segments(keys, range, false); };
  StoredCurve curve{keys, again, spec_.closed, {}};
  if (sampled && (keys.size() > 1 || is_single())) curve.placed = place_stored(keys, range, ExactKeys(false));
  return curve;
}

/// Rows once all keys are known: counts, closed curves, and rows in any order.
PlacedCurve CurvePipeline::place_stored(const KeyStore& keys, Extent extent, const ExactKeys& exact) const {
  if (golden_ && spec_.closed && time_exponent() != 0 && !spec_.period && keys.size() == exact.size()) {
    extent.last = exact.time_back(time_exponent(), spec_.rules.metric);
  }
  PlacedCurve placed;
  if (needs_random_access()) {
    placed = place_anywhere(segments(keys, extent, needs_lengths()), extent);
    placed.facts = {extent.first, extent.last, {}, {}};
  } else {
    placed = place_on_grid(keys, extent);
  }
  if (golden_) placed.evaluate = exact_rows(exact, keys.size(), extent, placed.locator);
  return placed;
}

/// Rows on a grid that depends on the whole curve. By arc length, the curve is measured first.
PlacedCurve CurvePipeline::place_on_grid(const KeyStore& keys, Extent& extent) const {
  PlacementFacts facts{extent.first, extent.last, {}, {}};
  std::optional<Lengths> lengths;
  if (by_length(request_.mode)) {
    lengths = all_lengths(segments(keys, extent, true));
    facts.length = extent.length = total_length(*lengths);
  }
  if (!by_segment(request_.mode)) facts.step = nearest_time(spacing(request_, extent).grid.step());
  auto all = segments(keys, extent, needs_lengths() && !lengths);
  if (lengths) all = with_lengths(std::move(all), std::move(*lengths));
  PlacedCurve placed = place_in_order(std::move(all), extent, keys.size() - (spec_.closed ? 0 : 1));
  placed.facts = facts;
  return placed;
}

/// The times of a grid that may leave the curve.
std::vector<Time> CurvePipeline::grid_times(const Extent& extent) const {
  const auto spacing = tcb::spacing(request_, extent);
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

/// The times or arc lengths of rows that need random access to the curve.
std::vector<Time> CurvePipeline::places(const CurveIndex& curve, const Extent& extent) const {
  std::vector<Time> places;
  if (request_.mode == Mode::tolerance) {
    const CurveSegments segments{[&curve](std::uint64_t number) { return curve.segment(number); }, curve.size()};
    places = times_within_tolerance(segments, request_.tolerance, request_.max_rows, request_.keys);
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
  return with_keys(places, curve, bound(request_.from, extent.first), bound(request_.to, *extent.last));
}

/// Rows at places in any order, also outside the curve.
PlacedCurve CurvePipeline::place_anywhere(const Source<SegmentBlock>& segments, const Extent& extent) const {
  const auto curve = std::make_shared<const CurveIndex>(segments, spec_.channels());
  std::vector<Time> places = this->places(*curve, extent);
  const std::uint64_t rows = places.size();
  const auto place = [places = std::move(places)](std::uint64_t row) { return places[row]; };
  const auto expected = [rows] { return static_cast<double>(rows); };
  if (request_.mode == Mode::arc_at) {
    const auto locator = std::make_shared<const AnywhereInLength>(place, rows, curve->length());
    return {look_up(curve, locator, request_.from_left), locator, nullptr, {}, fast_rows(locator), expected};
  }
  const Time& end = *extent.last;
  const auto locator = std::make_shared<const AnywhereInTime>(place, rows, spec_.extrapolation, extent.first, end);
  return {look_up(curve, locator, request_.from_left), locator, nullptr, {}, fast_rows(locator), expected};
}

/// The same rows, each number rounded once.
Evaluate CurvePipeline::exact_rows(const ExactKeys& exact, std::size_t keys, const Extent& extent,
                                   const std::shared_ptr<const Locator>& locator) const {
  std::optional<Rational> end;
  if (spec_.closed) end = exact_number(*extent.last, golden_->decimal);
  if (spec_.period && golden_->decimal) end = exact.first_time() + *spec_.period;
  ExactCurve curve = exact.curve(keys, spec_.rules, end);
  curve.channels = spec_.channels();
  if (time_exponent() != 0) {
    curve.exponent = time_exponent();
    if (!spec_.period) curve.end.reset();
  }
  curve.closed = spec_.closed;
  curve.extrapolation = spec_.extrapolation;
  const auto rows = std::make_shared<ExactRows>(std::move(curve), request_, extent, golden_->notation);
  return [rows, locator](const auto& block, const auto& chosen) { return rows->evaluate(block, *locator, chosen); };
}

}  // namespace tcb
