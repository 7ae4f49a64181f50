// Key blocks: appending, selecting and splitting keys with all their data.
#include "schema/key_block.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace tcb {
namespace {

template <class T>
void copy(std::vector<T>& to, const std::vector<T>& from, std::size_t first, std::size_t last) {
  if (from.empty()) return;
  to.insert(to.end(), from.begin() + static_cast<std::ptrdiff_t>(first),
            from.begin() + static_cast<std::ptrdiff_t>(last));
}

void copy(Texts& to, const Texts& from, std::size_t keys, std::size_t first, std::size_t last) {
  const std::size_t per_key = from.size() / keys;
  to.append(from, first * per_key, last * per_key);
}

}  // namespace

bool KeyBlock::has_gap_at(std::size_t key) const { return std::ranges::binary_search(breaks.gaps, key); }

bool KeyBlock::has_break_before(std::size_t key) const { return std::ranges::binary_search(breaks.before, key); }

bool KeyBlock::begins_curve(std::size_t key) const {
  return (key == 0 && curve_info != nullptr) || has_break_before(key);
}

void KeyBlock::append(const KeyBlock& from, std::size_t first, std::size_t last) {
  if (first == last) return;
  spline::take_common(keys, from.keys);
  const auto append_keys = [&](auto& to, const auto& column) {
    spline::append_entries(to, column, from.size(), first, last);
  };
  spline::for_each_column(append_keys, keys, from.keys);
  copy(text_positions.lines, from.text_positions.lines, first, last);
  copy(text_positions.columns, from.text_positions.columns, first, last);
  copy(text_positions.numbers, from.text_positions.numbers, first, last);
  text_positions.path = from.text_positions.path;
  copy(texts, from.texts, from.size(), first, last);
  copy(decimals, from.decimals, from.size(), first, last);
}

KeyBlock KeyBlock::range(std::size_t first, std::size_t last) const {
  KeyBlock part;
  part.append(*this, first, last);
  return part;
}

KeyBlock KeyBlock::selected(std::span<const std::size_t> indices) const {
  KeyBlock result;
  for (std::size_t i = 0; i < indices.size();) {
    std::size_t run = 1;
    while (i + run < indices.size() && indices[i + run] == indices[i] + run) ++run;
    result.append(*this, indices[i], indices[i] + run);
    i += run;
  }
  return result;
}

KeyBlock KeyBlock::cut(std::size_t first) {
  KeyBlock end = range(first, size());
  const auto break_at = std::ranges::lower_bound(breaks.before, first);
  if (break_at != breaks.before.end()) end.breaks.before = {0};
  if (first == 0) end.curve_info = std::move(curve_info);
  KeyBlock rest = range(0, first);
  rest.take_block_data(*this);
  rest.breaks.before.assign(breaks.before.begin(), break_at);
  *this = std::move(rest);
  return end;
}

void KeyBlock::take_block_data(KeyBlock& from) {
  spline::take_common(keys, from.keys);
  breaks.at_end = from.breaks.at_end;
  if (curve_info == nullptr) curve_info = std::move(from.curve_info);
  faults = std::move(from.faults);
}

void KeyBlock::rewrite_decimals(const std::function<std::string(std::size_t, std::size_t, std::string_view)>& f) {
  if (decimals.empty()) return;
  const std::size_t per_key = decimals.size() / size();
  Texts written;
  for (std::size_t i = 0; i < decimals.size(); ++i) written.add(f(i / per_key, i % per_key, decimals[i]));
  decimals = std::move(written);
}

TextPosition KeyBlock::text_position(std::size_t key) const {
  const std::vector<std::uint32_t>& columns = text_positions.columns;
  return {"", line(key), columns.empty() ? 0 : columns[key]};
}

std::string KeyBlock::list_position(std::size_t key) const {
  const std::vector<std::uint64_t>& numbers = text_positions.numbers;
  return numbers.empty() ? "" : fmt::format("{}[{}]", text_positions.path, numbers[key]);
}

}  // namespace tcb
