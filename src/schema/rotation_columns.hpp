// Rotation columns: which columns make rotations and angles, their channels, and the cells that show them.
#pragma once

#include <optional>
#include <span>

#include "schema/columns.hpp"
#include "schema/rotation_options.hpp"
#include "schema/schema.hpp"

namespace tcb {

/// The meaning of records with rotations and angles among the channels of their columns: as requested, or else by their
/// names: "q" and x, y, z and w, or w, x, y and z between the same texts of which the first has a "q". Columns are
/// requested by name, or by number from 1. In place of the first column of a rotation in another form than a quaternion
/// there are four channels. Requires: schema_of() made the schema from these columns.
/// Throws: Error (data) for a column that is missing, or that is in two rotations, and for names that are taken.
Schema with_rotations(Schema schema, const Columns& columns, const RotationOptions& options);

}  // namespace tcb
