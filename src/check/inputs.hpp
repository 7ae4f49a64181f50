// Inputs of a comparison: curves with their keys in memory, samples, and which of their columns are compared.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "check/compare_job.hpp"
#include "error.hpp"
#include "keys/curves.hpp"
#include "run/progress.hpp"
#include "sample/table.hpp"
#include "schema/key_block.hpp"
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
  /// Appends a row of others.
  void add(const SampleRows& from, std::size_t i) {
    if (!from.times.empty()) times.push_back(from.times[i]);
    const std::span<const double> row = from.row(i);
    numbers.insert(numbers.end(), row.begin(), row.end());
    lines.push_back(from.lines[i]);
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
};

/// Reads samples of the curves of `keys` from the bytes of `comparison.file`, to its end. Format, header and delimiter
/// are detected as in keys; the decimal mark is a comma if cells are separated by semicolons or tabs and no number has
/// a point. `time_place`: in a file without names, how many columns are before the time, without groups; nothing: none
/// is the time. Throws: Error.
SampleTable read_samples(const Comparison& comparison, Source<std::string> bytes, const Schema& keys,
                         std::optional<std::size_t> time_place);

/// A column of the samples that is also one of the curve's rows.
struct MatchedColumn {
  std::string name;
  std::size_t given;     ///< index into SampleTable::columns
  std::size_t computed;  ///< index into the cells of a row with the chosen fields
};

struct MatchedColumns {
  std::vector<std::size_t> fields;  ///< indices into fields(), whose cells make a row of the curve
  std::vector<MatchedColumn> compared;
  std::vector<std::array<std::size_t, 4>> rotations = {};  ///< indices into compared, of the numbers of each
  std::vector<std::pair<std::size_t, bool>> angles = {};   ///< index into compared, and whether it is in degrees
  std::optional<std::size_t> place;   ///< index into SampleTable::columns: the places of the samples, if not the times
  bool by_length = false;             ///< the places are arc lengths
  std::vector<std::string> ignored;   ///< names of columns that are intentionally not compared
  std::vector<std::string> problems;  ///< of columns that are missing or unknown

  /// Negates computed quaternions and turns computed angles by whole turns where that is nearer to the given row, as
  /// these are the same.
  void align(std::span<Cell> computed, std::span<const double> given_row) const;
};

/// Matches columns with the given fields, or if none are given, with all fields whose columns the table names. A
/// table without names has the columns of the given fields, or else the time and the positions.
/// Throws: Error (data) if nothing can be compared.
MatchedColumns match_columns(const SampleTable& table, const Schema& keys, const std::vector<std::size_t>& given);

/// A curve whose keys can be read more than once.
struct KeptKeys {
  std::vector<std::string> group;
  std::shared_ptr<const CurveInfo> curve_info;
  std::vector<KeyBlock> blocks;
  std::optional<CurvePart> part = {};  ///< of a curve that gaps divide

  /// The curve must outlive the source.
  Source<KeyBlock> keys() const;
};

/// All curves of an input.
struct KeptInput {
  Schema schema;
  KeyTraits traits;
  std::vector<KeptKeys> curves;
  std::optional<CountedFrom> zero = {};  ///< from which their times count, and those of the samples
};

/// Reads the curves from the bytes of `comparison.keys_file`. Throws: Error.
KeptInput keep_input(const Comparison& comparison, Source<std::string> bytes);

/// The error of samples without a column of positions; `channels`: those of the keys.
Error no_position_column(const std::vector<std::string>& channels);

/// Both files of a comparison.
struct ComparisonInputs {
  KeptInput kept;
  SampleTable table;
  MatchedColumns columns;
  std::string keys, file;  ///< names of the files of keys and of samples for messages
  unsigned threads = 1;
  FileProgress* progress = nullptr;  ///< of both files, if it is shown

  /// The column that holds the places of the samples.
  std::string place_name() const { return columns.by_length ? "s" : kept.schema.time.name; }
};

/// Reads both files and matches the columns; `chosen` as for match_columns. `progress` counts the bytes, unless it is
/// null. Throws: Error, naming the file.
ComparisonInputs read_inputs(const Comparison& comparison, const std::vector<std::size_t>& chosen,
                             FileProgress* progress = nullptr);

}  // namespace tcb
