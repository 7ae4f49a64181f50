// Blocks of keys: a part of one, one behind another, and a curve's blocks in other sizes.
#pragma once

#include <cstddef>
#include <span>

#include "input/input.hpp"

namespace tcb {

/// Keys [first, last) of `from` go behind those of `to`, with their lines and texts; gaps and breaks do not.
void append(KeyBlock& to, const KeyBlock& from, std::size_t first, std::size_t last);

/// The keys with these numbers.
KeyBlock chosen(const KeyBlock& block, std::span<const std::size_t> keys);

/// Where a key stands: in text its time, in JSON itself.
TextPosition place_of_key(const KeyBlock& block, std::size_t key);

/// The key in words, as in "keys[17]", where its list has a name; otherwise its line.
std::string name_of_key(const KeyBlock& block, std::size_t key);

}  // namespace tcb
