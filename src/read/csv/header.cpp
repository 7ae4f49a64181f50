// Header of delimited text: names and roles of the columns, from the first three records.
#include "read/csv/header.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <limits>
#include <optional>
#include <utility>

#include "io/encoding.hpp"
#include "numbers/parse_number.hpp"
#include "read/csv/errors.hpp"
#include "read/csv/invalid_number.hpp"
#include "read/csv/tokenizer.hpp"
#include "schema/near_misses.hpp"
#include "schema/rotation_columns.hpp"
#include "text/utf8.hpp"

namespace tcb {
namespace {

using HeadCells = std::vector<std::string_view>;

std::vector<std::string> texts(const HeadCells& cells) {
  std::vector<std::string> result;
  std::ranges::transform(cells, std::back_inserter(result), unquoted);
  return result;
}

/// The names in a comment line such as "# timestamp tx ty tz".
std::vector<std::string> comment_names(std::string_view comment, const Dialect& dialect) {
  comment.remove_prefix(dialect.comment.size());
  const Chunk chunk{std::string(comment), 1, 0};
  const Dialect no_comments{dialect.delimiter, ""};
  HeadCells cells;
  Tokenizer(chunk, no_comments).next(cells);
  return texts(cells);
}

/// The first three records of an input, or as many as there are: enough to find header and columns.
class HeadRecords {
 public:
  struct Record {
    std::vector<std::string> cells;
    std::string comment;    ///< the comment line directly above
    std::size_t chunk = 0;  ///< index of its chunk, and the offset there
    std::size_t offset = 0;
    std::uint64_t line = 1;
  };

  HeadRecords(const Source<Chunk>& source, const Dialect& dialect) {
    while (records.size() < 3) {
      std::optional<Chunk> chunk = source();
      if (!chunk) break;
      add(std::move(*chunk), dialect);
    }
  }

  std::vector<Record> records;
  std::vector<Chunk> chunks;  ///< with records, or with a line that ends a curve

 private:
  void add(Chunk chunk, const Dialect& dialect) {
    Tokenizer tokenizer(chunk, dialect);
    const std::size_t before = records.size();
    bool more = true;
    for (HeadCells cells; records.size() < 3 && (more = tokenizer.next(cells));) {
      if (!tokenizer.comment().empty() || tokenizer.follows_blank()) comment_.clear();
      if (!tokenizer.comment().empty()) comment_ = tokenizer.comment();
      records.push_back(
          {texts(cells), std::exchange(comment_, {}), chunks.size(), tokenizer.offset(), tokenizer.line()});
    }
    if (!more && tokenizer.follows_blank()) comment_.clear();
    if (!more && !tokenizer.comment().empty()) comment_ = tokenizer.comment();
    if (records.size() == before && !tokenizer.broken()) return;
    if (records.size() == before) chunk.text = "\n";
    if (!records.empty()) chunks.push_back(std::move(chunk));
  }

  std::string comment_;  ///< the last line, if it is a comment
};

/// Whether the cell looks like a number. One with the other decimal mark, or with
/// separators of thousands, does too, and is an error later.
bool may_be_number(std::string_view cell, const DelimitedHead& head) {
  return is_missing_sign(cell, head.rules.signs) || Decimals({}).looks_numeric(cell) ||
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
  if (samples && samples->groups.size() + samples->labels.size() < cells.size()) {
    cells = cells.first(cells.size() - samples->labels.size()).subspan(samples->groups.size());
  }
  return !std::ranges::all_of(cells, [&](const auto& cell) { return may_be_value(cell, head); });
}

/// A column holds numbers unless both of the first two data records have text in it, or it has neither cells nor a
/// name.
std::vector<bool> numeric_columns(const HeadRecords& first, std::size_t data, const std::vector<std::string>& names,
                                  const DelimitedHead& head) {
  const auto& one = first.records[data].cells;
  const auto& two = data + 1 < first.records.size() ? first.records[data + 1].cells : one;
  std::vector<bool> numeric(one.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    const std::string_view below = i < two.size() ? std::string_view(two[i]) : "";
    const bool nameless = i < names.size() && names[i].empty();
    const bool nothing = nameless && one[i].empty() && below.empty();
    numeric[i] = !nothing && (may_be_number(one[i], head) || (i < two.size() && may_be_number(below, head)));
  }
  return numeric;
}

/// Converts names to UTF-8, as which they can be written to every format. Returns their encoding, if it is another
/// one: spreadsheets write Windows-1252. Throws: Error (data) for names that are in neither encoding.
std::string convert_names(std::vector<std::string>& names, const TextPosition& position) {
  bool are_converted = false;
  for (std::string& name : names) {
    const std::size_t invalid = find_invalid_utf8(name);
    if (invalid == std::string::npos) continue;
    const auto converted = in_utf8(name, Encoding::windows_1252);
    if (!converted) throw column_name_not_utf8(name, name[invalid]).at(position);
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
  return role_of_name(name) != Role::position || std::ranges::any_of(options.roles, [&](const RoleRequest& role) {
           return std::ranges::count(role.columns, name) > 0;
         });
}

/// Whether a comment names columns: one of its words gives a role, and none is a number. Otherwise it may be any text,
/// or a key that was commented out.
bool are_names(const std::vector<std::string>& words, const DelimitedHead& head, const ColumnOptions& options) {
  const auto is_number = [&](const std::string& word) { return may_be_number(word, head); };
  return std::ranges::none_of(words, is_number) &&
         (options.timeless ||
          std::ranges::any_of(words, [&](const std::string& word) { return has_meaning(word, options); }));
}

/// Throws: Error (data) if the first record has another number of cells than there are names, if there are any.
void require_names_for_cells(const std::vector<std::string>& names, const HeadRecords::Record& row,
                             const DelimitedHead& head) {
  if (names.empty() || names.size() == row.cells.size()) return;
  const auto unlike = head.is_of_format ? line_unlike_format : row_unlike_header;
  throw unlike(row.cells.size(), names.size()).at({"", row.line, 1});
}

/// Throws: Error (data) if a column of text begins like a number in its first record.
void require_text(const Chunk& data, const DelimitedHead& head, const std::vector<bool>& numeric,
                  const std::vector<std::string>& names) {
  Tokenizer tokenizer(data, head.dialect);
  HeadCells cells;
  tokenizer.next(cells);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (!head.columns.cells[i].is_text || numeric[i]) continue;
    const std::string cell = unquoted(cells[i]);
    constexpr std::string_view minus = "\xE2\x88\x92";  // U+2212
    const std::size_t digit = cell.starts_with(minus) ? minus.size() : cell.find_first_not_of("+-.,");
    if (digit >= cell.size() || cell[digit] < '0' || cell[digit] > '9') continue;
    if (find_notation(cell) && !head.columns.has(Role::time)) {
      const auto name = i < names.size() ? names[i] : fmt::format("{}", i + 1);
      throw times_in_text_column(name, cell).at(tokenizer.position(cells[i]));
    }
    throw in_possible_text_column(why_not_number(fmt::format("column {}", i + 1), cell, head.marks))
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
    const std::size_t digit = cell.find_first_not_of("+-");
    const bool begins_like_number = digit < cell.size() && cell[digit] >= '0' && cell[digit] <= '9';
    if (numeric[i] || !begins_like_number || find_notation(cell)) continue;
    const std::string name = i < names.size() ? names[i] : fmt::format("column {}", i + 1);
    throw why_not_number(name, cell, head.marks).at({"", record.line, 0});
  }
}

/// Throws: Error (data) if the first record may be a header, or a key with a misspelt number: one of its cells is
/// text, another a number, and none a name with a meaning.
void require_clear_header(const HeadRecords::Record& record, const DelimitedHead& head, const ColumnOptions& options) {
  const auto is_number = [&](const std::string& cell) {
    return !is_missing_sign(cell, head.rules.signs) && may_be_number(cell, head);
  };
  const auto is_name = [&](const std::string& cell) { return !is_number(cell) && has_meaning(cell, options); };
  const auto number = std::ranges::find_if(record.cells, is_number);
  if (number == record.cells.end() || std::ranges::any_of(record.cells, is_name)) return;
  const auto text = std::ranges::find_if_not(record.cells, [&](const auto& cell) { return may_be_value(cell, head); });
  const auto fault = options.samples ? samples_header_unclear : header_unclear;
  throw fault(*text, *number).at({"", record.line, 1});
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
    throw other_delimiter_likely(dialect.delimiter, c).at({"", first.records[0].line, 1});
  }
}

/// Throws: Error (data) for an input of one line.
[[noreturn]] void refuse_header_alone(const HeadRecords::Record& record) {
  const bool carriage_returns =
      std::ranges::any_of(record.cells, [](const auto& cell) { return cell.find('\r') != std::string::npos; });
  throw(carriage_returns ? lines_end_in_carriage_returns() : header_without_rows()).at({"", record.line, 1});
}

/// The rotation that both of the first two records may have.
std::optional<spline::RotationForm> likely_rotation_of(const HeadRecords& first, const NumberMarks& marks) {
  if (first.records.size() < 2) return std::nullopt;
  std::array<std::optional<spline::RotationForm>, 2> found;
  for (std::size_t i = 0; i < found.size(); ++i) {
    std::vector<double> numbers;
    for (const std::string& cell : first.records[i].cells) {
      numbers.push_back(Decimals(marks).number(cell).value_or(std::numeric_limits<double>::quiet_NaN()));
    }
    found[i] = likely_rotation(numbers);
  }
  return found[0] == found[1] ? found[0] : std::nullopt;
}

/// The cell of the time, without quotes; empty where there is none.
std::string first_time(const std::vector<std::string>& cells, const Columns& columns) {
  const auto time = std::ranges::find(columns.cells, Role::time, &Columns::Column::role);
  const auto index = static_cast<std::size_t>(time - columns.cells.begin());
  return index < cells.size() ? cells[index] : "";
}

}  // namespace

DelimitedHead read_head(const Source<Chunk>& chunks, const Dialect& dialect, const InputOptions& options,
                        std::vector<Chunk>& rest) {
  const ColumnOptions& columns = options.columns;
  HeadRecords first(chunks, dialect);
  DelimitedHead head{dialect, {}, options.keys, {}, options.delimited.marks};
  head.is_of_format = !options.delimited.head.empty();
  if (first.records.size() == (head.is_of_format ? 1U : 0U)) throw columns.samples ? empty_samples() : empty_input();
  if (!options.delimited.delimiter) require_delimiter(first, dialect);
  const bool header = options.delimited.header.value_or(is_header(first.records[0], head, columns.samples));
  std::size_t data = header ? 1 : 0;
  std::vector<std::string> names = header ? first.records[0].cells : std::vector<std::string>{};
  TextPosition position{"", first.records[0].line, 0};  // of the names
  if (header && !options.delimited.header) require_clear_header(first.records[0], head, columns);
  if (data == first.records.size()) refuse_header_alone(first.records[0]);
  if (!header && !options.delimited.header && !first.records[0].comment.empty()) {
    auto above = comment_names(first.records[0].comment, dialect);
    if (above.size() == first.records[0].cells.size() && are_names(above, head, columns)) {
      names = std::move(above);
      --position.line;
    }
  }
  const auto& row = first.records[data];
  require_names_for_cells(names, row, head);
  head.encoding = convert_names(names, position);
  head.names_quaternion = !columns.samples && name_quaternion(names);
  rest.assign(first.chunks.begin() + static_cast<std::ptrdiff_t>(row.chunk), first.chunks.end());
  rest[0].text.erase(0, row.offset);
  rest[0].line = row.line;
  const auto numeric = numeric_columns(first, data, names, head);
  require_numbers(row, names, numeric, head);
  at_position(position, [&] {
    head.columns = columns.samples ? find_sample_columns(names, numeric, *columns.samples, columns.timeless)
                                   : find_columns(names, numeric, columns.roles, columns.timeless);
    if (!columns.samples) require_no_near_miss(names, head.columns, columns.roles, columns.timeless);
    head.units = units_of_keys(options.units, head.columns, first_time(row.cells, head.columns));
  });
  if (names.empty() && columns.roles.empty()) head.columns.likely_rotation = likely_rotation_of(first, head.marks);
  const bool chosen = std::ranges::any_of(columns.roles, [](const auto& role) { return role.role == Role::position; });
  if (!chosen && !columns.samples) require_text(rest[0], head, numeric, names);
  return head;
}

}  // namespace tcb
