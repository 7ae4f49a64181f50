// Layouts: the texts around cells and rows of each format, and the loop that prints rows.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "numbers/print_number.hpp"
#include "sample/table.hpp"
#include "schema/schema.hpp"

namespace tcb {

/// The texts around the cells of a table; `before` has one entry per column.
struct Layout {
  std::string head;
  std::vector<std::string> before;
  std::string row_end;
  std::string empty;  ///< for a number that is not defined
  std::string between_rows;
  std::string tail;
  std::string no_rows;     ///< instead of `tail` if there is no row
  std::string end;         ///< of the whole output, after its last list of rows
  std::string divider;     ///< the line between two curves of the same group; empty: impossible
  Notation notation = {};  ///< of numbers that may have a fraction
  char decimal = '.';      ///< their decimal mark
};

/// Appends rows to text. Shapes: cells holds a whole number of rows, columns.size() cells each. texts[i] is printed in
/// place of the number of cell i, unless it is empty; texts may be empty. `first`: there is no row before these.
void append_rows(std::string& out, const Layout& layout, const std::vector<OutputColumn>& columns,
                 const std::vector<Cell>& cells, const std::vector<std::string>& texts, bool first);

std::string json_text(std::string_view text);
/// JSON of a library, whose texts are those of json_text() where they could end a script in a page.
std::string for_pages(std::string_view json);
std::string json_list(const std::vector<std::string>& texts);

/// Rows of delimited text, below the names if there is a header.
Layout delimited_layout(const std::vector<OutputColumn>& columns, const TextMarks& marks, bool header);

/// Rows of doubles, the lowest byte first, after the head of a NumPy file with 0 rows.
Layout npy_layout(const std::vector<OutputColumn>& columns, const TextMarks& marks = {}, bool header = true);

}  // namespace tcb
