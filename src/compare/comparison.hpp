// Comparisons: what is asked for where someone's samples are compared with the curve instead of printing it.
#pragma once

#include <string>
#include <vector>

namespace tcb {

/// How far a number may be from the curve's, in one measure.
struct Tolerance {
  std::string column;  ///< empty: all columns without one of their own
  double most = 0;     ///< the largest distance that is admitted
};

struct Comparison {
  std::string file;                      ///< of someone's samples; "-" is standard input
  bool identify = false;                 ///< which rules made it, rather than whether these did
  std::vector<Tolerance> abs, rel, ulp;  ///< a number is admitted by any of the three
};

}  // namespace tcb
