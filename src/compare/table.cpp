// Tables: someone's samples, as they stand in a file.
#include "compare/table.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

#include "input/reader.hpp"
#include "io/file.hpp"
#include "keys/curves.hpp"
#include "stream/stream.hpp"

namespace tcb {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// The mark stands between two digits somewhere.
bool has_between_digits(std::string_view text, char mark) {
  for (std::size_t at = text.find(mark); at != std::string_view::npos; at = text.find(mark, at + 1)) {
    if (at > 0 && at + 1 < text.size() && is_digit(text[at - 1]) && is_digit(text[at + 1])) return true;
  }
  return false;
}

char decimal_of(std::string_view beginning) {
  const bool apart = beginning.find_first_of(";\t") != std::string_view::npos;
  const bool commas = apart && !has_between_digits(beginning, '.') && has_between_digits(beginning, ',');
  return commas ? ',' : '.';
}

void append(SampleRows& rows, const KeyBlock& block) {
  rows.times.insert(rows.times.end(), block.keys.times.begin(), block.keys.times.end());
  rows.numbers.insert(rows.numbers.end(), block.keys.positions.begin(), block.keys.positions.end());
  rows.lines.insert(rows.lines.end(), block.lines.begin(), block.lines.end());
}

}  // namespace

InputOptions table_options(const Input& keys, bool timeless, unsigned threads) {
  InputOptions options;
  options.samples = SampleNames{keys.time, keys.groups, keys.carried};
  options.missing = Missing::skip_cell;
  options.timeless = timeless;
  options.threads = threads;
  return options;
}

SampleTable read_table(const std::string& path, InputOptions options) {
  Source<std::string> bytes = read_file(path);
  std::string beginning = bytes().value_or("");
  options.decimal = decimal_of(beginning);
  Input input = open_input(path, preceded_by(std::move(beginning), std::move(bytes)), options);
  SampleTable table{input.named, input.timed, input.time, input.channels, input.ignored, {}};
  input.timed = false;  // rows may stand in any order
  Curves curves(input, {}, false);
  while (const std::optional<CurveKeys> curve = curves.next()) {
    SampleRows& rows = table.curves.emplace_back(SampleRows{curve->group, {}, {}, {}});
    while (const std::optional<KeyBlock> block = curve->keys()) append(rows, *block);
  }
  return table;
}

}  // namespace tcb
