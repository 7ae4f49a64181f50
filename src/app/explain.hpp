// What was found in a file and would be done with it, a line each.
#pragma once

#include <string>

#include "app/curve_pipeline.hpp"
#include "app/job.hpp"

namespace tcb {

/// Reads the keys of a file and places the samples of its curves, but works none of them out.
/// Throws: Error as resample() does.
std::string explanation(const std::string& path, const Job& plan);

/// The facts of a curve in words: names and values.
Facts in_words(const RuleFacts& facts);
Facts in_words(const PlacementFacts& facts);

/// How far the end is from the last row, and the remedy; empty where it is a row.
std::string remainder_in_words(const PlacedCurve& placed);

}  // namespace tcb
