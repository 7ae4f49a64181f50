// How rows look as text: a layout is a value, and one loop prints them all.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "curve/fields.hpp"
#include "text/notation.hpp"

namespace tcb {

/// The texts around the cells of a table; `before` has one entry a column.
struct Layout {
  std::string head;
  std::vector<std::string> before;
  std::string row_end;
  std::string empty;  ///< for a number that is not defined
  std::string between_rows;
  std::string tail;
  std::string no_rows;     ///< instead of `tail` where not one row was written
  Notation notation = {};  ///< of numbers that may have a fraction
};

/// Appends rows to text. Shapes: cells holds a whole number of rows, columns.size() cells each.
/// `first` says that no row came before these.
void append_rows(std::string& out, const Layout& layout, const std::vector<OutputColumn>& columns,
                 const std::vector<Cell>& cells, bool first);

/// The same for cells of which some have texts of their own, the others empty ones.
void append_rows(std::string& out, const Layout& layout, const std::vector<OutputColumn>& columns,
                 const std::vector<Cell>& cells, const std::vector<std::string>& texts, bool first);

/// A text as a cell: in quotes where RFC 4180 asks for them.
std::string delimited_text(std::string_view text, char delimiter);

/// A text as a JSON string.
std::string json_text(std::string_view text);

/// Rows of cells with a delimiter between, and the names on top where wanted.
Layout delimited_layout(const std::vector<OutputColumn>& columns, char delimiter, bool header);

/// An array of objects, one a line.
Layout json_layout(const std::vector<OutputColumn>& columns);

/// An object a line.
Layout jsonl_layout(const std::vector<OutputColumn>& columns);

}  // namespace tcb
