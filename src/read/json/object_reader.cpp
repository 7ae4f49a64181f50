// Object reader: JSON text as events about key objects, with the text position and the path of each value.
#include "read/json/object_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "numbers/parse_number.hpp"

namespace tcb {
namespace {

using nlohmann::json;

ErrorCode syntax_code(const JsonFault& fault) {
  if (fault.token.front() == '"' && !is_json_string(fault.token)) return ErrorCode::json_string_not_closed;
  switch (fault.expected) {
    case JsonExpected::value:
    case JsonExpected::value_or_end: return ErrorCode::json_value_expected;
    case JsonExpected::name:
    case JsonExpected::name_or_end: return ErrorCode::json_name_expected;
    case JsonExpected::colon: return ErrorCode::json_colon_expected;
    case JsonExpected::comma_in_array: return ErrorCode::json_comma_or_bracket_expected;
    case JsonExpected::comma_in_object: return ErrorCode::json_comma_or_brace_expected;
    case JsonExpected::nothing: break;
  }
  return ErrorCode::json_end_expected;
}

/// A token without its quotes.
std::string token_text(std::string_view token) {
  if (is_json_string(token)) token.remove_suffix(1);
  return std::string(token.substr(token.starts_with('"') ? 1 : 0));
}

}  // namespace

/// nlohmann-json's events, with its names.
struct JsonObjectReader::Adapter {
  JsonObjectReader& reader;

  bool null() {
    reader.is_quoted_ = false;
    if (reader.for_key() && reader.on_break()) return reader.has_breaks_ = true;
    if (reader.for_key()) reader.refuse_value(ErrorCode::json_value_for_key, {"null"});
    return reader.value([this] { return reader.on_null(); });
  }
  bool boolean(bool value) {
    reader.is_quoted_ = false;
    return text(value ? "true" : "false");
  }
  bool number_integer(json::number_integer_t value) {
    return value != 0 ? whole(value) : number_float(-0.0, {});  // only a zero with a sign comes here
  }
  bool number_unsigned(json::number_unsigned_t value) {
    const auto number = std::exchange(reader.reading_.number, std::nullopt);
    return number ? number_float(number->value, number->text) : whole(value);
  }
  bool number_float(json::number_float_t value, std::string_view written) {
    reader.decimal_ = written;
    return number(spline::Time<double>(value));
  }
  bool string(std::string& value) {
    reader.is_quoted_ = true;
    return text(value);
  }
  bool binary(json::binary_t&) { return false; }
  bool start_object(std::size_t) { return reader.open(true); }
  bool key(std::string& name) {
    if (reader.depth_ != reader.member_depth()) return true;
    if (reader.outer_depth_ == 1) {
      reader.member_ = name;
    } else {
      reader.member_ = reader.outer_ + name;
    }
    return reader.on_member(reader.member_);
  }
  bool end_object() { return reader.close(true); }
  bool start_array(std::size_t) { return reader.open(false); }
  bool end_array() { return reader.close(false); }
  bool parse_error(std::size_t, const std::string&, const json::exception& error) const {
    constexpr int out_of_range = 406;
    if (error.id == out_of_range) reader.refuse_large_number();
    reader.refuse_syntax();
  }

  bool text(std::string_view value) {
    if (reader.for_key()) reader.refuse_value(ErrorCode::json_value_for_key, {std::string(value)});
    if (reader.is_deep()) reader.on_deep_value(false);
    return reader.value([this, value] { return reader.on_text(value); });
  }

  bool number(const spline::Time<double>& value) {
    reader.is_quoted_ = false;
    if (reader.for_key()) reader.refuse_value(ErrorCode::json_number_for_key);
    if (reader.is_deep()) reader.on_deep_value(true);
    return reader.value([this, &value] { return reader.on_number(value); });
  }

  template <class Integer>
  bool whole(Integer value) {
    reader.decimal_ = {};
    return number(whole_time(value));
  }
};

void JsonObjectReader::parse() {
  const char* const begin = chunk_.text.data();
  const char* const end = begin + chunk_.text.size();
  if (chunk_.text.starts_with('[')) {
    key_depth_ = 1;
    (void)parse_range(begin, end);
    if (keys_ == 0 && !has_breaks_) fail_at(end - 1, ErrorCode::json_key_missing);
    return;
  }
  for (const char* line = begin; line != end;) {
    const char* const line_end = std::find(line, end, '\n');
    if (!std::all_of(line, line_end, is_json_blank) && !parse_line(line, line_end)) return;
    line = line_end == end ? end : line_end + 1;
  }
}

/// Whether the next line is to be parsed.
bool JsonObjectReader::parse_line(const char* begin, const char* end) {
  const std::size_t keys = keys_;
  try {
    return parse_range(begin, end);
  } catch (const Error& error) {
    if (!on_bad_line(error)) throw;
    keys_ = keys + 1;
    return true;
  }
}

void JsonObjectReader::parse_object() {
  (void)parse_range(chunk_.text.data(), chunk_.text.data() + chunk_.text.size());
}

/// Whether all was parsed.
bool JsonObjectReader::parse_range(const char* begin, const char* end) {
  depth_ = 0;
  outer_depth_ = 1;
  range_ = {begin, static_cast<std::size_t>(end - begin)};
  reading_ = {begin, {}};
  Adapter adapter{*this};
  return json::sax_parse(JsonCursor(begin, end, reading_), JsonCursor(end, end, reading_), &adapter);
}

/// Passes a value on, unless it is deep in another one.
template <class F>
bool JsonObjectReader::value(F event) {
  if (is_deep()) return true;
  const bool more = event();
  if (in_array()) ++element_;
  return more;
}

bool JsonObjectReader::open(bool object) {
  bool more = true;
  if (in_array()) {
    more = on_nested();
    ++element_;
  } else if (object && depth_ == key_depth_ + 1 && (member_ == "tcb" || member_ == "rotation")) {
    outer_ = member_ + ".";
    outer_depth_ = 2;
    on_members();
  } else if (depth_ == member_depth()) {
    element_ = 0;
    is_array_ = !object;
    if (object) more = on_nested();
  } else if (depth_ == key_depth_) {
    if (!object) fail_at(reading_.now - 1, ErrorCode::json_array_for_key);
    member_.clear();
    key_ = reading_.now - 1;
    more = on_key_start();
  }
  ++depth_;
  return more;
}

bool JsonObjectReader::close(bool object) {
  const bool array_of_member = !object && in_array();
  const bool key = object && depth_ == key_depth_ + 1;
  --depth_;
  if (depth_ == key_depth_ + 1) outer_depth_ = 1;
  if (key) ++keys_;
  return array_of_member ? on_array_end() : key ? on_key_end() : true;
}

LinePosition JsonObjectReader::key_position() {
  counted_position_ = position_after({counted_, static_cast<std::size_t>(key_ - counted_)}, counted_position_);
  counted_ = key_;
  return counted_position_;
}

std::string JsonObjectReader::key_path() const {
  return fmt::format("{}[{}]", chunk_.path.empty() ? "keys" : chunk_.path, key_number());
}

std::string JsonObjectReader::path() const {
  const std::string list = key_depth_ == 0 && part_ != nullptr ? chunk_.path : key_path();
  return fmt::format("{}{}{}{}", list, list.empty() ? "" : ".", member_,
                     in_array() ? fmt::format("[{}]", element_) : "");
}

TextPosition JsonObjectReader::value_position() const { return position_of(last_json_value(read_text())); }

Error JsonObjectReader::value_error(ErrorCode code, std::vector<ErrorValue> values) const {
  values.insert(values.begin(), path());
  return Error(Exit::data, code, std::move(values)).at(value_position());
}

Error JsonObjectReader::key_error(ErrorCode code, std::vector<ErrorValue> values) const {
  return Error(Exit::data, code, std::move(values)).at(position_of(key_));
}

/// The text that was read of the current range.
std::string_view JsonObjectReader::read_text() const {
  return {range_.data(), static_cast<std::size_t>(reading_.now - range_.data())};
}

void JsonObjectReader::refuse_value(ErrorCode code, std::vector<ErrorValue> values) const {
  fail_at(last_json_value(read_text()), code, std::move(values));
}

void JsonObjectReader::refuse_large_number() const {
  const std::string_view text = read_text();
  const char* const begin = last_json_value(text);
  const std::string number(JsonTokens(text.substr(static_cast<std::size_t>(begin - text.data()))).next());
  fail_at(begin, ErrorCode::json_number_too_large, {number});
}

void JsonObjectReader::refuse_syntax() const {
  JsonFault fault = find_json_fault(range_);
  const bool has_more = reading_.now != range_.data() + range_.size();
  if (has_more &&
      fault.token.data() >= reading_.now) {  // a string's characters, which find_json_fault() does not check
    fault = find_json_fault(read_text());
    fail_at(reading_.now - 1, ErrorCode::json_character_in_string, {token_text(fault.token)});
  }
  const bool value_expected = fault.expected == JsonExpected::value || fault.expected == JsonExpected::value_or_end;
  const bool at_key = key_depth_ == 1 && depth_ == 1 && value_expected && (fault.token == "," || fault.token == "]");
  if (at_key) fail_at(fault.token.data(), ErrorCode::json_key_missing);
  if (fault.token.empty()) fail_at(fault.token.data(), ErrorCode::json_ends_early);
  fail_at(fault.token.data(), syntax_code(fault), {token_text(fault.token)});
}

void JsonObjectReader::fail_at(const char* where, ErrorCode code, std::vector<ErrorValue> values) const {
  throw Error(Exit::data, code, std::move(values)).at(position_of(where));
}

TextPosition JsonObjectReader::position_of(const char* where) const {
  const std::string_view before(chunk_.text.data(), static_cast<std::size_t>(where - chunk_.text.data()));
  if (part_ != nullptr && before.size() >= part_->gap) {
    const std::string_view after = before.substr(part_->gap);
    return {"", part_->line + count_lines(after), column_after(after, part_->column)};
  }
  return {"", chunk_.line + count_lines(before), column_after(before, chunk_.column)};
}

}  // namespace tcb
