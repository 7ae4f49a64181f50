// From keys to segments with their lengths: open, closed and sparse curves, streamed and kept.
#include "sample/build.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <stdexcept>

#include "keys/prepare.hpp"
#include "numbers/decimal_time.hpp"
#include "numbers/print_number.hpp"
#include "stream/ordered_map.hpp"
#include "tcb/spline/build_error.hpp"
#include "tcb/spline/closing.hpp"
#include "tcb/spline/curve.hpp"
#include "tcb/spline/curve_keys.hpp"
#include "tcb/spline/curve_stream.hpp"
#include "text/suggest.hpp"
#include "text/utf8.hpp"

namespace tcb {
namespace {

using spline::DoubleDouble;

void measure(SegmentBlock& block, const Rules& rules) {
  block.lengths = spline::lengths_of<double>(block.segments, rules.metric);
  for (std::size_t i = 0; i < block.segments.size(); ++i) {
    if (std::isfinite(block.lengths[i].value)) continue;
    const std::string from = time_text(block.segments.times[i]), to = time_text(block.segments.times[i + 1]);
    throw data_error(
        "the curve from time {} to {} has tangents beyond the range of doubles; expected less than 1.8e308 in size; "
        "scale the keys down",
        from, to);
  }
}

/// Gives times that are frames the digits that doubles omit.
void make_precise(std::vector<Time>& times, const std::optional<FrameTimes>& frames) {
  if (!frames) return;
  for (Time& time : times) time = frames->elapsed(time);
}

/// The block of these segments, with their times as doubles where they are frames.
SegmentBlock finished(SegmentBlock block, const Rules& rules, const SegmentOptions& options) {
  if (options.frames) {
    std::vector<Time>& times = block.segments.times;
    for (Time& time : times) time = options.frames->key_time(time);
    if (options.frames->are_decimals() && std::ranges::any_of(times, is_long_decimal)) {  // all, so that they compare
      for (Time& time : times) time = with_all_digits(time);
    }
  }
  if (options.measured) measure(block, rules);
  return block;
}

/// The keys in blocks of at most keys_at_once.
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

/// Windows of keys, as they become complete.
Source<spline::Window<double>> windows(Source<Keys> keys, spline::CurveStream<double> stream) {
  return [keys = std::move(keys), stream = std::move(stream),
          ended = false]() mutable -> std::optional<spline::Window<double>> {
    if (ended) return std::nullopt;
    if (const std::optional<Keys> block = keys()) return stream.push(*block);
    ended = true;
    return stream.finish();
  };
}

Source<SegmentBlock> streamed_segments(Source<Keys> keys, spline::CurveStream<double> stream, const Rules& rules,
                                       const SegmentOptions& options) {
  if (options.frames) {
    keys = mapped(std::move(keys), [frames = options.frames](Keys block) {
      make_precise(block.times, frames);
      return block;
    });
  }
  const auto link = [rules, options](const spline::Window<double>& window) {
    return finished({spline::segments(window, rules), {}, window.last, window.last && !window.ends}, rules, options);
  };
  return ordered_map(windows(in_small_blocks(std::move(keys)), std::move(stream)), link, options.threads);
}

/// All segments of a curve whose keys lack positions, in one block.
SegmentBlock sparse_segments(const KeyStore& keys, const std::optional<Time>& end, const Rules& rules,
                             const SegmentOptions& options) {
  const auto part = options.expanded ? spline::expanded_part<double> : spline::part<double>;
  Keys all = keys.all();
  make_precise(all.times, options.frames);
  const spline::CurveKeys<double> curve(std::move(all), rules, end, part, options.gaps);
  return finished({curve.segments(0, curve.size()), {}, true, curve.is_closed()}, rules, options);
}

}  // namespace

Error curve_error(const spline::BuildError& error, const KeyStore& keys, const std::vector<std::string>& channels) {
  using enum spline::BuildErrorCode;
  const TextPosition last{"", keys.last_line(), 0};
  switch (error.code) {
    case channel_without_positions:
      return data_error(
          "no key has a number in channel {}; expected at least one; fill one in, or give --columns {} to leave the "
          "column out",
          in_quotes(channels[error.channel]), in_shell("ignore=" + channels[error.channel]));
    case ease_with_missing_positions:
      return data_error(
          "some numbers were skipped by --missing skip-cell, but ease_in and ease_out need a number in every channel; "
          "fill them in, or give --no-ease");
    case closed_too_few_keys: return data_error("a closed curve needs at least two distinct keys; add keys");
    case period_missing: {  // as long as the last segment, for example
      const auto time = [&](std::size_t key) { return exact_time(keys.key(key).times[0]); };
      const std::size_t end = keys.size() - 1;
      return data_error(
          "the last key does not repeat the first, so that the period of the closed curve is unknown; expected it; "
          "give --period {} or another one, --closed=no for an open curve, or add a row that repeats the first "
          "position",
          time_text(nearest_time(time(end) - time(0) + (time(end) - time(end - 1)))));
    }
    case period_not_finite:
    case period_too_short:
      return data_error(
          "the period ends before the last key, at time {}; give a longer period, or --closed=no for an open curve",
          time_text(keys.key(error.key).times[0]));
    case period_contradicted:
      return data_error(
                 "this key repeats the position of line {}, so it ends the period, but the given period differs; "
                 "remove the key or the period",
                 keys.first_line())
          .at(last);
    case seam_tcb_differs:
      return data_error(
                 "this key closes the curve at the position of line {}, but has a different tension, continuity or "
                 "bias; expected the same numbers; correct one of the two keys",
                 keys.first_line())
          .at(last);
    case seam_velocity_differs:
      return data_error(
                 "this key closes the curve at the position of line {}, but the velocity differs; expected the same; "
                 "correct one of the two keys, or leave the incoming velocity of the first key and the outgoing "
                 "velocity of the last key empty",
                 keys.first_line())
          .at(last);
    case seam_velocity_missing:
      return data_error(
          "a velocity of channel \"{}\" is missing where the closed curve returns to its first key; expected the "
          "incoming velocity of the first key and the outgoing velocity of the last key; fill them in",
          channels[error.channel]);
    default: throw std::logic_error(error.message());  // the stages before find every other fault
  }
}

Time take_closing(KeyStore& keys, const CurveSpec& spec, const std::vector<std::string>& channels) {
  const Keys first = keys.key(0);
  const Keys last = spline::with_signs_of(first, keys.key(keys.size() - 1), spec.rules.rotations);
  std::optional<Time> end;
  if (spec.period) {
    const auto frame = spec.frames ? spec.frames->exact(first.times[0]) : std::nullopt;
    end = nearest_time(frame.value_or(exact_time(first.times[0])) + *spec.period, keys.decimals());
  } else if (!spec.timed && keys.size() > 1 && !spline::is_repeated(first, last)) {
    const double step =
        parameter_step<double, double>(last.position(0), first.position(0), spec.exponent(), spec.rules.metric);
    end = Time((last.times[0] + Time(step)).hi);
  }
  const auto closing = spline::find_closing<double>(first, last, keys.size(), end);
  if (!closing) throw curve_error(closing.error(), keys, channels);
  if (closing->repeats) {
    keys.drop_last();
    keys.join_seam(last);
  }
  const auto key_at = [&keys](std::size_t number) { return keys.key(number); };
  if (const auto error = spline::find_seam_error<double>(key_at, keys.size())) {
    throw curve_error(*error, keys, channels);
  }
  return closing->end;
}

Source<SegmentBlock> segment_blocks(Source<Keys> keys, const Rules& rules, const SegmentOptions& options) {
  return streamed_segments(std::move(keys), {}, rules, options);
}

Source<SegmentBlock> StreamedCurve::segments(bool measured) const {
  SegmentOptions own = options;
  own.measured = measured;
  std::optional<Time> end = extent.closed ? extent.last : std::nullopt;
  if (end && own.frames) end = own.frames->elapsed(*end);
  if (keys.are_sparse()) {
    return [block = std::optional(sparse_segments(keys, end, rules, own))]() mutable {
      return std::exchange(block, std::nullopt);
    };
  }
  spline::CurveStream<double> stream;
  if (end) {
    Keys last_key = keys.key(keys.size() - 1);
    make_precise(last_key.times, own.frames);
    stream = {std::move(last_key), *end};
  }
  return streamed_segments(keys.source(), stream, rules, own);
}

KeptCurve::KeptCurve(spline::Curve<double> curve, CurveChannels channels, const Extent& extent,
                     const Extrapolations& extrapolations, std::vector<spline::ChannelGap> gaps)
    : curve_(std::make_shared<const spline::Curve<double>>(std::move(curve))),
      channels_(std::move(channels)),
      extent_(extent),
      extrapolations_(extrapolations),
      gaps_(std::move(gaps)) {
  for (const Time& time : curve_->times()) decimals_ = std::max(decimals_, decimals_of(time));
  const spline::Segment<double> first = curve_->segment(0), last = curve_->segment(curve_->segment_count() - 1);
  for (std::size_t i = 0; i < first.rotations.size(); ++i) {
    turns_.push_back(last.rotations[i].at({1, 0}) * spline::conjugate(first.rotations[i].at({0, -1})));
  }
  for (std::size_t i = 0; i < first.cubics.size(); ++i) cycle_.push_back(last.cubics[i].p1 - first.cubics[i].p0);
}

KeptCurve StreamedCurve::kept(const CurveChannels& channels, const Extrapolations& extrapolation, bool measured) const {
  const std::size_t count = extent.closed ? keys.size() : std::max<std::size_t>(keys.size() - 1, 1);
  spline::Curve<double> curve(rules, extent.closed, count);
  const Source<SegmentBlock> all = segments(measured);
  while (std::optional<SegmentBlock> block = all()) curve.append(std::move(block->segments), block->lengths);
  return {std::move(curve), channels, extent, extrapolation, options.gaps};
}

double KeptCurve::length() const { return curve_->length().value; }

std::uint64_t KeptCurve::size() const { return curve_->segment_count(); }

CurveSegment KeptCurve::segment(std::uint64_t number) const {
  const spline::Segment<double> segment = curve_->segment(number);
  const bool last = number + 1 == size();
  return {segment.start,
          segment.end,
          segment.length_start,
          segment.length_end,
          segment.cubics,
          channels_.metric,
          last,
          segment.warp,
          cycle_,
          number,
          segment.length_error,
          last && curve_->is_closed() ? 0 : number + 1,
          decimals_,
          segment.rotations,
          channels_.rotations,
          channels_.angles,
          turns_,
          channels_.frames ? &*channels_.frames : nullptr};
}

void require_length(const DoubleDouble& length, const Time& end) {
  if (std::isfinite(length.hi)) return;
  throw data_error(
      "the length of the curve up to time {} is beyond the range of doubles; expected less than 1.8e308; scale the "
      "keys down",
      time_text(end));
}

StreamedCurve::Measured StreamedCurve::measured() const {
  std::deque<spline::Length<double>> lengths;  // which grows without a copy
  DoubleDouble sum;
  std::size_t last_moving = 0;
  const Source<SegmentBlock> blocks = segments(true);
  while (const std::optional<SegmentBlock> block = blocks()) {
    for (std::size_t i = 0; i < block->lengths.size(); ++i) {
      lengths.push_back(block->lengths[i]);
      if (lengths.back().value > 0) last_moving = lengths.size() - 1;
      sum = sum + DoubleDouble(lengths.back().value);
      require_length(sum, block->segments.times[i + 1]);
    }
  }
  const auto add_lengths = [lengths = std::move(lengths), next = std::ptrdiff_t{0}](SegmentBlock block) mutable {
    const auto begin = lengths.begin() + next;
    next += static_cast<std::ptrdiff_t>(block.segments.size());
    block.lengths.assign(begin, lengths.begin() + next);
    return block;
  };
  return {mapped(segments(), add_lengths), sum.hi, last_moving};
}

}  // namespace tcb
