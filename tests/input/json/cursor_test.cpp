// The cursor: what a parser reads through it is what it reads without.
#include "input/json/cursor.hpp"

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

/// Reads as it is, and leaves word of how far the reading is.
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

/// Keeps what a parser says and how far it has read then, each as text; numbers with their written form where they
/// have one.
struct Listener {
  const char* begin;
  JsonReading reading{begin, {}};
  std::vector<std::string> heard = {};
  std::size_t read = 0;  ///< numbers that the cursor read

  bool say(std::string what) {
    heard.push_back(std::move(what) + " before " + std::to_string(reading.now - begin));
    return true;
  }
  bool null() { return say("null"); }
  bool boolean(bool value) { return say(value ? "true" : "false"); }
  bool number_integer(json::number_integer_t value) { return say("integer " + std::to_string(value)); }
  bool number_unsigned(json::number_unsigned_t value) {
    const auto number = std::exchange(reading.number, std::nullopt);
    if (!number) return say("whole " + std::to_string(value));
    ++read;
    return number_float(number->value, std::string(number->text));
  }
  bool number_float(json::number_float_t value, const std::string& text) {
    return say("number " + std::to_string(std::bit_cast<std::uint64_t>(value)) + " from " + text);
  }
  bool string(std::string& text) { return say("string " + text); }
  bool binary(json::binary_t&) { return false; }
  bool start_object(std::size_t) { return say("{"); }
  bool key(std::string& name) { return say("key " + name); }
  bool end_object() { return say("}"); }
  bool start_array(std::size_t) { return say("["); }
  bool end_array() { return say("]"); }
  bool parse_error(std::size_t, const std::string&, const json::exception&) {
    say("error");
    return false;
  }
};

std::vector<std::string> heard_without(std::string_view text) {
  Listener listener{text.data()};
  const char* const end = text.data() + text.size();
  json::sax_parse(PlainCursor{text.data(), &listener.reading}, PlainCursor{end, &listener.reading}, &listener);
  return listener.heard;
}

Listener heard_through_cursor(std::string_view text) {
  Listener listener{text.data()};
  const char* const end = text.data() + text.size();
  json::sax_parse(JsonCursor(text.data(), end, listener.reading), JsonCursor(end, end, listener.reading), &listener);
  return listener;
}

TEST(JsonCursor, reads_numbers_with_a_fraction_or_an_exponent) {
  const Listener listener =
      heard_through_cursor(R"([1.5, -2e-3,7E+2 , 0, -0, 12, "3.5 \" 4.5", {"6.5":-0.0}, 1e-400])");
  EXPECT_EQ(listener.read, 5U);
  EXPECT_EQ(listener.heard, heard_without(R"([1.5, -2e-3,7E+2 , 0, -0, 12, "3.5 \" 4.5", {"6.5":-0.0}, 1e-400])"));
}

TEST(JsonCursor, leaves_to_the_parser_what_is_no_number_of_json) {
  for (const char* text : {"[01.5]", "[.5]", "[1.]", "[1.5e]", "[1.5.2]", "[+1.5]", "[1.5x]", "[--1.5]", "[1e400]",
                           "[0x1p3]", "[1.5 2.5]", "{1.5:2}", "[1,5e999]", "[1.5", "1.5", "", "-", "[\"1.5"}) {
    EXPECT_EQ(heard_through_cursor(text).heard, heard_without(text)) << text;
  }
}

TEST(JsonCursor, tells_of_any_text_what_the_parser_hears_without_it) {
  std::mt19937 random(3);
  constexpr std::string_view parts[] = {"[",  "]", "{",   "}",  ",",    ":",   "\"",    "\\", " ",
                                        "\n", "0", "1",   "25", "-",    "1.5", "-0.0",  ".",  "e",
                                        "E+", "3", "e-7", "17", "null", "x",   "\"a\":"};
  std::size_t accepted = 0;
  for (int i = 0; i < 300'000; ++i) {
    std::string text = i % 2 == 0 ? "[" : "";
    for (auto left = random() % 12; left > 0; --left) text += parts[random() % std::size(parts)];
    if (i % 2 == 0) text += "]";
    const std::vector<std::string> expected = heard_without(text);
    accepted += !expected.back().starts_with("error");
    ASSERT_EQ(heard_through_cursor(text).heard, expected) << text;
  }
  EXPECT_GT(accepted, 3000U);
}

}  // namespace
}  // namespace tcb
