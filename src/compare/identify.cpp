// Identifying: which convention made someone's samples.
#include "compare/identify.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "compare/pairs.hpp"
#include "compare/sides.hpp"
#include "curve/settings.hpp"
#include "error.hpp"
#include "stream/stream.hpp"

namespace tcb {
namespace {

constexpr std::size_t most_chosen = 64, most_mixed = 16;

/// Leaves the columns of positions alone among those that are compared.
void leave_positions(ComparisonInputs& sides) {
  MatchedColumns& columns = sides.columns;
  const auto& channels = sides.kept.input.channels;
  std::vector<MatchedColumn> positions;
  for (MatchedColumn column : columns.compared) {
    const auto channel = std::ranges::find(channels, column.name);
    if (channel == channels.end()) {
      columns.ignored.push_back(column.name);
      continue;
    }
    column.ours = static_cast<std::size_t>(channel - channels.begin());
    positions.push_back(column);
  }
  columns.fields = {field_of("position")};
  columns.compared = std::move(positions);
  if (!columns.compared.empty()) return;
  throw Error(Exit::data, "no column of positions, which tell conventions apart; expected one at least; name it");
}

bool is_closed(const KeptCurves& kept, const Job& plan) {
  return std::ranges::any_of(kept.curves, [&](const KeptCurve& curve) {
    return make_spec(merged(plan.curve, curve.curve_info->settings)).closed;
  });
}

/// What is wrong with rows on no curve, which any convention has at the same times.
void say_off_curve(const Comparer& comparer, const std::vector<GivenSamples>& samples, Identified& result) {
  for (const GivenSamples& sample : samples) {
    const Places places = comparer.places(sample, comparer.whole(*sample.curve, {}));
    result.rows += places.rows.size();
    if (!places.off_curve.empty()) result.problems.push_back(off_curve(places, sample.rows));
  }
}

[[noreturn]] void refuse_nothing(const Identified& result) {
  const std::string why = result.problems.empty() ? "it has no rows" : result.problems.back();
  throw Error(Exit::data, TextPosition{result.file}, why + "; expected rows on the curve of the keys; give others");
}

/// Compares all conventions with samples, on all threads.
std::vector<Candidate> compared(const Comparer& comparer, const std::vector<Convention>& conventions,
                                const std::vector<GivenSamples>& samples, unsigned threads) {
  Source<Convention> source = [&conventions, next = std::size_t{0}]() mutable {
    return next < conventions.size() ? std::optional(conventions[next++]) : std::nullopt;
  };
  const auto compare = [&](const Convention& convention) { return comparer.compare(convention, samples); };
  const auto answers = ordered_map(std::move(source), compare, threads);
  std::vector<Candidate> candidates;
  while (std::optional<Candidate> candidate = answers()) candidates.push_back(std::move(*candidate));
  return candidates;
}

/// The conventions that few rows leave.
std::vector<Convention> chosen(const Ranking& ranking) {
  std::vector<Convention> left;
  for (std::size_t i = 0; i < ranking.candidates.size() && i < std::max(most_chosen, ranking.fitting); ++i) {
    left.push_back(ranking.candidates[i].convention);
  }
  return left;
}

/// The best conventions with different rules at their ends.
std::vector<Convention> mixed(const Ranking& ranking) {
  std::vector<Convention> tried, all;
  for (const Candidate& candidate : ranking.candidates) {
    const auto same = [&](const Convention& other) {
      const Convention& one = candidate.convention;
      return one.tangents == other.tangents && one.equal_speed == other.equal_speed && one.order == other.order;
    };
    if (tried.size() == most_mixed || std::ranges::any_of(tried, same)) continue;
    tried.push_back(candidate.convention);
    const auto more = with_mixed_ends(candidate.convention);
    all.insert(all.end(), more.begin(), more.end());
  }
  return all;
}

/// Ranks by few rows first, and the best of them by all.
class Search {
 public:
  Search(const Comparer& comparer, const std::vector<GivenSamples>& samples, Subset few, bool closed, unsigned threads)
      : comparer_(comparer), samples_(samples), few_(std::move(few)), closed_(closed), threads_(threads) {}

  Ranking rank(const std::vector<Convention>& conventions) const {
    Ranking ranking = rank(conventions, few_.samples);
    return few_.all ? ranking : rank(chosen(ranking), samples_);
  }

  /// The candidates of both.
  Ranking joined(Ranking one, Ranking other) const {
    std::ranges::move(other.candidates, std::back_inserter(one.candidates));
    return ranked(std::move(one.candidates), count_rows(samples_), closed_);
  }

 private:
  Ranking rank(const std::vector<Convention>& conventions, const std::vector<GivenSamples>& samples) const {
    return ranked(compared(comparer_, conventions, samples, threads_), count_rows(samples), closed_);
  }

  const Comparer& comparer_;
  const std::vector<GivenSamples>& samples_;
  Subset few_;
  bool closed_;
  unsigned threads_;
};

}  // namespace

Identified identify(const Job& plan) {
  ComparisonInputs sides =
      read_sides(plan, plan.fields.empty() ? std::vector{field_of("time"), field_of("position")} : plan.fields);
  in_file(sides.file, [&] { leave_positions(sides); });
  Pairs pairs = pair_up(sides.kept, sides.table);
  Identified result{compared(sides, pairs)};
  in_file(sides.keys, [&] {
    result.closed = is_closed(sides.kept, plan);
    result.orders = distinct_orders(sides.kept);
    const std::vector<Convention> all = conventions(result.orders.size(), result.closed);
    result.conventions = all.size();
    const std::vector<GivenSamples> samples = samples_of(std::move(pairs.pairs), sides);
    const Comparer comparer(plan, sides, result.orders, result.closed);
    say_off_curve(comparer, samples, result);
    if (result.rows == 0) refuse_nothing(result);
    const Search search(comparer, samples, few_of(samples, sides, !result.closed), result.closed, sides.threads);
    result.ranking = search.rank(all);
    if (!result.ranking.candidates.front().worst) {
      result.problems.emplace_back("it has no numbers to compare");
      refuse_nothing(result);
    }
    if (result.fits() || result.closed) return;
    const std::vector<Convention> more = mixed(result.ranking);
    result.conventions += more.size();
    result.ranking = search.joined(std::move(result.ranking), search.rank(more));
  });
  return result;
}

}  // namespace tcb
