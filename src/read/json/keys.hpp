// JSON keys: records on a tape become keys.
#pragma once

#include "read/json/columns.hpp"
#include "read/json/tables.hpp"
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

}  // namespace tcb
