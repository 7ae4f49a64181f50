// Notes: facts about an input or its curves that a user may not expect, as texts; one function for each.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace tcb {

struct Note {
  std::string text;
  bool is_important = false;  ///< printed unless it is quiet; other notes only on a terminal
};

Note reads_terminal();
/// The text was converted to UTF-8.
Note text_converted(std::string_view encoding);
/// Only names and texts of columns were.
Note names_converted(std::string_view named, std::string_view encoding);
/// Columns are positions as they have no other role.
Note positions_by_elimination(const std::vector<std::string>& names);
/// The times of day or the timecode of keys pass midnight.
Note midnights_passed(std::string_view time);
/// `angles` is a value of --angle for the columns that do. `may_be_euler`: they are called roll, pitch and yaw.
Note angles_jump(std::string_view angles, bool may_be_euler);
/// Columns x, y, z, x, y, z, w are a pose.
Note names_of_quaternion();
/// The index of a table in JSON is not a count of its rows, and no column is the time.
Note index_is_time();
/// The only list in JSON that can be keys.
Note keys_at(std::string_view path);
Note no_time_column();
Note channels_in_extras(const std::vector<std::string>& names);
Note other_objects_left_out(const std::vector<std::string>& names);
Note other_tracks_left_out(const std::vector<std::string>& names);
Note constant_tracks_left_out(const std::vector<std::string>& names);
Note ignored_columns(const std::vector<std::string>& names);
/// Columns that are ignored as the positions were chosen.
Note unchosen_columns(const std::vector<std::string>& names);
/// A frame rate was given as a decimal such as 29.97, which stands for `rate`.
Note rate_of_broadcast(std::string_view decimal, std::string_view rate, std::string_view exact);
/// The unit of the times is unknown, and they seem to count from 1970.
Note times_since_1970(std::string_view time, std::string_view unit);
/// The unit of the times is unknown, and a duration such as 30min takes them as seconds.
Note times_as_seconds(std::string_view time);
/// The times in this column are dates without a zone.
Note dates_in_utc(std::string_view time);
/// A rate is given, and the times in the column `time` count frames.
Note rate_of_frames(std::string_view time);
/// The range ends between rows; `at_key`: at the last key.
Note remainder_note(double distance, bool at_key);
Note more_remainders(std::uint64_t curves);
Note rows_within(std::uint64_t rows, std::uint64_t least);
/// Gaps divide the curves.
Note gaps_divide(std::uint64_t gaps, double largest);
Note step_is(std::string_view step);
Note skipped_rows(std::uint64_t rows);
/// An input changed after its last byte was read, or only its links, name or mode did.
Note changed_after_reading(bool is_certain);
/// An earlier output is made again by another version.
Note other_program(std::string_view earlier, std::string_view current);

}  // namespace tcb
