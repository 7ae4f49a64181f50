// Key store: the keys of a curve that has to be read to its end, in 8 bytes per number.
#include "keys/key_store.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "numbers/decimal_time.hpp"

namespace tcb {

void KeyStore::Columns::append(const Keys& keys) {
  channels = keys.channels;
  common_tcb = keys.common_tcb;
  for (const auto& time : keys.times) {
    if (time.lo != 0) low_parts.resize(times.size());
    times.push_back(time.hi);
    if (time.lo != 0 || !low_parts.empty()) low_parts.push_back(time.lo);
  }
  positions.insert(positions.end(), keys.positions.begin(), keys.positions.end());
  tcbs_per_key = keys.tcbs_per_key();
  tcbs.insert(tcbs.end(), keys.tcbs.begin(), keys.tcbs.end());
  eases.insert(eases.end(), keys.eases.begin(), keys.eases.end());
  turns_per_key = keys.turns_per_key();
  turns.insert(turns.end(), keys.turns.begin(), keys.turns.end());
  given = keys.given;
  velocities.insert(velocities.end(), keys.velocities.begin(), keys.velocities.end());
}

Keys KeyStore::Columns::part(std::size_t first, std::size_t last) const {
  Keys keys;
  keys.channels = channels;
  keys.common_tcb = common_tcb;
  const auto copy = [&](auto& to, const auto& from, std::size_t stride) {
    const auto begin = from.begin();
    to.assign(begin + static_cast<std::ptrdiff_t>(first * stride), begin + static_cast<std::ptrdiff_t>(last * stride));
  };
  copy(keys.times, times, 1);
  for (std::size_t i = 0; !low_parts.empty() && i < keys.times.size(); ++i) keys.times[i].lo = low_parts[first + i];
  copy(keys.positions, positions, channels);
  copy(keys.tcbs, tcbs, tcbs_per_key);
  if (!eases.empty()) copy(keys.eases, eases, 1);
  copy(keys.turns, turns, turns_per_key);
  if (velocities.empty()) return keys;
  keys.given = given;
  copy(keys.velocities, velocities, channels);
  return keys;
}

KeyStore::KeyStore(const Source<KeyBlock>& blocks) : columns_(std::make_shared<Columns>()) {
  std::optional<KeyBlock> block;  // kept until the next one: freed memory would not return to the system
  while ((block = blocks())) {
    if (block->empty()) continue;
    if (size() == 0) first_line_ = block->lines.front();
    last_line_ = block->lines.back();
    columns_->append(block->keys);
  }
}

void KeyStore::drop_last() {
  Columns& columns = *columns_;
  columns.times.pop_back();
  if (!columns.low_parts.empty()) columns.low_parts.pop_back();
  columns.positions.resize(columns.times.size() * columns.channels);
  columns.tcbs.resize(columns.times.size() * columns.tcbs_per_key);
  if (!columns.eases.empty()) columns.eases.pop_back();
  columns.turns.resize(columns.times.size() * columns.turns_per_key);
  if (!columns.velocities.empty()) columns.velocities.resize(columns.positions.size());
}

void KeyStore::set_first_incoming(const Keys& repeated) {
  for (std::size_t i = 0; i < repeated.velocities.size(); ++i) columns_->velocities[i].in = repeated.velocities[i].in;
  std::ranges::copy(repeated.turns, columns_->turns.begin());
}

int KeyStore::decimals() const {
  int most = 0;
  for (std::size_t i = 0; i < columns_->low_parts.size(); ++i) {
    most = std::max(most, decimals_of({columns_->times[i], columns_->low_parts[i]}));
  }
  return most;
}

bool KeyStore::are_sparse() const {
  return std::ranges::any_of(columns_->positions, [](double position) { return std::isnan(position); });
}

Source<Keys> KeyStore::source() const {
  return [columns = columns_, next = std::size_t{0}]() mutable -> std::optional<Keys> {
    if (next == columns->times.size()) return std::nullopt;
    const std::size_t first = next;
    next = std::min(first + keys_at_once, columns->times.size());
    return columns->part(first, next);
  };
}

}  // namespace tcb
