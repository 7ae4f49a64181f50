// The writer: one output with the texts around the rows of files and curves, and the rows themselves.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "input/input.hpp"
#include "io/atomic_output.hpp"
#include "output/labels.hpp"
#include "output/layout.hpp"
#include "output/provenance.hpp"

namespace tcb {

/// What an output looks like.
struct WriterOptions {
  FormatId format = FormatId::csv;
  std::optional<bool> header;       ///< nothing: as the input has one
  Notation notation;                ///< of numbers that may have a fraction
  std::vector<std::size_t> fields;  ///< indices into fields()
  std::optional<ProvenanceRequest> provenance;
};

/// One output of the rows of one file or of several.
class Writer {
 public:
  /// The options outlive the writer.
  Writer(const WriterOptions& options, std::string path)
      : options_(options),
        output_(std::move(path), format_of(options.format).is_binary),
        recorder_(options.provenance) {}

  /// The recorder of the output's provenance, to be attached to the sources of its rows.
  ProvenanceRecorder& recorder() { return recorder_; }

  /// Begins the rows of the next file; `rules` are those of its first curve. Throws: Error (data) where they have
  /// other columns than the rows before.
  void begin(const Input& input, bool live, Facts rules);

  /// Begins the rows of the next curve of the file.
  void begin_curve(const std::vector<std::string>& group);

  /// The text of some rows. A pure function until the next begin_curve().
  std::string print(const Table& table, bool first) const;

  /// The same for rows with labels.
  std::string print(const LabelledBlock& block, const Evaluate& evaluate) const;

  std::string row_end(std::span<const std::string_view> labels) const { return frame_.row_end(labels); }

  /// Writes the rows of a curve.
  void write(const Source<std::string>& rows);

  /// Ends the output. Throws: Error (usage) if it cannot be completed.
  void commit();

 private:
  const WriterOptions& options_;
  Output output_;
  OutputColumns columns_;
  Frame frame_;
  ProvenanceRecorder recorder_;
  std::optional<std::vector<std::string>> group_;  ///< of the curve before
  std::uint64_t bytes_ = 0;                        ///< of all rows
};

}  // namespace tcb
