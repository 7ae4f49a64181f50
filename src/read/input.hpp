// Input: an opened input, which is the meaning of its records, facts about it, and its keys; and the half of a format
// that reads it. Each half is defined in one file of a room of readers, and a row of formats/formats.cpp names it.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "read/input_options.hpp"
#include "schema/columns.hpp"
#include "schema/curve_channels.hpp"
#include "schema/format.hpp"
#include "schema/input_keys.hpp"
#include "schema/schema.hpp"
#include "schema/units.hpp"
#include "stream/source.hpp"

namespace tcb {

enum class JsonShape : std::uint8_t { list, object, curves, lines, table, table_by_index, any };

/// What was found at the beginning of an input.
struct InputFacts {
  const Format* format = nullptr;
  std::string encoding = {};                      ///< from which text was converted to UTF-8; empty: none
  bool names_quaternion = false;                  ///< as in DelimitedHead
  JsonShape shape = JsonShape::list;              ///< of JSON
  std::string records = {};                       ///< the path of the list of keys in JSON of any shape
  std::optional<spline::Tcb<double>> tcb = {};    ///< of all keys, as the file has it
  std::string comment = {};                       ///< the prefix of its comment lines; empty: it has none
  std::vector<std::string> roles = {};            ///< names of columns that shape a curve, such as tension
  std::vector<std::string> constant_tracks = {};  ///< names of tracks that are left out as they never change
  std::vector<std::string> other_tracks = {};     ///< names of those left out as they have other channels
  std::map<std::vector<std::string>, EulerTrack> euler_tracks = {};  ///< by the groups of their curves, as texts
  std::vector<std::string> ignored = {};                             ///< names of columns without a role
  std::optional<double> time_gap = {};                               ///< as in Columns
  std::string shown_rate = {};                                       ///< a frame rate that is not used; empty: none
  std::vector<std::string> doubts = {};                              ///< notes: what its columns may mean besides
};

/// The records of an input as the reader of its format finds them.
struct Records {
  Columns columns;
  KeyUnits units = {};
  std::optional<TimeUnit> time_unit = {};      ///< of times, by a row of units
  std::optional<Rational> frame_rate = {};     ///< of times that count frames, as the file has it
  std::optional<TextMarks> marks = {};         ///< of delimited text
  std::optional<GivenRotation> rotation = {};  ///< that columns are by the format
  std::string camera_path = {};                ///< as in Schema
  InputFacts facts = {};
  InputKeys keys = {};
};

/// An opened input.
struct Input {
  Schema schema;
  InputFacts facts = {};
  InputKeys keys = {};
};

struct InputFormat {
  /// Opens an input. Requires: the bytes have no byte order mark. Throws: Error (data).
  Records (*open)(const Format& format, Source<std::string> bytes, InputOptions options);

  /// The options with what the format decides, unless it is requested; null: nothing. The beginning of the bytes may be
  /// read.
  InputOptions (*options)(const Format& format, Source<std::string>& bytes, InputOptions given) = nullptr;

  /// Whether a file begins as those of this format alone, whatever its name is; null: no file does.
  bool (*begins)(std::string_view beginning) = nullptr;

  /// How well a text fits, where its name tells no format or several: 0 is not at all, and the best fit counts, the
  /// first of equal ones. Nothing: that depends on what follows. null: no text does.
  std::optional<int> (*fit)(std::string_view beginning) = nullptr;

  bool has_tracks = false;       ///< of several objects, of which --only chooses
  bool has_own_columns = false;  ///< the format names its columns
  bool has_frames = false;       ///< a file may have samples of its own, so that no sampling option is needed
};

}  // namespace tcb
