// Texts that are no tables: lines above a table and below it, numbers within other text, cells with lines between them.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "numbers/parse_number.hpp"
#include "numbers/time_notation.hpp"
#include "read/csv/csv_reader.hpp"
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
void require_no_drawing(std::string_view text) {
  constexpr std::string_view corner = "\xE2\x94", double_corner = "\xE2\x95";  // of box-drawing characters
  const std::vector<std::string_view> lines = split(text, '\n');
  const auto is_drawn = [&](std::string_view line) {
    const bool is_rule = line.find("---") != std::string_view::npos &&
                         line.find_first_of("|+") != std::string_view::npos &&
                         line.find_first_not_of("-+|:= \r") == std::string_view::npos;
    return is_rule || line.starts_with(corner) || line.starts_with(double_corner);
  };
  const auto first = lines.begin(), end = first + std::min<std::ptrdiff_t>(4, std::ssize(lines));
  if (std::none_of(first, end, is_drawn)) return;
  throw data_error(
      "the table is drawn with lines between its cells; expected cells between delimiters; export it as CSV, as psql "
      "--csv, mysql --batch, sqlite3 -csv, duckdb -csv and write_csv of polars do");
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

/// Whether a word begins somewhere, not as a unit or an exponent behind a number.
bool has_word(std::string_view text) {
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (is_letter(text[at]) && (at == 0 || (text[at - 1] != '#' && !is_letter(text[at - 1])))) return true;
  }
  return false;
}

/// A number that no word ends, as a regular expression.
constexpr std::string_view number_in_perl = "(?<![\\w.])[-+]?\\.?\\d[\\d.]*(?:[eE][-+]?\\d+)?";

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
      "a time and other text begin each line, as in {}; expected cells between delimiters; take the time and the "
      "numbers "
      "behind it, as in perl -ne 'if (/^\\W*((?:\\d{{4}}-\\d\\d-\\d\\d[ T])?\\d+:\\d\\d:\\d\\d(?:[.,]\\d+)?)(.*)/) "
      "{{my ($t, $r) = ($1, "
      "$2); $t =~ tr/,/./; print join(\",\", $t, $r =~ /{}/g), \"\\n\"}}' FILE | tcbsample",
      in_quotes(one), number_in_perl);
}

/// Throws: Error (data) where the first two lines have the same text around numbers, and no cell is a number.
void require_cells_of_numbers(std::string_view one, std::string_view two, char delimiter) {
  std::size_t numbers = 0, numbers_below = 0;
  const std::string text = without_numbers(one, numbers);
  if (text.empty() || numbers < 2 || without_numbers(two, numbers_below) != text || numbers != numbers_below) return;
  const auto cells = split(one, delimiter);
  const auto is_value = [](std::string_view cell) {
    const std::string_view text = bare(trimmed(cell));
    return !text.empty() && (looks_numeric(text) || find_notation(text));
  };
  const auto count = [&](std::string_view marks) {
    return std::ranges::count_if(cells[0], [&](char c) { return marks.find(c) != std::string_view::npos; });
  };
  const bool has_brackets = count("([{<") > count(")]}>");
  if (!has_brackets && (!has_word(text) || std::ranges::any_of(cells, is_value))) return;
  throw data_error(
      "the numbers are within other text, as in {}; expected cells between delimiters; {}, with --parameter uniform if "
      "none is a time",
      in_quotes(trimmed(one)), numbers_alone());
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
  return fmt::format("{}", fmt::join(roles, ","));
}

}  // namespace

std::string numbers_alone() {
  return fmt::format("take the numbers alone, as in perl -ne '@n = /{}/g and print \"@n\\n\"' FILE | tcbsample",
                     number_in_perl);
}

void require_bare_numbers(std::string_view text, const Dialect& dialect) {
  require_no_drawing(text);
  std::vector<std::string_view> lines = split(text.substr(0, text.find_last_of('\n')), '\n');
  std::erase_if(lines, [&](std::string_view line) { return trimmed(line).empty() || dialect.is_comment(line); });
  if (lines.size() < 2) return;
  const std::string_view one = trimmed(lines[0]), two = trimmed(lines[1]);
  require_no_log(one, two, dialect.delimiter);
  const auto are_quoted = [&](std::string_view line) {
    const auto cells = split(line, dialect.delimiter);
    return std::ranges::all_of(
        cells, [](std::string_view cell) { return cell.size() > 1 && cell.front() == '\'' && cell.back() == '\''; });
  };
  if (are_quoted(one) && are_quoted(two)) {
    throw data_error(
        "the cells are in single quotes, as in {}; expected double quotes, or none; change them, as in tr "
        "\\' '\"' <FILE | tcbsample",
        one);
  }
  require_cells_of_numbers(one, two, dialect.delimiter);
}

std::optional<LaterTable> find_later_table(std::string_view text, const Dialect& dialect) {
  const std::vector<std::string_view> lines = split(text, '\n');
  for (const char delimiter : std::string_view("\t;, ")) {
    if (text.find(delimiter) == std::string_view::npos) continue;
    const auto cells_in = [&](std::string_view line) {
      std::vector<std::string_view> cells;
      for (std::size_t begin = 0, end = 0; begin <= line.size(); begin = end + 1) {
        const bool is_quoted = begin < line.size() && line[begin] == '"';
        const std::size_t quote = is_quoted ? line.find('"', begin + 1) : begin;
        end = std::min(line.find(delimiter, std::min(quote, line.size())), line.size());
        const std::string_view cell = trimmed(line.substr(begin, end - begin));
        if (delimiter != ' ' || !cell.empty()) cells.push_back(cell);
      }
      return cells;
    };
    const auto is_number = [&](std::string_view cell) {
      const std::string_view text = bare(cell);
      return parse_number(text) || (delimiter != ',' && Decimals({','}).number(text)) ||
             (delimiter != ' ' && find_notation(text));
    };
    const auto is_of_numbers = [&](const std::vector<std::string_view>& cells) {
      const auto numbers = std::ranges::count_if(cells, is_number);
      return numbers > 0 && cells.size() > 1 && 2 * numbers > std::ssize(cells) - std::ranges::count(cells, "");
    };
    for (std::size_t i = 1; i + 1 < lines.size(); ++i) {
      const auto one = cells_in(lines[i]), two = cells_in(lines[i + 1]);
      if (!is_of_numbers(one) || !is_of_numbers(two) || one.size() != two.size()) continue;
      std::size_t head = i;  // the last line above that is not blank, if it names the columns
      while (head > 0 && lines[head - 1].find_first_not_of(" \t\r") == std::string_view::npos) --head;
      auto names = head > 0 ? cells_in(lines[head - 1]) : std::vector<std::string_view>{};
      while (head > 1 && names.size() == one.size() && are_units(names)) names = cells_in(lines[--head - 1]);
      const bool are_names = names.size() == one.size() && !is_of_numbers(names) &&
                             (std::ranges::none_of(names, is_number) || std::ranges::any_of(names, is_usual_time));
      const std::size_t line = are_names ? head : i + 1;
      const bool may_be_names = line == 2 && (cells_in(lines[0]).size() > 1 || has_words(lines[0], one.size()));
      if (!are_names && may_be_names) return std::nullopt;  // the first line may be a header with a fault
      const auto is_text = [&](std::string_view above) {
        return above.find_first_not_of(" \t\r") != std::string_view::npos && !dialect.is_comment(above);
      };
      const auto begins_like_number = [](std::string_view cell) {
        const std::size_t digit = bare(cell).find_first_of("0123456789");
        return digit == 0 || (digit == 1 && std::string_view("+-.").find(bare(cell)[0]) != std::string_view::npos);
      };
      const bool follows_text =
          std::any_of(lines.begin() + 1, lines.begin() + static_cast<std::ptrdiff_t>(i), [&](std::string_view above) {
            return is_text(above) && std::ranges::none_of(cells_in(above), begins_like_number);
          });
      const bool has_preamble =
          std::any_of(lines.begin(), lines.begin() + static_cast<std::ptrdiff_t>(line - 1), is_text);
      if (!has_preamble) return std::nullopt;
      std::vector<std::vector<std::string_view>> rows;
      constexpr std::size_t enough = 16;
      for (std::size_t row = i; row < std::min(lines.size(), i + enough); ++row) {
        rows.push_back(cells_in(lines[row]));
        if (rows.back().size() != one.size()) break;
      }
      if (rows.back().size() != one.size()) rows.pop_back();
      const char first = lines[0].empty() ? ' ' : lines[0][0];
      const bool are_comments = std::string_view("%!;@*\\/$").find(first) != std::string_view::npos &&
                                std::all_of(lines.begin(), lines.begin() + static_cast<std::ptrdiff_t>(i),
                                            [&](std::string_view above) { return above.starts_with(first); });
      const auto end =
          std::find_if(lines.begin() + static_cast<std::ptrdiff_t>(i), lines.end(),
                       [&](std::string_view below) { return is_text(below) && cells_in(below).size() != one.size(); });
      return LaterTable{line,
                        end == lines.end() ? 0 : static_cast<std::uint64_t>(end - lines.begin()),
                        one.size(),
                        are_names,
                        are_names ? "" : roles_by_cells(rows),
                        are_comments ? std::string(1, first) : "",
                        follows_text};
    }
  }
  return std::nullopt;
}

Error unlike_table(const LaterTable& table, std::uint64_t first, std::string_view reason) {
  const std::uint64_t line = first + table.line - 1;
  const std::string also = reason.empty() ? "" : fmt::format(" ({})", reason);
  const std::string nameless = table.has_names ? ""
                               : table.roles.empty()
                                   ? ", with which columns have no names and the first is the time"
                                   : fmt::format(" --columns {}, as columns have no names then", table.roles);
  if (table.end > 0) {
    const std::uint64_t end = first + table.end - 1;
    return data_error(
               "lines {} to {} seem to be a table, with other lines around it{}; expected one table; take it alone, as "
               "in sed -n "
               "{},{}p FILE | tcbsample{}",
               line, end, also, line, end, nameless)
        .at({"", first, 0});
  }
  return data_error(
             "the lines above line {} are not part of the table that seems to begin there{}; expected a table from the "
             "first "
             "line on; give {} {}{}",
             line, also, table.mark.empty() ? "--skip-lines" : "--comment",
             table.mark.empty() ? fmt::format("{}", line - 1) : in_shell(table.mark),
             table.mark.empty() ? nameless : "")
      .at({"", first, 0});
}

}  // namespace tcb
