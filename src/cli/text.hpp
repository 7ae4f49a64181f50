// Text laid out for people: lines of a terminal, and the escapes of the manual page.
#pragma once

#include <string>
#include <string_view>

namespace tcb {

/// Text in lines of 80 columns at most, each indented, each ended.
std::string wrapped(std::string_view text, std::size_t indent);

/// Text for the manual page, where dashes, backslashes and leading points have a meaning.
std::string escaped(std::string_view text);

}  // namespace tcb
