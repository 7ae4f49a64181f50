// Input options: what is requested of the reading of an input.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "numbers/parse_number.hpp"
#include "read/memory_use.hpp"
#include "schema/columns.hpp"
#include "schema/format.hpp"
#include "schema/key_rules.hpp"
#include "schema/rotation_options.hpp"
#include "schema/units.hpp"

namespace tcb {

struct DelimitedOptions {
  std::optional<char> delimiter = {};    ///< ' ' is any run of blanks and tabs; nothing: found in the first record
  std::optional<bool> header = {};       ///< nothing: found in the first records
  std::string comment = "#";             ///< the prefix of lines to skip; empty: none
  NumberMarks marks = {};                ///< in numbers
  bool is_plain = false;                 ///< the text is a table that the program made; a blank line ends a curve
  std::vector<std::string> meant = {};   ///< names of columns that are in no doubt
  std::string array = {};                ///< the name of the only array of positions; empty: there is none
  bool has_decimal = false;              ///< the decimal mark is given, so a comma is no other one
  std::uint64_t skipped_lines = 0;       ///< at the beginning, which are not part of the table
  std::vector<std::string> names = {};   ///< of the columns of a format; empty: the text may have names
  std::vector<std::string> others = {};  ///< of columns that may follow these, and are read if they are requested

  friend bool operator==(const DelimitedOptions&, const DelimitedOptions&) = default;
};

/// The settings of a curve that options give instead of the file.
struct GivenSettings {
  bool closed = false, period = false;  ///< how the curve closes, or that it does not
  bool preset = false, tangents = false, ends = false;
};

struct InputOptions {
  const Format* format = nullptr;  ///< null: by ending or content
  DelimitedOptions delimited = {};
  ColumnOptions columns = {};
  KeyRules keys = {};
  bool has_shown_tcb_scale =
      false;  ///< the product of the preset shows a scale of T, C and B, which keys are checked by
  UnitOptions units = {};
  RotationOptions rotation = {};
  GivenSettings given = {};
  std::vector<Renaming> renamings = {};           ///< of columns in the output
  std::vector<std::string> only = {};             ///< patterns of the tracks to read; empty: all
  std::string records = {};                       ///< the path of the list of keys in JSON; empty: found by its shape
  std::uint64_t max_memory = default_max_memory;  ///< in bytes, of what a reader must keep
  unsigned threads = 1;                           ///< at most
};

}  // namespace tcb
