// Angles among keys: their checks, and whether rows show negative ones.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "schema/curve_channels.hpp"
#include "schema/key_block.hpp"
#include "schema/rotation_options.hpp"
#include "schema/schema.hpp"
#include "stream/source.hpp"

namespace tcb {

/// Throws: Error (data) for an angle of more turns than its unit allows. `makes_turns`: they count.
void require_angle(double angle, bool degrees, bool makes_turns, const std::string& name, std::uint64_t line);

/// Passes keys on. `closed`: the first key follows the last one. Throws: Error (data), at its line, for an angle that
/// is missing or beyond what its unit allows, and for half a turn between two.
Source<KeyBlock> with_clear_angles(Source<KeyBlock> blocks, const std::vector<AngleColumn>& angles,
                                   const std::vector<std::string>& channels, bool closed = false);

/// Passes keys on, and after the last one checks the step from it to the first one.
template <class Chain>
Source<KeyBlock> with_checked_seam(Source<KeyBlock> blocks, std::shared_ptr<std::vector<Chain>> chains) {
  return [blocks = std::move(blocks), chains = std::move(chains)] {
    std::optional<KeyBlock> block = blocks();
    if (!block) {
      for (const Chain& chain : *chains) chain.close();
    }
    return block;
  };
}

/// Plain channels that seem to be angles: by their names, and as they jump by more than half a turn.
class LikelyAngles {
 public:
  explicit LikelyAngles(const Schema& schema);

  /// Passes keys on. Requires: this outlives the source.
  Source<KeyBlock> observe(Source<KeyBlock> blocks);

  /// The channels and their units, so far. Angles that are all within a turn of radians are in radians.
  std::vector<NamedAngle> found() const;

 private:
  struct Channel {
    std::size_t channel;
    std::string name;
    bool is_named = true;     ///< by a name that is one of angles alone
    bool is_positive = true;  ///< no number is below 0
    double largest = 0, jump = 0;
    std::optional<double> before = {};
  };
  bool has_names_;  ///< the channels have; small numbers without a name are no angles
  std::vector<Channel> channels_;
};

/// Keys, and whether any angle of a channel is negative, for which all keys are read where there are angles.
struct SignedKeys {
  Source<KeyBlock> blocks;
  std::vector<AngleColumn> angles;
};
SignedKeys with_signs(Source<KeyBlock> blocks, std::vector<AngleColumn> angles);

}  // namespace tcb
