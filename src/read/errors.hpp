// Errors of inputs in any format: what their bytes are, times that are not numbers, and earlier outputs.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "error.hpp"

namespace tcb {

// The first bytes.
Error compressed_input(std::string_view compression, std::string_view command);
Error input_in_other_format(std::string_view format);
/// `function` of pandas reads it.
Error table_in_other_format(std::string_view format, std::string_view function);
Error text_not_in_utf8(std::string_view encoding);
Error two_byte_order_marks();
Error blank_beginning();

// All bytes.
Error nul_in_text();

// Times in words. `column` is the name of the column or of the member of JSON.
Error no_such_time(std::string_view column, std::string_view time);
/// A time has two columns, of seconds and of nanoseconds.
Error time_parts_not_whole(std::string_view time);
Error time_in_other_notation(std::string_view column, std::string_view time);

// Formats that are not text.
Error options_of_text(std::string_view format);

// Files without tracks.
Error file_without_tracks(std::string_view format);

// NumPy arrays.
Error not_an_npy();
Error npy_ends_early();
Error npy_header_unknown(std::string_view text);
Error npy_column_not_a_number(std::string_view column, std::string_view type);
Error npy_of_other_shape(std::size_t dimensions, bool is_structured);

// Earlier outputs.
Error no_provenance();

}  // namespace tcb
