// Inputs of a comparison: curves with their keys in memory, samples, and their columns that are compared.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "check/comparison.hpp"
#include "check/matched_columns.hpp"
#include "check/sample_table.hpp"
#include "run/progress.hpp"
#include "schema/input_keys.hpp"
#include "schema/schema.hpp"
#include "stream/source.hpp"

namespace tcb {

/// A curve whose keys can be read more than once.
struct KeptCurve {
  std::vector<std::string> group;
  std::shared_ptr<const CurveInfo> curve_info;
  std::vector<KeyBlock> blocks;

  /// The curve must outlive the source.
  Source<KeyBlock> keys() const;
  std::size_t key_count() const;
};

/// All curves of an input.
struct KeptCurves {
  Schema schema;
  KeyTraits traits;
  std::vector<KeptCurve> curves;
};

/// Reads the curves from the bytes of `comparison.keys_file`. Throws: Error.
KeptCurves keep_curves(const Comparison& comparison, Source<std::string> bytes);

/// Both files of a comparison.
struct ComparisonInputs {
  KeptCurves kept;
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
