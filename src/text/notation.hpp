// Notations: a header on its way out; include the one below.
#pragma once

#include "text/print_number.hpp"
