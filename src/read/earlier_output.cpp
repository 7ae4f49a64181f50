// Earlier outputs: their provenance in comment lines; that in JSON is read in read/json/provenance.cpp.
#include "read/earlier_output.hpp"

#include <fmt/format.h>

#include <optional>
#include <string_view>
#include <utility>

#include "error.hpp"
#include "option_names.hpp"
#include "read/json/provenance.hpp"

namespace tcb {
namespace {

/// The value of a comment line with this name.
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
  std::optional<EarlierOutput> output = reader.end();
  if (!output) {
    throw data_error("this file has no provenance; expected an output that was made with {}; give such a file",
                     option::meta);
  }
  return std::move(*output);
}

}  // namespace tcb
