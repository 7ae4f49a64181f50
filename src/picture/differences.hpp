// Pictures of differences: samples over a curve, their differences from it over time, and the largest of these.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "picture/picture.hpp"
#include "picture/scene.hpp"

namespace tcb {

/// A sample and the numbers of the curve at its time, for each channel that is drawn.
struct ComparedSample {
  Time t;
  std::vector<double> given, computed;
};

/// Collects curves with their samples.
class DifferencePicture {
 public:
  /// The options outlive this.
  explicit DifferencePicture(const PictureOptions& options) : options_(options) {}

  bool has_begun() const { return !channels_.empty(); }
  /// Whether further curves are not drawn.
  bool is_full() const { return scene_.curves.size() + 2 > Scene::most_curves; }

  /// Begins the picture of some channels of curves, by their numbers in `keys`. `curves` and `samples` are names of
  /// files. Throws: Error (usage) for axes that do not exist and too many strips.
  void begin(const Schema& keys, std::vector<std::size_t> channels, const std::string& curves,
             const std::string& samples);

  /// Adds a curve of all channels, and samples of those that are drawn.
  void add(const KeyStore& keys, const std::function<Source<SegmentBlock>()>& segments, bool closed,
           std::vector<ComparedSample> samples);

  /// The picture as SVG, with the result in words. Throws: Error as picture() does.
  std::string svg(const std::string& curves, const std::string& samples, const std::string& result);

 private:
  void add_curve(const KeyStore& store, const std::function<Source<SegmentBlock>()>& segments, bool closed);
  void add_samples(std::vector<ComparedSample> samples);

  const PictureOptions& options_;
  Scene scene_;
  std::vector<std::size_t> channels_;  ///< of the keys: those that are drawn
  double largest_ = 0;                 ///< difference so far
};

}  // namespace tcb
