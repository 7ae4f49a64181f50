// Tables below other lines.
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

/// Whether a line has this number of words with some delimiter, so that it may be the names of as many columns.
bool has_words(std::string_view line, std::size_t count) {
  return std::ranges::any_of(std::string_view("\t;, "), [&](char delimiter) {
    const auto words = split(line, delimiter);
    return words.size() - static_cast<std::size_t>(std::ranges::count(words, "")) == count;
  });
}

bool is_blank(std::string_view line) { return line.find_first_not_of(" \t\r") == std::string_view::npos; }

/// The lines of a text as cells between a delimiter, and the table that seems to begin among them.
class LinesOfCells {
 public:
  LinesOfCells(std::string_view text, char delimiter, const Dialect& dialect)
      : lines_(split(text, '\n')), delimiter_(delimiter), dialect_(dialect) {}

  /// The first row of the longest table below another line: rows of the same number of cells that are mostly numbers,
  /// two at least. Rows of as many cells below others may be of the same table.
  std::optional<std::size_t> first_row() const {
    Rows best{0, 0, 1}, rows;
    for (std::size_t line = 1; line < lines_.size(); ++line) {
      if (!is_text(lines_[line])) continue;
      const Cells row = cells(line);
      const std::size_t size = is_of_numbers(row) ? row.size() : 0;
      if (size != rows.cells) rows = {line, size, 0};
      const bool may_be_same = size == best.cells && rows.first != best.first;
      if (size > 0 && ++rows.count > best.count && !may_be_same) best = rows;
    }
    return best.first > 0 ? std::optional(best.first) : std::nullopt;
  }

  /// The table that has its first row there; nothing where that may be the table of the first line.
  std::optional<LaterTable> table_at(std::size_t row) const {
    const std::size_t size = cells(row).size();
    const std::optional<std::size_t> head = names_above(row);
    const std::size_t begin = head.value_or(row);
    const std::string comment = head ? "" : comment_above(row, size);
    const bool may_be_names = begin == 1 && (cells(0).size() > 1 || has_words(lines_[0], size));
    // The first line may be a header with a fault, or one of rows that have fewer cells at their ends.
    if (!head && comment.empty() && (may_be_names || has_short_rows(row))) return std::nullopt;
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
                      !head && has_text(cells(row)) ? " --no-header" : "",
                      std::any_of(at(1), at(row), has_no_number),
                      head && has_name(*head, size, [](auto name) { return is_parameter_word(name); }),
                      head && may_take_rate(names_in(*head, size)),
                      comment};
  }

 private:
  using Cells = std::vector<std::string_view>;

  /// Lines of the same number of cells that are mostly numbers.
  struct Rows {
    std::size_t first = 0;
    std::size_t cells = 0;
    std::size_t count = 0;
  };

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
           has_thousands_separators(text) || (delimiter_ != ' ' && find_notation(text));
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

  template <class Test>
  bool has_name(std::size_t line, std::size_t size, Test test) const {
    return std::ranges::any_of(names_in(line, size), [&](std::string_view name) { return test(bare(name)); });
  }
  /// Whether there is no time by its name, or only one in frames.
  static bool may_take_rate(const Cells& names) {
    const auto is_time = [](std::string_view name) { return role_of_name(name) == Role::time || is_usual_time(name); };
    const auto time = std::ranges::find_if(names, is_time, bare);
    if (time == names.end()) return true;
    return std::none_of(time + 1, names.end(), [&](auto name) { return is_time(bare(name)); }) &&
           unit_of_time(bare(*time)) == TimeUnit::frames;
  }
  static bool is_parameter_word(std::string_view name) {
    const Role role = role_of_name(name);
    return role == Role::tension || role == Role::continuity || role == Role::bias;
  }

  /// Whether the first line names a time, and all lines from it to a row are rows of no more cells than it has.
  bool has_short_rows(std::size_t row) const {
    const Cells names = cells(0);
    return std::ranges::any_of(names, is_usual_time, bare) && std::all_of(at(1), at(row), [&](std::string_view line) {
             const Cells row = cells_of(line);
             return !is_text(line) || (row.size() <= names.size() && is_of_numbers(row));
           });
  }

  /// A mark of comments that begins all lines above a row, if the last of these has as many words behind it.
  std::string comment_above(std::size_t row, std::size_t size) const {
    for (const std::string_view mark : comment_marks) {
      const auto has_mark = [&](std::string_view line) { return is_blank(line) || trimmed(line).starts_with(mark); };
      if (!std::all_of(lines_.begin(), at(row), has_mark) || is_blank(lines_[row - 1])) continue;
      const std::string_view words = trimmed(trimmed(lines_[row - 1]).substr(mark.size()));
      if (has_words(words, size) || has_words(words.substr(words.find(':') + 1), size)) return std::string(mark);
    }
    return "";
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
  if (!table.comment.empty() && table.end == 0) {
    return data_error(
               "the lines above line {} begin with {}, as comments do; expected # in front of comments; give --comment "
               "{}",
               line, in_quotes(table.comment), in_shell(table.comment) + table.options)
        .at({"", first, 0});
  }
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
             "first line on; give --skip-lines {}{}",
             line, also, line - 1, options)
      .at({"", first, 0});
}

}  // namespace tcb
