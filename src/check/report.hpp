// Reports of comparisons as text and as JSON, and the comparison of two files from reading to report.
#pragma once

#include <string>

#include "check/check.hpp"
#include "check/ranking.hpp"

namespace tcb {

/// Turns problems into words.
using ErrorWords = std::string (*)(const Error&);

/// The report as text.
std::string text(const Check& check, ErrorWords words);
std::string text(const Identification& found, ErrorWords words);

/// The report as a JSON object.
std::string json(const Check& check, ErrorWords words);
std::string json(const Identification& found, ErrorWords words);

/// Compares and writes the report. Returns Exit::data if the samples do not agree with the curve.
/// Requires: job.comparison. Throws: Error, naming the file.
Exit compare(const Job& job, ErrorWords words);

}  // namespace tcb
