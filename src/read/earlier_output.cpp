// Earlier outputs: their provenance in comment lines, or in the member "meta" of JSON.
#include "read/earlier_output.hpp"

#include <fmt/format.h>

#include <optional>
#include <string_view>
#include <utility>

#include "error.hpp"
#include "read/json/tape.hpp"

namespace tcb {
namespace {

using Kind = JsonNode::Kind;

std::optional<std::string> value_of(std::string_view line, std::string_view name) {
  const std::string begin = fmt::format("# {}: ", name);
  if (!line.starts_with(begin)) return std::nullopt;
  return std::string(line.substr(begin.size()));
}

void read_line(EarlierOutput& output, std::string_view line) {
  if (line.ends_with('\r')) line.remove_suffix(1);
  constexpr std::string_view program = "# tcbsample ";
  if (line.starts_with(program) && output.program.empty()) output.program = line.substr(2);
  if (auto option = value_of(line, "option")) output.options.push_back(std::move(*option));
  if (auto name = value_of(line, "input")) output.inputs.emplace_back(std::move(*name), "");
  if (auto digest = value_of(line, "sha256"); digest && !output.inputs.empty()) {
    output.inputs.back().second = *digest;
  }
}

/// Reads the comments among the complete lines of a text, and leaves the last, incomplete line.
void read_lines(EarlierOutput& output, std::string& text) {
  std::string_view left = text;
  for (std::size_t end = left.find('\n'); end != std::string_view::npos; end = left.find('\n')) {
    if (left.starts_with('#')) read_line(output, left.substr(0, end));
    left.remove_prefix(end + 1);
  }
  text.erase(0, text.size() - left.size());
}

std::string text_of(const JsonTape& tape, std::size_t object, std::string_view name) {
  const auto found = tape.member(object, name);
  return found && tape.kind(*found) == Kind::string ? std::string(tape.text(*found)) : "";
}

/// The elements of a member; none if it is no array.
std::vector<std::uint32_t> elements_of(const JsonTape& tape, std::size_t object, std::string_view name) {
  const auto found = tape.member(object, name);
  return found && tape.kind(*found) == Kind::array ? tape.elements(*found) : std::vector<std::uint32_t>{};
}

std::optional<EarlierOutput> provenance_of(const JsonTape& tape) {
  if (tape.kind(0) != Kind::object) return std::nullopt;
  const auto meta = tape.member(0, "meta");
  if (!meta || tape.kind(*meta) != Kind::object) return std::nullopt;
  EarlierOutput provenance;
  provenance.program = text_of(tape, *meta, "program");
  for (const std::size_t option : elements_of(tape, *meta, "options")) {
    if (tape.kind(option) == Kind::string) provenance.options.emplace_back(tape.text(option));
  }
  for (const std::size_t input : elements_of(tape, *meta, "inputs")) {
    if (tape.kind(input) != Kind::object) continue;
    provenance.inputs.emplace_back(text_of(tape, input, "name"), text_of(tape, input, "sha256"));
  }
  return provenance;
}

/// The member "meta" of JSON: of the object around the rows or the curves, or of the last one of lines; empty if there
/// is none.
EarlierOutput json_provenance(std::string_view text) {
  if (text.find("\"meta\"") == std::string_view::npos) return {};
  JsonSplitter splitter(each_of(std::deque{std::string(text)}));
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

}  // namespace

void EarlierOutputReader::add(std::string_view bytes) {
  MemoryUse(max_memory_).add(text_.size() + bytes.size());
  text_ += bytes;
  if (!begun_) json_ = text_.starts_with('{') || text_.starts_with('[');
  begun_ = true;
  if (!json_) read_lines(output_, text_);
}

std::optional<EarlierOutput> EarlierOutputReader::end() {
  text_ += '\n';
  if (json_) {
    output_ = json_provenance(text_);
  } else {
    read_lines(output_, text_);
  }
  if (output_.program.empty() || output_.inputs.empty()) return std::nullopt;
  return std::move(output_);
}

EarlierOutput read_earlier_output(const Source<std::string>& bytes, std::uint64_t max_memory) {
  EarlierOutputReader reader(max_memory);
  while (const std::optional<std::string> more = bytes()) reader.add(*more);
  if (std::optional<EarlierOutput> output = reader.end()) return std::move(*output);
  throw data_error("this file has no provenance; expected an output that was made with --meta; give such a file");
}

}  // namespace tcb
