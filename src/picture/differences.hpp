// Pictures of differences: samples over a curve, their differences from it over time, and the largest of these.
//
// The scene has the channels that are drawn, and after them a channel for each of their differences, in which the curve
// is 0. The samples are a curve of their own: a polyline through them.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "picture/picture.hpp"
#include "picture/scene.hpp"

namespace tcb {

struct StreamedCurve;

/// A sample and the numbers of the curve at its time, for each channel that is drawn.
struct ComparedSample {
  Time t;
  std::vector<double> given, computed;
};

/// Collects curves with their samples.
class DifferencePicture {
 public:
  /// `curves` and `samples` are names of files. The options outlive this.
  DifferencePicture(const PictureOptions& options, const std::string& curves, const std::string& samples);

  bool has_begun() const { return !channels_.empty(); }
  /// Whether further curves are not drawn.
  bool is_full() const { return scene_.curves.size() + 2 > Scene::most_curves; }

  /// Begins the picture of some channels of curves, by their numbers in `keys`. Throws: Error (usage) for axes that do
  /// not exist and too many strips.
  void begin(const Schema& keys, std::vector<std::size_t> channels);

  /// Adds a curve of all channels, and samples of those that are drawn.
  void add(const StreamedCurve& curve, const CurveChannels& channels, std::vector<ComparedSample> samples);

  /// The picture as SVG, with the result in words. Throws: Error as picture() does.
  std::string svg(const std::string& result);

 private:
  void add_curve(const StreamedCurve& curve, const CurveChannels& channels);
  void add_samples(std::vector<ComparedSample> samples);

  const PictureOptions& options_;
  std::string curves_, samples_;  ///< names of the files
  Scene scene_;
  std::vector<std::size_t> channels_;  ///< of the keys: those that are drawn
  double largest_ = 0;                 ///< difference so far
};

}  // namespace tcb
