// Allowances: how far given numbers may be off by rounding, printing and single precision.
#include "check/allowances.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "numbers/parse_number.hpp"
#include "sample/fields.hpp"

namespace tcb {
namespace {

/// The shortest decimal of a number: how many digits it has, and the powers of ten of the first and the last.
struct Decimal {
  int digits = 0, first = 0, last = 0;
};

Decimal decimal_of(double value) {
  std::array<char, 32> text{};
  const char* const end =
      std::to_chars(text.data(), text.data() + text.size(), std::abs(value), std::chars_format::scientific).ptr;
  const char* const exponent = std::find<const char*>(text.data(), end, 'e');
  Decimal decimal;
  decimal.digits = static_cast<int>(std::count_if<const char*>(text.data(), exponent, [](char c) { return c != '.'; }));
  const char* const digits = exponent + 1 + (exponent[1] == '+' ? 1 : 0);
  (void)std::from_chars(digits, end, decimal.first);
  decimal.last = decimal.first - decimal.digits + 1;
  return decimal;
}

/// The numbers of one column, over all curves.
std::vector<double> numbers_of(const std::vector<GivenSamples>& samples, const MatchedColumn& column) {
  std::vector<double> numbers;
  for (const GivenSamples& sample : samples) {
    for (std::size_t row = 0; row < sample.rows.size(); ++row) numbers.push_back(sample.rows.row(row)[column.given]);
  }
  return numbers;
}

/// The largest size of the keys' numbers in a cell; of a rotation, at most that of a number of a quaternion.
double largest_position(const KeptInput& kept, const PositionCell& cell) {
  if (cell.rotation != PositionCell::none) return cell.channel == PositionCell::none ? 0 : 1;
  double largest = 0;
  for (const KeptKeys& curve : kept.curves) {
    for (const KeyBlock& block : curve.blocks) {
      for (std::size_t key = 0; key < block.size(); ++key) {
        const double position = std::abs(block.keys.positions[key * block.keys.channels + cell.channel]);
        if (position > largest) largest = position;
      }
    }
  }
  return largest;
}

}  // namespace

std::vector<Allowance> allowances(std::span<const double> column, double size) {
  constexpr int most_printed = 15, most_single = 9;
  int digits = 0, last = std::numeric_limits<int>::max();
  bool single = true;
  for (const double value : column) {
    if (!std::isfinite(value)) continue;
    size = std::max(size, std::abs(value));
    single = single && static_cast<double>(static_cast<float>(value)) == value;
    if (value == 0) continue;
    const Decimal decimal = decimal_of(value);
    digits = std::max(digits, decimal.digits);
    last = std::min(last, decimal.last);
  }
  const double rounding = std::ldexp(size, -40);
  const double coarse = single || digits <= most_single ? std::ldexp(size, -20) : rounding;
  std::vector<Allowance> result;
  for (const double value : column) {
    const bool printed = digits > 0 && digits <= most_printed && std::isfinite(value);
    const int unit = value == 0 ? last : std::max(last, decimal_of(value).first - digits + 1);
    const double step = printed ? parse_number("1e" + std::to_string(unit)).value_or(0) : 0;
    result.push_back({rounding, std::max(coarse, step + rounding)});
  }
  return result;
}

std::vector<GivenSamples> samples_of(std::vector<Pair> pairs, const ComparisonInputs& inputs) {
  const std::size_t width = inputs.columns.compared.size();
  const Schema& keys = inputs.kept.schema;
  const std::vector<PositionCell> cells = position_cells(keys.channels.size(), rotation_columns(keys));
  std::vector<GivenSamples> samples;
  for (Pair& pair : pairs) {
    GivenSamples& sample = samples.emplace_back(GivenSamples{pair.curve, std::move(pair.rows), {}});
    sample.allowances.resize(sample.rows.size() * width);
  }
  for (std::size_t i = 0; i < width; ++i) {
    const MatchedColumn& column = inputs.columns.compared[i];
    const auto allowed = allowances(numbers_of(samples, column), largest_position(inputs.kept, cells[column.computed]));
    std::size_t next = 0;
    for (GivenSamples& sample : samples) {
      for (std::size_t row = 0; row < sample.rows.size(); ++row) sample.allowances[row * width + i] = allowed[next++];
    }
  }
  return samples;
}

}  // namespace tcb
