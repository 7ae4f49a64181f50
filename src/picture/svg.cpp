// SVG: numbers in pixels, texts with their estimated widths, elements, and the style sheet of a picture.
#include "picture/svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>

#include "numbers/print_number.hpp"
#include "text/utf8.hpp"

namespace tcb {
namespace {

/// Colours have a contrast of at least 3 to 1 with the background, texts of 4.5 to 1, in light and in dark. Those of
/// curves also differ for people who cannot distinguish red and green.
/// Source: Okabe and Ito, "Color Universal Design", darker for light backgrounds.
constexpr std::string_view style = R"css(<style>
text{font:12px "DejaVu Sans",Verdana,"Segoe UI",Roboto,Helvetica,Arial,sans-serif;fill:#1b1f24}
.t{font-size:16px;font-weight:bold}
.n{font-weight:bold}
.v,.u{fill:#57606a}
.v{font-size:11px}
.b{fill:#fff}
.f{fill:none;stroke:#8c959f}
.g{fill:none;stroke:#e4e7eb}
.l,.h,.s{fill:none}
.l{stroke:currentColor;stroke-width:1.6;stroke-linejoin:round}
.h{stroke:#8c959f}
.s{stroke:currentColor}
.k{fill:currentColor;stroke:#fff}
.q{fill:#fff;stroke:currentColor;stroke-width:2}
.w{fill:none;stroke:#c0182b;stroke-width:2}
.ax,.ay,.az{fill:none;stroke-width:1.4}
.ax{stroke:#c0182b}
.ay{stroke:#1a7f37}
.az{stroke:#5b4bdb}
.c0{color:#0072b2}
.c1{color:#c24e00}
.c2{color:#00795a}
.c3{color:#a8437c}
.c4{color:#8a6a00}
.c5{color:#4d5761}
.d1 .l{stroke-dasharray:7 3}
.d2 .l{stroke-dasharray:2 3}
@media(prefers-color-scheme:dark){
text{fill:#f0f3f6}
.v,.u{fill:#b1bac4}
.b{fill:#15181c}
.f,.h{stroke:#768390}
.g{stroke:#2d333b}
.k{stroke:#15181c}
.q{fill:#15181c}
.w,.ax{stroke:#ff7b86}
.ay{stroke:#3fb950}
.az{stroke:#a99cff}
.c0{color:#56b4e9}
.c1{color:#f08a3c}
.c2{color:#35c79a}
.c3{color:#e79ac4}
.c4{color:#e8d44d}
.c5{color:#b9c2cc}
}
</style>
)css";

/// The size in bytes of the character at the beginning of a text; 0 if it is not UTF-8.
std::size_t first_character(std::string_view text) {
  const auto first = static_cast<unsigned char>(text.front());
  const std::size_t size = first < 0x80 ? 1 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
  return text.size() >= size && find_invalid_utf8(text.substr(0, size)) == std::string_view::npos ? size : 0;
}

/// The width of a character, as a part of the font's size, in DejaVu Sans, which is a wide font.
double character_width(std::string_view character) {
  if (character.size() == 2) return 0.7;
  if (character.size() > 2) return character >= "\xE2\xBA\x80" ? 1.3 : 0.9;  // from U+2E80 on: ideographs, emoji
  const char c = character[0];
  if (std::string_view("fijlrtI.,:;'|!()[]/\\ -").find(c) != std::string_view::npos) return 0.42;
  if (std::string_view("mwMW@%+=<>&~^#").find(c) != std::string_view::npos) return 1.0;
  return c >= 'A' && c <= 'Z' ? 0.79 : 0.645;
}

std::string pixels(double value) {
  std::string text;
  append_pixels(text, value);
  return text;
}

/// Calls use(character) for each; a byte that is not UTF-8 is the character U+FFFD.
template <class Use>
void each_character(std::string_view text, Use use) {
  while (!text.empty()) {
    const std::size_t size = first_character(text);
    use(size == 0 ? std::string_view("\xEF\xBF\xBD") : text.substr(0, size));
    text.remove_prefix(std::max<std::size_t>(size, 1));
  }
}

}  // namespace

void append_pixels(std::string& out, double value) {
  std::array<char, number_room> text{};
  constexpr double most = 1e7;  // far outside every picture
  const char* end = write_fixed(std::clamp(value, -most, most), 2, text.data());
  while (end[-1] == '0') --end;
  if (end[-1] == '.') --end;
  const std::string_view number(text.data(), static_cast<std::size_t>(end - text.data()));
  out += number == "-0" ? "0" : number;
}

void append_pixel(std::string& out, const Pixel& at) {
  const bool after_digit = !out.empty() && out.back() >= '0' && out.back() <= '9';
  if (after_digit) out += ' ';
  append_pixels(out, at.x);
  out += ' ';
  append_pixels(out, at.y);
}

std::string xml_text(std::string_view text) {
  std::string out;
  const std::string line = in_one_line(text);
  each_character(line, [&out](std::string_view character) {
    if (character == "<") {
      out += "&lt;";
    } else if (character == "&") {
      out += "&amp;";
    } else if (character == ">") {
      out += "&gt;";
    } else if (character == "\"") {
      out += "&quot;";
    } else {
      const bool allowed = character != "\xEF\xBF\xBE" && character != "\xEF\xBF\xBF";
      out += allowed ? character : std::string_view("\xEF\xBF\xBD");
    }
  });
  return out;
}

double text_width(std::string_view text, double size) {
  double width = 0;
  each_character(text, [&width](std::string_view character) { width += character_width(character); });
  return width * size;
}

std::string fitted(std::string_view text, double width, double size) {
  if (text_width(text, size) <= width) return std::string(text);
  std::string beginning;
  double used = character_width("…") * size;
  bool full = false;
  each_character(text, [&](std::string_view character) {
    used += character_width(character) * size;
    full = full || used > width;
    if (!full) beginning += character;
  });
  return beginning + "…";
}

void Svg::begin(double width, double height, std::string_view title) {
  text_ += fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" "
      "role=\"img\">\n<title>{2}</title>\n",
      static_cast<int>(width), static_cast<int>(height), xml_text(title));
  text_ += style;
  text_ += "<rect class=\"b\" width=\"100%\" height=\"100%\"/>\n";
}

void Svg::add_text(const Pixel& at, std::string_view text, std::string_view css, std::string_view anchor) {
  const std::string anchored = anchor == "start" ? "" : fmt::format("\" text-anchor=\"{}", anchor);
  text_ += fmt::format("<text x=\"{}\" y=\"{}{}\" class=\"{}\">{}</text>\n", pixels(at.x), pixels(at.y), anchored, css,
                       xml_text(text));
}

void Svg::add_path(std::string_view data, std::string_view css) {
  text_ += fmt::format("<path class=\"{}\" d=\"{}\"/>\n", css, data);
}

void Svg::add_box(const Box& box, std::string_view css) {
  text_ += fmt::format("<rect class=\"{}\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>\n", css, pixels(box.left),
                       pixels(box.top), pixels(box.width), pixels(box.height));
}

void Svg::add_circle(const Pixel& centre, double radius, std::string_view css) {
  text_ += fmt::format("<circle class=\"{}\" cx=\"{}\" cy=\"{}\" r=\"{}\"/>\n", css, pixels(centre.x), pixels(centre.y),
                       pixels(radius));
}

}  // namespace tcb
