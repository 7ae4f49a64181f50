// Keys without faults: the faults of an input, gathered from its blocks into one error.
#include "keys/without_faults.hpp"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include "error.hpp"

namespace tcb {
namespace {

/// Takes the faults of a block, in the order of their positions.
void gather(std::vector<Error>& faults, KeyBlock& block) {
  std::ranges::stable_sort(block.faults.errors, {}, [](const Error& fault) {
    return std::pair(fault.position().line, fault.position().column);
  });
  std::ranges::move(block.faults.errors, std::back_inserter(faults));
}

/// Throws: Error (data) with all of them, at most ten. Requires: there is at least one.
[[noreturn]] void refuse(std::vector<Error> faults) {
  if (faults.size() > most_faults) faults.erase(faults.begin() + most_faults, faults.end());
  Error first = faults[0];
  for (std::size_t i = 1; i < faults.size(); ++i) first.add(std::move(faults[i]));
  throw first;
}

}  // namespace

Source<KeyBlock> without_faults(Source<KeyBlock> blocks, bool live) {
  return [blocks = std::move(blocks), live]() -> std::optional<KeyBlock> {
    std::optional<KeyBlock> block = blocks();
    if (!block || block->faults.errors.empty()) return block;
    std::vector<Error> faults;
    for (bool more = true; more;) {
      gather(faults, *block);
      more = faults.size() < most_faults && !block->faults.unreadable && !live;
      try {
        if (more) block = blocks();
      } catch (const Error& error) {
        faults.push_back(error);
        more = false;
      }
      more = more && block;
    }
    refuse(std::move(faults));
  };
}

}  // namespace tcb
