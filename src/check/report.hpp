// Reports of comparisons as text and as JSON, and the comparison of two files from reading to report.
#pragma once

#include <string>

#include "check/check.hpp"
#include "check/ranking.hpp"

namespace tcb {

/// The report as text.
std::string text(const Check& check);
std::string text(const Identification& found);

/// The report as a JSON object.
std::string json(const Check& check);
std::string json(const Identification& found);

/// Compares and writes the report. Returns Exit::data if the samples do not agree with the curve.
/// Requires: job.comparison. Throws: Error, naming the file.
Exit compare(const Job& job);

}  // namespace tcb
