// Shapes of JSON inputs: lists of keys, objects with keys, objects with curves, JSON Lines.
//
// Source: RFC 8259.
#pragma once

#include <string>

#include "read/input.hpp"
#include "read/input_options.hpp"
#include "stream/source.hpp"

namespace tcb {

/// Throws: Error (usage) for options of delimited text.
void refuse_options_of_text(const InputOptions& options);

/// Opens JSON of any shape: an array of keys, an object with "keys", one with "curves", JSON Lines, a table, or a list
/// in another shape. Keys of an object are held until its settings are known. Requires: the bytes have no byte order
/// mark. Throws: Error (data).
Records open_json(Source<std::string> bytes, const InputOptions& options);

}  // namespace tcb
