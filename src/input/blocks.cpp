// Blocks of keys: a part of one, one behind another, and a curve's blocks in other sizes.
#include "input/blocks.hpp"

#include <fmt/format.h>

namespace tcb {
namespace {

template <class T>
void copy(std::vector<T>& to, const std::vector<T>& from, std::size_t first, std::size_t last) {
  if (from.empty()) return;
  to.insert(to.end(), from.begin() + static_cast<std::ptrdiff_t>(first),
            from.begin() + static_cast<std::ptrdiff_t>(last));
}

}  // namespace

void append(KeyBlock& to, const KeyBlock& from, std::size_t first, std::size_t last) {
  if (first == last) return;
  const spline::Keys<double>& keys = from.keys;
  const std::size_t texts = from.texts.size() / from.lines.size();
  to.keys.channels = keys.channels;
  to.keys.common_tcb = keys.common_tcb;
  copy(to.keys.times, keys.times, first, last);
  copy(to.keys.positions, keys.positions, first * keys.channels, last * keys.channels);
  copy(to.keys.tcbs, keys.tcbs, first, last);
  copy(to.keys.eases, keys.eases, first, last);
  copy(to.lines, from.lines, first, last);
  copy(to.columns, from.columns, first, last);
  copy(to.numbers, from.numbers, first, last);
  to.texts.append(from.texts, first * texts, last * texts);
  const std::size_t decimals = from.decimals.size() / from.lines.size();
  to.decimals.append(from.decimals, first * decimals, last * decimals);
  to.path = from.path;
}

KeyBlock chosen(const KeyBlock& block, std::span<const std::size_t> keys) {
  KeyBlock result;
  for (std::size_t i = 0; i < keys.size();) {
    std::size_t run = 1;
    while (i + run < keys.size() && keys[i + run] == keys[i] + run) ++run;
    append(result, block, keys[i], keys[i] + run);
    i += run;
  }
  return result;
}

TextPosition place_of_key(const KeyBlock& block, std::size_t key) {
  return {"", block.lines[key], block.columns.empty() ? 0 : block.columns[key]};
}

std::string name_of_key(const KeyBlock& block, std::size_t key) {
  if (block.numbers.empty()) return fmt::format("line {}", block.lines[key]);
  return fmt::format("{}[{}]", block.path, block.numbers[key]);
}

}  // namespace tcb
