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

/// A name as a cell: in quotes where RFC 4180 asks for them.
std::string delimited_name(const std::string& name, char delimiter) {
  const bool plain = name.find_first_of("\"\r\n") == std::string::npos && name.find(delimiter) == std::string::npos &&
                     !(delimiter == ' ' && name.find_first_of(" \t") != std::string::npos);
  if (plain) return name;
  std::string quoted = "\"";
  for (const char c : name) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + '"';
}

/// A name as a JSON string.
std::string json_name(const std::string& name) {
  std::string text = "\"";
  for (const char c : name) {
    if (c == '"' || c == '\\') text += '\\';
    const auto code = static_cast<unsigned char>(c);
    text += code < 0x20 ? fmt::format("\\u{:04x}", code) : std::string(1, c);
  }
  return text + '"';
}

/// The texts before the members of an object.
std::vector<std::string> members(const std::vector<OutputColumn>& columns) {
  std::vector<std::string> before;
  before.reserve(columns.size());
  for (const OutputColumn& column : columns) {
    before.push_back((before.empty() ? "{" : ",") + json_name(column.name) + ":");
  }
  return before;
}

}  // namespace

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
    if (header) layout.head += layout.before.back() + delimited_name(column.name, delimiter);
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
