// Key blocks: appending, selecting and splitting keys with all their data.
#include "schema/key_block.hpp"

#include <fmt/format.h>

#include <algorithm>

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

template <class T>
void drop_last(std::vector<T>& values) {
  if (!values.empty()) values.pop_back();
}

}  // namespace

bool KeyBlock::has_gap_at(std::size_t key) const { return std::ranges::binary_search(gaps, key); }

bool KeyBlock::has_break_before(std::size_t key) const { return std::ranges::binary_search(breaks, key); }

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
  copy(lines, from.lines, first, last);
  copy(columns, from.columns, first, last);
  copy(numbers, from.numbers, first, last);
  copy(marks, from.marks, first * from.marks_per_key(), last * from.marks_per_key());
  copy(texts, from.texts, from.size(), first, last);
  copy(decimals, from.decimals, from.size(), first, last);
  path = from.path;
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

KeyBlock KeyBlock::split_last() {
  const std::size_t last = size() - 1;
  KeyBlock one = range(last, last + 1);
  if (has_break_before(last)) {
    one.breaks = {0};
    breaks.pop_back();
  }
  if (last == 0) one.curve_info = std::move(curve_info);
  marks.resize(marks_per_key() * last);
  texts.cut(texts_per_key() * last);
  decimals.cut(decimals.size() / size() * last);
  spline::for_each_column([&](auto& column) { column.resize(column.size() / size() * last); }, keys);
  drop_last(lines);
  drop_last(columns);
  drop_last(numbers);
  return one;
}

void KeyBlock::take_block_data(KeyBlock& from) {
  spline::take_common(keys, from.keys);
  break_after = from.break_after;
  if (curve_info == nullptr) curve_info = std::move(from.curve_info);
  skipped = from.skipped;
  faults = std::move(from.faults);
  unreadable = from.unreadable;
}

TextPosition KeyBlock::text_position(std::size_t key) const {
  return {"", lines[key], columns.empty() ? 0 : columns[key]};
}

std::string KeyBlock::list_position(std::size_t key) const {
  return numbers.empty() ? "" : fmt::format("{}[{}]", path, numbers[key]);
}

}  // namespace tcb
