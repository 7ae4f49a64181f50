// Longest cubics: the least number of cubics, connected or not, that stay within the tolerances of a recording.
//
// The longest are taken one after another. No cubic stays within the tolerance of some samples if a weighted
// least squares fit to some of them, whatever the weights, has a weighted mean square error above the square of the
// tolerance; that proves where a cubic ends. So no curve of cubics, with a sample in each, has fewer.
// Source: C. L. Lawson, "Contributions to the theory of linear least maximum approximation", 1961, for the weights; for
//   longest cubics, D. E. McClure, "Nonlinear segmented function approximation and analysis of line patterns", 1975.
#include "fit/fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "stream/ordered_map.hpp"

namespace tcb {
namespace {

constexpr std::size_t cubic_order = 4;  // of a cubic
using Basis = std::array<double, cubic_order>;

/// Chebyshev polynomials at x in [-1, 1].
Basis basis_at(double x) { return {1, x, 2 * x * x - 1, x * (4 * x * x - 3)}; }

/// Solves a symmetric positive definite system for several right-hand vectors, in place.
void solve(std::array<Basis, cubic_order>& matrix, std::span<Basis> targets) {
  for (std::size_t k = 0; k < cubic_order; ++k) {
    for (std::size_t j = 0; j < k; ++j) {
      for (std::size_t i = k; i < cubic_order; ++i) matrix[i][k] -= matrix[i][j] * matrix[k][j];
    }
    const double root = std::sqrt(std::max(matrix[k][k], 1e-300));
    for (std::size_t i = k; i < cubic_order; ++i) matrix[i][k] /= root;
  }
  for (Basis& target : targets) {
    for (std::size_t k = 0; k < cubic_order; ++k) {
      for (std::size_t j = 0; j < k; ++j) target[k] -= matrix[k][j] * target[j];
      target[k] /= matrix[k][k];
    }
    for (std::size_t k = cubic_order; k-- > 0;) {
      for (std::size_t j = k + 1; j < cubic_order; ++j) target[k] -= matrix[j][k] * target[j];
      target[k] /= matrix[k][k];
    }
  }
}

/// Whether one cubic stays within the tolerance of the channels of a group at some samples.
class CubicTest {
 public:
  /// `share`: of the tolerance.
  CubicTest(const Recording& recording, const FitGroup& group, double share)
      : recording_(recording),
        channels_(group.channels),
        per_square_(1 / (group.tolerance * share * (group.tolerance * share))),
        cubic_(group.channels.size()) {}

  /// False only if it is proved that no cubic is within the tolerance.
  bool may_fit(SampleRange range) {
    if (range.size() <= cubic_order) return true;
    begin(range);
    for (int round = 0; round < most_rounds; ++round) {
      if (!fit_chosen()) return false;
      if (!add_worst(range)) return true;
    }
    return true;
  }

 private:
  static constexpr int most_rounds = 40, most_weightings = 60;
  static constexpr std::size_t parts = 6;  // of the range, each of whose worst samples is chosen

  void begin(SampleRange range) {
    const double first = recording_.times[range.first], last = recording_.times[range.last - 1];
    middle_ = (first + last) / 2;
    half_ = (last - first) / 2;
    chosen_.clear();
    weights_.clear();
    constexpr std::size_t least = 9;
    for (std::size_t i = 0; i < least; ++i) choose(range.first + (range.size() - 1) * i / (least - 1));
  }

  void choose(std::size_t sample) {
    if (std::ranges::count(chosen_, sample) > 0) return;
    chosen_.push_back(sample);
    double mean = 0;
    for (const double weight : weights_) mean += weight;
    weights_.push_back(weights_.empty() ? 1 : mean / static_cast<double>(weights_.size()));
  }

  /// Fits the chosen samples, with more and more weight on those that are far. Returns false if no cubic can
  /// stay within the tolerance.
  bool fit_chosen() {
    for (int i = 0; i < most_weightings; ++i) {
      fit_weighted();
      double largest = 0, sum = 0, squares = 0;
      errors_.clear();
      for (std::size_t k = 0; k < chosen_.size(); ++k) {
        const double square = squared_error(chosen_[k]);
        errors_.push_back(std::sqrt(square));
        largest = std::max(largest, errors_[k]);
        sum += weights_[k];
        squares += weights_[k] * square;
      }
      constexpr double rounding = 1 + 1e-9;
      if (squares > sum * rounding) return false;
      if (largest <= 1) return true;
      for (std::size_t k = 0; k < chosen_.size(); ++k) weights_[k] *= (errors_[k] + 1e-3) / largest;
    }
    return true;
  }

  void fit_weighted() {
    std::array<Basis, cubic_order> matrix{};
    std::ranges::fill(cubic_, Basis{});
    for (std::size_t k = 0; k < chosen_.size(); ++k) {
      const Basis b = basis(chosen_[k]);
      for (std::size_t i = 0; i < cubic_order; ++i) {
        for (std::size_t j = 0; j <= i; ++j) matrix[i][j] += weights_[k] * b[i] * b[j];
        for (std::size_t c = 0; c < cubic_.size(); ++c) {
          cubic_[c][i] += weights_[k] * b[i] * recording_.position(chosen_[k], channels_[c]);
        }
      }
    }
    solve(matrix, cubic_);
  }

  /// Chooses the worst samples beyond the tolerance; false: there are none.
  bool add_worst(SampleRange range) {
    bool any = false;
    for (std::size_t part = 0; part < parts; ++part) {
      double largest = 1;
      std::size_t worst = range.last;
      for (std::size_t i = range.first + range.size() * part / parts;
           i < range.first + range.size() * (part + 1) / parts; ++i) {
        const double now = squared_error(i);
        if (now > largest) {
          largest = now;
          worst = i;
        }
      }
      if (worst == range.last) continue;
      any = any || std::ranges::count(chosen_, worst) == 0;
      choose(worst);
    }
    return any;
  }

  Basis basis(std::size_t sample) const { return basis_at((recording_.times[sample] - middle_) / half_); }

  /// The square of the distance of the cubic from a sample, in tolerances.
  double squared_error(std::size_t sample) const {
    const Basis b = basis(sample);
    double sum = 0;
    for (std::size_t c = 0; c < cubic_.size(); ++c) {
      const Basis& a = cubic_[c];
      const double gap =
          ((a[0] + a[1] * b[1]) + (a[2] * b[2] + a[3] * b[3])) - recording_.position(sample, channels_[c]);
      sum += gap * gap;
    }
    return sum * per_square_;
  }

  const Recording& recording_;
  const std::vector<std::size_t>& channels_;
  double per_square_;  ///< of the tolerance
  double middle_ = 0, half_ = 1;
  std::vector<std::size_t> chosen_;
  std::vector<double> weights_, errors_;
  std::vector<Basis> cubic_;  ///< of each channel, in Chebyshev polynomials
};

/// Tests samples with one cubic for each group.
class CubicTests {
 public:
  /// `share`: of the tolerances.
  CubicTests(const Recording& recording, double share) {
    for (const FitGroup& group : recording.groups) tests_.emplace_back(recording, group, share);
  }

  /// Whether samples [first, last) may be within the tolerances.
  bool may_fit(std::size_t first, std::size_t last) {
    return std::ranges::all_of(tests_, [&](CubicTest& test) { return test.may_fit({first, last}); });
  }

 private:
  std::vector<CubicTest> tests_;
};

/// The largest size up to `most` for which a test holds, as for all below it; `good`: it holds for this one. Searches
/// in growing steps around a guess.
template <class Test>
std::size_t largest_size(std::size_t good, std::size_t most, std::size_t guess, const Test& test) {
  std::size_t bad = most + 1, size = std::clamp(guess, good, most), step = std::max<std::size_t>(size / 8, 1);
  if (size == good || test(size)) {
    good = size;
    while (good < most) {
      size = good + std::min(step, most - good);
      if (!test(size)) {
        bad = size;
        break;
      }
      good = size;
      step *= 2;
    }
  } else {
    bad = size;
    while (bad - good > step) {
      size = bad - step;
      if (test(size)) {
        good = size;
        break;
      }
      bad = size;
      step *= 2;
    }
  }
  while (good + 1 < bad) {
    const std::size_t middle = good + (bad - good) / 2;
    (test(middle) ? good : bad) = middle;
  }
  return good;
}

/// The starts of the longest cubics, from one sample on.
class Chain {
 public:
  Chain(const Recording& recording, double share, std::size_t first)
      : size_(recording.size()), tests_(recording, share), next_(first) {}

  const std::vector<std::size_t>& starts() const { return starts_; }
  std::size_t next() const { return next_; }

  /// Adds a start, behind whose cubic the next one is.
  void add() {
    starts_.push_back(next_);
    const std::size_t rest = size_ - next_;
    guess_ = largest_size(std::min(cubic_order, rest), rest, guess_,
                          [&](std::size_t size) { return tests_.may_fit(next_, next_ + size); });
    next_ += guess_;
  }

  /// Adds the starts of another chain from the next one on, if that is one of them.
  bool join(const Chain& other) {
    const auto found = std::ranges::lower_bound(other.starts_, next_);
    if (found == other.starts_.end() || *found != next_) return false;
    starts_.insert(starts_.end(), found, other.starts_.end());
    next_ = other.next_;
    return true;
  }

 private:
  std::size_t size_;
  CubicTests tests_;
  std::size_t next_, guess_ = cubic_order;
  std::vector<std::size_t> starts_;
};

/// The first `most` starts of the longest cubics. Chains that begin at several samples are found on all threads; a
/// chain mostly meets the next one soon.
std::vector<std::size_t> starts_of(const Recording& recording, double share, std::size_t most, unsigned threads) {
  constexpr std::size_t samples_of_part = 50'000;
  const std::size_t parts = recording.size() / samples_of_part + 1;
  const auto end_of = [&](std::size_t part) { return recording.size() * (part + 1) / parts; };
  const auto chain_of = [&](std::size_t part) {
    Chain chain(recording, share, recording.size() * part / parts);
    while (chain.next() < end_of(part) && chain.starts().size() < most) chain.add();
    return chain;
  };
  const auto chains = ordered_map(numbers_to(parts), chain_of, threads);
  Chain joined(recording, share, 0);
  for (std::size_t part = 0; part < parts && joined.starts().size() < most; ++part) {
    const Chain chain = *chains();
    while (joined.next() < end_of(part) && joined.starts().size() < most && !joined.join(chain)) joined.add();
  }
  return joined.starts();
}

/// For each start but the first one, the sample in the middle between the last one of the cubic before it and the first
/// one from which a cubic reaches as far as that of the start.
std::vector<std::size_t> knots_between(const Recording& recording, double share, const std::vector<std::size_t>& starts,
                                       unsigned threads) {
  std::vector<std::size_t> knots(starts.size() - 1);
  constexpr std::size_t cubics_of_part = 500;
  for_each_number(knots.size() / cubics_of_part + 1, threads, [&](std::size_t part) {
    CubicTests tests(recording, share);
    for (std::size_t i = part * cubics_of_part; i < std::min((part + 1) * cubics_of_part, knots.size()); ++i) {
      const std::size_t start = starts[i + 1], last = i + 2 < starts.size() ? starts[i + 2] : recording.size();
      const std::size_t before =
          largest_size(0, start - starts[i], 1, [&](std::size_t size) { return tests.may_fit(start - size, last); });
      knots[i] = start - 1 - before / 2;
    }
  });
  return knots;
}

}  // namespace

std::vector<std::size_t> longest_cubics(const Recording& recording, unsigned threads) {
  return starts_of(recording, 1, recording.size(), threads);
}

std::vector<std::size_t> knots_of(const Recording& recording, std::size_t cubics, unsigned threads) {
  const std::size_t most = cubics + cubics / 4;
  for (const double share : {0x1p-8, 0x1p-4, 1.0}) {
    const std::vector<std::size_t> starts = starts_of(recording, share, most + 1, threads);
    if (starts.size() <= most) return knots_between(recording, share, starts, threads);
  }
  return {};
}

}  // namespace tcb
