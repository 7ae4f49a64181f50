// JSON keys: records on a tape become keys, and the members around them settings of the curve, names of channels, and
// an id.
#pragma once

#include <string>
#include <vector>

#include "read/json/columns.hpp"
#include "read/json/tables.hpp"
#include "schema/curve_settings.hpp"
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
  CurveInfo curve_info;
  std::vector<std::string> channels;  ///< names of the numbers of "position"
  std::vector<std::string> unused;    ///< members with numbers that are no settings
  std::string shown_rate;             ///< the number of the first of them that is a frame rate; empty: none
  std::string path;                   ///< of the object, empty for the outermost one
  TextPosition position;              ///< where it begins
};

/// Whether a member is a frame rate by its name, and a number.
bool is_frame_rate(const JsonTape& tape, std::size_t name);

/// Throws: Error (data) at a member that is wrong, or whose name is a near miss.
JsonCurveInfo read_curve_info(const JsonPart& part);

/// The names of channels in an object whose text ends with the opening bracket of its keys, if it has any.
std::vector<std::string> channels_before_keys(const Chunk& text);

}  // namespace tcb
