// Parameterize and check: times for keys without any, from the distances between them; ease and number of keys.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "input/key_block.hpp"
#include "stream/stream.hpp"

namespace tcb {

/// Keys with times where the input has none: t[i+1] = t[i] + |P[i+1] - P[i]|^exponent, which is t[i] + 1 for exponent
/// 0. `metric`: the channels that count for distances; empty: all. Throws: Error (data) where two positions are equal,
/// or a step is lost in rounding; it has both lines.
Source<KeyBlock> parameterized(Source<KeyBlock> blocks, double exponent, std::vector<std::size_t> metric);

/// |b - a|^exponent over the metric channels (empty: all); 1 for exponent 0.
double parameter_step(std::span<const double> a, std::span<const double> b, double exponent,
                      std::span<const std::size_t> metric);

/// The same keys, without their ease.
Source<KeyBlock> without_ease(Source<KeyBlock> blocks);

/// The same keys, checked: there are at least `least` of them, 1 or 2, and their ease is in [0, 1].
/// Requires: times that increase. Throws: Error (data) with the line of the key.
Source<KeyBlock> checked(Source<KeyBlock> blocks, std::size_t least);

}  // namespace tcb
