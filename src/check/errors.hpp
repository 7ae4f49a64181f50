// Errors of comparisons: one function for each fault.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "error.hpp"

namespace tcb {

// Columns of samples, by their names or their order:
Error samples_have_same_column(std::string_view name);
/// `time`: the name of the time column of the keys.
Error samples_without_places(const std::vector<std::string>& columns, std::string_view time);
/// `known`: columns that the keys have values for.
Error nothing_to_compare(const std::vector<std::string>& columns, const std::vector<std::string>& known);
Error unnamed_sample_columns(std::size_t columns, const std::vector<std::string>& expected);
/// About the option of the fields.
Error fields_without_places();
/// `column`: of a tolerance, about its option; `compared`: columns that may have one.
Error tolerance_of_unknown_column(std::string_view column, const std::vector<std::string>& compared);
/// `channels`: those of the keys.
Error no_position_column(const std::vector<std::string>& channels);

// Rows of samples:
/// `problems`: why rows are off the curve.
Error no_row_on_curve(std::span<const std::string> problems);
Error no_number_in_samples();

}  // namespace tcb
