// Input options: what is requested of the reading of an input.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "numbers/rational.hpp"
#include "numbers/time_notation.hpp"
#include "schema/columns.hpp"
#include "schema/formats.hpp"
#include "schema/key_rules.hpp"
#include "schema/rotation_options.hpp"
#include "schema/units.hpp"

namespace tcb {

/// Options of the reading of an input.
struct InputOptions {
  std::optional<FormatId> format;  ///< nothing: by ending or content
  std::optional<char> delimiter;   ///< ' ' is any run of blanks and tabs
  std::optional<bool> header;
  std::string comment = "#";  ///< the prefix of lines to skip; empty: none
  std::vector<RoleRequest> roles;
  spline::Tcb<double> tcb;  ///< of keys that have none
  bool timeless = false;    ///< no column is the time, unless by its name
  unsigned threads = 1;     ///< at most
  char decimal = '.';       ///< decimal mark of delimited text
  Missing missing = Missing::error;
  std::optional<SampleNames> samples;  ///< the records are samples of a curve, not keys
  bool keeps_decimals = false;         ///< keys keep their numbers also as text

  std::vector<std::string> signs;  ///< of missing cells, besides the common ones

  TcbScale tcb_scale = TcbScale::unknown;
  std::optional<TimeUnit> time_unit;   ///< of the times; nothing: that of the column's name, if it has one
  std::optional<Rational> input_rate;  ///< the times are frames, so many of them a second
  std::vector<ChannelScale> scales;
  RotationOptions rotation = {};
  std::vector<Renaming> renamings;  ///< of columns in the output

  KeyRules key_rules() const { return {tcb, missing, keeps_decimals, signs, tcb_scale}; }
  UnitOptions units() const { return {time_unit, input_rate, scales, samples.has_value()}; }
};

}  // namespace tcb
