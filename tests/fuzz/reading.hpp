// Readers under test: their result does not depend on the sizes of chunks, and is finite or an error with a position.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "error.hpp"
#include "formats/formats.hpp"
#include "invariant.hpp"
#include "io/terminal.hpp"
#include "keys/curves.hpp"
#include "read/input.hpp"
#include "read/input_options.hpp"

namespace tcb::fuzz {

/// The text in pieces of `size` bytes.
inline Source<std::string> pieces(std::string_view text, std::size_t size) {
  return [text, size]() mutable -> std::optional<std::string> {
    if (text.empty()) return std::nullopt;
    std::string piece(text.substr(0, size));
    text.remove_prefix(piece.size());
    return piece;
  };
}

/// Keys as text, one per line, with the breaks of curves between them, and the checks that hold for each.
class ShownKeys {
 public:
  /// `lines`: of the text; nothing: it has none.
  ShownKeys(std::optional<std::uint64_t> lines, bool may_miss) : lines_(lines), may_miss_(may_miss) {}

  void add(const KeyBlock& block) {
    if (block.curve_info)
      text_ += fmt::format("id {}\n", block.curve_info->id);  // a curve begins, of one block or more
    for (std::size_t i = 0; i < block.size(); ++i) {
      if (block.has_break_before(i) || breaks_) text_ += "break\n";
      breaks_ = false;
      if (block.has_gap_at(i)) {
        text_ += "gap\n";
      } else {
        add_key(block, i);
      }
      for (std::size_t j = 0; j < block.texts_per_key(); ++j) text_ += fmt::format("text {}\n", block.text(i, j));
    }
    breaks_ = breaks_ || block.breaks.at_end;
    skipped_ += block.faults.skipped;
  }

  std::string text() const { return text_ + fmt::format("{} skipped\n", skipped_); }

  /// The numbers of the keys alone, without lines.
  const std::string& numbers() const { return numbers_; }

 private:
  void add_number(double value, bool may_be_missing = false) {
    text_ += fmt::format(" {}", value);
    numbers_ += fmt::format(" {}", value);
    require(std::isfinite(value) || may_be_missing, "a key that is not finite", text_);
  }

  void add_key(const KeyBlock& block, std::size_t i) {
    const spline::Keys<double>& keys = block.keys;
    text_ += fmt::format("{}:{}", block.line(i), block.text_position(i).column);
    require(!lines_ || (block.line(i) >= 1 && block.line(i) <= *lines_), "a key on no line", text_);
    if (!keys.times.empty()) {
      add_number(keys.times.at(i).hi);
      add_number(keys.times.at(i).lo);
    }
    require(keys.positions.size() == block.size() * keys.channels, "positions missing", text_);
    for (const double value : keys.position(i)) add_number(value, may_miss_);
    for (std::size_t channel = 0; channel < (keys.has_channel_tcbs() ? keys.channels : 1); ++channel) {
      const auto& [tension, continuity, bias] = keys.tcb(i, channel);
      for (const double value : {tension, continuity, bias}) add_number(value);
    }
    require(keys.velocities.empty() || keys.velocities.size() == keys.positions.size(), "velocities missing", text_);
    for (std::size_t channel = 0; !keys.velocities.empty() && channel < keys.channels; ++channel) {
      add_number(keys.velocities[i * keys.channels + channel].in, true);
      add_number(keys.velocities[i * keys.channels + channel].out, true);
    }
    if (!keys.eases.empty()) add_number(keys.eases.at(i).in);
    if (!keys.eases.empty()) add_number(keys.eases.at(i).out);
    text_ += '\n';
    numbers_ += '\n';
  }

  std::optional<std::uint64_t> lines_;
  bool may_miss_;
  std::string text_, numbers_;
  std::uint64_t skipped_ = 0;
  bool breaks_ = false;
};

/// The result of a reader for a text: keys as text, or an error.
struct Reading {
  std::string text;
  std::string numbers;  ///< of the keys alone
  bool refused = false;
};

inline Reading read(std::string_view text, const InputOptions& options, std::size_t piece) {
  const bool is_binary = options.format == find_format("3ds") || options.format == find_format("npy");
  std::optional<std::uint64_t> lines;
  if (!is_binary) lines = static_cast<std::uint64_t>(std::ranges::count(text, '\n')) + 1;
  try {
    const Input input = open_input("f", pieces(text, piece), options);
    std::string found;
    const char delimiter = input.schema.marks.value_or(TextMarks{}).delimiter;
    found += fmt::format("{} {} {}\n", input.facts.format->name, delimiter, input.schema.named);
    for (const auto& names : {input.schema.groups,
                              {input.schema.time.name},
                              input.schema.channels,
                              input.schema.labels,
                              input.facts.ignored}) {
      for (const std::string& name : names) found += fmt::format("{}\n", name);
    }
    ShownKeys shown(lines, input.keys.traits.may_miss);
    const Source<KeyBlock> keys = without_faults(input.keys.blocks);
    while (const auto block = keys()) shown.add(*block);
    return {found + shown.text(), shown.numbers()};
  } catch (const Error& error) {
    const std::string refusal = error_text(error.in("f"));
    require_refusal(refusal, "f");
    const bool there = !lines || (error.position().line <= *lines + 1 && error.position().column <= text.size() + 1);
    require(there, "a place that is not there", fmt::format("{}\n{}", refusal, text));
    return {refusal, "", true};
  }
}

/// Reads the text whole and in chunks, on one thread and sometimes on three. The boundaries of chunks may decide which
/// error of a text comes first, unless `same_refusals`.
inline void require_same_readings(std::string_view text, InputOptions options, std::size_t piece, bool same_refusals) {
  const Reading whole = read(text, options, std::string_view::npos);
  const Reading pieced = read(text, options, piece);
  const bool both_refused = whole.refused && pieced.refused;
  if (same_refusals || !both_refused) require_same(whole.text, pieced.text, "whole and in pieces");
  if (piece % 8 != 0) return;
  options.threads = 3;
  require_same(pieced.text, read(text, options, piece).text, "on one thread and on three");
}

}  // namespace tcb::fuzz
