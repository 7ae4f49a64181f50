// Layouts: the texts around cells and rows as a value, and the one loop that prints all of them.
#pragma once

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
  std::string no_rows;     ///< instead of `tail` where there is no row
  std::string end;         ///< of the whole output, after its last list of rows
  Notation notation = {};  ///< of numbers that may have a fraction
};

/// Appends rows to text. Shapes: cells holds a whole number of rows, columns.size() cells each.
/// `first`: there is no row before these.
void append_rows(std::string& out, const Layout& layout, const std::vector<OutputColumn>& columns,
                 const std::vector<Cell>& cells, bool first);

/// The same for cells of which some have texts of their own, the others empty ones.
void append_rows(std::string& out, const Layout& layout, const std::vector<OutputColumn>& columns,
                 const std::vector<Cell>& cells, const std::vector<std::string>& texts, bool first);

/// A text as a cell: in quotes where RFC 4180 asks for them.
std::string delimited_text(std::string_view text, char delimiter);

/// A text as a JSON string.
std::string json_text(std::string_view text);

/// Rows of cells with a delimiter between, below the names where there is a header.
Layout delimited_layout(const std::vector<OutputColumn>& columns, char delimiter, bool header);

/// An array of objects, one a line.
Layout json_layout(const std::vector<OutputColumn>& columns);

/// An object a line.
Layout jsonl_layout(const std::vector<OutputColumn>& columns);

}  // namespace tcb
