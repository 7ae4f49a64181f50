// Layouts: the texts around cells and rows of each format, and the loop that prints rows.
#include "write/layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "error.hpp"
#include "numbers/print_number.hpp"
#include "schema/key_block.hpp"
#include "schema/texts.hpp"
#include "write/output_format.hpp"

namespace tcb {
namespace {

/// The head of a NumPy file of doubles, rows x columns in C order. Promises: the size is the same for all numbers.
/// Source: NumPy, "numpy.lib.format", version 1.0 of the format.
std::string npy_head(std::size_t columns, std::uint64_t rows) {
  constexpr std::size_t size = 128;  // a multiple of 64, as the format requires
  constexpr std::string_view magic("\x93NUMPY\x01\x00", 8);
  constexpr char remaining = size - magic.size() - 2;
  std::string head(magic);
  head += {remaining, '\0'};
  head += fmt::format("{{'descr': '<f8', 'fortran_order': False, 'shape': ({}, {}), }}", rows, columns);
  head.resize(size - 1, ' ');
  return head + '\n';
}

/// A text as a cell: in quotes if RFC 4180 requires them.
std::string delimited_text(std::string_view text, char delimiter) {
  const bool plain = text.find_first_of("\"\r\n") == std::string_view::npos &&
                     text.find(delimiter) == std::string_view::npos && !text.starts_with('#') &&
                     !(delimiter == ' ' &&
                       (text.empty() || text.starts_with('>') || text.find_first_of(" \t") != std::string_view::npos));
  if (plain) return std::string(text);
  std::string quoted;
  add_quoted(quoted, text);
  return quoted;
}

std::string delimited_cell(std::string_view text, char delimiter) {
  return text.empty() && delimiter == ' ' ? "NA" : delimited_text(content(text), delimiter);
}

std::string json_cell(std::string_view text, char) {
  if (text.empty()) return "null";
  return is_string(text) ? json_text(content(text)) : std::string(text);
}

char* write_cell(char* out, CellKind kind, const Cell& cell) {
  switch (kind) {
    case CellKind::time:
    case CellKind::duration: return write_time(cell, out);
    case CellKind::real: return write_shortest(cell.hi, out);
    case CellKind::whole: return write_whole(static_cast<std::uint64_t>(cell.hi), out);
  }
  return out;
}

char* write_cell(char* out, CellKind kind, const Cell& cell, const Notation& notation) {
  if (notation.kind == Notation::Kind::shortest || (kind == CellKind::whole && notation.is_text())) {
    return write_cell(out, kind, cell);
  }
  if (!notation.is_text() && cell.lo != 0) {
    throw data_error(
        "time {} has more digits than a double holds; expected a double, or a text format; give another format, such "
        "as csv, to --output-format",
        time_text(cell));
  }
  return kind == CellKind::time ? write_time(cell, notation, out) : write_number(cell.hi, notation, out);
}

char* write_cell(char* out, CellKind kind, const Cell& cell, const Layout& layout) {
  char* const end = write_cell(out, kind, cell, layout.notation);
  if (layout.decimal != '.') std::replace(out, end, '.', layout.decimal);
  return end;
}

char* write_text(char* out, std::string_view text) {
  if (text.size() != 1) return std::copy(text.begin(), text.end(), out);
  *out = text.front();  // usually a delimiter
  return out + 1;
}

std::size_t longest_row(const Layout& layout) {
  std::size_t length = layout.between_rows.size() + layout.row_end.size() + longest_time;
  const std::size_t cell = std::max(longest_number_in(layout.notation), layout.empty.size());
  for (const std::string& before : layout.before) length += before.size() + cell;
  return length;
}

/// The texts before the members of an object.
std::vector<std::string> members(const std::vector<OutputColumn>& columns) {
  std::vector<std::string> before;
  before.reserve(columns.size());
  for (const OutputColumn& column : columns) {
    before.push_back((before.empty() ? "{" : ",") + json_text(column.name) + ":");
  }
  return before;
}

/// An array of objects, one per line.
Layout json_layout(const std::vector<OutputColumn>& columns, const TextMarks&, bool) {
  return {"[\n", members(columns), "}", "null", ",\n", "\n]", "]", "\n", "null"};
}

/// An object per line.
Layout jsonl_layout(const std::vector<OutputColumn>& columns, const TextMarks&, bool) {
  return {"", members(columns), "}\n", "null", "", "", "", "", "null\n"};
}

}  // namespace

Layout npy_layout(const std::vector<OutputColumn>& columns, const TextMarks&, bool) {
  Layout layout;
  layout.head = npy_head(columns.size(), 0);
  layout.before.resize(columns.size());
  layout.notation.kind = Notation::Kind::bytes;
  std::array<char, number_room> bytes{};
  layout.empty = {bytes.data(), write_number(std::numeric_limits<double>::quiet_NaN(), layout.notation, bytes.data())};
  return layout;
}

std::string for_pages(std::string_view json) {
  std::string escaped;
  for (std::size_t i = 0; i < json.size(); ++i) {
    constexpr std::string_view line_separator = "\xE2\x80\xA8", paragraph_separator = "\xE2\x80\xA9";
    const std::string_view three = json.substr(i, line_separator.size());
    if (three == line_separator || three == paragraph_separator) {  // which end a line of JavaScript
      escaped += three == line_separator ? "\\u2028" : "\\u2029";
      i += three.size() - 1;
      continue;
    }
    if (json[i] == '/' && i > 0 && json[i - 1] == '<') escaped += '\\';  // it would end a script in a page of HTML
    escaped += json[i];
  }
  return escaped;
}

std::string json_text(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') quoted += '\\';
    const auto code = static_cast<unsigned char>(c);
    quoted += code < 0x20 ? fmt::format("\\u{:04x}", code) : std::string(1, c);
  }
  return for_pages(quoted + '"');
}

std::string json_list(const std::vector<std::string>& texts) {
  std::string list;
  for (const std::string& text : texts) list += (list.empty() ? "" : ",") + json_text(text);
  return "[" + list + "]";
}

/// Rows without texts in place of numbers.
static void append_numbers(std::string& out, const Layout& layout, std::span<const PrintedColumn> columns,
                           const RowCells& rows, bool first) {
  const std::size_t begin = out.size();
  const bool shortest = layout.notation.kind == Notation::Kind::shortest && layout.decimal == '.';
  std::vector<std::pair<std::string_view, PrintedColumn>> row;  // each column with the text before its cell
  for (std::size_t i = 0; i < columns.size(); ++i) row.emplace_back(layout.before[i], columns[i]);
  out.resize(begin + rows.cells.size() / rows.width * longest_row(layout) + spare_room);
  char* at = out.data() + begin;
  const Cell* const end = rows.cells.data() + rows.cells.size();
  for (const Cell* cells = rows.cells.data(); cells != end; cells += rows.width) {
    if (cells != rows.cells.data() || !first) at = write_text(at, layout.between_rows);
    for (const auto& [before, column] : row) {
      const Cell& cell = cells[column.cell];
      at = write_text(at, before);
      at = is_empty(cell) ? write_text(at, layout.empty)
           : shortest     ? write_cell(at, column.kind, cell)
                          : write_cell(at, column.kind, cell, layout);
    }
    at = write_text(at, layout.row_end);
  }
  out.resize(static_cast<std::size_t>(at - out.data()));
}

void append_rows(std::string& out, const Layout& layout, std::span<const PrintedColumn> columns, const RowCells& rows,
                 const ShownTimes& times, bool first) {
  if (rows.texts.empty() && times.are_as_they_are()) return append_numbers(out, layout, columns, rows, first);
  ShownTimes::Texts shown(times);
  out.reserve(out.size() + rows.cells.size() / rows.width * longest_row(layout));
  std::string number(longest_number_in(layout.notation) + spare_room, '\0');
  for (std::size_t begin = 0; begin < rows.cells.size(); begin += rows.width) {
    if (begin > 0 || !first) out += layout.between_rows;
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const auto [kind, cell] = columns[i];
      const Cell& value = rows.cells[begin + cell];
      out += layout.before[i];
      if (is_empty(value)) {
        out += layout.empty;
      } else if (kind == CellKind::time && !times.are_as_they_are()) {
        shown.append(out, value);
      } else if (!rows.texts.empty() && !rows.texts[begin + cell].empty()) {
        const auto text = static_cast<std::ptrdiff_t>(out.size());
        out += rows.texts[begin + cell];
        if (layout.decimal != '.') std::replace(out.begin() + text, out.end(), '.', layout.decimal);
      } else {
        out.append(number.data(), write_cell(number.data(), kind, value, layout));
      }
    }
    out += layout.row_end;
  }
}

Layout delimited_layout(const std::vector<OutputColumn>& columns, const TextMarks& marks, bool header) {
  Layout layout;
  layout.row_end = layout.divider = "\n";
  layout.decimal = marks.decimal;
  for (const OutputColumn& column : columns) {
    layout.before.emplace_back(layout.before.empty() ? "" : std::string(1, marks.delimiter));
    if (header) layout.head += layout.before.back() + delimited_text(column.name, marks.delimiter);
  }
  if (header) layout.head += layout.row_end;
  if (marks.delimiter == ' ') layout.empty = "NA";  // between blanks, an empty text would not be a cell
  return layout;
}

extern const OutputFormat delimited_output{.layout = delimited_layout, .text = delimited_cell};
extern const OutputFormat json_output{.layout = json_layout, .text = json_cell};
extern const OutputFormat jsonl_output{.layout = jsonl_layout, .text = json_cell};
extern const OutputFormat npy_output{
    .layout = npy_layout, .counted_head = npy_head, .has_groups = false, .has_labels = false};

}  // namespace tcb
