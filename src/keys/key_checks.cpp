// Key checks: whether the keys of a curve have clear times, their parameters, and enough keys.
#include "keys/key_checks.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <optional>
#include <string>
#include <utility>

#include "keys/errors.hpp"
#include "schema/errors.hpp"
#include "schema/roles.hpp"

namespace tcb {
namespace {

void require_ease(const spline::Ease<double>& ease, std::uint64_t line) {
  for (const auto& [name, value] : {std::pair{"ease_in", ease.in}, std::pair{"ease_out", ease.out}}) {
    if (value >= 0 && value <= 1) continue;
    throw ease_out_of_range(name, value).at({"", line, 0});
  }
}

}  // namespace

Source<KeyBlock> with_clear_times(Source<KeyBlock> blocks, std::string channel) {
  return [blocks = std::move(blocks), channel = std::move(channel), held = std::deque<KeyBlock>(),
          is_clear = false]() mutable -> std::optional<KeyBlock> {
    constexpr std::size_t most = 1000;
    std::size_t keys = 0;
    for (double before = 0; !is_clear;) {
      std::optional<KeyBlock> block = blocks();
      for (std::size_t i = 0; block && i < block->size() && keys < most && !is_clear; ++i) {
        const double now = block->keys.positions[i * block->keys.channels];
        is_clear = keys++ > 0 && !(before < now);
        before = now;
      }
      if (!is_clear && keys > 1 && (!block || keys == most)) {
        throw times_unclear(channel);
      }
      is_clear = is_clear || !block;
      if (block) held.push_back(std::move(*block));
    }
    if (held.empty()) return blocks();
    KeyBlock first = std::move(held.front());
    held.pop_front();
    return first;
  };
}

Source<KeyBlock> within_tcb_scale(Source<KeyBlock> blocks, ShownTcbScale shown) {
  const auto fault = shown == ShownTcbScale::percent ? tcb_in_percent : tcb_from_0_to_50;
  return mapped(std::move(blocks), [fault](KeyBlock block) {
    const auto require = [&](std::size_t key, Role role, double value) {
      if (std::abs(value) <= 5) return;
      throw fault(role_name(role), value).at({"", block.line(key), 0});
    };
    const std::size_t per_key = std::max<std::size_t>(block.keys.tcbs_per_key(), 1);
    for (std::size_t i = 0; i < block.size() * per_key; ++i) {
      const auto& tcb = block.keys.tcb(i / per_key, i % per_key);
      require(i / per_key, Role::tension, tcb.tension);
      require(i / per_key, Role::continuity, tcb.continuity);
      require(i / per_key, Role::bias, tcb.bias);
    }
    return block;
  });
}

Source<KeyBlock> with_rules_alone(Source<KeyBlock> blocks) {
  return mapped(std::move(blocks), [](KeyBlock block) {
    if (block.empty()) return block;
    if (!block.keys.eases.empty()) throw ease_with_timing().at({"", block.line(0)});
    if (!block.keys.velocities.empty()) throw velocities_with_timing().at({"", block.line(0)});
    if (block.keys.is_sparse()) throw missing_cells_with_timing().at({"", block.line(0)});
    return block;
  });
}

Source<KeyBlock> without_ease(Source<KeyBlock> blocks) {
  return mapped(std::move(blocks), [](KeyBlock block) {
    block.keys.eases.clear();
    return block;
  });
}

Source<KeyBlock> checked(Source<KeyBlock> blocks, std::size_t least) {
  return [blocks = std::move(blocks), least, count = std::size_t{0},
          line = std::uint64_t{0}]() mutable -> std::optional<KeyBlock> {
    std::optional<KeyBlock> block = blocks();
    if (!block && count < least) throw too_few_keys(count).at({"", line, 0});
    if (!block) return std::nullopt;
    for (std::size_t i = 0; i < block->keys.eases.size(); ++i) require_ease(block->keys.eases[i], block->line(i));
    if (count == 0 && block->keys.size() > 0) line = block->line(0);
    count += block->keys.size();
    return block;
  };
}

}  // namespace tcb
