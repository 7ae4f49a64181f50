// LightWave: the motions of scenes (.lws) and of motion files (.mot) as keys.
//
// A motion has the tracks position (x, y, z), rotation (x, y, z: heading, pitch, bank; in radians, before version 3 in
// degrees) and scale. A span is the segment that ends at a key:
//   TCB     tangents by the preset lightwave
//   Hermite, Bezier 1D   the tangents of the key, per segment
//   linear  the chord
//   stepped the value of the key before, up to the last time before the key
// Where all keys of a channel are TCB, the rules of the preset apply; otherwise the file decides all its velocities.
// Bezier 2D is no cubic in time, and is refused.
// Source: the documentation of the scene format and the samples of the LightWave SDK; files of LightWave, for the
//   tangents at the ends and the numbers of Hermite spans.
#pragma once

#include <string>

#include "read/input.hpp"
#include "read/input_options.hpp"
#include "stream/source.hpp"

namespace tcb {

/// Opens a scene, whose text is kept while it is read. Throws: Error (data).
Records open_lightwave(const Source<std::string>& bytes, const InputOptions& options);

}  // namespace tcb
