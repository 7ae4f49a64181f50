// Fitting: from the samples of a recording to the rows of its keys, and how well they fit.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "fit/fit.hpp"
#include "fit/fit_options.hpp"
#include "keys/curves.hpp"
#include "read/input.hpp"
#include "run/progress.hpp"
#include "sample/table.hpp"
#include "schema/key_block.hpp"
#include "schema/schema.hpp"

namespace tcb {

/// What is fitted of an input, and within which limits.
struct FittedChannels {
  std::vector<std::size_t> numbers;  ///< of the channels, in the input
  std::vector<std::string> names;
  std::vector<FitGroup> groups;  ///< of these channels: those of rotations come last
};

/// `rules` have the metric. Throws: Error (data) for rotations that are no quaternions, for limits of channels or
/// rotations that are not there, and for a channel without a limit; Error (usage) for a metric that does not exist.
FittedChannels fitted_channels(const Schema& schema, const CurveSettings& rules, const FitOptions& options);

struct Samples {
  std::vector<std::string> group;
  Recording recording;
  std::vector<Time> times;
  std::vector<std::uint64_t> lines;
  std::vector<std::size_t> kept;  ///< that become keys in any case
  FittedChannels fitted;
};

/// How recordings were fitted.
struct FitReport {
  std::uint64_t samples = 0, keys = 0;
  std::uint64_t least_keys = 0;  ///< fewer cannot be within the tolerances
  double largest = 0;            ///< distance of a sample from the curve, in tolerances
  std::uint64_t line = 0;        ///< of that sample; 0: there are no samples

  /// Adds that of another recording.
  void add(const FitReport& other);
};

/// Notes of columns that a fit has no keys for.
std::vector<Note> notes_of_columns(const Schema& schema, const FitOptions& options);

/// The report in numbers of the input.
Note note_of(const FitReport& report, const FitOptions& options);

/// The keys of one recording.
struct FittedRows {
  std::vector<std::string> group;
  Table table;
  FitReport report;
};

/// The meaning of the curve that fits samples: that of its positions. Throws: Error (data) for an input that has no
/// times or is one of keys, and for a tolerance of a channel that it does not have.
Schema curve_of_fit(const Input& samples, const CurveSettings& rules, const FitOptions& options);

/// The meaning of the keys of that curve as rows, which also have slopes, or tension, continuity and bias. Throws:
/// Error as curve_of_fit().
Schema keys_of_fit(const Input& samples, const CurveSettings& rules, const FitOptions& options);

/// The samples of a curve. Throws: Error (data) for missing numbers, fewer than two samples, a tolerance near the
/// spacing of doubles, and a time to keep that no sample has.
Samples recorded_samples(const InputCurve& curve, const Schema& schema, const CurveSettings& rules,
                         const FitOptions& options);

/// Fits samples. A pure function. Throws: Error (data) where no keys can be within the tolerances.
FitResult fitted(const Samples& samples, const FitOptions& options, const SamplesDone& done = {}, unsigned threads = 1);

FittedRows rows_of(const Samples& samples, const FitResult& result, const FitOptions& options);

}  // namespace tcb
