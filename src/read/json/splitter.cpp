// JSON splitter: a JSON text is cut into whole records, by its strings and brackets alone.
#include "read/json/splitter.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace tcb {
namespace {

constexpr std::size_t longest_json_record = 64UL * 1024 * 1024;

Error text_ends_early() {
  return data_error("not JSON: the text ends too early; expected the rest of the last value; complete it");
}

/// The characters that determine where records end.
constexpr std::array<bool, 256> is_structure = [] {
  std::array<bool, 256> found{};
  for (const char c : std::string_view("\"[]{},")) found[static_cast<unsigned char>(c)] = true;
  return found;
}();

bool holds_blanks_only(std::string_view text) { return std::ranges::all_of(text, is_json_blank); }

/// The closing quote of the string that `at` is in, or `end`. `escaped`: a backslash precedes `at`; on return at `end`,
/// whether one precedes what follows.
const char* find_closing_quote(const char* at, const char* end, bool& escaped) {
  if (at != end && escaped) {
    escaped = false;
    ++at;
  }
  while (at != end && *at != '"') {
    while (at != end && *at != '"' && *at != '\\') ++at;
    if (at == end || *at == '"') break;
    escaped = at + 1 == end;
    at += escaped ? 1 : 2;
  }
  return at;
}

}  // namespace

std::size_t end_of_json_value(std::string_view text, std::size_t at) {
  for (std::size_t depth = 0; at < text.size(); ++at) {
    const char c = text[at];
    if (c == '"') {
      bool escaped = false;
      const char* const quote = find_closing_quote(text.data() + at + 1, text.data() + text.size(), escaped);
      at = static_cast<std::size_t>(quote - text.data());
    } else if (c == '{' || c == '[') {
      ++depth;
    } else if (c == '}' || c == ']') {
      if (depth <= 1) return at + 1;
      --depth;
    } else if (c == '\n' && depth == 0) {
      return at;
    }
  }
  return text.size();
}

/// False if the text ends in the string.
bool JsonSplitter::skip_string() {
  const char* const begin = text_.data();
  const char* const end = begin + text_.size();
  const char* const quote = find_closing_quote(begin + at_, end, escaped_);
  in_string_ = quote == end;
  at_ = static_cast<std::size_t>(quote - begin) + (in_string_ ? 0 : 1);
  return !in_string_;
}

/// False if the text ends in the blanks.
bool JsonSplitter::skip_blanks() {
  while (!at_end() && is_json_blank(text_[at_])) ++at_;
  return !at_end();
}

/// Skips from an opening brace to just before the closing one, where no other brace and no backslash is between.
void JsonSplitter::skip_plain_object() {
  // Without another brace and without a backslash, quotes come in pairs up to a brace outside of strings.
  const std::size_t end = text_.find('}', at_);
  if (end == std::string::npos) return;
  std::uint8_t odd = 0, doubtful = 0;
  for (const char c : std::string_view(text_).substr(at_ + 1, end - at_ - 1)) {
    odd = static_cast<std::uint8_t>(odd ^ static_cast<std::uint8_t>(c == '"'));
    doubtful = static_cast<std::uint8_t>(doubtful | static_cast<std::uint8_t>(c == '{') |
                                         static_cast<std::uint8_t>(c == '\\'));
  }
  if (odd == 0 && doubtful == 0) at_ = end - 1;
}

/// Cuts off and returns the text up to `end`.
Chunk JsonSplitter::take(std::size_t end) {
  std::string rest = text_.substr(end);
  text_.resize(end);
  Chunk chunk{std::exchange(text_, std::move(rest)), line_, column_};
  column_ = column_after(chunk.text, column_);
  line_ += count_lines(chunk.text);
  at_ -= std::min(at_, end);
  return chunk;
}

bool JsonSplitter::read_more() {
  const bool is_record = stage_ == Stage::list || stage_ == Stage::values;
  if (is_record && text_.size() > longest_json_record) {
    throw here(data_error("a key is longer than 64 MiB; expected a shorter one; remove what it does not need"));
  }
  if (!is_record) MemoryUse(max_memory_).add(text_.size());
  return bytes_.append_to(text_, {line_, column_});
}

/// "curves[2]" and the path within it, or the latter alone.
std::string JsonSplitter::path(std::string_view list) const {
  if (shape_ != JsonShape::curves) return std::string(list);
  return fmt::format("curves[{}]{}{}", curve_, list.empty() ? "" : ".", list);
}

bool JsonSplitter::scan_start() {
  if (!skip_blanks()) return false;
  const char first = text_[at_];
  if (first == '{') {
    stage_ = Stage::object;
    return true;
  }
  if (first != '[') {
    shape_ = JsonShape::lines;
    stage_ = Stage::values;
    return true;
  }
  const std::size_t second = text_.find_first_not_of(" \t\r\n", at_ + 1);
  if (second == std::string::npos) return false;
  if (text_[second] == '[') {
    const std::size_t third = text_.find_first_not_of(" \t\r\n", second + 1);
    if (third == std::string::npos) return false;
    if (text_[third] == '[' || text_[third] == '{') {  // rows hold no nested values
      shape_ = JsonShape::any;
      stage_ = Stage::rest;
      return true;
    }
  }
  begin_list_of(text_[second] == '[' ? JsonShape::table : JsonShape::list);
  return true;
}

/// Whether the array that begins here is that of the keys or of the curves.
bool JsonSplitter::begins_list(bool& needs_more) const {
  const std::string_view name = std::string_view(text_).substr(name_begin_, name_end_ - name_begin_);
  if (!shape_ && name == "curves") return true;
  if (has_list_ || (name != "keys" && name != "rows")) return false;
  const std::size_t next = text_.find_first_not_of(" \t\r\n", at_ + 1);
  needs_more = next == std::string::npos;
  return !needs_more && std::string_view("[-0123456789").find(text_[next]) == std::string_view::npos;
}

void JsonSplitter::begin_list() {
  const bool is_curves = !shape_ && text_[name_begin_] == 'c';
  begin_list_of(is_curves ? JsonShape::curves : JsonShape::object);
}

/// The keys or the curves begin at the current bracket.
void JsonSplitter::begin_list_of(JsonShape shape) {
  if (!shape_) shape_ = shape;
  Chunk before = take(at_ + (shape == JsonShape::curves ? 1 : 0));
  depth_ = name_begin_ = name_end_ = 0;
  if (shape == JsonShape::curves) {
    before_curves_ = std::move(before);
    stage_ = Stage::between_curves;
    return;
  }
  if (shape == JsonShape::object) before_ = std::move(before);
  at_ = 1;
  stage_ = Stage::list;
  has_list_ = is_first_cut_ = true;
  is_list_closed_ = false;
  records_ = records_cut_ = 0;
}

/// The text begins with the closing bracket of the curves.
void JsonSplitter::end_curves() {
  before_ = std::move(before_curves_);
  before_.text.pop_back();  // the opening bracket, which cut_object() adds
  has_list_ = true;
  shape_ = JsonShape::object;  // from here on
  stage_ = Stage::object;
  depth_ = 2;
}

/// Scans an object for its keys or curves, and to its end.
bool JsonSplitter::scan_object() {
  while (!at_end()) {
    if (in_string_) {
      if (!skip_string()) return false;
      if (depth_ == 1) name_end_ = at_ - 1;
      continue;
    }
    const char c = text_[at_];
    bool needs_more = false;
    if (c == '"') {
      in_string_ = true;
      if (depth_ == 1) name_begin_ = name_end_ = at_ + 1;
    } else if (c == '[' && depth_ == 1 && begins_list(needs_more)) {
      begin_list();
      return true;
    } else if (needs_more) {
      return false;
    } else if (c == '{' || c == '[') {
      ++depth_;
    } else if ((c == '}' || c == ']') && --depth_ == 0) {
      ++at_;
      if (shape_ == JsonShape::curves) {
        boundary_ = at_;
      } else {
        stage_ = shape_ ? Stage::rest : Stage::after_first_object;
      }
      return true;
    }
    ++at_;
  }
  return false;
}

/// The first object has no keys: it is one of several values, or the whole text.
bool JsonSplitter::scan_after_first_object() {
  if (!skip_blanks()) return false;
  shape_ = JsonShape::lines;
  stage_ = Stage::values;
  ++records_;
  return true;
}

/// Scans records to the end of the text, or of the list that they are elements of.
bool JsonSplitter::scan_records() {
  const bool is_list = stage_ == Stage::list;
  const char* const begin = text_.data();
  const char* const end = begin + text_.size();
  for (;; ++at_) {
    const char* now = begin + at_;
    for (;;) {
      if (in_string_) {
        at_ = static_cast<std::size_t>(now - begin);
        if (!skip_string()) return false;
        now = begin + at_;
      }
      while (now != end && !is_structure[static_cast<unsigned char>(*now)]) ++now;
      in_string_ = now != end && *now == '"';
      if (!in_string_) break;
      ++now;
    }
    at_ = static_cast<std::size_t>(now - begin);
    if (now == end) return false;
    switch (*now) {
      case '{':
        if (depth_ == 0) skip_plain_object();
        [[fallthrough]];
      case '[': ++depth_; break;
      case ',':
        if (!is_list || depth_ != 0) break;
        boundary_ = at_;
        if (++records_ == most_first_records && is_first_cut_) return true;
        break;
      case ']':
        if (is_list && depth_ == 0) {
          boundary_ = at_;
          ++records_;
          is_list_closed_ = true;
          return true;
        }
        [[fallthrough]];
      case '}':  // one that nothing opened stays in its record, where the parser finds it
        if (depth_ > 0) --depth_;
        if (is_list || depth_ != 0) break;
        boundary_ = at_ + 1;
        if (++records_ == most_first_records && is_first_cut_) return true;
        break;
      default: break;
    }
  }
}

/// Between curves: nothing but commas, up to the next one or the end of their list.
bool JsonSplitter::scan_between_curves() {
  const bool more = skip_blanks();
  (void)take(at_);
  if (!more) return false;
  const char c = text_[at_];
  if (c == '{' && has_comma_) {
    stage_ = Stage::object;
    has_list_ = has_comma_ = false;
    name_begin_ = name_end_ = 0;
    before_ = {};
    return true;
  }
  if (c == ']' && (curve_ == 0 || !has_comma_)) {
    end_curves();
    return true;
  }
  if (has_comma_) throw here(data_error("no curve here; expected an object with \"keys\"; correct the text"));
  if (c != ',') {
    throw here(data_error("no comma after a curve; expected one, or the end of \"curves\"; correct the text"));
  }
  (void)take(1);
  has_comma_ = true;
  return true;
}

/// Continues in the current text; false if more must be read.
bool JsonSplitter::scan() {
  switch (stage_) {
    case Stage::start: return scan_start();
    case Stage::object: return scan_object();
    case Stage::after_first_object: return scan_after_first_object();
    case Stage::list:
    case Stage::values: return scan_records();
    case Stage::between_curves: return scan_between_curves();
    case Stage::after_list:
      if (skip_blanks()) {
        (void)take(at_);
        throw here(data_error("there is text after the array of keys; expected nothing; remove it"));
      }
      return false;
    case Stage::rest:
    case Stage::unclosed:
    case Stage::end: break;
  }
  return false;
}

/// The object that ends at `end`, without its keys.
JsonPart JsonSplitter::cut_object(std::size_t end) {
  JsonPart part{JsonPart::Kind::object, std::exchange(before_, {})};
  Chunk rest = take(end);
  if (has_list_) {
    part.chunk.text += '[';
    part.seam = part.chunk.text.size();
    part.after = {rest.line, rest.column};
    part.chunk.text += rest.text;
  } else {
    part.chunk = std::move(rest);
  }
  part.chunk.path = path("");
  ++curve_;
  return part;
}

JsonPart JsonSplitter::cut_values(std::size_t end) {
  JsonPart part{JsonPart::Kind::values, take(end)};
  is_first_cut_ = false;
  part.chunk.first = std::exchange(records_cut_, records_);
  part.chunk.path = path("keys");
  return part;
}

/// The elements before `end`, where a comma or the closing bracket is, in brackets; nothing in an empty list.
std::optional<JsonPart> JsonSplitter::cut_list(std::size_t end) {
  JsonPart part{JsonPart::Kind::list, take(end)};
  const bool is_empty_list = std::exchange(is_first_cut_, false) && is_list_closed_ &&
                             holds_blanks_only(std::string_view(part.chunk.text).substr(1));
  part.chunk.text += ']';
  part.chunk.first = std::exchange(records_cut_, records_);
  part.chunk.path = path("keys");
  if (!is_list_closed_) {
    if (!text_.empty()) text_[0] = '[';  // in place of the comma
    at_ = std::min(std::max<std::size_t>(at_, 1), text_.size());
  } else if (shape_ == JsonShape::list || shape_ == JsonShape::table) {
    (void)take(1);
    stage_ = Stage::after_list;
  } else {
    stage_ = Stage::object;
    depth_ = 2;
  }
  return is_empty_list ? std::nullopt : std::optional(std::move(part));
}

/// The records up to the last boundary.
std::optional<JsonPart> JsonSplitter::cut() {
  const std::size_t end = *std::exchange(boundary_, std::nullopt);
  if (stage_ == Stage::list) return cut_list(end);
  if (stage_ == Stage::values) return cut_values(end);
  JsonPart part = cut_object(end);
  stage_ = Stage::between_curves;
  return part;
}

/// What is left at the end of the input.
std::optional<JsonPart> JsonSplitter::cut_rest() {
  if (stage_ == Stage::list) {
    stage_ = Stage::unclosed;
    if (!holds_blanks_only(std::string_view(text_).substr(1))) return cut_list(text_.size());
    (void)take(text_.size());
    throw here(text_ends_early());
  }
  if (stage_ == Stage::between_curves) end_curves();
  const Stage stage = std::exchange(stage_, Stage::end);
  const bool is_object = stage == Stage::object || stage == Stage::rest;
  if (is_object && shape_ && shape_ != JsonShape::any) return cut_object(text_.size());
  if (holds_blanks_only(text_)) return std::nullopt;
  if (stage == Stage::values) return cut_values(text_.size());
  shape_ = JsonShape::any;
  return JsonPart{JsonPart::Kind::whole, take(text_.size())};
}

std::optional<JsonPart> JsonSplitter::next() {
  if (stage_ == Stage::unclosed) {
    (void)take(text_.size());
    throw here(text_ends_early());
  }
  while (stage_ != Stage::end) {
    const bool more = scan();
    if (!more && !boundary_ && !read_more()) return cut_rest();
    if (!boundary_) continue;
    if (auto part = cut()) return part;
  }
  return std::nullopt;
}

JsonPart JsonSplitter::whole(JsonPart first) {
  Chunk& chunk = first.chunk;
  chunk.text.pop_back();
  if (is_list_closed_) {
    chunk.text += ']';
  } else if (!text_.empty()) {
    text_[0] = ',';
  }
  text_.insert(0, chunk.text);
  line_ = chunk.line;
  column_ = chunk.column;
  stage_ = Stage::rest;
  while (read_more()) {
  }
  stage_ = Stage::end;
  shape_ = JsonShape::any;
  return {JsonPart::Kind::whole, take(text_.size())};
}

}  // namespace tcb
