// Curves: the keys of an input, arranged and split into curves.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "keys/order.hpp"
#include "schema/input_keys.hpp"
#include "schema/rotation_options.hpp"
#include "schema/schema.hpp"
#include "stream/source.hpp"

namespace tcb {

/// Passes keys on until one has a fault; then reads on to collect more faults, as far as they arrive, and throws an
/// Error (data) with all of them. `arrive`: as in InputBytes; nothing: everything does.
Source<KeyBlock> without_faults(Source<KeyBlock> blocks, const std::function<bool()>& arrive = nullptr);

/// A channel with a number that may be the sign of a missing one.
struct LikelySign {
  std::string channel;
  double number;
};

/// What the numbers of channels may mean besides, by all keys.
class ObservedChannels {
 public:
  /// `may_miss`: a channel may lack numbers.
  ObservedChannels(const Schema& schema, bool may_miss);

  void add(const KeyBlock& block);

  /// Plain channels that seem to be angles, as they jump by more than half a turn: by their names, or by numbers at the
  /// beginning that are all within a turn and jump from near its end to near its beginning. Angles that are all within
  /// a turn of radians are in radians.
  std::vector<NamedAngle> likely_angles() const;
  /// Channels with a number such as -9999 or 99.9 that is far from all others.
  std::vector<LikelySign> likely_signs() const;
  /// Channels that have no number at the first or the last key of a curve.
  std::vector<std::string> without_ends() const;

 private:
  struct Channel {
    std::size_t source = 0;  ///< of keys as they are read
    std::string name;
    double least = std::numeric_limits<double>::infinity(), most = -least;  ///< of the numbers that are no sign
    double sign = 0;                                                        ///< the last one that is,
    std::size_t signs = 0;                                                  ///< and how often it follows itself
    bool is_unknown = false;                            ///< by its numbers alone it may be an angle,
    bool is_coordinate = false;                         ///< or by numbers that are no small coordinates
    bool may_be_angle = false, is_named_angle = false;  ///< the latter by a name that is one of angles alone
    bool is_positive = true;                            ///< no number is below 0
    double largest = 0, jump = 0;
    double from = 0, to = 0;                     ///< of the largest jump
    bool lacks_end = false, lacks_last = false;  ///< it has no number at an end of a curve; at the last key so far
    std::optional<double> before = {};

    bool jumps_over_end(bool degrees) const;
  };

  void add_ends(const KeyBlock& block);

  bool has_names_;  ///< the channels have; small numbers without a name are no angles
  bool may_miss_;
  bool is_beginning_ = true;  ///< no block was observed
  std::vector<Channel> channels_;
};

/// Where keys carry tension, continuity or bias other than 0, and which settings of their curves that matters to.
class ObservedTcbs {
 public:
  /// Keys of a curve; `begins`: the first ones of the next curve.
  void add(const KeyBlock& block, const CurveSettings& settings, bool begins);

  /// Any key does; any of a curve whose input gives it linear tangents.
  bool any() const { return any_; }
  bool any_linear() const { return any_linear_; }
  /// The first or the last key of an open curve does, whose input names neither its ends nor a preset.
  bool at_ends() const { return at_ends_ || is_last_; }
  /// The input names the ends of a curve.
  bool has_named_ends() const { return has_named_ends_; }

 private:
  bool any_ = false, any_linear_ = false, at_ends_ = false, has_named_ends_ = false;
  bool is_last_ = false;  ///< the last key of the curve so far makes at_ends_ true
};

/// A part of a curve that gaps divide, which has a curve of its own.
struct CurvePart {
  std::size_t number = 0;  ///< of the part, from 0
  Time origin;             ///< the time of the first key of the first part
  /// The time of the first key of the next part, once all keys of this one are read; nothing: it is the last one.
  std::function<std::optional<Time>()> next;
  Rational max_gap = 0;  ///< in the unit of the times
};

/// Whether the time between two keys, of which the second one is later, is more than `most`.
bool is_gap(const Time& from, const Time& to, const Rational& most);

struct InputCurve {
  std::vector<std::string> group;  ///< the texts that identify the curve, one for each of the input's groups
  std::shared_ptr<const CurveInfo> curve_info;
  Source<KeyBlock> keys;
  std::optional<CurvePart> part = {};  ///< where gaps divide curves
};

/// Times of a curve that count from another one than 0, exactly. `frames`: where they are frames.
void count_from(InputCurve& curve, const Rational& zero, const std::optional<FrameTimes>& frames);
CurvePart counted_from(const CurvePart& part, const Rational& zero, const std::optional<FrameTimes>& frames);

/// The curves of an input, in order of first appearance. It outlives the sources of their keys.
class Curves {
 public:
  /// `arrive`: as for without_faults().
  Curves(const Schema& schema, const InputKeys& keys, const CurveOptions& options,
         const std::function<bool()>& arrive = nullptr);
  Curves(const Curves&) = delete;
  Curves& operator=(const Curves&) = delete;

  /// The next curve. It ends the previous one, whose remaining keys are skipped.
  /// Throws: Error (data) with all faults of the keys.
  std::optional<InputCurve> next();

  std::uint64_t skipped() const { return skipped_; }
  const ObservedChannels& channels() const { return channels_; }
  const ObservedTcbs& tcbs() const { return tcbs_; }
  /// How often times of day passed midnight so far.
  std::uint64_t midnights() const { return midnights_; }
  /// How many gaps divided curves so far, and the largest one.
  std::uint64_t gaps() const { return gaps_; }
  double largest_gap() const { return largest_gap_; }
  /// How often the input breaks between two keys, apart from gaps.
  std::uint64_t breaks() const { return breaks_; }

 private:
  void count_breaks(const KeyBlock& block);
  std::optional<KeyBlock> next_keys();
  std::optional<KeyBlock> observed_keys();
  std::vector<std::string> group() const;
  bool has_gap(std::size_t key) const;
  std::optional<Time> next_part();
  bool fill();

  std::uint64_t midnights_ = 0, breaks_ = 0;
  bool any_read_ = false, is_broken_ = false;  ///< any key was read; a break follows the last one
  ObservedChannels channels_;
  ObservedTcbs tcbs_;
  Source<KeyBlock> blocks_;
  bool may_break_;
  std::optional<Rational> max_gap_;  ///< in the unit of the times
  std::size_t groups_;
  std::shared_ptr<const CurveInfo> curve_info_;
  bool own_curves_;
  std::optional<KeyBlock> block_;  ///< holds the next key
  std::size_t at_ = 0;             ///< its index
  std::uint64_t skipped_ = 0;
  bool first_ = true;         ///< no curve has begun
  bool started_ = false;      ///< the next key is the first of the current curve
  std::optional<Time> last_;  ///< the time of the last key that was handed out of the current curve
  Time origin_;               ///< the time of the first key of the first part of the current curve
  std::size_t part_ = 0;      ///< of the curve that gaps divide
  std::uint64_t gaps_ = 0;
  double largest_gap_ = 0;
};

}  // namespace tcb
