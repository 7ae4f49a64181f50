// Camera paths: the keyframes of nerfstudio as keys.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "read/input.hpp"
#include "read/input_options.hpp"
#include "stream/source.hpp"

namespace tcb {

/// Whether the beginning of a text is that of a camera path: the first list in an object is "keyframes", and the first
/// one of these has a matrix. Nothing: that depends on the text that follows.
std::optional<bool> begins_camera_path(std::string_view beginning);

/// The options with the rotation of camera paths and their unit of times, unless others are requested.
InputOptions options_of_camera_path(InputOptions options);

/// Opens a camera path: keys with x, y, z, the matrix r11 to r33, fov in degrees, and render_time where the keyframes
/// have it; the first one is at 0 seconds. The curve has the preset nerfstudio, is closed if the path is a cycle, and
/// its tension is smoothness_value.
/// Source: the viewer of nerfstudio, which writes and reads such files. Throws: Error (data).
Records open_camera_path(Source<std::string> bytes, const InputOptions& options);

}  // namespace tcb
