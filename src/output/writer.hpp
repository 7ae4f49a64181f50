// The writer of one output: what stands around the rows of files and curves, and the rows themselves.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/job.hpp"
#include "io/file.hpp"
#include "output/frame.hpp"
#include "output/labels.hpp"
#include "output/provenance_recorder.hpp"

namespace tcb {

/// One output, which takes the rows of one file or of several.
class Writer {
 public:
  Writer(const Job& plan, std::string path)
      : plan_(plan), output_(std::move(path), format_of(plan.output_format).is_binary), recorder_(plan.meta) {}

  /// What the output's provenance says is told to it.
  ProvenanceRecorder& recorder() { return recorder_; }

  /// The next file's rows follow, the first of them on a curve with these rules. Throws: Error (data) where they have
  /// other columns than the rows before.
  void begin(const Input& input, bool live, Facts rules);

  /// The rows of the next curve of the file follow.
  void begin_curve(const std::vector<std::string>& group);

  /// The text of some rows. A pure function but for the layout, which begin_curve() has set.
  std::string print(const Table& table, bool first) const;

  /// The same for rows that end in labels.
  std::string print(const LabelledBlock& batch, const Evaluate& evaluate) const;

  std::string row_end(std::span<const std::string_view> labels) const { return frame_.row_end(labels); }

  /// Writes the rows of a curve as they come.
  void write(const Source<std::string>& rows);

  /// All rows are written. Throws: Error (usage) if the output cannot be completed.
  void commit();

 private:
  const Job& plan_;
  Output output_;
  OutputColumns columns_;
  Frame frame_;
  ProvenanceRecorder recorder_;
  std::optional<std::vector<std::string>> group_;  ///< of the curve before
  std::uint64_t bytes_ = 0;                        ///< of all rows
};

}  // namespace tcb
