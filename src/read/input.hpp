// Input: an opened input, which is the meaning of its records, facts about it, and its keys.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "schema/columns.hpp"
#include "schema/curve_channels.hpp"
#include "schema/format.hpp"
#include "schema/key_block.hpp"
#include "schema/schema.hpp"
#include "schema/units.hpp"

namespace tcb {

/// The shapes of JSON inputs.
enum class JsonShape { list, object, curves, lines, table, table_by_index, any };

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
  bool is_recording = false;                      ///< keys are samples; their columns shape no curve
  std::vector<std::string> constant_tracks = {};  ///< names of tracks that are left out as they never change
  std::vector<std::string> other_objects = {};    ///< names of those left out for the first that moves
  std::vector<std::string> other_tracks = {};     ///< names of those left out as they have other channels
  std::map<std::vector<std::string>, EulerTrack> euler_tracks = {};  ///< by the groups of their curves, as texts
  std::vector<std::string> ignored = {};                             ///< names of columns without a role
  std::optional<double> time_gap = {};                               ///< as in Columns
  std::vector<std::string> doubts = {};                              ///< notes: what its columns may mean besides
};

/// The records of an input as the reader of its format finds them.
struct Records {
  Columns columns;
  KeyUnits units = {};
  std::optional<TimeUnit> time_unit = {};      ///< of times, by a row of units
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

}  // namespace tcb
