// Settings in JSON: the members around keys, which are settings of the curve, names of channels, and an id.
#pragma once

#include <string>
#include <vector>

#include "read/json/text.hpp"
#include "schema/curve_settings.hpp"

namespace tcb {

/// The members of an object around keys.
struct JsonCurveInfo {
  CurveInfo curve_info = {};
  std::vector<std::string> channels = {};  ///< names of the numbers of "position"
  std::vector<std::string> unused = {};    ///< members with numbers that are no settings
  std::string shown_rate = {};             ///< the number of the first of them that is a frame rate; empty: none
};

/// Whether the value of a member is a frame rate by its name, and a number.
bool is_frame_rate(const Json& json, std::size_t value);

/// The settings in an object around keys. `path`: of the object, empty for the outermost one. Throws: Error (data) at a
/// member that is wrong, or whose name is a near miss.
JsonCurveInfo read_curve_info(const Json& json, std::size_t object, const std::string& path);

}  // namespace tcb
