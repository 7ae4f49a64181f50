// JSON input: members of keys, keys, settings of curves, provenance, and the shapes that an input may have.
//
// A key is {"time":0,"position":[1,2],"tension":0,…} or flat, {"time":0,"x":1,"y":2}; its members have the roles of
// columns of the same names, and "tcb":[t,c,b] is accepted. It is parsed by nlohmann-json through its events, so that
// no document is ever held.
// Source: RFC 8259.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "input/input.hpp"
#include "input/json/splitter.hpp"
#include "stream/source.hpp"

namespace tcb {

/// The meaning of the members of key objects, as the first one has them. Each is a cell, or an array of cells.
struct JsonColumns {
  struct Member {
    std::string name;
    bool array = false;
    std::size_t cell = 0;   ///< its first cell in `columns`
    std::size_t cells = 0;  ///< the number of its cells; 0: it is ignored
    bool required = false;
  };
  Columns columns;
  std::vector<Member> members;
  std::size_t found = 0;  ///< the number of cells of the first key; others may come in any key
  KeyRules rules;
};

/// The meaning of the members of the first key of a chunk. `channels` are names for the numbers of "position", if any.
/// Throws: Error (data).
JsonColumns find_members(const Chunk& chunk, const InputOptions& options, const std::vector<std::string>& channels);

/// Gives the numbers of "position" these names. Throws: Error (data) where there are not as many.
void name_channels(JsonColumns& columns, const std::vector<std::string>& channels);

/// The keys of a chunk of whole key objects, an array of them or one a line. A pure function.
/// Errors are among its faults, at the position of the value; ten at most.
KeyBlock parse_json(const Chunk& chunk, const JsonColumns& columns);

/// The members of an object around keys.
struct JsonCurveInfo {
  CurveInfo curve_info;
  std::vector<std::string> channels;  ///< names of the numbers of "position"
  std::string path;                   ///< of the object, empty for the outermost one
  TextPosition position;              ///< where it begins
};

/// Throws: Error (data) at a member that is wrong, or whose name is a near miss.
JsonCurveInfo read_curve_info(const JsonPart& part);

/// The names of channels in an object whose text ends before its keys, if it has any.
std::vector<std::string> channels_before_keys(const JsonPart& part);

/// The provenance of an output in JSON.
struct JsonProvenance {
  std::string program;
  std::vector<std::string> options;
  std::vector<std::pair<std::string, std::string>> inputs;  ///< names and SHA-256
};

/// The member "meta" of JSON text, or of the last line of JSON Lines; empty where there is none.
JsonProvenance read_json_provenance(std::string_view text);

/// Opens JSON of any shape: an array of keys, an object with "keys", one with "curves", or JSON Lines. Keys of an
/// object are held until its settings are known. Requires: the bytes have no byte order mark. Throws: Error (data).
Input open_json(Source<std::string> bytes, const InputOptions& options);

}  // namespace tcb
