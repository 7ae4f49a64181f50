// Kept curves: the keys of an input, to be gone through more than once.
#include "compare/kept.hpp"

#include <utility>

#include "input/reader.hpp"
#include "io/file.hpp"

namespace tcb {

Source<KeyBlock> KeptCurve::keys() const {
  return [this, next = std::size_t{0}]() mutable {
    return next < blocks.size() ? std::optional(blocks[next++]) : std::nullopt;
  };
}

KeptCurves keep(const Job& plan) {
  const std::string& path = plan.files[0];
  InputOptions options = plan.input;
  options.threads = plan.threads();
  KeptCurves kept{open_input(path, read_file(path), options), {}};
  Curves curves(kept.input, plan.curves, false);
  while (const std::optional<CurveKeys> curve = curves.next()) {
    KeptCurve& one = kept.curves.emplace_back(KeptCurve{curve->group, curve->curve_info, {}});
    while (std::optional<KeyBlock> block = curve->keys()) one.blocks.push_back(std::move(*block));
  }
  return kept;
}

}  // namespace tcb
