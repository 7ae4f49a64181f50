// The prose of the manual page, man/tcbsample.1.in, put into the program by the build.
#pragma once

namespace tcb {

extern const char* const manual_template;

}  // namespace tcb
