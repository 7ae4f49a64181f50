// Typed options: the lookup of the texts of options by their names.
#include "cli/typed_options.hpp"

#include <algorithm>
#include <array>

#include "option_names.hpp"

namespace tcb {

const std::string& TypedOptions::text(std::string_view option) const {
  static const std::string none;
  const auto found = std::ranges::find(texts_, option, &std::pair<std::string_view, std::string>::first);
  return found == texts_.end() ? none : found->second;
}

void TypedOptions::set_text(std::string_view option, std::string text) {
  const auto found = std::ranges::find(texts_, option, &std::pair<std::string_view, std::string>::first);
  if (found == texts_.end()) {
    texts_.emplace_back(option, std::move(text));
  } else {
    found->second = std::move(text);
  }
}

bool TypedOptions::wants_text() const {
  return std::ranges::any_of(std::array{option::help, option::list_presets, option::version, option::generate},
                             [this](std::string_view option) { return has(option); });
}

}  // namespace tcb
