// Sample table: a file of samples, read into memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "check/comparison.hpp"
#include "read/earlier_output.hpp"
#include "schema/schema.hpp"
#include "stream/source.hpp"

namespace tcb {

/// The samples of one curve. `numbers` has a number for each column, row after row; a missing one is NaN.
struct SampleRows {
  std::vector<std::string> group;  ///< texts as in schema/texts.hpp
  std::vector<spline::Time<double>> times;
  std::vector<double> numbers;
  std::vector<std::uint64_t> lines;

  std::size_t size() const { return lines.size(); }
  std::span<const double> row(std::size_t i) const {
    const std::size_t width = numbers.size() / size();
    return std::span(numbers).subspan(i * width, width);
  }
};

/// The samples of a file.
struct SampleTable {
  bool named = false;                ///< its columns have names
  bool timed = false;                ///< it has times
  std::string time;                  ///< name of their column
  std::vector<std::string> columns;  ///< names of all other columns of numbers
  std::vector<std::string> ignored;  ///< names of the columns of text
  std::vector<SampleRows> curves;
  std::optional<EarlierOutput> provenance = {};  ///< if it is read
};

/// Reads samples of the curves of `keys` from the bytes of `comparison.file`, to its end. Format, header and delimiter
/// are detected as in keys; the decimal mark is a comma if cells are separated by semicolons or tabs and no number has
/// a point. `time_place`: in a file without names, how many columns are before the time, without groups; nothing: none
/// is the time. Throws: Error.
SampleTable read_samples(const Comparison& comparison, Source<std::string> bytes, const Schema& keys,
                         std::optional<std::size_t> time_place);

}  // namespace tcb
