// Positions of Synfig's animated values with waypoints of the kind TCB.
#include <synfig/general.h>
#include <synfig/type.h>
#include <synfig/valuenodes/valuenode_animated.h>
#include <synfig/waypoint.h>

#include <cstdlib>

#include "curve.hpp"

int main() {
  const Curve curve = read_curve();
  if (curve.closed) return unsupported;
  const auto since = [&](double time) { return synfig::Time(time - curve.keys.front().time); };
  synfig::Type::subsys_init();
  const auto animated = synfig::ValueNode_Animated::create(synfig::type_real);
  for (const Key& key : curve.keys) {
    const auto waypoint = animated->new_waypoint(since(key.time), synfig::ValueBase(synfig::Real(key.position)));
    waypoint->set_before(synfig::INTERPOLATION_TCB);
    waypoint->set_after(synfig::INTERPOLATION_TCB);
    waypoint->set_tension(key.tension);
    waypoint->set_continuity(key.continuity);
    waypoint->set_bias(key.bias);
  }
  animated->changed();
  for (const double time : curve.times) std::cout << (*animated)(since(time)).get(synfig::Real()) << '\n';
  std::cout.flush();
  std::_Exit(0);  // without the ends of a program that synfig began
}
