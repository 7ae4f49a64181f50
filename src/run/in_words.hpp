// In words: the rules of a curve and the requested samples, for provenance, explanations and pictures.
#pragma once

#include <string>

#include "numbers/rational.hpp"
#include "write/provenance.hpp"

namespace tcb {

struct CurveSpec;
struct SamplingRequest;

std::string number_in_words(const Rational& value);

/// The rules of a curve, as names and values.
Facts rules_in_words(const CurveSpec& spec);

/// The preset of a curve, and its rules.
Facts preset_in_words(const CurveSpec& spec);

/// The requested samples, as in "every 0.5 of time".
std::string samples_in_words(const SamplingRequest& request);

}  // namespace tcb
