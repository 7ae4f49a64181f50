// Writer options: the form of an output.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "numbers/print_number.hpp"
#include "numbers/time_notation.hpp"
#include "schema/format.hpp"
#include "write/provenance.hpp"

namespace tcb {

/// The time that is subtracted from those of rows.
struct TimeZero {
  std::optional<Rational> time;  ///< in the unit of the times; nothing: that of the first key of the output
};

/// The form of an output.
struct WriterOptions {
  const Format* format = nullptr;   ///< one that has rows
  std::optional<bool> header;       ///< nothing: as the input has one
  std::optional<char> delimiter;    ///< nothing: that of the format
  char decimal = '.';               ///< the decimal mark
  Notation notation;                ///< of numbers that may have a fraction
  std::vector<std::size_t> fields;  ///< indices into fields()
  std::optional<ProvenanceRequest> provenance;
  std::optional<std::string> file_column = {};     ///< the name of a first column with that of the input's file
  std::optional<TimeNotation> time_notation = {};  ///< nothing: that of the input
  std::optional<Rational> frame_rate = {};         ///< of timecode and frames
  std::optional<TimeZero> time_zero = {};          ///< from which times count
};

}  // namespace tcb
