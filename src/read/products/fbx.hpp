// FBX: the animation of a scene in an ASCII file of FBX (versions 6 and 7) as keys.
//
// An animation curve node of version 7, or a channel of a model of version 6, is a track of the object that it drives:
// position, rotation (x, y, z in degrees), scale, or another property. Its animation curves are the channels; a channel
// without keys has the constant that the node gives it. Where several takes or layers drive a property, each is a track
// with their names. Layers are not blended. Times are converted to seconds. The preset is fbx.
// Source: the documentation of the FBX SDK, and files of MotionBuilder, Maya and 3ds Max.
#pragma once

#include <string>

#include "read/input.hpp"
#include "read/input_options.hpp"
#include "stream/source.hpp"

namespace tcb {

/// Opens a scene, whose text is kept while it is read. Throws: Error (data).
Records open_fbx(const Source<std::string>& bytes, const InputOptions& options);

}  // namespace tcb
