// Provenance in JSON: the member "meta" of an earlier output.
#include "read/json/provenance.hpp"

#include <algorithm>
#include <optional>

#include "error.hpp"
#include "read/json/tape.hpp"

namespace tcb {
namespace {

using Kind = JsonNode::Kind;

std::string text_of(const JsonTape& tape, std::size_t object, std::string_view name) {
  const auto found = tape.member(object, name);
  return found && tape.kind(*found) == Kind::string ? std::string(tape.text(*found)) : "";
}

/// Calls f for each element of a member that is an array.
template <class F>
void for_each_of(const JsonTape& tape, std::size_t object, std::string_view name, const F& f) {
  const auto found = tape.member(object, name);
  if (!found || tape.kind(*found) != Kind::array) return;
  tape.for_each_element(*found, [&](std::size_t value) { return f(value), true; });
}

std::optional<EarlierOutput> provenance_of(const JsonTape& tape) {
  if (tape.kind(0) != Kind::object) return std::nullopt;
  const auto meta = tape.member(0, "meta");
  if (!meta || tape.kind(*meta) != Kind::object) return std::nullopt;
  EarlierOutput provenance;
  provenance.program = text_of(tape, *meta, "program");
  for_each_of(tape, *meta, "options", [&](std::size_t option) {
    if (tape.kind(option) == Kind::string) provenance.options.emplace_back(tape.text(option));
  });
  for_each_of(tape, *meta, "inputs", [&](std::size_t input) {
    if (tape.kind(input) != Kind::object) return;
    provenance.inputs.emplace_back(text_of(tape, input, "name"), text_of(tape, input, "sha256"));
  });
  return provenance;
}

}  // namespace

/// It is in the object around the rows or the curves, or in one of the lines, of which it is the last.
EarlierOutput json_provenance(std::string_view text) {
  if (text.find("\"meta\"") == std::string_view::npos) return {};
  JsonSplitter splitter(
      [left = std::optional(std::string(text))]() mutable { return std::exchange(left, std::nullopt); });
  EarlierOutput found;
  try {
    while (const std::optional<JsonPart> part = splitter.next()) {
      if (part->kind == JsonPart::Kind::list) continue;
      JsonTape tape(*part);
      do {
        if (tape.size() == 0) continue;
        if (auto provenance = provenance_of(tape)) found = *std::move(provenance);
      } while (part->kind == JsonPart::Kind::values && tape.read_next());
    }
  } catch (const Error&) {  // a text that is not JSON, or is cut off
  }
  return found;
}

}  // namespace tcb
