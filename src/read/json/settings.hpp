// Settings in JSON: the members around keys, which are settings of the curve, channel names and an id.
#pragma once

#include <string>
#include <vector>

#include "read/json/splitter.hpp"
#include "schema/curve_settings.hpp"

namespace tcb {

/// The members of an object around keys.
struct JsonCurveInfo {
  CurveInfo curve_info;
  std::vector<std::string> channels;  ///< names of the numbers of "position"
  std::vector<std::string> unused;    ///< members with numbers that are no settings
  std::string path;                   ///< of the object, empty for the outermost one
  TextPosition position;              ///< where it begins
};

/// Throws: Error (data) at a member that is wrong, or whose name is a near miss.
JsonCurveInfo read_curve_info(const JsonPart& part);

/// The names of channels in an object whose text ends with the opening bracket of its keys, if it has any.
std::vector<std::string> channels_before_keys(const Chunk& text);

}  // namespace tcb
