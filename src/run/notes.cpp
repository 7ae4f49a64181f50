// Notes about inputs and curves, in the order of the flow.
#include "run/notes.hpp"

#include <fmt/format.h>

#include "option_names.hpp"
#include "text/suggest.hpp"
#include "text/utf8.hpp"

namespace tcb {

Note reads_terminal() { return {"keys are read from the terminal; end them with Ctrl-D, or name a file"}; }

Note text_converted(std::string_view encoding) {
  return {fmt::format("the text is in {}, and was converted to UTF-8", encoding), true};
}

Note names_converted(std::string_view named, std::string_view encoding) {
  return {fmt::format("names of {} are not in UTF-8; they are taken as {}", named, encoding), true};
}

Note positions_by_elimination(const std::vector<std::string>& names) {
  return {fmt::format("positions: {}; {} gives other roles, as in ignore=NAME or tension=NAME", listed(names),
                      option::columns),
          true};
}

Note midnights_passed(std::string_view time) {
  return {fmt::format("the times in column \"{}\" pass midnight, and count on from 24:00:00", time), true};
}

Note angles_jump(std::string_view angles, bool may_be_euler) {
  const std::string euler =
      may_be_euler ? fmt::format(", or {} euler=yaw:pitch:roll,order=ZYX as a rotation", option::rotation) : "";
  return {fmt::format("angles seem to jump by more than half a turn; {} {} turns them the shorter way{}", option::angle,
                      angles, euler),
          true};
}

Note names_of_quaternion() {
  return {
      fmt::format("columns x, y, z and w after x, y and z are taken as the quaternion qx, qy, qz, qw; {} none takes "
                  "them as positions",
                  option::rotation),
      true};
}

Note keys_at(std::string_view path) {
  return {fmt::format("the keys are the list {}; {} takes another one", in_quotes(path), option::records), true};
}

Note index_is_time() { return {"the index of the table is taken as the time", true}; }

Note no_time_column() { return {"there is no time column; the times of the keys are 0, 1, 2, ..."}; }

Note channels_in_extras(const std::vector<std::string>& names) {
  return {
      fmt::format("in the extras of the animation, as they are no translation, rotation or scale: {}", listed(names)),
      true};
}

Note other_objects_left_out(const std::vector<std::string>& names) {
  return {fmt::format("left out, as they do not move the first object: {}; {} reads them, as in {} '*/position'",
                      listed(names), option::only, option::only),
          true};
}

Note other_tracks_left_out(const std::vector<std::string>& names) {
  return {fmt::format("left out, as they have other channels: {}; {} reads them", listed(names), option::only), true};
}

Note constant_tracks_left_out(const std::vector<std::string>& names) {
  return {fmt::format("left out, as they have a single key: {}; {} reads them", listed(names), option::only), true};
}

Note ignored_columns(const std::vector<std::string>& names) {
  return {fmt::format("ignored: {}; {} gives them roles, as in carry=NAME or position=NAME:NAME", listed(names),
                      option::columns),
          true};
}

Note unchosen_columns(const std::vector<std::string>& names) {
  return {fmt::format("ignored, as {} chooses others: {}", option::columns, listed(names))};
}

Note rate_of_broadcast(std::string_view decimal, std::string_view rate, std::string_view exact) {
  return {fmt::format("the frame rate {} is taken as {}; give {} for exactly {}", decimal, rate, exact, decimal), true};
}

Note times_since_1970(std::string_view time, std::string_view unit) {
  return {fmt::format(
              "the times in column \"{0}\" may be {1} since 1970; {2} {1} says so, and rates and durations are then "
              "in seconds",
              time, unit, option::time_unit),
          true};
}

Note times_as_seconds(std::string_view time) {
  return {
      fmt::format("the unit of the times in column \"{}\" is unknown; they are taken as seconds; {} gives another one",
                  time, option::time_unit),
      true};
}

Note dates_in_utc(std::string_view time) {
  return {fmt::format("the dates in column \"{}\" have no zone; they are taken as UTC", time), true};
}

Note rate_of_frames(std::string_view time) {
  return {fmt::format("the times in column \"{}\" count frames, so {} is per frame; {} HZ converts them to seconds",
                      time, option::rate, option::input_fps),
          true};
}

Note remainder_note(double distance, bool at_key) {
  return {fmt::format("{0} is {1} after the last row; {2} keep or {2} fit includes it",
                      at_key ? "the last key" : "the end of the range", distance, option::end),
          true};
}

Note more_remainders(std::uint64_t curves) {
  return {fmt::format("a remainder is also left in {} more curves", curves), true};
}

Note rows_within(std::uint64_t rows, std::uint64_t least) {
  return {fmt::format("{} rows; any polyline within the tolerance has at least {}", rows, least), true};
}

Note gaps_divide(std::uint64_t gaps, double largest) {
  return {fmt::format("{} between keys {} a new curve; the largest is {}",
                      gaps == 1 ? "1 gap" : fmt::format("{} gaps", gaps), gaps == 1 ? "begins" : "begin", largest),
          true};
}

Note step_is(std::string_view step) { return {fmt::format("the step is {}", step)}; }

Note skipped_rows(std::uint64_t rows) { return {fmt::format("rows skipped for missing numbers: {}", rows)}; }

Note changed_after_reading(bool is_certain) {
  return {fmt::format("the file {} after it was read; its output has the earlier keys, and {} makes it again",
                      is_certain ? "changed" : "may have changed", option::update)};
}

Note other_program(std::string_view earlier, std::string_view current) {
  return {fmt::format("{} made this file; last digits may differ in {}", earlier, current)};
}

}  // namespace tcb
