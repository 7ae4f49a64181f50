// Where the keys are in JSON text: it is cut between key objects, without looking into them.
#include "input/json/splitter.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "error.hpp"
#include "text/text_position.hpp"

namespace tcb {
namespace {

bool is_blank(std::string_view text) { return text.find_first_not_of(" \t\r\n") == std::string_view::npos; }

}  // namespace

/// "curves[2]" and what is in it, or the latter alone.
std::string JsonSplitter::path(const char* list) const {
  if (shape_ != Shape::curves) return list;
  return fmt::format("curves[{}]{}{}", curve_, *list == '\0' ? "" : ".", list);
}

/// The keys or the curves begin behind the bracket at hand.
void JsonSplitter::start_list(Shape shape) {
  if (shape_ == Shape::unknown) shape_ = shape;
  Chunk before = text_.take(text_.at);
  depth_ = 0;
  if (shape == Shape::curves) {
    outer_ = {std::move(before), true};
    (void)text_.take(1);
    stage_ = Stage::between;
    return;
  }
  if (shape != Shape::list) object_ = {std::move(before), true};
  stage_ = Stage::list;
  listed_ = first_cut_ = true;
  list_closed_ = false;
  records_ = records_cut_ = 0;
}

/// The keys are all cut off.
void JsonSplitter::end_list() {
  stage_ = shape_ == Shape::list ? Stage::behind : Stage::object;
  depth_ = 1;
  object_.chunk.text += "[]";
  object_.gap = object_.chunk.text.size();
  object_.line = text_.line;
  object_.column = text_.column;
}

bool JsonSplitter::scan_start() {
  text_.skip_blanks();
  if (text_.at_end()) return false;
  if (text_.now() == '[') {
    start_list(Shape::list);
  } else if (text_.now() == '{') {
    stage_ = Stage::object;
  } else {
    shape_ = Shape::lines;
    stage_ = Stage::lines;
  }
  return true;
}

/// The array that begins here may be that of the keys, or of the curves.
bool JsonSplitter::begin_list() {
  const bool keys = !listed_ && (member_ == "keys\"" || member_ == "rows\"");
  const bool curves = shape_ == Shape::unknown && member_ == "curves\"";
  if (keys || curves) start_list(keys ? Shape::wrapped : Shape::curves);
  return keys || curves;
}

/// Scans an object for its keys or curves, and to its end.
bool JsonSplitter::scan_object() {
  while (!text_.at_end()) {
    const char c = text_.now();
    if (text_.in_string) {
      const std::size_t begin = text_.at;
      const bool whole = text_.skip_string();
      if (depth_ == 1) member_.append(text_.view().substr(begin, std::min<std::size_t>(text_.at - begin, 16)));
      if (!whole) return false;
      continue;
    }
    if (c == '"') {
      text_.in_string = true;
      member_.clear();
    } else if (c == '[' && depth_ == 1 && begin_list()) {
      return true;
    } else if (c == '{' || c == '[') {
      ++depth_;
    } else if ((c == '}' || c == ']') && --depth_ == 0) {
      ++text_.at;
      if (shape_ == Shape::unknown) {
        shape_ = Shape::lines;
        stage_ = Stage::lines;
        ++records_;
      }
      if (shape_ == Shape::curves) boundary_ = text_.at;
      if (shape_ != Shape::wrapped) return true;
      depth_ = 1;  // what follows is for the parser to refuse
      continue;
    }
    ++text_.at;
  }
  return false;
}

/// Scans keys to the end of the text, or of their list.
bool JsonSplitter::scan_keys() {
  const bool listed = stage_ == Stage::list;
  for (; !text_.at_end(); ++text_.at) {
    if (!text_.skip_to_telling()) return false;
    switch (text_.now()) {
      case '{':
        if (depth_ == (listed ? 1U : 0U)) text_.skip_plain_object();
        [[fallthrough]];
      case '[': ++depth_; break;
      case ',':
        if (!listed || depth_ != 1) break;
        boundary_ = text_.at;
        ++records_;
        break;
      case '\n':
        if (!listed && depth_ == 0) boundary_ = text_.at + 1;
        break;
      default:  // a bracket is closed
        if (depth_ > 0) --depth_;
        if (depth_ != 0) break;
        ++records_;
        if (!listed) break;
        list_closed_ = true;
        boundary_ = ++text_.at;
        return true;
    }
  }
  return false;
}

/// Between curves: nothing but commas, up to the next one or the end of their list.
bool JsonSplitter::scan_between() {
  text_.skip_blanks();
  (void)text_.take(text_.at);
  if (text_.at_end()) return false;
  const char c = text_.now();
  if (c == '{' && comma_) {
    stage_ = Stage::object;
    listed_ = comma_ = false;
    object_ = {};
    return true;
  }
  if (c == ']' && (curve_ == 0 || !comma_)) {
    (void)text_.take(1);
    stage_ = Stage::object;
    depth_ = 1;
    listed_ = true;
    object_ = std::move(outer_);
    shape_ = Shape::wrapped;  // from here on
    end_list();
    return true;
  }
  if (c != ',' || comma_) {
    text_.refuse(comma_ ? "no curve where one was expected; expected {…}; correct the text"
                        : "expected a comma or the end of the curves; correct the text");
  }
  (void)text_.take(1);
  comma_ = true;
  return true;
}

/// Goes on in the text at hand.
bool JsonSplitter::scan() {
  switch (stage_) {
    case Stage::start: return scan_start();
    case Stage::object: return scan_object();
    case Stage::list:
    case Stage::lines: return scan_keys();
    case Stage::between: return scan_between();
    case Stage::behind: break;
    case Stage::end: return false;
  }
  text_.skip_blanks();
  (void)text_.take(text_.at);
  if (!text_.at_end()) text_.refuse("text after the end of the JSON array; expected nothing more; take it out");
  return false;
}

/// The object that ends at `end`, without its keys.
JsonPart JsonSplitter::take_object(std::size_t end) {
  boundary_ = 0;
  Chunk rest = text_.take(end);
  if (!object_.chunk.text.empty()) object_.chunk.text += rest.text;
  if (object_.chunk.text.empty()) object_ = {std::move(rest), true};
  object_.chunk.path = path("");
  ++curve_;
  return std::exchange(object_, {});
}

/// The records up to the last boundary, as a JSON array or as lines; all that is left `at_end`.
std::optional<JsonPart> JsonSplitter::cut(bool at_end) {
  const std::size_t end = at_end ? text_.size() : boundary_;
  if (stage_ == Stage::object && shape_ != Shape::unknown) {
    JsonPart part = take_object(end);
    if (shape_ == Shape::curves) stage_ = Stage::between;
    return part;
  }
  if (end == 0) return std::nullopt;
  boundary_ = 0;
  Chunk chunk = text_.take(end);
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
    if (text_.read_more(stage_ == Stage::object
                            ? "an object of more than 64 MiB around the keys; expected less; shorten it"
                            : "a key of more than 64 MiB; expected less; shorten it")) {
      continue;
    }
    if (stage_ == Stage::between) {
      object_ = std::move(outer_);
      stage_ = Stage::object;
    }
    const bool inside = stage_ == Stage::object || !text_.is_blank();
    auto part = inside ? cut(true) : std::nullopt;
    stage_ = Stage::end;
    return part;
  }
  return std::nullopt;
}

}  // namespace tcb
