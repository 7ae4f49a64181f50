// Errors of the pipeline: one function for each fault.
#pragma once

#include <exception>
#include <string>
#include <string_view>
#include <vector>

#include "error.hpp"

namespace tcb {

/// Times are to be made for keys that have them, in the column `time`; about the option of the parameterization.
Error parameter_with_times(std::string_view time);

/// `curve`: NAME=VALUE for each column of its group; about the option of the places.
Error group_without_places(const std::vector<std::string>& curve);

/// What a person is told of an exception; the texts of libraries are not for people.
Error failure_of(const std::exception& failure);

/// A duration such as 30min is given, and the times in this column are frames.
Error duration_of_frames(std::string_view time);

}  // namespace tcb
