// Errors of pictures, in the order in which a picture is made.
#include "plot/errors.hpp"

#include <fmt/format.h>

#include "option_names.hpp"
#include "text/suggest.hpp"
#include "text/utf8.hpp"

namespace tcb {

Error columns_of_other_picture(const std::vector<std::string>& columns, const std::vector<std::string>& expected) {
  return {Exit::data, fmt::format("the columns are {}; expected {}, as in the earlier files; give {} FOLDER to draw a "
                                  "picture of each file",
                                  listed(columns), listed(expected), option::output_dir)};
}

Error no_channel_for_axis(std::string_view name, const std::vector<std::string>& channels) {
  return {Exit::usage, fmt::format("there is no channel {}; expected two of {}, by name or by number from 1{}",
                                   in_quotes(name), listed(channels), did_you_mean(name, channels))};
}

Error axes_are_same(std::string_view name) {
  return {Exit::usage,
          fmt::format("both axes are the channel {}; expected two different channels; replace one", in_quotes(name))};
}

Error too_many_strips(std::size_t strips, std::size_t most) {
  return {Exit::usage, fmt::format("the picture would have {} strips over time; expected at most {}; choose channels "
                                   "with {} position=NAME:NAME",
                                   strips, most, option::columns)};
}

Error picture_beyond_doubles() {
  return {Exit::data,
          "the numbers of a channel are too far apart to be drawn; expected differences below 1.8e308; scale the keys "
          "down"};
}

Error picture_too_small(std::size_t channels) {
  return {Exit::usage, fmt::format("the picture is too small for {} channels; give a larger {}, or leave it out",
                                   channels, option::size)};
}

}  // namespace tcb
