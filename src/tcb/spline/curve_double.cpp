// The templates of a curve of doubles, compiled once for all sources of a target that links tcb::spline.
#include "tcb/spline/curve.hpp"

namespace tcb::spline {

template Segments<double> segments(const Window<double>& window, const CurveRules<double>& rules);
template class CurveKeys<double>;
template class Curve<double>;

}  // namespace tcb::spline
