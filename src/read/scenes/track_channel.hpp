// Channels of tracks: the keys of one animated value of a file, each with its numbers as written.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "error.hpp"
#include "numbers/parse_number.hpp"

namespace tcb {

// Faults of files.
Error number_of_track_not_finite();
Error file_ends_early();
Error number_of_file_expected(std::string_view found);
Error count_of_file_expected(std::string_view found);

/// The number nearest to a ratio. Throws: Error (data) beyond the doubles.
WrittenNumber written_number(const Rational& exact);

/// A key of one channel.
struct TrackKey {
  WrittenNumber time;
  WrittenNumber value;
  WrittenNumber tension = {}, continuity = {}, bias = {};
  WrittenNumber ease_in = {}, ease_out = {};                         ///< the same in all channels of a track
  std::optional<WrittenNumber> velocity_in = {}, velocity_out = {};  ///< per unit of time, where the file decides them
  std::uint64_t line = 0;                                            ///< in the file; 0: it has no lines
};

/// The keys of a channel in order.
struct TrackChannel {
  std::string name;
  std::vector<TrackKey> keys = {};
  bool has_velocities = false;  ///< the file decides all velocities
  /// The extrapolations before and after the keys, or nothing where the file does not decide them.
  std::string_view before = {}, after = {};
};

/// The curve between two keys where the file decides it: a cubic in time, or a step.
struct TrackSpan {
  enum class Kind {
    cubic,
    holds_first,   ///< the first value up to the double before the second time
    holds_second,  ///< the second value from the double after the first time
  };
  Kind kind = Kind::cubic;
  Rational start = Rational(0), end = Rational(0);  ///< velocities of a cubic
};

/// Throws: Error (data).
void require_increasing_times(const TrackChannel& channel);

/// Gives the keys of a channel the velocities of the spans between them, and adds keys for steps. Throws: Error (data)
/// for a step that no double is within.
void set_spans(TrackChannel& channel, const std::vector<TrackSpan>& spans);

/// The keys of a channel, of a format's own kind, and its extrapolations as in TrackChannel.
template <class Key>
struct TrackCurve {
  std::vector<Key> keys = {};
  std::string_view before = {}, after = {};
};

/// The channel of a curve. Unless all its keys are TCB, span_of(i) is the span after key i. Throws: Error (data) for
/// times that do not increase, and as set_spans().
template <class Key, class SpanOf>
TrackChannel channel_of(std::string_view name, const TrackCurve<Key>& curve, const SpanOf& span_of) {
  const std::vector<Key>& keys = curve.keys;
  TrackChannel channel{std::string(name), {keys.begin(), keys.end()}, false, curve.before, curve.after};
  require_increasing_times(channel);
  if (keys.size() < 2 || std::ranges::all_of(keys, &Key::is_tcb)) return channel;
  std::vector<TrackSpan> spans;
  for (std::size_t i = 0; i + 1 < keys.size(); ++i) spans.push_back(span_of(i));
  set_spans(channel, spans);
  return channel;
}

}  // namespace tcb
