// Positions of lib3ds 1, which has single precision and whole times: here 1/32.
#include <lib3ds/tracks.h>

#include "curve.hpp"

int main() {
  const Curve curve = read_curve();
  if (curve.closed) return unsupported;
  const auto frame = [&](double time) { return (time - curve.keys.front().time) * 32; };
  Lib3dsLin1Track track{0, nullptr};
  for (const Key& key : curve.keys) {
    Lib3dsLin1Key* k = lib3ds_lin1_key_new();
    k->tcb.frame = static_cast<int>(frame(key.time));
    k->tcb.tens = key.tension, k->tcb.cont = key.continuity, k->tcb.bias = key.bias;
    k->value = key.position;
    lib3ds_lin1_track_insert(&track, k);
  }
  lib3ds_lin1_track_setup(&track);
  for (const double time : curve.times) {
    float position = 0;
    lib3ds_lin1_track_eval(&track, &position, frame(time));
    std::cout << position << '\n';
  }
}
