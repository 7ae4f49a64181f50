// Text positions: a header on its way out; include utf8.hpp.
#pragma once

#include "text/utf8.hpp"

namespace tcb {

inline LinePosition place_after(std::string_view text, LinePosition place) { return position_after(text, place); }

}  // namespace tcb
