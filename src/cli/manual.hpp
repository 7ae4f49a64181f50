// Manual: the pages tcbsample(1) and tcbsample-curves(7), made from their texts and the tables of options, presets and
// rules.
#pragma once

#include <string>

namespace tcb {

/// The texts of the pages, man/tcbsample.1.in and man/tcbsample-curves.7.in, put into the program by the build.
extern const char* const manual_template;
extern const char* const curves_template;

/// The pages in the man macros, without the last line end.
std::string manual_page();
std::string curves_page();

}  // namespace tcb
