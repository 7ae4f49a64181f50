// Layouts: the texts around cells and rows of each format, and the loop that prints rows.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "numbers/print_number.hpp"
#include "sample/table.hpp"
#include "schema/schema.hpp"
#include "write/shown_times.hpp"

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

/// A column of numbers, and the place of its cell in the rows of a table.
struct PrintedColumn {
  CellKind kind = CellKind::real;
  std::size_t cell = 0;
};

/// Rows of a table. A text is printed in place of the number of its cell, unless it is empty; there may be no texts.
struct RowCells {
  std::span<const Cell> cells;
  std::span<const std::string> texts;
  std::size_t width;  ///< the number of cells in a row, of which columns show some

  RowCells(const Table& table, std::size_t cells_per_row)
      : cells(table.cells), texts(table.texts), width(cells_per_row) {}

  /// One of them. Requires: first is the place of its first cell.
  RowCells row(std::size_t first) const {
    RowCells one = *this;
    one.cells = cells.subspan(first, width);
    if (!texts.empty()) one.texts = texts.subspan(first, width);
    return one;
  }
};

/// Appends rows to text, with times as they are shown. `first`: there is no row before these.
void append_rows(std::string& out, const Layout& layout, std::span<const PrintedColumn> columns, const RowCells& rows,
                 const ShownTimes& times, bool first);

std::string json_text(std::string_view text);
/// JSON of a library, whose texts are those of json_text() where they could end a script in a page.
std::string for_pages(std::string_view json);
std::string json_list(const std::vector<std::string>& texts);

/// Rows of delimited text, below the names if there is a header.
Layout delimited_layout(const std::vector<OutputColumn>& columns, const TextMarks& marks, bool header);

/// Rows of doubles, the lowest byte first, after the head of a NumPy file with 0 rows.
Layout npy_layout(const std::vector<OutputColumn>& columns, const TextMarks& marks = {}, bool header = true);

}  // namespace tcb
