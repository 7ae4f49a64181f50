// Sample table: a file of samples, read into memory.
#include "check/sample_table.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

#include "io/compression.hpp"
#include "keys/curves.hpp"
#include "read/reader.hpp"
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

/// The decimal mark of delimited text, from its first lines that are no comments.
char decimal_mark_of(std::string_view beginning, char of_keys) {
  while (beginning.starts_with('#')) beginning.remove_prefix(std::min(beginning.find('\n'), beginning.size() - 1) + 1);
  const bool delimited = beginning.find_first_of(";\t") != std::string_view::npos;
  const bool has_points = has_between_digits(beginning, '.') && of_keys == '.';  // otherwise these are in dates
  const bool commas = delimited && !has_points && has_between_digits(beginning, ',');
  return commas ? ',' : '.';
}

void append(SampleRows& rows, const KeyBlock& block) {
  rows.times.insert(rows.times.end(), block.keys.times.begin(), block.keys.times.end());
  rows.numbers.insert(rows.numbers.end(), block.keys.positions.begin(), block.keys.positions.end());
  rows.lines.insert(rows.lines.end(), block.text_positions.lines.begin(), block.text_positions.lines.end());
}

}  // namespace

SampleTable read_samples(const Comparison& comparison, Source<std::string> bytes, const Schema& keys,
                         std::optional<std::size_t> time_place) {
  bytes = decompressed(std::move(bytes));
  EarlierOutputReader provenance;
  if (comparison.recorded) {
    bytes = mapped(std::move(bytes), [&provenance](std::string text) {
      provenance.add(text);
      return text;
    });
  }
  std::string beginning = bytes().value_or("");
  InputOptions options;
  options.columns.samples =
      SampleNames{keys.time.name, keys.groups, keys.labels, time_place.value_or(0), comparison.maps};
  options.keys.missing = Missing::skip_cell;
  options.columns.timeless = !time_place;
  options.threads = comparison.threads.count();
  const UnitOptions& units = comparison.keys.input.units;
  options.units = {.frame_rate = units.frame_rate, .date_order = units.date_order, .are_optional = true};
  options.delimited.marks.decimal = decimal_mark_of(beginning, comparison.keys.input.delimited.marks.decimal);
  const Input input = open_input(comparison.file, preceded_by(std::move(beginning), std::move(bytes)), options);
  const Schema& schema = input.schema;
  SampleTable table{schema.named, schema.time.is_given, schema.time.name, schema.channels, input.facts.ignored, {}};
  Curves curves(schema, input.keys, {.any_order = true}, false);
  while (const std::optional<CurveKeys> curve = curves.next()) {
    SampleRows& rows = table.curves.emplace_back(SampleRows{curve->group, {}, {}, {}});
    while (const std::optional<KeyBlock> block = curve->keys()) append(rows, *block);
  }
  if (comparison.recorded) table.provenance = provenance.end();
  return table;
}

}  // namespace tcb
