// Legend: what the colours and the marks of a picture mean, in lines below its views.
#include "plot/legend.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tcb {
namespace {

constexpr double symbol_width = 28, between = 16, line_height = 20, widest_name = 200;
constexpr std::size_t most_names = 24;

double width_of(std::string_view text, bool has_symbol) {
  return (has_symbol ? symbol_width : 0) + text_width(text, text_size) + between;
}

}  // namespace

std::string colour_of(std::size_t name) {
  const std::size_t dashes = name / colours % 3;
  return fmt::format("c{}{}", name % colours, dashes == 0 ? "" : fmt::format(" d{}", dashes));
}

double Legend::height() const {
  return entries({true, true, true, true, scene_.worst.has_value()}, {false, true}).back().at.y + line_height + 8;
}

std::vector<Legend::Entry> Legend::entries(const Marks& marks, const HiddenMarks& hidden) const {
  std::vector<Entry> all;
  if (scene_.names.size() > 1) {
    add_names(all);
  } else {
    all.push_back({Symbol::curve, "curve", colour_of(0)});
  }
  const std::string css = scene_.names.size() > 1 ? "c5" : "c0";
  if (marks.keys) all.push_back({Symbol::key, "key", css});
  if (marks.corners) all.push_back({Symbol::corner, "key at a corner", css});
  if (marks.handles) all.push_back({Symbol::tangent, "tangents", css});
  if (marks.samples) all.push_back({Symbol::sample, "sample", css});
  if (scene_.frame) {
    all.push_back({Symbol::axis_x, "x axis", css});
    all.push_back({Symbol::axis_y, "y axis", css});
    all.push_back({Symbol::axis_z, "z axis", css});
  }
  if (marks.worst) all.push_back({Symbol::worst, "largest difference", css});
  if (hidden.keys) all.push_back({Symbol::none, "keys are too dense to be shown", css});
  if (hidden.samples) all.push_back({Symbol::none, "samples are too dense to be shown", css});
  Pixel at;
  for (Entry& entry : all) {
    const double width = width_of(entry.text, entry.symbol != Symbol::none);
    if (at.x > 0 && at.x + width - between > width_) at = {0, at.y + line_height};
    entry.at = at;
    at.x += width;
  }
  return all;
}

void Legend::add_names(std::vector<Entry>& entries) const {
  const std::size_t shown = std::min(scene_.names.size(), most_names);
  for (std::size_t i = 0; i < shown; ++i) {
    entries.push_back({Symbol::curve, fitted(scene_.names[i], widest_name, text_size), colour_of(i)});
  }
  const std::size_t more = scene_.names.size() - shown;
  if (more > 0) entries.push_back({Symbol::none, fmt::format("and {} more", more), "c5"});
}

void Legend::draw_symbol(Svg& svg, Symbol symbol, const Pixel& at) {
  const Pixel middle = at + Pixel{11, 0};
  const auto line = [&svg](const Pixel& from, std::string_view rest, std::string_view css) {
    std::string data = "M";
    append_pixel(data, from);
    svg.add_path(data + std::string(rest), css);
  };
  switch (symbol) {
    case Symbol::none: return;
    case Symbol::curve: return line(at, "h22", "l");
    case Symbol::key: return svg.add_circle(middle, key_radius, "k");
    case Symbol::corner: return svg.add_circle(middle, key_radius, "q");
    case Symbol::tangent: return line(at, "h22", "h");
    case Symbol::worst: return svg.add_circle(middle, worst_radius, "w");
    case Symbol::axis_x: return line(at, "h22", "ax");
    case Symbol::axis_y: return line(at, "h22", "ay");
    case Symbol::axis_z: return line(at, "h22", "az");
    case Symbol::sample: return line(middle - Pixel{0, half_tick}, "v8", "s");
  }
}

void Legend::draw(Svg& svg, const Pixel& corner, const Marks& marks, const HiddenMarks& hidden) const {
  for (const Entry& entry : entries(marks, hidden)) {
    const Pixel at = corner + entry.at + Pixel{0, line_height / 2};
    svg.begin_group(entry.css);
    draw_symbol(svg, entry.symbol, at);
    svg.end_group();
    svg.add_text(at + Pixel{entry.symbol == Symbol::none ? 0 : symbol_width, 4}, entry.text, "u");
  }
}

}  // namespace tcb
