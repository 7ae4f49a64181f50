// JSON splitter: a JSON text is cut into whole records, by its strings and brackets alone.
#include "read/json/splitter.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "read/json/errors.hpp"

namespace tcb {
namespace {

constexpr std::size_t longest_part = 64UL * 1024 * 1024;

/// Names that are longer than those of lists are kept up to here.
constexpr std::size_t longest_name = 16;

}  // namespace

/// "curves[2]" and the path within it, or the latter alone.
std::string JsonSplitter::path(std::string_view list) const {
  if (shape_ != JsonShape::curves) return std::string(list);
  return fmt::format("curves[{}]{}{}", curve_, list.empty() ? "" : ".", list);
}

bool JsonSplitter::scan_start() {
  scanner_.skip_blanks();
  if (scanner_.at_end()) return false;
  if (scanner_.now() == '[') {
    begin_list_of(JsonShape::list);
  } else if (scanner_.now() == '{') {
    stage_ = Stage::object;
  } else {
    shape_ = JsonShape::lines;
    stage_ = Stage::lines;
  }
  return true;
}

/// Begins a list, if the array that begins here is that of the keys or of the curves.
bool JsonSplitter::begin_list() {
  const bool is_name = list_.empty() ? name_ == "keys" || name_ == "rows" : name_ == list_;
  const bool keys = !has_list_ && is_name;
  const bool curves = !shape_ && list_.empty() && name_ == "curves";
  if (keys || curves) begin_list_of(keys ? JsonShape::object : JsonShape::curves);
  return keys || curves;
}

/// The keys or the curves begin after the current bracket.
void JsonSplitter::begin_list_of(JsonShape shape) {
  if (!shape_) shape_ = shape;
  Chunk before = scanner_.take(scanner_.at + 1);
  depth_ = 0;
  if (shape == JsonShape::curves) {
    before_curves_ = std::move(before);
    stage_ = Stage::between_curves;
    return;
  }
  if (shape == JsonShape::object) before_ = std::move(before);
  stage_ = Stage::list;
  has_list_ = is_first_cut_ = true;
  is_list_closed_ = false;
  records_ = records_cut_ = 0;
}

/// All elements are cut off, up to the closing bracket.
void JsonSplitter::end_list() {
  if (shape_ == JsonShape::list) {
    (void)scanner_.take(1);
    stage_ = Stage::after_list;
  } else {
    stage_ = Stage::object;
    depth_ = 2;
  }
}

void JsonSplitter::end_curves() {
  before_ = std::move(before_curves_);
  has_list_ = true;
  shape_ = JsonShape::object;  // from here on
  stage_ = Stage::object;
  depth_ = 2;
}

/// Scans an object for its keys or curves, and to its end.
bool JsonSplitter::scan_object() {
  while (!scanner_.at_end()) {
    const char c = scanner_.now();
    if (scanner_.in_string) {
      const std::size_t begin = scanner_.at;
      const bool is_whole = scanner_.skip_string();
      const std::size_t end = scanner_.at - (is_whole ? 1 : 0);
      if (depth_ == 1) name_.append(scanner_.view().substr(begin, std::min(end - begin, longest_name)));
      if (!is_whole) return false;
      continue;
    }
    if (c == '"') {
      scanner_.in_string = true;
      name_.clear();
    } else if (c == '[' && depth_ == 1 && begin_list()) {
      return true;
    } else if (c == '{' || c == '[') {
      ++depth_;
    } else if ((c == '}' || c == ']') && --depth_ == 0) {
      ++scanner_.at;
      if (!shape_) {
        shape_ = JsonShape::lines;
        stage_ = Stage::lines;
        ++records_;
      }
      if (shape_ == JsonShape::curves) boundary_ = scanner_.at;
      if (shape_ != JsonShape::object) return true;
      depth_ = 1;  // what follows is an error that the parser finds
      continue;
    }
    ++scanner_.at;
  }
  return false;
}

/// Scans records to the end of the text, or of the list that they are elements of.
bool JsonSplitter::scan_records() {
  const bool is_list = stage_ == Stage::list;
  for (; !scanner_.at_end(); ++scanner_.at) {
    if (!scanner_.skip_to_structure()) return false;
    switch (scanner_.now()) {
      case '{':
        if (depth_ == 0) scanner_.skip_plain_object();
        [[fallthrough]];
      case '[': ++depth_; break;
      case ',':
        if (!is_list || depth_ != 0) break;
        boundary_ = scanner_.at;
        ++records_;
        break;
      case '\n':
        if (!is_list && depth_ == 0) boundary_ = scanner_.at + 1;
        break;
      case ']':
        if (is_list && depth_ == 0) {
          boundary_ = scanner_.at;
          ++records_;
          is_list_closed_ = true;
          return true;
        }
        [[fallthrough]];
      case '}':  // one that nothing opened stays in its record, where the parser finds it
        if (depth_ > 0) --depth_;
        if (!is_list && depth_ == 0) ++records_;
        break;
      default: break;
    }
  }
  return false;
}

/// Between curves: nothing but commas, up to the next one or the end of their list.
bool JsonSplitter::scan_between_curves() {
  scanner_.skip_blanks();
  (void)scanner_.take(scanner_.at);
  if (scanner_.at_end()) return false;
  const char c = scanner_.now();
  if (c == '{' && has_comma_) {
    stage_ = Stage::object;
    has_list_ = has_comma_ = false;
    before_ = {};
    return true;
  }
  if (c == ']' && (curve_ == 0 || !has_comma_)) {
    end_curves();
    return true;
  }
  if (c != ',' || has_comma_) {
    throw at_scanner(has_comma_ ? json::curve_expected() : json::comma_between_curves_expected());
  }
  (void)scanner_.take(1);
  has_comma_ = true;
  return true;
}

void JsonSplitter::require_end() {
  scanner_.skip_blanks();
  (void)scanner_.take(scanner_.at);
  if (!scanner_.at_end()) throw at_scanner(json::text_after_list());
}

/// Continues in the current text; false if more must be read.
bool JsonSplitter::scan() {
  switch (stage_) {
    case Stage::start: return scan_start();
    case Stage::object: return scan_object();
    case Stage::list:
    case Stage::lines: return scan_records();
    case Stage::between_curves: return scan_between_curves();
    case Stage::after_list: require_end(); return false;
    case Stage::unclosed_list:
    case Stage::end: break;
  }
  return false;
}

/// The object that ends at `end`, without its keys.
JsonPart JsonSplitter::cut_object(std::size_t end) {
  JsonPart part{JsonPart::Kind::object, std::exchange(before_, {})};
  (has_list_ ? part.after : part.chunk) = scanner_.take(end);
  part.chunk.path = path("");
  ++curve_;
  return part;
}

JsonPart JsonSplitter::cut_lines(std::size_t end) {
  JsonPart part{JsonPart::Kind::lines, scanner_.take(end)};
  part.chunk.first = std::exchange(records_cut_, records_);
  part.chunk.path = path(list_.empty() ? "keys" : list_);
  return part;
}

/// The elements before `end`, and the comma or the bracket after them; nothing in an empty list.
std::optional<JsonPart> JsonSplitter::cut_elements(std::size_t end) {
  JsonPart part{JsonPart::Kind::elements, scanner_.take(end)};
  part.chunk.first = std::exchange(records_cut_, records_);
  part.chunk.path = path(list_.empty() ? "keys" : list_);
  const bool is_empty_list = std::exchange(is_first_cut_, false) && is_list_closed_ && is_json_blank(part.chunk.text);
  if (is_list_closed_) {
    end_list();
  } else if (scanner_.size() != 0) {
    (void)scanner_.take(1);
  }
  return is_empty_list ? std::nullopt : std::optional(std::move(part));
}

/// The records up to the last boundary.
std::optional<JsonPart> JsonSplitter::cut() {
  const std::size_t end = *std::exchange(boundary_, std::nullopt);
  if (stage_ == Stage::list) return cut_elements(end);
  if (stage_ == Stage::lines) return cut_lines(end);
  JsonPart part = cut_object(end);
  stage_ = Stage::between_curves;
  return part;
}

/// What is left at the end of the input.
std::optional<JsonPart> JsonSplitter::cut_rest() {
  if (stage_ == Stage::list) {
    stage_ = Stage::unclosed_list;
    if (!is_json_blank(scanner_.view())) return cut_elements(scanner_.size());
    throw at_scanner(json::ends_early());
  }
  if (stage_ == Stage::between_curves) end_curves();
  const Stage stage = std::exchange(stage_, Stage::end);
  if (stage == Stage::object && shape_) return cut_object(scanner_.size());
  if (is_json_blank(scanner_.view())) return std::nullopt;
  return cut_lines(scanner_.size());
}

bool JsonSplitter::read_more() {
  if (scanner_.size() > longest_part) {
    throw at_scanner(stage_ == Stage::object ? json::object_too_long() : json::key_too_long());
  }
  return scanner_.read_more();
}

std::optional<JsonPart> JsonSplitter::next() {
  if (stage_ == Stage::unclosed_list) throw at_scanner(json::ends_early());
  while (stage_ != Stage::end) {
    const bool more = scan();
    if (!more && !boundary_ && !read_more()) return cut_rest();
    if (!boundary_) continue;
    if (auto part = cut()) return part;
  }
  return std::nullopt;
}

}  // namespace tcb
