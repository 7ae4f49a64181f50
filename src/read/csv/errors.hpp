// Errors of delimited text: delimiter, header, records, and cells. A column is shown by its name, or as "column 3".
#pragma once

#include <cstddef>
#include <string_view>

#include "error.hpp"

namespace tcb {

// The delimiter.
Error decimal_comma_is_delimiter();
Error other_delimiter_likely(char delimiter, char likely_delimiter);

// The header and the first records.
Error empty_input();
Error empty_samples();
/// Of a file of samples.
Error samples_header_unclear(std::string_view text_cell, std::string_view number_cell);
Error header_without_rows();
Error lines_end_in_carriage_returns();
Error header_unclear(std::string_view text_cell, std::string_view number_cell);
Error row_unlike_header(std::size_t cells, std::size_t names);
Error column_name_not_utf8(std::string_view name, char byte);

// Records.
Error record_too_long();
Error too_many_cells(std::size_t most);
Error quote_not_closed();
Error text_after_quotes();
Error wrong_number_of_cells(std::size_t cells, std::size_t expected);
/// Of a format with fixed columns.
Error line_unlike_format(std::size_t cells, std::size_t expected);

// Cells of texts.
Error cell_not_utf8(std::string_view cell, char byte);
Error group_is_empty(std::string_view column);
Error number_in_text_column(std::string_view column, std::string_view cell);

// Cells of numbers. An empty cell, or one with a sign such as NA, is missing.
Error number_is_missing(std::string_view column, std::string_view cell);
/// A row is a segment, from its start to its end.
Error number_of_segment_is_missing(std::string_view column, std::string_view cell);
Error time_is_missing(std::string_view column, std::string_view cell);
Error number_with_decimal_point(std::string_view column, std::string_view cell);
Error number_with_decimal_comma(std::string_view column, std::string_view cell);
/// The comma may be either mark.
Error number_with_thousands(std::string_view column, std::string_view cell);
/// It is a number with these marks; `decimal` is 0 if it is that of the input.
Error number_with_marks(std::string_view column, std::string_view cell, char decimal, char thousands);
Error number_beyond_doubles(std::string_view column, std::string_view cell);
Error several_numbers_in_cell(std::string_view column, std::string_view cell);
Error word_in_column_of_numbers(std::string_view column, std::string_view cell);
Error cell_is_not_a_number(std::string_view column, std::string_view cell);

/// An error about a cell of a column that may hold texts: it also offers to leave out the column.
Error times_in_text_column(std::string_view column, std::string_view cell);
Error in_possible_text_column(const Error& error);

}  // namespace tcb
