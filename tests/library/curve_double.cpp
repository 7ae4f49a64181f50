// Defines the curve that tour.cpp declares.
#include <tcb/spline/spline.hpp>

template class tcb::spline::Curve<double>;
