// Arrangement: the size of a picture, and the boxes of its views.
#pragma once

#include <vector>

#include "plot/picture.hpp"
#include "plot/scene.hpp"
#include "plot/view.hpp"

namespace tcb {

/// Between the edge of the picture and its contents.
inline constexpr double picture_margin = 16;

/// The width of a picture of these channels.
double picture_width(const Scene& scene, const PictureSize& size);

struct Arrangement {
  double width = 0, height = 0;
  std::vector<View> views;        ///< the path, if there is one, then a strip per channel
  std::vector<ViewFrame> frames;  ///< one per view
  Box time_title;                 ///< below the strips
};

/// The path to the left, the strips to the right, in columns if there are many. `legend_height` is left free at the
/// bottom. Throws: Error (usage) if the channels need a larger picture.
Arrangement arranged(const Scene& scene, const SceneExtent& extent, const PictureSize& size, double legend_height);

}  // namespace tcb
