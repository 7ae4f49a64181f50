// Samples on a grid of times or of arc lengths: what the two have in common.
#pragma once

#include "sampling/bounds.hpp"
#include "sampling/sampler.hpp"

namespace tcb {

class OnGrid : public Sampler {
 public:
  OnGrid(const SamplingRequest& request, Spacing spacing);

  Run place(const CurveSegment& piece) override;
  bool done() const override { return done_; }
  std::optional<Rational> left_out() const override { return left_out_; }

 protected:
  /// A block of the coordinate that the grid is on.
  struct Range {
    Time start, end;
  };

  /// The piece's block of the coordinate, and the names of the curve's ends for messages.
  virtual Range range(const CurveSegment& piece) const = 0;
  virtual Bound lower(const Range& range) const = 0;
  virtual Bound upper(const Range& range) const = 0;

  /// Puts the coordinates of some rows on this piece in the place of others.
  void set_coordinates(const CurveSegment& piece, std::uint64_t first, std::uint64_t last,
                       std::vector<Time>& coordinates) const;

 private:
  void require_bounds(const CurveSegment& piece, const Range& on) const;
  std::uint64_t rows_up_to(const CurveSegment& piece, const Range& on, const Time& stop, bool final) const;
  void add_keys(Run& run, const Range& on, const Time& stop, bool final) const;
  void finish(const Run& run, const Time& stop);

  Spacing spacing_;
  EndPolicy policy_;
  bool keys_, from_left_;
  std::uint64_t max_rows_;
  bool cut_;   ///< the request says where to end
  Time near_;  ///< a row this near to a key is that key
  std::uint64_t next_ = 0;
  bool done_ = false;
  std::optional<Rational> left_out_;
};

}  // namespace tcb
