// Header of delimited text: names and roles of the columns, from the first three records.
#pragma once

#include <vector>

#include "read/chunk.hpp"
#include "read/csv/dialect.hpp"
#include "read/input_options.hpp"
#include "schema/columns.hpp"
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
  bool names_quaternion = false;  ///< x, y, z and w after x, y and z are named as a quaternion
  std::string encoding = {};      ///< of names and texts, where it is not UTF-8
  bool is_of_format = false;      ///< the format has the columns, not the text
};

/// Dialect and columns, from the header if there is one and the first two records after it; `rest` gets the text that
/// was read, from the first record of numbers on. Throws: Error (data).
DelimitedHead read_head(const Source<Chunk>& chunks, const Dialect& dialect, const InputOptions& options,
                        std::vector<Chunk>& rest);

}  // namespace tcb
