// How rows look as text: a layout is a value, and one loop prints them all.
#include "format/layout.hpp"

#include <fmt/format.h>

#include "format/number.hpp"

namespace tcb::format {
namespace {

void append_cell(std::string& out, CellKind kind, const Cell& cell) {
  switch (kind) {
    case CellKind::time: append_time(out, cell); break;
    case CellKind::real: append_number(out, cell.hi); break;
    case CellKind::whole: append_whole(out, static_cast<std::uint64_t>(cell.hi)); break;
  }
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

}  // namespace

std::string delimited_text(std::string_view text, char delimiter) {
  const bool plain = text.find_first_of("\"\r\n") == std::string_view::npos &&
                     text.find(delimiter) == std::string_view::npos &&
                     !(delimiter == ' ' && (text.empty() || text.find_first_of(" \t") != std::string_view::npos));
  if (plain) return std::string(text);
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + '"';
}

std::string json_text(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') quoted += '\\';
    const auto code = static_cast<unsigned char>(c);
    quoted += code < 0x20 ? fmt::format("\\u{:04x}", code) : std::string(1, c);
  }
  return quoted + '"';
}

void append_rows(std::string& out, const Layout& layout, const std::vector<OutputColumn>& columns,
                 const std::vector<Cell>& cells, bool first) {
  for (std::size_t row = 0; row < cells.size(); row += columns.size()) {
    if (row > 0 || !first) out += layout.between_rows;
    for (std::size_t i = 0; i < columns.size(); ++i) {
      out += layout.before[i];
      if (is_empty(cells[row + i])) {
        out += layout.empty;
      } else {
        append_cell(out, columns[i].kind, cells[row + i]);
      }
    }
    out += layout.row_end;
  }
}

Layout delimited_layout(const std::vector<OutputColumn>& columns, char delimiter, bool header) {
  Layout layout;
  for (const OutputColumn& column : columns) {
    layout.before.emplace_back(layout.before.empty() ? "" : std::string(1, delimiter));
    if (header) layout.head += layout.before.back() + delimited_text(column.name, delimiter);
  }
  if (header) layout.head += '\n';
  layout.row_end = "\n";
  if (delimiter == ' ') layout.empty = "NA";  // nothing between blanks would be no cell
  return layout;
}

Layout json_layout(const std::vector<OutputColumn>& columns) {
  return {"[\n", members(columns), "}", "null", ",\n", "\n]\n", "]\n"};
}

Layout jsonl_layout(const std::vector<OutputColumn>& columns) {
  return {"", members(columns), "}\n", "null", "", "", ""};
}

}  // namespace tcb::format
