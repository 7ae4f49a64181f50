// JSON text as events about key objects: a thin layer over nlohmann-json's events that knows where it is.
#include "input/json/events.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "text/number.hpp"
#include "text/refusal.hpp"
#include "text/text_position.hpp"

namespace tcb {
namespace {

using nlohmann::json;

constexpr const char* no_key = "nothing where a key was expected; expected {…}; take the comma out";

/// Where the token ends that was read last, and then where it begins, by looking back.
const char* token_start(const char* begin, const char* now) {
  constexpr std::string_view between = " \t\r\n,:]}";
  const auto is_between = [&](char c) { return between.find(c) != std::string_view::npos; };
  while (now != begin && is_between(now[-1])) --now;
  if (now == begin) return now;
  if (now[-1] == '"') {
    for (--now; now != begin && (now[-1] != '"' || (now - 1 != begin && now[-2] == '\\'));) --now;
    return now == begin ? now : now - 1;
  }
  while (now != begin && !is_between(now[-1]) && now[-1] != '[' && now[-1] != '{') --now;
  return now;
}

/// Where the token begins that was read last, a bracket or comma among them.
const char* last_token(const char* begin, const char* now) {
  const bool single = now != begin && std::string_view(",:[]{}").find(now[-1]) != std::string_view::npos;
  return single ? now - 1 : token_start(begin, now);
}

/// What nlohmann-json says is wrong with a text that it has seen with other numbers.
std::string message_on(std::string_view text) {
  try {
    const auto keep_nothing = [](int, json::parse_event_t, json&) { return false; };
    [[maybe_unused]] const json parsed = json::parse(text, keep_nothing);
  } catch (const json::exception& error) {
    return error.what();
  }
  return "syntax error";
}

/// The same without its own place, and with what it read last shown as text is here.
std::string reason(std::string_view whole) {
  const std::string message = message_on(whole);
  const std::size_t start = message.find("syntax error");
  if (start == std::string::npos) return message.substr(message.find("] ") + 2);
  constexpr std::string_view mark = "; last read: '";
  const std::size_t read = message.find(mark, start);
  if (read == std::string::npos) return message.substr(start);
  const std::size_t begin = read + mark.size();
  const bool expects = message.find("while parsing value") > read;  // or else what was read is the last it says
  const std::size_t end = expects ? message.rfind("'; expected ") : message.size() - 1;
  std::string text = message.substr(begin, end - begin);
  if (text.rfind('"') == 0) text.erase(0, 1);  // of a string that was begun
  return fmt::format("{} in {}{}", message.substr(start, read - start), shown(text), message.substr(end + 1));
}

}  // namespace

/// nlohmann-json's events, with its names.
struct JsonEvents::Adapter {
  JsonEvents& events;

  bool null() { return word("null"); }
  bool boolean(bool value) { return word(value ? "true" : "false"); }
  bool number_integer(json::number_integer_t value) {
    return value != 0 ? whole(value) : number_float(-0.0, {});  // only a zero with a sign comes here
  }
  bool number_unsigned(json::number_unsigned_t value) {
    const auto number = std::exchange(events.reading_.number, std::nullopt);
    return number ? number_float(number->value, number->text) : whole(value);
  }
  bool number_float(json::number_float_t value, std::string_view text) {
    events.decimal_ = text;
    events.is_quoted_ = false;
    const spline::Time<double> number(value);
    return events.value(&number, {});
  }
  bool string(std::string& text) {
    events.is_quoted_ = true;
    return events.value(nullptr, text);
  }
  bool binary(json::binary_t&) { return false; }
  bool start_object(std::size_t) { return events.open(true); }
  bool key(std::string& name) {
    if (events.depth_ != events.key_depth_ + 1) return true;
    events.member_ = name;
    return events.on_member(name);
  }
  bool end_object() { return events.close(true); }
  bool start_array(std::size_t) { return events.open(false); }
  bool end_array() { return events.close(false); }
  bool parse_error(std::size_t, const std::string&, const json::exception& error) {
    if (error.id == 406) {  // a number that is too large
      const char* const start = token_start(events.chunk_.text.data(), events.reading_.now);
      const std::string_view behind(start, static_cast<std::size_t>(events.reading_.now - start));
      events.fail(fmt::format("{} is not a finite double; expected less than 1.8e308 in size; correct it",
                              shown(behind.substr(0, behind.find_first_of(" \t\r\n,]}")))));
    }
    const char* const token = last_token(events.chunk_.text.data(), events.reading_.now);
    const bool at_keys = events.key_depth_ == 1 && events.depth_ == 1 && (*token == ',' || *token == ']');
    if (at_keys && std::string_view(error.what()).ends_with("'[', '{', or a literal")) events.fail_at(token, no_key);
    events.fail_at(token, fmt::format("not JSON: {}; correct the text", reason(events.range_)));
  }

  bool word(std::string_view text) {
    events.is_quoted_ = false;
    return events.value(nullptr, text);
  }

  template <class IndexedCurve>
  bool whole(IndexedCurve value) {
    events.is_quoted_ = false;
    events.decimal_ = {};
    const spline::Time<double> number = whole_time(value);
    return events.value(&number, {});
  }
};

void JsonEvents::parse() {
  const char* const begin = chunk_.text.data();
  const char* const end = begin + chunk_.text.size();
  if (chunk_.text.starts_with('[')) {
    key_depth_ = 1;
    (void)parse_range(begin, end);
    if (keys_ == 0 && !has_breaks_) fail_at(end - 1, no_key);
    return;
  }
  for (const char* line = begin; line != end;) {
    const char* const line_end = std::find(line, end, '\n');
    const bool blank = std::all_of(line, line_end, [](char c) { return c == ' ' || c == '\t' || c == '\r'; });
    if (!blank && !parse_line(line, line_end)) return;
    line = line_end == end ? end : line_end + 1;
  }
}

/// Whether the events go on in the next line.
bool JsonEvents::parse_line(const char* begin, const char* end) {
  const std::size_t keys = keys_;
  try {
    return parse_range(begin, end);
  } catch (const Error& error) {
    if (!on_bad_line(error)) throw;
    keys_ = keys + 1;
    return true;
  }
}

void JsonEvents::parse_object() { (void)parse_range(chunk_.text.data(), chunk_.text.data() + chunk_.text.size()); }

/// Whether the events went on to the end.
bool JsonEvents::parse_range(const char* begin, const char* end) {
  depth_ = 0;
  range_ = {begin, end};
  reading_ = {begin, {}};
  Adapter adapter{*this};
  return json::sax_parse(JsonCursor(begin, end, reading_), JsonCursor(end, end, reading_), &adapter);
}

bool JsonEvents::value(const spline::Time<double>* number, std::string_view text) {
  if (depth_ <= key_depth_) {
    if (number == nullptr && text == "null" && !is_quoted_ && on_break()) return has_breaks_ = true;
    fail(fmt::format("{} where a key was expected; expected {{…}}; correct it", number ? "a number" : text));
  }
  if (depth_ != key_depth_ + 1 && !in_array()) return true;
  const bool more = number != nullptr ? on_number(*number) : on_other(text);
  if (in_array()) ++element_;
  return more;
}

bool JsonEvents::open(bool object) {
  bool more = true;
  is_quoted_ = false;
  if (in_array()) {
    more = on_other(object ? "an object" : "an array");
    ++element_;
  } else if (depth_ == key_depth_ + 1) {
    element_ = 0;
    is_array_ = !object;
    if (object) more = on_other("an object");
  } else if (depth_ == key_depth_) {
    if (!object) fail_at(reading_.now - 1, "an array where a key was expected; expected {…}; correct it");
    member_.clear();
    key_ = reading_.now - 1;
    more = on_key_start();
  }
  ++depth_;
  return more;
}

bool JsonEvents::close(bool object) {
  const bool array_of_member = !object && in_array();
  const bool key = object && depth_ == key_depth_ + 1;
  --depth_;
  if (key) ++keys_;
  return array_of_member ? on_array_end() : key ? on_key_end() : true;
}

LinePosition JsonEvents::place_of_key() {
  counted_place_ = place_after({counted_, static_cast<std::size_t>(key_ - counted_)}, counted_place_);
  counted_ = key_;
  return counted_place_;
}

std::string JsonEvents::key_path() const {
  return fmt::format("{}[{}]", chunk_.path.empty() ? "keys" : chunk_.path, key_number());
}

std::string JsonEvents::path() const {
  const std::string list = key_depth_ == 0 && part_ != nullptr ? chunk_.path : key_path();
  return fmt::format("{}{}{}{}", list, list.empty() ? "" : ".", member_,
                     in_array() ? fmt::format("[{}]", element_) : "");
}

Error JsonEvents::error(const std::string& message) const {
  return {Exit::data, place_of(token_start(chunk_.text.data(), reading_.now)), message};
}

Error JsonEvents::key_error(const std::string& message) const { return {Exit::data, place_of(key_), message}; }
void JsonEvents::fail(const std::string& message) const { throw error(message); }

TextPosition JsonEvents::here() const { return place_of(token_start(chunk_.text.data(), reading_.now)); }

void JsonEvents::fail_at(const char* where, const std::string& message) const {
  throw Error(Exit::data, place_of(where), message);
}

TextPosition JsonEvents::place_of(const char* where) const {
  const std::string_view before(chunk_.text.data(), static_cast<std::size_t>(where - chunk_.text.data()));
  if (part_ != nullptr && before.size() >= part_->gap) {
    const std::string_view behind = before.substr(part_->gap);
    return {"", part_->line + count_lines(behind), column_after(behind, part_->column)};
  }
  return {"", chunk_.line + count_lines(before), column_after(before, chunk_.column)};
}

}  // namespace tcb
