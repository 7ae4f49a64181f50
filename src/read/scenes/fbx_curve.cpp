// FBX curves: the keys of an animation curve of FBX as keys of a channel.
#include "read/scenes/fbx.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

#include "text/utf8.hpp"

namespace tcb {
namespace {

Error no_old_fbx_tangent(std::string_view letter) {
  return data_error(
      "the key has the type {}, which is not documented; expected TCB, user, linear and constant keys; export the file "
      "as FBX 7",
      in_quotes(letter));
}

Error fbx_tangents_with_weights() {
  return data_error(
      "the tangents of the key have weights, so the curve is not a cubic in time; expected tangents without weights; "
      "remove them in the program that made the file, or bake the animation and export it again");
}

Error fbx_arrays_differ() {
  return data_error(
      "the numbers of keys, values, flags and tangents of the animation curve differ; expected as many as there are "
      "keys; export the file again");
}

/// The flags of a key. Source: the class FbxAnimCurveDef of the FBX SDK. 0x10000000 and 0x20000000 show velocities,
/// which are in slopes and weights too.
namespace flag {
constexpr std::uint32_t constant = 0x2, linear = 0x4, cubic = 0x8;
constexpr std::uint32_t takes_next = 0x100;  ///< of a constant span
constexpr std::uint32_t tcb = 0x200, user = 0x400;
constexpr std::uint32_t clamps = 0x1000, time_independent = 0x2000, clamps_progressively = 0x4000;
constexpr std::uint32_t right_weight = 0x1000000, left_weight = 0x2000000;
}  // namespace flag

/// Whether a tangent has the weight 1/3, which makes the span a cubic in time; in units of 0.0001, as in files. Before
/// version 7.2, files have 7 digits of the float whose bits are two weights.
constexpr bool is_third(std::uint32_t weight) { return weight >= 3331 && weight <= 3335; }

WrittenNumber seconds(std::int64_t ticks, const FbxHead& head) {
  return written_number(Rational(ticks) / Rational(head.ticks_per_second));
}

/// The numbers of KeyAttrDataFloat as single-precision floats. Since version 7.2 they are written as their bits.
std::vector<float> floats_of(const FbxNode& node, const FbxHead& head) {
  constexpr std::int64_t first_with_bits = 7200;
  std::vector<float> floats;
  const bool are_bits = head.version >= first_with_bits;
  for (FbxValues values(node); !values.at_end();) {
    if (are_bits) {
      floats.push_back(std::bit_cast<float>(static_cast<std::uint32_t>(values.next_integer())));
    } else {
      floats.push_back(static_cast<float>(values.next_number().value));
    }
  }
  return floats;
}

WrittenNumber number_of(float value, std::uint64_t line) {
  if (!(value - value == 0)) throw number_of_track_not_finite().at({"", line, 0});
  return written_number(Rational(static_cast<double>(value)));
}

/// Sets how the span after a key runs, from the flags and four floats.
void set_span(FbxKey& key, std::uint32_t flags, const float* data) {
  const auto fail = [&](const Error& error) -> Error { return error.at({"", key.line, 0}); };
  if ((flags & flag::constant) != 0) {
    key.span = (flags & flag::takes_next) != 0 ? FbxSpan::constant_next : FbxSpan::constant;
    return;
  }
  if ((flags & flag::linear) != 0) return;
  if ((flags & flag::cubic) == 0)
    throw fail(
        data_error("the interpolation of the key has the flags 0x{:x}; expected constant (0x2), linear (0x4) or cubic "
                   "(0x8); change it in the program that made the file",
                   flags));
  if ((flags & flag::tcb) != 0) {
    key.span = FbxSpan::tcb;
    key.tension = number_of(data[0], key.line);
    key.continuity = number_of(data[1], key.line);
    key.bias = number_of(data[2], key.line);
    return;
  }
  const auto weights = std::bit_cast<std::uint32_t>(data[2]);
  const bool is_right_other = (flags & flag::right_weight) != 0 && !is_third(weights & 0xFFFF);
  const bool is_left_other = (flags & flag::left_weight) != 0 && !is_third(weights >> 16);
  if (is_right_other || is_left_other) throw fail(fbx_tangents_with_weights());
  key.span = (flags & flag::user) != 0 ? FbxSpan::user : FbxSpan::automatic;
  key.right = number_of(data[0], key.line);
  key.next_left = number_of(data[1], key.line);
  key.is_time_independent = (flags & flag::time_independent) != 0;
  key.clamps = (flags & flag::clamps) != 0;
  key.clamps_progressively = (flags & flag::clamps_progressively) != 0;
}

/// The weights of a tangent in version 6: n (none), r, l (one side), a (both).
void require_no_weights(FbxValues& values, std::uint64_t line) {
  const std::string_view kind = values.next();
  const auto require_third = [&] {
    const double weight = values.next_number().value / 1e-4;
    if (!(weight >= 0 && weight < 1e5 && is_third(static_cast<std::uint32_t>(weight)))) {
      throw fbx_tangents_with_weights().at({"", line, 0});
    }
  };
  if (kind != "n" && kind != "r" && kind != "l" && kind != "a") throw no_old_fbx_tangent(kind).at({"", line, 0});
  if (kind != "n") require_third();
  if (kind == "a") require_third();
}

/// The tangents of the keys of a channel.
class Tangents {
 public:
  explicit Tangents(const std::vector<FbxKey>& keys) : keys_(keys) {}

  /// The span after key i.
  TrackSpan span(std::size_t i) const {
    switch (keys_[i].span) {
      case FbxSpan::constant: return {TrackSpan::Kind::holds_first};
      case FbxSpan::constant_next: return {TrackSpan::Kind::holds_second};
      case FbxSpan::linear: return {TrackSpan::Kind::cubic, slope(i), slope(i)};
      default: return {TrackSpan::Kind::cubic, outgoing(i), incoming(i + 1)};
    }
  }

 private:
  Rational time(std::size_t i) const { return exact_number(keys_[i].time); }
  Rational value(std::size_t i) const { return exact_number(keys_[i].value); }
  Rational duration(std::size_t i) const { return time(i + 1) - time(i); }
  Rational slope(std::size_t i) const { return (value(i + 1) - value(i)) / duration(i); }
  bool is_end(std::size_t i) const { return i == 0 || i + 1 == keys_.size(); }

  Rational outgoing(std::size_t i) const {
    const FbxKey& key = keys_[i];
    if (key.span == FbxSpan::tcb) return tcb_slope(i, 1 + exact_number(key.continuity));
    if (key.span == FbxSpan::user) return exact_number(key.right);
    return automatic(i, exact_number(key.right));
  }

  /// The slope at key i of the cubic before it.
  Rational incoming(std::size_t i) const {
    const FbxKey& key = keys_[i];
    const FbxKey& previous = keys_[i - 1];
    if (key.span == FbxSpan::tcb) return tcb_slope(i, 1 - exact_number(key.continuity));
    if (key.span == FbxSpan::automatic) {
      const bool has_bias = previous.span == FbxSpan::user || previous.span == FbxSpan::automatic;
      return automatic(i, has_bias ? -exact_number(previous.next_left) : Rational(0));
    }
    // The number is in the place of the continuity of a TCB key before.
    if (previous.span == FbxSpan::tcb)
      throw data_error(
          "the key follows a TCB key, so the file has no slope for its left side; expected a TCB or an automatic "
          "tangent; change one of the two keys")
          .at({"", key.line, 0});
    return exact_number(previous.next_left);
  }

  /// By the preset fbx. `before` is 1 + C for an outgoing tangent and 1 - C for an incoming one.
  Rational tcb_slope(std::size_t i, const Rational& before) const {
    const FbxKey& key = keys_[i];
    const Rational loose = (1 - exact_number(key.tension)) / (is_end(i) ? 1 : 2);
    const Rational bias = exact_number(key.bias);
    Rational result(0);
    if (i > 0) result += loose * (1 + bias) * before * slope(i - 1);
    if (i + 1 < keys_.size()) result += loose * (1 - bias) * (2 - before) * slope(i);
    return result;
  }

  /// The automatic slope at key i: between the chord of both spans and the mean of their slopes, weighted by the
  /// other's duration, or the chord alone where it is independent of time. A bias moves it to one of the slopes.
  Rational automatic(std::size_t i, const Rational& percent) const {
    const FbxKey& key = keys_[i];
    constexpr int most_percent = 500;  // above it, the slope has another rule
    if (percent < -most_percent || percent > most_percent) {
      throw data_error(
          "the bias of the automatic tangent is beyond {} percent; expected no more; change the tangent to a user "
          "tangent",
          most_percent)
          .at({"", key.line, 0});
    }
    if (is_end(i)) {
      if (key.clamps_progressively) return Rational(0);
      return i == 0 ? slope(i) : slope(i - 1);
    }
    if (key.clamps && (slope(i - 1) == 0 || slope(i) == 0)) return Rational(0);
    const Rational before = duration(i - 1), after = duration(i), both = before + after;
    Rational result = (value(i + 1) - value(i - 1)) / both;
    if (!key.is_time_independent) {
      result = result / 2 + (slope(i - 1) * after + slope(i) * before) / both / 2;
      const Rational weight = abs(percent) / 100;
      result = result * (1 - weight) + (percent > 0 ? slope(i) : slope(i - 1)) * weight;
    }
    return key.clamps_progressively ? within(result, 3 * slope(i - 1), 3 * slope(i)) : result;
  }

  /// A slope no steeper than others; zero where they have another sign.
  static Rational within(const Rational& slope, const Rational& a, const Rational& b) {
    if (slope * a <= 0 || slope * b <= 0) return Rational(0);
    return slope > 0 ? std::min({slope, a, b}) : std::max({slope, a, b});
  }

  const std::vector<FbxKey>& keys_;
};

/// An extrapolation of FBX by its letter.
struct ExtrapolationRow {
  std::string_view letter, name;
  bool repeats;
};
constexpr std::array extrapolations_of_fbx{
    ExtrapolationRow{"C", "hold", false},     ExtrapolationRow{"K", "linear", false},
    ExtrapolationRow{"R", "repeat", true},    ExtrapolationRow{"A", "offset", true},
    ExtrapolationRow{"M", "oscillate", true},
};

/// The extrapolation of one side of a curve; nothing where there is none, or where it ends after some repetitions.
std::string_view read_extrapolation(const FbxNode& curve, std::string_view side) {
  const FbxNode* const node = curve.find(side);
  const FbxNode* const type = node == nullptr ? nullptr : node->find("Type");
  if (type == nullptr) return "";
  const std::string_view letter = FbxValues(*type).next();
  const auto row = std::ranges::find(extrapolations_of_fbx, letter, &ExtrapolationRow::letter);
  if (row == extrapolations_of_fbx.end()) return "";
  const FbxNode* const count = node->find("Repetition");
  const bool ends = row->repeats && count != nullptr && FbxValues(*count).next_integer() >= 0;
  return ends ? "" : row->name;
}

}  // namespace

FbxCurve read_curve(const FbxNode& curve, const FbxHead& head) {
  FbxValues times(curve.child("KeyTime")), values(curve.child("KeyValueFloat"));
  FbxValues flags(curve.child("KeyAttrFlags")), counts(curve.child("KeyAttrRefCount"));
  const std::vector<float> data = floats_of(curve.child("KeyAttrDataFloat"), head);
  constexpr std::size_t numbers = 4;  // of the tangents of a key
  std::vector<FbxKey> keys;
  std::int64_t left = 0;  // keys with the same flags
  std::uint32_t bits = 0;
  std::size_t first = 0;
  while (!times.at_end()) {
    if (values.at_end()) throw fbx_arrays_differ().at({"", curve.line, 0});
    if (left == 0) {
      if (!keys.empty()) first += numbers;
      if (flags.at_end() || counts.at_end() || first + numbers > data.size()) {
        throw fbx_arrays_differ().at({"", curve.line, 0});
      }
      bits = static_cast<std::uint32_t>(flags.next_integer());
      left = counts.next_integer();
      if (left < 1) throw fbx_arrays_differ().at({"", curve.line, 0});
    }
    --left;
    FbxKey key{{seconds(times.next_integer(), head), values.next_number()}};
    key.line = curve.line;
    set_span(key, bits, &data[first]);
    keys.push_back(std::move(key));
  }
  const bool has_all = keys.empty() ? data.empty() : first + numbers == data.size();
  if (!values.at_end() || left != 0 || !flags.at_end() || !counts.at_end() || !has_all)
    throw fbx_arrays_differ().at({"", curve.line, 0});
  return {keys, read_extrapolation(curve, "Pre-Extrapolation"), read_extrapolation(curve, "Post-Extrapolation")};
}

FbxCurve read_old_curve(const FbxNode& channel, const FbxHead& head) {
  const FbxNode* const list = channel.find("Key");
  if (list == nullptr) return {};
  std::vector<FbxKey> keys;
  const std::int64_t version = FbxValues(channel.child("KeyVer")).next_integer();
  const std::int64_t count = FbxValues(channel.child("KeyCount")).next_integer();
  constexpr std::int64_t without_weights = 4003, with_sides = 4004;  // versions
  for (FbxValues values(*list); !values.at_end();) {
    const std::uint64_t line = values.line();
    FbxKey key{{seconds(values.next_integer(), head), values.next_number()}};
    key.line = line;
    const std::string_view mode = values.next();
    if (mode == "C") {
      const bool is_next = version >= with_sides && values.next() == "n";
      key.span = is_next ? FbxSpan::constant_next : FbxSpan::constant;
    } else if (mode == "U") {
      const std::string_view tangent = values.next();
      if (tangent == "t") {
        key.span = FbxSpan::tcb;
        key.tension = values.next_number();
        key.continuity = values.next_number();
        key.bias = values.next_number();
      } else if (tangent == "s" || tangent == "b") {
        key.span = FbxSpan::user;
        key.right = values.next_number();
        key.next_left = values.next_number();
        if (version != without_weights) require_no_weights(values, line);
      } else {
        throw no_old_fbx_tangent(tangent).at({"", line, 0});
      }
    } else if (mode != "L") {
      throw no_old_fbx_tangent(mode).at({"", line, 0});
    }
    keys.push_back(std::move(key));
  }
  if (std::cmp_not_equal(keys.size(), count)) throw fbx_arrays_differ().at({"", list->line, 0});
  return {keys, read_extrapolation(channel, "Pre-Extrapolation"), read_extrapolation(channel, "Post-Extrapolation")};
}

TrackChannel channel_of(std::string_view name, const FbxCurve& curve) {
  return channel_of(name, curve, [tangents = Tangents(curve.keys)](std::size_t i) { return tangents.span(i); });
}

}  // namespace tcb
