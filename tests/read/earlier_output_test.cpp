// Earlier outputs: their provenance in the comment lines of delimited text and in JSON, in parts of any size.
#include "read/earlier_output.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <string>

#include "error.hpp"

namespace tcb {
namespace {

using testing::ElementsAre;
using testing::Pair;

/// What a text holds that arrives in parts of so many bytes.
std::optional<EarlierOutput> read_earlier(std::string_view text, std::size_t part) {
  EarlierOutputReader reader;
  for (std::size_t at = 0; at < text.size(); at += part) reader.add(text.substr(at, part));
  return reader.end();
}

constexpr std::string_view comments =
    "# tcbsample 1.2.3\n# preset: gte\n# option: --count=2\n# option: --meta\n#\nt,x\n# not a name: 1\n0,0\n"
    "# input: a b.csv\n# sha256: 12ab\n# input: c.csv\n# sha256: 34cd";

TEST(EarlierOutput, is_read_from_comment_lines) {
  for (const std::size_t part : {std::size_t{1}, std::size_t{7}, comments.size()}) {
    const std::optional<EarlierOutput> output = read_earlier(comments, part);
    ASSERT_TRUE(output) << part;
    EXPECT_EQ(output->program, "tcbsample 1.2.3");
    EXPECT_THAT(output->options, ElementsAre("--count=2", "--meta"));
    EXPECT_THAT(output->inputs, ElementsAre(Pair("a b.csv", "12ab"), Pair("c.csv", "34cd")));
  }
}

TEST(EarlierOutput, may_have_line_ends_of_two_characters) {
  std::string text;
  for (const char c : comments) text += c == '\n' ? "\r\n" : std::string(1, c);
  const std::optional<EarlierOutput> output = read_earlier(text, 5);
  ASSERT_TRUE(output);
  EXPECT_THAT(output->options, ElementsAre("--count=2", "--meta"));
}

TEST(EarlierOutput, is_read_from_the_member_meta_of_json) {
  constexpr std::string_view json = R"({"rows":[{"t":0}],"meta":{"program":"tcbsample 1.2.3","options":["--meta"],)"
                                    R"("inputs":[{"name":"k.csv","sha256":"12ab"}]}})";
  for (const std::size_t part : {std::size_t{1}, json.size()}) {
    const std::optional<EarlierOutput> output = read_earlier(json, part);
    ASSERT_TRUE(output) << part;
    EXPECT_EQ(output->program, "tcbsample 1.2.3");
    EXPECT_THAT(output->options, ElementsAre("--meta"));
    EXPECT_THAT(output->inputs, ElementsAre(Pair("k.csv", "12ab")));
  }
}

TEST(EarlierOutput, is_read_from_the_last_one_of_json_lines) {
  const std::optional<EarlierOutput> output = read_earlier(
      "{\"t\":0}\n{\"meta\":{\"program\":\"p 1\",\"options\":[\"a\",\"b\"],"
      "\"inputs\":[{\"name\":\"n\",\"sha256\":\"0f\"}]}}\n",
      9);
  ASSERT_TRUE(output);
  EXPECT_THAT(output->options, ElementsAre("a", "b"));
  EXPECT_THAT(output->inputs, ElementsAre(Pair("n", "0f")));
  EXPECT_FALSE(read_earlier("{\"t\":", 9));
}

TEST(EarlierOutput, needs_a_program_and_an_input) {
  EXPECT_FALSE(read_earlier("t,x\n0,0\n", 3));
  EXPECT_FALSE(read_earlier("# tcbsample 1.2.3\nt,x\n0,0\n", 3));
  EXPECT_FALSE(read_earlier(R"([{"t":0}])", 3));
  EXPECT_THROW((void)read_earlier_output([] { return std::optional<std::string>(); }), Error);
}

}  // namespace
}  // namespace tcb
