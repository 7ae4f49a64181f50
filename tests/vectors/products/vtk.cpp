// Positions of VTK's vtkKochanekSpline, which has one tension, continuity and bias for all keys.
#include <vtkKochanekSpline.h>
#include <vtkNew.h>

#include "curve.hpp"

int main() {
  const Curve curve = read_curve();
  const Key& first = curve.keys.front();
  vtkNew<vtkKochanekSpline> spline;
  spline->SetDefaultTension(first.tension);
  spline->SetDefaultContinuity(first.continuity);
  spline->SetDefaultBias(first.bias);
  if (curve.closed) spline->ClosedOn();
  if (curve.closed) spline->SetParametricRange(first.time, curve.keys.back().time);
  for (std::size_t i = 0; i < curve.keys.size() - curve.closed; ++i) {
    const Key& key = curve.keys[i];
    if (key.tension != first.tension || key.continuity != first.continuity || key.bias != first.bias)
      return unsupported;
    spline->AddPoint(key.time, key.position);
  }
  for (const double time : curve.times) std::cout << spline->Evaluate(time) << '\n';
}
