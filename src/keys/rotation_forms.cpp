// Rotations of keys in other forms than quaternions: their checks, and their quaternions.
#include "keys/rotation_forms.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "keys/angles.hpp"
#include "keys/errors.hpp"
#include "tcb/spline/rotation_notation.hpp"

namespace tcb {
namespace {

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
  Conversion(std::size_t number, const RotationSchema& rotation, const RotationsOfKeys& all)
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
      throw whole_turns_of_rotation(given_.columns[0], angle).at({"", block.line(key), 0});
    block.keys.turns[key * block.keys.turns_per_key() + *turn_] =
        spline::turn_vector_from(numbers, degrees, before_, in_parent_);
  }

  void check(const GivenNumbers& numbers, std::uint64_t line) const {
    if (given_.notation.form == spline::RotationForm::matrix) return check_matrix(numbers, line);
    const bool has_axis = given_.notation.form == spline::RotationForm::axis_angle;
    const std::span<const double> angles = std::span(numbers).subspan(has_axis ? 3 : 0, has_axis ? 1 : 3);
    for (const double angle : angles)
      require_angle(angle, given_.notation.degrees, given_.relative, given_.columns[0], line);
    const bool is_zero = std::ranges::all_of(numbers.begin(), numbers.begin() + 3, [](double n) { return n == 0; });
    if (has_axis && is_zero && numbers[3] != 0) throw axis_is_zero(given_.columns[0], numbers[3]).at({"", line, 0});
  }

  void check_matrix(const GivenNumbers& numbers, std::uint64_t line) const {
    const RowsOfMatrix rows(numbers);
    if (!(rows.volume() > 1e-6)) throw matrix_not_a_rotation(given_.columns[0], rows.determinant()).at({"", line, 0});
    if (given_.normalize || rows.deviation() <= 0.001) return;
    throw matrix_not_orthogonal(given_.columns[0], rows.deviation()).at({"", line, 0});
  }

  std::size_t number_;
  spline::RotationChannels channels_;
  std::optional<std::size_t> turn_;
  GivenRotation given_;
  bool in_parent_, has_whole_turns_;
  bool is_first_ = true;
  spline::Quaternion<double> before_{0, 0, 0, 1};
};

}  // namespace

std::vector<ConvertedRotation> converted_rotations(const RotationsOfKeys& rotations) {
  std::vector<ConvertedRotation> converted;
  for (const auto& [columns, given, names] : rotations.rotations) {
    if (given.notation.is_quaternion()) continue;
    converted.push_back({columns, given.notation, given.relative, rotations.in_parent || given.in_parent});
  }
  return converted;
}

Source<KeyBlock> with_converted_rotations(Source<KeyBlock> blocks, const RotationsOfKeys& rotations) {
  std::vector<GivenRotation> given;
  auto conversions = std::make_shared<std::vector<Conversion>>();
  for (const RotationSchema& rotation : rotations.rotations) {
    if (rotation.given.notation.is_quaternion()) continue;
    conversions->emplace_back(conversions->size(), rotation, rotations);
    given.push_back(rotation.given);
  }
  if (given.empty()) return blocks;
  const auto turns = static_cast<std::size_t>(std::ranges::count_if(
      rotations.rotations, [](const RotationSchema& rotation) { return rotation.columns.turn.has_value(); }));
  const auto convert = [given, conversions, turns, sources = rotations.sources](KeyBlock block) {
    keep_given(block, given);
    if (!sources.empty()) select_channels(block, sources);
    block.keys.turns.resize(turns * block.size());
    for (Conversion& conversion : *conversions) conversion.convert(block);
    return block;
  };
  return mapped(std::move(blocks), convert);
}

}  // namespace tcb
