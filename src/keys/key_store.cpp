// Key store: the keys of a curve that has to be read to its end.
#include "keys/key_store.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "numbers/decimal_time.hpp"
#include "tcb/spline/closing.hpp"

namespace tcb {

KeyStore::KeyStore(const Source<KeyBlock>& blocks) {
  std::optional<KeyBlock> block;  // kept until the next one: freed memory would not return to the system
  while ((block = blocks())) {
    if (block->empty()) continue;
    if (size() == 0) first_line_ = block->text_positions.lines.front();
    last_line_ = block->text_positions.lines.back();
    append(block->keys);
  }
}

void KeyStore::append(const Keys& keys) {
  for (std::size_t first = 0; first < keys.size();) {
    if (blocks_->empty() || blocks_->back().size() == keys_at_once) {
      blocks_->emplace_back();
      const auto reserve = [&](auto& to, const auto& from) { to.reserve(from.size() / keys.size() * keys_at_once); };
      if (blocks_->size() > 1) spline::for_each_column(reserve, blocks_->back(), keys);
    }
    Keys& last = blocks_->back();
    const std::size_t end = std::min(first + keys_at_once - last.size(), keys.size());
    spline::append(last, keys, first, end);
    first = end;
  }
}

Keys KeyStore::key(std::size_t number) const {
  Keys one;
  const std::size_t at = number % keys_at_once;
  spline::append(one, (*blocks_)[number / keys_at_once], at, at + 1);
  return one;
}

void KeyStore::drop_last() {
  Keys& last = blocks_->back();
  const std::size_t size = last.size();
  spline::for_each_column([size](auto& column) { column.resize(column.size() / size * (size - 1)); }, last);
  if (size == 1) blocks_->pop_back();
}

void KeyStore::join_seam(const Keys& repeated) { spline::join_seam(blocks_->front(), repeated); }

int KeyStore::decimals() const {
  int most = 0;
  for (const Keys& block : *blocks_) {
    for (const Time& time : block.times) most = time.lo == 0 ? most : std::max(most, decimals_of(time));
  }
  return most;
}

bool KeyStore::are_sparse() const {
  return std::ranges::any_of(*blocks_, [](const Keys& block) {
    return std::ranges::any_of(block.positions, [](double position) { return std::isnan(position); });
  });
}

Keys KeyStore::all() const {
  Keys keys;
  for (const Keys& block : *blocks_) spline::append(keys, block, 0, block.size());
  return keys;
}

Source<Keys> KeyStore::source() const {
  return [blocks = blocks_, next = std::size_t{0}]() mutable -> std::optional<Keys> {
    return next < blocks->size() ? std::optional((*blocks)[next++]) : std::nullopt;
  };
}

}  // namespace tcb
