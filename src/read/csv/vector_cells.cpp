// Cells of delimited text that hold the numbers of a vector: each number becomes a cell.
#include "read/csv/vector_cells.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "numbers/parse_number.hpp"
#include "read/csv/csv_reader.hpp"
#include "schema/usual_names.hpp"
#include "text/suggest.hpp"

namespace tcb {
namespace {

bool is_of_number(char c) { return is_digit(c) || c == '+' || c == '-' || c == '.'; }

/// The end of a number that begins at a place, with its exponent.
std::size_t number_end(std::string_view text, std::size_t at) {
  const auto skip_digits = [&] {
    while (at < text.size() && is_of_number(text[at])) ++at;
  };
  skip_digits();
  if (at + 1 < text.size() && lower(text[at]) == 'e' && is_of_number(text[at + 1])) {
    ++at;
    skip_digits();
  }
  return at;
}

/// A cell of a record.
struct CellOfText {
  std::size_t begin = 0, end = 0;
  std::size_t numbers = 0;  ///< of a vector; 0: it is none
  std::size_t first = 0;    ///< where the first number, or its name, begins
  bool may_be_one = false;  ///< as the numbers may also be parts of one, such as 0,5
  bool has_blanks = false;  ///< between the numbers, and no other mark
};

/// What divides two numbers of a vector: blanks, ",", ";" or ", "; empty for anything else.
std::string_view mark_in(std::string_view between) {
  const std::string_view mark = trimmed(between);
  if (mark == "," && between.back() == ' ') return ", ";
  return mark.empty() ? " " : mark == "," || mark == ";" ? mark : "";
}

/// Whether numbers without brackets may be one: with a decimal comma, thousands, or degrees with minutes.
bool may_be_one(std::string_view cell, std::string_view mark) {
  if (mark != " ") return mark == "," && (Decimals({','}).number(cell) || has_thousands_separators(cell));
  return std::ranges::any_of(split(cell, ' '), [](std::string_view part) {
    return !part.empty() && part.find('.') == std::string_view::npos;
  });
}

/// The place of the bracket behind a word that begins at a place, as in POINT (1 2); the same place without one.
std::size_t bracket_behind_word(std::string_view text, std::size_t at) {
  std::size_t end = at;
  while (end < text.size() && (is_digit(text[end]) || (lower(text[end]) >= 'a' && lower(text[end]) <= 'z') ||
                               (end > at && text[end] == ' '))) {
    ++end;
  }
  const bool is_word = end > at && !is_digit(text[at]);
  return is_word && end < text.size() && text[end] == '(' ? end : at;
}

/// The vector in the cell that begins at a place: at least two numbers, each behind a name and "=" or alone, and all
/// divided alike, as commas may be decimal marks in (0,5, 1,5). They are in brackets, behind a word or not, as in
/// POINT (1 2), or alone, as in "1.5, 2.5". No numbers: there is none.
CellOfText vector_at(std::string_view text, std::size_t begin, char delimiter) {
  const auto get = [&](std::size_t at) { return at < text.size() ? text[at] : '\n'; };
  const bool is_quoted = get(begin) == '"';
  const std::size_t inner = begin + (is_quoted ? 1 : 0);
  std::size_t at = bracket_behind_word(text, inner), numbers = 0;
  const std::size_t bracket = std::string_view("([{<").find(get(at));
  const bool has_brackets = bracket != std::string_view::npos;
  const auto is_end_at = [&](std::size_t place) {
    const char c = get(place);
    return has_brackets ? c == ")]}>"[bracket] : c == '\n' || c == '\r' || c == (is_quoted ? '"' : delimiter);
  };
  if (has_brackets) ++at;
  const std::size_t first = at;
  std::string_view mark;
  for (std::size_t end = at;; end = at) {  // of the last number
    while (!is_end_at(at) && std::string_view(" ,;").find(get(at)) != std::string_view::npos) ++at;
    const std::string_view between = text.substr(end, at - end);
    const bool is_end = is_end_at(at);
    if ((is_end || numbers == 0) && !trimmed(between).empty()) return {};
    if (is_end) break;
    const std::string_view next = between.empty() ? "" : mark_in(between);
    if (numbers > 0 && (next.empty() || (numbers > 1 && next != mark))) return {};
    mark = next;
    const std::size_t name = at;
    while (has_brackets && lower(get(at)) >= 'a' && lower(get(at)) <= 'z') ++at;
    if (at > name && get(at++) != '=') return {};
    const std::size_t number = at;
    at = number_end(text, at);
    if (at == number || (!has_brackets && !parse_number(text.substr(number, at - number)))) return {};
    ++numbers;
  }
  const std::string_view alone = trimmed(text.substr(first, at - first));
  if (has_brackets) ++at;
  if (is_quoted && get(at++) != '"') return {};
  std::size_t next = at;
  while (get(next) != delimiter && (Dialect::is_blank(get(next)) || get(next) == '\r')) ++next;
  const bool ends_cell = get(next) == delimiter || get(next) == '\n';
  return {begin,      at, ends_cell && numbers > 1 ? numbers : 0, first, !has_brackets && may_be_one(alone, mark),
          mark == " "};
}

/// The place behind a quoted cell that begins at a place.
std::size_t quoted_end(std::string_view text, std::size_t at) {
  do {
    at = std::min(text.find('"', at + 1), text.size() - 1) + 1;
  } while (at < text.size() && text[at] == '"');
  return at;
}

std::size_t cell_end(std::string_view text, std::size_t at, char delimiter) {
  while (at < text.size() && text[at] != delimiter && text[at] != '\n') ++at;
  return at;
}

/// The cell that begins at a place, behind blanks.
CellOfText cell_at(std::string_view text, std::size_t at, char delimiter) {
  while (at < text.size() && Dialect::is_blank(text[at]) && text[at] != delimiter) ++at;
  if (const CellOfText vector = vector_at(text, at, delimiter); vector.numbers > 0) return vector;
  const std::size_t last = at < text.size() && text[at] == '"' ? quoted_end(text, at) : at;
  return {at, cell_end(text, last, delimiter)};
}

/// The cells of a line, with their places in the text.
std::vector<CellOfText> cells_in_line(std::string_view text, std::size_t begin, std::size_t end, char delimiter) {
  std::vector<CellOfText> cells;
  for (std::size_t at = begin;; ++at) {
    cells.push_back(cell_at(text.substr(0, end), at, delimiter));
    at = std::min(text.find(delimiter, cells.back().end), end);
    if (at == end) return cells;
  }
}

/// Puts a delimiter between the numbers of a vector, and blanks in the place of all else.
void spread(std::string& text, const CellOfText& vector, char delimiter) {
  std::size_t numbers = 0;
  std::fill(text.begin() + static_cast<std::ptrdiff_t>(vector.begin),
            text.begin() + static_cast<std::ptrdiff_t>(vector.first), ' ');
  for (std::size_t at = vector.first; at < vector.end;) {
    if (is_of_number(text[at])) {
      at = number_end(text, at);
      if (++numbers < vector.numbers) text[at++] = delimiter;
    } else {
      text[at++] = ' ';
    }
  }
}

/// The text of whole records with a cell for each number of a vector, which all stay where they are. `numbers`: how
/// many the vectors of each column have; others are no numbers, which is an error later.
std::string with_cells_of_numbers(std::string text, char delimiter, const std::vector<std::size_t>& numbers) {
  std::size_t column = 0;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const CellOfText cell = cell_at(text, at, delimiter);
    if (cell.numbers > 0 && column < numbers.size() && cell.numbers == numbers[column]) spread(text, cell, delimiter);
    at = cell_end(text, cell.end, delimiter);
    column = at < text.size() && text[at] == '\n' ? 0 : column + 1;
  }
  return text;
}

/// The parts of a name such as "lat,lon"; none if there are not as many as numbers.
std::vector<std::string> names_in(std::string_view name, std::size_t numbers) {
  for (const char mark : std::string_view(",;/")) {
    std::vector<std::string> parts;
    for (const std::string_view part : split(name, mark)) {
      if (!trimmed(part).empty()) parts.emplace_back(trimmed(part));
    }
    if (parts.size() == numbers) return parts;
  }
  return {};
}

bool is_tcb(std::string_view name) { return same_in_any_case(name, "tcb") || same_in_any_case(name, "tbc"); }

/// The names of the numbers of a vector.
std::vector<std::string> part_names(std::string_view name, std::size_t numbers) {
  constexpr std::array coordinates{"x", "y", "z", "w"};
  std::vector<std::string> parts = names_in(name, numbers);
  if (!parts.empty()) return parts;
  for (std::size_t i = 0; i < numbers; ++i) {
    parts.push_back(numbers <= coordinates.size() ? fmt::format("{}.{}", name, coordinates[i])
                                                  : fmt::format("{}[{}]", name, i));
  }
  return parts;
}

/// A line of a chunk.
struct LineOfChunk {
  std::size_t chunk = 0, begin = 0, end = 0;
};

/// The first lines that are neither blank nor comments, of which each chunk has one at least.
std::vector<LineOfChunk> first_lines(Source<Chunk>& source, std::vector<Chunk>& chunks, const Dialect& dialect) {
  constexpr std::size_t wanted = 2;
  std::vector<LineOfChunk> lines;
  while (lines.size() < wanted) {
    std::optional<Chunk> chunk = source();
    if (!chunk) break;
    const std::string& text = chunks.emplace_back(*std::move(chunk)).text;
    for (std::size_t begin = 0, end = 0; begin < text.size() && lines.size() < wanted; begin = end + 1) {
      end = std::min(text.find('\n', begin), text.size());
      const std::string_view line = trimmed(std::string_view(text).substr(begin, end - begin));
      const bool has_return = end > begin && text[end - 1] == '\r';
      if (!line.empty() && !dialect.is_comment(line)) {
        lines.push_back({chunks.size() - 1, begin, has_return ? end - 1 : end});
      }
    }
  }
  return lines;
}

/// The columns of vectors in the second line, whose names become those of their numbers in the first line, unless that
/// has vectors itself. No columns where the lines differ otherwise, or vectors are alone.
std::vector<VectorColumn> name_vectors(std::vector<Chunk>& chunks, const std::vector<LineOfChunk>& lines,
                                       char delimiter) {
  const auto cells_in = [&](const LineOfChunk& line) {
    return cells_in_line(chunks[line.chunk].text, line.begin, line.end, delimiter);
  };
  const std::vector<CellOfText> names = cells_in(lines[0]), cells = cells_in(lines[1]);
  if (cells.size() != names.size() || cells.size() < 2) return {};
  const bool has_header = std::ranges::all_of(names, [](const CellOfText& cell) { return cell.numbers == 0; });
  std::string& text = chunks[lines[0].chunk].text;
  const std::string_view second = chunks[lines[1].chunk].text;
  const auto text_of = [&](const CellOfText& cell) {
    return bare(trimmed(second.substr(cell.begin, cell.end - cell.begin)));
  };
  const bool has_points = std::ranges::any_of(cells, [&](const CellOfText& cell) {
    const std::string_view number = text_of(cell);
    return cell.numbers == 0 && number.find('.') != std::string_view::npos && parse_number(number);
  });
  std::vector<VectorColumn> columns;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (cells[i].numbers == 0) continue;
    const std::string_view cell = trimmed(std::string_view(text).substr(names[i].begin, names[i].end - names[i].begin));
    const std::string name = has_header ? unquoted(cell) : fmt::format("{}", i + 1);
    const bool names_vector =
        !names_in(name, cells[i].numbers).empty() || (cells[i].has_blanks && (is_usual_position(name) || is_tcb(name)));
    const bool may_have_points = delimiter == ',' && !has_thousands_separators(text_of(cells[i]));
    const bool is_one = cells[i].may_be_one && !(has_points && may_have_points) && !names_vector;
    if (is_one) continue;
    if (name.find('"') != std::string::npos) return {};
    columns.push_back({i, name, part_names(name, cells[i].numbers)});
  }
  for (std::size_t i = columns.size(); has_header && i-- > 0;) {  // the last one first, as places behind it change
    const CellOfText& cell = names[columns[i].cell];
    const std::string between{'"', delimiter, '"'};
    text.replace(cell.begin, cell.end - cell.begin, fmt::format("\"{}\"", fmt::join(columns[i].parts, between)));
  }
  return columns;
}

}  // namespace

std::vector<VectorColumn> take_vectors(Source<Chunk>& chunks, const Dialect& dialect) {
  if (dialect.delimiter == ' ') return {};
  std::vector<Chunk> first;
  const std::vector<LineOfChunk> lines = first_lines(chunks, first, dialect);
  std::vector<VectorColumn> columns;
  if (lines.size() > 1) columns = name_vectors(first, lines, dialect.delimiter);
  for (; !first.empty(); first.pop_back()) chunks = preceded_by(std::move(first.back()), std::move(chunks));
  if (columns.empty()) return {};
  std::vector<std::size_t> numbers(columns.back().cell + 1);
  for (const VectorColumn& column : columns) numbers[column.cell] = column.parts.size();
  chunks = mapped(std::move(chunks), [delimiter = dialect.delimiter, numbers = std::move(numbers)](Chunk chunk) {
    chunk.text = with_cells_of_numbers(std::move(chunk.text), delimiter, numbers);
    return chunk;
  });
  return columns;
}

InputOptions with_vectors(InputOptions options, const std::vector<VectorColumn>& columns) {
  const auto require_clear_number = [&](const std::string& name) {
    if (in_digits<std::size_t>(name).value_or(0) <= columns[0].cell) return;
    throw data_error(
        "column {} is not clear by its number, as cells hold several numbers; expected a name such as {}; give names, "
        "or {}",
        name, in_quotes(columns[0].parts[0]), numbers_alone);
  };
  for (RoleRequest& role : options.columns.roles) {
    for (const VectorColumn& column : columns) {
      const auto found = std::ranges::find(role.columns, column.name);
      if (found == role.columns.end()) continue;
      role.columns.insert(role.columns.erase(found), column.parts.begin(), column.parts.end());
    }
    std::ranges::for_each(role.columns, require_clear_number);
  }
  for (const GivenRotation& rotation : options.rotation.requests) {
    std::ranges::for_each(rotation.columns, require_clear_number);
  }
  for (const NamedAngle& angle : options.rotation.angles) require_clear_number(angle.channel);
  return options;
}

}  // namespace tcb
