// Tape: a JSON text as a list of its values, each with its place in the text.
#include "read/json/tape.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstring>
#include <nlohmann/json.hpp>

#include "numbers/parse_number.hpp"
#include "numbers/print_number.hpp"

namespace tcb {
namespace {

using Json = nlohmann::json;

constexpr std::size_t most_levels = 100;

/// The token for which NaN is exchanged, as the grammar of JSON has none of that size.
constexpr std::string_view nan_token = "NaN", number_for_nan = "0e0";

bool is_word(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_'; }

bool begins_with_nan(std::string_view text) {
  return text.starts_with(nan_token) && (text.size() == nan_token.size() || !is_word(text[nan_token.size()]));
}

/// The text with a number in the place of each NaN outside of strings.
std::string without_nan(std::string_view text) {
  std::string changed(text);
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (text[at] == '"') {
      for (++at; at < text.size() && text[at] != '"'; ++at) at += text[at] == '\\' ? 1 : 0;
    } else if (text[at] == 'N' && begins_with_nan(text.substr(at)) && (at == 0 || !is_word(text[at - 1]))) {
      changed.replace(at, nan_token.size(), number_for_nan);
    }
  }
  return changed;
}

}  // namespace

/// Receives the events of nlohmann-json, with its names, and finds the text of each again. An event that returns false
/// ends the parsing.
class JsonTape::Events {
 public:
  Events(JsonTape& tape, std::size_t begin)
      : tape_(tape),
        text_(tape.part_.chunk.text),
        now_(text_.data() + begin),
        is_list_(tape.part_.kind == JsonPart::Kind::list) {}

  bool null() { return add(Kind::null, 4); }
  bool boolean(bool value) { return add(Kind::boolean, value ? 4 : 5); }
  bool number_integer(Json::number_integer_t) { return add_whole_number(); }
  bool number_unsigned(Json::number_unsigned_t) { return add_whole_number(); }
  bool number_float(Json::number_float_t, const std::string& written) {
    const bool is_nan = *begin() == 'N';
    return add(is_nan ? Kind::null : Kind::number, written.size());
  }
  bool string(const std::string& text) { return add_text(Kind::string, text); }
  bool key(const std::string& text) { return add_text(Kind::name, text); }
  bool binary(const Json::binary_t&) { return false; }
  bool start_object(std::size_t) { return open(Kind::object); }
  bool start_array(std::size_t) { return open(Kind::array); }
  bool end_object() { return close(); }
  bool end_array() { return close(); }
  bool parse_error(std::size_t bytes, const std::string&, const Json::exception& error) {
    constexpr int number_overflow = 406;
    if (error.id == number_overflow) refuse_number(byte(bytes));
    refuse_syntax(bytes);
    return false;
  }

  /// A NaN ended the parsing.
  bool at_nan() const { return at_nan_; }
  const char* now() const { return now_; }

 private:
  /// What was read last.
  enum class Last { nothing, opening, name, value };

  /// The first character of the next token.
  const char* begin() {
    while (is_json_blank(*now_) || *now_ == ',' || *now_ == ':') ++now_;
    return now_;
  }

  bool add(Kind kind, std::size_t size) {
    const auto first = static_cast<std::uint32_t>(begin() - text_.data());
    now_ += size;
    if (tape_.nodes_.size() == tape_.nodes_.capacity()) tape_.require_memory();
    tape_.nodes_.push_back(
        {first, first + static_cast<std::uint32_t>(size), static_cast<std::uint32_t>(tape_.nodes_.size() + 1), kind});
    last_ = Last::value;
    return true;
  }

  bool add_whole_number() {
    const char* end = begin() + (*begin() == '-' ? 1 : 0);
    if (*end++ == '0') return add(Kind::number, static_cast<std::size_t>(end - now_));
    while (end != text_.data() + text_.size() && *end >= '0' && *end <= '9') ++end;
    return add(Kind::number, static_cast<std::size_t>(end - now_));
  }

  /// A text without escapes is as it is written.
  bool add_text(Kind kind, const std::string& text) {
    const char* const first = begin() + 1;
    const std::size_t left = text_.size() - static_cast<std::size_t>(first - text_.data());
    const bool is_plain =
        text.size() < left && first[text.size()] == '"' && std::memcmp(first, text.data(), text.size()) == 0;
    std::size_t size = text.size();
    if (!is_plain) {
      for (size = 0; first[size] != '"'; ++size) size += first[size] == '\\' ? 1 : 0;
    }
    add(kind, size + 2);
    if (!is_plain) {
      tape_.nodes_.back().has_escapes = true;
      tape_.unescaped_.emplace(tape_.nodes_.back().begin, text);
    }
    if (kind == Kind::name) last_ = Last::name;
    return true;
  }

  bool open(Kind kind) {
    if (open_.size() == most_levels) {
      throw data_error("this is nested deeper than {} brackets; expected fewer; remove it", most_levels)
          .at(tape_.position_at(static_cast<std::size_t>(begin() - text_.data())));
    }
    open_.push_back(tape_.nodes_.size());
    add(kind, 1);
    last_ = Last::opening;
    return true;
  }

  bool close() {
    JsonNode& node = tape_.nodes_[open_.back()];
    open_.pop_back();
    node.end = static_cast<std::uint32_t>(begin() - text_.data()) + 1;
    node.next = static_cast<std::uint32_t>(tape_.nodes_.size());
    ++now_;
    last_ = Last::value;
    return true;
  }

  /// The place of the byte that the parser has read last.
  std::size_t byte(std::size_t bytes) const {
    return std::min(static_cast<std::size_t>(parsed_ - text_.data()) + bytes - 1, text_.size());
  }
  std::size_t skip(std::size_t at) const { return std::min(text_.find_first_not_of(" \t\r\n", at), text_.size()); }

  /// The place of the next token, which a comma or colon may precede unless that is the `last` byte.
  std::size_t next_token(std::size_t last, bool& is_separated) const {
    const std::size_t at = skip(static_cast<std::size_t>(now_ - text_.data()));
    is_separated = at < text_.size() && (text_[at] == ',' || text_[at] == ':') && at != last;
    return is_separated ? skip(at + 1) : at;
  }

  [[noreturn]] void refuse_number(std::size_t last) const {
    bool is_separated = false;
    const std::size_t first = next_token(last, is_separated);
    throw data_error("{} is too large for a double; expected less than 1.8e308 in size; correct it",
                     in_quotes(text_.substr(first, last + 1 - first)))
        .at(tape_.position_at(first));
  }

  /// Throws: Error (data) for the last one of the bytes that the parser has read, which breaks the grammar of JSON;
  /// returns at a NaN.
  void refuse_syntax(std::size_t bytes) {
    const std::size_t last = byte(bytes);
    const bool is_end = last + (is_list_ ? 1 : 0) >= text_.size();
    bool is_separated = false;
    const std::size_t begin = next_token(last, is_separated);
    const std::string_view found = text_.substr(begin);
    if (begins_with_nan(found) && tape_.without_nan_.empty()) {
      at_nan_ = true;
      return;
    }
    const auto at = [&](std::size_t place, const Error& error) { return error.at(tape_.position_at(place)); };
    const bool may_be_string = is_separated || last_ == Last::nothing || last_ == Last::opening;
    if (found.starts_with('"') && is_end) {
      throw at(begin, data_error("not JSON: a string is not closed; expected \" at its end; add it"));
    }
    const bool is_key_expected = is_list_ && open_.size() == 1 && may_be_string;
    if (is_key_expected && (is_end || text_[last] == ',')) {
      throw at(last, data_error("no key before or after a comma; expected an object; remove the comma"));
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
  const char* now_;            ///< the end of the last token
  const char* parsed_ = now_;  ///< where the parsing began
  bool is_list_;
  bool at_nan_ = false;
  Last last_ = Last::nothing;
  std::vector<std::size_t> open_;  ///< the arrays and objects around the next value
};

JsonTape::JsonTape(const JsonPart& part, std::uint64_t max_memory) : part_(part), max_memory_(max_memory) {
  if (part.kind != JsonPart::Kind::values) parse(0, true);
}

/// Parses a value from the end of the last one on, which has to be the only one if `is_one`, to node `first` on.
void JsonTape::parse(std::size_t first, bool is_one) {
  nodes_.resize(first);
  Events events(*this, end_);
  const std::string_view text = without_nan_.empty() ? part_.chunk.text : std::string_view(without_nan_);
  const std::string_view left = text.substr(end_);
  const bool is_read =
      Json::sax_parse(left.data(), left.data() + left.size(), &events, Json::input_format_t::json, is_one);
  if (is_read) {
    end_ = static_cast<std::size_t>(events.now() - part_.chunk.text.data());
    return;
  }
  if (!events.at_nan()) return;
  without_nan_ = without_nan(part_.chunk.text);
  parse(first, is_one);
}

/// Throws: Error (data) if the text and twice as many nodes need more memory than is allowed.
void JsonTape::require_memory() const {
  MemoryUse(max_memory_).add(part_.chunk.text.size() + 2 * nodes_.capacity() * sizeof(JsonNode));
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
    end_ = end_of_json_value(text, begin);
    throw;
  }
  return true;
}

std::size_t JsonTape::count(std::size_t value) const {
  std::size_t count = 0;
  const bool is_object = kind(value) == Kind::object;
  for (std::size_t at = value + 1; at < nodes_[value].next; ++count) at = nodes_[is_object ? at + 1 : at].next;
  return count;
}

std::vector<std::uint32_t> JsonTape::elements(std::size_t array) const {
  std::vector<std::uint32_t> values;
  for_each_element(array, [&](std::size_t value) {
    values.push_back(static_cast<std::uint32_t>(value));
    return true;
  });
  return values;
}

std::optional<std::size_t> JsonTape::member(std::size_t object, std::string_view name) const {
  std::optional<std::size_t> found;
  for_each_member(object, [&](std::size_t its_name, std::size_t value) {
    if (text(its_name) != name) return true;
    if (found) {
      throw data_error("{}: the object has this member twice; expected it once; remove one", name)
          .at(position(its_name));
    }
    found = value;
    return true;
  });
  return found;
}

std::string JsonTape::path(std::size_t within, std::size_t value) const {
  std::string path;
  while (within != value) {
    std::size_t index = 0, found = within;
    if (kind(within) == Kind::object) {
      for_each_member(within, [&](std::size_t name, std::size_t of_member) {
        if (value != name && value >= nodes_[of_member].next) return true;
        path += fmt::format(".{}", text(name));
        found = value == name ? value : of_member;
        return false;
      });
    } else {
      for_each_element(within, [&](std::size_t element) {
        if (value >= nodes_[element].next) return ++index, true;
        path += fmt::format("[{}]", index);
        found = element;
        return false;
      });
    }
    within = found;
  }
  return path;
}

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
