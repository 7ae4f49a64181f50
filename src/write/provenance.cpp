// Provenance: how an output was made, in comment lines or in a JSON object; its recorder.
#include "write/provenance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "io/input_file.hpp"
#include "sample/rows.hpp"
#include "schema/key_block.hpp"
#include "text/suggest.hpp"
#include "text/utf8.hpp"
#include "write/layout.hpp"

namespace tcb {
namespace {

std::string line(std::string_view name, const std::string& value) {
  return fmt::format("# {}: {}\n", name, in_one_line(value));
}

/// A text as a JSON string, which is UTF-8: a name of a file may have other bytes.
std::string json_word(std::string_view text) {
  return json_text(find_invalid_utf8(text) == std::string::npos ? std::string(text) : printable(text));
}

std::string member(std::string_view name, std::string_view value) {
  return fmt::format("{}:{}", json_text(name), json_word(value));
}

Facts results_of(const Provenance& provenance, std::size_t input) {
  return input < provenance.results.size() ? provenance.results[input] : Facts{};
}

std::string json_member(const Provenance& provenance) {
  std::string out = "\"meta\":{" + member("program", provenance.program), inputs;
  for (const auto& [name, value] : provenance.rules) out += "," + member(name, value);
  out += "," + member("command", provenance.command);
  for (std::size_t i = 0; i < provenance.inputs.size(); ++i) {
    const auto& [name, digest] = provenance.inputs[i];
    inputs += fmt::format("{}{{{},{}", inputs.empty() ? "" : ",", member("name", name), member("sha256", digest));
    for (const auto& [result, value] : results_of(provenance, i)) inputs += "," + member(result, value);
    inputs += "}";
  }
  return out + fmt::format(",\"inputs\":[{}],\"curves\":{},\"keys\":{},\"rows\":{}}}", inputs, provenance.curves,
                           provenance.keys, provenance.rows);
}

/// A command that reads these files, none of which is taken for an option, for a shell.
std::string with_files(std::vector<std::string> command, const std::vector<std::string>& files) {
  const auto looks_like_option = [](std::string_view file) { return file.starts_with('-') && file != "-"; };
  if (std::ranges::any_of(files, looks_like_option)) command.emplace_back("--");
  command.insert(command.end(), files.begin(), files.end());
  return command_in_shell(command);
}

}  // namespace

std::string text_before_rows(const Provenance& provenance, const Format& format) {
  if (!format.offers(offer::marks)) return "";
  std::string out = fmt::format("# {}\n", provenance.program);
  for (const auto& [name, value] : provenance.rules) out += line(name, value);
  out += line("command", provenance.command);
  return out + "#\n";  // so that the comment directly above a row is empty, and not taken for a header
}

std::string text_after_rows(const Provenance& provenance, const Format& format) {
  if (format.nests) return json_member(provenance);
  if (!format.offers(offer::marks)) return "{" + json_member(provenance) + "}\n";
  std::string out;
  for (std::size_t i = 0; i < provenance.inputs.size(); ++i) {
    out += line("input", printable(provenance.inputs[i].first)) + line("sha256", provenance.inputs[i].second);
    for (const auto& [name, value] : results_of(provenance, i)) out += line(name, value);
  }
  for (const auto& [name, count] : {std::pair{"curves", provenance.curves}, std::pair{"keys", provenance.keys},
                                    std::pair{"rows", provenance.rows}}) {
    out += line(name, fmt::format("{}", count));
  }
  return out;
}

ProvenanceRecorder::ProvenanceRecorder(const std::optional<ProvenanceRequest>& request)
    : request_(request), provenance_(request ? Provenance{.program = request->program} : Provenance()) {}

Source<std::string> ProvenanceRecorder::observe_bytes(const std::string& path, Source<std::string> bytes) {
  if (!request_) return bytes;
  if (provenance_.inputs.empty()) {
    provenance_.command = with_files(request_->command, request_->files.value_or(std::vector{path}));
  }
  provenance_.inputs.emplace_back(shown_name(path), "");
  bytes_ = observed(std::move(bytes), [this](const std::string& part) { sha256_.add(part); });
  return [this] { return bytes_(); };
}

Source<KeyBlock> ProvenanceRecorder::observe_keys(Source<KeyBlock> keys) {
  if (!request_) return keys;
  ++provenance_.curves;
  keys_ = observed(std::move(keys), [this](const KeyBlock& block) { provenance_.keys += block.size(); });
  return [this] { return keys_(); };
}

Source<SampleBlock> ProvenanceRecorder::observe_rows(Source<SampleBlock> rows) {
  if (!request_) return rows;
  return observed(std::move(rows), [this](const SampleBlock& block) { provenance_.rows += block.rows(); });
}

void ProvenanceRecorder::set_results(Facts results) {
  if (!request_) return;
  provenance_.results.resize(provenance_.inputs.size());
  provenance_.results.back() = std::move(results);
}

void ProvenanceRecorder::end_curve() {
  while (request_ && keys_()) {
  }
}

void ProvenanceRecorder::end_input() {
  if (!request_) return;
  while (bytes_()) {
  }
  provenance_.inputs.back().second = sha256_.digest();
}

std::string ProvenanceRecorder::before_rows(const Format& format) const {
  return request_ ? text_before_rows(provenance_, format) : "";
}

std::string ProvenanceRecorder::after_rows(const Format& format) const {
  return request_ ? text_after_rows(provenance_, format) : "";
}

}  // namespace tcb
