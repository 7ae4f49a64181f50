// Streams: a header on its way out; include the two below.
#pragma once

#include "stream/ordered_map.hpp"
#include "stream/source.hpp"
