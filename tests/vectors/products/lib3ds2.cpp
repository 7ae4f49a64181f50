// Positions of lib3ds 2, from the plugin of OpenSceneGraph that contains it; single precision and whole times: here
// 1/32.
#include <dlfcn.h>

#include "curve.hpp"

struct Lib3dsKey {
  int frame;
  unsigned flags;
  float tens, cont, bias, ease_to, ease_from, value[4];
};
struct Lib3dsTrack {
  unsigned flags;
  int type, nkeys;
  Lib3dsKey* keys;
};

int main() {
  const Curve curve = read_curve();
  void* const plugin = dlopen(LIBRARY "osgPlugins-3.6.5/osgdb_3ds.so", RTLD_LAZY);
  if (curve.closed || !plugin) return unsupported;
  const auto make = reinterpret_cast<Lib3dsTrack* (*)(int, int)>(dlsym(plugin, "lib3ds_track_new"));
  const auto eval = reinterpret_cast<void (*)(Lib3dsTrack*, float*, float)>(dlsym(plugin, "lib3ds_track_eval_float"));
  const auto frame = [&](double time) { return (time - curve.keys.front().time) * 32; };
  Lib3dsTrack* const track = make(1, static_cast<int>(curve.keys.size()));
  for (std::size_t i = 0; i < curve.keys.size(); ++i) {
    const Key& key = curve.keys[i];
    track->keys[i] = Lib3dsKey{static_cast<int>(frame(key.time)),
                               7,
                               static_cast<float>(key.tension),
                               static_cast<float>(key.continuity),
                               static_cast<float>(key.bias),
                               0,
                               0,
                               {static_cast<float>(key.position)}};
  }
  for (const double time : curve.times) {
    float position = 0;
    eval(track, &position, frame(time));
    std::cout << position << '\n';
  }
}
