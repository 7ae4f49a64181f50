// Pictures of comparisons: the samples over the curve, their differences over time, and the worst place.
#pragma once

#include <string>
#include <vector>

#include "check/check.hpp"
#include "plot/picture.hpp"
#include "plot/scene.hpp"

namespace tcb {

/// Collects the curves of a comparison with their samples.
class CheckPicture {
 public:
  /// The options outlive this.
  explicit CheckPicture(const PictureOptions& options) : options_(options) {}

  /// Adds a curve with the samples that are on it. Throws: Error (data) if no position is compared.
  void add(const CheckedPair& pair);

  /// The picture as SVG, with the result in words. Throws: Error as picture() does.
  std::string svg(const ComparisonSummary& files, const std::string& result);

 private:
  void begin(const ComparisonInputs& inputs);
  void add_curve(const CheckedPair& pair);
  void add_samples(const CheckedPair& pair);

  const PictureOptions& options_;
  Scene scene_;
  std::vector<std::size_t> channels_;  ///< of the keys: those that are compared
  std::vector<std::size_t> given_;     ///< their columns in the table of samples
  double largest_ = 0;                 ///< difference so far
};

}  // namespace tcb
