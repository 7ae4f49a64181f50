// Words of reports: numbers and lists, as text and as JSON.
#pragma once

#include <string>
#include <vector>

namespace tcb {

/// The shortest text that reads back as the same double; "nothing" where it is not a number, "-" where it is infinite.
std::string number_text(double value);

/// The same for JSON, where both are null.
std::string number_json(double value);

std::string list_json(const std::vector<std::string>& texts);

}  // namespace tcb
