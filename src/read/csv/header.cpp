// Header of delimited text: names and roles of the columns, from the first three records.
#include "read/csv/csv_reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>
#include <span>
#include <tuple>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "io/encoding.hpp"
#include "numbers/dates.hpp"
#include "numbers/parse_number.hpp"
#include "read/csv/splitter.hpp"
#include "read/csv/tokenizer.hpp"
#include "schema/doubts.hpp"
#include "schema/parameter_names.hpp"
#include "schema/usual_names.hpp"
#include "text/suggest.hpp"
#include "text/utf8.hpp"

namespace tcb {
namespace {

using HeadCells = std::vector<std::string_view>;
using HeadRows = std::vector<HeadCells>;

std::vector<std::string> texts(const HeadCells& cells) {
  std::vector<std::string> result;
  std::ranges::transform(cells, std::back_inserter(result), unquoted);
  return result;
}

/// Removes the numbers of columns, as in "1:time" and "time[1]", where all names have them.
void remove_numbers(std::vector<std::string>& names) {
  std::vector<std::string> bare_names;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string number = fmt::format("{}", i + 1);
    std::string_view name = names[i];
    for (const std::string& front : {number + ":", number + "=", "[" + number + "]", "(" + number + ")"}) {
      if (name.starts_with(front)) name.remove_prefix(front.size());
    }
    for (const std::string& end : {"[" + number + "]", "(" + number + ")"}) {
      if (name.ends_with(end)) name.remove_suffix(end.size());
    }
    if (name == names[i]) return;
    bare_names.emplace_back(trimmed(name));
  }
  names = std::move(bare_names);
}

/// The names in a comment line such as "# timestamp tx ty tz", between the delimiter, or between others if it has as
/// many parts as there are columns, or behind a title as in "columns: time, x".
std::vector<std::string> comment_names(std::string_view comment, const Dialect& dialect, std::size_t columns) {
  while (comment.starts_with(dialect.comment)) comment.remove_prefix(dialect.comment.size());
  if (const std::size_t colon = comment.find(':'); colon != std::string_view::npos) {
    const std::string_view title = trimmed(comment.substr(0, colon));
    const bool is_name = is_usual_time(title) || role_of_name(title) != Role::position || is_coordinate(title);
    auto names = comment_names(comment.substr(colon + 1), Dialect{dialect.delimiter, "\n"}, columns);
    if (!is_name && names.size() == columns) return names;
  }
  const Chunk chunk{std::string(comment), 1, 0};
  const Dialect no_comments{dialect.delimiter, ""};
  HeadCells cells;
  Tokenizer(chunk, no_comments).next(cells);
  for (const char delimiter : std::string_view("|,;\t")) {
    if (cells.size() != columns && std::ranges::count(comment, delimiter) + 1 == static_cast<std::ptrdiff_t>(columns)) {
      cells = split(comment, delimiter);
      std::ranges::transform(cells, cells.begin(), trimmed);
    }
  }
  std::vector<std::string> names = texts(cells);
  remove_numbers(names);
  return names;
}

bool are_units(const std::vector<std::string>& cells) { return tcb::are_units(HeadCells(cells.begin(), cells.end())); }

/// Whether a cell begins with a number, behind a sign, a minus of U+2212, or a currency.
bool begins_like_number(std::string_view cell) {
  for (const std::string_view sign : {"\u2212", "$", "\u20AC", "\u00A3"}) {
    if (cell.starts_with(sign)) cell.remove_prefix(sign.size());
  }
  const std::size_t digit = cell.find_first_not_of("+-., ");
  return digit < cell.size() && is_digit(cell[digit]);
}

bool is_text(std::string_view cell) { return !is_missing_sign(cell, {}) && !looks_numeric(cell); }

/// Whether a record may describe the columns whose names are above it: by their units, or by texts without numbers,
/// apart from such as "100: gps".
bool may_describe(const std::vector<std::string>& cells) {
  const auto may_be_number = [](std::string_view cell) {
    const std::size_t colon = cell.find(": ");
    const bool has_word = colon != std::string_view::npos && colon + 2 < cell.size() && !is_digit(cell[colon + 2]);
    return begins_like_number(cell) && !has_word;
  };
  return are_units(cells) || (std::ranges::none_of(cells, may_be_number) && std::ranges::any_of(cells, is_text));
}

/// The first three records of an input without up to three that may describe the columns, or as many as there are:
/// enough to find header and columns.
class HeadRecords {
 public:
  struct Record {
    std::vector<std::string> cells;
    std::vector<std::string> comments;  ///< the last two lines directly above, as far as they are comments
    std::size_t chunk = 0;              ///< index of its chunk, and the offset there
    std::size_t offset = 0;
    std::uint64_t line = 1;
  };

  HeadRecords(const Source<Chunk>& source, const Dialect& dialect) : delimiter_(dialect.delimiter) {
    while (records.size() < wanted_) {
      std::optional<Chunk> chunk = source();
      if (!chunk) break;
      add(std::move(*chunk), dialect);
    }
  }

  bool ends_in_comment() const { return !comments_.empty(); }

  std::vector<Record> records;
  std::vector<Chunk> chunks;  ///< with records, or with a line that ends a curve

 private:
  void add(Chunk chunk, const Dialect& dialect) {
    Tokenizer tokenizer(chunk, dialect);
    const std::size_t before = records.size();
    bool more = true;
    for (HeadCells cells; records.size() < wanted_ && (more = tokenizer.next(cells));) {
      add_comments(tokenizer);
      records.push_back(
          {texts(cells), std::exchange(comments_, {}), chunks.size(), tokenizer.offset(), tokenizer.line()});
      constexpr std::size_t most = 6;
      if (records.size() + 1 == wanted_ && wanted_ < most && may_describe(records.back().cells)) ++wanted_;
    }
    if (!more) add_comments(tokenizer);
    if (records.size() == before && !tokenizer.broken()) return;
    if (records.size() == before) chunk.text = "\n";
    if (!records.empty()) chunks.push_back(std::move(chunk));
  }

  void add_comments(const Tokenizer& tokenizer) {
    constexpr std::size_t most = 2;
    if (tokenizer.follows_blank()) comments_.clear();
    if (tokenizer.comment().empty()) return;
    for (const std::string_view line : split(tokenizer.comment(), '\n')) {
      if (!is_rule(line)) comments_.emplace_back(line);
    }
    if (comments_.size() > most) comments_.erase(comments_.begin(), comments_.end() - most);
  }

  /// Whether a comment is a line of dashes or the like, or nothing, unless that ends what an earlier output tells of
  /// itself. Beside blanks, nothing ends a remark.
  bool is_rule(std::string_view comment) const {
    const std::size_t text = comment.find_first_not_of("# \t\r");
    if (text != std::string_view::npos) return comment.find_first_not_of("#-=_*+~ \t\r") == std::string_view::npos;
    return delimiter_ != ' ' && (comments_.empty() || !comments_.back().starts_with("# command: "));
  }

  const char delimiter_;
  std::size_t wanted_ = 3;
  std::vector<std::string> comments_;  ///< above what follows, as in Record
};

/// Whether the cell looks like a number. One with the other decimal mark, or with
/// separators of thousands, does too, and is an error later.
bool may_be_number(std::string_view cell, const DelimitedHead& head) {
  return Decimals({}).looks_numeric(cell) || is_missing_sign(cell, head.rules.signs) ||
         Decimals(head.marks).looks_numeric(cell) || has_thousands_separators(cell) ||
         (head.dialect.delimiter != ',' && Decimals({','}).looks_numeric(cell));
}

/// Whether the cell is a value of a key and no name: it looks like a number, or is a time in words.
bool may_be_value(std::string_view cell, const DelimitedHead& head) {
  return may_be_number(cell, head) || find_notation(unquoted(cell));
}

/// Whether a cell is text. In samples the groups, which come first, and the labels, which come last, may be text.
bool is_header(const HeadRecords::Record& record, const DelimitedHead& head,
               const std::optional<SampleNames>& samples) {
  std::span<const std::string> cells = record.cells;
  const auto notation = find_notation(cells[0]);
  if (notation && is_date(*notation)) return false;
  if (samples && samples->groups.size() + samples->labels.size() < cells.size()) {
    cells = cells.first(cells.size() - samples->labels.size()).subspan(samples->groups.size());
  }
  return !std::ranges::all_of(cells, [&](const auto& cell) { return may_be_value(cell, head); });
}

/// Whether the first record numbers the columns besides the first one, which has no name, as pandas writes them.
bool has_numbered_columns(const HeadRecords& first) {
  const auto& names = first.records[0].cells;
  if (names.size() < 2 || !names[0].empty() || first.records.size() < 2) return false;
  for (std::size_t cell = 1; cell < names.size(); ++cell) {
    if (names[cell] != fmt::format("{}", cell - 1)) return false;
  }
  return !first.records[1].cells[0].empty();
}

/// A column holds numbers unless both of the first two data records have text in it, or it has neither cells nor a
/// name. Without names that is told of the first column of keys alone: a column of samples may begin without numbers.
std::vector<bool> numeric_columns(const HeadRecords& first, std::size_t data, const std::vector<std::string>& names,
                                  bool are_samples, const DelimitedHead& head) {
  const auto& one = first.records[data].cells;
  const auto& two = data + 1 < first.records.size() ? first.records[data + 1].cells : one;
  std::vector<bool> numeric(one.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    const std::string_view below = i < two.size() ? std::string_view(two[i]) : "";
    const bool nothing = one[i].empty() && below.empty() && (names.empty() ? i == 0 && !are_samples : names[i].empty());
    numeric[i] = !nothing && (may_be_number(one[i], head) || (i < two.size() && may_be_number(below, head)));
  }
  return numeric;
}

/// The only marks by which all numbers of the first keys are such; nothing where they are numbers without, or where
/// several marks may be meant, as in 1,234.
std::optional<NumberMarks> marks_of_numbers(const HeadRows& rows) {
  std::vector<std::string> numbers;
  for (const HeadCells& row : rows) {
    for (const std::string_view cell : row) {
      if (find_notation(cell)) continue;
      if (cell.find('.') != std::string_view::npos && parse_number(cell)) return std::nullopt;
      if (Decimals({','}).number(cell) ? !parse_number(cell) : has_thousands_separators(cell))
        numbers.emplace_back(cell);
    }
  }
  const auto fit = [&](const NumberMarks& marks) {
    Decimals decimals(marks);
    return !numbers.empty() &&
           std::ranges::all_of(numbers, [&](const std::string& cell) { return decimals.number(cell).has_value(); });
  };
  const auto* const found = std::ranges::find_if(other_marks, fit);
  const bool is_clear = found != other_marks.end() && !(fit({'.', ','}) && fit({','}));
  return is_clear ? std::optional(*found) : std::nullopt;
}

std::string marks_in_words(const NumberMarks& marks) {
  const std::string_view decimal = marks.decimal == ',' ? "comma" : "point";
  if (marks.thousands == 0) return fmt::format("the {} in numbers is taken as the decimal mark", decimal);
  return fmt::format("the {} in numbers is taken as the decimal mark, and {} as the mark between thousands", decimal,
                     in_quotes({&marks.thousands, 1}));
}

/// Converts names to UTF-8, as which they can be written to every format. Returns their encoding, if it is another
/// one: spreadsheets write Windows-1252. Throws: Error (data) for names that are in neither encoding.
std::string convert_names(std::vector<std::string>& names, const TextPosition& position) {
  bool are_converted = false;
  for (std::string& name : names) {
    const std::size_t invalid = find_invalid_utf8(name);
    if (invalid == std::string::npos) continue;
    const auto converted = in_utf8(name, Encoding::windows_1252);
    if (!converted)
      throw data_error(
          "the column name {} has the byte {:02X}, which is neither UTF-8 nor Windows-1252; expected UTF-8; convert "
          "the text from its encoding with iconv",
          in_quotes(name), static_cast<unsigned char>(name[invalid]))
          .at(position);
    name = *converted;
    are_converted = true;
  }
  return are_converted ? std::string(name_of(Encoding::windows_1252)) : "";
}

/// Names x, y, z and w after x, y and z, as in flattened poses, as the quaternion that they are. Whether there are
/// such.
bool name_quaternion(std::vector<std::string>& names) {
  constexpr std::array poses{std::array{"x", "y", "z", "x", "y", "z", "w"},
                             std::array{"x", "y", "z", "x.1", "y.1", "z.1", "w"}};  // as pandas names them
  constexpr std::array quaternion{"qx", "qy", "qz", "qw"};
  for (const auto& pose : poses) {
    const auto same = [](std::string_view one, std::string_view other) { return same_in_any_case(one, other); };
    const auto found = std::search(names.begin(), names.end(), pose.begin(), pose.end(), same);
    if (found == names.end()) continue;
    std::ranges::copy(quaternion, found + 3);
    return true;
  }
  return false;
}

/// Whether the name gives its column a role, or is requested.
bool has_meaning(const std::string& name, const ColumnOptions& options) {
  return role_of_name(name) != Role::position || options.has(name);
}

/// Whether a comment names columns: one of its words gives a role or, between delimiters, names a coordinate, or
/// several are parts of a date, and none is a number. Otherwise it may be any text, or a key that was commented out.
bool are_names(const std::vector<std::string>& words, const DelimitedHead& head, const ColumnOptions& options) {
  const auto is_number = [&](const std::string& word) {
    return !is_missing_sign(word, head.rules.signs) && may_be_number(word, head);
  };
  const auto is_known = [&](const std::string& word) {
    return has_meaning(word, options) || is_usual_time(word) || (head.dialect.delimiter != ' ' && is_coordinate(word));
  };
  const bool are_known = options.timeless || std::ranges::any_of(words, is_known) ||
                         std::ranges::all_of(words, is_coordinate) || !parts_of_date(words, {}).empty();
  return std::ranges::none_of(words, is_number) && are_known;
}

/// The names in the comments above a record, and the line of units below these.
std::pair<std::vector<std::string>, HeadRecords::Record> names_in_comments(const HeadRecords::Record& record,
                                                                           const DelimitedHead& head,
                                                                           const ColumnOptions& options) {
  std::vector<std::vector<std::string>> lines;
  for (const std::string& comment : record.comments) {
    lines.push_back(comment_names(comment, head.dialect, record.cells.size()));
  }
  const bool have_cells =
      std::ranges::all_of(lines, [&](const auto& words) { return words.size() == record.cells.size(); });
  if (lines.size() > 1 && have_cells && are_names(lines[0], head, options)) {
    HeadRecords::Record units;
    units.cells = std::move(lines[1]);
    units.line = record.line - 1;
    return {std::move(lines[0]), std::move(units)};
  }
  const bool has_names = !lines.empty() && lines.back().size() == record.cells.size();
  if (!has_names || !are_names(lines.back(), head, options)) return {};
  return {std::move(lines.back()), HeadRecords::Record()};
}

/// The columns of words of a first record that is no header, as it has numbers too: those in which the next record has
/// the same word or, where a comment above names the columns, another one.
std::vector<std::size_t> words_beside_numbers(const HeadRecords& first, const DelimitedHead& head,
                                              const ColumnOptions& options) {
  if (first.records.size() < 2) return {};
  const auto &one = first.records[0].cells, &two = first.records[1].cells;
  const auto is_number = [&](const std::string& cell) { return !cell.empty() && may_be_value(cell, head); };
  if (one.size() != two.size() || std::ranges::none_of(one, is_number)) return {};
  const bool are_named = !names_in_comments(first.records[0], head, options).first.empty();
  std::vector<std::size_t> words;
  for (std::size_t i = 0; i < one.size(); ++i) {
    const bool is_word = !may_be_value(one[i], head) && !may_be_value(two[i], head);
    if (is_word && (are_named || one[i] == two[i])) words.push_back(i);
  }
  return words;
}

/// What to do where the first row has another number of cells than the header: with another delimiter the records may
/// agree, or the first lines may be a title.
std::string remedy_for_row(const HeadRecords& first, std::size_t data, const Dialect& dialect) {
  const auto& row = first.records[data];
  for (const auto& [delimiter, name] :
       {std::pair('\t', "tab"), std::pair(';', "semicolon"), std::pair(',', "comma"), std::pair('|', "pipe")}) {
    const auto marks_in = [&, mark = delimiter](const HeadRecords::Record& record) {
      const std::string_view text = std::string_view(first.chunks[record.chunk].text).substr(record.offset);
      return std::ranges::count(text.substr(0, text.find('\n')), mark);
    };
    const auto marks = marks_in(row);
    const bool agree = std::ranges::all_of(first.records, [&](const auto& one) { return marks_in(one) == marks; });
    if (delimiter != dialect.delimiter && marks > 0 && agree) return fmt::format("give --delimiter {}", name);
  }
  const std::string lines = fmt::format("correct line {} or line {}", first.records[0].line, row.line);
  const auto is_name = [](const std::string& cell) {
    return role_of_name(cell) != Role::position || is_usual_time(cell);
  };
  const bool is_table = data + 1 < first.records.size() && first.records[data + 1].cells.size() == row.cells.size() &&
                        row.line > 1 && std::ranges::none_of(first.records[0].cells, is_name);
  return is_table
             ? fmt::format("{}, or give --skip-lines {} if what is above the row is no header", lines, row.line - 1)
             : lines;
}

/// Throws: Error (data) if the first record has another number of cells than there are names, if there are any.
void require_names_for_cells(const std::vector<std::string>& names, const HeadRecords& first, std::size_t data,
                             const DelimitedHead& head) {
  const auto& row = first.records[data];
  const std::size_t cells = row.cells.size();
  if (names.empty() || names.size() == cells) return;
  if (head.is_of_format) throw line_unlike_format(cells, names.size()).at({"", row.line, 1});
  const std::string_view names_of_rows =
      cells == names.size() + 1 ? "add a name to the header if the first cells name the rows, or " : "";
  throw data_error("the number of cells in the first row is {}, but {} in the header; expected the same number; {}{}",
                   cells, names.size(), names_of_rows, remedy_for_row(first, data, head.dialect))
      .at({"", row.line, 1});
}

/// Throws: Error (data) if a column of text begins like a number in its first record.
void require_text(const Chunk& data, const DelimitedHead& head, const std::vector<std::string>& names,
                  const std::vector<bool>& numeric) {
  Tokenizer tokenizer(data, head.dialect);
  HeadCells cells;
  tokenizer.next(cells);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (!head.columns.cells[i].is_text || numeric[i]) continue;
    const std::string cell = unquoted(cells[i]);
    if (!begins_like_number(cell) || find_notation(cell)) continue;
    const std::string name = i < names.size() ? names[i] : fmt::format("column {}", i + 1);
    const Error fault = why_not_number(name, cell, head.marks);
    if (is_coordinate(name)) throw Error(fault).at(tokenizer.position(cells[i]));
    const std::string column = in_shell(requested_as(names, i));
    throw data_error(
        "{}; or give --group {} if these texts tell curves apart, or --columns ignore={} to leave the column out",
        fault.message(), column, column)
        .at(tokenizer.position(cells[i]));
  }
}

/// Throws: Error (data) if no column besides the first numbers holds numbers, but one has cells that begin like a
/// number, such as "0,5".
void require_numbers(const HeadRecords::Record& record, const std::vector<std::string>& names,
                     const std::vector<bool>& numeric, const DelimitedHead& head) {
  if (std::ranges::count(numeric, true) > 1) return;
  for (std::size_t i = 0; i < record.cells.size(); ++i) {
    const std::string& cell = record.cells[i];
    if (numeric[i] || !begins_like_number(cell) || find_notation(cell)) continue;
    const std::string name = i < names.size() ? names[i] : fmt::format("column {}", i + 1);
    throw why_not_number(name, cell, head.marks).at({"", record.line, 0});
  }
}

/// The first record below the names that is a key, behind those that describe the columns. A text in a column of texts
/// may be that of a key.
std::size_t first_key(const std::vector<HeadRecords::Record>& records) {
  std::size_t key = 1;
  while (key < records.size() && may_describe(records[key].cells)) ++key;
  for (std::size_t i = 1; i < key; ++i) {
    auto names = records[0].cells, cells = records[i].cells;
    const auto& numbers = records[std::min(key, records.size() - 1)].cells;
    remove_unused(names, numbers.size());
    remove_unused(cells, numbers.size());
    const bool has_cells = cells.size() == names.size() && cells.size() == numbers.size();
    const bool is_rule = cells.size() == 1 && cells[0].find_first_not_of("-=_+*") == std::string::npos;
    bool describes = is_rule || (are_units(cells) && (key == records.size() || !has_cells));
    for (std::size_t cell = 0; has_cells && cell < cells.size(); ++cell) {
      describes = describes || (is_text(cells[cell]) && begins_like_number(numbers[cell]));
    }
    if (!describes) return i;
  }
  return key;
}

/// Notes the records between the names and the first key, and takes the unit of the times.
void take_descriptions(DelimitedHead& head, std::span<const HeadRecords::Record> records, const UnitOptions& options) {
  std::vector<std::string> units, lines;
  for (const HeadRecords::Record& record : records) {
    const bool has_units = are_units(record.cells);
    if (has_units && units.empty()) units = record.cells;
    if (!has_units) lines.push_back(fmt::format("{}", record.line));
  }
  if (!lines.empty()) {
    const bool is_one = lines.size() == 1;
    head.columns.doubts.push_back(fmt::format("line{} {} below the names {}, and {} left out", is_one ? "" : "s",
                                              fmt::join(lines, ", "), is_one ? "has no number" : "have no numbers",
                                              is_one ? "is" : "are"));
  }
  if (units.empty()) return;
  head.columns.doubts.push_back(fmt::format("the line below the names is taken as units: {}", listed(units)));
  const std::size_t cell = cell_of(head.columns, Role::time);
  if (cell >= units.size() || options.time || unit_of_time(head.columns.time)) return;
  const std::string_view unit = without_brackets(units[cell]);
  head.time_unit = unit_of_time(fmt::format("t [{}]", unit));
}

/// Throws: Error (data) if only the first cell of the first record has a text, above a record of names.
void require_no_title(const std::vector<HeadRecords::Record>& records) {
  if (records.size() < 2 || records[0].cells.size() < 2) return;
  const auto are_empty = [](const auto& cells) { return std::ranges::count(cells, "") + 1 == std::ssize(cells); };
  const auto &one = records[0].cells, &two = records[1].cells;
  if (one[0].empty() || !are_empty(one) || is_usual_time(one[0])) return;
  if (are_empty(two) || are_units(two) || !may_describe(two)) return;
  throw data_error("the line has one cell, {}, as titles do; expected the names of the columns; give --skip-lines {}",
                   in_quotes(one[0]), records[1].line - 1)
      .at({"", records[0].line, 1});
}

/// The cells of the first records, without reading further. Requires: `chunks` outlive them.
HeadRows cells_of(std::span<const Chunk> chunks, const Dialect& dialect) {
  constexpr std::size_t most = 100;
  HeadRows rows;
  try {
    for (const Chunk& chunk : chunks) {
      Tokenizer tokenizer(chunk, dialect);
      for (HeadCells cells; rows.size() < most && tokenizer.next(cells); rows.push_back(cells)) {
        std::ranges::transform(cells, cells.begin(), bare);
      }
    }
  } catch (const Error&) {
    return rows;  // the record is refused when it is read as a key
  }
  return rows;
}

/// The columns, beside others without numbers, that have numbers in all first records, as requests; empty: there are
/// none.
std::string numbers_beside_text(const HeadRows& rows, const DelimitedHead& head) {
  if (rows.size() < 3) return "";
  std::vector<std::string> columns;
  bool is_beside_text = false;
  for (std::size_t cell = 0; cell < rows[0].size(); ++cell) {
    const auto numbers = std::ranges::count_if(rows, [&](const HeadCells& row) {
      return cell < row.size() && !is_missing_sign(row[cell], {}) && may_be_number(row[cell], head);
    });
    if (numbers == std::ssize(rows)) columns.push_back(fmt::format("{}", cell + 1));
    is_beside_text = is_beside_text || (numbers == 0 && !rows[0][cell].empty());
  }
  if (columns.size() < 2 || !is_beside_text) return "";
  return fmt::format("time={},position={}", columns[0], fmt::join(columns.begin() + 1, columns.end(), ":"));
}

/// Throws: Error (data) if the first record may be a header, or a key with a misspelt number: one of its cells is
/// text, another a number, and none a name with a meaning.
void require_clear_header(const HeadRecords& first, const DelimitedHead& head, const ColumnOptions& options) {
  const HeadRecords::Record& record = first.records[0];
  const auto is_number = [&](const std::string& cell) {
    return !is_missing_sign(cell, head.rules.signs) && may_be_number(cell, head);
  };
  const auto is_name = [&](const std::string& cell) {
    return (has_meaning(cell, options) || is_usual_time(cell)) && !is_number(cell);
  };
  if (std::ranges::any_of(record.cells, is_name)) return;
  const auto number = std::ranges::find_if(record.cells, is_number);
  if (number == record.cells.end()) return;
  const auto text = std::ranges::find_if_not(record.cells, [&](const auto& cell) { return may_be_value(cell, head); });
  if (const std::string date = date_in_known_form(*text); !date.empty()) {
    const auto column = fmt::format("column {}", text - record.cells.begin() + 1);
    throw date_not_read(column, *text, date).at({"", record.line, 1});
  }
  Chunk data = first.chunks[record.chunk];
  data.text.erase(0, record.offset);
  const std::string columns = numbers_beside_text(cells_of({&data, 1}, head.dialect), head);
  const std::string remedy =
      options.samples ? "add a line of names above it, or remove the text"
      : columns.empty()
          ? "give --header if they are names, --no-header if they are not"
          : fmt::format(
                "give --no-header --columns {} for the columns that have only numbers, or --header if these "
                "are names",
                columns);
  throw data_error("the first record has both text, {}, and a number, {}; expected only names or only numbers; {}",
                   in_quotes(*text), in_quotes(*number), remedy)
      .at({"", record.line, 1});
}

/// A delimiter as the value of an option in a shell.
std::string delimiter_as_value(char c) {
  switch (c) {
    case ',': return "comma";
    case ';': return "semicolon";
    case '\t': return "tab";
    case '|': return "pipe";
    default: return c < ' ' ? fmt::format("$'\\x{:02X}'", static_cast<unsigned>(c)) : fmt::format("'{}'", c);
  }
}

/// Throws: Error (data) where each record is one cell, with the same number of some other character that may delimit.
void require_delimiter(const HeadRecords& first, const Dialect& dialect) {
  const auto is_single = [](const auto& record) { return record.cells.size() == 1; };
  if (first.records.size() < 2 || !std::ranges::all_of(first.records, is_single)) return;
  for (const char c : std::string_view("|:^~!&/\x1F\x01")) {
    const auto count = [c](const auto& record) { return std::ranges::count(record.cells[0], c); };
    const auto cells = count(first.records[0]);
    if (cells == 0 || std::ranges::any_of(first.records, [&](const auto& record) { return count(record) != cells; }))
      continue;
    throw data_error(
        "the rows have no delimiter {}, but each has {}; expected cells between delimiters; give --delimiter {}",
        in_quotes({&dialect.delimiter, 1}), in_quotes({&c, 1}), delimiter_as_value(c))
        .at({"", first.records[0].line, 1});
  }
}

/// Throws: Error (data) for a header of one name, in which the delimiter does not occur, but another one does.
void require_delimiter_in_header(const HeadRecords& first, const Dialect& dialect) {
  const HeadRecords::Record& header = first.records[0];
  const std::string text = header.cells[0] + "\n";
  const char other = delimiter_of(text, '.').value_or(' ');
  const bool is_other = other != ' ' && other != dialect.delimiter && text.find(other) != std::string::npos;
  const std::string_view given = std::string_view(first.chunks[header.chunk].text).substr(header.offset);
  if (header.cells.size() > 1 || !is_other || given.starts_with('"')) return;
  throw data_error(
      "the header {} has no delimiter {}, but {}; expected names between delimiters; give --delimiter {}, or quote the "
      "name if it is one",
      in_quotes(header.cells[0]), in_quotes({&dialect.delimiter, 1}), in_quotes({&other, 1}), delimiter_as_value(other))
      .at({"", header.line, 1});
}

/// Throws: Error (data) for an input of one line.
[[noreturn]] void refuse_header_alone(const HeadRecords::Record& record) {
  const bool carriage_returns =
      std::ranges::any_of(record.cells, [](const auto& cell) { return cell.find('\r') != std::string::npos; });
  throw(carriage_returns ? data_error("the input is a single line that contains carriage returns; expected a line for "
                                      "each key; change them to line feeds, as in tr '\\r' '\\n' <FILE | tcbsample")
                         : data_error("no row follows the header; expected a row for each key; see --help"))
      .at({"", record.line, 1});
}

/// The text of the time, without quotes; empty where there is none.
std::string first_time(const std::vector<std::string>& cells, const Columns& columns) {
  std::vector<std::string> parts;
  for (const std::size_t cell : columns.time_cells()) parts.push_back(cell < cells.size() ? cells[cell] : "");
  return joined_time(parts);
}

/// For each column, whether it may have a requested role, by its name in any case, with its unit or without, or by its
/// number.
std::vector<bool> requested_cells(const std::vector<std::string>& names, std::size_t cells,
                                  const ColumnOptions& options) {
  std::unordered_set<std::string> columns;
  for (const RoleRequest& request : options.roles) {
    for (const std::string& column : request.columns) columns.insert(in_lower_case(column));
  }
  const auto is_named = [&](std::string_view name) {
    return columns.contains(in_lower_case(name)) || columns.contains(in_lower_case(without_unit(name)));
  };
  std::vector<bool> requested(cells);
  for (std::size_t cell = 0; cell < cells && !columns.empty(); ++cell) {
    requested[cell] = (cell < names.size() && is_named(names[cell])) || columns.contains(fmt::format("{}", cell + 1));
  }
  return requested;
}

/// What columns mean by rules that look at their cells, as requests, with notes.
class RolesByCells {
 public:
  RolesByCells(std::vector<std::string>& names, const std::vector<bool>& numeric, const HeadRows& rows,
               const ColumnOptions& requested, const std::vector<RoleRequest>& parameters, bool has_rate)
      : names_(names),
        numeric_(numeric),
        rows_(rows),
        requested_(requested),
        requested_cells_(requested_cells(names, numeric.size(), requested)),
        is_parameter_(numeric.size()),
        has_rate_(has_rate) {
    std::unordered_map<std::string, Role> roles;
    for (const RoleRequest& request : parameters) {
      requested_.roles.push_back(request);
      roles.emplace(request.columns[0], request.role);
    }
    for (std::size_t cell = 0; cell < names.size() && !roles.empty(); ++cell) {
      auto found = roles.find(names[cell]);
      if (found == roles.end()) found = roles.find(fmt::format("{}", cell + 1));
      if (found == roles.end()) continue;
      requested_cells_[cell] = true;
      is_parameter_[cell] = found->second != Role::time;
    }
  }

  /// The request, with the roles that follow from cells. Throws: Error (data) where an index may be the time.
  ColumnOptions complete() {
    const bool is_given = requested_.has(Role::time) || requested_.timeless;
    if (!is_given) take_date_and_clock();
    if (!is_given && !requested_.has(Role::time)) take_parts_of_date();
    if (!requested_.has(Role::time) && !requested_.timeless && !has_rate_) take_time_beside_frames();
    if (!requested_.has(Role::time) && !requested_.timeless) take_only_time();
    if (!names_.empty()) leave_counters();
    leave_second_times();
    if (!requested_.has(Role::time) && !requested_.timeless) names_.empty() ? leave_labels() : take_dates();
    for (std::size_t i = 0; i < names_.size(); ++i) {
      if (names_[i].empty()) names_[i] = fmt::format("column {}", i + 1);
    }
    return requested_;
  }
  std::vector<std::string> notes() { return std::move(notes_); }

 private:
  bool is_requested(std::size_t cell) const { return requested_cells_[cell]; }

  void request(Role role, std::size_t cell) {
    requested_.roles.push_back({role, {requested_as(names_, cell)}});
    requested_cells_[cell] = true;
  }

  std::optional<TimeNotation> notation(std::size_t cell) const {
    return cell < rows_[0].size() ? find_notation(rows_[0][cell]) : std::nullopt;
  }
  /// Whether the cells of a column are dates without a time of day.
  bool has_days(std::size_t cell) const {
    if (cell >= rows_[0].size()) return false;
    const auto format = find_date_format(rows_[0][cell]);
    return format && format->before_clock == 0;
  }

  /// Dates in one column and times of day in another are one time.
  void take_date_and_clock() {
    std::optional<std::size_t> day, clock;
    for (std::size_t cell = 0; cell < numeric_.size(); ++cell) {
      if (is_requested(cell)) continue;
      const bool is_day = has_days(cell), is_clock = notation(cell) == TimeNotation::clock;
      if ((is_day && day) || (is_clock && clock)) return;
      if (is_day) day = cell;
      if (is_clock) clock = cell;
    }
    if (!day || !clock) return;
    for (std::size_t cell = 0; cell < names_.size(); ++cell) {
      if (cell != *day && cell != *clock && is_time(cell)) return;
    }
    request(Role::time, *day);
    request(Role::clock, *clock);
    notes_.push_back(fmt::format("the dates in column {} and the times of day in column {} are taken as one time",
                                 shown(*day), shown(*clock)));
  }

  /// A year, a month and a day in columns of these names are one time, with an hour, a minute and a second.
  void take_parts_of_date() {
    const std::vector<std::size_t> parts = parts_of_date(names_, rows_);
    if (names_.empty() || parts.empty() || std::ranges::any_of(parts, [&](auto cell) { return is_requested(cell); }))
      return;
    for (std::size_t cell = 0; cell < names_.size(); ++cell) {
      if (is_time(cell) && std::ranges::count(parts, cell) == 0) return;
    }
    std::vector<std::string> columns, shown_columns;
    for (const std::size_t cell : parts) {
      columns.push_back(requested_as(names_, cell));
      shown_columns.push_back(names_[cell]);
      requested_cells_[cell] = true;
    }
    requested_.roles.push_back({Role::time, columns});
    notes_.push_back(fmt::format("columns {} are taken as one time", listed(shown_columns)));
  }

  /// Of a column that counts frames and another one of times, the other one is the time.
  void take_time_beside_frames() {
    std::vector<std::size_t> times, frames;
    for (std::size_t cell = 0; cell < names_.size(); ++cell) {
      if (!is_time(cell) || is_requested(cell)) continue;
      (unit_of_time(names_[cell]) == TimeUnit::frames ? frames : times).push_back(cell);
    }
    if (times.size() != 1 || frames.size() != 1) return;
    request(Role::time, times[0]);
    request(Role::unused, frames[0]);
    notes_.push_back(fmt::format("column {} is taken as the time, and column {}, which counts frames, is left out",
                                 shown(times[0]), shown(frames[0])));
  }

  /// The only column called year, day, hour or the like, or whose name ends like a time, is the time, where no other
  /// one may be.
  void take_only_time() {
    for (std::size_t cell = 0; cell < names_.size(); ++cell) {
      if (is_time(cell) || notation(cell)) return;
    }
    const auto found = find_only_time(names_, rows_);
    if (!found || is_requested(*found)) return;
    request(Role::time, *found);
    notes_.push_back(only_time_is_taken(shown(*found)));
  }

  /// The only column of dates, or of times in words, is the time, where no name says which is.
  void take_dates() {
    for (std::size_t cell = 0; cell < names_.size(); ++cell) {
      if (is_time(cell)) return;
    }
    const auto times = only_times_in_words(std::span(rows_[0]).first(std::min(rows_[0].size(), names_.size())));
    if (!times || is_requested(times->cell)) return;
    const std::string column = shown(times->cell);
    if (names_[times->cell].empty()) names_[times->cell] = "time";
    request(Role::time, times->cell);
    notes_.push_back(times_in_words_are_taken(*times, column));
  }

  /// Columns of words before the first number or time, where columns have no names, are the names of the rows. A text
  /// that begins with a digit may be a time in an unknown notation.
  void leave_labels() {
    const auto is_label = [&](std::size_t cell) {
      const auto& row = rows_[0];
      return !numeric_[cell] && !(cell < row.size() && !row[cell].empty() && is_digit(row[cell][0]));
    };
    for (std::size_t cell = 0; cell < numeric_.size() && is_label(cell); ++cell) {
      if (is_requested(cell)) continue;
      request(Role::unused, cell);
      const bool is_empty = cell < rows_[0].size() && rows_[0][cell].empty();
      notes_.push_back(fmt::format("column {} is {}, and is left out", cell + 1, is_empty ? "empty" : "text"));
    }
  }

  /// Whether a column of times in words is among those that are not the index.
  bool has_times_in_words() const {
    for (std::size_t cell = 1; cell < numeric_.size(); ++cell) {
      if (notation(cell)) return true;
    }
    return false;
  }

  /// Whether another column than the index is the time by its name or a request.
  bool is_time(std::size_t cell) const {
    if (is_parameter_[cell]) return false;
    const Role role = role_of_name(names_[cell]);
    if (role != Role::position) return role == Role::time;
    return is_usual_time(names_[cell]) && !is_usual_counter(names_[cell]);
  }

  /// Beside other numbers, columns that count the rows by their names and cells are no positions.
  void leave_counters() {
    bool has_time = requested_.has(Role::time) || requested_.timeless || has_times_in_words();
    bool has_others = requested_.has(Role::position);
    std::vector<std::size_t> counters;
    for (std::size_t cell = 0; cell < names_.size(); ++cell) {
      has_time = has_time || is_time(cell);
      if (!numeric_[cell] || is_requested(cell) || is_time(cell) || is_usual_counter(names_[cell])) continue;
      if (role_of_name(names_[cell]) != Role::position) continue;
      if (!counts(cell)) {
        has_others = true;
      } else if (cell == 0 || !requested_.has(Role::position)) {
        counters.push_back(cell);
      }
    }
    if (counters.empty()) return;
    if (!has_time && counters[0] == 0 && is_index_name(names_[0])) {
      throw data_error(
          "{} counts the rows, and no other column is the time; expected a column of times; give --columns time=1 if "
          "it is the time, --columns time=NAME if another one is, or --parameter uniform if the keys have no times",
          names_[0].empty() ? "column 1 has no name and" : fmt::format("column {}", in_quotes(names_[0])));
    }
    if (!has_others) return;
    std::vector<std::string> left;
    const ColumnRequests columns(names_);
    for (const std::size_t cell : counters) {
      left.push_back(shown(cell));
      requested_.roles.push_back({Role::unused, {columns[cell]}});
      requested_cells_[cell] = true;
    }
    const bool is_one = left.size() == 1;
    notes_.push_back(fmt::format("column{} {} {} the rows, and {} not taken as {}", is_one ? "" : "s", listed(left),
                                 is_one ? "counts" : "count", is_one ? "is" : "are",
                                 is_one ? "a position" : "positions"));
  }

  /// Whether the cells of a column count, as its name says: numbers of records rise; others are one more each in the
  /// first rows, from 0 or 1, and rise or begin anew in the next ones.
  bool counts(std::size_t cell) const {
    constexpr std::size_t enough = 3;
    const std::string& name = names_[cell];
    const auto number = [&](const HeadCells& row) {
      return cell < row.size() ? in_digits<std::uint64_t>(row[cell]) : std::nullopt;
    };
    const auto first = number(rows_[0]);
    if (!first || rows_.size() < 2) return false;
    bool is_index = *first <= 1 && is_index_name(name) && (!name.empty() || cell == 0);
    bool is_record = rows_.size() >= enough && names_record(name);
    for (std::size_t row = 1; row < rows_.size() && (is_index || is_record); ++row) {
      const auto before = number(rows_[row - 1]), here = number(rows_[row]);
      const bool rises = here && before && *here > *before;
      const bool is_next = row >= enough ? rises : rises && *here == *before + 1;
      is_index = is_index && (is_next || (row > 1 && here == first));
      is_record = is_record && rises;
    }
    return is_index || is_record;
  }

  /// Beside a time by its name, other times that are called so are no position: since 1970, or as they rise.
  void leave_second_times() {
    bool has_time = requested_.has(Role::time);
    for (const std::string& name : names_) has_time = has_time || role_of_name(name) == Role::time;
    for (std::size_t cell = 0; cell < names_.size() && has_time; ++cell) {
      if (!numeric_[cell] || is_requested(cell) || role_of_name(names_[cell]) != Role::position) continue;
      const std::vector<std::string> words = words_of(names_[cell]);
      const bool is_time_by_name = is_time(cell) || ends_like_time(names_[cell]) ||
                                   (!words.empty() && lists_word("time timestamp stamp", words[0]));
      const bool is_since_1970 = cell < rows_[0].size() && unit_since_1970(rows_[0][cell]);
      if (!is_time_by_name || (!is_since_1970 && !rises(cell))) continue;
      request(Role::unused, cell);
      notes_.push_back(fmt::format("column {} has times as well, and is left out", shown(cell)));
    }
  }

  /// Whether each of the numbers of a column is greater than the one above it. Two rows tell little.
  bool rises(std::size_t cell) const {
    const auto number = [&](const HeadCells& row) {
      return cell < row.size() ? parse_number(row[cell]).value_or(std::nan("")) : std::nan("");
    };
    const auto falls = [&](const HeadCells& one, const HeadCells& next) { return !(number(one) < number(next)); };
    return rows_.size() > 2 && std::ranges::adjacent_find(rows_, falls) == rows_.end();
  }

  static bool is_index_name(std::string_view name) {
    constexpr std::string_view endings = "no nr num number index idx";
    const std::vector<std::string> words = words_of(name);
    if (name.ends_with('#') || (words.size() > 1 && lists_word(endings, words.back()))) return true;
    constexpr std::array names{"",   "index", "unnamed: 0", "row",   "rownames", "row_names", "no.", "nr.", "no",
                               "nr", "pt",    "point",      "punkt", "ptnum",    "record",    "key", "---"};
    return std::ranges::any_of(names, [&](std::string_view known) { return same_in_any_case(known, name); });
  }

  std::string shown(std::size_t cell) const {
    return cell < names_.size() && !names_[cell].empty() ? in_quotes(names_[cell]) : fmt::format("{}", cell + 1);
  }

  std::vector<std::string>& names_;
  const std::vector<bool>& numeric_;
  const HeadRows& rows_;
  ColumnOptions requested_;
  std::vector<bool> requested_cells_;  ///< for each column, whether that has a role of it
  std::vector<bool> is_parameter_;     ///< tension, continuity or bias by its name
  bool has_rate_;                      ///< the times are frames by an option
  std::vector<std::string> notes_;
};

/// The columns of numbers without those that are positions by their names alone and have no number in the first
/// records.
std::vector<bool> with_numbers(const std::vector<bool>& all, const std::vector<std::string>& names,
                               const HeadRows& rows, const DelimitedHead& head, const std::vector<bool>& requested) {
  std::vector<bool> numeric = all;
  for (std::size_t cell = 0; cell < names.size(); ++cell) {
    const auto has_none = [&](const HeadCells& row) {
      return cell >= row.size() || !begins_like_number(row[cell]) || is_missing_sign(row[cell], head.rules.signs);
    };
    if (requested[cell] || role_of_name(names[cell]) != Role::position) continue;
    if (std::ranges::all_of(rows, has_none)) numeric[cell] = false;
  }
  const auto is_time_in_words = [](std::string_view cell) { return find_notation(cell).has_value(); };
  const bool has_times = !rows.empty() && std::ranges::any_of(rows[0], is_time_in_words);
  return std::ranges::count(numeric, true) > (has_times ? 0 : 1) ? numeric : all;  // something has to be the position
}

/// Sets the columns of keys, with the doubts about them. `unread`: those that are not read unless they are requested.
void find_key_columns(DelimitedHead& head, std::vector<std::string>& names, std::vector<bool> numeric,
                      const HeadRows& rows, const InputOptions& options, const std::vector<std::size_t>& unread) {
  ColumnOptions requested = options.columns;
  const std::vector<bool> is_requested = requested_cells(names, numeric.size(), requested);
  numeric = with_numbers(numeric, names, rows, head, is_requested);
  for (const std::size_t cell : unread) {
    if (!is_requested[cell]) requested.roles.push_back({Role::unused, {fmt::format("{}", cell + 1)}});
  }
  std::vector<std::string> notes;
  std::vector<RoleRequest> parameters;
  if (!names.empty() && !head.is_of_format) {
    std::vector<bool> usable = numeric;
    const std::unordered_set<std::string_view> meant(options.delimited.meant.begin(), options.delimited.meant.end());
    for (std::size_t cell = 0; cell < usable.size(); ++cell) {
      usable[cell] = usable[cell] && !is_requested[cell] && !meant.contains(names[cell]);
    }
    parameters = parameters_by_name(names, usable, requested);
  }
  if (!rows.empty() && !head.is_of_format) {
    RolesByCells by_cells(names, numeric, rows, requested, parameters, options.units.frame_rate.has_value());
    requested = by_cells.complete();
    notes = by_cells.notes();
  } else {
    std::ranges::copy(parameters, std::back_inserter(requested.roles));
  }
  head.columns = requested.times_only ? find_time_column(names, numeric, requested.roles)
                                      : find_columns(names, numeric, requested.roles, requested.timeless);
  for (const std::size_t cell : unread) {
    if (is_requested[cell] || requested.times_only || head.is_of_format) continue;
    head.columns.cells[cell].is_text = true;
    head.columns.ignored.push_back(names.empty() ? fmt::format("column {}", cell + 1) : names[cell]);
  }
  for (std::size_t cell = 0; cell < numeric.size(); ++cell) {
    Columns::Column& column = head.columns.cells[cell];
    column.is_empty = column.is_text && std::ranges::all_of(rows, [&](const HeadCells& row) {
                        return cell >= row.size() || is_missing_sign(row[cell], head.rules.signs);
                      });
  }
  if (!head.is_of_format && !requested.times_only) {
    const FoundColumns found{
        .names = names,
        .rows = rows,
        .numeric = numeric,
        .columns = head.columns,
        .requested = options.columns,
        .parameters = parameter_sets(names, numeric, options.columns),
        .marks = head.marks,
        .is_plain = head.is_plain,
        .has_rotations = options.rotation.none || !options.rotation.requests.empty(),
        .has_tcb_scale = options.keys.tcb_scale != TcbScale::unknown || options.has_shown_tcb_scale,
        .has_time_unit = options.units.time.has_value(),
        .has_tangents = options.given.tangents || options.given.preset,
        .meant = options.delimited.meant,
        .array = options.delimited.array};
    std::ranges::copy(doubts_of_columns(found), std::back_inserter(notes));
    head.columns.time_gap = first_time_gap(found);
  }
  head.columns.doubts = std::move(notes);
}

/// The column of texts that may tell curves apart; empty where there is none.
std::string label_of(const DelimitedHead& head, const std::vector<std::string>& names, const HeadRows& rows) {
  const auto may_be_label = [](const Columns::Column& column) {
    return column.role == Role::ignored && column.is_text;
  };
  const bool has_time = head.columns.has(Role::time) && !head.columns.has(Role::nanoseconds);
  if (!has_time || std::ranges::none_of(head.columns.cells, may_be_label)) return "";
  std::vector<double> times;
  for (const HeadCells& cells : rows) {
    const std::string text = first_time(texts(cells), head.columns);
    const auto number = Decimals(head.marks).number(text);
    const KeyUnits& units = head.units;
    const auto seconds =
        number ? std::nullopt : read_time(text, units.notation, units.frame_rate.value_or(1), units.dates.order);
    times.push_back(number ? *number : seconds ? nearest_double(*seconds) : std::numeric_limits<double>::quiet_NaN());
  }
  return label_of_curves(head.columns, names, rows, times);
}

}  // namespace

DelimitedHead read_head(const Source<Chunk>& chunks, const Dialect& dialect, const InputOptions& options,
                        std::vector<Chunk>& rest) {
  const ColumnOptions& columns = options.columns;
  HeadRecords first(chunks, dialect);
  DelimitedHead head{dialect, {}, options.keys, {}, options.delimited.marks};
  head.is_of_format = !options.delimited.names.empty();
  head.is_plain = options.delimited.is_plain;
  if (first.records.empty() && first.ends_in_comment() && options.delimited.names.empty()) {
    throw data_error(
        "all lines begin with {}, as comments do; expected a row for each key; give --comment none if they are keys",
        in_quotes(dialect.comment));
  }
  if (first.records.empty())
    throw columns.samples ? data_error("the file is empty; expected samples; give the file that has them")
                          : data_error("the input is empty; expected a row for each key; see --help");
  if (!options.delimited.delimiter) require_delimiter(first, dialect);
  if (!options.delimited.header && !columns.samples && !head.is_of_format) require_no_title(first.records);
  std::vector<std::size_t> unread;
  if (!options.delimited.header && !columns.samples) unread = words_beside_numbers(first, head, columns);
  const bool is_numbered = unread.empty() && has_numbered_columns(first);
  const bool is_named = is_numbered || (unread.empty() && is_header(first.records[0], head, columns.samples));
  const bool header = options.delimited.header.value_or(is_named);
  if (header && !head.is_of_format) require_delimiter_in_header(first, dialect);
  std::size_t data = header ? 1 : 0;
  std::vector<std::string> names = header ? first.records[0].cells : std::vector<std::string>{};
  TextPosition position{"", first.records[0].line, 0};  // of the names
  if (header && !is_numbered && !options.delimited.header) require_clear_header(first, head, columns);
  const std::size_t below = data;
  if (header && !columns.samples && !head.is_plain) data = first_key(first.records);
  if (data == first.records.size()) refuse_header_alone(first.records[0]);
  std::span<const HeadRecords::Record> described = std::span(first.records).subspan(below, data - below);
  HeadRecords::Record units;
  if (!header && !options.delimited.header) {
    std::tie(names, units) = names_in_comments(first.records[0], head, columns);
    if (!units.cells.empty()) described = {&units, 1};
    if (!names.empty()) position.line -= units.cells.empty() ? 1 : 2;
  }
  const auto& row = first.records[data];
  if (head.is_of_format) {
    position = {};
    names = options.delimited.names;
    for (const std::string& other : options.delimited.others) {
      if (names.size() >= row.cells.size()) break;
      unread.push_back(names.size());
      names.push_back(other);
    }
  }
  if (header && dialect.delimiter == ' ' && names.size() > row.cells.size()) {
    const std::string_view text = first.chunks[first.records[0].chunk].text;
    const std::string_view line = text.substr(first.records[0].offset);
    const auto between = names_between_blanks(line.substr(0, line.find_first_of("\r\n")));
    if (between.size() == row.cells.size()) names.assign(between.begin(), between.end());
  }
  head.begins_with_value = may_be_value(row.cells[0], head);
  if (header && head.begins_with_value) remove_unused(names, row.cells.size());
  require_names_for_cells(names, first, data, head);
  head.facts.encoding = convert_names(names, position);
  head.facts.names_quaternion = !columns.samples && name_quaternion(names);
  rest.assign(std::move_iterator(first.chunks.begin() + static_cast<std::ptrdiff_t>(row.chunk)),
              std::move_iterator(first.chunks.end()));
  rest[0].text.erase(0, row.offset);
  rest[0].line = row.line;
  const HeadRows rows = cells_of(rest, dialect);
  const bool may_have_marks = !head.is_of_format && !columns.samples && !options.delimited.has_decimal;
  const auto marks = may_have_marks && head.marks == NumberMarks() ? marks_of_numbers(rows) : std::nullopt;
  if (marks) head.marks = *marks;
  const auto numeric = numeric_columns(first, data, names, columns.samples.has_value(), head);
  require_numbers(row, names, numeric, head);
  at_position(position, [&] {
    if (columns.samples) {
      head.columns = find_sample_columns(names, numeric, *columns.samples, columns.timeless);
    } else {
      find_key_columns(head, names, numeric, rows, options, unread);
    }
    take_descriptions(head, described, options.units);
    if (marks) head.columns.doubts.push_back(marks_in_words(head.marks));
    std::vector<std::string> times{first_time(row.cells, head.columns)};
    if (find_date_format(times[0])) {
      for (const HeadCells& cells : rows) times.push_back(first_time(texts(cells), head.columns));
    }
    const UnitOptions of_times = with_date_order(options.units, head.columns.time, times, head.columns.doubts);
    head.units = units_of_keys(of_times, head.columns, times[0]);
    if (!head.is_of_format && !columns.samples && !columns.times_only) {
      head.columns.label = label_of(head, names, rows);
    }
  });
  if (!columns.has(Role::position) && !columns.samples && !columns.times_only)
    require_text(rest[0], head, names, numeric);
  return head;
}

Error line_unlike_format(std::size_t cells, std::size_t expected) {
  return data_error(
      "the line has {} numbers; expected {}, as the format has; complete the line, or give another format to "
      "--input-format",
      cells, expected);
}

}  // namespace tcb
