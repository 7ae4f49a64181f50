// Order: the keys of an input in their order: curve after curve, without gaps, with increasing times.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "numbers/frame_times.hpp"
#include "numbers/rational.hpp"
#include "numbers/time_notation.hpp"
#include "schema/curve_settings.hpp"
#include "schema/key_block.hpp"
#include "stream/source.hpp"

namespace tcb {

/// How grouped() arranges keys.
struct Grouping {
  std::size_t groups = 0;   ///< number of texts, from a key's first, that identify its curve
  bool sort = false;        ///< by time; the sort is stable
  bool own_curves = false;  ///< a curve begins with each block that has curve_info
};

/// The keys of one curve after another, in order of first appearance, with a break before each. The first call reads
/// the source to its end: the last row of an input may belong to its first curve.
/// Memory: 100 to 200 bytes per curve, and 16 bytes per key besides its numbers.
Source<KeyBlock> grouped(Source<KeyBlock> blocks, const Grouping& grouping);

/// What the remedies for times that do not increase depend on.
struct OrderRemedies {
  bool has_time_by_place = false;  ///< the first column is the time, as none has a name
  std::string_view group = {};     ///< NAME or NUMBER, which stands for a column in --group; empty: there is none
  std::string label = {};          ///< as in Columns: equal times are those of several curves; empty: no column is one
};

/// The remedy for keys of several curves that a label tells apart.
std::string remedy_for_label(std::string_view label);

/// The keys with times of one kind. Up to the block with the first time of more than 17 digits, times are doubles or
/// whole numbers; from there on each is its decimal.
Source<KeyBlock> with_time_digits(Source<KeyBlock> blocks);

/// From which time times count.
struct CountedFrom {
  Rational time;
  bool is_of_key = false;  ///< it is the time of a key, before a change of times
  bool has_keys = false;   ///< the keys count from it already
};

/// The exact time of the first key of a curve, whose keys stay; nothing without times. `frames`: where they are frames.
std::optional<Rational> first_time(Source<KeyBlock>& keys, const std::optional<FrameTimes>& frames);

/// A time less `zero`, exactly where that is a decimal of 31 digits, and otherwise the nearest double.
Time less(const Time& time, const Rational& zero, const std::optional<FrameTimes>& frames);

/// The keys of a curve with such times. Throws: Error (data) for times too far from zero to be told apart.
Source<KeyBlock> less(Source<KeyBlock> keys, const Rational& zero, const std::optional<FrameTimes>& frames);

/// The keys of times of day, to which a day is added where they go back by more than half of it. Counts these in
/// `midnights`, which outlives the source. Times in other notations stay. `rate`: of the frames of timecode. Requires:
/// no gaps.
Source<KeyBlock> past_midnight(Source<KeyBlock> blocks, TimeNotation notation, const Rational& rate,
                               std::uint64_t& midnights);

/// The keys without gaps, which become breaks. A break between two blocks is at the front of the later one.
Source<KeyBlock> without_gaps(Source<KeyBlock> blocks);

/// The keys, where those with the same time get equal parts of the step to the next time of the curve, the last ones of
/// a curve of the step before. Holds the keys of one time.
Source<KeyBlock> spread_out(Source<KeyBlock> blocks);

/// The keys whose times increase up to the next break. Decreasing times, and equal ones where they are an error, are
/// faults of the block. Duplicates::last delays one key until the next is read.
Source<KeyBlock> in_order(Source<KeyBlock> blocks, Duplicates duplicates, OrderRemedies remedies = {});

}  // namespace tcb
