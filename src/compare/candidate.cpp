// Candidates: how well each convention agrees with someone's samples.
#include "compare/candidate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

namespace tcb {

Comparer::Comparer(const Job& plan, const ComparisonInputs& sides, const std::vector<TcbOrders>& orders, bool closed)
    : plan_(plan), sides_(sides), orders_(orders), closed_(closed), request_(plan.sampling) {
  request_.mode = sides.columns.by_length ? Mode::arc_at : Mode::at;
}

IndexedCurve Comparer::whole(const KeptCurve& curve, const Convention& convention) const {
  const CurveSettings settings = settings_of(convention, plan_.curve, closed_);
  const CurvePipeline path(request_, settings, sides_.columns.fields, std::nullopt, sides_.kept.input,
                           *curve.curve_info);
  const TcbOrder& order = orders_[convention.order].order;
  if (order.is_plain()) return path.whole(curve.keys());
  return path.whole(mapped(curve.keys(), [&order](KeyBlock block) {
    block.keys.common_tcb = order.of(block.keys.common_tcb);
    for (auto& tcb : block.keys.tcbs) tcb = order.of(tcb);
    return block;
  }));
}

Places Comparer::places(const GivenSamples& sample, const IndexedCurve& whole) const {
  Limits limits;
  if (sides_.columns.by_length) limits.abs = std::numeric_limits<double>::infinity();
  return places_of(sample.rows, sides_.table, sides_.columns, whole, limits);
}

Candidate Comparer::compare(const Convention& convention, const std::vector<GivenSamples>& samples) const {
  Candidate candidate{convention, 0, {}, 0, {}, {}};
  for (const GivenSamples& sample : samples) {
    const IndexedCurve curve = whole(*sample.curve, convention);
    for_each_row(places(sample, curve), sides_.columns, curve, true, 1,
                 [&](std::size_t row, auto cells) { compare_row(candidate, sample, row, cells); });
  }
  return candidate;
}

void Comparer::compare_row(Candidate& candidate, const GivenSamples& sample, std::size_t row,
                           std::span<const Cell> cells) const {
  const auto& columns = sides_.columns.compared;
  bool off = false;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const double theirs = sample.rows.numbers[row * sides_.table.columns.size() + columns[i].theirs];
    if (std::isnan(theirs)) continue;  // it says nothing
    const double ours = cells[columns[i].ours].hi;
    const Distance found = distance(theirs, ours);
    const Allowance& allowed = sample.allowances[row * columns.size() + i];
    for (std::size_t p = 0; p < allowed.size(); ++p) {
      if (found.abs == 0) continue;
      candidate.excess[p] = std::max(candidate.excess[p], found.abs / allowed[p]);
    }
    const bool beyond = found.abs > *std::ranges::max_element(allowed);
    const Difference difference{sample.numbers[row], sample.rows.lines[row], columns[i].name, theirs, ours, found};
    if (beyond && (!candidate.first || difference.line < candidate.first->line)) candidate.first = difference;
    if (!candidate.worst || found.abs > candidate.largest) candidate.worst = difference;
    candidate.largest = std::max(candidate.largest, found.abs);
    off = off || beyond;
  }
  if (off) ++candidate.rows_off;
}

namespace {

/// Which candidates fit, and cannot be told apart.
std::vector<bool> fitting(const std::vector<Candidate>& candidates, std::size_t precision) {
  const auto excess = [precision](const Candidate& candidate) { return candidate.excess[precision]; };
  const double best = excess(*std::ranges::min_element(candidates, {}, excess));
  std::vector<bool> fits;
  for (const Candidate& candidate : candidates) {
    const bool as_good = candidate.excess[0] <= 1 || excess(candidate) <= 1.5 * best;
    fits.push_back(excess(candidate) <= 1 && as_good);
  }
  return fits;
}

}  // namespace

Ranking ranked(std::vector<Candidate> candidates, std::uint64_t rows, bool closed) {
  Ranking result;
  std::vector<bool> fits(candidates.size());
  for (std::size_t p = 0; p < precisions.size() && !result.precision; ++p) {
    if (std::ranges::any_of(candidates, [p](const Candidate& one) { return one.excess[p] <= 1; })) {
      result.precision = p;
      fits = fitting(candidates, p);
    }
  }
  std::vector<Candidate> others;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    (fits[i] ? result.candidates : others).push_back(std::move(candidates[i]));
  }
  result.fitting = result.candidates.size();
  std::ranges::stable_sort(result.candidates, {}, [closed](const Candidate& one) {
    return std::tuple(one.convention.order, one.convention.equal_speed, presets_of(one.convention, closed).empty());
  });
  std::ranges::stable_sort(others, {}, [rows](const Candidate& one) {
    const bool nearly = one.rows_off <= std::max<std::uint64_t>(1, rows / 4);
    return std::tuple(!nearly, nearly ? one.rows_off : 0, one.largest);
  });
  std::ranges::move(others, std::back_inserter(result.candidates));
  return result;
}

}  // namespace tcb
