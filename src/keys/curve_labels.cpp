// Curve labels: the column that distinguishes the curves of keys whose times do not increase.
#include "keys/curve_labels.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <unordered_map>

#include "numbers/decimal_time.hpp"
#include "schema/usual_names.hpp"

namespace tcb {
namespace {

/// The value of a key in a column; nothing if it distinguishes no curves.
using Label = std::function<std::optional<std::size_t>(std::size_t key)>;

/// Whether times increase for each value of a column, and there are several values, some of several keys.
bool distinguishes(const KeyBlock& block, const Label& label) {
  std::unordered_map<std::size_t, Time> before;
  for (std::size_t key = 0; key < block.size(); ++key) {
    const auto value = label(key);
    if (!value) return false;
    const Time time = block.keys.times[key];
    const auto [found, is_first] = before.emplace(*value, time);
    if (!is_first && !is_earlier(found->second, time)) return false;
    found->second = time;
  }
  return before.size() > 1 && before.size() < block.size();
}

}  // namespace

std::string CurveLabels::distinguishing(const KeyBlock& block, bool texts) const {
  const std::size_t per_key = block.marks_per_key();
  for (std::size_t i = 0; i < std::min(per_key, marks.size()); ++i) {
    if (!marks[i].is_text && (texts || !is_usual_label(marks[i].column))) continue;
    if (distinguishes(block, [&](std::size_t key) { return std::optional(block.marks[key * per_key + i]); })) {
      return marks[i].column;
    }
  }
  const auto number = [&](std::size_t key, std::size_t channel) -> std::optional<std::size_t> {
    const double value = block.keys.positions[key * block.keys.channels + channel];
    if (!(std::abs(value) < 0x1p53) || value != std::trunc(value)) return std::nullopt;
    return static_cast<std::size_t>(static_cast<std::int64_t>(value));
  };
  for (std::size_t i = 0; i < channels.size() && !texts; ++i) {
    const auto label = [&](std::size_t key) { return number(key, i); };
    if (is_usual_label(channels[i]) && distinguishes(block, label)) return channels[i];
  }
  return "";
}

}  // namespace tcb
