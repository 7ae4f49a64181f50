// From keys to measured pieces of the curve: checked, linked to segments, and measured where lengths matter.
#pragma once

#include <memory>
#include <vector>

#include "format/input.hpp"
#include "spline/curve.hpp"
#include "stream.hpp"

namespace tcb {

using Keys = spline::Keys<double>;

/// Which curve the keys make, and what its lengths are over.
struct CurvePlan {
  spline::CurveRules rules;
  std::vector<std::size_t> metric;  ///< channels that lengths are over; empty: all
};

/// Successive segments with their lengths.
struct Stretch {
  spline::Segments<double> segments;
  std::vector<double> lengths;  ///< one a segment, or none where nobody asked
  bool last = false;            ///< the curve ends here
};

/// The keys, once it is seen that there are two at least and that their times increase.
/// Throws: Error (data) naming both rows.
Source<Keys> increasing(Source<format::KeyBlock> blocks);

/// The segments between the keys, each as soon as the key after its end has come.
Source<Stretch> stretches(Source<Keys> keys, const CurvePlan& plan, bool measured);

/// Keys that were read to the end, to be gone through more than once.
class KeptKeys {
 public:
  explicit KeptKeys(const Source<Keys>& keys);
  Source<Keys> source() const;
  const spline::Time<double>& last_time() const { return blocks_->back().times.back(); }

 private:
  std::shared_ptr<std::vector<Keys>> blocks_;
};

/// The length of the whole curve.
double total_length(const Source<Stretch>& measured);

}  // namespace tcb
