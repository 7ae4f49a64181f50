// Delimited text: from records to keys, by the header or by position.
#include "input/csv/key_parser.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <memory>

#include "error.hpp"
#include "input/csv/delimiter.hpp"
#include "text/decimal_mark.hpp"
#include "text/refusal.hpp"

namespace tcb {
namespace {

using Cells = std::vector<std::string_view>;

std::string counted_cells(std::size_t count) { return fmt::format("{} {}", count, count == 1 ? "cell" : "cells"); }

/// A cell as a text that is kept: a whole number as such, everything else as a string.
std::string kept_text(std::string_view cell) {
  const std::string_view digits = cell.substr(cell.starts_with('-') ? 1 : 0);
  const bool is_digits = !digits.empty() && digits.find_first_not_of("0123456789") == std::string_view::npos;
  const bool whole = is_digits && (digits == "0" ? digits.size() == cell.size() : digits[0] != '0');
  return (whole ? "" : "\"") + unquoted(cell);
}

/// Turns records into keys, one after another.
class KeyParser {
 public:
  KeyParser(const Chunk& chunk, const DelimitedHead& head)
      : head_(head), columns_(head.columns), records_(chunk, head.dialect), decimals_(head.decimal) {
    block_.keys.channels = columns_.channels.size();
    block_.keys.common_tcb = head.tcb;
    carries_ease_ = columns_.has(Role::ease_in) || columns_.has(Role::ease_out);
    carries_tcb_ = columns_.has(Role::tension) || columns_.has(Role::continuity) || columns_.has(Role::bias);
    const auto is_time = [](const Columns::Column& column) { return column.role == Role::time; };
    time_cell_ = static_cast<std::size_t>(std::ranges::find_if(columns_.cells, is_time) - columns_.cells.begin());
    timed_ = time_cell_ < columns_.cells.size();
    texts_.resize(columns_.texts());
    if (head.keeps_decimals) written_.resize(NumberOfKey::position + columns_.channels.size());
  }

  KeyBlock parse() {
    while (block_.faults.size() < most_faults && next_record()) {
    }
    block_.break_after = breaks_;
    return std::move(block_);
  }

 private:
  bool next_record() {
    bool more = true, well_formed = true;
    try {
      more = records_.next(cells_);
    } catch (const Error& error) {
      block_.faults.push_back(error);
      well_formed = false;
    }
    breaks_ = breaks_ || records_.broken();
    if (more && well_formed) add_key();
    return more;
  }

  void add_key() {
    const std::size_t expected = columns_.cells.size();
    if (cells_.size() != expected) {
      refuse(cells_[std::min(cells_.size(), expected + 1) - 1],
             fmt::format("a row of {}; expected {} as in the rows above; complete or correct the row, or give the "
                         "delimiter with -d",
                         counted_cells(cells_.size()), expected));
      return;
    }
    const std::size_t faults = block_.faults.size();
    missing_ = false;
    tcb_ = head_.tcb;
    ease_ = {};
    spline::Keys<double>& keys = block_.keys;
    keys.positions.resize(keys.positions.size() + keys.channels);
    std::ranges::fill(written_, std::string());
    for (std::size_t i = 0; i < expected; ++i) read_cell(cells_[i], columns_.cells[i]);
    const bool breaks_off = missing_ && head_.missing == Missing::break_curve;
    if (block_.faults.size() > faults || (missing_ && !breaks_off)) {
      keys.positions.resize(keys.positions.size() - keys.channels);
      if (block_.faults.size() == faults) ++block_.skipped;
      return;
    }
    if (breaks_off) block_.gaps.push_back(block_.lines.size());
    if (timed_) keys.times.push_back(time_);
    if (carries_tcb_) keys.tcbs.push_back(tcb_);
    if (carries_ease_) keys.eases.push_back(ease_);
    for (const std::string& text : texts_) block_.texts.add(text);
    for (const std::string& decimal : written_) block_.decimals.add(decimal);
    if (std::exchange(breaks_, false)) block_.breaks.push_back(block_.lines.size());
    block_.lines.push_back(records_.line());
    block_.columns.push_back(timed_ ? static_cast<std::uint32_t>(records_.place(cells_[time_cell_]).column) : 1);
  }

  void read_cell(std::string_view cell, Columns::Column column) {
    spline::Keys<double>& keys = block_.keys;
    if (!written_.empty() && !may_miss(cell)) keep(cell, column);
    double* const position = keys.positions.data() + keys.positions.size() - keys.channels;
    switch (column.role) {
      case Role::left_out: break;
      case Role::time: read_time(cell); break;
      case Role::position: read_number(cell, columns_.channels[column.channel], position[column.channel], nan); break;
      case Role::tension: read_number(cell, "tension", tcb_.tension, tcb_.tension); break;
      case Role::continuity: read_number(cell, "continuity", tcb_.continuity, tcb_.continuity); break;
      case Role::bias: read_number(cell, "bias", tcb_.bias, tcb_.bias); break;
      case Role::ease_in: read_number(cell, "ease_in", ease_.in, 0); break;
      case Role::ease_out: read_number(cell, "ease_out", ease_.out, 0); break;
      case Role::group:
      case Role::carry: read_text(cell, column); break;
    }
  }

  /// Keeps a number as it is written.
  void keep(std::string_view cell, Columns::Column column) {
    if (const auto place = number_of_key(column)) written_[*place] = decimals_.text(bare(cell));
  }

  /// `otherwise`: what --missing skip-cell puts in the place of a number that is missing.
  void read_number(std::string_view cell, std::string_view name, double& number, double otherwise) {
    if (const auto value = decimals_.number(bare(cell))) {
      number = *value;
    } else if (may_miss(cell)) {
      number = otherwise;
      missing_ = missing_ || head_.missing != Missing::skip_cell;
    } else {
      refuse_number(cell, name);
    }
  }

  void read_time(std::string_view cell) {
    if (const auto value = decimals_.time(bare(cell))) {
      time_ = *value;
    } else if (may_miss(cell) && head_.missing != Missing::skip_cell) {
      time_ = Time(nan);
      missing_ = true;
    } else {
      refuse_number(cell, columns_.time);
    }
  }

  void read_text(std::string_view cell, Columns::Column column) {
    std::string& text = texts_[column.channel];
    text = kept_text(cell);
    const std::size_t foreign = find_foreign(text);
    if (foreign != std::string::npos)
      refuse(cell, fmt::format("{}: {}", shown(unquoted(cell)), foreign_byte(text[foreign])));
    if (column.role != Role::group || !content(text).empty()) return;
    missing_ = missing_ || head_.missing == Missing::skip_row;
    if (head_.missing == Missing::skip_row) return;
    refuse(cell, fmt::format("{}: an empty cell; expected what tells the curves apart; fill it in, or give --missing "
                             "skip-row",
                             columns_.groups[column.channel]));
  }

  bool may_miss(std::string_view cell) const { return head_.missing != Missing::error && is_missing(bare(cell)); }

  void refuse_number(std::string_view cell, std::string_view name) {
    refuse(cell, fmt::format("{}: {}", name, no_number(unquoted(cell), head_.decimal)));
  }

  void refuse(std::string_view cell, const std::string& message) {
    if (block_.faults.size() < most_faults) block_.faults.emplace_back(Exit::data, records_.place(cell), message);
  }

  /// A number in quotes is a number all the same.
  static std::string_view bare(std::string_view cell) {
    return cell.size() >= 2 && cell.front() == '"' ? cell.substr(1, cell.size() - 2) : cell;
  }

  static constexpr double nan = std::numeric_limits<double>::quiet_NaN();

  const DelimitedHead& head_;
  const Columns& columns_;
  Records records_;
  Decimals decimals_;
  Cells cells_;
  std::size_t time_cell_ = 0;
  bool timed_ = false, carries_tcb_ = false, carries_ease_ = false;
  bool breaks_ = false;   ///< the curve breaks off before the next key
  bool missing_ = false;  ///< the row at hand is not to be a key
  Time time_;
  spline::Tcb<double> tcb_;
  spline::Ease<double> ease_;
  std::vector<std::string> texts_;
  std::vector<std::string> written_;  ///< the numbers of the row at hand, where they are kept
  KeyBlock block_;
};

}  // namespace

KeyBlock parse_delimited(const Chunk& chunk, const DelimitedHead& head) { return KeyParser(chunk, head).parse(); }

Input open_delimited(Source<std::string> bytes, const InputOptions& options) {
  Beginning beginning;
  if (options.delimiter) beginning.delimiter = *options.delimiter;
  if (!options.delimiter) beginning = find_delimiter(bytes, options);
  const Dialect dialect{beginning.delimiter, options.comment, options.samples.has_value()};
  if (dialect.delimiter == options.decimal) {
    throw Error(Exit::data,
                "--decimal , cannot be where the delimiter is , too; expected another one; give it with "
                "-d, or take --decimal out");
  }
  Source<Chunk> chunks =
      split_delimited(preceded_by(std::move(beginning.text), std::move(bytes)), dialect, beginning.line);
  std::vector<Chunk> rest;
  const auto head = std::make_shared<const DelimitedHead>(read_head(chunks, dialect, options, rest));
  for (; !rest.empty(); rest.pop_back()) chunks = preceded_by(std::move(rest.back()), std::move(chunks));
  const auto parse = [head](const Chunk& chunk) { return parse_delimited(chunk, *head); };
  const Columns& columns = head->columns;
  Input input{columns.named, columns.has(Role::time), columns.time, columns.channels, {}, {}};
  input.keys = ordered_map(std::move(chunks), parse, options.threads);
  input.facts.delimiter = dialect.delimiter;
  input.facts.comment = dialect.comment;
  input.facts.decimal = options.decimal;
  input.facts.roles = columns.shape_roles();
  input.ignored = head->columns.left_out;
  input.groups = columns.groups;
  input.carried = columns.carried;
  input.may_miss = options.missing == Missing::skip_cell;
  input.may_break = dialect.delimiter == ' ' || dialect.divided || options.missing == Missing::break_curve;
  return input;
}

}  // namespace tcb
