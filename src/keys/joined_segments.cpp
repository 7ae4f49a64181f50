// Joined segments: keys from records that are segments.
#include "keys/joined_segments.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "keys/errors.hpp"
#include "numbers/print_number.hpp"
#include "schema/errors.hpp"

namespace tcb {
namespace {

/// The stage of joined_segments(). Keys come in pairs: the start of a segment, and its end.
class Joiner {
 public:
  explicit Joiner(Source<KeyBlock> ends) : ends_(std::move(ends)) {}

  std::optional<KeyBlock> next() {
    std::optional<KeyBlock> block = waiting_ ? std::exchange(waiting_, std::nullopt) : ends_();
    if (!held_.empty() && (!block || block->begins_curve(0))) {
      waiting_ = std::move(block);
      return std::exchange(held_, {});
    }
    if (!block || block->empty()) return block;
    return keys_of(std::move(*block));
  }

 private:
  /// The keys of a block but the last one, which the next block may continue.
  KeyBlock keys_of(KeyBlock block) {
    std::vector<std::size_t> kept, breaks;
    const bool continues = !held_.empty();
    for (std::size_t start = 0; start < block.size(); start += 2) {
      const bool begins = start == 0 ? !continues : block.has_break_before(start);
      if (begins && start > 0) kept.push_back(start - 1);
      if (block.has_break_before(start)) breaks.push_back(kept.size());
      if (!begins) join(start == 0 ? held_ : block, start == 0 ? 0 : start - 1, block, start);
      kept.push_back(start);
      require_duration(block, start);
    }
    KeyBlock result = block.selected(kept);
    if (!result.decimals.empty()) result.decimals = joined_decimals(block, kept);
    result.take_block_data(block);
    result.breaks.before = std::move(breaks);
    held_ = block.range(block.size() - 1, block.size());
    return result;
  }

  /// Gives the start of a segment the incoming velocities of the end before it. Throws: Error (data) if they are apart.
  void join(const KeyBlock& before, std::size_t end, KeyBlock& block, std::size_t start) const {
    const Time &from = block.keys.times[start], &to = before.keys.times[end];
    const double distance = std::abs((from - to).hi);
    if (!(distance <= 0x1p-51 * std::max(size_, std::abs(from.hi)))) {
      throw segment_starts_elsewhere(time_text(from), time_text(to)).at(block.text_position(start));
    }
    const std::size_t channels = block.keys.channels;
    for (std::size_t i = 0; i < channels; ++i) {
      const double here = block.keys.position(start)[i], there = before.keys.position(end)[i];
      if (here != there) throw segment_jumps(here, there).at(block.text_position(start));
      block.keys.velocities[start * channels + i].in = before.keys.velocities[end * channels + i].in;
    }
  }

  /// Sets the size of the times of a segment, to which their rounding errors are relative.
  void require_duration(const KeyBlock& block, std::size_t start) {
    const Time &from = block.keys.times[start], &to = block.keys.times[start + 1];
    const double duration = (to - from).hi;
    if (!(from < to)) throw segment_without_duration(duration).at(block.text_position(start));
    size_ = std::max(std::abs(from.hi), duration);
  }

  /// The numbers of the keys as written, with the incoming velocities of the ends that they are joined to.
  Texts joined_decimals(const KeyBlock& block, const std::vector<std::size_t>& kept) const {
    Texts texts;
    const std::size_t per_key = block.decimals.size() / block.size(), channels = block.keys.channels;
    const std::size_t first = NumberOfKey::of_channel(NumberOfKey::velocity_in_of, 0, channels);
    for (const std::size_t key : kept) {
      const bool is_start = key % 2 == 0;
      for (std::size_t i = 0; i < per_key; ++i) {
        const bool is_incoming = is_start && i >= first && i < first + channels;
        const Texts& from = is_incoming && key == 0 ? held_.decimals : block.decimals;
        const std::size_t owner = !is_incoming ? key : key == 0 ? 0 : key - 1;
        texts.add(from.empty() ? std::string_view() : from[owner * per_key + i]);
      }
    }
    return texts;
  }

  Source<KeyBlock> ends_;
  KeyBlock held_;                    ///< the end of the last segment
  std::optional<KeyBlock> waiting_;  ///< a block that begins a curve
  double size_ = 0;                  ///< of the times of the last segment
};

}  // namespace

Source<KeyBlock> joined_segments(Source<KeyBlock> ends) {
  const auto joiner = std::make_shared<Joiner>(std::move(ends));
  return [joiner] { return joiner->next(); };
}

}  // namespace tcb
