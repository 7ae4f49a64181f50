// Rotations among keys: quaternions from other forms, their checks, and their signs.
#include "keys/rotations.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <tuple>
#include <utility>

#include "error.hpp"
#include "keys/angles.hpp"
#include "tcb/spline/detail/rotation_notation.hpp"

namespace tcb {
namespace {

using Numbers = std::array<double, 4>;

constexpr double half_turn_rounding = 0x1p-50;  // of the cosine of half the angle

double dot(const Numbers& a, const Numbers& b) { return (a[0] * b[0] + a[1] * b[1]) + (a[2] * b[2] + a[3] * b[3]); }

/// Inserts one entry after every `stride` entries.
template <class T>
void widen(std::vector<T>& entries, std::size_t stride, const T& inserted) {
  std::vector<T> wider;
  wider.reserve(entries.size() / stride * (stride + 1));
  for (std::size_t i = 0; i < entries.size(); ++i) {
    wider.push_back(entries[i]);
    if ((i + 1) % stride == 0) wider.push_back(inserted);
  }
  entries = std::move(wider);
}

/// Gives a block one channel more, without positions.
void add_channel(KeyBlock& block) {
  Keys& keys = block.keys;
  const std::size_t channels = keys.channels;
  if (keys.has_channel_tcbs()) widen(keys.tcbs, channels, keys.common_tcb);
  widen(keys.positions, channels, 0.0);
  if (!keys.velocities.empty()) {
    widen(keys.velocities, channels, {});
    keys.given.push_back(false);
  }
  Texts decimals;
  const std::size_t per_key = block.empty() ? 0 : block.decimals.size() / block.size();
  for (std::size_t i = 0; i < block.decimals.size(); ++i) {
    const std::size_t number = i % per_key;
    decimals.add(block.decimals[i]);
    if (number >= NumberOfKey::position && (number - NumberOfKey::position + 1) % channels == 0) decimals.add("");
  }
  block.decimals = std::move(decimals);
  ++keys.channels;
}

/// One rotation of successive keys that give it in another form.
class Conversion {
 public:
  /// `number`: among those that are converted.
  Conversion(std::size_t number, const spline::RotationColumns& rotation, const GivenRotation& given,
             const RotationsOfKeys& all)
      : number_(number),
        channels_(rotation.channels),
        turn_(rotation.turn),
        given_(given),
        in_parent_(all.in_parent),
        has_whole_turns_(all.curve == spline::RotationCurve::squad || all.curve == spline::RotationCurve::slerp) {}

  void convert(KeyBlock& block) {
    for (std::size_t key = 0; key < block.size(); ++key) convert_key(block, key);
  }

 private:
  void convert_key(KeyBlock& block, std::size_t key) {
    const std::uint64_t line = block.lines[key];
    double* const positions = block.keys.positions.data() + key * block.keys.channels;
    const spline::RotationNotation& notation = given_.notation;
    Numbers numbers{};
    for (std::size_t i = 0; i < notation.numbers(); ++i) numbers[i] = positions[channels_[i]];
    block.given_rotations[key * (block.given_rotations.size() / block.size()) + number_] = numbers;
    const auto lacking = std::ranges::count_if(numbers, [](double number) { return std::isnan(number); });
    if (lacking == static_cast<std::ptrdiff_t>(notation.numbers())) {
      positions[channels_[3]] = std::numeric_limits<double>::quiet_NaN();
      return;
    }
    if (lacking > 0) refuse(ErrorCode::rotation_incomplete, line, {given_.columns[0]});
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
  void set_turn(KeyBlock& block, std::size_t key, const Numbers& numbers, const spline::Quaternion<double>& q) const {
    const bool degrees = given_.notation.degrees;
    const double angle = numbers[3];
    const bool is_whole = std::abs(angle) >= spline::whole_turn<double>(degrees).hi;
    if (!is_whole && std::abs(q.w) > half_turn_rounding) return;
    if (is_whole && !has_whole_turns_) refuse(ErrorCode::whole_turns, block.lines[key], {given_.columns[0], angle});
    block.keys.turns[key * block.keys.turns_per_key() + *turn_] =
        spline::turn_vector_from(numbers, degrees, before_, in_parent_);
  }

  void check(const Numbers& numbers, std::uint64_t line) const {
    const bool has_axis = given_.notation.form == spline::RotationForm::axis_angle;
    const std::span<const double> angles = std::span(numbers).subspan(has_axis ? 3 : 0, has_axis ? 1 : 3);
    for (const double angle : angles)
      require_angle(angle, given_.notation.degrees, given_.relative, given_.columns[0], line);
    const bool is_zero = std::ranges::all_of(numbers.begin(), numbers.begin() + 3, [](double n) { return n == 0; });
    if (has_axis && is_zero && numbers[3] != 0) refuse(ErrorCode::axis_zero, line, {given_.columns[0], numbers[3]});
  }

  std::size_t number_;
  spline::RotationChannels channels_;
  std::optional<std::size_t> turn_;
  GivenRotation given_;
  bool in_parent_, has_whole_turns_;
  bool is_first_ = true;
  spline::Quaternion<double> before_{0, 0, 0, 1};
};

/// One rotation of successive keys.
class SignChain {
 public:
  SignChain(const spline::RotationColumns& rotation, const GivenRotation& given, const RotationsOfKeys& all)
      : channels_(rotation.channels),
        turn_(rotation.turn),
        name_(given.columns[0]),
        is_quaternion_(given.notation.form == spline::RotationForm::quaternion),
        normalize_(all.normalize),
        has_tangents_(all.curve != spline::RotationCurve::slerp) {}

  /// Checks the keys of a block, and negates its quaternions where the one before needs it.
  void add(KeyBlock& block) {
    const auto has_velocity = [&](std::size_t channel) {
      return !block.keys.given.empty() && block.keys.given[channel];
    };
    const auto velocities = std::ranges::count_if(channels_, has_velocity);
    if (velocities > 0 && (velocities < 4 || !is_quaternion_)) {
      throw Error(Exit::data, ErrorCode::velocity_of_rotation, {name_});
    }
    if (velocities > 0 && !has_tangents_) throw Error(Exit::data, ErrorCode::velocity_with_slerp, {name_});
    std::vector<bool> negated(block.size());
    for (std::size_t key = 0; key < block.size(); ++key) negated[key] = add_key(block, key);
    if (is_quaternion_ && !block.decimals.empty() && std::ranges::count(negated, true) > 0)
      negate_decimals(block, negated);
  }

  /// Checks the turn from the last key to the first one.
  void close() const {
    if (line_ != 0) (void)cosine_to(first_, line_, first_line_);
  }

 private:
  /// The cosine of half the turn from the last key to another one.
  double cosine_to(const Numbers& q, std::uint64_t line, std::uint64_t other) const {
    const double cosine = dot(before_, q);
    if (std::abs(cosine) <= half_turn_rounding) refuse(ErrorCode::half_turn_between_keys, line, {name_, other});
    return cosine;
  }

  double checked_norm(const Numbers& q, std::uint64_t line) const {
    const double largest = std::abs(*std::ranges::max_element(q, {}, [](double number) { return std::abs(number); }));
    if (largest == 0) refuse(ErrorCode::rotation_zero, line, {name_});
    Numbers scaled = q;
    for (double& number : scaled) number /= largest;
    const double norm = largest * std::sqrt(dot(scaled, scaled));
    const bool is_unit = norm >= 0.999 && norm <= 1.001;
    if (!is_unit && !normalize_) refuse(ErrorCode::rotation_not_unit, line, {name_, norm});
    return norm;
  }

  /// Whether the quaternion of a key was negated.
  bool add_key(KeyBlock& block, std::size_t key) {
    const std::uint64_t line = block.lines[key];
    double* const positions = block.keys.positions.data() + key * block.keys.channels;
    Numbers q{};
    for (std::size_t i = 0; i < q.size(); ++i) q[i] = positions[channels_[i]];
    const auto missing = std::ranges::count_if(q, [](double number) { return std::isnan(number); });
    if (missing == 4) return false;
    if (missing > 0) refuse(ErrorCode::rotation_incomplete, line, {name_});
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
    const std::size_t per_key = block.decimals.size() / block.lines.size();
    Texts decimals;
    for (std::size_t i = 0; i < block.decimals.size(); ++i) {
      const std::size_t number = i % per_key;
      const std::string_view text = block.decimals[i];
      if (!negated[i / per_key] || !has_sign(number, block.keys.channels) || text.empty()) {
        decimals.add(text);
      } else if (text.starts_with('-')) {
        decimals.add(text.substr(1));
      } else {
        decimals.add("-" + std::string(text.starts_with('+') ? text.substr(1) : text));
      }
    }
    block.decimals = std::move(decimals);
  }

  spline::RotationChannels channels_;
  std::optional<std::size_t> turn_;
  std::string name_;
  bool is_quaternion_, normalize_, has_tangents_;
  Numbers before_{}, first_{};  ///< of the last key with this rotation, and of the first one
  std::uint64_t line_ = 0;      ///< of the last one; 0: there is none
  std::uint64_t first_line_ = 0;
};

}  // namespace

std::vector<ConvertedRotation> converted_rotations(const RotationsOfKeys& rotations) {
  std::vector<ConvertedRotation> converted;
  for (std::size_t i = 0; i < rotations.columns.size(); ++i) {
    const auto& [notation, relative, columns] = rotations.given[i];
    if (notation.form == spline::RotationForm::quaternion) continue;
    converted.push_back({rotations.columns[i], notation, relative, rotations.in_parent});
  }
  return converted;
}

Source<KeyBlock> with_quaternions(Source<KeyBlock> blocks, const RotationsOfKeys& rotations) {
  if (rotations.columns.empty()) return blocks;
  auto conversions = std::make_shared<std::vector<Conversion>>();
  auto chains = std::make_shared<std::vector<SignChain>>();
  for (std::size_t i = 0; i < rotations.columns.size(); ++i) {
    const spline::RotationColumns& columns = rotations.columns[i];
    const GivenRotation& given = rotations.given[i];
    if (given.notation.form != spline::RotationForm::quaternion) {
      conversions->emplace_back(conversions->size(), columns, given, rotations);
    }
    chains->emplace_back(columns, given, rotations);
  }
  const auto turns = static_cast<std::size_t>(std::ranges::count_if(
      rotations.columns, [](const spline::RotationColumns& columns) { return columns.turn.has_value(); }));
  blocks = mapped(std::move(blocks), [conversions, chains, turns, channels = rotations.channels](KeyBlock block) {
    while (block.keys.channels < channels) add_channel(block);
    block.keys.turns.resize(turns * block.size());
    block.given_rotations.resize(conversions->size() * block.size());
    for (Conversion& conversion : *conversions) conversion.convert(block);
    for (SignChain& chain : *chains) chain.add(block);
    return block;
  });
  return rotations.closed ? with_checked_seam(std::move(blocks), std::move(chains)) : blocks;
}

}  // namespace tcb
