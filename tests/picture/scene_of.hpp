// Scenes of curves through given keys, for tests of pictures.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "picture/scene.hpp"
#include "sample/build.hpp"

namespace tcb {

/// A curve through keys with the rules of the default preset.
inline SceneCurve scene_curve(const Keys& keys, std::size_t name = 0) {
  const KeyStore store(keys);
  const StreamedCurve streamed{store, {}, make_spec({}).rules, {}};
  const auto segments = [streamed] { return streamed.segments(); };
  return {name, store, segments};
}

inline Keys keys_of(std::vector<Time> times, std::vector<double> positions) {
  Keys keys;
  keys.channels = positions.size() / times.size();
  keys.times = std::move(times);
  keys.positions = std::move(positions);
  return keys;
}

/// Four keys of a path with a height.
inline Scene small_scene() {
  Scene scene;
  scene.title = "keys <&>.csv";
  scene.subtitle = "preset gte";
  scene.time = "time";
  scene.channels = {"x", "y", "z [m]"};
  scene.names = {"a"};
  scene.path = {0, 1};
  scene.curves.push_back(scene_curve(keys_of({0, 1, 2, 4}, {0, 0, 1, 2, 1, 1, 4, 2, 2, 0, 4, 9})));
  return scene;
}

}  // namespace tcb
