// What an input is told from outside, what flows through its reading, and what it yields.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "error.hpp"
#include "input/columns.hpp"
#include "input/key_block.hpp"
#include "input/texts.hpp"
#include "io/formats.hpp"
#include "stream/stream.hpp"
#include "tcb/spline/key.hpp"

namespace tcb {

/// What becomes of a cell without a number.
enum class Missing { error, skip_row, skip_cell, break_curve };

/// How --missing names them.
struct MissingName {
  std::string_view name;
  Missing way;
};
inline constexpr std::array missing_names{
    MissingName{"error", Missing::error}, MissingName{"skip-row", Missing::skip_row},
    MissingName{"skip-cell", Missing::skip_cell}, MissingName{"break", Missing::break_curve}};

/// What the command line says about the input.
struct InputOptions {
  std::optional<FormatId> format;  ///< nothing: by ending or content
  std::optional<char> delimiter;   ///< ' ' stands for runs of blanks and tabs
  std::optional<bool> header;
  std::string comment = "#";  ///< lines that begin with it are skipped; empty: none are
  std::vector<RoleRequest> roles;
  spline::Tcb<double> tcb;  ///< for keys that carry none
  bool timeless = false;    ///< no column is the time, unless its name says so
  unsigned threads = 1;     ///< that may work on it
  char decimal = '.';       ///< between the digits of a number in delimited text
  Missing missing = Missing::error;
  std::optional<SampleNames> samples;  ///< the records are no keys but samples of a curve
  bool keeps_decimals = false;         ///< keys keep their numbers as they are written
};

/// IndexedCurve records of an input, as text.
struct Chunk {
  std::string text;
  std::uint64_t line = 1;    ///< of the first character, from 1
  std::uint64_t column = 1;  ///< of the first character, from 1
  std::uint64_t first = 0;   ///< number of the first record, where the format counts them
  std::string path = {};     ///< of the list that the records are in, where the format has one
};

/// So many faults of an input are said before it is given up.
inline constexpr std::size_t most_faults = 10;

/// The place of a column's number, if it has one.
inline std::optional<std::size_t> number_of_key(const Columns::Column& column) {
  switch (column.role) {
    case Role::time: return NumberOfKey::time;
    case Role::tension: return NumberOfKey::tension;
    case Role::continuity: return NumberOfKey::continuity;
    case Role::bias: return NumberOfKey::bias;
    case Role::ease_in: return NumberOfKey::ease_in;
    case Role::ease_out: return NumberOfKey::ease_out;
    case Role::position: return NumberOfKey::position + column.channel;
    case Role::left_out:
    case Role::group:
    case Role::carry: break;
  }
  return std::nullopt;
}

/// The shapes of JSON inputs.
enum class JsonShape { list, object, curves, lines };

/// What was found at the beginning of an input, besides its columns.
struct InputFacts {
  FormatId format = FormatId::csv;
  JsonShape shape = JsonShape::list;  ///< of JSON
  char delimiter = ',';               ///< of delimited text; ' ' is any run of blanks and tabs
  std::string comment;                ///< the prefix of its comment lines; empty: it has none
  char decimal = '.';                 ///< its decimal mark
  std::vector<Role> roles;            ///< those of tension to ease_out that have a column
};

/// An input opened: what its numbers mean, and its keys in blocks.
struct Input {
  bool named = false;                 ///< it names its columns
  bool timed = false;                 ///< it has a time column
  std::string time;                   ///< name of the time column
  std::vector<std::string> channels;  ///< names of the position channels
  CurveInfo curve_info;               ///< what stands beside the keys, for all of them
  Source<KeyBlock> keys;
  InputFacts facts = {};
  std::vector<std::string> ignored = {};  ///< names of the columns without a meaning
  std::vector<std::string> groups = {};   ///< names of the columns that tell curves apart
  std::vector<std::string> carried = {};  ///< names of the columns of labels
  unsigned threads = 1;                   ///< that may work on it
  bool may_break = false;                 ///< a curve may end before the input does
  bool may_miss = false;                  ///< positions may be missing
  bool own_curves = false;                ///< blocks say where curves begin, and what is beside their keys
};

}  // namespace tcb
