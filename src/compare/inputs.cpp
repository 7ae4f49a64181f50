// Inputs of a comparison: reading keys into memory, and the file of samples.
#include "compare/inputs.hpp"

#include <utility>

#include "curve/fields.hpp"
#include "input/input.hpp"
#include "io/input_file.hpp"
#include "keys/curves.hpp"
#include "stream/source.hpp"

namespace tcb {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Whether the mark occurs between two digits.
bool has_between_digits(std::string_view text, char mark) {
  for (std::size_t at = text.find(mark); at != std::string_view::npos; at = text.find(mark, at + 1)) {
    if (at > 0 && at + 1 < text.size() && is_digit(text[at - 1]) && is_digit(text[at + 1])) return true;
  }
  return false;
}

char decimal_mark_of(std::string_view beginning) {
  const bool delimited = beginning.find_first_of(";\t") != std::string_view::npos;
  const bool commas = delimited && !has_between_digits(beginning, '.') && has_between_digits(beginning, ',');
  return commas ? ',' : '.';
}

void append(SampleRows& rows, const KeyBlock& block) {
  rows.times.insert(rows.times.end(), block.keys.times.begin(), block.keys.times.end());
  rows.numbers.insert(rows.numbers.end(), block.keys.positions.begin(), block.keys.positions.end());
  rows.lines.insert(rows.lines.end(), block.lines.begin(), block.lines.end());
}

}  // namespace

Source<KeyBlock> KeptCurve::keys() const {
  return [this, next = std::size_t{0}]() mutable {
    return next < blocks.size() ? std::optional(blocks[next++]) : std::nullopt;
  };
}

std::size_t KeptCurve::key_count() const {
  std::size_t count = 0;
  for (const KeyBlock& block : blocks) count += block.size();
  return count;
}

KeptCurves keep(const Job& job) {
  const std::string& path = job.files[0];
  InputOptions options = job.input;
  options.threads = job.threads();
  KeptCurves kept{open_input(path, read_file(path), options), {}};
  Curves curves(kept.input, job.curves, false);
  while (const std::optional<CurveKeys> curve = curves.next()) {
    KeptCurve& one = kept.curves.emplace_back(KeptCurve{curve->group, curve->curve_info, {}});
    while (std::optional<KeyBlock> block = curve->keys()) one.blocks.push_back(std::move(*block));
  }
  return kept;
}

SampleTable read_samples(const std::string& path, const Input& keys, bool timeless, unsigned threads) {
  Source<std::string> bytes = read_file(path);
  std::string beginning = bytes().value_or("");
  InputOptions options;
  options.samples = SampleNames{keys.time, keys.groups, keys.carried};
  options.missing = Missing::skip_cell;
  options.timeless = timeless;
  options.threads = threads;
  options.decimal = decimal_mark_of(beginning);
  Input input = open_input(path, preceded_by(std::move(beginning), std::move(bytes)), options);
  SampleTable table{input.named, input.timed, input.time, input.channels, input.ignored, {}};
  input.timed = false;  // rows may come in any order
  Curves curves(input, {}, false);
  while (const std::optional<CurveKeys> curve = curves.next()) {
    SampleRows& rows = table.curves.emplace_back(SampleRows{curve->group, {}, {}, {}});
    while (const std::optional<KeyBlock> block = curve->keys()) append(rows, *block);
  }
  return table;
}

ComparisonInputs read_inputs(const Job& job, const std::vector<std::size_t>& chosen) {
  ComparisonInputs inputs;
  inputs.keys = shown_name(job.files[0]);
  inputs.file = shown_name(job.comparison->file);
  inputs.threads = job.threads();
  inputs.kept = in_file(inputs.keys, [&] { return keep(job); });
  const bool timeless = !chosen.empty() && chosen[0] != field_of("time");
  in_file(inputs.file, [&] {
    inputs.table = read_samples(job.comparison->file, inputs.kept.input, timeless, inputs.threads);
    inputs.columns = match_columns(inputs.table, inputs.kept.input, chosen);
  });
  return inputs;
}

}  // namespace tcb
