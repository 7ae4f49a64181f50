// Errors of pictures: one function for each fault.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "error.hpp"

namespace tcb {

/// The next file of a picture has other columns than the files before.
Error columns_of_other_picture(const std::vector<std::string>& columns, const std::vector<std::string>& expected);

/// An axis that is requested has no channel; about the option of the axes.
Error no_channel_for_axis(std::string_view name, const std::vector<std::string>& channels);

/// Both axes are the same channel; about the option of the axes.
Error axes_are_same(std::string_view name);

/// The picture would have more strips than can be read.
Error too_many_strips(std::size_t strips, std::size_t most);

/// The extent of a channel overflows.
Error picture_beyond_doubles();

/// The views do not fit in the requested size.
Error picture_too_small(std::size_t channels);

}  // namespace tcb
