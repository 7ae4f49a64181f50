// Fitting: the keys of a recording as rows, in place of the samples of a curve.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "app/job.hpp"
#include "app/progress.hpp"
#include "curve/rows.hpp"
#include "input/input.hpp"
#include "keys/curves.hpp"

namespace tcb {

/// The keys of one recording.
struct FittedRows {
  Table table;
  std::uint64_t rows = 0;
  Note note;  ///< how many samples and keys, and how far they are apart
};

/// The columns of the keys that fit samples, as those of an input. Throws: Error (data) for an input that has no times
/// or is one of keys, and for a tolerance of a channel that it does not have.
Input columns_of_fit(const Input& samples, const Job& job);

/// Fits the samples of a curve. Throws: Error (data) where no keys can be within the tolerances.
FittedRows fitted_rows(const CurveKeys& samples, const Input& input, const SamplingRequest& request, const Job& job);

}  // namespace tcb
