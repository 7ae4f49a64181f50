// Provenance in JSON: the member "meta" of an earlier output.
#include "read/json/provenance.hpp"

#include <nlohmann/json.hpp>
#include <string>

namespace tcb {
namespace {

using Json = nlohmann::json;

/// The text without its rows.
Json without_rows(std::string_view text) {
  const auto keep = [](int, Json::parse_event_t event, Json& parsed) {
    return event != Json::parse_event_t::key || (parsed != "rows" && parsed != "curves");
  };
  return Json::parse(text, keep, false);
}

std::string_view last_line(std::string_view text) {
  const std::size_t end = text.find_last_not_of(" \t\r\n") + 1;
  const std::size_t before = text.substr(0, end).find_last_of('\n');
  return text.substr(0, end).substr(before == std::string_view::npos ? 0 : before + 1);
}

std::string text_of(const Json& object, const char* name) {
  const auto found = object.find(name);
  return found != object.end() && found->is_string() ? found->get<std::string>() : "";
}

}  // namespace

EarlierOutput json_provenance(std::string_view text) {
  if (text.find("\"meta\"") == std::string_view::npos) return {};
  Json whole = without_rows(text);
  if (whole.is_discarded()) whole = without_rows(last_line(text));
  if (!whole.is_object() || !whole.contains("meta") || !whole["meta"].is_object()) return {};
  const Json& object = whole["meta"];
  EarlierOutput provenance;
  provenance.program = text_of(object, "program");
  for (const Json& option : object.value("options", Json::array())) {
    if (option.is_string()) provenance.options.push_back(option.get<std::string>());
  }
  for (const Json& input : object.value("inputs", Json::array())) {
    if (input.is_object()) provenance.inputs.emplace_back(text_of(input, "name"), text_of(input, "sha256"));
  }
  return provenance;
}

}  // namespace tcb
