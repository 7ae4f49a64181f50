// Numbers as text: a header on its way out; include the two below.
#pragma once

#include "text/parse_number.hpp"
#include "text/print_number.hpp"
