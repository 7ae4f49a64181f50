// Input: options of its reading, chunks of its text, and an input opened with its columns, its facts and its keys.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "error.hpp"
#include "numbers/rational.hpp"
#include "numbers/time_notation.hpp"
#include "schema/columns.hpp"
#include "schema/formats.hpp"
#include "schema/key_block.hpp"
#include "schema/missing.hpp"
#include "schema/rotation_columns.hpp"
#include "stream/source.hpp"
#include "tcb/spline/key.hpp"
#include "text/utf8.hpp"

namespace tcb {

/// Scales of tension, continuity and bias: as they are, or from 0 to 50 as 3ds Max shows them.
enum class TcbScale {
  unknown,  ///< as they are, and checked if the preset's product shows another scale
  none,     ///< as they are
  max3ds,   ///< from 0 to 50, with 25 for 0
};

/// The names of the scales that can be given.
struct TcbScaleName {
  std::string_view name;
  TcbScale scale;
};
inline constexpr std::array tcb_scales{TcbScaleName{"3dsmax", TcbScale::max3ds}, TcbScaleName{"none", TcbScale::none}};

/// (v - 25) / 25, exactly.
inline Rational from_0_to_50(const Rational& v) { return (v - 25) / 25; }

/// How cells become keys.
struct KeyRules {
  spline::Tcb<double> tcb = {};  ///< of keys that have none
  Missing missing = Missing::error;
  bool keeps_decimals = false;                    ///< keys keep their numbers as written
  std::vector<std::string> signs = {};            ///< of missing cells, besides the common ones
  TcbScale tcb_scale = TcbScale::none;            ///< of keys
  TimeNotation notation = TimeNotation::seconds;  ///< of the times
  std::optional<Rational> frame_rate = {};        ///< of timecode
  std::vector<Rational> factors = {};             ///< of the numbers of a key, in the order of NumberOfKey; none: all 1
};

/// The factor of a channel's positions.
struct ChannelScale {
  std::string channel;
  Rational factor;
};

/// The names of the forms of rotations.
struct RotationFormName {
  std::string_view name;
  spline::RotationForm form;
};
inline constexpr std::array rotation_forms{RotationFormName{"quaternion", spline::RotationForm::quaternion},
                                           RotationFormName{"axis-angle", spline::RotationForm::axis_angle},
                                           RotationFormName{"euler", spline::RotationForm::euler},
                                           RotationFormName{"matrix", spline::RotationForm::matrix}};

/// The units of angles.
struct AngleUnit {
  std::string_view name;
  bool degrees;
};
inline constexpr std::array angle_units{AngleUnit{"radians", false}, AngleUnit{"degrees", true}};

/// How keys give a rotation.
struct GivenRotation {
  spline::RotationNotation notation = {};
  bool relative = false;                   ///< to the rotation of the key before
  std::vector<std::string> columns = {};   ///< names of those of its numbers
  std::vector<std::size_t> channels = {};  ///< those of its numbers, in keys as they are read
};

/// A channel that is an angle.
struct NamedAngle {
  std::string channel;
  bool degrees = false;
};

/// Which columns are rotations, and how rows show them.
struct RotationOptions {
  bool none = false;       ///< their numbers are plain channels
  bool normalize = false;  ///< quaternions may have any norm
  bool degrees = false;    ///< their angles are in degrees, else in radians
  std::vector<GivenRotation> requests = {};
  std::vector<NamedAngle> angles = {};
  std::optional<spline::RotationNotation> shown = {};  ///< nothing: as they are given
  bool as_curves = false;                              ///< all as quaternions, whose curves are drawn
};

/// Options of the reading of an input.
struct InputOptions {
  std::optional<FormatId> format;  ///< nothing: by ending or content
  std::optional<char> delimiter;   ///< ' ' is any run of blanks and tabs
  std::optional<bool> header;
  std::string comment = "#";  ///< the prefix of lines to skip; empty: none
  std::vector<RoleRequest> roles;
  spline::Tcb<double> tcb;  ///< of keys that have none
  bool timeless = false;    ///< no column is the time, unless by its name
  unsigned threads = 1;     ///< at most
  char decimal = '.';       ///< decimal mark of delimited text
  Missing missing = Missing::error;
  std::optional<SampleNames> samples;  ///< the records are samples of a curve, not keys
  bool keeps_decimals = false;         ///< keys keep their numbers also as text

  std::vector<std::string> signs;  ///< of missing cells, besides the common ones

  TcbScale tcb_scale = TcbScale::unknown;
  std::optional<TimeUnit> time_unit;   ///< of the times; nothing: that of the column's name, if it has one
  std::optional<Rational> input_rate;  ///< the times are frames, so many of them a second
  std::vector<ChannelScale> scales;
  RotationOptions rotation = {};
  std::vector<Renaming> renamings;  ///< of columns in the output

  KeyRules key_rules() const { return {tcb, missing, keeps_decimals, signs, tcb_scale}; }
};

/// Whole records of an input, as text.
struct Chunk {
  std::string text;
  std::uint64_t line = 1;    ///< of the first character, from 1
  std::uint64_t column = 1;  ///< of the first character, from 1
  std::uint64_t first = 0;   ///< number of the first record, in formats that count them
  std::string path = {};     ///< of the list that holds the records, in formats that have one
};

/// A source of text, which ends with an error at a NUL.
class TextBytes {
 public:
  explicit TextBytes(Source<std::string> bytes) : bytes_(std::move(bytes)) {}

  /// Appends the next bytes to a text that begins at `position`; false at the end of the input.
  /// Throws: Error (data) at a NUL, once the text before it was read.
  bool append_to(std::string& text, LinePosition position);

 private:
  Source<std::string> bytes_;
  bool at_nul_ = false;  ///< the next byte is a NUL
};

/// The shapes of JSON inputs.
enum class JsonShape { list, object, curves, lines };

/// What was found at the beginning of an input, besides its columns.
struct InputFacts {
  FormatId format = FormatId::csv;
  JsonShape shape = JsonShape::list;  ///< of JSON
  char delimiter = ',';               ///< of delimited text; ' ' is any run of blanks and tabs
  std::string comment;                ///< the prefix of its comment lines; empty: it has none
  char decimal = '.';                 ///< its decimal mark
  std::vector<std::string> roles;     ///< the names of those that shape a curve, such as tension, and have a column
};

/// An opened input: the meaning of its numbers, and its keys in blocks.
struct Input {
  bool named = false;                                         ///< it names its columns
  bool timed = false;                                         ///< it has a time column
  std::string time;                                           ///< name of the time column
  std::vector<std::string> channels;                          ///< names of the position channels
  std::vector<std::string> read_channels = {};                ///< the same of keys as they are read
  std::vector<std::size_t> read_columns = {};                 ///< the number of the column of each of these, from 1
  std::size_t column_count = 0;                               ///< of a record
  std::optional<spline::RotationForm> likely_rotation = {};   ///< that columns without names and roles may be
  std::vector<std::size_t> channel_sources = {};              ///< of each channel, the one of keys as they are read
  std::vector<RotationColumns> rotations = {};        ///< which of them make rotations
  std::vector<GivenRotation> given_rotations = {};            ///< how keys give each
  std::vector<std::vector<std::string>> rotation_names = {};  ///< of the cells of each, where they are not channels
  std::vector<AngleColumn> angles = {};              ///< which of them are angles
  bool normalize = false;                                     ///< quaternions may have any norm
  CurveInfo curve_info;                                       ///< of all curves, unless they have their own
  Source<KeyBlock> keys;
  InputFacts facts = {};
  std::vector<std::string> ignored = {};               ///< names of the columns without a role
  std::vector<Mark> marks = {};                        ///< the first of them
  std::vector<std::string> groups = {};                ///< names of the group columns
  std::vector<std::string> carried = {};               ///< names of the columns of labels
  unsigned threads = 1;                                ///< at most
  bool may_break = false;                              ///< a curve may end before the input does
  bool may_miss = false;                               ///< positions may be missing
  bool has_tcb_scale = false;                          ///< that of tension, continuity and bias is given
  bool may_be_timed = false;                           ///< its first channel may be the time
  std::optional<Rational> frame_rate = {};             ///< the times were frames, and are seconds
  TimeNotation time_notation = TimeNotation::seconds;  ///< as it was given
  std::optional<TimeUnit> time_unit = {};              ///< of the times, if it is known
  bool has_segments = false;                           ///< the keys are the two ends of each segment, not yet joined
  bool own_curves = false;                             ///< blocks have the beginnings of curves, and their information

  /// Takes over the columns of the input.
  void set_columns(const Columns& columns);
};

/// Sets the notation of the times, by the first of them, and the factors of the numbers. Throws: Error (data) for
/// timecode without a rate, units of time that contradict each other, and a channel that no column is.
void set_units(KeyRules& rules, const InputOptions& options, const Columns& columns, std::string_view first_time);

/// Sets the notation and the unit of the times, and renames columns. Throws: Error (data) where there is no such
/// column.
void set_units_and_names(Input& input, const InputOptions& options);

/// Sets which channels are angles, and which make rotations, as requested or else by their names: "q" and x, y, z and
/// w, or w, x, y and z between the same texts of which the first has a "q". Columns are requested by name, or by number
/// from 1. In place of the first column of a rotation in another form than a quaternion there are four channels.
/// Throws: Error (data) for a column that is missing, or that is in two rotations, and for names that are taken.
void set_rotations(Input& input, const RotationOptions& options);

/// The largest number of faults of an input that are reported.
inline constexpr std::size_t most_faults = 10;

/// Opens an input: the format is the given one, else by the file's ending, else by the first byte that is not blank.
/// Throws: Error (data), without a file name.
Input open_input(const std::string& path, Source<std::string> bytes, const InputOptions& options);

/// Keys without faults. After a fault, the rest of the input is read for more, up to ten; a live input, which may not
/// end soon, is read no further. Throws: Error (data) with all faults that were found.
Source<KeyBlock> without_faults(Source<KeyBlock> blocks, bool live);

/// Throws: Error (data) with all of them, at most ten. Requires: there is at least one.
[[noreturn]] void refuse(std::vector<Error> faults);

}  // namespace tcb
