// JSON keys: records on a tape become keys, and the members around them settings of the curve, names of channels, and
// an id.
#pragma once

#include <string>
#include <vector>

#include "read/json/columns.hpp"
#include "read/json/tables.hpp"
#include "read/settings.hpp"
#include "schema/key_block.hpp"

namespace tcb {

/// The keys of a part of whole records: objects, or rows with the names of `columns`.
/// A pure function. Errors are among its faults, at the position of the value; at most ten.
KeyBlock parse_json(const JsonPart& part, const JsonColumns& columns);

/// The error of a value in the place of a record, which is an object, or a row that is an array.
Error not_a_record(const JsonTape& tape, std::size_t value, bool is_row);

/// The keys of rows [first, last) of a table, as parse_json(). `lines` counts to the row before.
KeyBlock parse_table(const JsonTable& table, std::size_t first, std::size_t last, const JsonColumns& columns,
                     LineCounter& lines);

/// The members of an object around keys.
struct JsonCurveInfo {
  FileSettings settings;
  std::string path;       ///< of the object, empty for the outermost one
  TextPosition position;  ///< where it begins
};

/// Throws: Error (data) at a member that is wrong, or whose name is a near miss.
JsonCurveInfo read_curve_info(const JsonPart& part, const InputOptions& options);

/// The settings in the objects from the root to a table, and beside its columns.
FileSettings settings_around(const JsonTape& tape, const JsonTable& table, const InputOptions& options);

/// The settings in an object whose text ends before its keys, if it has any.
FileSettings settings_before_keys(const Chunk& text, const InputOptions& options);

}  // namespace tcb
