// Provenance: how an output was made, in comment lines or in a JSON object, written and read.
#include "output/provenance.hpp"

#include <fmt/format.h>

#include <string_view>

#include "error.hpp"
#include "input/json/json_input.hpp"
#include "output/layout.hpp"
#include "text/refusal.hpp"

namespace tcb {
namespace {

std::string line(std::string_view name, const std::string& value) {
  return fmt::format("# {}: {}\n", name, in_one_line(value));
}

std::string member(std::string_view name, std::string_view value) {
  return fmt::format("{}:{}", json_text(name), json_text(value));
}

/// The member "meta" of a JSON object.
std::string json_member(const Provenance& provenance) {
  std::string out = "\"meta\":{" + member("program", provenance.program), options, inputs;
  for (const auto& [name, value] : provenance.rules) out += "," + member(name, value);
  for (const std::string& option : provenance.options) options += (options.empty() ? "" : ",") + json_text(option);
  for (const auto& [name, digest] : provenance.inputs) {
    inputs += fmt::format("{}{{{},{}}}", inputs.empty() ? "" : ",", member("name", name), member("sha256", digest));
  }
  return out + fmt::format(",\"options\":[{}],\"inputs\":[{}],\"curves\":{},\"keys\":{},\"rows\":{}}}", options, inputs,
                           provenance.curves, provenance.keys, provenance.rows);
}

/// The value of a comment line with this name.
std::optional<std::string> value_of(std::string_view line, std::string_view name) {
  const std::string begin = fmt::format("# {}: ", name);
  if (!line.starts_with(begin)) return std::nullopt;
  return std::string(line.substr(begin.size()));
}

void read_line(Provenance& provenance, std::string_view line) {
  if (line.ends_with('\r')) line.remove_suffix(1);
  constexpr std::string_view program = "# tcbsample ";
  if (line.starts_with(program) && provenance.program.empty()) provenance.program = line.substr(2);
  if (auto option = value_of(line, "option")) provenance.options.push_back(std::move(*option));
  if (auto name = value_of(line, "input")) provenance.inputs.emplace_back(std::move(*name), "");
  if (auto digest = value_of(line, "sha256"); digest && !provenance.inputs.empty()) {
    provenance.inputs.back().second = *digest;
  }
}

/// Reads the comments among the complete lines of a text, and leaves the last, incomplete line.
void read_lines(Provenance& provenance, std::string& text) {
  std::string_view left = text;
  for (std::size_t end = left.find('\n'); end != std::string_view::npos; end = left.find('\n')) {
    if (left.starts_with('#')) read_line(provenance, left.substr(0, end));
    left.remove_prefix(end + 1);
  }
  text.erase(0, text.size() - left.size());
}

}  // namespace

std::string text_before_rows(const Provenance& provenance, FormatId format) {
  if (!format_of(format).has_header) return "";
  std::string out = fmt::format("# {}\n", provenance.program);
  for (const auto& [name, value] : provenance.rules) out += line(name, value);
  for (const std::string& option : provenance.options) out += line("option", option);
  return out + "#\n";  // so that no other comment is directly above a row, where it would be taken for a header
}

std::string text_after_rows(const Provenance& provenance, FormatId format) {
  if (format_of(format).nests) return json_member(provenance);
  if (!format_of(format).has_header) return "{" + json_member(provenance) + "}\n";
  std::string out;
  for (const auto& [name, digest] : provenance.inputs) out += line("input", name) + line("sha256", digest);
  for (const auto& [name, count] : {std::pair{"curves", provenance.curves}, std::pair{"keys", provenance.keys},
                                    std::pair{"rows", provenance.rows}}) {
    out += line(name, fmt::format("{}", count));
  }
  return out;
}

Provenance read_meta(const Source<std::string>& bytes) {
  Provenance provenance;
  std::string text;  // of JSON all, of lines the last one
  bool json = false;
  for (bool first = true; const std::optional<std::string> more = bytes(); first = false) {
    text += *more;
    if (first) json = text.starts_with('{') || text.starts_with('[');
    if (!json) read_lines(provenance, text);
  }
  text += '\n';
  if (json) {
    JsonProvenance found = read_json_provenance(text);
    provenance.program = std::move(found.program);
    provenance.options = std::move(found.options);
    provenance.inputs = std::move(found.inputs);
  } else {
    read_lines(provenance, text);
  }
  if (provenance.program.empty() || provenance.inputs.empty()) throw Error(Exit::data, ErrorCode::no_provenance);
  return provenance;
}

}  // namespace tcb
