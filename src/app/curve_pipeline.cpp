// The path of one curve, from its keys to its placed samples: which steps it needs, and in which order.
#include "app/curve_pipeline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "curve/closed.hpp"
#include "curve/sparse.hpp"
#include "error.hpp"
#include "exact/golden_rows.hpp"
#include "keys/parameterize.hpp"
#include "sampling/bounds.hpp"
#include "sampling/tolerance.hpp"
#include "text/number.hpp"

namespace tcb {
namespace {

/// The settings beside the keys; what is wrong with them is said of their place.
const CurveSettings& checked_settings(const CurveInfo& curve_info, const std::vector<std::string>& channels) {
  try {
    (void)fitted(make_curve(curve_info.settings), curve_info.settings, channels);
    return curve_info.settings;
  } catch (const Error& error) {
    std::string message = error.what();
    message.erase(0, message.find_first_not_of('-'));  // they are members here, not options
    for (const auto& [name, place] : curve_info.places) {
      if (message.starts_with(name)) throw Error(Exit::data, place, message);
    }
    throw Error(Exit::data, message);
  }
}

}  // namespace

CurvePipeline::CurvePipeline(const SamplingRequest& request, const CurveSettings& settings,
                             std::vector<std::size_t> fields, const std::optional<GoldenOptions>& golden,
                             const Input& input, const CurveInfo& curve_info)
    : request_(request),
      settings_(over(settings, checked_settings(curve_info, input.channels))),
      curve_(fitted(make_curve(settings_), settings_, input.channels)),
      fields_(std::move(fields)),
      golden_(golden),
      timed_(input.timed),
      threads_(input.threads),
      may_miss_(input.may_miss),
      channels_(input.channels) {
  if (timed_ && curve_.parameter) {
    throw Error(Exit::data, fmt::format("--parameter makes times, but column \"{}\" has them; expected one of the two; "
                                        "take --parameter out, or choose other columns with --columns",
                                        input.time));
  }
}

bool CurvePipeline::is_single() const {
  return (request_.count == 1 && (request_.mode == Mode::count || request_.mode == Mode::arc_count)) ||
         request_.places.size() == 1;
}

bool CurvePipeline::needs_lengths() const {
  return by_length(request_.mode) ||
         std::ranges::any_of(fields_, [](std::size_t field) { return fields()[field].needs_lengths; });
}

/// The keys with times, checked.
Source<KeyBlock> CurvePipeline::prepared(Source<KeyBlock> blocks) const {
  if (!timed_) blocks = parameterized(std::move(blocks), curve_.parameter.value_or(0), curve_.rules.metric);
  if (!curve_.ease) blocks = without_ease(std::move(blocks));
  return checked(std::move(blocks), is_single() ? 1 : 2);
}

Placed CurvePipeline::place(Source<KeyBlock> blocks) const {
  blocks = prepared(std::move(blocks));
  const auto exact = std::make_shared<ExactKeys>(golden_ && golden_->decimal);
  if (golden_) {
    blocks = mapped(std::move(blocks), [this, exact](KeyBlock block) {
      exact->add(block);
      if (const double exponent = made_by(); exponent != 0) exact->set_times(block, exponent, curve_.rules.metric);
      return block;
    });
  }
  const bool anywhere = curve_.extrapolation != Extrapolation::error || needs_curve(request_.mode);
  if (curve_.closed || anywhere || may_miss_ || golden_ || needs_end(request_))
    return place_kept(KeyStore(blocks), anywhere, *exact);
  Source<Keys> keys = mapped(std::move(blocks), [](KeyBlock block) { return std::move(block.keys); });
  std::optional<Keys> first = keys();
  while (first && first->size() == 0) first = keys();
  const Extent extent{first->times.front(), {}, {}};
  return place_streamed({preceded_by(std::move(*first), std::move(keys)), {}}, extent);
}

Source<SegmentBlock> CurvePipeline::segment_blocks(LinkedKeys keys, bool measured, bool sparse) const {
  return sparse ? sparse_stretches(keys, curve_.rules, measured, channels_)
                : tcb::segment_blocks(std::move(keys), curve_.rules, measured, threads_);
}

/// Rows as the curve goes by.
Placed CurvePipeline::place_streamed(LinkedKeys keys, const Extent& extent, std::optional<Lengths> lengths,
                                     bool sparse) const {
  const std::shared_ptr<Sampler> sampler = make_sampler(request_, extent);
  auto pieces = segment_blocks(std::move(keys), needs_lengths() && !lengths, sparse);
  if (lengths) pieces = with_lengths(std::move(pieces), std::move(*lengths));
  return {tcb::place(std::move(pieces), sampler, curve_.rules.metric), sampler, sampler, {}, fast_rows(sampler)};
}

/// From which time to which the keys are a curve.
Extent CurvePipeline::extent(KeyStore& kept) const {
  if (kept.are_sparse() && !kept.key(0).eases.empty()) {
    throw Error(Exit::data,
                "ease_in and ease_out warp all channels of a segment, and some are missing where --missing "
                "skip-cell left cells out; expected numbers in all; fill them in, or give --no-ease");
  }
  Extent extent{kept.key(0).times[0], {}, {}, curve_.closed};
  extent.last = curve_.closed ? close(kept, curve_, timed_) : kept.key(kept.size() - 1).times[0];
  return extent;
}

LinkedKeys CurvePipeline::linked(const KeyStore& kept, const Extent& extent) const {
  return curve_.closed ? going_round(kept, *extent.last) : LinkedKeys{kept.source(), {}};
}

IndexedCurve CurvePipeline::whole(Source<KeyBlock> blocks) const {
  KeyStore kept(prepared(std::move(blocks)));
  const bool sparse = kept.are_sparse();
  const Extent range = extent(kept);
  auto pieces = segment_blocks(linked(kept, range), needs_lengths(), sparse);
  return {std::make_shared<const CurveIndex>(std::move(pieces), curve_.rules.metric), range, curve_.extrapolation};
}

/// Rows once all keys are there: counts, closed curves, and rows in an order of their own.
Placed CurvePipeline::place_kept(KeyStore kept, bool anywhere, const ExactKeys& exact) const {
  const bool sparse = kept.are_sparse();
  Extent extent = this->extent(kept);
  if (golden_ && curve_.closed && made_by() != 0 && !curve_.period && kept.size() == exact.size()) {
    extent.last = exact.time_back(made_by(), curve_.rules.metric);
  }
  Facts facts{{"curve", fmt::format("from {} to {}", time_text(extent.first), time_text(*extent.last))}};
  Placed placed;
  if (anywhere) {
    placed = place_anywhere(linked(kept, extent), extent, sparse);
  } else {
    std::optional<Lengths> lengths;
    if (by_length(request_.mode)) {
      lengths = all_lengths(segment_blocks(linked(kept, extent), true, sparse));
      extent.length = total_length(*lengths);
      facts.emplace_back("length", fmt::format("{}", *extent.length));
    }
    if (request_.mode != Mode::per_segment) {
      const Time step = nearest_time(spacing(request_, extent).grid.step());
      facts.emplace_back("step", time_text(step));
    }
    placed = place_streamed(linked(kept, extent), extent, std::move(lengths), sparse);
  }
  placed.facts = std::move(facts);
  if (golden_) placed.evaluate = golden_rows(exact, kept.size(), extent, placed.locator);
  return placed;
}

/// The times of a grid that may leave the curve.
std::vector<Time> CurvePipeline::grid_times(const Extent& extent) const {
  const auto spacing = tcb::spacing(request_, extent);
  const bool single = spacing.grid.step() == 0;
  if (!single) require_resolution(spacing.grid, *spacing.end);
  const std::uint64_t rows = single ? spacing.rows : std::min(spacing.rows, spacing.grid.rows_through(*spacing.end));
  std::vector<Time> times;
  for (std::uint64_t row = 0; row < rows; ++row) times.push_back(spacing.grid.time(row));
  if (request_.end == EndPolicy::keep && (times.empty() || times.back() < *spacing.end)) {
    times.push_back(*spacing.end);
  }
  return times;
}

/// Rows at places in any order, also outside the curve.
Placed CurvePipeline::place_anywhere(LinkedKeys keys, const Extent& extent, bool sparse) const {
  const auto curve =
      std::make_shared<const CurveIndex>(segment_blocks(std::move(keys), needs_lengths(), sparse), curve_.rules.metric);
  std::vector<Time> places;
  if (request_.mode == Mode::tolerance) {
    const CurveSegments pieces{[curve](std::uint64_t number) { return curve->piece(number); }, curve->size()};
    places = times_within_tolerance(pieces, request_.tolerance, request_.max_rows);
  } else if (request_.places.empty()) {
    places = grid_times(extent);
  } else {
    std::ranges::transform(request_.places, std::back_inserter(places), nearest_time);
  }
  if (request_.keys) {
    const Time to = request_.to ? nearest_time(*request_.to) : *extent.last;
    places = with_keys(places, *curve, places.front(), to);
  }
  const std::uint64_t rows = places.size();
  const auto place = [places = std::move(places)](std::uint64_t row) { return places[row]; };
  if (request_.mode == Mode::arc_at) {
    const auto locator = std::make_shared<const AnywhereInLength>(place, rows, curve->length());
    return {look_up(curve, locator, request_.from_left), locator, nullptr, {}, fast_rows(locator)};
  }
  const auto locator =
      std::make_shared<const AnywhereInTime>(place, rows, curve_.extrapolation, extent.first, *extent.last);
  return {look_up(curve, locator, request_.from_left), locator, nullptr, {}, fast_rows(locator)};
}

/// The same rows, each number worked out exactly.
Evaluate CurvePipeline::golden_rows(const ExactKeys& exact, std::size_t keys, const Extent& extent,
                                    const std::shared_ptr<const Locator>& locator) const {
  std::optional<Rational> end;
  if (curve_.closed) end = exact_number(*extent.last, golden_->decimal);
  if (curve_.period && golden_->decimal) end = exact.first_time() + *curve_.period;
  ExactCurve curve = exact.curve(keys, curve_.rules, end);
  if (made_by() != 0) {
    curve.exponent = made_by();
    if (!curve_.period) curve.end.reset();
  }
  curve.closed = curve_.closed;
  curve.extrapolation = curve_.extrapolation;
  const auto rows = std::make_shared<GoldenRows>(std::move(curve), request_, extent, golden_->notation);
  return [rows, locator](const SampleBlock& batch, std::span<const std::size_t> chosen) {
    return rows->evaluate(batch, *locator, chosen);
  };
}

Facts CurvePipeline::rules() const {
  const auto end = [&](const spline::EndChoice<double>& choice) { return name_of(choice.rule); };
  Facts facts{{"tangents", std::string(name_of(curve_.rules.tangents))}};
  if (curve_.closed) {
    facts.emplace_back("closed", "yes");
  } else {
    facts.emplace_back("ends", fmt::format("{}, {}", end(curve_.rules.start), end(curve_.rules.end)));
  }
  if (curve_.rules.equal_speed) facts.emplace_back("equal speed", "yes");
  if (!timed_) {
    facts.emplace_back("times", fmt::format("none; made with --parameter {}", settings_.parameter.value_or("uniform")));
  }
  return facts;
}

}  // namespace tcb
