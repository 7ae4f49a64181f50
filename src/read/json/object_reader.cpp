// Object reader: JSON text as events about key objects, with the text position and the path of each value.
#include "read/json/object_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>
#include <utility>

#include "numbers/parse_number.hpp"
#include "read/json/errors.hpp"

namespace tcb {
namespace {

using Json = nlohmann::json;
using Lexer = nlohmann::detail::lexer<Json, nlohmann::detail::iterator_input_adapter<JsonText::Iterator>>;

bool is_inside(const char* where, std::string_view text) {
  return std::greater_equal<>()(where, text.data()) && std::less_equal<>()(where, text.data() + text.size());
}

}  // namespace
}  // namespace tcb

/// Decimals in JSON become doubles by parse_number(), as all decimals do. The conversion that this specialization
/// replaces is std::strtod's, which depends on the locale and takes longer than the rest of the parser.
template <>
void tcb::Lexer::strtof(double& value, const char* text, char** end) noexcept {
  const std::size_t size = std::strlen(text);
  constexpr double too_large = std::numeric_limits<double>::infinity();  // which the parser reports
  value = tcb::parse_number({text, size}).value_or(too_large);
  *end = const_cast<char*>(text) + size;
}

namespace tcb {

/// nlohmann-json's events, with its names.
struct JsonObjectReader::Adapter {
  JsonObjectReader& reader;

  bool null() {
    reader.is_quoted_ = false;
    if (reader.is_for_key()) {
      if (!reader.on_break()) reader.refuse_for_key("null");
      if (reader.part_.kind == JsonPart::Kind::elements) ++reader.keys_;
      return passed(Last::value, true);
    }
    if (reader.is_deep()) reader.on_deep_value(false);
    return passed(Last::value, reader.value([this] { return reader.on_null(); }));
  }
  bool boolean(bool value) {
    reader.is_quoted_ = false;
    return text(value ? "true" : "false");
  }
  bool number_integer(Json::number_integer_t value) {
    return value != 0 ? whole(value) : number_float(-0.0, {});  // only a zero with a sign comes here
  }
  bool number_unsigned(Json::number_unsigned_t value) { return whole(value); }
  bool number_float(Json::number_float_t value, std::string_view written) {
    reader.decimal_ = written;
    return number(spline::Time<double>(value));
  }
  bool string(std::string& value) {
    reader.is_quoted_ = true;
    return text(value);
  }
  bool binary(Json::binary_t&) { return false; }
  bool start_object(std::size_t) { return passed(Last::opening, reader.open(true)); }
  bool key(std::string& name) {
    if (reader.depth_ != reader.member_depth()) return passed(Last::name, true);
    if (reader.outer_depth_ == 1) return passed(Last::name, reader.on_member(name));
    return passed(Last::name, reader.on_member(reader.outer_ + name));
  }
  bool end_object() { return passed(Last::value, reader.close(true)); }
  bool start_array(std::size_t) { return passed(Last::opening, reader.open(false)); }
  bool end_array() { return passed(Last::value, reader.close(false)); }
  bool parse_error(std::size_t bytes, const std::string&, const Json::exception& error) const {
    constexpr int number_overflow = 406;
    if (error.id == number_overflow) {
      const char* const begin = reader.value_begin();
      const char* const last = reader.text_.byte(bytes - 1);
      throw json::number_too_large({begin, static_cast<std::size_t>(last + 1 - begin)}).at(reader.position_of(begin));
    }
    reader.refuse_syntax(bytes);
  }

  bool text(std::string_view value) {
    if (reader.is_for_key()) reader.refuse_for_key(in_quotes(value));
    if (reader.is_deep()) reader.on_deep_value(false);
    return passed(Last::value, reader.value([this, value] { return reader.on_text(value); }));
  }

  bool number(const spline::Time<double>& value) {
    reader.is_quoted_ = false;
    if (reader.is_for_key()) reader.refuse_for_key("a number");
    if (reader.is_deep()) reader.on_deep_value(true);
    const bool more = reader.value([this, &value] { return reader.on_number(value); });
    reader.last_ = Last::value;
    reader.passed_ = reader.text_.now() - 1;  // the parser has read one byte more, to find the end of the number
    return more;
  }

  template <class Integer>
  bool whole(Integer value) {
    reader.decimal_ = {};
    return number(whole_time(value));
  }

  bool passed(Last what, bool more) {
    reader.last_ = what;
    reader.passed_ = reader.text_.now();
    return more;
  }
};

void JsonObjectReader::parse() {
  const std::string_view text = part_.chunk.text;
  if (part_.kind == JsonPart::Kind::object) {
    (void)parse_text({text, part_.after.text});
    return;
  }
  if (part_.kind == JsonPart::Kind::elements) {
    key_depth_ = 1;
    (void)parse_text({"[", text, "]"});
    if (keys_ == 0) throw json::no_key_between_commas().at({"", part_.chunk.line, part_.chunk.column});
    return;
  }
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string_view line = text.substr(begin, end - begin);
    if (!is_json_blank(line) && !parse_line(line)) return;
    begin = end + 1;
  }
}

/// Whether the next line is to be parsed.
bool JsonObjectReader::parse_line(std::string_view line) {
  const std::size_t keys = keys_;
  try {
    return parse_text({line});
  } catch (const Error& error) {
    if (!on_bad_line(error)) throw;
    keys_ = keys + 1;
    return true;
  }
}

/// Whether all was parsed.
bool JsonObjectReader::parse_text(const JsonText::Pieces& pieces) {
  depth_ = 0;
  outer_depth_ = 1;
  text_ = JsonText(pieces);
  passed_ = text_.now();
  last_ = Last::nothing;
  Adapter adapter{*this};
  return Json::sax_parse(JsonText::Iterator(text_), JsonText::Iterator(), &adapter);
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
  if (depth_ > member_depth()) on_deep_value(false);
  if (in_array()) {
    more = on_nested();
    ++element_;
  } else if (object && depth_ == key_depth_ + 1 && (member() == "tcb" || member() == "rotation")) {
    outer_ = std::string(member()) + ".";
    outer_depth_ = 2;
    on_members();
  } else if (depth_ == member_depth()) {
    element_ = 0;
    is_array_ = !object;
    array_ = text_.now() - 1;
    if (object) more = on_nested();
  } else if (depth_ == key_depth_) {
    if (!object) refuse_for_key("an array");
    key_ = text_.now() - 1;
    more = on_key_start();
  }
  ++depth_;
  return more;
}

bool JsonObjectReader::close(bool object) {
  const bool is_array_of_member = !object && in_array();
  const bool is_key = object && depth_ == key_depth_ + 1;
  --depth_;
  if (depth_ == key_depth_ + 1) outer_depth_ = 1;
  if (is_key) ++keys_;
  if (!is_array_of_member) return !is_key || on_key_end();
  is_array_end_ = true;
  const bool more = on_array_end();
  is_array_end_ = false;
  return more;
}

LinePosition JsonObjectReader::count_to(const char* where) {
  counted_position_ = position_after({counted_, static_cast<std::size_t>(where - counted_)}, counted_position_);
  counted_ = where;
  return counted_position_;
}

std::string JsonObjectReader::path() const {
  const std::string& list = part_.chunk.path;
  const std::string object =
      part_.kind == JsonPart::Kind::object ? list : fmt::format("{}[{}]", list.empty() ? "keys" : list, key_number());
  return fmt::format("{}{}{}{}", object, object.empty() ? "" : ".", member(),
                     in_array() ? fmt::format("[{}]", element_) : "");
}

/// Where the value or the name begins that the parser passes on now.
const char* JsonObjectReader::value_begin() const {
  if (is_array_end_) return array_;
  std::string_view rest = text_.rest(passed_);
  if (rest.starts_with(',') || rest.starts_with(':')) rest = text_.rest(rest.data() + 1);
  return rest.data();
}

/// Throws: Error (data) for a value in the place of a key.
void JsonObjectReader::refuse_for_key(std::string_view what) const {
  throw json::key_is_no_object(what).at(position_of(value_begin()));
}

/// Throws: Error (data) for the last one of the bytes that the parser has read, which breaks the grammar of JSON.
void JsonObjectReader::refuse_syntax(std::size_t bytes) const {
  const bool is_list = part_.kind == JsonPart::Kind::elements;
  const bool is_end = bytes > text_.size() - (is_list ? 1 : 0);
  const char* const last = text_.byte(bytes - 1);
  const std::string_view next = text_.rest(passed_);
  const bool is_separated = (next.starts_with(',') || next.starts_with(':')) && next.data() != last;
  const std::string_view found = is_separated ? text_.rest(next.data() + 1) : next;
  const char* const begin = found.data();
  const bool may_be_string = is_separated || last_ == Last::nothing || last_ == Last::opening;
  if (found.starts_with('"') && is_end) throw json::string_not_closed().at(position_of(begin));
  const bool is_key_expected = is_list && depth_ == 1 && may_be_string;
  if (is_key_expected && (is_end || *last == ',')) throw json::no_key_between_commas().at(position_of(last));
  if (is_end) throw json::ends_early().at(position_of(last));
  const std::string_view token(begin, static_cast<std::size_t>(last + 1 - begin));
  if (found.starts_with('"') && may_be_string) throw json::character_in_string(token.substr(1)).at(position_of(last));
  throw json::unexpected(token, expected(is_separated)).at(position_of(begin));
}

/// What may follow what the parser has passed on, and a comma or colon after that.
json::Expected JsonObjectReader::expected(bool is_separated) const {
  using enum json::Expected;
  switch (last_) {
    case Last::nothing: return value;
    case Last::opening: return passed_[-1] == '{' ? name : value;
    case Last::name: return is_separated ? value : colon;
    case Last::value: break;
  }
  if (depth_ == 0) return nothing;
  return is_separated ? after_comma : comma;
}

TextPosition JsonObjectReader::position_of(const char* where) const {
  const bool is_after = !part_.after.text.empty() && is_inside(where, part_.after.text);
  const Chunk& chunk = is_after ? part_.after : part_.chunk;
  std::string_view before = chunk.text;  // to the end of the keys, for the bracket after them
  if (is_inside(where, before)) before = before.substr(0, static_cast<std::size_t>(where - before.data()));
  return {"", chunk.line + count_lines(before), column_after(before, chunk.column)};
}

}  // namespace tcb
