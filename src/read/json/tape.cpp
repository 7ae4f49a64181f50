// Tape: a JSON text as a list of its values, each with its place in the text.
#include "read/json/tape.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <limits>
#include <nlohmann/json.hpp>

#include "numbers/parse_number.hpp"
#include "numbers/print_number.hpp"
#include "text/suggest.hpp"

namespace tcb {
namespace {

constexpr std::size_t most_levels = 100;

bool is_word(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || is_digit(c) || c == '_'; }

/// Where the string that begins at `at` ends, after its closing quote, or the end of the text.
std::size_t end_of_string(std::string_view text, std::size_t at) {
  for (++at; at < text.size() && text[at] != '"'; ++at) at += text[at] == '\\' ? 1 : 0;
  return std::min(at + 1, text.size());
}

/// Whether an escape such as \ud800 is at `at`, whose first digit after d is one of these.
bool is_surrogate(std::string_view text, std::size_t at, std::string_view digits) {
  constexpr std::string_view hexadecimal = "0123456789abcdefABCDEF";
  const std::string_view escape = text.substr(std::min(at, text.size()), 6);
  return escape.size() == 6 && (escape.starts_with("\\ud") || escape.starts_with("\\uD")) &&
         digits.find(escape[3]) != std::string_view::npos &&
         escape.find_first_not_of(hexadecimal, 4) == std::string_view::npos;
}

/// A text as nlohmann-json gets it, which takes long for each character and for the value of a number.
struct ShortText {
  std::string text;
  std::size_t place = 0;  ///< of its last character in the whole text, or the end of that
};

/// What the grammar needs of a text from `at` on, up to so many characters: with a zero in the place of digits from one
/// of 1 to 9 on, and of NaN, which JSON does not have, and without the characters of strings in printable ASCII. Half
/// of a surrogate pair is a valid escape of no character, and stands as it is written.
ShortText shortened(std::string_view text, std::size_t at, std::size_t most = std::string_view::npos) {
  const auto is_plain = [](char c) { return c >= ' ' && c <= '~' && c != '"' && c != '\\'; };
  const auto is_nan = [&](std::size_t begin) {
    const char before = begin == 0 ? ' ' : text[begin - 1];
    const std::string_view rest = text.substr(begin);
    return rest.starts_with("NaN") && !(rest.size() > 3 && (is_word(rest[3]) || rest[3] == '.')) &&
           (before == ',' || before == ':' || before == '[' || is_json_blank(before));
  };
  std::string out;
  std::size_t place = at;
  bool in_string = false;
  while (at < text.size() && out.size() < most) {
    const char c = text[place = at++];
    out += c;
    if (in_string) {
      in_string = c != '"';
      if (c == '\\' && at < text.size() && out.size() < most) {
        const bool is_high = is_surrogate(text, at - 1, "89abAB"), is_low = is_surrogate(text, at - 1, "cdefCDEF");
        out += text[place = at++];
        if (is_high && is_surrogate(text, at + 4, "cdefCDEF")) {
          out += text.substr(at, 10);
          place = (at += 10) - 1;
        } else if (is_high || is_low) {
          out.back() = '\\';
        }
      }
    } else if (c == '"') {
      in_string = true;
      std::size_t end = at;
      while (end < text.size() && is_plain(text[end])) ++end;
      if (end < text.size() && text[end] == '"') at = end;
    } else if (c == 'N' && is_nan(at - 1)) {
      out.back() = '0';
      at += 2;
    } else if (c >= '1' && c <= '9') {
      out.back() = '0';
      while (at < text.size() && is_digit(text[at])) place = at++;
    }
  }
  const bool is_whole = out.size() < most;
  return {std::move(out), is_whole ? text.size() : place};
}

/// Where the value that begins at `at` ends, by its strings and brackets, or the end of the text.
std::size_t end_of_value(std::string_view text, std::size_t at) {
  std::size_t depth = 0;
  for (; at < text.size(); ++at) {
    const char c = text[at];
    if (c == '"') {
      at = end_of_string(text, at) - 1;
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

/// Where the value that begins at `at` ends if it is one; of several that follow, none is in it.
std::size_t end_of_next(std::string_view text, std::size_t at) {
  if (text[at] == '{' || text[at] == '[') return end_of_value(text, at);
  if (text[at] == '"') return end_of_string(text, at);
  return std::min(text.find_first_of(" \t\r\n,{}[]\"", at + 1), text.size());
}

}  // namespace

/// Receives the events of nlohmann-json, with its names, and finds the place of each value in the text.
class JsonTape::Events {
 public:
  using Json = nlohmann::json;

  /// What is parsed ends at `end`.
  Events(JsonTape& tape, std::size_t begin, std::size_t end)
      : tape_(tape),
        text_(tape.part_.chunk.text),
        first_(begin),
        end_(end),
        now_(begin),
        is_list_(tape.part_.kind == JsonPart::Kind::list) {}

  bool null() { return add(Kind::null, begin() + 4); }
  bool boolean(bool value) { return add(Kind::boolean, begin() + (value ? 4 : 5)); }
  bool number_integer(Json::number_integer_t) { return add_number(); }
  bool number_unsigned(Json::number_unsigned_t) { return add_number(); }
  bool number_float(Json::number_float_t, const std::string&) { return add_number(); }
  bool string(const std::string& text) { return add_text(Kind::string, text); }
  bool key(const std::string& text) { return add_text(Kind::name, text); }
  bool binary(const Json::binary_t&) { return false; }
  bool start_object(std::size_t) { return open(Kind::object); }
  bool start_array(std::size_t) { return open(Kind::array); }
  bool end_object() { return close(); }
  bool end_array() { return close(); }
  bool parse_error(std::size_t count, const std::string&, const Json::exception&) { refuse_syntax(count); }

  std::size_t now() const { return now_; }

 private:
  /// What was read last.
  enum class Last { nothing, opening, name, value };

  /// The first character of the next token.
  std::size_t begin() {
    while (is_json_blank(text_[now_]) || text_[now_] == ',' || text_[now_] == ':') ++now_;
    return now_;
  }
  bool add(Kind kind, std::size_t end) {
    const auto first = static_cast<std::uint32_t>(begin());
    now_ = end;
    if (tape_.nodes_.size() == tape_.nodes_.capacity()) tape_.require_memory();
    tape_.nodes_.push_back(
        {first, static_cast<std::uint32_t>(end), static_cast<std::uint32_t>(tape_.size() + 1), kind});
    last_ = Last::value;
    return true;
  }

  bool add_number() {
    std::size_t at = begin();
    if (text_[at] == 'N') return add(Kind::null, at + 3);
    const auto skip = [&](std::string_view any) {
      const bool is_one = at < text_.size() && any.find(text_[at]) != std::string_view::npos;
      if (is_one) ++at;
      return is_one;
    };
    const auto skip_digits = [&] {
      while (at < text_.size() && is_digit(text_[at])) ++at;
    };
    skip("-");
    if (!skip("0")) skip_digits();
    if (skip(".")) skip_digits();
    const bool has_exponent = skip("eE");
    if (has_exponent) {
      skip("+-");
      skip_digits();
    }
    add(Kind::number, at);
    constexpr std::size_t longest = 308;  // of a number that is no double only by its exponent
    const std::string_view number = tape_.written(tape_.size() - 1);
    if ((has_exponent || number.size() > longest) && !parse_number(number)) {
      throw too_large(number).at(tape_.position(tape_.size() - 1));
    }
    return true;
  }

  /// A text without escapes is as it is written.
  bool add_text(Kind kind, const std::string& text) {
    add(kind, end_of_string(text_, begin()));
    JsonNode& node = tape_.nodes_.back();
    node.has_escapes = tape_.written(tape_.size() - 1).find('\\') != std::string_view::npos;
    if (node.has_escapes) tape_.unescaped_.emplace(node.begin, text);
    if (kind == Kind::name) last_ = Last::name;
    return true;
  }

  bool open(Kind kind) {
    if (open_.size() == most_levels) {
      throw data_error("this is nested deeper than {} brackets; expected fewer; remove it", most_levels)
          .at(tape_.position_at(begin()));
    }
    open_.push_back(tape_.nodes_.size());
    add(kind, begin() + 1);
    last_ = Last::opening;
    return true;
  }

  bool close() {
    JsonNode& node = tape_.nodes_[open_.back()];
    open_.pop_back();
    now_ = begin() + 1;
    node.end = static_cast<std::uint32_t>(now_);
    node.next = static_cast<std::uint32_t>(tape_.nodes_.size());
    last_ = Last::value;
    return true;
  }

  std::size_t skip(std::size_t at) const { return std::min(text_.find_first_not_of(" \t\r\n", at), text_.size()); }

  /// The place of the next token, which a comma or colon may precede unless that is the `last` byte.
  std::size_t next_token(std::size_t last, bool& is_separated) const {
    const std::size_t at = skip(now_);
    is_separated = at < text_.size() && (text_[at] == ',' || text_[at] == ':') && at != last;
    return is_separated ? skip(at + 1) : at;
  }

  /// Throws: Error (data) for the last one of so many characters that the parser has read, which breaks the grammar of
  /// JSON.
  [[noreturn]] void refuse_syntax(std::size_t count) const {
    const std::size_t last = shortened(text_.substr(0, end_), first_, count).place;
    const bool is_end = last + (is_list_ ? 1 : 0) >= text_.size();
    bool is_separated = false;
    const std::size_t begin = next_token(last, is_separated);
    const std::string_view found = text_.substr(begin);
    const auto at = [&](std::size_t place, const Error& error) { return error.at(tape_.position_at(place)); };
    const auto unexpected = [&](std::string_view token) {
      return at(begin, data_error("not JSON: found {}; expected {}; correct the text", in_quotes(token),
                                  expected(is_separated)));
    };
    // A literal such as 1. or tru ends before a comma or a bracket; one within a record that the text's end cuts off
    // does not.
    const bool is_literal = !found.empty() && (is_word(found[0]) || found[0] == '-');
    const bool ends_literal =
        std::string_view(",]}: \t\r\n").find(text_[std::min(last, text_.size() - 1)]) != std::string_view::npos;
    if (is_literal && begin < last && ends_literal && (!is_end || open_.size() == 1)) {
      throw unexpected(found.substr(0, last - begin));
    }
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
    throw unexpected(token);
  }

  /// What may follow what was read, and a comma or colon after that.
  std::string_view expected(bool is_separated) const {
    switch (last_) {
      case Last::nothing: return "a value";
      case Last::opening: return text_[now_ - 1] == '{' ? "a name in quotes" : "a value";
      case Last::name: return is_separated ? "a value" : "a colon after the name";
      case Last::value: break;
    }
    if (open_.empty()) return "nothing after the last bracket";
    return is_separated ? "another value or member after the comma" : "a comma or a closing bracket";
  }

  JsonTape& tape_;
  std::string_view text_;
  std::size_t first_, end_;  ///< of what is parsed
  std::size_t now_;          ///< the end of the last token
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
  const std::string_view whole = part_.chunk.text;
  const std::size_t end = is_one ? whole.size() : end_of_next(whole, end_);
  const ShortText parsed = shortened(whole.substr(0, end), end_);
  Events events(*this, end_, end);
  nlohmann::json::sax_parse(parsed.text, &events, nlohmann::json::input_format_t::json, is_one);
  end_ = events.now();
}

/// Throws: Error (data) if the text and twice as many nodes need more memory than is allowed.
void JsonTape::require_memory() const {
  constexpr std::size_t bytes_of_unescaped = 96;         // a short string in its table
  const std::size_t texts = unescaped_.empty() ? 2 : 3;  // with the one that is parsed
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
