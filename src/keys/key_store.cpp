// Key store: the keys of a curve that has to be read to its end, in 8 bytes per number.
#include "keys/key_store.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <type_traits>

#include "numbers/decimal_time.hpp"
#include "tcb/spline/closing.hpp"

namespace tcb {

void KeyStore::Times::push_back(const Time& time) {
  if (time.lo != 0) low.resize(high.size());
  high.push_back(time.hi);
  if (time.lo != 0 || !low.empty()) low.push_back(time.lo);
}

void KeyStore::Times::resize(std::size_t size) {
  high.resize(size);
  if (!low.empty()) low.resize(size);
}

namespace {

/// Appends the entries of keys [first, last) of a column, also where one of the two has its times in two parts.
template <class To, class From>
void append_part(To& to, const From& from, std::size_t size, std::size_t first, std::size_t last) {
  if constexpr (std::is_same_v<std::remove_cvref_t<decltype(from[0])>, Time>) {
    if constexpr (requires { to.reserve(size); }) to.reserve(to.size() + (last - first));
    for (std::size_t key = first; key < last; ++key) to.push_back(from[key]);
  } else {
    spline::append_entries(to, from, size, first, last);
  }
}

}  // namespace

void KeyStore::Columns::append(const Keys& keys) {
  if (keys.size() == 0) return;
  spline::take_common(*this, keys);
  const auto append = [&](auto& to, const auto& from) { append_part(to, from, keys.size(), 0, keys.size()); };
  spline::for_each_column(append, *this, keys);
}

Keys KeyStore::Columns::part(std::size_t first, std::size_t last) const {
  Keys keys;
  spline::take_common(keys, *this);
  const auto append = [&](auto& to, const auto& from) { append_part(to, from, size(), first, last); };
  if (first != last) spline::for_each_column(append, keys, *this);
  return keys;
}

KeyStore::KeyStore(const Source<KeyBlock>& blocks) : columns_(std::make_shared<Columns>()) {
  std::optional<KeyBlock> block;  // kept until the next one: freed memory would not return to the system
  while ((block = blocks())) {
    if (block->empty()) continue;
    if (size() == 0) first_line_ = block->text_positions.lines.front();
    last_line_ = block->text_positions.lines.back();
    columns_->append(block->keys);
  }
}

void KeyStore::drop_last() {
  const std::size_t size = this->size();
  spline::for_each_column([size](auto& column) { column.resize(column.size() / size * (size - 1)); }, *columns_);
}

void KeyStore::join_seam(const Keys& repeated) { spline::join_seam(*columns_, repeated); }

int KeyStore::decimals() const {
  int most = 0;
  const Times& times = columns_->times;
  for (std::size_t key = 0; !times.low.empty() && key < times.size(); ++key) {
    most = std::max(most, decimals_of(times[key]));
  }
  return most;
}

bool KeyStore::are_sparse() const {
  return std::ranges::any_of(columns_->positions, [](double position) { return std::isnan(position); });
}

Source<Keys> KeyStore::source() const {
  return [columns = columns_, next = std::size_t{0}]() mutable -> std::optional<Keys> {
    if (next == columns->size()) return std::nullopt;
    const std::size_t first = next;
    next = std::min(first + keys_at_once, columns->size());
    return columns->part(first, next);
  };
}

}  // namespace tcb
