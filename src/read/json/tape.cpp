// Tape: a JSON text as a list of its values, each with its place in the text.
#include "read/json/tape.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstring>
#include <limits>
#include <nlohmann/json.hpp>

#include "numbers/parse_number.hpp"
#include "numbers/print_number.hpp"
#include "text/suggest.hpp"

namespace tcb {
namespace {

constexpr std::size_t most_levels = 100;

bool is_word(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || is_digit(c) || c == '_'; }

bool is_plain(char c) { return c >= ' ' && static_cast<unsigned char>(c) < 0x80 && c != '"' && c != '\\'; }

/// The characters of a text as nlohmann-json gets them, which takes a long time for each. It would convert each number,
/// but numbers are converted where they are used, and a zero in the place of digits has their syntax. A string of
/// printable ASCII without escapes is an empty one, as its text is as it is written. Blanks after a comma or a colon
/// are left out. NaN, which JSON does not have, is a zero, too. The NUL after the text ends it.
class Characters {
 public:
  using iterator_category = std::forward_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = char;

  /// `read`: the place of the character that was read last.
  Characters(const char* at, const char*& read) : at_(at), read_(&read) {}

  char operator*() const { return begins_digits() || is_nan() ? '0' : *at_; }
  Characters& operator++() {
    *read_ = at_;
    if (in_string_) {
      in_string_ = *at_ != '"' || is_escaped_;
      is_escaped_ = *at_ == '\\' && !is_escaped_;
    } else if (*at_ == '"') {
      in_string_ = true;
      const char* end = at_ + 1;
      while (is_plain(*end)) ++end;
      if (*end == '"') at_ = end - 1;
    } else if (*at_ == ',' || *at_ == ':') {
      while (is_json_blank(at_[1])) ++at_;
    } else if (begins_digits()) {
      while (is_digit(at_[1])) ++at_;
    } else if (is_nan()) {
      at_ += 2;
    }
    before_ = *at_++;
    return *this;
  }
  bool operator==(const Characters& other) const { return at_ == other.at_; }

  const char* place() const { return at_; }
  /// A zero is given by itself, as another digit may not follow one that begins a number.
  bool begins_digits() const { return *at_ >= '1' && *at_ <= '9' && !in_string_; }

 private:
  bool is_nan() const {
    return *at_ == 'N' && !in_string_ && std::strncmp(at_, "NaN", 3) == 0 && !is_word(at_[3]) &&
           (before_ == ',' || before_ == ':' || before_ == '[' || is_json_blank(before_));
  }

  const char* at_;
  const char** read_;
  char before_ = ' ';
  bool in_string_ = false, is_escaped_ = false;
};

/// Where the value that begins at `at` ends, by its strings and brackets, or the end of the text.
std::size_t end_of_value(std::string_view text, std::size_t at) {
  std::size_t depth = 0;
  for (; at < text.size(); ++at) {
    const char c = text[at];
    if (c == '"') {
      for (++at; at < text.size() && text[at] != '"'; ++at) at += text[at] == '\\' ? 1 : 0;
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

}  // namespace

/// Receives the events of nlohmann-json, with its names. An event follows the last character of its text, but that of a
/// number the character after it. One that returns false ends the parsing.
class JsonTape::Events {
 public:
  using Json = nlohmann::json;

  Events(JsonTape& tape, std::size_t begin)
      : tape_(tape),
        text_(tape.part_.chunk.text),
        now_(text_.data() + begin),
        is_list_(tape.part_.kind == JsonPart::Kind::list) {}

  bool null() { return add(Kind::null); }
  bool boolean(bool) { return add(Kind::boolean); }
  bool number_integer(Json::number_integer_t) { return add_number(false); }
  bool number_unsigned(Json::number_unsigned_t) { return add_number(false); }
  bool number_float(Json::number_float_t, const std::string&) { return add_number(true); }
  bool string(const std::string& text) { return add_text(Kind::string, text); }
  bool key(const std::string& text) { return add_text(Kind::name, text); }
  bool binary(const Json::binary_t&) { return false; }
  bool start_object(std::size_t) { return open(Kind::object); }
  bool start_array(std::size_t) { return open(Kind::array); }
  bool end_object() { return close(); }
  bool end_array() { return close(); }
  bool parse_error(std::size_t count, const std::string&, const Json::exception&) { refuse_syntax(count); }

  const char*& read() { return read_; }
  const char* now() const { return now_; }

 private:
  /// What was read last.
  enum class Last { nothing, opening, name, value };

  std::uint32_t place(const char* at) const { return static_cast<std::uint32_t>(at - text_.data()); }

  /// The first character of the next token.
  const char* begin() {
    while (is_json_blank(*now_) || *now_ == ',' || *now_ == ':') ++now_;
    return now_;
  }

  bool add(Kind kind) { return add(kind, read_ + 1); }
  bool add(Kind kind, const char* end) {
    const std::uint32_t first = place(begin());
    now_ = end;
    if (tape_.nodes_.size() == tape_.nodes_.capacity()) tape_.require_memory();
    tape_.nodes_.push_back({first, place(end), static_cast<std::uint32_t>(tape_.nodes_.size() + 1), kind});
    last_ = Last::value;
    return true;
  }

  bool add_number(bool may_have_exponent) {
    if (*begin() == 'N') return add(Kind::null, read_);
    add(Kind::number, read_);
    constexpr std::size_t longest = 308;  // of a number that is no double only by its exponent
    const std::string_view number = tape_.written(tape_.size() - 1);
    const bool has_exponent =
        may_have_exponent && (number.find('e') < number.size() || number.find('E') < number.size());
    if ((has_exponent || number.size() > longest) && !parse_number(number)) {
      throw too_large(number).at(tape_.position(tape_.size() - 1));
    }
    return true;
  }

  /// A text without escapes is as it is written; `text` is empty for one that is plain.
  bool add_text(Kind kind, const std::string& text) {
    add(kind);
    JsonNode& node = tape_.nodes_.back();
    node.has_escapes = !text.empty() && tape_.text(tape_.size() - 1) != text;
    if (node.has_escapes) tape_.unescaped_.emplace(node.begin, text);
    if (kind == Kind::name) last_ = Last::name;
    return true;
  }

  bool open(Kind kind) {
    if (open_.size() == most_levels) {
      throw data_error("this is nested deeper than {} brackets; expected fewer; remove it", most_levels)
          .at(tape_.position_at(place(begin())));
    }
    open_.push_back(tape_.nodes_.size());
    add(kind);
    last_ = Last::opening;
    return true;
  }

  bool close() {
    JsonNode& node = tape_.nodes_[open_.back()];
    open_.pop_back();
    now_ = read_ + 1;
    node.end = place(now_);
    node.next = static_cast<std::uint32_t>(tape_.nodes_.size());
    last_ = Last::value;
    return true;
  }

  std::size_t skip(std::size_t at) const { return std::min(text_.find_first_not_of(" \t\r\n", at), text_.size()); }

  /// The place of the next token, which a comma or colon may precede unless that is the `last` byte.
  std::size_t next_token(std::size_t last, bool& is_separated) const {
    const std::size_t at = skip(static_cast<std::size_t>(now_ - text_.data()));
    is_separated = at < text_.size() && (text_[at] == ',' || text_[at] == ':') && at != last;
    return is_separated ? skip(at + 1) : at;
  }

  /// The place of the last one of the characters that the parser has read and not given back.
  std::size_t last_place(std::size_t count) const {
    const char* read = nullptr;
    Characters last(parsed_, read);
    for (; count > 1 && last.place() < text_.data() + text_.size(); --count) ++last;
    const char* at = last.place();
    while (last.begins_digits() && is_digit(at[1])) ++at;
    return place(at);
  }

  /// Throws: Error (data) for the last one of the characters that the parser has read, which breaks the grammar of
  /// JSON.
  [[noreturn]] void refuse_syntax(std::size_t count) const {
    const std::size_t last = last_place(count);
    const bool is_end = last + (is_list_ ? 1 : 0) >= text_.size();
    bool is_separated = false;
    const std::size_t begin = next_token(last, is_separated);
    const std::string_view found = text_.substr(begin);
    const auto at = [&](std::size_t place, const Error& error) { return error.at(tape_.position_at(place)); };
    const bool may_be_string = is_separated || last_ == Last::nothing || last_ == Last::opening;
    if (found.starts_with('"') && is_end) {
      throw at(begin, data_error("not JSON: a string is not closed; expected \" at its end; add it"));
    }
    const bool is_key_expected = is_list_ && open_.size() == 1 && may_be_string;
    if (is_key_expected && (is_end || text_[last] == ',')) {
      throw at(last, no_key_at_comma());
    }
    if (is_end) {
      const std::size_t end = text_.size() - (is_list_ ? 1 : 0);  // without the bracket that the splitter adds
      throw at(std::min(last, end),
               data_error("not JSON: the text ends too early; expected the rest of the last value; complete it"));
    }
    std::string_view token = text_.substr(begin, last + 1 - begin);
    if (token.starts_with('"')) {
      token.remove_prefix(1);
      if (may_be_string) {
        throw at(last, data_error("not JSON: the last character of {} is not allowed in a string; expected UTF-8 "
                                  "without control characters, and only the escapes of JSON; correct the text",
                                  in_quotes(token)));
      }
      if (token.ends_with('"')) token.remove_suffix(1);
    }
    throw at(begin,
             data_error("not JSON: found {}; expected {}; correct the text", in_quotes(token), expected(is_separated)));
  }

  /// What may follow what was read, and a comma or colon after that.
  std::string_view expected(bool is_separated) const {
    switch (last_) {
      case Last::nothing: return "a value";
      case Last::opening: return now_[-1] == '{' ? "a name in quotes" : "a value";
      case Last::name: return is_separated ? "a value" : "a colon after the name";
      case Last::value: break;
    }
    if (open_.empty()) return "nothing after the last bracket";
    return is_separated ? "another value or member after the comma" : "a comma or a closing bracket";
  }

  JsonTape& tape_;
  std::string_view text_;
  const char* read_ = nullptr;  ///< the place of the last character that the parser has read
  const char* now_;             ///< the end of the last token
  const char* parsed_ = now_;   ///< where the parsing began
  bool is_list_;
  Last last_ = Last::nothing;
  std::vector<std::size_t> open_;  ///< the arrays and objects around the next value
};

JsonTape::JsonTape(const JsonPart& part, std::uint64_t max_memory) : part_(part), max_memory_(max_memory) {
  if (part.chunk.text.size() > std::numeric_limits<std::uint32_t>::max()) {
    throw data_error(
        "the text has more than 4 GiB and is read as a whole; expected less; write a list of objects, which is read in "
        "parts");
  }
  if (part.kind != JsonPart::Kind::values) parse(0, true);
}

/// Parses a value from the end of the last one on, which has to be the only one if `is_one`, to node `first` on.
void JsonTape::parse(std::size_t first, bool is_one) {
  nodes_.resize(first);
  Events events(*this, end_);
  const char* const text = part_.chunk.text.c_str();
  nlohmann::json::sax_parse(Characters(text + end_, events.read()),
                            Characters(text + part_.chunk.text.size() + 1, events.read()), &events,
                            nlohmann::json::input_format_t::json, is_one);
  end_ = static_cast<std::size_t>(events.now() - text);
}

/// Throws: Error (data) if the text and twice as many nodes need more memory than is allowed.
void JsonTape::require_memory() const {
  constexpr std::size_t bytes_of_unescaped = 96;  // a short string in its table
  const std::size_t texts = unescaped_.empty() ? 1 : 2;
  MemoryUse(max_memory_)
      .add(texts * part_.chunk.text.size() +
           2 * (nodes_.capacity() * sizeof(JsonNode) + unescaped_.size() * bytes_of_unescaped));
}

bool JsonTape::read_next(bool keeps_last) {
  const std::string_view text = part_.chunk.text;
  const auto skip_blanks = [&] { end_ = std::min(text.find_first_not_of(" \t\r\n", end_), text.size()); };
  skip_blanks();
  if (text.substr(end_).starts_with(byte_order_mark)) end_ += byte_order_mark.size();
  skip_blanks();
  if (end_ == text.size()) return false;
  const std::size_t begin = end_, first = keeps_last ? nodes_.size() : 0;
  if (!keeps_last) unescaped_.clear();
  try {
    parse(first, false);
  } catch (const Error&) {
    nodes_.resize(first);
    end_ = end_of_value(text, begin);
    throw;
  }
  return true;
}

std::optional<std::size_t> JsonTape::member(std::size_t object, std::string_view name) const {
  std::optional<std::size_t> found;
  for (const std::size_t other : inside(object)) {
    if (text(other) != name) continue;
    if (found) throw twice_in("object").about(name).at(position(other));
    found = value_of(other);
  }
  return found;
}

std::string JsonTape::path(std::size_t within, std::size_t value) const {
  std::string path;
  while (within != value) {
    std::size_t index = 0;
    const auto all = inside(within);
    const auto inner = std::ranges::find_if(all, [&](std::size_t other) {
      ++index;
      return value == other || value < nodes_[value_of(other)].next;
    });
    if (inner == all.end()) return path;
    const bool is_name = kind(*inner) == Kind::name;
    path += is_name ? fmt::format(".{}", text(*inner)) : fmt::format("[{}]", index - 1);
    within = value == *inner ? value : value_of(*inner);
  }
  return path;
}

Error too_large(std::string_view decimal) {
  return data_error("{} is too large for a double; expected less than 1.8e308 in size; correct it", in_quotes(decimal));
}

Error twice_in(std::string_view holder) {
  return data_error("the {} has this member twice; expected it once; remove one", holder);
}

Error no_key_at_comma() { return data_error("no key before or after a comma; expected an object; remove the comma"); }

std::string json_number_text(std::string_view decimal) {
  const bool is_whole = decimal.find_first_of(".eE") == std::string_view::npos && decimal != "-0";
  std::uint64_t digits = 0;
  const char* const begin = decimal.data() + (decimal.starts_with('-') ? 1 : 0);
  const bool is_exact = is_whole && std::from_chars(begin, decimal.data() + decimal.size(), digits).ec == std::errc() &&
                        (begin == decimal.data() || digits <= std::uint64_t{1} << 63);
  return is_exact ? std::string(decimal) : time_text(Time(parse_number(decimal).value_or(0)));
}

TextPosition JsonTape::position_at(std::size_t byte) const {
  const Chunk& chunk = part_.chunk;
  const std::string_view text = chunk.text;
  const LinePosition at = byte < part_.seam ? position_after(text.substr(0, byte), {chunk.line, chunk.column})
                                            : position_after(text.substr(part_.seam, byte - part_.seam), part_.after);
  return {"", at.line, at.column};
}

}  // namespace tcb
