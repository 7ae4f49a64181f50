// Tables: someone's samples, as they stand in a file.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "input/input.hpp"

namespace tcb {

/// The rows of one curve. Shapes: numbers holds a number a column, row after row; a missing one is not a number.
struct SampleRows {
  std::vector<std::string> group;  ///< what tells the curve apart, texts as in texts.hpp
  std::vector<spline::Time<double>> times;
  std::vector<double> numbers;
  std::vector<std::uint64_t> lines;

  std::size_t size() const { return lines.size(); }
};

struct SampleTable {
  bool named = false;                 ///< its columns have names
  bool timed = false;                 ///< it has times
  std::string time;                   ///< name of their column
  std::vector<std::string> columns;   ///< names of all other columns of numbers
  std::vector<std::string> left_out;  ///< and of those of text
  std::vector<SampleRows> curves;
};

/// What reading samples of these keys is told: `timeless` where a file without names does not begin with the time.
InputOptions table_options(const Input& keys, bool timeless, unsigned threads);

/// Reads a file to its end; every format, header and decimal mark is found as those of keys are, and the mark is a
/// comma where cells are apart by semicolons or tabs and no number has a point.
/// Throws: Error.
SampleTable read_table(const std::string& path, InputOptions options);

}  // namespace tcb
