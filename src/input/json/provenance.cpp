// Provenance in JSON: the member "meta" of an output.
#include "input/json/provenance.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

namespace tcb {
namespace {

using nlohmann::json;

/// The text without its rows.
json without_rows(std::string_view text) {
  const auto keep = [](int, json::parse_event_t event, json& parsed) {
    return event != json::parse_event_t::key || (parsed != "rows" && parsed != "curves");
  };
  return json::parse(text, keep, false);
}

std::string_view last_line(std::string_view text) {
  const std::size_t end = text.find_last_not_of(" \t\r\n") + 1;
  const std::size_t before = text.substr(0, end).find_last_of('\n');
  return text.substr(0, end).substr(before == std::string_view::npos ? 0 : before + 1);
}

std::string text_of(const json& object, const char* name) {
  const auto found = object.find(name);
  return found != object.end() && found->is_string() ? found->get<std::string>() : "";
}

}  // namespace

Provenance read_json_meta(std::string_view text) {
  json whole = without_rows(text);
  if (whole.is_discarded()) whole = without_rows(last_line(text));
  if (!whole.is_object() || !whole.contains("meta") || !whole["meta"].is_object()) return {};
  const json& object = whole["meta"];
  Provenance meta;
  meta.program = text_of(object, "program");
  for (const json& option : object.value("options", json::array())) {
    if (option.is_string()) meta.options.push_back(option.get<std::string>());
  }
  for (const json& input : object.value("inputs", json::array())) {
    if (input.is_object()) meta.inputs.emplace_back(text_of(input, "name"), text_of(input, "sha256"));
  }
  return meta;
}

}  // namespace tcb
