// Errors of curves: faults of the library in the words of the program, with its channels and lines.
#include "sample/curve_errors.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "numbers/print_number.hpp"
#include "option_names.hpp"
#include "text/utf8.hpp"

namespace tcb {

Error curve_error(const spline::BuildError& error, const KeyStore& keys, const std::vector<std::string>& channels) {
  using enum spline::BuildErrorCode;
  const TextPosition last{"", keys.last_line(), 0};
  const auto channel = [&] { return in_quotes(channels[error.channel]); };
  switch (error.code) {
    case channel_without_positions:
      return {Exit::data, fmt::format("channel {} has no number in any key; expected at least one; fill one in, or "
                                      "leave the column out with {}",
                                      channel(), option::columns)};
    case ease_with_missing_positions:
      return {Exit::data, fmt::format("ease_in and ease_out warp all channels of a segment, but {} skip-cell left some "
                                      "cells empty; expected a number in every channel; fill the cells in, or give {}",
                                      option::missing, option::no_ease)};
    case closed_too_few_keys:
      return {Exit::data, "the closed curve has a single key; expected at least two different ones; add a key"};
    case period_missing:
      return {Exit::data, fmt::format("the period of the closed curve is unknown; expected it, or a last key that "
                                      "repeats the first position; add that key, or give {} P",
                                      option::period)};
    case period_not_finite:
    case period_too_short:
      return {Exit::data, fmt::format("the closed curve is back at its first key before its last one, at time {}; "
                                      "expected a longer period; correct it",
                                      time_text(keys.key(error.key).times[0]))};
    case period_contradicted:
      return Error(Exit::data, fmt::format("this key repeats the position of line {} and so ends the period, but at "
                                           "another time than the given period; expected the same; remove one of them",
                                           keys.first_line()))
          .at(last);
    case seam_tcb_differs:
      return Error(Exit::data, fmt::format("this key closes the curve at the position of line {}, but with another "
                                           "tension, continuity or bias; expected the same; correct one of the two",
                                           keys.first_line()))
          .at(last);
    case seam_velocity_differs:
      return Error(Exit::data, fmt::format("this key closes the curve at the position of line {}, but with another "
                                           "velocity in channel {}; expected the same; correct one of the two, or "
                                           "leave empty the incoming one of the first key and the outgoing one of the "
                                           "last",
                                           keys.first_line(), channel()))
          .at(last);
    case seam_velocity_missing:
      return {Exit::data, fmt::format("channel {} lacks a velocity where the closed curve returns to its first key; "
                                      "expected the incoming one of the first key and the outgoing one of the last; "
                                      "fill them in",
                                      channel())};
    default: throw std::logic_error(error.message());  // the stages before find every other fault
  }
}

Error tangents_beyond_doubles(const Time& start, const Time& end) {
  return {Exit::data, fmt::format("the curve from time {} to {} has tangents beyond the range of doubles; expected "
                                  "less than 1.8e308 in size; scale the keys down",
                                  time_text(start), time_text(end))};
}

Error length_beyond_doubles(const Time& end) {
  return {Exit::data, fmt::format("up to time {} the length of the curve is beyond the range of doubles; expected "
                                  "less than 1.8e308; scale the keys down",
                                  time_text(end))};
}

}  // namespace tcb
