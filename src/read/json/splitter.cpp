// Splitter of JSON text: it is cut between key objects, without parsing them.
#include "read/json/json_input.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "error.hpp"
#include "text/utf8.hpp"

namespace tcb {
namespace {

bool is_blank(std::string_view text) { return std::ranges::all_of(text, is_json_blank); }

}  // namespace

/// "curves[2]" and the path within it, or the latter alone.
std::string JsonSplitter::path(const char* list) const {
  if (shape_ != JsonShape::curves) return list;
  return fmt::format("curves[{}]{}{}", curve_, *list == '\0' ? "" : ".", list);
}

/// The keys or the curves begin after the current bracket.
void JsonSplitter::start_list(JsonShape shape) {
  if (!shape_) shape_ = shape;
  Chunk before = scanner_.take(scanner_.at);
  depth_ = 0;
  if (shape == JsonShape::curves) {
    outer_ = {std::move(before), true};
    (void)scanner_.take(1);
    stage_ = Stage::between;
    return;
  }
  if (shape != JsonShape::list) object_ = {std::move(before), true};
  stage_ = Stage::list;
  listed_ = first_cut_ = true;
  list_closed_ = false;
  records_ = records_cut_ = 0;
}

/// All keys are cut off.
void JsonSplitter::end_list() {
  stage_ = shape_ == JsonShape::list ? Stage::after_list : Stage::object;
  depth_ = 1;
  object_.chunk.text += "[]";
  object_.gap = object_.chunk.text.size();
  object_.line = scanner_.line;
  object_.column = scanner_.column;
}

bool JsonSplitter::scan_start() {
  scanner_.skip_blanks();
  if (scanner_.at_end()) return false;
  if (scanner_.now() == '[') {
    start_list(JsonShape::list);
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
  const bool keys = !listed_ && (member_ == "keys\"" || member_ == "rows\"");
  const bool curves = !shape_ && member_ == "curves\"";
  if (keys || curves) start_list(keys ? JsonShape::object : JsonShape::curves);
  return keys || curves;
}

/// Scans an object for its keys or curves, and to its end.
bool JsonSplitter::scan_object() {
  while (!scanner_.at_end()) {
    const char c = scanner_.now();
    if (scanner_.in_string) {
      const std::size_t begin = scanner_.at;
      const bool whole = scanner_.skip_string();
      if (depth_ == 1) member_.append(scanner_.view().substr(begin, std::min<std::size_t>(scanner_.at - begin, 16)));
      if (!whole) return false;
      continue;
    }
    if (c == '"') {
      scanner_.in_string = true;
      member_.clear();
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

/// Scans keys to the end of the text, or of their list.
bool JsonSplitter::scan_keys() {
  const bool listed = stage_ == Stage::list;
  for (; !scanner_.at_end(); ++scanner_.at) {
    if (!scanner_.skip_to_structure()) return false;
    switch (scanner_.now()) {
      case '{':
        if (depth_ == (listed ? 1U : 0U)) scanner_.skip_plain_object();
        [[fallthrough]];
      case '[': ++depth_; break;
      case ',':
        if (!listed || depth_ != 1) break;
        boundary_ = scanner_.at;
        ++records_;
        break;
      case '\n':
        if (!listed && depth_ == 0) boundary_ = scanner_.at + 1;
        break;
      default:  // a bracket is closed
        if (depth_ > 0) --depth_;
        if (depth_ != 0) break;
        ++records_;
        if (!listed) break;
        list_closed_ = true;
        boundary_ = ++scanner_.at;
        return true;
    }
  }
  return false;
}

/// Between curves: nothing but commas, up to the next one or the end of their list.
bool JsonSplitter::scan_between() {
  scanner_.skip_blanks();
  (void)scanner_.take(scanner_.at);
  if (scanner_.at_end()) return false;
  const char c = scanner_.now();
  if (c == '{' && comma_) {
    stage_ = Stage::object;
    listed_ = comma_ = false;
    object_ = {};
    return true;
  }
  if (c == ']' && (curve_ == 0 || !comma_)) {
    (void)scanner_.take(1);
    stage_ = Stage::object;
    depth_ = 1;
    listed_ = true;
    object_ = std::move(outer_);
    shape_ = JsonShape::object;  // from here on
    end_list();
    return true;
  }
  if (c != ',' || comma_) {
    scanner_.refuse(comma_ ? ErrorCode::json_curve_expected : ErrorCode::json_comma_after_curve_expected);
  }
  (void)scanner_.take(1);
  comma_ = true;
  return true;
}

/// Continues in the current text.
bool JsonSplitter::scan() {
  switch (stage_) {
    case Stage::start: return scan_start();
    case Stage::object: return scan_object();
    case Stage::list:
    case Stage::lines: return scan_keys();
    case Stage::between: return scan_between();
    case Stage::after_list: break;
    case Stage::end: return false;
  }
  scanner_.skip_blanks();
  (void)scanner_.take(scanner_.at);
  if (!scanner_.at_end()) scanner_.refuse(ErrorCode::json_text_after_array);
  return false;
}

/// The object that ends at `end`, without its keys.
JsonPart JsonSplitter::take_object(std::size_t end) {
  boundary_ = 0;
  Chunk rest = scanner_.take(end);
  if (!object_.chunk.text.empty()) object_.chunk.text += rest.text;
  if (object_.chunk.text.empty()) object_ = {std::move(rest), true};
  object_.chunk.path = path("");
  ++curve_;
  return std::exchange(object_, {});
}

/// The records up to the last boundary, as a JSON array or as lines; `at_end`, the whole rest.
std::optional<JsonPart> JsonSplitter::cut(bool at_end) {
  const std::size_t end = at_end ? scanner_.size() : boundary_;
  if (stage_ == Stage::object && shape_) {
    JsonPart part = take_object(end);
    if (shape_ == JsonShape::curves) stage_ = Stage::between;
    return part;
  }
  if (end == 0) return std::nullopt;
  boundary_ = 0;
  Chunk chunk = scanner_.take(end);
  chunk.first = std::exchange(records_cut_, records_);
  chunk.path = path("keys");
  if (stage_ != Stage::list) return JsonPart{std::move(chunk)};
  // The text begins with the bracket or comma before its first record, and ends after its last or with the bracket.
  const bool empty_list = first_cut_ && list_closed_ && is_blank(std::string_view(chunk.text).substr(1, end - 2));
  chunk.text[0] = '[';
  if (!list_closed_ && !at_end) chunk.text += ']';
  first_cut_ = false;
  if (list_closed_) end_list();
  return empty_list ? std::nullopt : std::optional(JsonPart{std::move(chunk)});
}

std::optional<JsonPart> JsonSplitter::next() {
  while (stage_ != Stage::end) {
    while (scan()) {
      if (boundary_ == 0) continue;
      if (auto part = cut(false)) return part;
    }
    if (boundary_ != 0) {
      if (auto part = cut(false)) return part;
      continue;
    }
    if (scanner_.read_more(stage_ == Stage::object ? ErrorCode::json_object_too_long : ErrorCode::json_key_too_long)) {
      continue;
    }
    if (stage_ == Stage::between) {
      object_ = std::move(outer_);
      stage_ = Stage::object;
    }
    const bool inside = stage_ == Stage::object || !scanner_.is_blank();
    auto part = inside ? cut(true) : std::nullopt;
    stage_ = Stage::end;
    return part;
  }
  return std::nullopt;
}

}  // namespace tcb
