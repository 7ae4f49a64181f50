// SVG: numbers in pixels, texts with their estimated widths, elements, and the style sheet of a picture.
#pragma once

#include <string>
#include <string_view>

namespace tcb {

/// A place in the picture, from its left upper corner, in pixels.
struct Pixel {
  double x = 0, y = 0;
  friend Pixel operator+(const Pixel& a, const Pixel& b) { return {a.x + b.x, a.y + b.y}; }
  friend Pixel operator-(const Pixel& a, const Pixel& b) { return {a.x - b.x, a.y - b.y}; }
  friend Pixel operator*(double factor, const Pixel& a) { return {factor * a.x, factor * a.y}; }
};

/// A rectangle in the picture.
struct Box {
  double left = 0, top = 0, width = 0, height = 0;
  double right() const { return left + width; }
  double bottom() const { return top + height; }
};

/// Appends a number of pixels with at most two decimals.
void append_pixels(std::string& out, double value);
/// Appends "x y", after a blank if a digit precedes it.
void append_pixel(std::string& out, const Pixel& at);

/// A text as the content of an element: escaped, and without characters that XML does not have.
std::string xml_text(std::string_view text);

/// An upper estimate of the width of a text in a sans-serif font of this size.
double text_width(std::string_view text, double size);

/// The text, or its beginning with an ellipsis, in at most this width.
std::string fitted(std::string_view text, double width, double size);

/// Sizes of fonts; bold texts are as wide as if they were larger.
inline constexpr double small_size = 11, text_size = 12, bold_size = 13.5, title_size = 18;

/// The number of colours of curves; `cN` are their classes.
inline constexpr std::size_t colours = 6;

/// Elements of a picture, as text.
class Svg {
 public:
  const std::string& text() const { return text_; }
  std::size_t size() const { return text_.size(); }

  /// A picture with its background. `title` is for screen readers.
  void begin(double width, double height, std::string_view title);
  void end() { text_ += "</svg>\n"; }

  void begin_group(std::string_view css) { text_ += "<g class=\"" + std::string(css) + "\">\n"; }
  void end_group() { text_ += "</g>\n"; }
  /// A text on a line. `css`: its classes; `anchor`: start, middle or end.
  void add_text(const Pixel& at, std::string_view text, std::string_view css, std::string_view anchor = "start");
  void add_path(std::string_view data, std::string_view css);
  void add_box(const Box& box, std::string_view css);
  void add_circle(const Pixel& centre, double radius, std::string_view css);

 private:
  std::string text_;
};

}  // namespace tcb
