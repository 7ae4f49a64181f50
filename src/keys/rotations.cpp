// Rotations among keys: the checks of quaternions, and their signs.
#include "keys/rotations.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>

#include "error.hpp"

namespace tcb {
namespace {

using Numbers = std::array<double, 4>;

double dot(const Numbers& a, const Numbers& b) { return (a[0] * b[0] + a[1] * b[1]) + (a[2] * b[2] + a[3] * b[3]); }

/// One rotation of successive keys.
class SignChain {
 public:
  SignChain(const spline::RotationChannels& channels, std::string name, bool normalize)
      : channels_(channels), name_(std::move(name)), normalize_(normalize) {}

  /// Checks the keys of a block, and negates its quaternions where the one before needs it.
  void add(KeyBlock& block) {
    std::vector<bool> negated(block.size());
    for (std::size_t key = 0; key < block.size(); ++key) negated[key] = add_key(block, key);
    if (!block.decimals.empty() && std::ranges::count(negated, true) > 0) negate_decimals(block, negated);
  }

 private:
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
    constexpr double rounding = 0x1p-50;
    const double cosine = line_ == 0 ? 1 : dot(before_, q);
    if (std::abs(cosine) <= rounding) refuse(ErrorCode::half_turn_between_keys, line, {name_, line_});
    before_ = q;
    line_ = line;
    if (cosine > 0) return false;
    for (const std::size_t channel : channels_) positions[channel] = 0 - positions[channel];  // 0 stays without a sign
    for (double& number : before_) number = -number;
    return true;
  }

  void negate_decimals(KeyBlock& block, const std::vector<bool>& negated) const {
    const std::size_t per_key = block.decimals.size() / block.lines.size();
    Texts decimals;
    for (std::size_t i = 0; i < block.decimals.size(); ++i) {
      const std::size_t number = i % per_key;
      const bool changes = negated[i / per_key] && number >= NumberOfKey::position &&
                           std::ranges::count(channels_, number - NumberOfKey::position) > 0;
      const std::string_view text = block.decimals[i];
      if (!changes || text.empty()) {
        decimals.add(text);
      } else if (text.starts_with('-')) {
        decimals.add(text.substr(1));
      } else {
        decimals.add("-" + std::string(text.starts_with('+') ? text.substr(1) : text));
      }
    }
    block.decimals = std::move(decimals);
  }

  [[noreturn]] static void refuse(ErrorCode code, std::uint64_t line, std::vector<ErrorValue> values) {
    throw Error(Exit::data, code, std::move(values)).at({"", line, 0});
  }

  spline::RotationChannels channels_;
  std::string name_;
  bool normalize_;
  Numbers before_{};
  std::uint64_t line_ = 0;  ///< of the last key with this rotation; 0: there is none
};

}  // namespace

Source<KeyBlock> with_continuous_signs(Source<KeyBlock> blocks, const std::vector<spline::RotationChannels>& rotations,
                                       const std::vector<std::string>& channels, bool normalize) {
  if (rotations.empty()) return blocks;
  auto chains = std::make_shared<std::vector<SignChain>>();
  for (const auto& rotation : rotations) chains->emplace_back(rotation, channels[rotation[0]], normalize);
  return mapped(std::move(blocks), [chains](KeyBlock block) {
    for (SignChain& chain : *chains) chain.add(block);
    return block;
  });
}

}  // namespace tcb
