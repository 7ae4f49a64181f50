// Picture: the views of a scene with their curves, titles and the legend, as SVG of a bounded size.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace tcb {

struct Scene;

/// The size of a picture; 0: as required by the contents.
struct PictureSize {
  int width = 0, height = 0;
};

/// How curves are drawn.
struct PictureOptions {
  std::vector<std::string> axes;     ///< two channels by name or number; none: the first two metric ones
  std::optional<std::string> title;  ///< nothing: the name of the file
  PictureSize size;
};

/// The picture as SVG: at most 300 kB, and the same bytes everywhere.
/// Throws: Error (data) as extent_of(), Error (usage) if the channels need a larger picture.
std::string picture(Scene scene, const PictureSize& size);

}  // namespace tcb
