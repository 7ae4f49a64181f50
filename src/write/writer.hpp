// Writer: one output with its frames and rows.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/atomic_output.hpp"
#include "numbers/decimal_time.hpp"
#include "sample/table.hpp"
#include "schema/schema.hpp"
#include "stream/source.hpp"
#include "write/layout.hpp"
#include "write/output_format.hpp"
#include "write/provenance.hpp"
#include "write/shown_times.hpp"
#include "write/writer_options.hpp"

namespace tcb {

struct LabelledBlock;

/// The columns of an output: texts that identify curves, numbers, and labels.
struct OutputColumns {
  std::vector<std::string> groups;
  std::vector<OutputColumn> numbers;
  std::vector<std::string> labels;

  /// The names of all of them, in order.
  std::vector<std::string> names() const;
};

/// One output of the rows of one file or of several. The group of a curve is in cells of each of its rows, or in JSON
/// in an object around its rows. Curves of the same group are divided by a line without a row: empty, or null in JSON.
class Writer {
 public:
  /// Requires: the options outlive the writer.
  Writer(const WriterOptions& options, std::string path)
      : options_(options), output_(std::move(path), options.format->is_binary), recorder_(options.provenance) {}

  /// The recorder of the output's provenance, to be attached to the sources of its rows.
  ProvenanceRecorder& recorder() { return recorder_; }

  /// Begins the rows of the next file; `rules` are those of its first curve. Throws: Error (data) where they have
  /// other columns than the rows before. `file` is for a column of files.
  void begin(const Schema& schema, bool live, Facts rules, const std::string& file = {});

  /// What the format keeps of the rows; null: they are only printed.
  RowKeeper* keeper() { return keeper_.get(); }

  /// Begins the rows of the next curve of the file.
  void begin_curve(std::vector<std::string> group, const std::optional<EulerTrack>& euler = {});

  /// The text of some rows; from any thread until the next begin_curve().
  std::string print(const Table& table, bool first) const;

  std::string print(const LabelledBlock& block, const Evaluate& evaluate) const;

  /// The text after a row with these labels, each a text as in schema/texts.hpp.
  std::string row_end(std::span<const std::string_view> labels) const;

  void write(const Source<std::string>& rows);

  /// Ends the output. Throws: Error (usage) if it cannot be completed.
  void commit();

 private:
  /// Sets the texts around rows and cells, and returns that before all rows. Throws: Error (data) for texts in a format
  /// of numbers only.
  std::string set_layouts(bool header);
  /// The text before the rows of the next curve. Throws: Error (data) if the format cannot divide curves.
  std::string text_before(std::span<const std::string> group);
  std::string end_of_curve() const { return (any_rows_ ? rows_.tail : rows_.no_rows) + "}"; }
  /// The text after all rows. `member`: another member of an object around them, if there is one.
  std::string tail(std::string_view member = {}) const;

  const WriterOptions& options_;
  Output output_;
  OutputColumns columns_;
  std::size_t cells_ = 0;               ///< of a row
  std::vector<PrintedColumn> printed_;  ///< the columns of numbers
  std::unique_ptr<RowKeeper> keeper_;   ///< of the format; null: rows are only printed
  ShownTimes times_;
  TextMarks marks_;
  bool nested_ = false;    ///< each curve is an object with its rows
  Layout all_;             ///< with the texts of all columns before their cells
  Layout rows_;            ///< of rows of the current curve, without their labels
  bool any_rows_ = false;  ///< in the current list
  ProvenanceRecorder recorder_;
  std::optional<std::vector<std::string>> group_;  ///< of the curve before
  std::string file_;                               ///< the current one, as a text of a key
  std::uint64_t bytes_ = 0;                        ///< of all rows
};

}  // namespace tcb
