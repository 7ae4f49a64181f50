// JSON scanner: the parser reads the same with and without the cursor; tokens and the first fault of a text.
#include "read/json/scanner.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tcb {
namespace {

using nlohmann::json;

/// Reads the text unchanged, and keeps how far it was read.
struct PlainCursor {
  using iterator_category = std::forward_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  const char* at;
  JsonReading* reading;

  reference operator*() const { return *at; }
  PlainCursor& operator++() {
    reading->now = ++at;
    return *this;
  }
  bool operator==(const PlainCursor& other) const { return at == other.at; }
};

/// Keeps the events of a parser and how far it has read, as text; numbers with their written form where they have one.
struct Listener {
  const char* begin;
  JsonReading reading{begin, {}};
  std::vector<std::string> events = {};
  std::size_t read = 0;  ///< numbers that the cursor read

  bool add(std::string what) {
    events.push_back(std::move(what) + " before " + std::to_string(reading.now - begin));
    return true;
  }
  bool null() { return add("null"); }
  bool boolean(bool value) { return add(value ? "true" : "false"); }
  bool number_integer(json::number_integer_t value) { return add("integer " + std::to_string(value)); }
  bool number_unsigned(json::number_unsigned_t value) {
    const auto number = std::exchange(reading.number, std::nullopt);
    if (!number) return add("whole " + std::to_string(value));
    ++read;
    return number_float(number->value, std::string(number->text));
  }
  bool number_float(json::number_float_t value, const std::string& text) {
    return add("number " + std::to_string(std::bit_cast<std::uint64_t>(value)) + " from " + text);
  }
  bool string(std::string& text) { return add("string " + text); }
  bool binary(json::binary_t&) { return false; }
  bool start_object(std::size_t) { return add("{"); }
  bool key(std::string& name) { return add("key " + name); }
  bool end_object() { return add("}"); }
  bool start_array(std::size_t) { return add("["); }
  bool end_array() { return add("]"); }
  bool parse_error(std::size_t, const std::string&, const json::exception&) {
    add("error");
    return false;
  }
};

std::vector<std::string> events_without_cursor(std::string_view text) {
  Listener listener{text.data()};
  const char* const end = text.data() + text.size();
  json::sax_parse(PlainCursor{text.data(), &listener.reading}, PlainCursor{end, &listener.reading}, &listener);
  return listener.events;
}

Listener events_with_cursor(std::string_view text) {
  Listener listener{text.data()};
  const char* const end = text.data() + text.size();
  json::sax_parse(JsonCursor(text.data(), end, listener.reading), JsonCursor(end, end, listener.reading), &listener);
  return listener;
}

TEST(JsonCursor, reads_numbers_with_a_fraction_or_an_exponent) {
  const Listener listener = events_with_cursor(R"([1.5, -2e-3,7E+2 , 0, -0, 12, "3.5 \" 4.5", {"6.5":-0.0}, 1e-400])");
  EXPECT_EQ(listener.read, 5U);
  EXPECT_EQ(listener.events,
            events_without_cursor(R"([1.5, -2e-3,7E+2 , 0, -0, 12, "3.5 \" 4.5", {"6.5":-0.0}, 1e-400])"));
}

TEST(JsonCursor, leaves_other_text_to_the_parser) {
  for (const char* text : {"[01.5]", "[.5]", "[1.]", "[1.5e]", "[1.5.2]", "[+1.5]", "[1.5x]", "[--1.5]", "[1e400]",
                           "[0x1p3]", "[1.5 2.5]", "{1.5:2}", "[1,5e999]", "[1.5", "1.5", "", "-", "[\"1.5"}) {
    EXPECT_EQ(events_with_cursor(text).events, events_without_cursor(text)) << text;
  }
}

TEST(JsonCursor, gives_the_same_events_for_any_text) {
  std::mt19937 random(3);
  constexpr std::string_view parts[] = {"[",  "]", "{",   "}",  ",",    ":",   "\"",    "\\", " ",
                                        "\n", "0", "1",   "25", "-",    "1.5", "-0.0",  ".",  "e",
                                        "E+", "3", "e-7", "17", "null", "x",   "\"a\":"};
  std::size_t accepted = 0;
  for (int i = 0; i < 300'000; ++i) {
    std::string text = i % 2 == 0 ? "[" : "";
    for (auto left = random() % 12; left > 0; --left) text += parts[random() % std::size(parts)];
    if (i % 2 == 0) text += "]";
    const std::vector<std::string> expected = events_without_cursor(text);
    accepted += !expected.back().starts_with("error");
    ASSERT_EQ(events_with_cursor(text).events, expected) << text;
  }
  EXPECT_GT(accepted, 3000U);
}

TEST(FindJsonFault, finds_a_fault_only_if_the_parser_does) {
  std::mt19937 random(5);
  constexpr std::string_view parts[] = {"[",    "]",  "{",    "}",   ",",     ":",           " ",       "\n", "0",
                                        "-1.5", "01", "null", "tru", "\"a\"", "\"a\\\"b\":", "\"a\":1", "\""};
  for (int i = 0; i < 100'000; ++i) {
    std::string text = i % 2 == 0 ? "[" : "{";
    for (auto left = random() % 8; left > 0; --left) text += parts[random() % std::size(parts)];
    if (i % 4 != 0) text += i % 2 == 0 ? "]" : "}";
    const JsonFault fault = find_json_fault(text);
    const bool accepted = fault.token.empty() && fault.expected == JsonExpected::nothing;
    const bool has_control_character = text.find('\n') != std::string::npos;  // of strings only the ends are checked
    if (has_control_character) continue;
    ASSERT_EQ(accepted, json::accept(text)) << text;
  }
}

TEST(LastJsonValue, is_the_last_string_number_or_word_whatever_it_holds) {
  const auto offset = [](std::string_view text) { return last_json_value(text) - text.data(); };
  EXPECT_EQ(offset("[1, 23,"), 4);
  EXPECT_EQ(offset("[1, \"a\\\\\" ]}"), 4);
  EXPECT_EQ(offset("[1, \"]\\\" [\":"), 4);
  EXPECT_EQ(offset("[1, {"), 5);
}

/// A scanner that has read a text whole.
JsonScanner scanner_of(const std::string& text) {
  JsonScanner scanner([text, read = false]() mutable -> std::optional<std::string> {
    return std::exchange(read, true) ? std::nullopt : std::optional(text);
  });
  (void)scanner.read_more(ErrorCode::json_key_too_long);
  return scanner;
}

TEST(JsonScanner, structure_in_strings_is_skipped) {
  JsonScanner scanner = scanner_of(R"("a,\"[" , 1)");
  ASSERT_TRUE(scanner.skip_to_structure());
  EXPECT_EQ(scanner.view().substr(scanner.at), ", 1");
  JsonScanner open = scanner_of("\"a,\\");
  EXPECT_FALSE(open.skip_to_structure());
  EXPECT_TRUE(open.in_string);
}

TEST(JsonScanner, a_plain_object_is_skipped_and_others_are_not) {
  JsonScanner plain = scanner_of(R"({"a":"]"})");
  plain.skip_plain_object();
  EXPECT_EQ(plain.now(), '"') << "its brace is the next";
  EXPECT_EQ(plain.at, 7U);
  for (const char* text : {R"({"a":{}})", R"({"a":"}"})", R"({"a":"\""})", R"({"a":1)"}) {
    JsonScanner other = scanner_of(text);
    other.skip_plain_object();
    EXPECT_EQ(other.at, 0U) << text;
  }
}

}  // namespace
}  // namespace tcb
