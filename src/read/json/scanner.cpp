// JSON scanner: strings, brackets and tokens of JSON text, for the splitter, for the parser, and for error positions.
#include "read/json/scanner.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "numbers/parse_number.hpp"
#include "text/utf8.hpp"

namespace tcb {
namespace {

constexpr std::size_t longest_part = 64UL * 1024 * 1024;

/// The characters that determine where keys end.
constexpr std::array<bool, 256> is_structure = [] {
  std::array<bool, 256> found{};
  for (const char c : std::string_view("\"[]{},\n")) found[static_cast<unsigned char>(c)] = true;
  return found;
}();

const char* after_digits(const char* at, const char* end) {
  while (at != end && *at >= '0' && *at <= '9') ++at;
  return at;
}

/// The end of the JSON number that begins here; nothing if none does. A whole number ends at `whole_end`.
const char* after_number(const char* at, const char* end, const char*& whole_end) {
  if (at != end && *at == '-') ++at;
  const char* const whole = at;
  whole_end = at = after_digits(at, end);
  if (at == whole || (*whole == '0' && at != whole + 1)) return nullptr;
  if (at != end && *at == '.') {
    const char* const fraction = ++at;
    at = after_digits(at, end);
    if (at == fraction) return nullptr;
  }
  if (at != end && (*at == 'e' || *at == 'E')) {
    ++at;
    if (at != end && (*at == '-' || *at == '+')) ++at;
    const char* const exponent = at;
    at = after_digits(at, end);
    if (at == exponent) return nullptr;
  }
  return at;
}

/// The same for a number with a fraction or an exponent, followed by what may follow a value.
const char* after_decimal(const char* at, const char* end) {
  const char* whole_end = at;
  const char* const number_end = after_number(at, end, whole_end);
  const bool is_decimal = number_end != nullptr && number_end != whole_end;
  if (!is_decimal) return nullptr;
  const bool ends = number_end == end || std::string_view(" \t\r\n,]}").find(*number_end) != std::string_view::npos;
  return ends ? number_end : nullptr;
}

bool is_scalar(std::string_view token) {
  if (token.front() == '"') return is_json_string(token);
  const char* whole_end = nullptr;
  const char* const end = token.data() + token.size();
  return token == "true" || token == "false" || token == "null" || after_number(token.data(), end, whole_end) == end;
}

/// The grammar of JSON: which token may come next.
class JsonGrammar {
 public:
  JsonExpected expected() const { return expected_; }

  /// Accepts the next token; false if another one was expected.
  bool take(std::string_view token) {
    using enum JsonExpected;
    const char first = token.front();
    const bool value_expected = expected_ == value || expected_ == value_or_end;
    const bool name_expected = expected_ == name || expected_ == name_or_end;
    const bool after_item = expected_ == comma_in_array || expected_ == comma_in_object;
    if ((first == '[' || first == '{') && value_expected) {
      open_.push_back(first);
      expected_ = first == '[' ? value_or_end : name_or_end;
    } else if ((first == ']' && (expected_ == value_or_end || expected_ == comma_in_array)) ||
               (first == '}' && (expected_ == name_or_end || expected_ == comma_in_object))) {
      close();
    } else if (first == ',' && after_item) {
      expected_ = expected_ == comma_in_array ? value : name;
    } else if (first == ':' && expected_ == colon) {
      expected_ = value;
    } else if (first == '"' && name_expected && is_scalar(token)) {
      expected_ = colon;
    } else if (value_expected && is_scalar(token)) {
      expected_ = after_value();
    } else {
      return false;
    }
    return true;
  }

 private:
  void close() {
    open_.pop_back();
    expected_ = after_value();
  }
  JsonExpected after_value() const {
    if (open_.empty()) return JsonExpected::nothing;
    return open_.back() == '{' ? JsonExpected::comma_in_object : JsonExpected::comma_in_array;
  }

  std::vector<char> open_;
  JsonExpected expected_ = JsonExpected::value;
};

}  // namespace

bool JsonScanner::is_blank() const { return std::ranges::all_of(text_, is_json_blank); }

void JsonScanner::skip_blanks() {
  while (at != text_.size() && is_json_blank(text_[at])) ++at;
}

bool JsonScanner::skip_to_structure() {
  const char* const begin = text_.data();
  const char* const end = begin + text_.size();
  const char* now = begin + at;
  for (;;) {
    if (in_string) {
      at = static_cast<std::size_t>(now - begin);
      if (!skip_string()) return false;
      now = begin + at;
    }
    while (now != end && !is_structure[static_cast<unsigned char>(*now)]) ++now;
    in_string = now != end && *now == '"';
    if (!in_string) break;
    ++now;
  }
  at = static_cast<std::size_t>(now - begin);
  return now != end;
}

void JsonScanner::skip_plain_object() {
  // Without another brace and without a backslash, quotes come in pairs up to a brace outside of strings.
  const std::size_t end = text_.find('}', at);
  if (end == std::string::npos) return;
  std::uint8_t odd = 0, doubtful = 0;
  for (const char c : view().substr(at + 1, end - at - 1)) {
    odd = static_cast<std::uint8_t>(odd ^ static_cast<std::uint8_t>(c == '"'));
    doubtful = static_cast<std::uint8_t>(doubtful | static_cast<std::uint8_t>(c == '{') |
                                         static_cast<std::uint8_t>(c == '\\'));
  }
  if (odd == 0 && doubtful == 0) at = end - 1;
}

bool JsonScanner::skip_string() {
  const char* const begin = text_.data();
  const char* const end = begin + text_.size();
  const char* const quote = find_closing_quote(begin + at, end, escaped_);
  in_string = quote == end;
  at = static_cast<std::size_t>(quote - begin) + (in_string ? 0 : 1);
  return !in_string;
}

Chunk JsonScanner::take(std::size_t end) {
  std::string rest = text_.substr(end);
  text_.resize(end);
  Chunk chunk{std::exchange(text_, std::move(rest)), line, column};
  column = column_after(chunk.text, column);
  line += count_lines(chunk.text);
  at -= std::min(at, end);
  return chunk;
}

bool JsonScanner::read_more(ErrorCode too_long) {
  if (text_.size() > longest_part) refuse(too_long);
  return bytes_.append_to(text_, {line, column});
}

void JsonScanner::refuse(ErrorCode code) const { throw Error(Exit::data, code).at({"", line, column}); }

void JsonCursor::look_at_number() {
  const char* const number_end = after_decimal(at_, end_);
  if (number_end != nullptr) {
    const std::string_view text(at_, static_cast<std::size_t>(number_end - at_));
    if (const auto value = parse_number(text)) {
      number_ = {*value, text};
      number_end_ = number_end;
      return;
    }
  }
  scanned_ = at_ + 1;
  while (scanned_ != end_ && std::string_view(" \t\r\n,]}\"").find(*scanned_) == std::string_view::npos) ++scanned_;
}

bool is_json_string(std::string_view token) {
  bool escaped = false;
  const char* const end = token.data() + token.size();
  return token.size() > 1 && token.front() == '"' && find_closing_quote(token.data() + 1, end, escaped) == end - 1;
}

std::string_view JsonTokens::next() {
  constexpr std::string_view single = "[]{},:";
  const char* at = rest_.data();
  const char* const end = at + rest_.size();
  while (at != end && is_json_blank(*at)) ++at;
  const char* const begin = at;
  if (at != end && *at == '"') {
    bool escaped = false;
    at = find_closing_quote(at + 1, end, escaped);
    if (at != end) ++at;
  } else if (at != end) {
    const auto ends_word = [&](char c) { return is_json_blank(c) || c == '"' || single.find(c) != single.npos; };
    at = single.find(*at) != single.npos ? at + 1 : std::find_if(at + 1, end, ends_word);
  }
  rest_.remove_prefix(static_cast<std::size_t>(at - rest_.data()));
  return {begin, static_cast<std::size_t>(at - begin)};
}

JsonFault find_json_fault(std::string_view text) {
  JsonTokens tokens(text);
  JsonGrammar grammar;
  std::string_view last, token = tokens.next();
  while (!token.empty() && grammar.take(token)) last = std::exchange(token, tokens.next());
  return {token.empty() ? last.substr(0, 0) : token, grammar.expected()};
}

const char* last_json_value(std::string_view text) {
  const char* value = text.data();
  JsonTokens tokens(text);
  for (std::string_view token = tokens.next(); !token.empty(); token = tokens.next()) {
    const char first = token.front();
    if (first == '[' || first == '{') value = token.data() + 1;
    if (std::string_view("[]{},:").find(first) == std::string_view::npos) value = token.data();
  }
  return value;
}

}  // namespace tcb
