// Tables in JSON: rows that are arrays, and values by column, as pandas and NumPy users write them.
//
// Source: pandas, DataFrame.to_json() with orient "split", "table", "columns" and "index"; and a list for each column,
// as
//   DataFrame.to_dict("list") has.
#pragma once

#include <optional>
#include <string>

#include "stream/source.hpp"

namespace tcb {

/// A table as a list of key objects in one line. It is read whole.
struct JsonTable {
  std::string list;
  bool has_times_in_index = false;  ///< the index of its rows is their time
};

/// The table that a JSON text is; nothing for other texts, whose bytes are left as they were.
/// Throws: Error (data) for a table that is not valid JSON, or whose columns differ in length.
std::optional<JsonTable> take_table(Source<std::string>& bytes);

}  // namespace tcb
