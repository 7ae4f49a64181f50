// Legend: what the colours and the marks of a picture mean, in lines below its views.
#pragma once

#include <string>
#include <vector>

#include "plot/scene.hpp"
#include "plot/svg.hpp"
#include "plot/view.hpp"

namespace tcb {

/// The class of a curve's colour and dashes.
std::string colour_of(std::size_t name);

/// Marks that no view has, because there are too many.
struct HiddenMarks {
  bool keys = false, samples = false;
};

/// Entries side by side, in as many lines as the width requires.
class Legend {
 public:
  Legend(const Scene& scene, double width) : scene_(scene), width_(width) {}

  /// The height of the legend with every mark.
  double height() const;
  /// Draws the marks that the picture has, and the names.
  void draw(Svg& svg, const Pixel& corner, const Marks& marks, const HiddenMarks& hidden) const;

 private:
  enum class Symbol { none, curve, key, corner, tangent, sample, worst, axis_x, axis_y, axis_z };
  struct Entry {
    Symbol symbol = Symbol::none;
    std::string text;
    std::string css = {};
    Pixel at = {};  ///< where it begins, from the legend's left upper corner
  };

  std::vector<Entry> entries(const Marks& marks, const HiddenMarks& hidden) const;
  void add_names(std::vector<Entry>& entries) const;
  static void draw_symbol(Svg& svg, Symbol symbol, const Pixel& at);

  const Scene& scene_;
  double width_;
};

}  // namespace tcb
