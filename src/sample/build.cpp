// From keys to segments with their lengths: open, closed and sparse curves.
#include "sample/build.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "error.hpp"
#include "keys/parameterize.hpp"
#include "numbers/decimal_time.hpp"
#include "numbers/print_number.hpp"
#include "sample/errors.hpp"
#include "option_names.hpp"
#include "sample/keyed_curve.hpp"
#include "sample/segment_length.hpp"
#include "stream/ordered_map.hpp"
#include "tcb/spline/tangents.hpp"

namespace tcb {
namespace {

using spline::DoubleDouble;

/// Sets the lengths of the segments.
void measure(SegmentBlock& block, const Rules& rules) {
  SegmentLength<double> arc;
  block.lengths.reserve(block.segments.size());
  for (std::size_t i = 0; i < block.segments.size(); ++i) {
    arc.assign(block.segments[i], block.segments.rotations_of(i), rules.metric);
    if (!std::isfinite(arc.total().value)) {
      throw tangents_beyond_doubles(time_text(block.segments.times[i]), time_text(block.segments.times[i + 1]));
    }
    block.lengths.push_back(arc.total());
  }
}

SegmentBlock block_of(const spline::Window<double>& window, const Rules& rules, bool measured) {
  SegmentBlock block{{}, {}, window.last, window.last && !window.ends};
  if (!window.has_segments() && !window.is_single_key()) return block;
  block.segments = spline::segments(window, rules);
  if (measured) measure(block, rules);
  return block;
}

/// The same keys in blocks of keys_at_once.
Source<Keys> in_small_blocks(Source<Keys> keys) {
  return [keys = std::move(keys), block = Keys(), next = std::size_t{0}]() mutable -> std::optional<Keys> {
    if (next == block.size()) {
      std::optional<Keys> more = keys();
      if (!more || more->size() <= keys_at_once) return more;
      block = std::move(*more);
      next = 0;
    }
    const std::size_t first = next;
    next = std::min(first + keys_at_once, block.size());
    Keys part;
    spline::append(part, block, first, next);
    return part;
  };
}

/// Windows of an open curve, as they become complete.
Source<spline::Window<double>> open_windows(Source<Keys> keys) {
  return [keys = std::move(keys), linker = spline::Linker<double>(),
          ended = false]() mutable -> std::optional<spline::Window<double>> {
    if (ended) return std::nullopt;
    std::optional<Keys> block = keys();
    ended = !block;
    return linker.link(block.value_or(Keys{}), ended);
  };
}

/// Windows of a closed curve, all of whose keys are known, so also the last block.
Source<spline::Window<double>> closed_windows(Source<Keys> keys, Keys context) {
  return [keys = std::move(keys), linker = spline::Linker<double>(std::move(context)), block = std::optional<Keys>(),
          started = false]() mutable -> std::optional<spline::Window<double>> {
    if (!std::exchange(started, true)) block = keys();
    if (!block) return std::nullopt;
    std::optional<Keys> next = keys();
    const Keys current = *std::exchange(block, std::move(next));
    return linker.link(current, !block);
  };
}

/// A key with the sign of each rotation, and of its velocities, that is nearer to another one's.
Keys with_signs_of(const Keys& other, Keys key, const std::vector<spline::RotationColumns>& rotations) {
  for (const spline::RotationColumns& rotation : rotations) {
    double dot = 0;
    for (const std::size_t i : rotation.channels) dot += other.positions[i] * key.positions[i];
    if (!(dot < 0)) continue;
    for (const std::size_t i : rotation.channels) {
      key.positions[i] = 0 - key.positions[i];  // 0 stays without a sign
      if (!key.velocities.empty()) key.velocities[i] = {-key.velocities[i].in, -key.velocities[i].out};
    }
  }
  return key;
}

bool same_position(const Keys& a, const Keys& b) { return std::ranges::equal(a.position(0), b.position(0)); }

/// The end of the period. Requires: a period.
Time end_by_period(const Keys& first, const Keys& last, const Rational& period, int decimals) {
  const Time end = nearest_time(exact_time(first.times[0]) + period, decimals);
  if (end > last.times[0]) return end;
  throw period_too_short(time_text(last.times[0]));
}

/// The time of a last key that repeats the first one. Throws: Error (data) if they differ in anything else.
Time end_by_last_key(const Keys& first, const Keys& last, const KeyStore& keys, const std::optional<Time>& end) {
  const TextPosition position{"", keys.last_line(), 0};
  if (last.tcbs != first.tcbs) {
    throw closing_key_differs(keys.first_line()).at(position);
  }
  for (std::size_t i = 0; i < last.velocities.size(); ++i) {
    const auto &a = first.velocities[i], &b = last.velocities[i];
    const auto differs = [](double x, double y) { return !std::isnan(x) && !std::isnan(y) && x != y; };
    if (!differs(a.in, b.in) && !differs(a.out, b.out)) continue;
    throw closing_velocity_differs(keys.first_line()).at(position);
  }
  if (end && *end != last.times[0]) {
    throw closing_key_against_period(keys.first_line()).at(position);
  }
  return last.times[0];
}

/// All keys of a store as one block, and which of their positions are missing.
std::pair<Keys, std::vector<bool>> with_missing(const KeyStore& store) {
  std::pair<Keys, std::vector<bool>> result{store.all(), {}};
  for (const double position : result.first.positions) result.second.push_back(std::isnan(position));
  return result;
}

void require_positions(const Keys& keys, const std::vector<bool>& missing, const std::vector<std::string>& channels) {
  for (std::size_t i = 0; i < keys.channels; ++i) {
    bool any = false;
    for (std::size_t key = 0; key < keys.size() && !any; ++key) any = !missing[key * keys.channels + i];
    if (!any) throw channel_without_numbers(channels[i]);
  }
}

}  // namespace

Time close(KeyStore& keys, const CurveSpec& spec, bool timed) {
  const Keys first = keys.key(0);
  Keys last = keys.key(keys.size() - 1);
  std::optional<Time> end;
  if (spec.period) end = end_by_period(first, first, *spec.period, keys.decimals());
  const Keys repeated = with_signs_of(first, last, spec.rules.rotations);
  if (keys.size() > 1 && same_position(first, repeated)) {
    end = end_by_last_key(first, repeated, keys, end);
    keys.drop_last();
    keys.set_first_incoming(repeated);
    if (keys.size() > 0) last = keys.key(keys.size() - 1);
  } else if (end) {
    end = end_by_period(first, last, *spec.period, keys.decimals());
  } else if (!timed) {
    const double step = parameter_step<double, double>(last.position(0), first.position(0), spec.parameter.value_or(0),
                                                       spec.rules.metric);
    end = Time((last.times[0] + Time(step)).hi);
  }
  if (keys.size() < 2) throw too_few_closed_keys();
  if (!end) throw no_period();
  return *end;
}

void require_seam_velocities(const KeyStore& keys, const std::vector<std::string>& channels) {
  const std::vector<bool> given = keys.key(0).given;
  const std::size_t size = keys.size();
  for (std::size_t i = 0; i < given.size(); ++i) {
    const auto is_missing = [&](std::size_t key) { return std::isnan(keys.key(key).positions[i]); };
    std::size_t first = 0, last = size - 1;
    while (first < last && is_missing(first)) ++first;
    while (last > first && is_missing(last)) --last;
    const bool has_both =
        !std::isnan(keys.key(first).velocities[i].in) && !std::isnan(keys.key(last).velocities[i].out);
    if (given[i] && !has_both) throw seam_velocity_missing(channels[i]);
  }
}

LinkedKeys periodic_extension(const KeyStore& keys, const Time& end) {
  const auto size = static_cast<std::ptrdiff_t>(keys.size());
  const Time period = end - keys.key(0).times[0];
  const auto extended = [&](std::ptrdiff_t number) {
    return extended_key<double>([&](std::size_t own) { return keys.key(own); }, size, period, number);
  };
  Keys next = extended(size);
  next.times[0] = end;
  spline::append(next, extended(size + 1), 0, 1);
  auto source = [kept = keys.source(), next = std::optional<Keys>(std::move(next))]() mutable {
    std::optional<Keys> block = kept();
    return block ? block : std::exchange(next, std::nullopt);
  };
  return {std::move(source), extended(-1)};
}

Source<SegmentBlock> segment_blocks(LinkedKeys keys, const Rules& rules, bool measured, unsigned threads) {
  keys.keys = in_small_blocks(std::move(keys.keys));
  auto windows = keys.context ? closed_windows(std::move(keys.keys), std::move(*keys.context))
                              : open_windows(std::move(keys.keys));
  const auto link = [rules, measured](const spline::Window<double>& window) {
    return block_of(window, rules, measured);
  };
  return ordered_map(std::move(windows), link, threads);
}

Source<SegmentBlock> sparse_segment_blocks(const KeyStore& keys, const std::optional<Time>& end, const Rules& rules,
                                           bool measured, const std::vector<std::string>& channels, bool expanded) {
  auto [all, missing] = with_missing(keys);
  require_positions(all, missing, channels);
  const auto part = expanded ? spline::expanded_part<double> : spline::part<double>;
  const KeyedCurve<double> curve(std::move(all), missing, rules, end, part);
  SegmentBlock block{curve.segments(0, curve.size()), {}, true, curve.is_closed()};
  if (measured) measure(block, rules);
  return [block = std::optional(std::move(block))]() mutable { return std::exchange(block, std::nullopt); };
}

void require_length(const DoubleDouble& length, const Time& end) {
  if (std::isfinite(length.hi)) return;
  throw length_beyond_doubles(time_text(end));
}

Lengths all_lengths(const Source<SegmentBlock>& measured) {
  Lengths lengths;
  DoubleDouble sum;
  while (const std::optional<SegmentBlock> block = measured()) {
    for (std::size_t i = 0; i < block->lengths.size(); ++i) {
      lengths.push_back(block->lengths[i]);
      sum = sum + DoubleDouble(lengths.back().value);
      require_length(sum, block->segments.times[i + 1]);
    }
  }
  return lengths;
}

double total_length(const Lengths& lengths) {
  DoubleDouble sum;
  for (const auto& length : lengths) sum = sum + DoubleDouble(length.value);
  return sum.hi;
}

Source<SegmentBlock> with_lengths(Source<SegmentBlock> segments, Lengths lengths) {
  return [segments = std::move(segments), lengths = std::move(lengths),
          next = std::ptrdiff_t{0}]() mutable -> std::optional<SegmentBlock> {
    std::optional<SegmentBlock> block = segments();
    if (!block) return std::nullopt;
    const auto begin = lengths.begin() + next;
    next += static_cast<std::ptrdiff_t>(block->segments.size());
    block->lengths.assign(begin, lengths.begin() + next);
    return block;
  };
}

}  // namespace tcb
