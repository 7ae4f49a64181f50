// Conflicts: options that exclude each other, need another, or have no effect, as one table.
#pragma once

#include <array>
#include <string_view>

#include "cli/typed_options.hpp"
#include "option_names.hpp"

namespace tcb {

/// The options that place the samples.
inline constexpr std::array sampling_options{
    option::step,        option::rate, option::fps,      option::count,     option::segments,
    option::per_segment, option::at,   option::arc_step, option::arc_count, option::arc_at,
    option::tolerance,   option::emit, option::fit};

bool has_sampling_option(const TypedOptions& typed);

/// Whether samples are compared, so that there is a report.
bool is_comparison(const TypedOptions& typed);
/// Whether maxima are printed, so that there is a report.
bool prints_limits(const TypedOptions& typed);

/// No length, speed or distance is requested, so that a metric has no effect.
bool needs_no_metric(const TypedOptions& typed);

/// Throws: Error (usage) for the first conflict of the options that are given, in the order of the table.
void require_no_conflict(const TypedOptions& typed);

}  // namespace tcb
