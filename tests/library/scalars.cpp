// Every member of the curve compiles without a warning at each kind of scalar: float, double, exact, many digits.
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_int.hpp>
#include <tcb/spline/spline.hpp>

namespace multiprecision = boost::multiprecision;
using Exact = multiprecision::number<multiprecision::cpp_rational_backend, multiprecision::et_off>;
using Long = multiprecision::number<multiprecision::cpp_bin_float<60>, multiprecision::et_off>;

template class tcb::spline::Curve<float>;
template class tcb::spline::Curve<double>;
#if !defined(__clang__) || __clang_major__ >= 16  // older ones also instantiate members whose constraints are not met
template class tcb::spline::Curve<Exact>;
#endif
template class tcb::spline::Curve<Long>;
template class tcb::spline::CurveStream<float>;
template class tcb::spline::CurveStream<double>;
template class tcb::spline::CurveStream<Exact>;
template class tcb::spline::CurveStream<Long>;
