// Tokenizer of delimited text: records and their cells.
#include "read/csv/tokenizer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <optional>

#include "numbers/dates.hpp"
#include "schema/usual_names.hpp"
#include "text/suggest.hpp"
#include "text/utf8.hpp"

namespace tcb {
namespace {

bool is_blank(char c) { return Dialect::is_blank(c); }

/// Sets the upper bit of the first of eight bytes that is zero, and of none before it; bits after it may be wrong.
/// Source: H. S. Warren, Hacker's Delight, ch. 6.
std::uint64_t zero_bytes(std::uint64_t bytes) { return (bytes - 0x0101010101010101) & ~bytes & 0x8080808080808080; }

/// The first of some characters, or the end.
template <class... Chars>
const char* find_one(const char* at, const char* end, Chars... chars) {
  const auto eight = [](char each) { return std::uint64_t{0x0101010101010101} * static_cast<unsigned char>(each); };
  for (; end - at >= 8; at += 8) {
    std::uint64_t bytes = 0;
    std::memcpy(&bytes, at, sizeof bytes);
    const std::uint64_t found = (zero_bytes(bytes ^ eight(chars)) | ...);
    if (found != 0) return at + std::countr_zero(found) / 8;
  }
  while (at != end && ((*at != chars) && ...)) ++at;
  return at;
}

Error number_with_marks(std::string_view column, std::string_view cell, char decimal, char thousands) {
  const bool has_comma = decimal == ',' && cell.find(',') != std::string_view::npos;
  const std::string also = has_comma || thousands == '.' ? "--decimal , " : "";
  return {
      Exit::data,
      fmt::format(
          "{}: {} is not a number; expected one without thousands separators; remove them, or give {}--thousands {}",
          column, in_quotes(cell), also,
          thousands == ' '    ? "space"
          : thousands == '\'' ? "apostrophe"
          : thousands == '_'  ? "underscore"
                              : std::string(1, thousands))};
}

/// The text with a point where it has a comma.
std::string with_point(std::string_view text) {
  std::string changed(text);
  std::ranges::replace(changed, ',', '.');
  return changed;
}

std::optional<NumberMarks> marks_of(std::string_view text) {
  const auto* const found = std::ranges::find_if(
      other_marks, [&](const NumberMarks& marks) { return Decimals(marks).number(text).has_value(); });
  return found == other_marks.end() ? std::nullopt : std::optional(*found);
}

/// The command that removes the word or the sign beside a number in a cell: a currency or a unit, as in $5, 10s and
/// 5 m. Empty: it is something else, such as an address.
std::string command_without_unit(std::string_view cell) {
  constexpr std::string_view digits = "0123456789";
  const std::size_t first = cell.find_first_of("+-.0123456789"), last = cell.find_last_of(digits);
  if (first == std::string_view::npos || last == std::string_view::npos || last < first) return "";
  const std::string_view before = cell.substr(0, first), behind = cell.substr(last + 1);
  const std::string_view number = cell.substr(first, last + 1 - first);
  const bool is_number = parse_number(number) || marks_of(number);
  const auto is_plain = [](std::string_view text) {  // a short word that stands for itself in a regular expression
    constexpr std::size_t longest = 12;
    const std::string_view word = trimmed(text);
    return word.size() <= longest && word.find_first_of(" \t\r\n\\/*[]^()'+?{}|&.$") == std::string_view::npos;
  };
  const bool is_word = !before.empty() && lower(before[0]) >= 'a' && lower(before[0]) <= 'z';
  if (!is_number || is_word || before.empty() == behind.empty()) return "";
  if (!is_plain(behind) || (before != "$" && !is_plain(before))) return "";
  return before.empty() ? fmt::format(R"(sed -E 's/([0-9]){}([",;[:space:]]|$)/\1\2/g')", behind)
                        : fmt::format("sed 's/{}{}//g'", before == "$" ? "\\" : "", before);
}

}  // namespace

Tokenizer::Tokenizer(const Chunk& chunk, const Dialect& dialect)
    : dialect_(dialect),
      begin_(chunk.text.data()),
      at_(begin_),
      end_(begin_ + chunk.text.size()),
      record_(begin_),
      line_(chunk.line),
      record_line_(chunk.line) {}

void Tokenizer::pass_line_end() {
  if (at_ != end_ && *at_ == '\r') ++at_;
  if (at_ != end_) ++at_;
  ++line_;
}

void Tokenizer::skip_line() {
  at_ = std::find(at_, end_, '\n');
  pass_line_end();
}

bool Tokenizer::skip_to_record() {
  for (; at_ != end_; pass_line_end()) {
    record_ = at_;
    while (at_ != end_ && is_blank(*at_)) ++at_;
    const std::string_view left(at_, static_cast<std::size_t>(end_ - at_));
    const bool divides = dialect_.is_divider(left);
    if (divides || dialect_.is_comment(left)) {
      const std::size_t size = std::min(left.find('\n'), left.size());
      const bool follows_comment = !comment_.empty() && comment_.data() + comment_.size() + 1 == record_;
      const char* const begin = follows_comment ? comment_.data() : at_;
      if (!divides) comment_ = {begin, static_cast<std::size_t>(at_ + size - begin)};
      broken_ = broken_ || divides;
      at_ += size;
    } else if (at_line_end()) {
      comment_ = {};
      follows_blank_ = true;
      broken_ = broken_ || dialect_.divided || dialect_.delimiter == ' ';
    } else {
      at_ = record_;
      return true;
    }
  }
  return false;
}

bool Tokenizer::next(std::vector<std::string_view>& cells) {
  cells.clear();
  comment_ = {};
  broken_ = follows_blank_ = false;
  if (!skip_to_record()) return false;
  record_line_ = line_;
  const bool blanks = dialect_.delimiter == ' ';
  for (;;) {
    while (!at_line_end() && is_blank(*at_) && *at_ != dialect_.delimiter) ++at_;
    while (blanks && !at_line_end() && is_blank(*at_)) ++at_;
    if (blanks && at_line_end()) break;
    if (cells.size() == most_cells) refuse_cells();
    cells.push_back(take_cell());
    if (at_line_end()) break;
    ++at_;  // the delimiter, which another cell follows
  }
  pass_line_end();
  return true;
}

void Tokenizer::refuse_cells() {
  const TextPosition where = position({record_, 1});
  skip_line();
  throw data_error(
      "the record has more than {} cells; expected at most {}; correct the row, or give the delimiter with --delimiter",
      most_cells, most_cells)
      .at(where);
}

std::string_view Tokenizer::take_cell() {
  const char* const start = at_;
  if (*start == '"') return take_quoted();
  const char delimiter = dialect_.delimiter;
  const char* const now =
      delimiter == ' ' ? find_one(start, end_, ' ', '\t', '\n') : find_one(start, end_, delimiter, '\n');
  const bool at_end = now == end_ || *now == '\n';
  at_ = at_end && now != start && now[-1] == '\r' ? now - 1 : now;
  const char* last = at_;
  while (last != start && is_blank(last[-1])) --last;
  return {start, static_cast<std::size_t>(last - start)};
}

std::string_view Tokenizer::take_quoted() {
  const char* const start = at_;
  for (++at_; at_ != end_; ++at_) {
    if (*at_ == '\n') ++line_;
    if (*at_ != '"') continue;
    if (at_ + 1 == end_ || at_[1] != '"') break;
    ++at_;
  }
  if (at_ == end_) throw data_error("a quoted cell is not closed; expected \" at its end").at(position({start, 1}));
  const std::string_view cell(start, static_cast<std::size_t>(++at_ - start));
  const bool blanks = dialect_.delimiter == ' ';  // blanks and tabs delimit
  while (!blanks && !at_line_end() && is_blank(*at_) && *at_ != dialect_.delimiter) ++at_;
  if (!at_line_end() && *at_ != dialect_.delimiter && !is_blank(*at_)) {
    const TextPosition where = position({at_, 1});
    skip_line();
    throw data_error(
        "text follows a quoted cell; expected the delimiter or the end of the line; double the quotes inside a cell")
        .at(where);
  }
  return cell;
}

TextPosition Tokenizer::position(std::string_view cell) const {
  const std::string_view before(record_, static_cast<std::size_t>(cell.data() - record_));
  return {"", record_line_ + count_lines(before), column(cell)};
}

std::uint64_t Tokenizer::column(std::string_view cell) const {
  return column_after({record_, static_cast<std::size_t>(cell.data() - record_)}, 1);
}

std::string unquoted(std::string_view cell) {
  if (cell.size() < 2 || cell.front() != '"') return std::string(cell);
  std::string text;
  for (std::size_t i = 1; i + 1 < cell.size(); ++i) {
    text += cell[i];
    if (cell[i] == '"') ++i;
  }
  return text;
}

bool has_thousands_separators(std::string_view text) {
  if (text.find_first_of("0123456789") == std::string_view::npos) return false;
  const std::optional<NumberMarks> marks = marks_of(text);
  return marks && marks->thousands != 0 && !parse_number(text);
}

Error date_not_read(std::string_view column, std::string_view cell, std::string_view known) {
  return data_error(
      "{}: {} is a date in a form that is not read; expected it as {}; write the dates so, as to_datetime of pandas "
      "does with the argument format",
      column, in_quotes(cell), known);
}

Error why_not_number(std::string_view column, std::string_view cell, const NumberMarks& marks) {
  if (looks_numeric(cell) || (marks.decimal != '.' && looks_numeric(with_point(cell)))) {
    const bool has_point = marks.decimal != '.' && cell.find('.') != std::string_view::npos;
    if (has_point && Decimals({',', '.'}).number(cell)) {
      return data_error(
          "{}: {} has a decimal point; expected a decimal comma; correct the cell, give --decimal , --thousands . if "
          "the point divides thousands, or --decimal . if it is the decimal mark",
          column, in_quotes(cell));
    }
    return has_point
               ? data_error(
                     "{}: {} has a decimal point; expected a decimal comma; correct the cell, or give --decimal . if "
                     "the point is the decimal mark",
                     column, in_quotes(cell))
               : number_beyond_doubles(column, cell);
  }
  if (const std::optional<NumberMarks> other = marks_of(cell); other && *other != marks) {
    const bool is_fraction = Decimals({','}).number(cell).has_value();
    if (other->thousands == 0)
      return data_error("{}: {} is not a number; expected a decimal point; give --decimal , if this is a decimal comma",
                        column, in_quotes(cell));
    return is_fraction && marks.decimal == '.'
               ? data_error(
                     "{}: {} is not a number; expected one without thousands separators; remove them, or give "
                     "--thousands , if the comma divides thousands, or --decimal , if it is a decimal comma",
                     column, in_quotes(cell))
               : number_with_marks(column, cell, other->decimal, other->thousands);
  }
  if (const std::string known = date_in_known_form(cell); !known.empty()) return date_not_read(column, cell, known);
  const bool has_digit = cell.find_first_of("0123456789") != std::string_view::npos;
  const bool may_be_time = (cell.find(':') != std::string_view::npos && cell[0] >= '0' && cell[0] <= '9') ||
                           (has_digit && cell.find_first_of("-/ ", 1) != std::string_view::npos &&
                            (is_usual_time(column) || ends_like_time(column))) ||
                           (cell.find_first_not_of("0123456789") == 4 && cell[4] == '-');  // as 2024-03 and 2024-W09
  if (may_be_time) {
    return data_error(
        "{}: {} is no number, and no time in a known notation; expected a number, or a time such as "
        "2024-03-01T13:00:00Z, 2024-03-01 or 13:00:00; convert the cells, as to_datetime of pandas does with the "
        "argument format",
        column, in_quotes(cell));
  }
  if (const std::size_t minus = cell.find("\u2212"); minus != std::string_view::npos) {
    return data_error("{}: {} has the minus sign U+2212; expected -; replace it, as in sed s/\u2212/-/g", column,
                      in_quotes(cell));
  }
  std::string as_exponent(cell);
  std::ranges::replace_if(
      as_exponent, [](char c) { return c == 'D' || c == 'd'; }, 'E');
  if (parse_number(as_exponent)) {
    return data_error("{}: {} has an exponent as Fortran writes it; expected e or E; change it", column,
                      in_quotes(cell));
  }
  if (const std::string command = command_without_unit(cell); !command.empty()) {
    return data_error(
        "{}: {} is not a number, but has one; expected it alone; remove the rest, as in {} FILE | tcbsample", column,
        in_quotes(cell), command);
  }
  const std::string text = with_point(cell);
  const bool several =
      std::ranges::all_of(split(text, ' '), [](std::string_view number) { return looks_numeric(number); });
  return several ? data_error(
                       "{}: {} is not a number; expected one number in each cell; give the delimiter with --delimiter",
                       column, in_quotes(cell))
                 : data_error("{}: {} is not a number; expected a decimal such as -1.5 or 2e3; correct the cell",
                              column, in_quotes(cell));
}

Error number_beyond_doubles(std::string_view column, std::string_view cell) {
  return data_error("{}: {} is not a finite double; expected less than 1.8e308 in size; correct the cell", column,
                    in_quotes(cell));
}

}  // namespace tcb
