// The ending of --output, which names the format of the output.
#include "cli/output_ending.hpp"

#include <optional>
#include <string>

#include "cli/errors.hpp"
#include "formats/formats.hpp"
#include "formats/other_files.hpp"
#include "option_names.hpp"

namespace tcb {
namespace {

/// The format that the ending of an output names, if it does. Throws: Error (usage) for the ending of other files.
const Format* format_by_ending(const std::string& path) {
  const Format* const named = find_output_format(path);
  const std::string other(other_ending(path));
  if (named == nullptr && !other.empty()) throw output_not_written(path, other);
  return named;
}

}  // namespace

void set_output_format(TypedOptions& typed, bool earlier) {
  const std::string& path = typed.text(option::output);
  const bool is_report = typed.has(option::check) || typed.has(option::identify);
  const Format* const named = format_by_ending(path);
  if (named == nullptr || (is_report && !named->has_reports)) return;
  const std::string_view name = named->name, chosen = typed.output.format->name;
  if (typed.has(option::output_format) || typed.has(option::plot) || earlier) {
    if (named->ending != typed.output.format->ending) throw output_of_other_format(path, name, chosen);
    return;
  }
  if (named == &formats().front()) return;  // as without the ending
  typed.output.format = named;
  typed.set_text(option::output_format, std::string(name));
}

}  // namespace tcb
