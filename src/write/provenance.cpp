// Provenance: how an output was made, in comment lines or in a JSON object; its recorder.
#include "write/provenance.hpp"

#include <fmt/format.h>

#include <deque>
#include <string_view>

#include "error.hpp"
#include "io/digest.hpp"
#include "sample/rows.hpp"
#include "schema/key_block.hpp"
#include "text/utf8.hpp"
#include "write/layout.hpp"

namespace tcb {
namespace {

std::string line(std::string_view name, const std::string& value) {
  return fmt::format("# {}: {}\n", name, in_one_line(value));
}

/// A text as a JSON string, which is UTF-8: a name of a file or a word of the command line may have other bytes.
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
  std::string out = "\"meta\":{" + member("program", provenance.program), options, inputs;
  for (const auto& [name, value] : provenance.rules) out += "," + member(name, value);
  for (const std::string& option : provenance.options) options += (options.empty() ? "" : ",") + json_word(option);
  for (std::size_t i = 0; i < provenance.inputs.size(); ++i) {
    const auto& [name, digest] = provenance.inputs[i];
    inputs += fmt::format("{}{{{},{}", inputs.empty() ? "" : ",", member("name", name), member("sha256", digest));
    for (const auto& [result, value] : results_of(provenance, i)) inputs += "," + member(result, value);
    inputs += "}";
  }
  return out + fmt::format(",\"options\":[{}],\"inputs\":[{}],\"curves\":{},\"keys\":{},\"rows\":{}}}", options, inputs,
                           provenance.curves, provenance.keys, provenance.rows);
}

/// All bytes, read ahead. Throws: Error (data) if they have another SHA-256.
Source<std::string> verified(const Source<std::string>& bytes, const std::string& expected, const std::string& from) {
  std::deque<std::string> parts;
  Sha256 sha256;
  while (std::optional<std::string> more = bytes()) {
    sha256.add(*more);
    parts.push_back(std::move(*more));
  }
  if (const std::string digest = sha256.digest(); digest != expected)
    throw data_error("its SHA-256 is {}; expected {}, as recorded in {}; give the recorded file", digest, expected,
                     from);
  return each_of(std::move(parts));
}

}  // namespace

std::string text_before_rows(const Provenance& provenance, const Format& format) {
  if (!format.has_marks) return "";
  std::string out = fmt::format("# {}\n", provenance.program);
  for (const auto& [name, value] : provenance.rules) out += line(name, value);
  for (const std::string& option : provenance.options) out += line("option", option);
  return out + "#\n";  // so that the comment directly above a row is empty, and not taken for a header
}

std::string text_after_rows(const Provenance& provenance, const Format& format) {
  if (format.nests) return json_member(provenance);
  if (!format.has_marks) return "{" + json_member(provenance) + "}\n";
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
    : request_(request), provenance_(request ? request->meta : Provenance()) {}

Source<std::string> ProvenanceRecorder::observe_bytes(const std::string& name, Source<std::string> bytes) {
  if (!request_) return bytes;
  auto& inputs = provenance_.inputs;
  const auto& earlier = request_->earlier.inputs;
  if (!earlier.empty()) {
    if (inputs.size() == earlier.size())
      throw usage_error("there are more key files than {} was made from; expected {}; remove the rest", request_->from,
                        earlier.size());
    const auto& [first_name, digest] = earlier[inputs.size()];
    bytes = verified(bytes, digest, request_->from);
    inputs.emplace_back(first_name, "");  // the file may have another name now
  } else {
    inputs.emplace_back(name, "");
  }
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
  if (!request_) return "";
  if (provenance_.inputs.size() < request_->earlier.inputs.size()) {
    throw usage_error("there are fewer key files than {} was made from; expected {}; add the rest", request_->from,
                      request_->earlier.inputs.size());
  }
  return text_after_rows(provenance_, format);
}

}  // namespace tcb
