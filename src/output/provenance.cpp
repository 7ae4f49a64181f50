// Provenance: what an output says of how it was made, as comment lines or as a JSON object.
#include "output/provenance.hpp"

#include <fmt/format.h>

#include <optional>
#include <string_view>

#include "error.hpp"
#include "text/refusal.hpp"
#include "input/json/provenance.hpp"
#include "output/layout.hpp"

namespace tcb {
namespace {

std::string line(std::string_view name, const std::string& value) {
  return fmt::format("# {}: {}\n", name, in_one_line(value));
}

std::string member(std::string_view name, std::string_view value) {
  return fmt::format("{}:{}", json_text(name), json_text(value));
}

/// The value of a comment line with this name.
std::optional<std::string> value_of(std::string_view line, std::string_view name) {
  const std::string begin = fmt::format("# {}: ", name);
  if (!line.starts_with(begin)) return std::nullopt;
  return std::string(line.substr(begin.size()));
}

/// Takes what a comment line says.
void take(Provenance& meta, std::string_view line) {
  if (line.ends_with('\r')) line.remove_suffix(1);
  constexpr std::string_view program = "# tcbsample ";
  if (line.starts_with(program) && meta.program.empty()) meta.program = line.substr(2);
  if (auto option = value_of(line, "option")) meta.options.push_back(std::move(*option));
  if (auto name = value_of(line, "input")) meta.inputs.emplace_back(std::move(*name), "");
  if (auto digest = value_of(line, "sha256"); digest && !meta.inputs.empty()) meta.inputs.back().second = *digest;
}

/// Takes what the comments among whole lines say; what is left of the last one stays.
void take_lines(Provenance& meta, std::string& text) {
  std::string_view left = text;
  for (std::size_t end = left.find('\n'); end != std::string_view::npos; end = left.find('\n')) {
    if (left.starts_with('#')) take(meta, left.substr(0, end));
    left.remove_prefix(end + 1);
  }
  text.erase(0, text.size() - left.size());
}

}  // namespace

std::string meta_head(const Provenance& meta) {
  std::string out = fmt::format("# {}\n", meta.program);
  for (const auto& [name, value] : meta.rules) out += line(name, value);
  for (const std::string& option : meta.options) out += line("option", option);
  return out + "#\n";  // so that no other line stands above a row without a header, and is taken for one
}

std::string meta_tail(const Provenance& meta) {
  std::string out;
  for (const auto& [name, digest] : meta.inputs) out += line("input", name) + line("sha256", digest);
  for (const auto& [name, count] :
       {std::pair{"curves", meta.curves}, std::pair{"keys", meta.keys}, std::pair{"rows", meta.rows}}) {
    out += line(name, fmt::format("{}", count));
  }
  return out;
}

std::string meta_object(const Provenance& meta) {
  std::string out = "{" + member("program", meta.program), options, inputs;
  for (const auto& [name, value] : meta.rules) out += "," + member(name, value);
  for (const std::string& option : meta.options) options += (options.empty() ? "" : ",") + json_text(option);
  for (const auto& [name, digest] : meta.inputs) {
    inputs += fmt::format("{}{{{},{}}}", inputs.empty() ? "" : ",", member("name", name), member("sha256", digest));
  }
  return out + fmt::format(",\"options\":[{}],\"inputs\":[{}],\"curves\":{},\"keys\":{},\"rows\":{}}}", options, inputs,
                           meta.curves, meta.keys, meta.rows);
}

Provenance read_meta(const Source<std::string>& bytes) {
  Provenance meta;
  std::string text;  // of JSON all, of lines the last one
  bool json = false;
  for (bool first = true; const std::optional<std::string> more = bytes(); first = false) {
    text += *more;
    if (first) json = text.starts_with('{') || text.starts_with('[');
    if (!json) take_lines(meta, text);
  }
  text += '\n';
  if (json) {
    meta = read_json_meta(text);
  } else {
    take_lines(meta, text);
  }
  if (!meta.program.empty() && !meta.inputs.empty()) return meta;
  throw Error(Exit::data,
              "no provenance: it does not say how it was made; expected an output that was made with --meta");
}

}  // namespace tcb
