// Delimited text: from records to keys, by the header or by position.
#include "format/csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "error.hpp"
#include "format/number.hpp"

namespace tcb::format {
namespace {

using Cells = std::vector<std::string_view>;

std::string counted_cells(std::size_t count) { return fmt::format("{} {}", count, count == 1 ? "cell" : "cells"); }

/// Text as it is quoted in messages: cut to a length that fits a line.
std::string shown(std::string_view text) {
  constexpr std::size_t longest = 40;
  if (text.size() <= longest) return fmt::format("\"{}\"", text);
  std::size_t end = longest;
  while ((static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;  // not inside a character
  return fmt::format("\"{}…\"", text.substr(0, end));
}

[[noreturn]] void refuse_cell(const Records& records, std::string_view cell, const std::string& column) {
  const std::string text = unquoted(cell);
  if (is_missing(text)) {
    throw Error(Exit::data, records.place(cell),
                fmt::format("{}: {} where a number was expected; fill it in, or take the row out", column,
                            text.empty() ? "an empty cell" : shown(text)));
  }
  const bool too_large = looks_numeric(text);
  throw Error(Exit::data, records.place(cell),
              too_large
                  ? fmt::format("{}: {} is not a finite double; expected less than 1.8e308 in size; correct the cell",
                                column, shown(text))
                  : fmt::format("{}: {} is not a number; expected a decimal such as -1.5 or 2e3; correct the cell",
                                column, shown(text)));
}

/// Turns records into keys, one after another.
class KeyParser {
 public:
  KeyParser(const Chunk& chunk, const DelimitedHead& head, const spline::Tcb<double>& tcb)
      : head_(head), records_(chunk, head.dialect), tcb_(tcb) {
    const Columns& columns = head.columns;
    block_.keys.channels = columns.channels.size();
    block_.keys.common_tcb = tcb;
    carries_ease_ = columns.has(Role::ease_in) || columns.has(Role::ease_out);
    carries_tcb_ = columns.has(Role::tension) || columns.has(Role::continuity) || columns.has(Role::bias);
  }

  KeyBlock parse() {
    for (Cells cells; records_.next(cells);) add_key(cells);
    return std::move(block_);
  }

 private:
  void add_key(const Cells& cells) {
    require_cells(cells);
    spline::Keys<double>& keys = block_.keys;
    spline::Tcb<double> tcb = tcb_;
    spline::Ease<double> ease;
    keys.positions.resize(keys.positions.size() + keys.channels);
    double* const position = keys.positions.data() + keys.positions.size() - keys.channels;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const auto [role, channel] = head_.columns.cells[i];
      switch (role) {
        case Role::left_out: break;
        case Role::time: keys.times.push_back(time(cells[i])); break;
        case Role::position: position[channel] = number(cells[i], head_.columns.channels[channel]); break;
        case Role::tension: tcb.tension = number(cells[i], "tension"); break;
        case Role::continuity: tcb.continuity = number(cells[i], "continuity"); break;
        case Role::bias: tcb.bias = number(cells[i], "bias"); break;
        case Role::ease_in: ease.in = number(cells[i], "ease_in"); break;
        case Role::ease_out: ease.out = number(cells[i], "ease_out"); break;
      }
    }
    if (carries_tcb_) keys.tcbs.push_back(tcb);
    if (carries_ease_) keys.eases.push_back(ease);
    block_.lines.push_back(records_.line());
  }

  void require_cells(const Cells& cells) const {
    const std::size_t expected = head_.columns.cells.size();
    if (cells.size() == expected) return;
    throw Error(Exit::data, records_.place(cells[std::min(cells.size(), expected + 1) - 1]),
                fmt::format("a row of {}; expected {} as in the rows above; complete or correct the row, or give the "
                            "delimiter with -d",
                            counted_cells(cells.size()), expected));
  }

  double number(std::string_view cell, const std::string& column) const {
    const auto value = parse_number(bare(cell));
    if (!value) refuse_cell(records_, cell, column);
    return *value;
  }

  spline::Time<double> time(std::string_view cell) const {
    const auto value = parse_time(bare(cell));
    if (!value) refuse_cell(records_, cell, head_.columns.time);
    return *value;
  }

  /// A number in quotes is a number all the same.
  static std::string_view bare(std::string_view cell) {
    return cell.size() >= 2 && cell.front() == '"' ? cell.substr(1, cell.size() - 2) : cell;
  }

  const DelimitedHead& head_;
  Records records_;
  const spline::Tcb<double>& tcb_;
  bool carries_tcb_ = false;
  bool carries_ease_ = false;
  KeyBlock block_;
};

}  // namespace

KeyBlock parse_delimited(const Chunk& chunk, const DelimitedHead& head, const spline::Tcb<double>& tcb) {
  return KeyParser(chunk, head, tcb).parse();
}

Input open_delimited(Source<std::string> bytes, const InputOptions& options) {
  std::string beginning;
  std::optional<char> delimiter = options.delimiter;
  while (!delimiter) {
    const std::optional<std::string> more = bytes();
    beginning += more.value_or("\n");  // the last record may lack its line end
    delimiter = find_delimiter(beginning, options.comment);
    if (!more) {
      beginning.pop_back();
      break;
    }
  }
  const Dialect dialect{delimiter.value_or(','), options.comment};
  Source<Chunk> chunks = split_delimited(preceded_by(std::move(beginning), std::move(bytes)), dialect);
  Chunk rest;
  const auto head = std::make_shared<const DelimitedHead>(read_head(chunks, dialect, options, rest));
  const auto parse = [head, tcb = options.tcb](const Chunk& chunk) { return parse_delimited(chunk, *head, tcb); };
  const Columns& columns = head->columns;
  return {columns.named,
          columns.has(Role::time),
          columns.time,
          columns.channels,
          {},
          ordered_map(preceded_by(std::move(rest), std::move(chunks)), parse, options.threads),
          {},
          facts(*head)};
}

}  // namespace tcb::format
