// Reader of delimited text: from bytes to keys.
#include "read/csv/csv_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "io/encoding.hpp"
#include "numbers/parse_number.hpp"
#include "read/csv/delimiter.hpp"
#include "read/csv/errors.hpp"
#include "read/csv/invalid_number.hpp"
#include "read/csv/splitter.hpp"
#include "read/csv/tokenizer.hpp"
#include "read/errors.hpp"
#include "read/input_format.hpp"
#include "read/key_builder.hpp"
#include "schema/usual_names.hpp"
#include "stream/ordered_map.hpp"
#include "text/utf8.hpp"

namespace tcb {
namespace {

/// A cell as a text of a key: a whole number as a number, everything else as a string.
std::string text_of(std::string_view cell) {
  const std::string_view digits = cell.substr(cell.starts_with('-') ? 1 : 0);
  const bool is_digits = !digits.empty() && digits.find_first_not_of("0123456789") == std::string_view::npos;
  const bool whole = is_digits && (digits == "0" ? digits.size() == cell.size() : digits[0] != '0');
  return (whole ? "" : "\"") + unquoted(cell);
}

/// The characters of a number, which may be in quotes.
std::string_view bare(std::string_view cell) {
  return cell.size() >= 2 && cell.front() == '"' ? cell.substr(1, cell.size() - 2) : cell;
}

/// Reads the records of a chunk as keys.
class RecordReader {
 public:
  RecordReader(const Chunk& chunk, const DelimitedHead& head)
      : head_(head),
        tokenizer_(chunk, head.dialect),
        decimals_(head.marks),
        keys_(head.columns, head.rules, head.units) {
    const auto time = std::ranges::find(head.columns.cells, Role::time, &Columns::Column::role);
    time_cell_ = static_cast<std::size_t>(time - head.columns.cells.begin());
  }

  KeyBlock read() {
    while (!keys_.is_full() && next_record()) {
    }
    return keys_.finish();
  }

 private:
  bool next_record() {
    bool more = true, well_formed = true;
    try {
      more = tokenizer_.next(cells_);
    } catch (const Error& error) {
      keys_.add_fault(error);
      well_formed = false;
    }
    if (tokenizer_.broken()) keys_.break_curve();
    if (more && well_formed) add_key();
    return more;
  }

  void add_key() {
    const std::size_t expected = head_.columns.cells.size();
    if (cells_.size() != expected) {
      const auto unlike = head_.is_of_format ? line_unlike_format : wrong_number_of_cells;
      add_fault(cells_[std::min(cells_.size(), expected + 1) - 1], unlike(cells_.size(), expected));
      return;
    }
    keys_.begin_key();
    for (std::size_t i = 0; i < expected; ++i) read_cell(cells_[i], head_.columns.cells[i]);
    if (!keys_.complete_time()) add_fault(cells_[time_cell_], time_parts_not_whole(head_.columns.time));
    if (!keys_.end_key()) return;
    const bool timed = time_cell_ < expected;
    keys_.set_position(tokenizer_.line(), timed ? tokenizer_.position(cells_[time_cell_]).column : 1);
  }

  void read_cell(std::string_view cell, const Columns::Column& column) {
    switch (column.role) {
      case Role::ignored:
        if (column.is_text && tokenizer_.line() <= last_line_of_roles) require_text(cell);
        keys_.set_mark(column, cell);
        break;
      case Role::group:
      case Role::carry: read_text(cell, column); break;
      case Role::time:
        if (const auto time = decimals_.time(bare(cell));
            time && !is_given_sign(cell) && keys_.has_times_as_numbers()) {
          keys_.set_time(*time);
          if (keys_.keeps_decimals()) keys_.keep_decimal(column, decimals_.text(bare(cell)));
          if (keys_.scales()) scale(cell, column);
        } else if (!keys_.set_time_in_words(column, unquoted(cell))) {
          read_no_number(cell, column);
        }
        break;
      default:
        if (const auto number = decimals_.number(bare(cell)); number && !is_given_sign(cell)) {
          keys_.number(column) = *number;
          if (keys_.keeps_decimals()) keys_.keep_decimal(column, decimals_.text(bare(cell)));
          if (keys_.scales()) scale(cell, column);
        } else {
          read_no_number(cell, column);
        }
    }
  }

  void scale(std::string_view cell, const Columns::Column& column) {
    if (keys_.scale(column, decimals_.text(bare(cell)))) return;
    add_fault(cell, number_beyond_doubles(head_.columns.name_of(column), unquoted(cell)));
  }

  /// A number such as -999 may be a sign of a missing one.
  bool is_given_sign(std::string_view cell) const {
    const auto& signs = head_.rules.signs;
    return !signs.empty() && std::ranges::count(signs, bare(cell)) > 0;
  }

  /// A number in a column of text is a fault: that is a column of numbers with other texts in it.
  void require_text(std::string_view cell) {
    if (!decimals_.number(bare(cell))) return;
    add_fault(cell, number_in_text_column(fmt::format("column {}", index_of(cell) + 1), unquoted(cell)));
  }

  void read_no_number(std::string_view cell, const Columns::Column& column) {
    if (is_missing_sign(bare(cell), head_.rules.signs) && keys_.miss(column)) return;
    const std::string text = unquoted(cell);
    const std::string name = head_.columns.name_of(column);
    const bool is_time = column.role == Role::time;
    if (is_missing_sign(text, head_.rules.signs)) {
      const bool is_of_time = is_time || column.role == Role::nanoseconds;
      add_fault(cell, head_.columns.are_segments ? number_of_segment_is_missing(name, text)
                      : is_of_time               ? time_is_missing(name, text)
                                                 : number_is_missing(name, text));
    } else if (is_time && (!keys_.has_times_as_numbers() || find_notation(text))) {
      const bool has_notation = head_.units.notation == find_notation(text);
      add_fault(cell, has_notation ? no_such_time(name, text) : time_in_other_notation(name, text));
    } else if (is_word(text, column)) {
      add_fault(cell, word_in_column_of_numbers(name, text));
    } else {
      add_fault(cell, why_not_number(name, text, head_.marks));
    }
  }

  /// Whether a cell without digits is in a column that may hold words by its name.
  bool is_word(std::string_view text, const Columns::Column& column) const {
    const bool may_hold_words = column.role == Role::position && head_.columns.named;
    return may_hold_words && !is_coordinate(head_.columns.name_of(column)) && !looks_numeric(text) &&
           text.find_first_of("0123456789") == std::string_view::npos;
  }

  std::size_t index_of(std::string_view cell) const {
    return static_cast<std::size_t>(std::ranges::find(cells_, cell.data(), &std::string_view::data) - cells_.begin());
  }

  void read_text(std::string_view cell, const Columns::Column& column) {
    std::string text = text_of(cell);
    if (!head_.encoding.empty()) text = in_utf8(text, Encoding::windows_1252).value_or(text);
    const std::size_t invalid = find_invalid_utf8(text);
    if (invalid != std::string::npos) add_fault(cell, cell_not_utf8(unquoted(cell), text[invalid]));
    if (content(text).empty() && !keys_.miss(column)) add_fault(cell, group_is_empty(head_.columns.name_of(column)));
    keys_.set_text(column, std::move(text));
  }

  void add_fault(std::string_view cell, const Error& fault) {
    if (!keys_.is_full()) keys_.add_fault(fault.at(tokenizer_.position(cell)));
  }

  const DelimitedHead& head_;
  Tokenizer tokenizer_;
  Decimals decimals_;
  KeyBuilder keys_;
  std::vector<std::string_view> cells_;
  std::size_t time_cell_ = 0;
};

/// Whether the first line ends with CR and LF.
bool has_crlf(std::string_view text) {
  const std::size_t end = text.find('\n');
  return end != std::string_view::npos && text.substr(0, end).ends_with('\r');
}

/// Whether a quoted number with a decimal comma occurs, so that a comma outside quotes is the delimiter.
bool has_quoted_decimal(std::string_view text) {
  for (std::size_t comma = text.find(','); comma != std::string_view::npos; comma = text.find(',', comma + 1)) {
    const std::size_t begin = text.find_last_of("\",\n", comma - 1), end = text.find_first_of("\",\n", comma + 1);
    const bool is_quoted = comma > 0 && begin != std::string_view::npos && end != std::string_view::npos &&
                           text[begin] == '"' && text[end] == '"';
    if (is_quoted && Decimals({','}).number(text.substr(begin + 1, end - begin - 1))) return true;
  }
  return false;
}

}  // namespace

KeyBlock parse_delimited(const Chunk& chunk, const DelimitedHead& head) { return RecordReader(chunk, head).read(); }

Records open_delimited(Source<std::string> bytes, const InputOptions& options) {
  const std::optional<char> named = take_named_delimiter(bytes);
  const std::optional<char> delimiter = options.delimited.delimiter ? options.delimited.delimiter : named;
  Beginning beginning;
  if (delimiter) beginning.delimiter = *delimiter;
  if (!delimiter) beginning = find_delimiter(bytes, options.delimited);
  if (named) ++beginning.line;
  if (!options.delimited.head.empty()) {
    bytes = preceded_by(options.delimited.head + "\n", std::move(bytes));
    --beginning.line;
  }
  const Dialect dialect{beginning.delimiter, options.delimited.comment, options.columns.samples.has_value()};
  const bool is_decimal = dialect.delimiter == options.delimited.marks.decimal;
  if (is_decimal && !has_quoted_decimal(beginning.text)) throw decimal_comma_is_delimiter();
  Source<Chunk> chunks =
      split_delimited(preceded_by(std::move(beginning.text), std::move(bytes)), dialect, beginning.line);
  std::vector<Chunk> rest;
  const auto head = std::make_shared<const DelimitedHead>(read_head(chunks, dialect, options, rest));
  const bool crlf = has_crlf(rest.front().text);
  for (; !rest.empty(); rest.pop_back()) chunks = preceded_by(std::move(rest.back()), std::move(chunks));
  const auto parse = [head](const Chunk& chunk) { return parse_delimited(chunk, *head); };
  Records records{head->columns, head->units.notation, head->units.dates, head->units.epoch_unit};
  records.marks = {dialect.delimiter, options.delimited.marks.decimal, crlf};
  records.facts.encoding = head->encoding;
  records.facts.names_quaternion = head->names_quaternion;
  records.facts.comment = dialect.comment;
  records.keys.blocks = ordered_map(std::move(chunks), parse, options.threads);
  records.keys.traits.may_break =
      dialect.delimiter == ' ' || dialect.divided || options.keys.missing == Missing::break_curve;
  return records;
}

Records open_lines(const Format& format, Source<std::string> bytes, InputOptions options) {
  std::optional<char>& delimiter = options.delimited.delimiter;
  if (!delimiter && !format.has_any_delimiter) delimiter = format.delimiter;
  return open_delimited(std::move(bytes), options);
}

extern const InputFormat delimited_input{.open = open_lines, .fit = [](std::string_view) { return std::optional(1); }};

}  // namespace tcb
