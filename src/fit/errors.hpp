// Errors of fits: one function for each fault.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "error.hpp"

namespace tcb {

// What is fitted:
Error fit_picture_of_several_files();
Error fit_without_times();
/// The samples have a column with a role of keys, such as tension.
Error fit_of_keys(std::string_view role);
/// `member`: a setting of a curve in JSON.
Error fit_of_setting(std::string_view member);
/// Several curves in a format that has no mark between them.
Error fit_of_sequence(std::string_view format);

// Its limits:
/// `channels`: those that may have a tolerance of their own.
Error tolerance_of_unknown_channel(std::string_view name, const std::vector<std::string>& channels);
Error channel_without_tolerance(std::string_view channel);
/// `column`: one of a rotation that is no quaternion.
Error fit_of_other_form(std::string_view column);

// Its samples:
Error sample_without_number(std::string_view channel);
Error too_few_samples();
/// Squares of the numbers of a channel, or of its tolerance, overflow.
Error fit_beyond_doubles(std::string_view channel);
/// `largest`: the size of the numbers of the channel; `least`: the least tolerance at that size.
Error tolerance_below_doubles(double tolerance, std::string_view channel, double largest, double least);
Error no_sample_to_keep(std::string_view time);

/// No key parameters meet the tolerance.
Error no_fit_found();

}  // namespace tcb
