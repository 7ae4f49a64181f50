// Ranking: comparing samples with all conventions, which of these fit, and in which order they are listed.
//
// All conventions are compared with all rows. Where none fits, the best ones are tried again with different rules at
// the two ends.
#include "check/ranking.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <tuple>
#include <utility>

#include "check/allowances.hpp"
#include "error.hpp"
#include "run/curve_pipeline.hpp"
#include "sample/build.hpp"
#include "stream/ordered_map.hpp"
#include "stream/source.hpp"

namespace tcb {
namespace {

constexpr std::size_t most_mixed = 16;

void set_order(KeyBlock& block, const TcbOrder& order) {
  block.keys.common_tcb = order.of(block.keys.common_tcb);
  for (auto& tcb : block.keys.tcbs) tcb = order.of(tcb);
}

/// Compares samples with conventions. Requires: the arguments of the constructor outlive it.
class Comparer {
 public:
  Comparer(const CurveSettings& rules, const ComparisonInputs& inputs, const std::vector<TcbOrders>& orders,
           const ComparedParts& parts)
      : rules_(rules), inputs_(inputs), orders_(orders), parts_(parts) {
    request_.mode = inputs.columns.by_length ? Mode::arc_at : Mode::at;
  }

  Candidate compare(const Convention& convention, const std::vector<GivenSamples>& samples) const {
    Candidate candidate{convention};
    for (const GivenSamples& sample : samples) {
      const std::shared_ptr<const KeptCurve> curve = curve_of(*sample.curve, convention);
      for_each_row(sample.rows, places(sample, *curve), inputs_.columns, curve, spline::Side::left, 1,
                   [&](std::size_t row, auto cells) { compare_row(candidate, sample, row, cells); });
    }
    return candidate;
  }

  std::shared_ptr<const KeptCurve> curve_of(const KeptKeys& curve, const Convention& convention) const {
    const CurveRequest request{.samples = request_,
                               .rules = settings_of(convention, rules_, parts_),
                               .fields = inputs_.columns.fields,
                               .threads = inputs_.threads,
                               .zero = inputs_.kept.zero};
    CurvePipeline pipeline(request, inputs_.kept.schema, inputs_.kept.traits, *curve.curve_info);
    const TcbOrder& order = orders_[convention.order].order;
    if (order.is_plain()) return pipeline.kept(curve.keys());
    return pipeline.kept(mapped(curve.keys(), [&order](KeyBlock block) {
      set_order(block, order);
      return block;
    }));
  }

  /// Where samples lie on a curve; an arc length beyond its end counts as the end.
  Places places(const GivenSamples& sample, const KeptCurve& curve) const {
    Limits limits;
    if (inputs_.columns.by_length) limits.abs = std::numeric_limits<double>::infinity();
    return places_of(sample.rows, inputs_.columns, curve, limits);
  }

 private:
  void compare_row(Candidate& candidate, const GivenSamples& sample, std::size_t row,
                   std::span<const Cell> cells) const {
    const auto& columns = inputs_.columns.compared;
    bool off = false;
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const double given = sample.rows.row(row)[columns[i].given];
      if (std::isnan(given)) continue;
      const double computed = cells[columns[i].computed].hi;
      const Distance found = distance(given, computed);
      const Allowance& allowed = sample.allowances[row * columns.size() + i];
      if (found.abs > allowed.rounding) candidate.excess = std::max(candidate.excess, found.abs / allowed.most);
      const bool beyond = found.abs > allowed.most;
      const std::uint64_t line = sample.rows.lines[row];
      const auto difference = [&] { return Difference{row + 1, line, columns[i].name, given, computed, found}; };
      if (beyond && (!candidate.first || line < candidate.first->line)) candidate.first = difference();
      if (!candidate.worst || found.abs > candidate.largest) candidate.worst = difference();
      candidate.largest = std::max(candidate.largest, found.abs);
      off = off || beyond;
    }
    if (off) ++candidate.rows_off;
  }

  const CurveSettings& rules_;
  const ComparisonInputs& inputs_;
  const std::vector<TcbOrders>& orders_;
  const ComparedParts& parts_;
  SamplingRequest request_;
};

/// Keeps only the columns of positions among those that are compared.
void compare_positions_only(ComparisonInputs& inputs) {
  MatchedColumns& columns = inputs.columns;
  columns.fields = {field_of("position")};
  const std::vector<OutputColumn> cells = output_columns(columns.fields, inputs.kept.schema);
  std::vector<MatchedColumn> positions;
  std::vector<std::size_t> places(columns.compared.size());  // of columns among those that are kept
  for (std::size_t i = 0; i < places.size(); ++i) {
    MatchedColumn column = columns.compared[i];
    const auto cell = std::ranges::find(cells, column.name, &OutputColumn::name);
    if (cell == cells.end()) {
      columns.ignored.push_back(column.name);
      continue;
    }
    column.computed = static_cast<std::size_t>(cell - cells.begin());
    places[i] = positions.size();
    positions.push_back(column);
  }
  for (auto& numbers : columns.rotations)
    std::ranges::transform(numbers, numbers.begin(), [&](auto i) { return places[i]; });
  for (auto& angle : columns.angles) angle.first = places[angle.first];
  columns.compared = std::move(positions);
  if (columns.compared.empty()) throw no_position_column(inputs.kept.schema.channels);
}

/// Counts the rows on the curves; adds a problem for rows off them, which are off them with every convention.
void find_rows(const Comparer& comparer, const std::vector<GivenSamples>& samples, Identification& result) {
  for (const GivenSamples& sample : samples) {
    const Places places = comparer.places(sample, *comparer.curve_of(*sample.curve, {}));
    result.rows += places.rows.size();
    if (places.off_curve) result.problems.emplace_back(*places.off_curve);
  }
}

std::vector<Candidate> compared_conventions(const Comparer& comparer, const std::vector<Convention>& conventions,
                                            const std::vector<GivenSamples>& samples, std::uint64_t rows,
                                            const ComparisonInputs& inputs) {
  Source<Convention> source = [&conventions, next = std::size_t{0}]() mutable {
    return next < conventions.size() ? std::optional(conventions[next++]) : std::nullopt;
  };
  const auto compare = [&](const Convention& convention) {
    Candidate candidate = comparer.compare(convention, samples);
    if (inputs.progress != nullptr) inputs.progress->add_rows(rows);
    return candidate;
  };
  const auto answers = ordered_map(std::move(source), compare, inputs.threads);
  std::vector<Candidate> candidates;
  while (std::optional<Candidate> candidate = answers()) candidates.push_back(std::move(*candidate));
  return candidates;
}

/// The best conventions with different rules at their ends.
std::vector<Convention> mixed(const Ranking& ranking) {
  std::vector<Convention> tried, all;
  for (const Candidate& candidate : ranking.candidates) {
    const auto same = [&](const Convention& other) {
      const Convention& one = candidate.convention;
      return one.tangents == other.tangents && one.equal_speed == other.equal_speed && one.order == other.order &&
             one.rotation_curve == other.rotation_curve;
    };
    if (candidate.convention.rotation_preset) continue;
    if (tried.size() == most_mixed || std::ranges::any_of(tried, same)) continue;
    tried.push_back(candidate.convention);
    const auto more = with_mixed_ends(candidate.convention);
    all.insert(all.end(), more.begin(), more.end());
  }
  return all;
}

/// Whether keys can be resampled with equal speed: not where they have velocities, or lack positions.
bool allows_equal_speed(const KeptInput& kept) {
  const auto refuses = [](const KeyBlock& block) {
    const auto is_missing = [](double position) { return std::isnan(position); };
    return !block.keys.velocities.empty() || std::ranges::any_of(block.keys.positions, is_missing);
  };
  return std::ranges::none_of(kept.curves,
                              [&](const KeptKeys& curve) { return std::ranges::any_of(curve.blocks, refuses); });
}

/// Ranks all conventions. Throws: Error (data) if there is nothing to compare.
void rank(Identification& result, const CurveSettings& rules, const ComparisonInputs& inputs,
          const std::vector<GivenSamples>& samples) {
  const Comparer comparer(rules, inputs, result.orders, result.parts);
  find_rows(comparer, samples, result);
  if (result.rows == 0) {
    Error error =
        data_error("no row is on the curve of the keys; expected at least one row; give samples of the same curve");
    for (const std::string& problem : result.problems) error.add({Exit::data, problem});
    throw error.in(inputs.file);
  }
  std::vector<Convention> all = conventions(result.orders.size(), result.parts);
  if (!allows_equal_speed(inputs.kept)) std::erase_if(all, [](const Convention& one) { return one.equal_speed; });
  result.conventions = all.size();
  std::uint64_t rows = 0;
  for (const GivenSamples& sample : samples) rows += sample.rows.size();
  result.ranking = ranked(compared_conventions(comparer, all, samples, rows, inputs), rows, result.parts);
  if (!result.ranking.candidates.front().worst) {
    throw data_error("no row has a number to compare; expected at least one; give other samples").in(inputs.file);
  }
  if (result.fits() || result.parts.closed) return;
  const std::vector<Convention> more = mixed(result.ranking);
  result.conventions += more.size();
  std::vector<Candidate> both = std::move(result.ranking.candidates);
  std::ranges::move(compared_conventions(comparer, more, samples, rows, inputs), std::back_inserter(both));
  result.ranking = ranked(std::move(both), rows, result.parts);
}

}  // namespace

Ranking ranked(std::vector<Candidate> candidates, std::uint64_t rows, const ComparedParts& parts) {
  Ranking result;
  const double best = std::ranges::min_element(candidates, {}, &Candidate::excess)->excess;
  std::vector<Candidate> others;
  for (Candidate& one : candidates) {
    const bool fits = one.excess <= 1 && one.excess <= 1.5 * best;  // of coarse numbers only those nearly as good
    (fits ? result.candidates : others).push_back(std::move(one));
  }
  result.fitting = result.candidates.size();
  std::ranges::stable_sort(result.candidates, {}, [&parts](const Candidate& one) {
    return std::tuple(one.convention.order, one.convention.equal_speed, presets_of(one.convention, parts).empty());
  });
  std::ranges::stable_sort(others, {}, [rows](const Candidate& one) {
    const bool nearly = one.rows_off <= std::max<std::uint64_t>(1, rows / 4);
    return std::tuple(!nearly, nearly ? one.rows_off : 0, one.largest);
  });
  std::ranges::move(others, std::back_inserter(result.candidates));
  return result;
}

ComparisonInputs read_positions(const Comparison& comparison, FileProgress* progress) {
  ComparisonInputs inputs = read_inputs(
      comparison, comparison.fields.empty() ? std::vector{field_of("time"), field_of("position")} : comparison.fields,
      progress);
  in_file(inputs.file, [&] { compare_positions_only(inputs); });
  return inputs;
}

Identification identify(const Comparison& comparison, ComparisonInputs inputs) {
  Pairs pairs = pair_up(inputs.kept, inputs.table);
  Identification result{summary(inputs, pairs)};
  in_file(inputs.keys, [&] {
    result.parts = compared_parts(comparison.keys.rules, inputs);
    result.orders = distinct_orders(inputs.kept);
    rank(result, comparison.keys.rules, inputs, samples_of(std::move(pairs.pairs), inputs));
  });
  return result;
}

Check check_best(const Comparison& comparison, const Identification& found, ComparisonInputs inputs,
                 const std::function<void(const CheckedPair&)>& observe) {
  const Convention& best = found.ranking.candidates.front().convention;
  Comparison with_rules = comparison;
  with_rules.keys.rules = settings_of(best, comparison.keys.rules, found.parts);
  for (KeptKeys& curve : inputs.kept.curves) {
    for (KeyBlock& block : curve.blocks) set_order(block, found.orders[best.order].order);
  }
  return check(with_rules, std::move(inputs), observe);
}

}  // namespace tcb
