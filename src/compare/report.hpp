// Reports: what a comparison came to, as text and as JSON.
#pragma once

#include <string>

#include "compare/check.hpp"
#include "compare/identify.hpp"

namespace tcb {

/// For people, a line for each thing that is to be said.
std::string text(const Check& check);
std::string text(const Identified& identified);

/// A JSON object.
std::string json(const Check& check);
std::string json(const Identified& identified);

}  // namespace tcb
