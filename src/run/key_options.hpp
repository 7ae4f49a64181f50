// Key options: how keys are read, and which curves they make.
#pragma once

#include <memory>
#include <string>

#include "io/input_file.hpp"
#include "read/input_options.hpp"
#include "schema/curve_settings.hpp"
#include "stream/source.hpp"

namespace tcb {

struct KeyOptions {
  InputOptions input;
  CurveOptions curves;
  CurveSettings rules;                                     ///< completed by the settings in the input
  std::shared_ptr<const std::string> standard_input = {};  ///< its bytes, if they were read before

  /// The bytes of a file. Throws: Error (usage) as open_file() does.
  InputBytes bytes_of(const std::string& path) const;
};

}  // namespace tcb
