// 3D Studio: the keyframe tracks of .3ds files as keys.
//
// Each node has the tracks position, rotation, scale, field of view, roll, color, hotspot and falloff; a target has the
// track target. Times are frames. Rotations are relative to the key before, by an axis in the parent's frame and
// a left-handed angle, whose sign is changed here. Positions, rotations and scales are relative to
// the parent of the node. A track that loops is closed if its last key repeats the first one. The preset is lib3ds1.
// Source: the behaviour of lib3ds, which reads and writes such files.
#pragma once

#include <string>

#include "read/input.hpp"
#include "read/input_options.hpp"
#include "stream/source.hpp"

namespace tcb {

/// Opens a file, which is kept while it is read. Throws: Error (data).
Records open_3ds(const Source<std::string>& bytes, const InputOptions& options);

}  // namespace tcb
