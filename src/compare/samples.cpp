// Samples: someone's rows with the precision of their numbers, all of them or a few that stand for them.
#include "compare/samples.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tcb {
namespace {

constexpr std::size_t most_rows = 1000, most_keys = 256;

/// The numbers of one column, over all curves.
std::vector<double> numbers_of(const std::vector<GivenSamples>& samples, const SampleTable& table,
                               const MatchedColumn& column) {
  std::vector<double> numbers;
  for (const GivenSamples& sample : samples) {
    for (std::size_t row = 0; row < sample.rows.size(); ++row) {
      numbers.push_back(sample.rows.numbers[row * table.columns.size() + column.theirs]);
    }
  }
  return numbers;
}

double largest_position(const KeptCurves& kept, std::size_t channel) {
  double largest = 0;
  for (const KeptCurve& curve : kept.curves) {
    for (const KeyBlock& block : curve.blocks) {
      for (std::size_t key = 0; key < block.lines.size(); ++key) {
        const double position = std::abs(block.keys.positions[key * block.keys.channels + channel]);
        if (position > largest) largest = position;
      }
    }
  }
  return largest;
}

/// A row of a sample added to others of its curve.
void add_row(GivenSamples& to, const GivenSamples& from, std::size_t row, std::size_t numbers, std::size_t width) {
  const auto copy = [row](auto& target, const auto& source, std::size_t stride) {
    const auto begin = source.begin() + static_cast<std::ptrdiff_t>(row * stride);
    if (!source.empty()) target.insert(target.end(), begin, begin + static_cast<std::ptrdiff_t>(stride));
  };
  copy(to.rows.times, from.rows.times, 1);
  copy(to.rows.numbers, from.rows.numbers, numbers);
  copy(to.rows.lines, from.rows.lines, 1);
  copy(to.numbers, from.numbers, 1);
  copy(to.allowances, from.allowances, width);
}

/// The first keys of a curve.
KeptCurve beginning_of(const KeptCurve& curve) {
  KeptCurve cut{curve.group, curve.curve_info, {}};
  std::size_t left = most_keys;
  for (const KeyBlock& block : curve.blocks) {
    if (left == 0) break;
    const std::size_t count = std::min(left, block.size());
    cut.blocks.push_back(block.range(0, count));
    left -= count;
  }
  return cut;
}

std::size_t keys_of(const KeptCurve& curve) {
  std::size_t keys = 0;
  for (const KeyBlock& block : curve.blocks) keys += block.lines.size();
  return keys;
}

/// The time of the key that is the so many-th from the end, or of the first one.
spline::Time<double> time_from_end(const KeptCurve& curve, std::size_t number) {
  auto block = curve.blocks.rbegin();
  for (; std::next(block) != curve.blocks.rend() && block->lines.size() < number; ++block) {
    number -= block->lines.size();
  }
  return block->keys.times[block->lines.size() - std::min(block->lines.size(), number)];
}

/// The rows before the last keys of a beginning, which the keys behind it bear on.
GivenSamples on_beginning(const GivenSamples& sample, const KeptCurve& beginning, const ComparisonInputs& sides) {
  const spline::Time<double> end = time_from_end(beginning, 3);
  GivenSamples before{&beginning, {}, {}, {}};
  for (std::size_t row = 0; row < sample.rows.size(); ++row) {
    if (sample.rows.times[row] > end) continue;
    add_row(before, sample, row, sides.table.columns.size(), sides.columns.compared.size());
  }
  return before;
}

}  // namespace

std::uint64_t count_rows(const std::vector<GivenSamples>& samples) {
  std::uint64_t rows = 0;
  for (const GivenSamples& sample : samples) rows += sample.rows.size();
  return rows;
}

std::vector<GivenSamples> samples_of(std::vector<Pair> pairs, const ComparisonInputs& sides) {
  std::vector<GivenSamples> samples;
  for (Pair& pair : pairs) {
    GivenSamples& sample = samples.emplace_back(GivenSamples{pair.curve, std::move(pair.rows), {}, {}});
    for (std::size_t row = 0; row < sample.rows.size(); ++row) sample.numbers.push_back(row + 1);
    sample.allowances.resize(sample.rows.size() * sides.columns.compared.size());
  }
  const std::size_t width = sides.columns.compared.size();
  for (std::size_t i = 0; i < width; ++i) {
    const MatchedColumn& column = sides.columns.compared[i];
    const auto allowed =
        allowances(numbers_of(samples, sides.table, column), largest_position(sides.kept, column.ours));
    std::size_t next = 0;
    for (GivenSamples& sample : samples) {
      for (std::size_t row = 0; row < sample.rows.size(); ++row) sample.allowances[row * width + i] = allowed[next++];
    }
  }
  return samples;
}

Subset few_of(const std::vector<GivenSamples>& samples, const ComparisonInputs& sides, bool open) {
  Subset few{samples, {}, true};
  const bool cuttable = open && sides.kept.input.timed && !sides.kept.input.may_miss && !sides.columns.by_length;
  few.curves.reserve(samples.size());
  for (GivenSamples& sample : few.samples) {
    if (!cuttable || keys_of(*sample.curve) <= most_keys) continue;
    GivenSamples before = on_beginning(sample, few.curves.emplace_back(beginning_of(*sample.curve)), sides);
    if (before.rows.size() * 4 < most_keys) continue;
    sample = std::move(before);
    few.all = false;
  }
  const std::size_t rows = count_rows(few.samples);
  if (rows <= most_rows) return few;
  few.all = false;
  std::size_t number = 0;
  for (GivenSamples& sample : few.samples) {
    GivenSamples thin{sample.curve, {}, {}, {}};
    for (std::size_t row = 0; row < sample.rows.size(); ++row, ++number) {
      if (number * most_rows / rows == (number + 1) * most_rows / rows) continue;
      add_row(thin, sample, row, sides.table.columns.size(), sides.columns.compared.size());
    }
    sample = std::move(thin);
  }
  return few;
}

}  // namespace tcb
