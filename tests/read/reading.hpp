// Reads a whole input, cut into pieces of any size, and shows its keys or its error as text.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "error.hpp"
#include "formats/formats.hpp"
#include "io/terminal.hpp"
#include "keys/curves.hpp"
#include "read/input.hpp"
#include "read/input_options.hpp"

namespace tcb {

/// The message that f ends with, of file "f"; one for wrong usage begins with "usage: ".
template <class F>
std::string error_of(F f) {
  try {
    f();
  } catch (const Error& error) {
    return (error.exit() == Exit::usage ? "usage: " : "") + error_text(error.in("f"));
  }
  return "no error";
}

/// The text in pieces of `size` bytes.
inline Source<std::string> pieces(std::string text, std::size_t size = std::string::npos) {
  return [text = std::move(text), size, at = std::size_t{0}]() mutable -> std::optional<std::string> {
    if (at >= text.size()) return std::nullopt;
    std::string piece = text.substr(at, size);
    at += piece.size();
    return piece;
  };
}

inline std::string shown_time(const spline::DoubleDouble& time) {
  if (std::trunc(time.hi) != time.hi || std::abs(time.hi) > 0x1p62) return fmt::format("{}", time.hi);
  return std::to_string(static_cast<std::int64_t>(time.hi) + static_cast<std::int64_t>(time.lo));
}

/// Key i as "LINE: TIME POSITION…", with " [T C B]" at the end where those are not all 0.
inline std::string shown_key(const KeyBlock& block, std::size_t i) {
  std::string text = fmt::format("{}: {}", block.line(i), shown_time(block.keys.times.at(i)));
  for (const double value : block.keys.position(i)) text += fmt::format(" {}", value);
  const auto& tcb = block.keys.tcb(i);
  if (tcb != spline::Tcb<double>{}) text += fmt::format(" [{} {} {}]", tcb.tension, tcb.continuity, tcb.bias);
  for (std::size_t number = 0; number < block.texts_per_key(); ++number) {
    text += fmt::format(" <{}>", block.text(i, number));
  }
  return text + "\n";
}

/// The columns' names and all keys, or the error. Names that the input does not give are in brackets.
inline std::string read(const std::string& text, const InputOptions& options = {},
                        std::size_t piece = std::string::npos, const std::string& path = "f") {
  std::string out;
  const std::string error = error_of([&] {
    const Input input = open_input(path, pieces(text, piece), options);
    for (const std::string& name : input.schema.channels) out += " " + name;
    out = input.schema.named ? input.schema.time.name + out + "\n" : "(" + input.schema.time.name + out + ")\n";
    const Source<KeyBlock> keys = without_faults(input.keys.blocks);
    while (const auto block = keys()) {
      for (std::size_t i = 0; i < block->keys.size(); ++i) out += shown_key(*block, i);
    }
  });
  return error == "no error" ? out : error;
}

/// Options with this --columns.
inline InputOptions with_columns(std::string_view columns) {
  InputOptions options;
  options.columns.roles = parse_roles(columns);
  return options;
}

}  // namespace tcb
