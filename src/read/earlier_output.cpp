// Earlier outputs: their provenance in comment lines, or in the member "meta" of JSON.
#include "read/earlier_output.hpp"

#include <fmt/format.h>

#include <optional>
#include <string_view>
#include <utility>

#include "error.hpp"
#include "read/json/text.hpp"

namespace tcb {
namespace {

using Kind = Json::Kind;

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

std::string text_of(const Json& json, std::size_t object, std::string_view name) {
  const auto found = json.member(object, name);
  return found && json.is(*found, Kind::string) ? std::string(json.text(*found)) : "";
}

/// The elements of a member; none if it is no array.
std::vector<std::uint32_t> elements_of(const Json& json, std::size_t object, std::string_view name) {
  const auto found = json.member(object, name);
  return found && json.is(*found, Kind::array) ? json.values(*found) : std::vector<std::uint32_t>{};
}

std::optional<EarlierOutput> provenance_of(const Json& json, std::size_t object) {
  const auto meta = json.member(object, "meta");
  if (!meta || !json.is(*meta, Kind::object)) return std::nullopt;
  EarlierOutput provenance;
  provenance.program = text_of(json, *meta, "program");
  for (const std::size_t option : elements_of(json, *meta, "options")) {
    if (json.is(option, Kind::string)) provenance.options.emplace_back(json.text(option));
  }
  for (const std::size_t input : elements_of(json, *meta, "inputs")) {
    if (json.is(input, Kind::object)) {
      provenance.inputs.emplace_back(text_of(json, input, "name"), text_of(json, input, "sha256"));
    }
  }
  return provenance;
}

/// The member "meta" of JSON: of the object around the rows or the curves, or of the last one of lines; empty if there
/// is none.
EarlierOutput json_provenance(std::string_view text, std::uint64_t max_memory) {
  if (text.find("\"meta\"") == std::string_view::npos) return {};
  JsonBlocks blocks(each_of(std::deque{std::string(text)}), max_memory);
  EarlierOutput found;
  try {
    while (std::optional<JsonBlock> block = blocks.next()) {
      const Json json(std::move(block->text), block->begin, block->nodes);
      for (const std::size_t value : json.inside(0)) {
        if (auto provenance = provenance_of(json, value)) found = *std::move(provenance);
      }
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
    output_ = json_provenance(text_, max_memory_);
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
