// Precision: the errors of rounding and printing, and the choice of rows that represent many.
#include "check/precision.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "numbers/parse_number.hpp"
#include "sample/fields.hpp"

namespace tcb {
namespace {

constexpr std::size_t most_rows = 1000, most_keys = 256;

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

void append_row(GivenSamples& to, const GivenSamples& from, std::size_t row) {
  to.rows.add(from.rows, row);
  to.numbers.push_back(from.numbers[row]);
  const std::size_t width = from.allowances.size() / from.rows.size();
  const std::span allowances = std::span(from.allowances).subspan(row * width, width);
  to.allowances.insert(to.allowances.end(), allowances.begin(), allowances.end());
}

KeptKeys beginning_of(const KeptKeys& curve) {
  KeptKeys cut{curve.group, curve.curve_info, {}};
  std::size_t left = most_keys;
  for (const KeyBlock& block : curve.blocks) {
    if (left == 0) break;
    const std::size_t count = std::min(left, block.size());
    cut.blocks.push_back(block.range(0, count));
    left -= count;
  }
  return cut;
}

/// The time of the key with this number, counted from the last key as 1, or of the first key.
spline::Time<double> time_from_end(const KeptKeys& curve, std::size_t number) {
  auto block = curve.blocks.rbegin();
  for (; std::next(block) != curve.blocks.rend() && block->size() < number; ++block) number -= block->size();
  return block->keys.times[block->size() - std::min(block->size(), number)];
}

/// The rows on the beginning of a curve, as far as later keys do not affect it.
GivenSamples on_beginning(const GivenSamples& sample, const KeptKeys& beginning) {
  const spline::Time<double> end = time_from_end(beginning, 3);
  GivenSamples before{&beginning, {}, {}, {}};
  for (std::size_t row = 0; row < sample.rows.size(); ++row) {
    if (!(sample.rows.times[row] > end)) append_row(before, sample, row);
  }
  return before;
}

/// Keeps `kept` of `rows` rows, evenly spread.
void thin_out(std::vector<GivenSamples>& samples, std::uint64_t rows, std::uint64_t kept) {
  std::uint64_t number = 0;
  for (GivenSamples& sample : samples) {
    GivenSamples thin{sample.curve, {}, {}, {}};
    for (std::size_t row = 0; row < sample.rows.size(); ++row, ++number) {
      if (number * kept / rows != (number + 1) * kept / rows) append_row(thin, sample, row);
    }
    sample = std::move(thin);
  }
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
  const double coarse = single || digits <= most_single ? std::ldexp(size, -20) : 0;
  std::vector<Allowance> result;
  for (const double value : column) {
    const bool printed = digits > 0 && digits <= most_printed && std::isfinite(value);
    const int unit = value == 0 ? last : std::max(last, decimal_of(value).first - digits + 1);
    const double step = printed ? parse_number("1e" + std::to_string(unit)).value_or(0) : 0;
    result.push_back({rounding, printed ? step + rounding : 0, coarse == 0 ? 0 : std::max(coarse, step + rounding)});
  }
  return result;
}

std::uint64_t count_rows(const std::vector<GivenSamples>& samples) {
  std::uint64_t rows = 0;
  for (const GivenSamples& sample : samples) rows += sample.rows.size();
  return rows;
}

std::vector<GivenSamples> samples_of(std::vector<Pair> pairs, const ComparisonInputs& inputs) {
  const std::size_t width = inputs.columns.compared.size();
  const Schema& keys = inputs.kept.schema;
  const std::vector<PositionCell> cells = position_cells(keys.channels.size(), rotation_columns(keys));
  std::vector<GivenSamples> samples;
  for (Pair& pair : pairs) {
    GivenSamples& sample = samples.emplace_back(GivenSamples{pair.curve, std::move(pair.rows), {}, {}});
    for (std::size_t row = 0; row < sample.rows.size(); ++row) sample.numbers.push_back(row + 1);
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

Subset subset_of(const std::vector<GivenSamples>& samples, const ComparisonInputs& inputs, const ComparedParts& parts) {
  Subset subset{samples, {}, true};
  const KeptInput& kept = inputs.kept;
  const bool cuttable =
      !parts.closed && kept.schema.time.is_given && !kept.traits.may_miss && !inputs.columns.by_length;
  subset.curves.reserve(samples.size());
  for (GivenSamples& sample : subset.samples) {
    if (!cuttable || sample.curve->key_count() <= most_keys) continue;
    GivenSamples before = on_beginning(sample, subset.curves.emplace_back(beginning_of(*sample.curve)));
    if (before.rows.size() * 4 < most_keys) continue;
    sample = std::move(before);
    subset.all = false;
  }
  const std::uint64_t rows = count_rows(subset.samples);
  const std::uint64_t most = most_rows / std::max<std::uint64_t>(parts.rotation_curves.size(), 1);
  if (rows > most) {
    thin_out(subset.samples, rows, most);
    subset.all = false;
  }
  return subset;
}

}  // namespace tcb
