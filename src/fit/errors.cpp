// Errors of fits, in the order of the work.
#include "fit/errors.hpp"

#include <fmt/format.h>

#include "option_names.hpp"
#include "text/suggest.hpp"
#include "text/utf8.hpp"

namespace tcb {

Error fit_picture_of_several_files() {
  return {Exit::usage, fmt::format("a picture of {} shows one recording; expected one input and one output; draw each "
                                   "file by itself",
                                   option::fit)};
}

Error fit_without_times() {
  return {Exit::data, fmt::format("there is no time column; {} needs samples with times; name the column with {} "
                                  "time=NAME",
                                  option::fit, option::columns)};
}

Error fit_of_keys(std::string_view role) {
  return {Exit::data, fmt::format("there is a column of {}, which only keys have; {} needs samples; leave the column "
                                  "out with {} ignore=NAME",
                                  role, option::fit, option::columns)};
}

Error fit_of_setting(std::string_view member) {
  return {Exit::data, fmt::format("\"{}\" is a setting of a curve of keys; {} makes keys for the default rules; remove "
                                  "the setting",
                                  member, option::fit)};
}

Error fit_of_sequence(std::string_view format) {
  return {Exit::data,
          fmt::format("there are several curves, and {} does not show where one curve ends; give {} ssv or json, "
                      "or name a column of groups with {}",
                      format, option::output_format, option::group)};
}

Error tolerance_of_unknown_channel(std::string_view name, const std::vector<std::string>& channels) {
  return {Exit::data, fmt::format("there is no channel {} for a tolerance; expected one of {}{}", in_quotes(name),
                                  listed(channels), did_you_mean(name, channels))};
}

Error channel_without_tolerance(std::string_view channel) {
  return {Exit::data, fmt::format("channel \"{0}\" has no tolerance; the distance D is only for the channels of {1}; "
                                  "add {0}=D to {2}",
                                  channel, option::metric, option::fit)};
}

Error fit_of_other_form(std::string_view column) {
  return {Exit::data, fmt::format("column \"{}\" belongs to a rotation that is not a quaternion; {} needs quaternions; "
                                  "convert the samples first with {} quaternion",
                                  column, option::fit, option::rotation_output)};
}

Error sample_without_number(std::string_view channel) {
  return {Exit::data, fmt::format("channel \"{}\" has no number; {} needs a number in every sample; fill it "
                                  "in, or give {} skip-row",
                                  channel, option::fit, option::missing)};
}

Error too_few_samples() {
  return {Exit::data,
          fmt::format("the curve has fewer than two samples; {} needs at least two; add samples", option::fit)};
}

Error fit_beyond_doubles(std::string_view channel) {
  return {Exit::data, fmt::format("the numbers of channel \"{0}\" or its tolerance cannot be squared as doubles; "
                                  "expected numbers below 1e150 and a tolerance above 1e-150; give {1} {0}=FACTOR",
                                  channel, option::scale)};
}

Error tolerance_below_doubles(double tolerance, std::string_view channel, double largest, double least) {
  return {Exit::data, fmt::format("the tolerance {} is near the spacing of doubles in channel \"{}\", whose numbers "
                                  "reach {}; expected at least {}; give a larger tolerance",
                                  tolerance, channel, largest, least)};
}

Error no_sample_to_keep(std::string_view time) {
  return {Exit::data, fmt::format("there is no sample at time {}; expected times of samples; correct it", time)};
}

Error no_fit_found() {
  return {Exit::data, fmt::format("no tension, continuity and bias keep the curve within the tolerance of {}; this "
                                  "happens if the numbers have too few digits for the tolerance, or if positions "
                                  "repeat; give a larger tolerance, numbers with more digits, or {} hermite",
                                  option::fit, option::fit_keys)};
}

}  // namespace tcb
