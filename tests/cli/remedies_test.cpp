// Remedies: every code has one row of words, and the words show the values and the subject.
#include "cli/remedies.hpp"

#include <gmock/gmock.h>

#include <map>
#include <optional>
#include <regex>

#include "cli/options.hpp"
#include "option_names.hpp"

namespace tcb {
namespace {

TEST(Remedies, every_code_has_exactly_one_row) {
  std::map<ErrorCode, int> rows;
  for (const Words& words : remedies()) ++rows[words.code];
  for (std::size_t code = 0; code < error_code_count; ++code) {
    EXPECT_EQ(rows[static_cast<ErrorCode>(code)], 1) << "code " << code;
  }
  EXPECT_EQ(rows.size(), error_code_count);
}

TEST(Remedies, words_are_one_line_without_a_point_at_the_end) {
  for (const Words& words : remedies()) {
    EXPECT_EQ(words.text.find('\n'), std::string_view::npos) << words.text;
    EXPECT_FALSE(words.text.ends_with('.')) << words.text;
  }
}

/// The message of a code whose first value is a text, and whose others are all `value`; nothing where its words take
/// other kinds of values.
std::optional<std::string> message_with(ErrorCode code, const ErrorValue& value) {
  std::vector<ErrorValue> values(8, value);
  values[0] = std::string("value");
  try {
    return error_message(Error(Exit::usage, code, values).about(option::step));
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

TEST(Remedies, placeholders_are_values_the_subject_or_the_nearest_name) {
  for (const Words& words : remedies()) {
    auto text = message_with(words.code, std::string("value"));
    if (!text) text = message_with(words.code, std::uint64_t{7});  // words that show a number in hexadecimal digits
    ASSERT_TRUE(text) << words.text;
    EXPECT_FALSE(std::regex_search(*text, std::regex("\\{[a-z]*[0-9]"))) << *text;
  }
}

TEST(Remedies, options_in_the_words_are_those_of_the_table) {
  for (const Words& words : remedies()) {
    for (std::size_t at = words.text.find("--"); at != std::string_view::npos; at = words.text.find("--", at + 2)) {
      const std::string_view from_dashes = words.text.substr(at);
      const std::string_view name = from_dashes.substr(0, from_dashes.find_first_not_of("abcdefghijklmnopqrstuvwxyz-"));
      const auto known = [&](const OptionRow& row) { return row.long_name() == name; };
      EXPECT_TRUE(name == "--" || std::ranges::any_of(option_table(), known)) << name << " in: " << words.text;
    }
  }
}

TEST(Remedies, a_value_is_a_text_a_number_or_a_list) {
  const std::vector<std::string> names{"first", "last"};
  const Error error(Exit::usage, ErrorCode::unknown_name, {std::string("fist"), names});
  EXPECT_EQ(error_message(error.about(option::duplicates)),
            "--duplicates: unknown name \"fist\"; expected one of first, last; did you mean first?");
}

}  // namespace
}  // namespace tcb
