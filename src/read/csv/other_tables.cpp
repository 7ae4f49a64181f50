// Texts that are no tables: lines above a table and below it, numbers within other text, cells with lines between them.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "numbers/parse_number.hpp"
#include "numbers/time_notation.hpp"
#include "read/csv/csv_reader.hpp"
#include "schema/key_rules.hpp"
#include "schema/usual_names.hpp"
#include "text/suggest.hpp"

namespace tcb {
namespace {

bool is_letter(char c) { return lower(c) >= 'a' && lower(c) <= 'z'; }

/// Whether a line has this number of words with some delimiter, so that it may be the names of as many columns.
bool has_words(std::string_view line, std::size_t count) {
  return std::ranges::any_of(std::string_view("\t;, "), [&](char delimiter) {
    const auto words = split(line, delimiter);
    return words.size() - static_cast<std::size_t>(std::ranges::count(words, "")) == count;
  });
}

/// Throws: Error (data) where lines are drawn between the cells, as programs print tables for people.
void require_no_drawing(std::string_view text, std::uint64_t first) {
  constexpr std::string_view corner = "\xE2\x94", double_corner = "\xE2\x95";  // of box-drawing characters
  constexpr int most_lines = 4;
  std::size_t end = 0;
  for (int line = 0; line < most_lines && end < text.size(); ++line)
    end = std::min(text.find('\n', end), text.size()) + 1;
  const std::vector<std::string_view> lines = split(text.substr(0, end), '\n');
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::string_view line = lines[i];
    const bool is_rule = line.find("--") != std::string_view::npos &&
                         line.find_first_of("|+") != std::string_view::npos &&
                         line.find_first_not_of("-+|:= \r") == std::string_view::npos;
    const bool is_box = line.starts_with(corner) || line.starts_with(double_corner);
    if (!is_rule && !is_box) continue;
    throw data_error(
        "the table is drawn with lines between its cells; expected cells between delimiters; export it as CSV")
        .at({"", first + i, 0});
  }
}

/// The text of a line with # for each number, which are counted unless they are parts of words; empty where a mark of
/// dates and times divides numbers.
std::string without_numbers(std::string_view line, std::size_t& numbers) {
  std::string text;
  for (std::size_t at = 0; at < line.size();) {
    if (!is_digit(line[at])) {
      text += line[at++];
      continue;
    }
    const std::size_t size = text.size();
    if (size > 1 && text[size - 2] == '#' && std::string_view(":/-").find(text.back()) != std::string_view::npos)
      return "";
    if (text.empty() || !is_letter(text.back())) ++numbers;
    at = std::min(line.find_first_not_of("0123456789.eE", at), line.size());
    text += '#';
  }
  std::erase(text, '-');
  return text;
}

/// Whether a line begins with a bracket. Requires: it is not empty.
bool is_open(std::string_view line) { return std::string_view("([{<").find(line[0]) != std::string_view::npos; }

/// Whether a word begins somewhere, not as a unit or an exponent behind a number.
bool has_word(std::string_view text) {
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (is_letter(text[at]) && (at == 0 || (text[at - 1] != '#' && !is_letter(text[at - 1])))) return true;
  }
  return false;
}

/// What is behind the time that begins a line, such as "[2024-03-01 10:00:00.5]"; nothing where none does.
std::optional<std::string_view> behind_time(std::string_view line) {
  const auto skip = [&](std::string_view characters) {
    const std::size_t size = std::min(line.find_first_not_of(characters), line.size());
    line.remove_prefix(size);
    return size;
  };
  skip("[(<");
  const std::size_t end = line.find_first_not_of("0123456789-");
  if (end == 10 && end < line.size() && find_notation(line.substr(0, end))) line.remove_prefix(end + 1);
  constexpr std::string_view digits = "0123456789";
  if (skip(digits) == 0 || skip(":") != 1 || skip(digits) != 2 || skip(":") != 1 || skip(digits) != 2)
    return std::nullopt;
  if (line.size() > 1 && (line[0] == '.' || line[0] == ',') && is_digit(line[1])) {
    line.remove_prefix(1);
    skip(digits);
  }
  return line;
}

/// Throws: Error (data) where a time begins the first two lines, and numbers are within the same text behind it.
void require_no_log(std::string_view one, std::string_view two, char delimiter) {
  const auto rest = behind_time(one), below = behind_time(two);
  const auto cells = split(one, delimiter);
  if (!rest || !below || (delimiter != ' ' && find_notation(bare(trimmed(cells[0]))))) return;
  constexpr std::size_t of_time = 2;
  for (std::size_t i = of_time; delimiter == ' ' && i < cells.size(); ++i) {
    if (cells[i] != "->" && looks_numeric(cells[i])) return;
  }
  std::size_t numbers = 0, numbers_below = 0;
  const std::string text = without_numbers(*rest, numbers);
  const bool has_text = has_word(text) || rest->find("->") != std::string_view::npos;
  if (!has_text || numbers == 0 || without_numbers(*below, numbers_below) != text) return;
  throw data_error(
      "a time and other text begin each line, as in {}; expected cells between delimiters; write the time and the "
      "numbers alone",
      in_quotes(one));
}

/// A line of the input without blanks around it, and its number from 1.
struct NumberedLine {
  std::string_view text;
  std::uint64_t number = 0;
};

/// Throws: Error (data) where two lines have the same text around numbers, and no cell is a number.
void require_cells_of_numbers(const NumberedLine& line, const NumberedLine& below, char delimiter) {
  std::size_t numbers = 0, numbers_below = 0;
  const std::string_view one = line.text;
  const std::string text = without_numbers(one, numbers);
  if (text.empty() || numbers < 2) return;
  const auto is_space = [](char c) { return c == ' ' || c == '\t'; };
  std::string frame = text, frame_below = without_numbers(below.text, numbers_below);
  std::erase_if(frame, is_space);
  std::erase_if(frame_below, is_space);
  if (frame != frame_below || numbers != numbers_below) return;
  const auto cells = split(one, delimiter);
  const auto is_value = [](std::string_view cell) {
    const std::string_view value = bare(trimmed(cell));
    return !value.empty() && (looks_numeric(value) || find_notation(value));
  };
  const auto count = [&](std::string_view marks) {
    return std::ranges::count_if(cells[0], [&](char c) { return marks.find(c) != std::string_view::npos; });
  };
  const bool has_brackets = count("([{<") > count(")]}>");
  if (!has_brackets && (!has_word(text) || std::ranges::any_of(cells, is_value))) return;
  throw data_error(
      "the numbers are within other text, as in {}; expected cells between delimiters; {}, and give --parameter "
      "uniform if none is a time",
      in_quotes(trimmed(one)), numbers_alone)
      .at({"", line.number, 0});
}

/// The roles of columns without names by their first rows: where the first counts the rows, and the second has numbers
/// with fractions that rise, that is the time. Empty columns at the end are none.
std::string roles_by_cells(const std::vector<std::vector<std::string_view>>& rows) {
  const auto number = [&](std::size_t row, std::size_t cell) {
    return parse_number(bare(rows[row][cell])).value_or(-1);
  };
  const std::size_t cells = rows[0].size();
  bool has_time = cells > 2 && rows.size() > 2 && (rows[0][0] == "0" || rows[0][0] == "1") &&
                  rows[0][1].find('.') < rows[0][1].size();
  for (std::size_t row = 1; row < rows.size(); ++row) {
    has_time = has_time && number(row, 0) == number(row - 1, 0) + 1 && number(row, 1) > number(row - 1, 1);
  }
  std::vector<std::string> roles;
  if (has_time) roles = {"time=2", "ignore=1"};
  const auto is_empty = [&](std::size_t cell) {
    return std::ranges::all_of(rows, [&](const auto& row) { return row[cell].empty(); });
  };
  for (std::size_t i = cells; i > 2 && is_empty(i - 1); --i) roles.push_back(fmt::format("ignore={}", i));
  return roles.empty() ? "" : fmt::format(" --columns {}", fmt::join(roles, ","));
}

bool is_blank(std::string_view line) { return line.find_first_not_of(" \t\r") == std::string_view::npos; }

/// The lines of a text as cells between a delimiter, and the table that seems to begin among them.
class LinesOfCells {
 public:
  LinesOfCells(std::string_view text, char delimiter, const Dialect& dialect)
      : lines_(split(text, '\n')), delimiter_(delimiter), dialect_(dialect) {}

  /// The first row of a table below another line: two rows at least of the same number of cells that are mostly
  /// numbers. More rows, of another number of cells and with names, are preferred, as what is above describes them
  /// then.
  std::optional<std::size_t> first_row() const {
    constexpr std::size_t enough = 16;
    Rows best{0, 0, 1}, rows;
    for (std::size_t line = 1; line < lines_.size() && best.count < enough; ++line) {
      if (!is_text(lines_[line])) continue;
      if (lines_[line].starts_with("***End_of_Header***")) best = {0, 0, 1};  // of LabVIEW, which writes two of them
      const Cells row = cells(line);
      if (!is_of_numbers(row)) {
        rows = {};
        continue;
      }
      if (rows.count == 2 && best.first == rows.first && is_led_by_other_word(rows.first, row[0])) {
        best = rows = {line - 1, row.size(), 1};
      }
      if (row.size() != rows.cells) rows = {line, row.size(), 0};
      if (++rows.count != best.count + 1) continue;
      const bool is_other = best.first > 0 && rows.first != best.first;
      if (is_other && (rows.cells == best.cells || !names_above(rows.first))) continue;
      if (is_other && !table_at(best.first)) break;
      best = rows;
    }
    return best.first > 0 ? std::optional(best.first) : std::nullopt;
  }

  /// The table that has its first row there; nothing where that may be the table of the first line.
  std::optional<LaterTable> table_at(std::size_t row) const {
    const std::size_t size = cells(row).size();
    const std::optional<std::size_t> head = names_above(row);
    const std::size_t begin = head.value_or(row);
    const bool may_be_names = begin == 1 && (cells(0).size() > 1 || has_words(lines_[0], size));
    if (!head && may_be_names) return std::nullopt;  // the first line may be a header with a fault
    const auto first = lines_.begin();
    if (std::none_of(first, at(begin), [&](std::string_view line) { return is_text(line); })) return std::nullopt;
    const auto is_other = [&](std::string_view line) { return is_text(line) && cells_of(line).size() != size; };
    const auto is_row = [&](std::string_view line) { return !is_other(line) && is_of_numbers(cells_of(line)); };
    const auto end = lines_.end() - 1;  // what is behind the last line end may be a part of a line
    auto other = std::find_if(at(row), end, is_other);
    if (std::any_of(other, end, is_row)) other = end;  // a fault within the table, whose rows below are none to lose
    const auto has_no_number = [&](std::string_view line) {
      return is_text(line) && std::ranges::none_of(cells_of(line), begins_like_number);
    };
    return LaterTable{begin + 1,
                      other == end ? 0 : static_cast<std::uint64_t>(other - first),
                      size,
                      head.has_value(),
                      head ? "" : (has_text(cells(row)) ? " --no-header" : "") + roles_by_cells(rows_from(row)),
                      comment_above(row),
                      std::any_of(at(1), at(row), has_no_number)};
  }

 private:
  using Cells = std::vector<std::string_view>;

  /// Lines of the same number of cells that are mostly numbers.
  struct Rows {
    std::size_t first = 0;
    std::size_t cells = 0;
    std::size_t count = 0;
  };

  /// Whether a line begins with another word than the next line and the one after it, which begins with `word`.
  bool is_led_by_other_word(std::size_t line, std::string_view word) const {
    const Cells first = cells(line), second = cells(line + 1);
    return !is_number(word) && !is_number(first[0]) && first[0] != word && !second.empty() && second[0] == word;
  }

  bool is_text(std::string_view line) const { return !is_blank(line) && !dialect_.is_comment(line); }

  std::vector<std::string_view>::const_iterator at(std::size_t line) const {
    return lines_.begin() + static_cast<std::ptrdiff_t>(line);
  }

  Cells cells(std::size_t line) const { return cells_of(lines_[line]); }
  Cells cells_of(std::string_view line) const {
    constexpr std::size_t usual = 8;
    Cells cells;
    cells.reserve(usual);
    for (std::size_t begin = 0, end = 0; begin <= line.size(); begin = end + 1) {
      const bool is_quoted = begin < line.size() && line[begin] == '"';
      const std::size_t quote = is_quoted ? line.find('"', begin + 1) : begin;
      end = std::min(line.find(delimiter_, std::min(quote, line.size())), line.size());
      const std::string_view cell = trimmed(line.substr(begin, end - begin));
      if (delimiter_ != ' ' || !cell.empty()) cells.push_back(cell);
    }
    return cells;
  }

  bool is_number(std::string_view cell) const {
    const std::string_view text = bare(cell);
    return parse_number(text) || (delimiter_ != ',' && Decimals({','}).number(text)) ||
           (delimiter_ != ' ' && find_notation(text));
  }

  bool is_of_numbers(const Cells& cells) const {
    const auto numbers = std::ranges::count_if(cells, [&](std::string_view cell) { return is_number(cell); });
    if (numbers == 0 || cells.size() < 2 || 2 * numbers > std::ssize(cells)) return numbers > 0 && cells.size() > 1;
    const auto missing = std::ranges::count_if(cells, [](auto cell) { return is_missing_sign(bare(cell), {}); });
    return 2 * numbers > std::ssize(cells) - missing;
  }

  /// Whether a row has words, so that it could be the names of the columns.
  bool has_text(const Cells& row) const {
    return std::ranges::any_of(row, [&](auto cell) { return !is_number(cell) && !is_missing_sign(bare(cell), {}); });
  }

  static bool begins_like_number(std::string_view cell) {
    const std::size_t digit = bare(cell).find_first_of("0123456789");
    return digit == 0 || (digit == 1 && std::string_view("+-.").find(bare(cell)[0]) != std::string_view::npos);
  }

  /// The cells of a line above rows of a number of cells.
  Cells names_in(std::size_t line, std::size_t size) const {
    Cells names = cells(line);
    remove_unused(names, size);
    return delimiter_ == ' ' && names.size() != size ? names_between_blanks(trimmed(lines_[line])) : names;
  }

  /// The line above a row that names its columns, above blank lines and units, and above other names if it names the
  /// time.
  std::optional<std::size_t> names_above(std::size_t row) const {
    const std::size_t size = cells(row).size();
    std::size_t below = row;  // the line below that of the names
    while (below > 0 && is_blank(lines_[below - 1])) --below;
    if (below == 0) return std::nullopt;
    const auto has_number = [&](const Cells& cells) {
      return std::ranges::any_of(cells, [&](std::string_view cell) { return is_number(cell); });
    };
    const auto has_time = [](const Cells& names) { return std::ranges::any_of(names, is_usual_time, bare); };
    Cells names = names_in(below - 1, size);
    for (; below > 1 && names.size() == size; --below) {
      Cells above = names_in(below - 2, size);
      const bool has_time_above = above.size() == size && has_time(above) && !has_number(above);
      if (!are_units(names) && !has_time_above) break;
      names = std::move(above);
    }
    const bool are_names = names.size() == size && !is_of_numbers(names) && (!has_number(names) || has_time(names));
    return are_names ? std::optional(below - 1) : std::nullopt;
  }

  /// The first rows of as many cells.
  std::vector<Cells> rows_from(std::size_t row) const {
    constexpr std::size_t enough = 16;
    std::vector<Cells> rows{cells(row)};
    for (std::size_t next = row + 1; next < std::min(lines_.size(), row + enough); ++next) {
      Cells more = cells(next);
      if (more.size() != rows[0].size()) break;
      rows.push_back(std::move(more));
    }
    return rows;
  }

  /// The mark of comments with which all lines above a row begin; empty: there is none.
  std::string comment_above(std::size_t row) const {
    const char mark = lines_[0].empty() ? ' ' : lines_[0][0];
    const bool are_comments = std::string_view("%!;@*\\/$").find(mark) != std::string_view::npos &&
                              std::all_of(lines_.begin(), at(row), [&](auto line) { return line.starts_with(mark); });
    return are_comments ? std::string(1, mark) : "";
  }

  const std::vector<std::string_view> lines_;
  const char delimiter_;
  const Dialect& dialect_;
};

}  // namespace

std::vector<std::string_view> names_between_blanks(std::string_view line) {
  std::vector<std::string_view> names;
  for (std::size_t at = line.find_first_not_of(" \t"); at < line.size(); at = line.find_first_not_of(" \t", at)) {
    const std::size_t end = std::min({line.find("  ", at), line.find('\t', at), line.size()});
    names.push_back(line.substr(at, end - at));
    at = end;
  }
  return names;
}

void require_bare_numbers(std::string_view text, const Dialect& dialect, std::uint64_t line) {
  require_no_drawing(text, line);
  std::uint64_t number = line;
  const auto take_line = [&] {  // that is neither blank nor a comment; the last one of the text may be a part of a line
    for (std::size_t end = text.find('\n'); end != std::string_view::npos; end = text.find('\n'), ++number) {
      const NumberedLine taken{trimmed(text.substr(0, end)), number};
      const bool is_used = !taken.text.empty() && !dialect.is_comment(text.substr(0, end));
      text.remove_prefix(end + 1);
      if (is_used) return ++number, taken;
    }
    return NumberedLine{};
  };
  NumberedLine one = take_line(), two = take_line();
  if (two.text.empty()) return;
  require_no_log(one.text, two.text, dialect.delimiter);
  const auto are_quoted = [&](std::string_view row) {
    const auto cells = split(row, dialect.delimiter);
    return std::ranges::all_of(
        cells, [](std::string_view cell) { return cell.size() > 1 && cell.front() == '\'' && cell.back() == '\''; });
  };
  if (are_quoted(one.text) && are_quoted(two.text)) {
    throw data_error("the cells are in single quotes, as in {}; expected double quotes, or none; change them",
                     one.text);
  }
  require_cells_of_numbers(one, two, dialect.delimiter);
  constexpr std::uint64_t most_above = 16;  // of the rows of an array in a program
  while (number < line + most_above && !two.text.empty()) {
    one = std::exchange(two, take_line());
    if (is_open(one.text)) require_cells_of_numbers(one, two, dialect.delimiter);
  }
}

void require_no_remarks(std::string_view text, std::uint64_t line, char delimiter) {
  for (const std::string_view row : split(text, '\n')) {
    const std::size_t mark = std::min(row.find(" # "), row.size());
    const std::string_view numbers = trimmed(row.substr(0, mark));
    const std::string_view last = trimmed(numbers.substr(numbers.rfind(delimiter) + 1));
    if (mark < row.size() && row.find('"') == std::string_view::npos && looks_numeric(last)) {
      throw data_error(
          "text follows {} in the row; expected a comment on a line of its own; move it there, or remove it",
          in_quotes("#"))
          .at({"", line, 0});
    }
    ++line;
  }
}

std::optional<LaterTable> find_later_table(std::string_view text, const Dialect& dialect) {
  for (const char delimiter : std::string_view("\t;, ")) {
    if (text.find(delimiter) == std::string_view::npos) continue;
    const LinesOfCells lines(text, delimiter, dialect);
    if (const auto row = lines.first_row()) return lines.table_at(*row);
  }
  return std::nullopt;
}

Error unlike_table(const LaterTable& table, std::uint64_t first, std::string_view reason) {
  const std::uint64_t line = first + table.line - 1;
  const std::string also = reason.empty() ? "" : fmt::format(" ({})", reason);
  const bool is_plain = !table.has_names && table.options.empty();
  const std::string options = is_plain ? ", with which columns have no names and the first is the time"
                                       : table.options + (table.has_names ? "" : ", as columns have no names then");
  if (table.end > 0) {
    const std::uint64_t end = first + table.end - 1;
    return data_error(
               "lines {} to {} seem to be a table, with other lines around it{}; expected one table; take it alone, as "
               "in sed -n {},{}p FILE | tcbsample{}",
               line, end, also, line, end, options)
        .at({"", first, 0});
  }
  return data_error(
             "the lines above line {} are not part of the table that seems to begin there{}; expected a table from the "
             "first line on; give {} {}{}",
             line, also, table.mark.empty() ? "--skip-lines" : "--comment",
             table.mark.empty() ? fmt::format("{}", line - 1) : in_shell(table.mark), table.mark.empty() ? options : "")
      .at({"", first, 0});
}

}  // namespace tcb
