// Reports of comparisons: as text, as JSON, and in a line.
#pragma once

#include <string>

namespace tcb {

struct Check;
struct Identification;

/// The report as text.
std::string text(const Check& check);
std::string text(const Identification& found);

/// The report as a JSON object.
std::string json(const Check& check);
std::string json(const Identification& found);

/// The result in a line, as a subtitle of a picture.
std::string in_short(const Check& check);
std::string in_short(const Identification& found);

}  // namespace tcb
