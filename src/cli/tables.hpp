// Tables: the options and the presets as JSON, from which the Python module is made.
#pragma once

#include <string>

namespace tcb {

/// An object with the version, the options in the order of the help, and the presets, without the last line end.
std::string tables_text();

}  // namespace tcb
