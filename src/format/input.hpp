// What an input is told from outside, what flows through its reading, and what it yields.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "error.hpp"
#include "format/columns.hpp"
#include "settings.hpp"
#include "spline/key.hpp"
#include "stream.hpp"

namespace tcb::format {

/// What the command line says about the input.
struct InputOptions {
  std::optional<std::size_t> format;  ///< index into formats(); nothing: by ending or content
  std::optional<char> delimiter;      ///< ' ' stands for runs of blanks and tabs
  std::optional<bool> header;
  std::string comment = "#";  ///< lines that begin with it are skipped; empty: none are
  std::vector<RoleRequest> roles;
  spline::Tcb<double> tcb;  ///< for keys that carry none
  bool timeless = false;    ///< no column is the time, unless its name says so
  unsigned threads = 1;     ///< that may work on it
};

/// Whole records of an input, as text.
struct Chunk {
  std::string text;
  std::uint64_t line = 1;    ///< of the first character, from 1
  std::uint64_t column = 1;  ///< of the first character, from 1
  std::uint64_t first = 0;   ///< number of the first record, where the format counts them
};

/// Successive keys, and the line that each stands on. Where the input has no times, neither have the keys.
struct KeyBlock {
  spline::Keys<double> keys;
  std::vector<std::uint64_t> lines;
};

/// An input opened: what its numbers mean, and its keys in blocks.
struct Input {
  bool named = false;                 ///< it names its columns
  bool timed = false;                 ///< it has a time column
  std::string time;                   ///< name of the time column
  std::vector<std::string> channels;  ///< names of the position channels
  CurveSettings settings;             ///< what stands beside the keys
  Source<KeyBlock> keys;
  std::vector<std::pair<std::string, Place>> setting_places = {};  ///< where each setting stands
  std::vector<std::pair<std::string, std::string>> facts = {};     ///< what was found, in words
  unsigned threads = 1;                                            ///< that may work on it
};

}  // namespace tcb::format
