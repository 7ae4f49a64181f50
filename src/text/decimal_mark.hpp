// The decimal mark: a header on its way out; include the one below.
#pragma once

#include "text/parse_number.hpp"
