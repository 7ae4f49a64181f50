// Manual: the page tcbsample(1), made from its prose and the tables of options, presets and rules.
#pragma once

#include <string>

namespace tcb {

/// The prose of the page, man/tcbsample.1.in, put into the program by the build.
extern const char* const manual_template;

/// The page in the man macros, without the last line end.
std::string manual_page();

}  // namespace tcb
