// Fields: what a row can show of a point of the curve.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "input/input.hpp"
#include "output/layout.hpp"
#include "sampling/sampler.hpp"
#include "tcb/spline/arc_length.hpp"
#include "tcb/spline/derivatives.hpp"

namespace tcb {

/// A sample on its piece, and what is worked out there, once and only if it is asked for. It looks into both.
class Point {
 public:
  /// On another piece; a sample on it is to follow.
  void set(const CurveSegment& piece);
  /// `outside`: how its time relates to one on the curve; null: it is on the curve.
  void set(const Sample& sample, const Outside* outside);

  const CurveSegment& piece() const { return *piece_; }
  const Sample& sample() const { return *sample_; }
  const Outside* outside() const { return outside_; }
  const spline::ArcLength<double>& arc();
  const spline::Derivatives<double>& motion();
  const spline::Shape<double>& shape();

 private:
  const CurveSegment* piece_ = nullptr;
  const Sample* sample_ = nullptr;
  const Outside* outside_ = nullptr;
  spline::ArcLength<double> arc_;
  bool has_arc_ = false;
  spline::Derivatives<double> motion_;
  bool has_motion_ = false;
  std::optional<spline::Shape<double>> shape_;
};

/// To add a field: a row of the table in fields.cpp.
struct Field {
  std::string_view name;
  std::string_view suffix;  ///< of a column's name, for a field with a column for each channel
  CellKind kind;
  bool per_channel;                         ///< a column for each channel, named after it; otherwise one
  bool needs_lengths;                       ///< the segments before it have to be measured
  bool over_metric;                         ///< it is a length or a speed over the metric channels
  bool has_side;                            ///< at a key it may differ from one side to the other
  Cell* (*write)(Cell* row, Point& point);  ///< answers the end of its cells

  /// The same of all samples on a piece, in rows of `width` cells, where that saves time. Requires: they are on the
  /// curve, none outside.
  void (*write_column)(Cell* first, std::size_t width, const CurveSegment& piece,
                       std::span<const Sample> samples) = nullptr;
};

std::span<const Field> fields();

/// How many cells the chosen fields have in a row.
std::size_t cells_in_row(std::span<const std::size_t> chosen, std::size_t channels);

/// Writes the chosen fields of the samples on a piece, row after row. `point` is memory that may be used again.
void write_rows(Cell* rows, std::span<const std::size_t> chosen, const CurveSegment& piece, const Located& located,
                Point& point);

/// The columns that the chosen fields make.
std::vector<OutputColumn> output_columns(std::span<const std::size_t> chosen, const Input& input);

}  // namespace tcb
