// The pipeline of one curve: the stages that its keys go through to become samples.
//
// Its constructor finds which curve the keys make (CurveSpec), and what the request needs of it (CurveNeeds): samples
// come segment after segment, or the curve is measured first, or all of it is kept for samples in any order.
#include "run/curve_pipeline.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <map>
#include <tuple>
#include <utility>

#include "error.hpp"
#include "exact/exact_rows.hpp"
#include "keys/prepare.hpp"
#include "run/gap_rows.hpp"
#include "sample/build.hpp"
#include "sample/grid.hpp"
#include "sample/places.hpp"
#include "sample/rows.hpp"
#include "sample/sampler.hpp"
#include "schema/usual_names.hpp"
#include "tcb/spline/curve.hpp"
#include "text/utf8.hpp"
#include "write/writer_options.hpp"

namespace tcb {
namespace {

/// The channels called x, y and z as the metric; nothing where there are no such, or all channels are.
std::optional<MetricSetting> metric_by_names(const Schema& schema) {
  std::vector<std::string> names;
  const std::vector<bool> are_plain = plain_channels(schema);
  for (const std::size_t channel : spatial_channels(schema.channels)) {
    if (!are_plain[channel]) return std::nullopt;
    names.push_back(schema.channels[channel]);
  }
  return names.empty() ? std::nullopt : std::optional(MetricSetting{names, SettingOrigin{"--metric"}});
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
  if (schema.time.counts_rows) all.parameter.reset();  // which is uniform
  if (!all.metric && request.mode != Mode::tolerance) all.metric = metric_by_names(schema);
  CurveSpec spec = make_spec(all, schema.channels, rotations, schema.angles);
  spec.timed = schema.time.is_given;
  return spec;
}

/// `fields`: those of the rows. `may_miss`: keys may lack positions. `exact`: numbers are computed exactly.
CurveNeeds curve_needs(const SamplingRequest& request, std::span<const std::size_t> fields, const CurveSpec& spec,
                       bool may_miss, bool exact) {
  const Mode mode = request.mode;
  const auto any_field = [&](const auto& holds) {
    return std::ranges::any_of(fields, [&](std::size_t field) { return holds(tcb::fields()[field]); });
  };
  const bool times_of_distances = !spec.timed && spec.exponent() != 0;
  const bool is_near_path = mode == Mode::tolerance && request.tolerance.limits_distance();
  const bool is_count = mode == Mode::count || mode == Mode::arc_count;
  CurveNeeds needs;
  needs.random_access = request.pace || mode == Mode::at || mode == Mode::arc_at || mode == Mode::tolerance ||
                        spec.extrapolations.extend_curve();
  needs.all_keys = spec.closed || needs.random_access || may_miss || exact || needs_end(request);
  needs.lengths = by_length(request) || any_field([](const Field& field) { return field.needs_lengths; });
  needs.whole_length = needs.all_keys && !needs.random_access && by_length(mode);
  needs.single_key = (is_count && request.count == 1) || request.places.size() == 1;
  needs.angle_signs = !spec.angles.empty();
  needs.metric = needs.lengths || times_of_distances || is_near_path ||
                 any_field([](const Field& field) { return field.over_metric; });
  return needs;
}

/// Whether the first channel may be the time that the request means: one called x only where the request has times.
bool needs_likely_time(const SamplingRequest& request, const Schema& schema) {
  const bool has_range = !by_length(request.mode) && (request.from || request.to);
  return has_range || request.mode == Mode::step || request.mode == Mode::at || !is_coordinate(schema.channels[0]);
}

/// About how many rows a curve will have, by the part of it that is known.
class RowEstimate {
 public:
  /// Requires: a request with rows segment after segment. `segments`: those of the whole curve, if it is known.
  RowEstimate(const SamplingRequest& request, const Extent& extent, std::uint64_t segments = 0)
      : request_(request), first_(extent.first), segments_(segments), length_(extent.length.value_or(0)) {
    if (!by_segment(request.mode)) spacing_ = spacing(request, extent);
    if (extent.last) end_ = made_ = *extent.last;
  }

  /// Adds keys that were read, and segments that were made.
  void add(const KeyBlock& block) {
    if (!block.keys.times.empty()) end_ = block.keys.times.back();
    segments_ += block.size();
  }
  void add(const SegmentBlock& block) {
    if (!block.segments.times.empty()) made_ = block.segments.times.back();
    for (const auto& length : block.lengths) length_ += length.value;
  }

  /// The step between rows; nothing where each segment has rows of its own.
  std::optional<Time> step() const {
    return spacing_ ? std::optional(nearest_time(spacing_->grid.step())) : std::nullopt;
  }

  double rows() const {
    const auto segments = static_cast<double>(segments_);
    const double keys = request_.keys ? segments + 1 : 0;
    if (!spacing_) return segments * static_cast<double>(request_.count) + keys + 1;
    Time end = end_;
    if (by_length(request_.mode)) end = Time(length_ * ((end_ - first_) / (made_ - first_)).hi);
    if (spacing_->end) end = std::min(end, nearest_time(*spacing_->end));
    const double rows = spacing_->grid.is_single() ? 1 : std::max(1.0, spacing_->grid.rough_rows(end));
    return std::min(rows, static_cast<double>(spacing_->rows)) + keys;
  }

 private:
  SamplingRequest request_;
  std::optional<Spacing> spacing_;  ///< nothing: each segment has its own rows
  Time first_, end_;                ///< of the keys
  Time made_;                       ///< end of the segments
  std::uint64_t segments_;
  double length_;  ///< of the segments
};

std::string kind_of_times(TimeNotation notation, const std::optional<TimeUnit>& unit) {
  if (is_date(notation)) return "dates";
  return unit == TimeUnit::frames ? "frames" : fmt::format("in {}", row_of(unit.value_or(TimeUnit::s)).name);
}

/// Throws: Error (data) for a profile whose times are not like those of the keys, which rows are printed like.
void require_like_times(const PaceProfile& profile, const TimeSchema& time) {
  const bool differ = profile.unit && time.unit && *profile.unit != *time.unit;
  if (!time.is_given || (!differ && is_date(profile.notation) == is_date(time.notation))) return;
  throw data_error("the times of the profile are {}, and those of the keys {}; expected the same; convert the profile",
                   kind_of_times(profile.notation, profile.unit), kind_of_times(time.notation, time.unit))
      .about("--pace");
}

/// Of a curve that is measured, and the rows on it.
PaceFacts pace_facts(const Pace& pace, const KeptCurve& curve, const RowPlaces& rows) {
  PaceFacts facts;
  if (pace.profile == nullptr) {
    facts.duration = (*curve.extent().last - curve.extent().first).hi;
    facts.mean_speed = facts.duration > 0 ? curve.length() / facts.duration : 0;
    facts.largest_speed = facts.mean_speed * nearest_double(pace.top_speed());
    return facts;
  }
  if (rows.motions.empty()) return facts;
  facts.duration = (rows.motions.back().time - rows.motions.front().time).hi;
  double way = 0;
  for (std::size_t row = 0; row < rows.places.size(); ++row) {
    if (row > 0) way += std::abs((rows.places[row] - rows.places[row - 1]).hi);
    facts.largest_speed = std::max(facts.largest_speed, std::abs(rows.motions[row].speed));
  }
  if (facts.duration > 0) facts.mean_speed = way / facts.duration;
  return facts;
}

Source<SampleBlock> with_gap_rows(Source<SampleBlock> blocks, const std::shared_ptr<GapRows>& gap_rows) {
  if (gap_rows == nullptr) return blocks;
  return observed(std::move(blocks), [gap_rows](const SampleBlock& block) { gap_rows->add_rows(block); });
}

}  // namespace

std::string in_words(const CurveNeeds& needs) {
  if (needs.whole_length) return "all keys and the length of the curve before the first row";
  std::string words = needs.all_keys || needs.angle_signs ? "all keys before the first row" : "a few keys at a time";
  if (needs.random_access) words += ", segments in any order";
  if (needs.lengths) words += ", the length of each segment";
  return words;
}

std::optional<CountedFrom> given_zero(const WriterOptions& rows) {
  if (!rows.time_zero || !rows.time_zero->time) return std::nullopt;
  return CountedFrom{*rows.time_zero->time};
}

void require_times(const CountedFrom& zero, const TimeSchema& time) {
  if (time.is_given || zero.time == 0) return;
  throw usage_error(
      "the times are made by the program; expected times of keys; name their column with --columns time=NAME")
      .about("--time-zero");
}

std::optional<FrameTimes> named_times(std::optional<TimeNotation> shown, const std::optional<Rational>& rate,
                                      const TimeSchema& time) {
  if (!time.is_given) return std::nullopt;
  const TimeNotation notation = shown.value_or(time.notation);
  if (is_date(notation) || notation == TimeNotation::clock) return FrameTimes::decimals();
  if (time.frame_rate) return FrameTimes(*time.frame_rate, time.start);
  const bool shows_frames = counts_frames(notation) && rate && time.unit != TimeUnit::frames;
  if (!shows_frames) return std::nullopt;
  return FrameTimes(*rate / (time.unit ? units_per_second(*time.unit) : Rational(1)));
}

CurvePipeline::CurvePipeline(const CurveRequest& request, const Schema& schema, const KeyTraits& traits,
                             const CurveInfo& curve_info, std::optional<CurvePart> part)
    : request_(request.samples),
      spec_(spec_of(request.rules, curve_info.settings, schema, request.samples)),
      golden_(request.golden),
      needs_(curve_needs(request_, request.fields, spec_, traits.may_miss, golden_.has_value())),
      threads_(request.threads),
      preparation_{.turns = {schema.rotations, schema.sources, spec_.rules.rotation_rules.curve,
                             spec_.preset == spline::Preset::nel, spec_.closed, spec_.angles, schema.channels},
                   .likely_time = needs_likely_time(request_, schema) ? schema.time.likely : "",
                   .counts_rows = schema.time.counts_rows,
                   .exponent = schema.time.is_given ? std::nullopt : std::optional(spec_.exponent()),
                   .metric = spec_.rules.metric,
                   .retiming = spec_.retiming,
                   .unlikely_scale = traits.has_tcb_scale ? std::nullopt : shown_tcb_scale(spec_.preset),
                   .ease = spec_.ease,
                   .monotone = spec_.rules.timing == spline::Timing::monotone,
                   .equal_speed = spec_.rules.equal_speed,
                   .only_breaks = schema.groups.empty()},
      part_(std::move(part)),
      may_be_point_(part_ || traits.may_be_point),
      may_miss_(traits.may_miss),
      leaves_gaps_(request.leaves_gaps),
      counts_gap_rows_(request.counts_gap_rows) {
  if (request_.pace && request_.pace->profile != nullptr) require_like_times(*request_.pace->profile, schema.time);
  const auto unit = schema.time.unit;
  const bool has_duration = request_.in_seconds.has_duration || spec_.is_period_in_seconds;
  if (has_duration && unit == TimeUnit::frames)
    throw usage_error(
        "the times in column {} are frames, which have no duration; expected their rate; give it with --input-fps, as "
        "in --input-fps 24, or give frames without a unit",
        in_quotes(schema.time.name));
  if (unit && unit != TimeUnit::frames) {
    request_.convert_seconds(units_per_second(*unit));
    if (spec_.is_period_in_seconds) *spec_.period *= units_per_second(*unit);
  }
  request_.frames = spec_.frames = named_times(request.time_notation, request.frame_rate, schema.time);
  const auto take_frame = [this](Rational& time) {  // whose printed time it is
    if (const auto frame = request_.frames->exact(nearest_time(time))) time = *frame;
  };
  if (request_.frames && !request_.frames->are_decimals() && !by_length(request_.mode)) {
    for (auto* const bound : {&request_.from, &request_.to}) {
      if (*bound) take_frame(**bound);
    }
    std::ranges::for_each(request_.places, take_frame);
  }
  if (request.zero) count_from(*request.zero, schema.time);
  if (spec_.retiming) {
    preparation_.frames = std::exchange(spec_.frames, std::nullopt);
    request_.frames.reset();
    if (!spec_.timed && ((spec_.closed && !spec_.period) || (golden_ && time_exponent() != 0))) {
      throw usage_error(
          "the times are made by the program; expected times of keys; name their column with --columns time=NAME")
          .about("--retime");
    }
    if (part_) {
      const auto later = [retiming = *spec_.retiming, frames = preparation_.frames](const std::optional<Time>& time) {
        return time ? std::optional(retimed(*time, retiming, frames)) : std::nullopt;
      };
      part_->origin = *later(part_->origin);
      part_->max_gap *= spec_.retiming->factor;
      part_->next = [later, next = part_->next] { return later(next()); };
    }
  }
  if (spec_.timed && spec_.parameter) {
    throw data_error(
        "column \"{}\" has times already; expected keys without times; remove --parameter, or choose the columns with "
        "--columns",
        schema.time.name)
        .about("--parameter");
  }
  require_fitting_rotations(spec_, request_, request.fields, needs_.metric);
  if (!request.fields.empty() && cells_in_row(request.fields, {schema.channels.size(), spec_.rotations}) == 0) {
    throw data_error(
        "rows would have no columns, as velocity, acceleration and jerk are of positions, and there are only "
        "rotations; expected a position; give angular_velocity, or --rotation none to take the numbers as positions")
        .about("--fields");
  }
  if (part_) request_.origin = request_.exact(part_->origin);
}

/// Times count from another one than 0, those of the request too. With a retiming so do the changed times.
void CurvePipeline::count_from(const CountedFrom& zero, const TimeSchema& time) {
  require_times(zero, time);
  if (!time.is_given) return;
  request_.zero = zero.time;
  if (spec_.retiming) {
    Rational& origin = spec_.retiming->origin;
    if (zero.is_of_key) request_.zero = origin + (zero.time - origin) * spec_.retiming->factor;
    origin -= request_.zero;
    preparation_.retiming = spec_.retiming;
  }
  given_frames_ = spec_.frames;
  if (spec_.frames) request_.frames = spec_.frames = given_frames_->less(request_.zero);
  if (!by_length(request_.mode)) {
    for (auto* const bound : {&request_.from, &request_.to}) {
      if (*bound) **bound -= request_.zero;
    }
    for (Rational& place : request_.places) place -= request_.zero;
  }
  if (zero.has_keys) return;
  zero_ = request_.zero;
  if (part_) part_ = counted_from(*part_, *zero_, given_frames_);
}

/// All keys of a part of a curve, with 0 in channels in which none of them has a position. These become `empty_`.
Source<KeyBlock> CurvePipeline::with_placeholders(const Source<KeyBlock>& blocks) {
  std::deque<KeyBlock> all;
  while (std::optional<KeyBlock> block = blocks()) all.push_back(std::move(*block));
  empty_.assign(all.empty() ? 0 : all.front().keys.channels, true);
  for (const KeyBlock& block : all) {
    for (std::size_t i = 0; i < block.keys.positions.size(); ++i) {
      if (!std::isnan(block.keys.positions[i])) empty_[i % empty_.size()] = false;
    }
  }
  for (KeyBlock& block : all) {
    for (std::size_t i = 0; i < block.keys.positions.size(); ++i) {
      if (empty_[i % empty_.size()]) block.keys.positions[i] = 0;
    }
  }
  return each_of(std::move(all));
}

/// The keys with times, checked. `least`: how many, unless a single key is enough. Sets the signs of angles.
Source<KeyBlock> CurvePipeline::prepared(Source<KeyBlock> blocks, std::size_t least) {
  if (zero_) blocks = less(std::move(blocks), *zero_, given_frames_);
  if (part_ && may_miss_) blocks = with_placeholders(std::move(blocks));
  SignedKeys keys = with_signs(std::move(blocks), spec_.angles);
  spec_.angles = preparation_.turns.angles = std::move(keys.angles);
  preparation_.least = needs_.single_key ? 1 : least;
  return tcb::prepared(std::move(keys.blocks), preparation_);
}

CurveSamples CurveSamples::none() {
  return {.blocks = []() -> std::optional<SampleBlock> { return std::nullopt; }};
}

/// A curve whose keys are all read. Frames are counted from its first key.
StreamedCurve CurvePipeline::read(Source<KeyBlock> blocks) {
  KeyStore keys(blocks);
  if (keys.are_sparse()) {
    if (const auto error = spline::find_position_error(keys.all()))
      throw curve_error(*error, keys, preparation_.turns.channels);
  }
  Extent extent{keys.key(0).times[0], {}, {}, spec_.closed, keys.decimals()};
  if (spec_.frames) spec_.frames = spec_.frames->from(extent.first);
  extent.last =
      spec_.closed ? take_closing(keys, spec_, preparation_.turns.channels) : keys.key(keys.size() - 1).times[0];
  const bool expanded = request_.mode == Mode::emit;  // where coefficients are printed, not positions
  std::vector<spline::ChannelGap> gaps = channel_gaps(keys);
  return {std::move(keys), extent, spec_.rules, {false, expanded, threads_, spec_.frames, std::move(gaps)}};
}

/// The gaps of channels that lack positions. Throws: Error (data) where a channel needs a number everywhere.
std::vector<spline::ChannelGap> CurvePipeline::channel_gaps(const KeyStore& store) const {
  const bool any_empty = std::ranges::count(empty_, true) > 0;
  if (!part_ || (!store.are_sparse() && !any_empty)) return {};
  const Keys keys = store.all();
  std::vector<spline::ChannelGap> gaps;
  for (std::size_t channel = 0; channel < keys.channels; ++channel) {
    if (any_empty && empty_[channel]) gaps.push_back({channel, 0, spline::ChannelGap::no_key});
    std::optional<std::size_t> before;
    for (std::size_t key = 0; key < keys.size(); ++key) {
      if (keys.is_missing(key, channel)) continue;
      if (before && is_gap(keys.times[*before], keys.times[key], part_->max_gap))
        gaps.push_back({channel, *before, key});
      before = key;
    }
  }
  const std::vector<bool> are_in_rotations = spline::in_rotations(spec_.rotations, keys.channels);
  const auto is_needed = [&](const spline::ChannelGap& gap) {
    return !leaves_gaps_ || needs_.metric || request_.mode == Mode::emit || request_.mode == Mode::tolerance ||
           are_in_rotations[gap.channel];
  };
  if (const auto gap = std::ranges::find_if(gaps, is_needed); gap != gaps.end()) {
    throw data_error(
        "channel {} has no number between {} and {}, which are further apart than --max-gap; expected numbers there, "
        "as only positions in rows of a table can be empty; fill them in, or give --missing skip-row, or a larger "
        "--max-gap",
        in_quotes(preparation_.turns.channels[gap->channel]), time_text(keys.times[gap->first]),
        time_text(keys.times[std::min(gap->last, keys.size() - 1)]));
  }
  return gaps;
}

StreamedCurve CurvePipeline::streamed(Source<KeyBlock> blocks) { return read(prepared(std::move(blocks), 1)); }

std::shared_ptr<const KeptCurve> CurvePipeline::kept(Source<KeyBlock> blocks) {
  const StreamedCurve curve = streamed(std::move(blocks));
  return std::make_shared<const KeptCurve>(curve.kept(spec_.channels(), spec_.extrapolations, needs_.lengths));
}

/// Where rows are at steps or given times, a key between two gaps is enough.
CurveSamples CurvePipeline::samples(Source<KeyBlock> blocks) {
  const bool may_be_point = may_be_point_ && (request_.mode == Mode::step || request_.mode == Mode::at);
  blocks = prepared(std::move(blocks), may_be_point ? 1 : 2);
  if (!needs_.all_keys) return samples_as_read(std::move(blocks));
  if (!golden_) return samples(read(std::move(blocks)));
  ExactKeys exact(golden_->decimal, converted_rotations(preparation_.turns), spec_.frames);
  StreamedCurve curve = read(observed(std::move(blocks), [this, &exact](KeyBlock& block) {
    exact.add(block);  // times made from distances are computed exactly and rounded
    if (time_exponent() != 0) exact.set_times(block, time_exponent(), spec_.rules.metric);
  }));
  if (spec_.closed && time_exponent() != 0 && !spec_.period && curve.keys.size() == exact.size()) {
    curve.extent.last = exact.time_back(time_exponent(), spec_.rules.metric);
  }
  return samples(curve, &exact);
}

CurveSamples CurvePipeline::samples(const StreamedCurve& curve, const ExactKeys* exact) {
  if (part_ && request_.mode == Mode::at && !take_places_of_part(curve.extent)) {
    return CurveSamples::none();
  }
  if (part_ && spec_.extrapolations.extend_curve()) {
    request_.reaches_before = part_->number == 0 && spec_.extrapolations.before != Extrapolation::error;
    request_.reaches_after = spec_.extrapolations.after != Extrapolation::error && !part_->next();
  }
  if (exact != nullptr && golden_->decimal && time_exponent() == 0) set_key_times(curve, *exact);
  CurveSamples samples = needs_.random_access ? samples_at_places(curve) : samples_on_grid(curve);
  if (exact != nullptr) samples.evaluate = exact_rows(*exact, curve, samples);
  if (curve.options.gaps.empty()) return samples;
  samples.evaluate = without_gaps(std::move(samples.evaluate), samples.locator, curve.options.gaps);
  samples.gaps = curve.options.gaps;
  return samples;
}

/// Leaves the places that are on the part of a curve, and those after it up to the next part; whether there are any.
/// Throws: Error (usage) for a time in the gap after it, where nothing extends the curve. Requires: its keys were read
/// to the end.
bool CurvePipeline::take_places_of_part(const Extent& extent) {
  const std::optional<Time> next = part_->next();
  const Rational first = request_.exact(extent.first), last = request_.exact(*extent.last);
  std::erase_if(request_.places, [&](const Rational& place) {
    const bool is_before = part_->number > 0 && place < first, is_after = next && place >= exact_time(*next);
    return is_before || is_after;
  });
  for (const Rational& place : request_.places) {
    if (!next || place <= last || spec_.extrapolations.after != Extrapolation::error) continue;
    throw usage_error("time {} is in the gap from {} to {}; give a time on the curve, or --extrapolate hold",
                      text(place + request_.zero), text(last + request_.zero), text(exact_time(*next) + request_.zero))
        .about("--at");
  }
  return !request_.places.empty();
}

/// What counts rows in gaps, or null where no gap is of interest.
std::shared_ptr<GapRows> CurvePipeline::new_gap_rows(std::shared_ptr<const Locator> locator, bool in_order) const {
  const bool counts =
      counts_gap_rows_ && !request_.pace && spec_.timed && !spec_.closed && !part_ && !by_segment(request_.mode);
  if (!counts) return nullptr;
  return std::make_shared<GapRows>(std::move(locator), in_order, spec_.retiming.value_or(Retiming{1, 0}),
                                   request_.zero);
}

/// Samples segment after segment, each as soon as its keys are read.
CurveSamples CurvePipeline::samples_as_read(Source<KeyBlock> blocks) {
  std::optional<KeyBlock> first = blocks();
  while (first->size() == 0) first = blocks();
  const Extent extent{first->keys.times.front(), {}, {}};
  if (spec_.frames) spec_.frames = spec_.frames->from(extent.first);
  const auto estimate = std::make_shared<RowEstimate>(request_, extent);
  Source<Keys> keys = mapped(preceded_by(std::move(*first), std::move(blocks)), [estimate](KeyBlock block) {
    estimate->add(block);
    return std::move(block.keys);
  });
  Source<SegmentBlock> segments =
      segment_blocks(std::move(keys), spec_.rules, {needs_.lengths, false, threads_, spec_.frames});
  segments = observed(std::move(segments), [estimate](const SegmentBlock& block) { estimate->add(block); });
  CurveSamples samples = samples_in_order(std::move(segments), make_sampler(request_, extent));
  samples.expected_rows = [estimate] { return estimate->rows(); };
  return samples;
}

/// Samples on a grid that depends on the whole curve. By arc length, the curve is measured first.
CurveSamples CurvePipeline::samples_on_grid(const StreamedCurve& curve) const {
  Extent extent = curve.extent;
  SampleFacts facts{extent.first, extent.last, {}, {}};
  Source<SegmentBlock> segments;
  if (needs_.whole_length) {
    auto measured = curve.measured();
    segments = std::move(measured.segments);
    facts.length = extent.length = measured.length;
    extent.last_moving = measured.last_moving;
  } else {
    segments = curve.segments(needs_.lengths);
  }
  const RowEstimate estimate(request_, extent, curve.keys.size() - (spec_.closed ? 0 : 1));
  facts.step = estimate.step();
  CurveSamples samples = samples_in_order(std::move(segments), make_sampler(request_, extent));
  samples.expected_rows = [rows = estimate.rows()] { return rows; };
  samples.facts = facts;
  return samples;
}

/// A sampler places samples segment after segment.
CurveSamples CurvePipeline::samples_in_order(Source<SegmentBlock> segments, std::shared_ptr<Sampler> sampler) const {
  const auto limited = std::make_shared<std::size_t>(0);
  if (spec_.rules.no_overshoot) {
    segments = observed(std::move(segments),
                        [limited](const SegmentBlock& block) { *limited += block.segments.limited_tangents; });
  }
  const std::shared_ptr<GapRows> gap_rows = new_gap_rows(sampler, true);
  if (gap_rows != nullptr) {
    segments = observed(std::move(segments), [gap_rows](const SegmentBlock& block) {
      gap_rows->add_steps(block.segments.times);
      if (block.last) gap_rows->end_steps();
    });
  }
  Source<SampleBlock> blocks = place(std::move(segments), sampler, spec_.channels(), request_.side());
  return {.blocks = with_gap_rows(std::move(blocks), gap_rows),
          .evaluate = fast_rows(sampler),
          .in_order = true,
          .limited_tangents = [limited] { return *limited; },
          .gap_rows = gap_rows,
          .locator = sampler,
          .remainder = [sampler] { return sampler->remainder(); }};
}

/// Samples in any order, also outside the curve.
CurveSamples CurvePipeline::samples_at_places(const StreamedCurve& curve) const {
  const Extent& extent = curve.extent;
  if (spec_.extrapolations.extend_curve() && may_leave_curve(request_) && !request_.origin) {
    const Rational& zero = request_.zero;
    const Rational first = exact_time(extent.first) + zero, last = exact_time(*extent.last) + zero;
    for (const auto& [option, time] : {std::pair("--from", request_.from), std::pair("--to", request_.to)}) {
      if (time) require_extended_to(option, *time + zero, spec_.extrapolations, first, last);
    }
  }
  const auto kept =
      std::make_shared<const KeptCurve>(curve.kept(spec_.channels(), spec_.extrapolations, needs_.lengths));
  RowPlaces places = row_places(request_, *kept, golden_ && golden_->decimal);
  SampleFacts facts{extent.first, extent.last, {}, {}};
  const std::size_t rows = places.places.size();
  facts.least_rows = places.least_rows;
  if (facts.least_rows) facts.rows = rows;
  if (request_.pace) {
    facts.length = kept->length();
    facts.pace = pace_facts(*request_.pace, *kept, places);
  }
  const std::optional<Rational> remainder = places.remainder;
  FoundRows found = find_rows(kept, std::move(places), request_.mode == Mode::arc_at || request_.pace, request_.side());
  const std::shared_ptr<GapRows> gap_rows = new_gap_rows(found.locator, false);
  if (gap_rows != nullptr) {
    gap_rows->add_steps(kept->curve().times());
    gap_rows->end_steps();
  }
  return {.blocks = with_gap_rows(std::move(found.blocks), gap_rows),
          .evaluate = fast_rows(found.locator),
          .facts = facts,
          .expected_rows = [rows] { return static_cast<double>(rows); },
          .limited_tangents = [kept] { return kept->curve().limited_tangents(); },
          .gap_rows = gap_rows,
          .locator = found.locator,
          .remainder = [remainder] { return remainder; }};
}

/// The exact time of the end of a closed curve.
Rational CurvePipeline::exact_end(const ExactKeys& exact, const StreamedCurve& curve) const {
  const std::size_t keys = curve.keys.size();
  if (keys < exact.size()) return exact.times()[keys];  // of the key that repeats the first one
  const bool decimal = golden_ && golden_->decimal;
  if (spec_.period && decimal) return exact.times()[0] + *spec_.period;
  return exact_number(*curve.extent.last, decimal, spec_.frames);
}

/// Requests take the times of keys with all their digits.
void CurvePipeline::set_key_times(const StreamedCurve& curve, const ExactKeys& exact) {
  std::map<Time, Rational> times;
  const Keys rounded = curve.keys.all();
  for (std::size_t key = 0; key < rounded.size(); ++key) times.emplace(rounded.times[key], exact.times()[key]);
  if (spec_.closed) times.emplace(*curve.extent.last, exact_end(exact, curve));
  request_.key_times = std::make_shared<const std::map<Time, Rational>>(std::move(times));
}

ExactCurve CurvePipeline::exact(const StreamedCurve& curve) const {
  KeyBlock block{.keys = curve.keys.all()};
  block.text_positions.lines.resize(curve.keys.size());
  ExactKeys exact(false, {}, spec_.frames);
  exact.add(block);
  return exact_curve(exact, curve);
}

ExactCurve CurvePipeline::exact_curve(const ExactKeys& exact, const StreamedCurve& curve) const {
  std::optional<Rational> end;
  if (spec_.closed) end = exact_end(exact, curve);
  ExactCurve result = exact.curve(curve.keys.size(), spec_.rules, end);
  result.channels = spec_.channels();
  if (time_exponent() != 0) {
    result.exponent = time_exponent();
    if (!spec_.period) result.end.reset();
  }
  result.closed = spec_.closed;
  result.extrapolations = spec_.extrapolations;
  result.gaps = curve.options.gaps;
  return result;
}

/// Evaluates rows exactly, and rounds each number once.
Evaluate CurvePipeline::exact_rows(const ExactKeys& exact, const StreamedCurve& curve,
                                   const CurveSamples& samples) const {
  Extent extent = curve.extent;
  extent.length = samples.facts.length;
  const auto rows = std::make_shared<ExactRows>(exact_curve(exact, curve), request_, extent, golden_->notation);
  return [rows, locator = samples.locator](const SampleBlock& block, std::span<const std::size_t> chosen) {
    return rows->evaluate(block, *locator, chosen);
  };
}

}  // namespace tcb
