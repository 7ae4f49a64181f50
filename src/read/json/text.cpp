// JSON text: the values of a text of JSON as nlohmann-json finds them, and where a text may be cut.
#include "read/json/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>

#include "numbers/decimal_time.hpp"
#include "numbers/parse_number.hpp"
#include "numbers/print_number.hpp"
#include "text/suggest.hpp"

namespace tcb {
namespace {

constexpr std::string_view json_blanks = " \t\r\n";
constexpr std::array<std::string_view, 3> json_words{"true", "false", "null"};
constexpr std::string_view number_characters = "+-.0123456789eE";
constexpr std::uint32_t largest_extent = (1U << 29) - 1;
constexpr std::size_t node_size = 8, distance_of_marks = std::size_t{1} << 20, size_of_nan = 3;

/// About what JSON with comments has; the command leaves that out.
constexpr std::string_view remove_comments =
    "found {}, which JSON does not have; expected JSON; remove it, as in python3 -c 'import re,sys; "
    R"x(print(re.sub(r"(\"(?:\\.|[^\"\\])*\")|//.*|/[*][\s\S]*?[*]/|,(?=(?:\s|//.*|/[*][\s\S]*?[*]/)*[]}}])","\\1",)x"
    "sys.stdin.read()))' <FILE | tcbsample";

/// A text with a number of the same size in the place of each NaN.
std::string without_nan(std::string_view text) {
  constexpr std::string_view before = " \t\r\n[,:", after = " \t\r\n],}";
  std::string masked(text);
  bool in_string = false;
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (in_string && text[at] == '\\') {
      ++at;
    } else if (text[at] == '"') {
      in_string = !in_string;
    } else if (!in_string && text[at] == 'N' && text.substr(at, size_of_nan) == "NaN") {
      const std::size_t end = at + size_of_nan;
      const bool is_value = (at == 0 || before.find(text[at - 1]) != before.npos) &&
                            (end == text.size() || after.find(text[end]) != after.npos);
      if (is_value) masked.replace(at, size_of_nan, "0.0");
    }
  }
  return masked;
}

}  // namespace

/// Makes nodes of the events of the parser, which come directly after their tokens: so a token begins at the first
/// character behind the last one that is no blank, comma or colon.
class Json::Events : public nlohmann::json_sax<nlohmann::json> {
  /// Passes the characters to the parser, which reads each of them once.
  struct CharacterIterator {
    using iterator_category = std::input_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char*;
    using reference = char;
    Events* from;  ///< null at the end

    char operator*() const { return *from->at_; }
    CharacterIterator& operator++() { return ++from->at_, *this; }
    CharacterIterator operator++(int) { return std::exchange(*this, ++CharacterIterator(*this)); }
    bool is_end() const { return from == nullptr || from->at_ == from->end_; }
    friend bool operator==(const CharacterIterator& one, const CharacterIterator& other) {
      return one.is_end() == other.is_end();
    }
    friend bool operator!=(const CharacterIterator& one, const CharacterIterator& other) { return !(one == other); }
  };

 public:
  explicit Events(Json& json)
      : json_(json), text_(json.text_), masked_(text_.find("NaN") == text_.npos ? "" : without_nan(text_)) {
    const std::string_view parsed = masked_.empty() ? text_ : std::string_view(masked_);
    begin_ = at_ = parsed.data();
    end_ = begin_ + parsed.size();
  }

  /// Parses the next value; false at the end.
  bool parse_next() {
    now_ = std::min(text_.find_first_not_of(json_blanks, now_), text_.size());
    if (now_ == text_.size()) return false;
    if (text_.substr(now_).starts_with("\xEF\xBB\xBF")) {  // which the parser would skip
      throw data_error(
          "not JSON: a byte order mark within the text; expected one at its beginning at most; remove it, as in "
          "sed 's/\\xEF\\xBB\\xBF//g' FILE | tcbsample")
          .at(json_.position_at(now_));
    }
    at_ = begin_ + now_;
    nlohmann::json::sax_parse(CharacterIterator{this}, CharacterIterator{nullptr}, this,
                              nlohmann::json::input_format_t::json, false);
    return true;
  }

  // The events, by the names of nlohmann-json.
  bool null() override { return add(Kind::null); }
  bool boolean(bool) override { return add(Kind::boolean); }
  bool number_integer(number_integer_t) override { return add_number(); }
  bool number_unsigned(number_unsigned_t) override { return add_number(); }
  bool number_float(number_float_t, const string_t&) override { return add_number(); }
  bool string(string_t& text) override { return add_text(Kind::string, text); }
  bool key(string_t& text) override { return add_text(Kind::name, text); }
  bool binary(binary_t&) override { return false; }
  bool start_object(std::size_t) override { return open(Kind::object); }
  bool start_array(std::size_t) override { return open(Kind::array); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }
  bool parse_error(std::size_t, const std::string&, const nlohmann::json::exception& error) override {
    const std::size_t begin = std::min(token(), std::max(now_ + 1, static_cast<std::size_t>(at_ - begin_)) - 1);
    const std::string_view last = text_.substr(begin), told = error.what();
    const auto begins_with_last = [&](std::string_view word) { return word.starts_with(last); };
    const bool is_begun = !last.empty() && (last[0] == '"' || std::ranges::any_of(json_words, begins_with_last) ||
                                            last.find_first_not_of(number_characters) == last.npos);
    const bool is_end = told.find("unexpected end of input") != told.npos;
    if (last.empty() || is_end || (at_ == end_ && is_begun)) {
      throw data_error("not JSON: the text ends too early; expected the rest of the last value; complete it")
          .at(json_.position_at(text_.size()));
    }
    constexpr int id_of_overflow = 406;  // the number of out_of_range where a number has no double
    if (error.id == id_of_overflow)
      throw too_large(last.substr(0, last.find_first_not_of(number_characters))).at(json_.position_at(begin));
    if (const std::string other = other_notation(begin); !other.empty()) {
      throw data_error("not JSON: {}", other).at(json_.position_at(begin));
    }
    std::string_view what = told;
    constexpr std::string_view syntax = "syntax error ", number = "] ";
    for (const std::string_view before : {number, syntax}) {
      if (const std::size_t at = what.find(before); at != what.npos) what.remove_prefix(at + before.size());
    }
    throw data_error("not JSON: {}", what.substr(0, what.find("; last read"))).at(json_.position_at(begin));
  }

 private:
  /// What a place has that texts like JSON may have, and how they become JSON; empty: nothing.
  std::string other_notation(std::size_t at) const {
    const std::size_t before = at == 0 ? text_.npos : text_.find_last_not_of(json_blanks, at - 1);
    const std::string_view text = text_.substr(at);
    const auto has = [&](std::string_view word) { return text_.find(word) != text_.npos; };
    if (text.starts_with("//") || text.starts_with("/*")) return fmt::format(remove_comments, "a comment");
    const bool ends = text[0] == ']' || text[0] == '}';
    if (ends && before != text_.npos && text_[before] == ',') return fmt::format(remove_comments, "a comma at the end");
    const std::size_t word = std::min(text.find_first_of(" \t\r\n:,]}[{"), text.size());
    const bool is_letter = (lower(text[0]) >= 'a' && lower(text[0]) <= 'z') || text[0] == '_' || text[0] == '$';
    const bool is_name = is_letter && text.find_first_not_of(json_blanks, word) != text.npos &&
                         text[text.find_first_not_of(json_blanks, word)] == ':';
    const std::string_view value = text.substr(0, word);
    const bool is_python = text[0] == '\'' ? !has("true") && !has("false") && !has("null") && !has("//")
                                           : value == "True" || value == "False" || value == "None";
    if (is_python) {
      return "found what Python prints; expected JSON; convert it, as in python3 -c 'import ast,json,sys; "
             "print(json.dumps(ast.literal_eval(sys.stdin.read())))' <FILE | tcbsample";
    }
    const bool is_number = value.starts_with('+') || value.starts_with('.');
    if (text[0] != '\'' && !is_name && !is_number && value != "undefined" && value != "Infinity") return "";
    return "found what JavaScript or JSON5 has; expected JSON, with names in double quotes; convert it, as in "
           "npx json5 FILE | tcbsample";
  }

  std::size_t token() const { return std::min(text_.find_first_not_of(" \t\r\n,:", now_), text_.size()); }

  static std::uint32_t size_of(std::size_t size) { return static_cast<std::uint32_t>(size); }
  bool add(Kind kind) { return add(kind, static_cast<std::size_t>(at_ - begin_)); }
  bool add(Kind kind, std::size_t end) {
    const std::size_t begin = token();
    now_ = end;
    if (end - begin > largest_extent) {
      throw data_error("a text is longer than 512 MiB; expected a shorter one; remove it").at(json_.position_at(begin));
    }
    json_.nodes_.push_back({static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(kind) & 7U,
                            size_of(end - begin) & largest_extent});
    return true;
  }
  /// The parser has read on to the character behind a number.
  bool add_number() {
    const std::size_t begin = token();
    if (text_[begin] == 'N') return add(Kind::null, begin + size_of_nan);
    const std::size_t end = std::min(text_.find_first_not_of(number_characters, begin), text_.size());
    const std::size_t read = static_cast<std::size_t>(at_ - begin_);
    return add(Kind::number, read == text_.size() ? end : std::min(end, read - 1));
  }
  bool add_text(Kind kind, std::string_view text) {
    add(kind);
    const Node& node = json_.nodes_.back();
    if (text.size() + 2 == node.extent) return true;
    const std::size_t number = json_.size() - 1, begin = json_.characters_.size();
    json_.unescaped_.push_back({static_cast<std::uint32_t>(number), static_cast<std::uint32_t>(begin)});
    json_.characters_ += text;
    return true;
  }
  bool open(Kind kind) {
    constexpr std::size_t most_levels = 100;
    add(kind);
    open_.push_back(json_.size() - 1);
    if (open_.size() <= most_levels) return true;
    throw data_error("this is nested deeper than {} brackets; expected fewer; remove it", most_levels)
        .at(json_.position(open_.back()));
  }
  bool close() {
    json_.nodes_[open_.back()].extent = size_of(json_.size() - 1 - open_.back()) & largest_extent;
    open_.pop_back();
    now_ = static_cast<std::size_t>(at_ - begin_);
    return true;
  }

  Json& json_;
  std::string_view text_;
  const std::string masked_;  ///< the text that is parsed in its place, if it has NaN
  const char *begin_ = nullptr, *at_ = nullptr,
             *end_ = nullptr;      ///< of the parsed text, and behind what the parser has
  std::size_t now_ = 0;            ///< behind the last token
  std::vector<std::size_t> open_;  ///< the arrays and objects around the next value
};

Json::Json(std::string text, LinePosition begin, std::size_t nodes) : text_(std::move(text)) {
  static_assert(sizeof(Node) == node_size);
  set_marks(begin);
  nodes_.reserve(nodes);
  nodes_.push_back({0, static_cast<std::uint32_t>(Kind::array), 0});
  Events events(*this);
  while (events.parse_next()) {
  }
  nodes_[0].extent = static_cast<std::uint32_t>(size() - 1) & largest_extent;
}

std::size_t Json::count(std::size_t value) const {
  return static_cast<std::size_t>(std::ranges::distance(inside(value)));
}

std::vector<std::uint32_t> Json::values(std::size_t value) const {
  std::vector<std::uint32_t> values;
  values.reserve(count(value));
  for (const std::uint32_t inner : inside(value)) values.push_back(inner);
  return values;
}

std::optional<std::size_t> Json::member(std::size_t object, std::string_view wanted) const {
  if (!is(object, Kind::object)) return std::nullopt;
  for (const std::size_t value : inside(object)) {
    if (name(value) == wanted) return value;
  }
  return std::nullopt;
}

bool Json::has_only(std::size_t value, Kind wanted) const {
  return is_nested(value) && !is_empty(value) &&
         std::ranges::all_of(inside(value), [&](std::size_t inner) { return is(inner, wanted); });
}

bool Json::holds(std::size_t value, Kind wanted) const {
  const auto begin = nodes_.begin() + static_cast<std::ptrdiff_t>(value);
  return std::any_of(begin, nodes_.begin() + static_cast<std::ptrdiff_t>(next(value)),
                     [&](const Node& node) { return static_cast<Kind>(node.kind) == wanted; });
}

/// Behind the last character of an array or an object.
std::size_t Json::end_of(std::size_t value) const {
  const bool holds_none = is_empty(value);
  const std::size_t last = holds_none ? value : next(value) - 1;
  std::size_t at = nodes_[last].begin + (is_nested(last) ? 1 : nodes_[last].extent);
  std::size_t depth = 0;  // of brackets that end behind the last node
  for (std::size_t node = last; node > value; --node) depth += is_nested(node) && next(node) > last ? 1 : 0;
  for (std::size_t left = depth + 1; left > 0; ++at) left -= text_[at] == ']' || text_[at] == '}' ? 1 : 0;
  return at;
}

std::string_view Json::text(std::size_t value) const {
  const std::string_view all = written(value);
  if (!is(value, Kind::string) && !is_name(value)) return all;
  const auto found = std::ranges::lower_bound(unescaped_, value, {}, &Unescaped::node);
  if (found == unescaped_.end() || found->node != value) return all.substr(1, all.size() - 2);
  const std::size_t end = found + 1 == unescaped_.end() ? characters_.size() : (found + 1)->begin;
  return std::string_view(characters_).substr(found->begin, end - found->begin);
}

std::string_view Json::written(std::size_t value) const {
  const Node& node = nodes_[value];
  const std::size_t size = is_nested(value) ? end_of(value) - node.begin : node.extent;
  return std::string_view(text_).substr(node.begin, size);
}

std::string Json::path(std::size_t within, std::size_t value) const {
  std::string path;
  while (is_nested(within)) {
    std::size_t number = 0;
    JsonIterator inner = inside(within).begin();
    while (next(*inner) <= value) ++inner, ++number;
    within = *inner;
    path +=
        is_member(within) ? fmt::format("{}{}", path.empty() ? "" : ".", name(within)) : fmt::format("[{}]", number);
    if (within == value || within == value + 1) break;
  }
  return path;
}

std::string Json::shown(std::size_t value) const {
  switch (kind(value)) {
    case Kind::array: return "an array";
    case Kind::object: return "an object";
    case Kind::number: return "a number";
    case Kind::null: return std::string(text(value));
    default: return in_quotes(text(value));
  }
}

TextPosition Json::position(std::size_t value) const { return position_at(nodes_[value].begin); }

void Json::set_marks(LinePosition begin) {
  marks_.push_back({0, begin});
  while (marks_.back().byte + distance_of_marks < text_.size()) {
    const Mark& last = marks_.back();
    const std::string_view between = std::string_view(text_).substr(last.byte, distance_of_marks);
    marks_.push_back({last.byte + distance_of_marks, position_after(between, last.at)});
  }
}

Json::Mark Json::mark_at(std::size_t byte, const Mark& last) const {
  const bool is_near = last.at.line > 0 && last.byte <= byte && byte - last.byte < distance_of_marks;
  const Mark& from = is_near ? last : marks_[std::min(byte / distance_of_marks, marks_.size() - 1)];
  return {byte, position_after(std::string_view(text_).substr(from.byte, byte - from.byte), from.at)};
}

TextPosition Json::position_at(std::size_t byte) const {
  const LinePosition at = mark_at(byte, {0, {0, 0}}).at;
  return {"", at.line, at.column};
}

bool JsonBlocks::read_more() {
  if (is_read_) return false;
  // Memory that is not used yet takes no pages, and a text that grows seldom is seldom copied.
  constexpr std::size_t large = std::size_t{1} << 22, growth = 8;
  std::string& text = left_.text;
  if (text.size() > large && text.capacity() - text.size() < large / growth) text.reserve(growth * text.size());
  is_read_ = !bytes_.append_to(left_.text, left_.begin);
  return !is_read_;
}

/// Goes on to the end of what was read, or of so many lines.
void JsonBlocks::scan(std::size_t most_lines) {
  const std::string& text = left_.text;
  for (; at_ < text.size() && left_.lines < most_lines; ++at_) {
    const char c = text[at_];
    if (in_string_) {
      if (c == '\\') ++at_, ++left_.escapes;
      in_string_ = c != '"';
      continue;
    }
    switch (c) {
      case '"': in_string_ = true; [[fallthrough]];
      default: left_.nodes += depth_ == 0 ? 1 : 0; break;
      case '[':
      case '{':
        left_.nodes += depth_ == 0 ? 2 : 1;
        left_.values += depth_ == 0 ? 1 : 0;
        ++depth_;
        break;
      case ',':
      case ':': ++left_.nodes; break;
      case ']':
      case '}': depth_ -= depth_ > 0 ? 1 : 0; break;
      case ' ':
      case '\t':
      case '\r': continue;
      case '\n':
        if (depth_ > 0 || !has_value_) continue;
        has_value_ = false;
        end_ = at_ + 1;
        end_nodes_ = left_.nodes;
        end_escapes_ = left_.escapes;
        ++left_.lines;
        continue;
    }
    has_value_ = true;
  }
}

/// Reads on to the end of so many lines, or of the input.
void JsonBlocks::fill(std::size_t lines, std::size_t most_lines) {
  constexpr std::size_t bytes_of_node = node_size + sizeof(std::uint32_t);  // and its place in a list of values
  constexpr std::size_t bytes_of_escape = 24, most_bytes = std::numeric_limits<std::uint32_t>::max();
  do {
    scan(most_lines);
    const bool has_lines = left_.lines >= lines;
    const std::uint64_t needed = left_.text.size() + left_.nodes * bytes_of_node + left_.escapes * bytes_of_escape;
    const bool is_too_large = needed > most_ || left_.text.size() > most_bytes || left_.nodes > largest_extent;
    if (!has_lines && is_too_large) refuse_size();
    if (has_lines) return;
  } while (read_more());
}

/// Throws: Error (data) with the memory that the whole text needs.
void JsonBlocks::refuse_size() {
  constexpr std::uint64_t mebibyte = 1ULL << 20, bytes_of_byte = 8, most_times = 16;
  const bool is_list = left_.text.find_first_not_of(json_blanks) == left_.text.find('[');
  std::uint64_t size = left_.text.size();
  for (std::string more; size < most_times * most_ && bytes_.append_to(more, {}); more.clear()) size += more.size();
  throw data_error(
      "JSON that is one {0} is kept as a whole, which needs up to {1} MiB of memory here; expected at most {2} MiB; "
      "{3}give --max-memory {1}MiB",
      is_list ? "array" : "value", bytes_of_byte * size / mebibyte + 1, most_ / mebibyte,
      is_list ? "make a line of each key, as in jq -c '.[]' FILE | tcbsample, or " : "");
}

std::optional<JsonBlock> JsonBlocks::next() {
  constexpr std::size_t no_limit = std::numeric_limits<std::size_t>::max();
  const bool is_first = std::exchange(is_first_, false);
  is_first ? fill(most_first_records, most_first_records) : fill(1, no_limit);
  return left_.lines == 0 || (is_first && left_.lines < most_first_records) ? rest() : cut();
}

std::optional<JsonBlock> JsonBlocks::whole() {
  constexpr std::size_t no_limit = std::numeric_limits<std::size_t>::max();
  fill(no_limit, no_limit);
  return rest();
}

bool JsonBlocks::is_at_end() {
  while (left_.text.find_first_not_of(json_blanks) == std::string::npos) {
    if (!read_more()) return true;
  }
  return false;
}

/// All that was read; nothing if it is blank.
std::optional<JsonBlock> JsonBlocks::rest() {
  if (left_.text.find_first_not_of(json_blanks) == std::string::npos) return std::nullopt;
  return std::exchange(left_, {});
}

/// What is up to the last line that ends outside of values.
JsonBlock JsonBlocks::cut() {
  JsonBlock rest{left_.text.substr(end_), {}, left_.nodes - end_nodes_, left_.escapes - end_escapes_};
  left_.text.resize(end_);
  left_.nodes = end_nodes_;
  left_.escapes = end_escapes_;
  rest.begin = position_after(left_.text, left_.begin);
  at_ -= std::exchange(end_, 0);
  return std::exchange(left_, std::move(rest));
}

std::string json_number_text(std::string_view decimal) {
  const bool is_whole = decimal.find_first_of(".eE") == std::string_view::npos && decimal != "-0";
  std::uint64_t digits = 0;
  const char* const begin = decimal.data() + (decimal.starts_with('-') ? 1 : 0);
  const bool is_exact = is_whole && std::from_chars(begin, decimal.data() + decimal.size(), digits).ec == std::errc() &&
                        (begin == decimal.data() || digits <= std::uint64_t{1} << 63);
  return is_exact ? std::string(decimal) : time_text(Time(parse_number(decimal).value_or(0)));
}

Error too_large(std::string_view decimal) {
  return data_error("{} is too large for a double; expected less than 1.8e308 in size", in_quotes(decimal));
}

Error twice_in(std::string_view holder) {
  return data_error("the {} has this member twice; expected it once; remove one", holder);
}

}  // namespace tcb
