// Keys of an input: in blocks as they are read, and what is known of them before the first one.
#pragma once

#include <string>

#include "schema/curve_settings.hpp"
#include "schema/key_block.hpp"
#include "stream/source.hpp"

namespace tcb {

/// What later stages have to expect of the keys of an input.
struct KeyTraits {
  bool own_curves = false;        ///< blocks have the beginnings of curves, and their information
  bool has_whole_curves = false;  ///< the keys of a curve follow each other, and its first block has its information
  bool may_break = false;         ///< a curve may end before the input does
  bool may_miss = false;          ///< positions may be missing
  bool may_be_point = false;      ///< a curve may be a single key between two breaks
  bool has_tcb_scale = false;     ///< the scale of tension, continuity and bias is given
  std::string label = {};         ///< as in Columns
};

/// The keys of an input as they are read.
struct InputKeys {
  Source<KeyBlock> blocks;
  CurveInfo curve_info = {};  ///< of all curves, unless they have their own
  KeyTraits traits = {};
};

}  // namespace tcb
