// Rotations and angles of keys: the quaternions of rotations in other forms, checks, and signs.
//
// A block goes through with_clear_turns(): Conversion makes quaternions of the numbers of a rotation in another form,
// which stay beside them as they are given; SignChain and AngleChain check each key against the one before, as two keys
// half a turn apart have no direction between them, and SignChain negates quaternions so that the turn is the short
// one.
#include "keys/rotations.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <span>
#include <tuple>
#include <utility>

#include "error.hpp"
#include "tcb/spline/angle.hpp"
#include "tcb/spline/rotation.hpp"
#include "tcb/spline/rotation_notation.hpp"
#include "text/utf8.hpp"

namespace tcb {
namespace {

constexpr double half_turn_rounding = 0x1p-50;  ///< of the cosine of half the angle of a turn

/// Throws: Error (data) for an angle of more turns than its unit allows. `makes_turns`: they count.
void require_angle(double angle, bool degrees, bool makes_turns, const std::string& name, std::uint64_t line) {
  constexpr double turn = 6.283185307179586, most_turns = 1e4;
  if (std::abs(angle) <= (degrees ? 360 * most_turns : makes_turns ? turn * most_turns : turn)) return;
  const bool counts_turns = degrees || makes_turns;
  throw(counts_turns ? data_error("{} has an angle of {}; expected at most 10000 turns; check its column, and its unit "
                                  "with --angles or --angle",
                                  in_quotes(name), angle)
                     : data_error("{} has an angle of {} radians; expected at most one turn, 6.2832; give degrees as "
                                  "its unit with --angles or --angle, or subtract whole turns",
                                  in_quotes(name), angle))
      .at({"", line, 0});
}

Error rotation_incomplete(const std::string& column) {
  return data_error(
      "the rotation that begins with {} lacks a number; expected all of its numbers, or none; fill it in, or remove "
      "the row",
      in_quotes(column));
}
Error velocities_of_part_of_rotation(const std::string& column) {
  return data_error(
      "some numbers of the rotation that begins with {} have velocities; expected velocities of all four numbers of a "
      "quaternion, or none; leave these columns out with --columns ignore=NAME",
      in_quotes(column));
}

using GivenNumbers = spline::RotationNumbers<double>;

/// The entries of channels that have these sources, for as many channels as there were.
template <class T>
std::vector<T> selected(const std::vector<T>& entries, std::size_t channels, std::span<const std::size_t> sources) {
  std::vector<T> result;
  result.reserve(entries.size() / channels * sources.size());
  for (std::size_t first = 0; first < entries.size(); first += channels) {
    for (const std::size_t source : sources) result.push_back(entries[first + source]);
  }
  return result;
}

/// The numbers of keys as written, of channels that have these sources, where there were so many channels.
Texts selected_decimals(const KeyBlock& block, std::size_t channels, std::span<const std::size_t> sources) {
  Texts decimals;
  const std::size_t per_key = block.decimals.size() / block.size();
  for (std::size_t key = 0; key < block.decimals.size(); key += per_key) {
    decimals.append(block.decimals, key, key + NumberOfKey::position);
    for (std::size_t first = NumberOfKey::position; first < per_key; first += channels) {
      for (const std::size_t source : sources) decimals.add(block.decimals[key + first + source]);
    }
  }
  return decimals;
}

/// Gives a block a channel for each of these sources.
void select_channels(KeyBlock& block, std::span<const std::size_t> sources) {
  Keys& keys = block.keys;
  const std::size_t channels = std::exchange(keys.channels, sources.size());
  if (!keys.given.empty()) keys.given = selected(keys.given, channels, sources);
  if (block.empty()) return;
  if (keys.tcbs.size() > block.size()) keys.tcbs = selected(keys.tcbs, channels, sources);
  keys.positions = selected(keys.positions, channels, sources);
  keys.velocities = selected(keys.velocities, channels, sources);
  if (!block.decimals.empty()) block.decimals = selected_decimals(block, channels, sources);
}

/// Keeps the numbers of rotations as keys give them. Throws: Error (data) for velocities of these.
void keep_given(KeyBlock& block, std::span<const GivenRotation> rotations) {
  const std::size_t channels = block.keys.channels;
  const std::size_t decimals = block.decimals.empty() ? 0 : block.decimals.size() / block.size();
  for (const GivenRotation& given : rotations) {
    const auto has_velocity = [&](std::size_t channel) {
      return !block.keys.given.empty() && block.keys.given[channel];
    };
    if (std::ranges::any_of(given.channels, has_velocity)) throw velocities_of_part_of_rotation(given.columns[0]);
  }
  for (std::size_t key = 0; key < block.size(); ++key) {
    for (const GivenRotation& given : rotations) {
      GivenNumbers& numbers = block.rotations.numbers.emplace_back();
      for (std::size_t i = 0; i < numbers.size(); ++i) {
        const bool is_number = i < given.channels.size();
        if (is_number) numbers[i] = block.keys.positions[key * channels + given.channels[i]];
        if (decimals == 0) continue;
        const std::size_t index = key * decimals + NumberOfKey::position + (is_number ? given.channels[i] : 0);
        block.rotations.decimals.add(is_number ? block.decimals[index] : "");
      }
    }
  }
}

/// The rows of a matrix, divided by a power of two so that no square overflows.
class RowsOfMatrix {
 public:
  /// Requires: finite numbers.
  explicit RowsOfMatrix(GivenNumbers numbers) : numbers_(numbers) {
    double largest = 0;
    for (const double number : numbers_) largest = std::max(largest, std::abs(number));
    unit_ = spline::power_of_two_below(largest);
    for (double& number : numbers_) number /= unit_;
  }

  double determinant() const { return scaled_determinant() * unit_ * unit_ * unit_; }

  /// The determinant of the multiple of the matrix that has the sum of the squares of a rotation.
  double volume() const {
    double squares = 0;
    for (const double number : numbers_) squares += number * number;
    const double size = std::sqrt(squares / 3);
    return scaled_determinant() / (size * size * size);
  }

  /// How far a norm is from 1 or a cosine between two rows from 0, at most.
  double deviation() const {
    double largest = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t next = (i + 1) % 3;
      largest = std::max({largest, std::abs(norm(i) * unit_ - 1), std::abs(product(i, next)) / (norm(i) * norm(next))});
    }
    return largest;
  }

 private:
  double at(std::size_t row, std::size_t column) const { return numbers_[3 * (row % 3) + column % 3]; }
  double product(std::size_t a, std::size_t b) const {
    return at(a, 0) * at(b, 0) + at(a, 1) * at(b, 1) + at(a, 2) * at(b, 2);
  }
  double norm(std::size_t row) const { return std::sqrt(product(row, row)); }
  double scaled_determinant() const {
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      sum += at(0, i) * (at(1, i + 1) * at(2, i + 2) - at(1, i + 2) * at(2, i + 1));
    }
    return sum;
  }

  GivenNumbers numbers_;
  double unit_;
};

/// One rotation of successive keys that give it in another form.
class Conversion {
 public:
  /// `number`: among those that are converted.
  Conversion(std::size_t number, const RotationSchema& rotation, const TurnsOfKeys& all)
      : number_(number),
        channels_(rotation.columns.channels),
        turn_(rotation.columns.turn),
        given_(rotation.given),
        in_parent_(all.in_parent || rotation.given.in_parent),
        has_whole_turns_(all.curve == spline::RotationCurve::squad || all.curve == spline::RotationCurve::slerp) {}

  void convert(KeyBlock& block) {
    for (std::size_t key = 0; key < block.size(); ++key) convert_key(block, key);
  }

 private:
  void convert_key(KeyBlock& block, std::size_t key) {
    const std::uint64_t line = block.line(key);
    double* const positions = block.keys.positions.data() + key * block.keys.channels;
    const spline::RotationNotation& notation = given_.notation;
    const GivenNumbers& numbers =
        block.rotations.numbers[key * (block.rotations.numbers.size() / block.size()) + number_];
    const auto lacking = std::ranges::count_if(numbers, [](double number) { return std::isnan(number); });
    if (lacking == static_cast<std::ptrdiff_t>(notation.numbers())) {
      for (const std::size_t channel : channels_) positions[channel] = std::numeric_limits<double>::quiet_NaN();
      return;
    }
    if (lacking > 0) throw rotation_incomplete(given_.columns[0]).at({"", line, 0});
    check(numbers, line);
    spline::Quaternion<double> q = spline::quaternion_from(numbers, notation);
    if (given_.relative) {
      if (is_first_) {
        is_first_ = false;
      } else {
        set_turn(block, key, numbers, q);
      }
      q = before_ = spline::after_turn(before_, q, in_parent_);
    }
    positions[channels_[0]] = q.x;
    positions[channels_[1]] = q.y;
    positions[channels_[2]] = q.z;
    positions[channels_[3]] = q.w;
  }

  /// Keeps the turn from the key before where the two keys do not tell it. `q`: the same turn.
  void set_turn(KeyBlock& block, std::size_t key, const GivenNumbers& numbers,
                const spline::Quaternion<double>& q) const {
    const bool degrees = given_.notation.degrees;
    const double angle = numbers[3];
    const bool is_whole = std::abs(angle) >= spline::whole_turn<double>(degrees).hi;
    if (!is_whole && std::abs(q.w) > half_turn_rounding) return;
    if (is_whole && !has_whole_turns_)
      throw data_error(
          "the rotation that begins with {} makes whole turns, with an angle of {}; expected a curve that can make "
          "them; give --rotation-curve squad or slerp",
          in_quotes(given_.columns[0]), angle)
          .at({"", block.line(key), 0});
    block.keys.turns[key * block.keys.turns_per_key() + *turn_] =
        spline::turn_vector_from(numbers, degrees, before_, in_parent_);
  }

  void check(const GivenNumbers& numbers, std::uint64_t line) const {
    if (given_.notation.form == spline::RotationForm::matrix) return check_matrix(numbers, line);
    if (given_.notation.form == spline::RotationForm::rotation_vector) {
      double angle = spline::length_of_vector(numbers);
      if (std::isinf(angle)) angle = std::hypot(numbers[0], numbers[1], numbers[2]);  // its squares are too large
      return require_angle(angle, given_.notation.degrees, false, given_.columns[0], line);
    }
    const bool has_axis = given_.notation.form == spline::RotationForm::axis_angle;
    const std::span<const double> angles = std::span(numbers).subspan(has_axis ? 3 : 0, has_axis ? 1 : 3);
    for (const double angle : angles)
      require_angle(angle, given_.notation.degrees, given_.relative, given_.columns[0], line);
    const bool is_zero = std::ranges::all_of(numbers.begin(), numbers.begin() + 3, [](double n) { return n == 0; });
    if (has_axis && is_zero && numbers[3] != 0)
      throw data_error(
          "the rotation that begins with {} has an angle of {}, but an axis of zero; expected a direction; correct the "
          "axis",
          in_quotes(given_.columns[0]), numbers[3])
          .at({"", line, 0});
  }

  void check_matrix(const GivenNumbers& numbers, std::uint64_t line) const {
    const RowsOfMatrix rows(numbers);
    if (!(rows.volume() > 1e-6))
      throw data_error(
          "the matrix that begins with {} has the determinant {}, so it is not a rotation; expected 1; check its "
          "columns and their order, or give --rotation none for plain channels",
          in_quotes(given_.columns[0]), rows.determinant())
          .at({"", line, 0});
    if (given_.normalize || rows.deviation() <= 0.001) return;
    throw data_error(
        "the matrix that begins with {} deviates from an orthogonal one by {}; expected rows of the norm 1 at right "
        "angles, within 0.001; check its columns and their order, or give --normalize for the nearest rotation, or "
        "--rotation none for plain channels",
        in_quotes(given_.columns[0]), rows.deviation())
        .at({"", line, 0});
  }

  std::size_t number_;
  spline::RotationChannels channels_;
  std::optional<std::size_t> turn_;
  GivenRotation given_;
  bool in_parent_, has_whole_turns_;
  bool is_first_ = true;
  spline::Quaternion<double> before_{0, 0, 0, 1};
};

/// One angle of successive keys.
class AngleChain {
 public:
  AngleChain(const AngleColumn& angle, std::string name) : angle_(angle), name_(std::move(name)) {}

  void add(const KeyBlock& block) {
    for (std::size_t key = 0; key < block.size(); ++key) {
      const double value = block.keys.position(key)[angle_.channel];
      const std::uint64_t line = block.line(key);
      if (std::isnan(value))
        throw data_error(
            "the angle {} is missing; expected a number at every key; fill it in, or give --missing skip-row or break",
            in_quotes(name_))
            .at({"", line, 0});
      require_angle(value, angle_.degrees, false, name_, line);
      if (line_ == 0) std::tie(first_, first_line_) = std::tie(value, line);
      require_turn(value, line, line_);
      std::tie(before_, line_) = std::tie(value, line);
    }
  }

  /// Checks the turn from the last key to the first one.
  void close() const { require_turn(first_, line_, first_line_); }

 private:
  /// Throws: Error (data), at a line, for half a turn from the last key to another one.
  void require_turn(double value, std::uint64_t line, std::uint64_t other) const {
    if (line_ == 0) return;
    const double half = spline::whole_turn<double>(angle_.degrees).hi / 2;
    const spline::DoubleDouble chord = spline::exact_difference(value, before_);
    const auto rest = chord - spline::nearest_turns<double>(chord, angle_.degrees);
    const bool is_half_turn = std::abs(std::abs(rest.hi) - half) <= half * 0x1p-50;
    if (is_half_turn)
      throw data_error(
          "the angle {} is exactly half a turn from the angle on line {}, so its direction is undefined; expected a "
          "smaller difference; add a key between them",
          in_quotes(name_), other)
          .at({"", line, 0});
  }

  AngleColumn angle_;
  std::string name_;
  double before_ = 0, first_ = 0;  ///< of the last key, and of the first one
  std::uint64_t line_ = 0;         ///< of the last one; 0: there is none
  std::uint64_t first_line_ = 0;
};

using Numbers = std::array<double, 4>;

double dot(const Numbers& a, const Numbers& b) { return (a[0] * b[0] + a[1] * b[1]) + (a[2] * b[2] + a[3] * b[3]); }

/// One rotation of successive keys.
class SignChain {
 public:
  SignChain(const RotationSchema& rotation, spline::RotationCurve curve)
      : channels_(rotation.columns.channels),
        turn_(rotation.columns.turn),
        name_(rotation.given.columns[0]),
        is_quaternion_(rotation.given.notation.is_quaternion()),
        normalize_(rotation.given.normalize),
        has_tangents_(curve != spline::RotationCurve::slerp) {}

  /// Checks the keys of a block, and negates its quaternions where the one before needs it.
  void add(KeyBlock& block) {
    const auto has_velocity = [&](std::size_t channel) {
      return !block.keys.given.empty() && block.keys.given[channel];
    };
    const auto velocities = std::ranges::count_if(channels_, has_velocity);
    if (velocities > 0 && velocities < 4) throw velocities_of_part_of_rotation(name_);
    if (velocities > 0 && !has_tangents_)
      throw data_error(
          "the rotation that begins with {} has velocities, which the curve slerp does not use; expected another "
          "curve; give --rotation-curve squad, or leave the columns out with --columns ignore=NAME",
          in_quotes(name_));
    std::vector<bool> negated(block.size());
    for (std::size_t key = 0; key < block.size(); ++key) negated[key] = add_key(block, key);
    if (is_quaternion_ && std::ranges::count(negated, true) > 0) negate_decimals(block, negated);
  }

  /// Checks the turn from the last key to the first one.
  void close() const {
    if (line_ != 0) (void)cosine_to(first_, line_, first_line_);
  }

 private:
  /// The cosine of half the turn from the last key to another one.
  double cosine_to(const Numbers& q, std::uint64_t line, std::uint64_t other) const {
    const double cosine = dot(before_, q);
    if (std::abs(cosine) <= half_turn_rounding)
      throw data_error(
          "the rotation that begins with {} is exactly 180 degrees from the rotation on line {}, so its axis is "
          "undefined; expected a smaller angle; add a key between them",
          in_quotes(name_), other)
          .at({"", line, 0});
    return cosine;
  }

  double checked_norm(const Numbers& q, std::uint64_t line) const {
    const double largest = std::abs(*std::ranges::max_element(q, {}, [](double number) { return std::abs(number); }));
    if (largest == 0)
      throw data_error(
          "the quaternion that begins with {} is zero, so it is not a rotation; expected the norm 1; correct it, or "
          "give --rotation none for plain channels",
          in_quotes(name_))
          .at({"", line, 0});
    Numbers scaled = q;
    for (double& number : scaled) number /= largest;
    const double norm = largest * std::sqrt(dot(scaled, scaled));
    const bool is_unit = norm >= 0.999 && norm <= 1.001;
    if (!is_unit && !normalize_)
      throw data_error(
          "the quaternion that begins with {} has the norm {}; expected 1, within 0.001; check its columns and their "
          "order, or give --normalize to divide by the norm, or --rotation none for plain channels",
          in_quotes(name_), norm)
          .at({"", line, 0});
    return norm;
  }

  /// Whether the quaternion of a key was negated.
  bool add_key(KeyBlock& block, std::size_t key) {
    const std::uint64_t line = block.line(key);
    double* const positions = block.keys.positions.data() + key * block.keys.channels;
    Numbers q{};
    for (std::size_t i = 0; i < q.size(); ++i) q[i] = positions[channels_[i]];
    const auto missing = std::ranges::count_if(q, [](double number) { return std::isnan(number); });
    if (missing == 4) return false;
    if (missing > 0) throw rotation_incomplete(name_).at({"", line, 0});
    const double norm = checked_norm(q, line);
    for (double& number : q) number /= norm;
    if (line_ != 0 && turn_) turn_before(block.keys.turns[key * block.keys.turns_per_key() + *turn_]);
    const double cosine = line_ == 0 ? 1 : cosine_to(q, line, line_);
    if (line_ == 0) std::tie(first_, first_line_) = std::tie(q, line);
    std::tie(before_, line_) = std::tie(q, line);
    if (cosine > 0) return false;
    for (const std::size_t channel : channels_) {
      positions[channel] = 0 - positions[channel];  // 0 stays without a sign
      if (block.keys.velocities.empty()) continue;
      spline::Velocity<double>& velocity = block.keys.velocities[key * block.keys.channels + channel];
      velocity = {-velocity.in, -velocity.out};
    }
    for (double& number : before_) number = -number;
    return true;
  }

  void turn_before(const spline::TurnVector<double>& turn) {
    const auto [x, y, z, w] =
        spline::Quaternion<double>{before_[0], before_[1], before_[2], before_[3]} * spline::exponential(turn);
    before_ = {x, y, z, w};
  }

  /// Whether a number of a key is negated with the quaternion.
  bool has_sign(std::size_t number, std::size_t channels) const {
    if (number < NumberOfKey::position) return false;
    const std::size_t kind = (number - NumberOfKey::position) / channels;
    const bool is_signed =
        kind == NumberOfKey::position_of || kind == NumberOfKey::velocity_in_of || kind == NumberOfKey::velocity_out_of;
    return is_signed && std::ranges::count(channels_, (number - NumberOfKey::position) % channels) > 0;
  }

  void negate_decimals(KeyBlock& block, const std::vector<bool>& negated) const {
    block.rewrite_decimals([&](std::size_t key, std::size_t number, std::string_view text) {
      if (!negated[key] || !has_sign(number, block.keys.channels) || text.empty()) return std::string(text);
      if (text.starts_with('-')) return std::string(text.substr(1));
      return "-" + std::string(text.starts_with('+') ? text.substr(1) : text);
    });
  }

  spline::RotationChannels channels_;
  std::optional<std::size_t> turn_;
  std::string name_;
  bool is_quaternion_, normalize_, has_tangents_;
  Numbers before_{}, first_{};  ///< of the last key with this rotation, and of the first one
  std::uint64_t line_ = 0;      ///< of the last one; 0: there is none
  std::uint64_t first_line_ = 0;
};

/// The keys with the quaternions of rotations that they give in another form.
Source<KeyBlock> with_converted_rotations(Source<KeyBlock> blocks, const TurnsOfKeys& turns) {
  std::vector<GivenRotation> given;
  auto conversions = std::make_shared<std::vector<Conversion>>();
  for (const RotationSchema& rotation : turns.rotations) {
    if (rotation.given.notation.is_quaternion()) continue;
    conversions->emplace_back(conversions->size(), rotation, turns);
    given.push_back(rotation.given);
  }
  if (given.empty()) return blocks;
  const auto relative = static_cast<std::size_t>(std::ranges::count_if(
      turns.rotations, [](const RotationSchema& rotation) { return rotation.columns.turn.has_value(); }));
  const auto convert = [given, conversions, relative, sources = turns.sources](KeyBlock block) {
    keep_given(block, given);
    if (!sources.empty()) select_channels(block, sources);
    block.keys.turns.resize(relative * block.size());
    for (Conversion& conversion : *conversions) conversion.convert(block);
    return block;
  };
  return mapped(std::move(blocks), convert);
}

}  // namespace

std::vector<ConvertedRotation> converted_rotations(const TurnsOfKeys& turns) {
  std::vector<ConvertedRotation> converted;
  for (const auto& [columns, given, names] : turns.rotations) {
    if (given.notation.is_quaternion()) continue;
    converted.push_back({columns, given.notation, given.relative, turns.in_parent || given.in_parent});
  }
  return converted;
}

Source<KeyBlock> with_clear_turns(Source<KeyBlock> blocks, const TurnsOfKeys& turns) {
  if (turns.rotations.empty() && turns.angles.empty()) return blocks;
  std::vector<SignChain> rotations;
  for (const RotationSchema& rotation : turns.rotations) rotations.emplace_back(rotation, turns.curve);
  std::vector<AngleChain> angles;
  for (const AngleColumn& angle : turns.angles) angles.emplace_back(angle, turns.channels[angle.channel]);
  return [blocks = with_converted_rotations(std::move(blocks), turns), rotations = std::move(rotations),
          angles = std::move(angles), closed = turns.closed]() mutable {
    std::optional<KeyBlock> block = blocks();
    const auto pass = [&](auto& chains) {
      for (auto& chain : chains) {
        if (block) chain.add(*block);
        if (!block && closed) chain.close();
      }
    };
    pass(rotations);
    pass(angles);
    return block;
  };
}

}  // namespace tcb
