// Kept curves: the keys of an input, to be gone through more than once.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "format/input.hpp"
#include "task.hpp"

namespace tcb::compare {

struct KeptCurve {
  std::vector<std::string> group;
  std::shared_ptr<const format::BesideKeys> beside_keys;
  std::vector<format::KeyBlock> blocks;

  Source<format::KeyBlock> keys() const;
};

struct KeptCurves {
  format::Input input;
  std::vector<KeptCurve> curves;
};

/// The curves of the one input of a plan. Throws: Error.
KeptCurves keep(const Plan& plan);

}  // namespace tcb::compare
