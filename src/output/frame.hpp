// Frames: the rows of several curves in one output, with what tells them apart and the labels that they carry.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/formats.hpp"
#include "output/layout.hpp"
#include "output/output_format.hpp"

namespace tcb {

/// The columns of an output: texts that tell curves apart, numbers, and labels.
struct OutputColumns {
  std::vector<std::string> groups;
  std::vector<OutputColumn> numbers;
  std::vector<std::string> labels;

  /// The names of all of them, in order.
  std::vector<std::string> names() const;
};

/// Everything around the numbers of the rows. Curves that a text tells apart have it in each row, or in JSON in an
/// object around their rows; where none does, a line without a row sets them apart: blank, or null in JSON.
class Frame {
 public:
  Frame() = default;
  /// Throws: Error (data) for texts in a format that holds numbers only.
  Frame(const Format& format, const OutputColumns& columns, bool header, const Notation& notation = {});

  /// Each curve is an object with its rows.
  bool is_nested() const { return nested_; }

  /// What stands before all rows.
  const std::string& head() const { return head_; }

  /// What takes its place once all rows are written, which have so many bytes; empty: nothing does.
  std::string counted_head(std::uint64_t bytes) const;

  /// What stands before the next curve's rows; its texts are in layout() from here on. `apart`: nothing else tells it
  /// from the curve before. Throws: Error (data) where the format has nothing to tell it apart.
  std::string begin(std::span<const std::string> group, bool apart);

  /// The layout of rows of the curve at hand, but for their labels.
  const Layout& layout() const { return rows_; }

  /// What ends a row with these labels, each a text as in texts.hpp.
  std::string row_end(std::span<const std::string_view> labels) const;

  /// No row of the list at hand was written, so that nothing goes between it and the next one.
  bool is_first() const { return !any_rows_; }
  void set_written() { any_rows_ = true; }

  /// What stands behind all rows.
  std::string tail();

 private:
  std::string end_curve() const;

  const Format* format_ = nullptr;
  const OutputFormat* written_ = nullptr;
  bool nested_ = false;
  Layout all_;   ///< with the texts of all columns in front of their cells
  Layout rows_;  ///< as append_rows takes it
  std::size_t groups_ = 0, numbers_ = 0;
  std::string head_;
  bool any_curves_ = false, any_rows_ = false;
};

}  // namespace tcb
