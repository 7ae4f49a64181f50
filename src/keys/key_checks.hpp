// Key checks: whether the keys of a curve have clear times, their parameters, and enough keys.
#pragma once

#include <cstddef>
#include <string>

#include "schema/key_block.hpp"
#include "stream/source.hpp"

namespace tcb {

/// Passes the keys of a curve without times on. Throws: Error (data) where the first channel, of this name, increases
/// from key to key, up to the thousandth: then it may be the time.
Source<KeyBlock> with_clear_times(Source<KeyBlock> blocks, std::string channel);

/// The scale on which a product shows tension, continuity and bias, where it is not from -1 to 1.
enum class ShownTcbScale { from_0_to_50, percent };

/// Passes keys on. Throws: Error (data) for tension, continuity or bias beyond 5 in size: they are probably on the
/// scale on which the product shows them.
Source<KeyBlock> within_tcb_scale(Source<KeyBlock> blocks, ShownTcbScale shown);

/// Passes keys on. Throws: Error (data) about keys with ease, velocities or missing positions, which monotone timing
/// does not have.
Source<KeyBlock> with_rules_alone(Source<KeyBlock> blocks);

/// The keys without their ease.
Source<KeyBlock> without_ease(Source<KeyBlock> blocks);

/// Passes keys on, and checks that there are at least `least` of them, 1 or 2, and that their ease is in [0, 1].
/// Requires: increasing times. Throws: Error (data) with the line of the key.
Source<KeyBlock> checked(Source<KeyBlock> blocks, std::size_t least);

}  // namespace tcb
