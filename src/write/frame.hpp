// Frame: the texts around the rows of all curves of an output.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "numbers/print_number.hpp"
#include "sample/table.hpp"
#include "schema/format.hpp"
#include "write/layout.hpp"

namespace tcb {

class RowKeeper;

/// The columns of an output: texts that identify curves, numbers, and labels.
struct OutputColumns {
  std::vector<std::string> groups;
  std::vector<OutputColumn> numbers;
  std::vector<std::string> labels;

  /// The names of all of them, in order.
  std::vector<std::string> names() const;
};

/// The options of a frame besides the columns.
struct FrameOptions {
  const Format* format = nullptr;
  bool header = true;
  Notation notation = {};
  bool has_member = false;            ///< in JSON: the output is an object, with another member after the rows
  TextMarks marks = {};               ///< of delimited text
  const RowKeeper* keeper = nullptr;  ///< that completes the texts
};

/// Everything around the numbers of the rows. The group of a curve is in cells of each of its rows, or in JSON in an
/// object around its rows. Curves of the same group are divided by a line without a row: empty, or null in JSON.
class Frame {
 public:
  Frame() = default;
  /// Throws: Error (data) for texts in a format of numbers only.
  Frame(const OutputColumns& columns, const FrameOptions& options);

  /// The text before all rows.
  const std::string& head() const { return head_; }

  /// The text that replaces the head once all rows, of so many bytes, are written; empty: none.
  std::string counted_head(std::uint64_t bytes) const;

  /// The text before the next curve's rows. `divided`: the previous curve has the same group.
  /// Throws: Error (data) if the format cannot divide curves.
  std::string begin(std::span<const std::string> group, bool divided);

  /// The layout of rows of the current curve, without their labels.
  const Layout& layout() const { return rows_; }

  /// The text after a row with these labels, each a text as in schema/texts.hpp.
  std::string row_end(std::span<const std::string_view> labels) const;

  /// Whether the current list has no row yet.
  bool is_first() const { return !any_rows_; }
  void set_written() { any_rows_ = true; }

  /// The text after all rows. `member`: the other member, if there is one.
  std::string tail(std::string_view member = {}) const;

 private:
  std::string end_curve() const { return (any_rows_ ? rows_.tail : rows_.no_rows) + "}"; }

  FrameOptions options_;
  TextMarks marks_;
  bool nested_ = false;  ///< each curve is an object with its rows
  Layout all_;           ///< with the texts of all columns before their cells
  Layout rows_;          ///< as append_rows takes it
  std::size_t groups_ = 0, numbers_ = 0;
  std::string head_;
  bool any_curves_ = false, any_rows_ = false;
};

}  // namespace tcb
