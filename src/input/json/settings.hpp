// What stands beside keys in JSON: settings of the curve, names of its channels, its id.
#pragma once

#include <string>
#include <vector>

#include "input/input.hpp"
#include "input/json/splitter.hpp"

namespace tcb {

/// What an object around keys says.
struct JsonCurveInfo {
  CurveInfo keys;
  std::vector<std::string> channels;  ///< names of the numbers of "position"
  std::string path;                   ///< of the object, empty for the outermost one
  TextPosition place;                 ///< where it begins
};

/// Throws: Error (data), placed at what is wrong, or where a name is nearly a known one.
JsonCurveInfo read_beside(const JsonPart& part);

/// The names of channels in an object whose text breaks off before its keys, if it has any.
std::vector<std::string> channels_before_keys(const JsonPart& part);

}  // namespace tcb
