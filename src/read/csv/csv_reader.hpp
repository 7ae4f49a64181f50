// Reader of delimited text: names and roles of the columns from the first records, and from bytes to keys.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "read/csv/tokenizer.hpp"
#include "read/input.hpp"
#include "read/input_options.hpp"
#include "read/text_bytes.hpp"
#include "schema/columns.hpp"
#include "schema/key_block.hpp"
#include "schema/key_rules.hpp"
#include "schema/units.hpp"
#include "stream/source.hpp"

namespace tcb {

/// What the header and the first records determine.
struct DelimitedHead {
  Dialect dialect;
  Columns columns;
  KeyRules rules;
  KeyUnits units;
  NumberMarks marks = {};
  InputFacts facts = {};                   ///< about names, texts and times
  std::optional<TimeUnit> time_unit = {};  ///< from a row of units
  bool is_plain = false;                   ///< an empty parameter is that of the curve
  bool is_of_format = false;               ///< the format has the columns, not the text
  bool begins_with_value = false;          ///< the first cell of the first record is a number or a time
};

/// The first cell with a role; beyond all of them where there is none.
inline std::size_t cell_of(const Columns& columns, Role role) {
  const auto found = std::ranges::find(columns.cells, role, &Columns::Column::role);
  return static_cast<std::size_t>(found - columns.cells.begin());
}

/// The text of a time in several cells: a date and a time of day; or a year, a month and a day, with an hour, a minute
/// and a second as far as they are there.
std::string joined_time(std::span<const std::string> parts);

/// A line of a format with fixed columns has another number of cells.
Error line_unlike_format(std::size_t cells, std::size_t expected);

/// Dialect and columns, from the header if there is one and the first two records after it; `rest` gets the text that
/// was read, from the first record of numbers on. Throws: Error (data).
DelimitedHead read_head(const Source<Chunk>& chunks, const Dialect& dialect, const InputOptions& options,
                        std::vector<Chunk>& rest);

/// Up to this line, a number in a column of text is a fault; after it, it is taken as text.
inline constexpr std::uint64_t last_line_of_roles = 1000;

/// The keys of a chunk. A pure function. Errors are among its faults, at the position of the cell; at most ten.
KeyBlock parse_delimited(const Chunk& chunk, const DelimitedHead& head);

/// What begins comments in text of others, of which --comment takes one.
inline constexpr std::array<std::string_view, 6> comment_marks{"//", "%", "!", ";", "--", "*"};

/// A table that seems to begin below other lines.
struct LaterTable {
  std::uint64_t line;   ///< from 1
  std::uint64_t end;    ///< the last line, where others follow; 0: none does
  std::size_t cells;    ///< in each of its lines
  bool has_names;       ///< above them
  std::string options;  ///< that its columns need, as " --no-header"; may be empty
  bool follows_text;    ///< a line above it, below the first one, has no number
  bool has_tcb;         ///< one of its names is that of a parameter
  bool takes_rate;      ///< by its names it has times in frames, or none
  std::string comment;  ///< the mark with which all lines above it begin, of which the last one has its names; or empty
};

/// Two lines at least of the same number of cells that are mostly numbers, and the line of names directly above them:
/// of several such tables the longest one. Nothing where that is the first line.
std::optional<LaterTable> find_later_table(std::string_view text, const Dialect& dialect);

/// What to do about a table below line `first`. `reason`: why the text from there on is none; may be empty.
Error unlike_table(const LaterTable& table, std::uint64_t first, std::string_view reason);

/// The remedy for numbers that are within other text.
inline constexpr std::string_view numbers_alone = "write the numbers alone";

/// The names in a line, between two blanks at least, as each of them may have blanks.
std::vector<std::string_view> names_between_blanks(std::string_view line);

/// Removes empty names at the end for which the rows have no cells.
template <typename Names>
void remove_unused(Names& names, std::size_t cells) {
  while (names.size() > cells && names.back().empty()) names.pop_back();
}

/// Opens delimited text whose delimiter is given, or else detected in the first record.
/// Requires: the bytes have no byte order mark. Throws: Error (data).
Records open_delimited(Source<std::string> bytes, InputOptions options);

}  // namespace tcb
