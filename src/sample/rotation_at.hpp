// The rotations of a point of a curve, and how fast they turn, also outside the curve.
#pragma once

#include <cstddef>

#include "sample/curve_segment.hpp"
#include "tcb/spline/rotation.hpp"

namespace tcb {

/// A rotation at a sample on a segment, and its rate there.
template <class S>
class RotationAt {
 public:
  /// `u`: the elapsed fraction of the segment's duration. `part`: of its ease. `outside`: null on the curve.
  RotationAt(const CurveSegmentOf<S>& segment, std::size_t index, const SampleOf<S>& sample, const S& u,
             spline::EasePart part, const OutsideOf<S>* outside)
      : segment_(segment), index_(index), sample_(sample), u_(u), part_(part), outside_(outside) {}

  /// The quaternion. Outside the curve, `linear` keeps turning at the rate of the end, `offset` adds the turn of the
  /// whole curve once per period, and `repeat` negates the quaternion in odd periods where its sign would jump.
  spline::Quaternion<S> value() const {
    const spline::Quaternion<S> q = segment_.rotations[index_].at(sample_.at);
    if (outside_ == nullptr) return q;
    const S beyond = spline::high_part<S>(outside_->beyond);
    if (beyond != S(0)) {
      const auto rate = rate_on_curve();
      const S half = beyond / S(2);
      return spline::normalized(spline::exponential<S>({rate[0] * half, rate[1] * half, rate[2] * half}) * q);
    }
    if (outside_->odd && segment_.turns[index_].w < S(0)) return -q;
    return outside_->cycles == S(0) ? q : spline::normalized(cycles() * q);
  }

  /// The angular velocity, in the frame in which the rotation is given, per unit of time.
  spline::Vector3<S> rate() const {
    spline::Vector3<S> rate{S(0), S(0), S(0)};
    if (segment_.start == segment_.end || (outside_ != nullptr && outside_->holds)) return rate;
    rate = rate_on_curve();
    if (outside_ == nullptr) return rate;
    if (outside_->backward) return {-rate[0], -rate[1], -rate[2]};
    if (outside_->cycles == S(0)) return rate;
    const spline::Quaternion<S> turn = cycles();
    const auto turned = turn * spline::Quaternion<S>{rate[0], rate[1], rate[2], S(0)} * spline::conjugate(turn);
    return {turned.x, turned.y, turned.z};
  }

 private:
  spline::Vector3<S> rate_on_curve() const {
    const S du = segment_.warp.first_derivative(u_, part_) / spline::high_part<S>(segment_.duration());
    const auto rate = segment_.rotations[index_].rate(sample_.at);
    return {rate[0] * du, rate[1] * du, rate[2] * du};
  }
  spline::Quaternion<S> cycles() const {
    const auto turn = spline::logarithm(segment_.turns[index_]);
    const S& count = outside_->cycles;
    return spline::exponential<S>({turn[0] * count, turn[1] * count, turn[2] * count});
  }

  const CurveSegmentOf<S>& segment_;
  std::size_t index_;
  const SampleOf<S>& sample_;
  S u_;
  spline::EasePart part_;
  const OutsideOf<S>* outside_;
};

}  // namespace tcb
