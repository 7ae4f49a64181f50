// Conflicts: options that exclude each other, need another, or have no effect, and conditions on their values.
#pragma once

#include <initializer_list>
#include <string_view>

#include "cli/typed_options.hpp"
#include "option_names.hpp"

namespace tcb {

/// The options that place the samples.
inline constexpr std::initializer_list<std::string_view> sampling_options{
    option::step,        option::rate, option::fps,      option::count,     option::segments,
    option::per_segment, option::at,   option::arc_step, option::arc_count, option::arc_at,
    option::tolerance,   option::emit, option::fit};

/// The conflicts of an option that is given. Each function throws Error (usage) about the first option of a list that
/// is in conflict with it, unless the values do not meet the condition. `reason` goes on after the last option in the
/// message, such as ", which has no comments".
class Conflicts {
 public:
  using Options = std::initializer_list<std::string_view>;
  using Condition = bool (*)(const TypedOptions& typed);

  Conflicts(std::string_view option, const TypedOptions& typed) : option_(option), typed_(typed) {}

  /// At most one of the option and each of `others` can be given.
  void exclude(Options others, std::string_view reason = "", Condition condition = nullptr) const;
  /// One of `others` has to be given as well.
  void need(Options others, std::string_view reason = "", Condition condition = nullptr) const;
  /// None of `others` has an effect with the option.
  void disable(Options others, std::string_view reason = "", Condition condition = nullptr) const;
  /// The option has no effect where the condition is met.
  void require_effect(std::string_view reason, Condition has_none) const;

 private:
  /// The first of the options that is given, besides this one; "" if none is.
  std::string_view first_given(Options options) const;
  bool is_met(Condition condition) const { return condition == nullptr || condition(typed_); }
  std::string shown(std::string_view option, Condition condition) const;

  std::string_view option_;
  const TypedOptions& typed_;
};

/// Throws: Error (usage) for the first conflict of the options that are given, in the order of the table.
void require_no_conflict(const TypedOptions& typed);

// Conditions on the values of options.

/// The format of the input is given, and is not delimited text.
bool has_other_input_than_delimited(const TypedOptions& typed);
/// The decimal mark is also the delimiter.
bool has_one_comma_for_two(const TypedOptions& typed);
/// The decimal mark also divides thousands.
bool has_one_mark_for_two(const TypedOptions& typed);
/// Rows would have commas as decimal marks and as delimiters; without a delimiter that is given, and with one.
bool needs_output_delimiter(const TypedOptions& typed);
bool has_one_output_comma_for_two(const TypedOptions& typed);
/// Cells without a number are skipped, but all channels are needed at each key.
bool has_sparse_channels(const TypedOptions& typed);
/// No length, speed or distance is requested.
bool needs_no_metric(const TypedOptions& typed);
/// The curve is extended, but all samples are on it, as with steps and counts without a range in time.
bool stays_on_curve(const TypedOptions& typed);
bool extends_curve(const TypedOptions& typed);
/// There is a field that rows of pieces do not have.
bool has_field_of_samples(const TypedOptions& typed);
bool has_field_of_pieces(const TypedOptions& typed);
/// There is a field that is not exact.
bool has_rounded_field(const TypedOptions& typed);
/// No field can differ between the two sides of a key. Without fields, a comparison may have any of them.
bool has_no_side(const TypedOptions& typed);
bool has_more_digits_than_doubles(const TypedOptions& typed);
bool has_frames_of_time(const TypedOptions& typed);
bool has_no_sampling_option(const TypedOptions& typed);
/// The format of the output is one that a report does not have.
bool has_no_format_of_reports(const TypedOptions& typed);
bool has_picture(const TypedOptions& typed);
bool has_no_picture(const TypedOptions& typed);
bool has_binary_output(const TypedOptions& typed);
bool has_no_header(const TypedOptions& typed);
/// The rows of the output are poses.
bool has_poses(const TypedOptions& typed);
/// The output is an animation.
bool has_scene(const TypedOptions& typed);
/// The output has lines of polynomials.
bool has_pieces(const TypedOptions& typed);
bool has_samples_in_pieces(const TypedOptions& typed);
bool has_scene_of_other_form(const TypedOptions& typed);
/// The format has no delimiter, or its own.
bool has_fixed_delimiter(const TypedOptions& typed);
bool has_no_provenance(const TypedOptions& typed);

}  // namespace tcb
