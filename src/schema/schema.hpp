// Schema: what a record means: its time, its channels, the rotations and angles among these, its groups and labels.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "numbers/rational.hpp"
#include "numbers/time_notation.hpp"
#include "schema/curve_channels.hpp"
#include "schema/rotation_options.hpp"
#include "tcb/spline/key.hpp"

namespace tcb {

struct Columns;
struct Renaming;

/// The marks of delimited text.
struct TextMarks {
  char delimiter = ',';  ///< between cells; ' ' is any run of blanks and tabs
  char decimal = '.';    ///< in numbers
};

/// The times of records.
struct TimeSchema {
  bool is_given = false;     ///< records have a time; otherwise the positions of keys make them
  bool is_by_place = false;  ///< the first column is the time, as none has a name
  std::string name = "t";
  TimeNotation notation = TimeNotation::seconds;  ///< as the input has it
  DateFormat dates = {};                          ///< where the times are dates
  std::optional<TimeUnit> unit = {};              ///< nothing: unknown
  std::optional<TimeUnit> epoch_unit = {};        ///< in which they seem to count from 1970, if the unit is unknown
  std::optional<Rational> frame_rate = {};        ///< the times were frames, and are seconds
  bool counts_rows = false;                       ///< row i of a group is at start + i / frame_rate
  Rational start = 0;                             ///< of the rows that are counted
  std::string likely = {};                        ///< the first channel as it can be requested, if it may be the time
};

/// A rotation of records.
struct RotationSchema {
  RotationColumns columns = {};         ///< which channels make it, and how rows show it
  GivenRotation given = {};             ///< how keys give it
  std::vector<std::string> names = {};  ///< of its cells in rows, where these are not channels
};

/// What a record means: a key as it is read, or a sample as it is written.
struct Schema {
  bool named = false;                   ///< the columns have names
  std::optional<TextMarks> marks = {};  ///< of an input of delimited text
  TimeSchema time = {};
  std::vector<std::string> channels = {};  ///< names of the position channels
  std::vector<std::size_t> sources = {};   ///< index of the channel of keys as they are read, for each channel
  std::vector<RotationSchema> rotations = {};
  std::vector<AngleColumn> angles = {};  ///< which channels are angles
  std::vector<std::string> groups = {};  ///< names of the group columns
  std::vector<std::string> labels = {};  ///< names of the columns of labels
  std::string camera_path = {};          ///< the members of a camera path besides its cameras, as JSON; empty: none
};

/// The names of the channels that are not numbers of a rotation.
std::vector<std::string> moving_channels(const Schema& schema);

std::vector<RotationColumns> rotation_columns(const Schema& schema);

/// Which channels are neither numbers of a rotation nor angles.
std::vector<bool> plain_channels(const Schema& schema);

/// The meaning of records with these columns, whose times have this notation and, if they are dates, this format; all
/// channels are plain.
Schema schema_of(const Columns& columns, TimeNotation notation, const DateFormat& dates = {});

/// The meaning of records with rotations and angles among the channels of their columns: as requested, or else by their
/// names: "q" and x, y, z and w, or w, x, y and z between the same texts of which the first has a "q". Columns are
/// requested by name, or by number from 1. In place of the first column of a rotation in another form than a quaternion
/// there are four channels. Requires: schema_of() made the schema from these columns.
/// Throws: Error (data) for a column that is missing, or that is in two rotations, and for names that are taken.
Schema with_rotations(Schema schema, const Columns& columns, const RotationOptions& options);

/// A schema with the times and groups of another one, and with these names of plain channels; it has no labels.
Schema with_channels(const Schema& schema, std::vector<std::string> channels);

/// The schema with other names of columns. Throws: Error (data) for a name that no column has, and where two columns
/// would have the same name.
Schema renamed(Schema schema, const std::vector<Renaming>& renamings);

/// Throws: Error (data) about an option by which two columns have the same name.
void require_distinct_names(Schema schema, std::string_view option);

}  // namespace tcb
