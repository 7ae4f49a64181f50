// Keys for tests, written as text: what goes into a room, and what comes out of it.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>

#include "error.hpp"
#include "io/terminal.hpp"
#include "schema/key_block.hpp"
#include "stream/source.hpp"

namespace tcb {

/// Keys of one channel in blocks of `size`, from lines "TIME POSITION TEXT…", where line i has number i.
/// A line "/" is no key: the curve breaks off there. "gap TIME" is a gap, "?" a position that is missing.
inline Source<KeyBlock> keys_of(const std::string& lines, std::size_t size) {
  std::vector<KeyBlock> blocks(1);
  std::istringstream in(lines);
  std::uint64_t number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    if (blocks.back().size() == size) blocks.emplace_back();
    KeyBlock& block = blocks.back();
    if (line == "/") {
      block.breaks.before.push_back(block.size());
      continue;
    }
    std::istringstream cells(line);
    std::string time, position, text;
    cells >> time >> position;
    if (time == "gap") block.breaks.gaps.push_back(block.size());
    if (time == "gap") std::swap(time, position);
    const auto value = [](const std::string& cell) {
      return cell.find_first_of("0123456789") == std::string::npos ? std::nan("") : std::stod(cell);
    };
    block.keys.channels = 1;
    block.keys.times.emplace_back(value(time));
    block.keys.positions.push_back(value(position));
    block.text_positions.lines.push_back(number);
    while (cells >> text) block.texts.add(text);
  }
  return [blocks, next = std::size_t{0}]() mutable {
    return next < blocks.size() ? std::optional(blocks[next++]) : std::nullopt;
  };
}

/// Keys as "LINE:POSITION", with "/" where the curve breaks off, and the first lines of faults in brackets.
inline std::string shown_keys(const Source<KeyBlock>& keys) {
  std::string out;
  while (const auto block = keys()) {
    for (std::size_t i = 0; i < block->size(); ++i) {
      if (std::ranges::count(block->breaks.before, i) > 0) out += " /";
      if (std::ranges::count(block->breaks.gaps, i) > 0) out += " gap";
      out += fmt::format(" {}:{}", block->line(i), block->keys.positions[i]);
    }
    for (const Error& fault : block->faults.errors) out += fmt::format(" [{}]", error_text(fault.in("f")));
  }
  return out;
}

/// The message that f ends with, of file "f".
template <class F>
std::string refusal_of(F f) {
  try {
    f();
  } catch (const Error& error) {
    return error_text(error.in("f"));
  }
  return "nothing";
}

}  // namespace tcb
