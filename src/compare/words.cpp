// Words of reports: numbers and lists, as text and as JSON.
#include "compare/words.hpp"

#include <cmath>

#include "output/layout.hpp"
#include "text/number.hpp"

namespace tcb {

std::string number_text(double value) {
  if (std::isnan(value)) return "nothing";
  if (std::isinf(value)) return "-";
  std::string text;
  append_number(text, value);
  return text;
}

std::string number_json(double value) { return std::isfinite(value) ? number_text(value) : "null"; }

std::string list_json(const std::vector<std::string>& texts) {
  std::string list;
  for (const std::string& text : texts) list += (list.empty() ? "" : ",") + json_text(text);
  return "[" + list + "]";
}

}  // namespace tcb
