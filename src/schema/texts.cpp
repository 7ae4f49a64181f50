// Texts of keys: groups and labels, and many texts in one string.
#include "schema/texts.hpp"

namespace tcb {

std::vector<std::string> contents(const std::vector<std::string>& group) {
  std::vector<std::string> texts;
  texts.reserve(group.size());
  for (const std::string& text : group) texts.emplace_back(content(text));
  return texts;
}

std::vector<std::string> group_title(const std::vector<std::string>& names, const std::vector<std::string>& group) {
  std::vector<std::string> title;
  for (std::size_t i = 0; i < group.size() && i < names.size(); ++i) {
    title.push_back(names[i] + "=" + std::string(content(group[i])));
  }
  return title;
}

}  // namespace tcb
