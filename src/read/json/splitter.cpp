// JSON splitter: a JSON text is cut into whole records, by its strings and brackets alone.
#include "read/json/splitter.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <tuple>

#include "read/input.hpp"
#include "text/suggest.hpp"

namespace tcb {
namespace {

constexpr std::size_t longest_json_record = 64UL * 1024 * 1024;

/// The characters that determine where records end.
constexpr std::array<bool, 256> is_structure = [] {
  std::array<bool, 256> found{};
  for (const char c : std::string_view("\"[]{},")) found[static_cast<unsigned char>(c)] = true;
  return found;
}();

}  // namespace

JsonShape JsonSplitter::shape() const { return shape_.value_or(JsonShape::lines); }

/// Reads on; false at the end of the input, and where whole records are to be cut off first.
bool JsonSplitter::read_more() {
  if (boundary_ || is_input_read_) return false;
  const bool is_in_records = stage_ == Stage::list || stage_ == Stage::values;
  if (is_in_records && text_.size() > longest_json_record) {
    throw here(data_error("a key is longer than 64 MiB; expected a shorter one; remove what it does not need"));
  }
  if (!is_in_records) MemoryUse(max_memory_).add(text_.size());
  is_input_read_ = !bytes_.append_to(text_, {line_, column_});
  return !is_input_read_;
}

/// Goes from `at` to a character that is no blank, and returns it; NUL at the end of the input.
char JsonSplitter::skip_blanks(std::size_t& at) {
  do {
    at = std::min(text_.find_first_not_of(" \t\r\n", at), text_.size());
  } while (at == text_.size() && read_more());
  return at < text_.size() ? text_[at] : '\0';
}

/// Goes from a quote to the one that closes the string; false if the text ends before it.
bool JsonSplitter::skip_string() {
  ++at_;
  do {
    const char* at = text_.data() + at_;
    const char* const last = text_.data() + text_.size() - 1;
    while (at <= last && *at != '"' && (*at != '\\' || at < last)) at += *at == '\\' ? 2 : 1;
    at_ = static_cast<std::size_t>(at - text_.data());
  } while (text_[at_] != '"' && read_more());
  return text_[at_] == '"';
}

/// Cuts off and returns the text up to `end`.
Chunk JsonSplitter::take(std::size_t end) {
  std::string rest = text_.substr(end);
  text_.resize(end);
  Chunk chunk{std::exchange(text_, std::move(rest)), line_, column_};
  column_ = column_after(chunk.text, column_);
  line_ += count_lines(chunk.text);
  at_ = 0;
  return chunk;
}

/// "curves[2]" and the path within it, or the latter alone.
std::string JsonSplitter::path(std::string_view list) const {
  if (shape_ != JsonShape::curves) return std::string(list);
  return fmt::format("curves[{}]{}{}", curve_, list.empty() ? "" : ".", list);
}

void JsonSplitter::start() {
  stage_ = Stage::rest;
  const char first = skip_blanks(at_);
  if (first == '{') {
    stage_ = Stage::object;
  } else if (first == '[') {
    std::size_t inner = at_ + 1;
    const char second = skip_blanks(inner);
    const char third = second == '[' ? skip_blanks(++inner) : second;
    const bool is_nested = second == '[' && (third == '[' || third == '{');  // rows hold no nested values
    if (second != '[' && second != '{' && is_row_followed_by_row()) {
      shape_ = JsonShape::table;
      stage_ = Stage::values;
    } else if (third != '\0' && !is_nested) {
      begin_list(second == '[' ? JsonShape::table : JsonShape::list);
    }
  } else if (first != '\0') {
    shape_ = JsonShape::lines;
    stage_ = Stage::values;
  }
}

/// Whether the array that begins here holds no other one, and another array follows it, as where each line is a row.
bool JsonSplitter::is_row_followed_by_row() {
  constexpr std::size_t longest = 1UL << 16;
  std::size_t end = at_ + 1;
  while ((end = std::min(text_.find_first_of("[]{}", end), text_.size())) == text_.size() && end < longest) {
    if (!read_more()) return false;
  }
  if (end == text_.size() || text_[end] != ']') return false;
  return skip_blanks(++end) == '[';
}

/// The keys begin at the current bracket.
void JsonSplitter::begin_list(JsonShape shape) {
  if (!shape_) shape_ = shape;
  Chunk before = take(at_);
  if (shape == JsonShape::object) before_ = std::move(before);
  at_ = 1;
  stage_ = Stage::list;
  has_list_ = is_first_cut_ = true;
  is_list_closed_ = false;
  records_ = records_cut_ = 0;
}

/// Whether the array that begins here is that of the keys, not one of numbers or rows.
bool JsonSplitter::begins_keys() {
  if (has_list_ || (name() != "keys" && name() != "rows")) return false;
  std::size_t next = at_ + 1;
  const char first = skip_blanks(next);
  return first != '\0' && first != '[' && first != '-' && !is_digit(first);
}

/// Scans an object to its keys or curves, or to its end.
std::optional<JsonPart> JsonSplitter::scan_object() {
  for (;; ++at_) {
    while (at_ == text_.size()) {
      if (!read_more()) return take_rest();
    }
    const char c = text_[at_];
    if (c == '"') {
      const std::size_t begin = at_ + 1;
      if (!skip_string()) return take_rest();
      if (depth_ == 1) std::tie(name_begin_, name_end_) = std::pair(begin, at_);
    } else if (c == '[' && depth_ == 1 && !shape_ && name() == "curves") {
      shape_ = JsonShape::curves;
      before_curves_ = take(at_ + 1);
      depth_ = name_begin_ = name_end_ = 0;
      stage_ = Stage::curves;
      return std::nullopt;
    } else if (c == '[' && depth_ == 1 && begins_keys()) {
      begin_list(JsonShape::object);
      return std::nullopt;
    } else if (c == '{' || c == '[') {
      ++depth_;
    } else if ((c == '}' || c == ']') && --depth_ == 0) {
      ++at_;
      return end_object();
    }
  }
}

/// An object ends: a curve, the one around keys or curves, or one of several values, or the whole text.
std::optional<JsonPart> JsonSplitter::end_object() {
  if (shape_ == JsonShape::curves) {
    stage_ = Stage::curves;
    return cut_object(at_);
  }
  if (shape_ || skip_blanks(at_) == '\0') return take_rest();
  shape_ = JsonShape::lines;
  stage_ = Stage::values;
  ++records_;
  return std::nullopt;
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

/// Skips a comma and blanks to the next curve, or to the end of their list, where the object around them continues.
void JsonSplitter::scan_to_curve() {
  stage_ = Stage::object;
  char c = skip_blanks(at_);
  const bool has_comma = curve_ == 0 || c == ',';
  if (curve_ > 0 && c == ',') c = skip_blanks(++at_);
  (void)take(at_);
  if (c == '{' && has_comma) {
    has_list_ = false;
    name_begin_ = name_end_ = 0;
    before_ = {};
  } else if (c == '\0' || (c == ']' && (curve_ == 0 || !has_comma))) {
    before_ = std::move(before_curves_);
    before_.text.pop_back();  // the opening bracket, which cut_object() adds
    has_list_ = true;
    shape_ = JsonShape::object;  // from here on
    depth_ = 2;
  } else if (has_comma) {
    throw here(data_error("no curve here; expected an object with \"keys\"; correct the text"));
  } else {
    throw here(data_error("no comma after a curve; expected one, or the end of \"curves\"; correct the text"));
  }
}

/// Scans records to the last one that the text holds whole, or to the end of their list.
void JsonSplitter::scan_records() {
  const bool is_list = stage_ == Stage::list;
  /// Whether the first part has enough records.
  const auto end_record = [&](std::size_t end) {
    boundary_ = end;
    return ++records_ == most_first_records && is_first_cut_;
  };
  for (std::size_t depth = 0;; ++at_) {
    do {
      const char* at = text_.data() + at_;
      const char* const end = text_.data() + text_.size();
      while (at != end && !is_structure[static_cast<unsigned char>(*at)]) ++at;
      at_ = static_cast<std::size_t>(at - text_.data());
    } while (at_ == text_.size() && read_more());
    if (at_ == text_.size()) return;
    switch (text_[at_]) {
      case '"':
        if (!skip_string()) return;
        break;
      case '{':
      case '[': ++depth; break;
      case ',':
        if (is_list && depth == 0 && end_record(at_)) return;
        break;
      case ']':
        is_list_closed_ = is_list && depth == 0;
        if (is_list_closed_) return void(end_record(at_));
        [[fallthrough]];
      default:  // a brace; one that nothing opened stays in its record, where the parser finds it
        if (depth > 0) --depth;
        if (!is_list && depth == 0 && end_record(at_ + 1)) return;
    }
  }
}

/// The whole records of the text; nothing for an empty list.
std::optional<JsonPart> JsonSplitter::next_records() {
  const bool is_list = stage_ == Stage::list;
  scan_records();
  const bool is_rest = !boundary_;  // the input ends
  JsonPart part{is_list ? JsonPart::Kind::list : JsonPart::Kind::values,
                take(std::exchange(boundary_, std::nullopt).value_or(text_.size()))};
  const bool is_blank = std::all_of(part.chunk.text.begin() + (is_list ? 1 : 0), part.chunk.text.end(), is_json_blank);
  const bool is_empty = is_blank && (is_rest || (is_first_cut_ && is_list_closed_));
  if (is_list) part.chunk.text += ']';
  part.chunk.first = std::exchange(records_cut_, records_);
  part.chunk.path = path("keys");
  is_first_cut_ = false;
  if (is_rest) {
    stage_ = is_list ? Stage::unclosed : Stage::end;
  } else if (is_list && !is_list_closed_) {
    text_[0] = '[';  // in place of the comma
    at_ = 1;
  } else if (is_list) {
    const bool is_outermost = shape_ == JsonShape::list || shape_ == JsonShape::table;
    if (is_outermost) (void)take(1);
    stage_ = is_outermost ? Stage::after_list : Stage::object;
    depth_ = 2;
  }
  return is_empty ? std::nullopt : std::optional(std::move(part));
}

/// What is left of the input: of an object around keys, or of a text of another shape; nothing if it is blank.
std::optional<JsonPart> JsonSplitter::take_rest() {
  while (read_more()) {
  }
  stage_ = Stage::end;
  if (shape_) return cut_object(text_.size());
  if (std::ranges::all_of(text_, is_json_blank)) return std::nullopt;
  shape_ = JsonShape::any;
  return JsonPart{JsonPart::Kind::whole, take(text_.size())};
}

std::optional<JsonPart> JsonSplitter::next() {
  std::optional<JsonPart> part;
  while (!part && stage_ != Stage::end) {
    switch (stage_) {
      case Stage::start: start(); break;
      case Stage::object: part = scan_object(); break;
      case Stage::curves: scan_to_curve(); break;
      case Stage::list:
      case Stage::values: part = next_records(); break;
      case Stage::after_list:
        stage_ = Stage::end;
        if (skip_blanks(at_) == '\0') break;
        (void)take(at_);
        if (text_[0] == '[') {
          throw here(
              data_error("another array follows the first one; expected one array of all keys; put the keys "
                         "into one"));
        }
        throw here(data_error("there is text after the array of keys; expected nothing; remove it"));
      case Stage::unclosed:
        (void)take(text_.size());
        throw here(data_error("not JSON: the text ends too early; expected the rest of the last value; complete it"));
      case Stage::rest:
      case Stage::end: part = take_rest();
    }
  }
  return part;
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
