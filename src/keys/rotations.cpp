// Rotations among keys: checks of quaternions, and their signs.
#include "keys/rotations.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <tuple>
#include <utility>

#include "keys/angles.hpp"
#include "keys/errors.hpp"
#include "tcb/spline/rotation.hpp"

namespace tcb {
namespace {

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
    if (velocities > 0 && !has_tangents_) throw velocities_with_slerp(name_);
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
    if (std::abs(cosine) <= half_turn_rounding) throw half_turn_between_rotations(name_, other).at({"", line, 0});
    return cosine;
  }

  double checked_norm(const Numbers& q, std::uint64_t line) const {
    const double largest = std::abs(*std::ranges::max_element(q, {}, [](double number) { return std::abs(number); }));
    if (largest == 0) throw quaternion_is_zero(name_).at({"", line, 0});
    Numbers scaled = q;
    for (double& number : scaled) number /= largest;
    const double norm = largest * std::sqrt(dot(scaled, scaled));
    const bool is_unit = norm >= 0.999 && norm <= 1.001;
    if (!is_unit && !normalize_) throw quaternion_not_unit(name_, norm).at({"", line, 0});
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
    const std::size_t per_key = block.decimals.size() / block.size();
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

Source<KeyBlock> with_quaternions(Source<KeyBlock> blocks, const RotationsOfKeys& rotations) {
  if (rotations.rotations.empty()) return blocks;
  auto chains = std::make_shared<std::vector<SignChain>>();
  for (const RotationSchema& rotation : rotations.rotations) chains->emplace_back(rotation, rotations.curve);
  blocks = mapped(with_converted_rotations(std::move(blocks), rotations), [chains](KeyBlock block) {
    for (SignChain& chain : *chains) chain.add(block);
    return block;
  });
  return rotations.closed ? with_checked_seam(std::move(blocks), std::move(chains)) : blocks;
}

}  // namespace tcb
