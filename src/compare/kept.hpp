// Kept curves: the keys of an input, to be gone through more than once.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/job.hpp"
#include "input/input.hpp"

namespace tcb {

struct KeptCurve {
  std::vector<std::string> group;
  std::shared_ptr<const CurveInfo> curve_info;
  std::vector<KeyBlock> blocks;

  Source<KeyBlock> keys() const;
};

struct KeptCurves {
  Input input;
  std::vector<KeptCurve> curves;
};

/// The curves of the one input of a plan. Throws: Error.
KeptCurves keep(const Job& plan);

}  // namespace tcb
