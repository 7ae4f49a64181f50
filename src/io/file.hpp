// Files: a header on its way out; include the two below.
#pragma once

#include "io/atomic_output.hpp"
#include "io/input_file.hpp"
