// Provenance: written in comment lines and in JSON, and read from both.
#include "output/provenance.hpp"

#include <gmock/gmock.h>

#include "error.hpp"

namespace tcb {
namespace {

using testing::ElementsAre;
using testing::Pair;

Provenance read(const std::string& text) {
  return read_meta([text, done = false]() mutable -> std::optional<std::string> {
    return std::exchange(done, true) ? std::nullopt : std::optional(text);
  });
}

Provenance example() {
  return {"tcbsample 1.2.3",
          {{"tangents", "uniform"}},
          {"--step=1/24", "--columns=position=\"a\\b\":# c"},
          {{"k.csv", "0a"}},
          1,
          5,
          25};
}

void expect_example(const Provenance& meta) {
  EXPECT_EQ(meta.program, "tcbsample 1.2.3");
  EXPECT_EQ(meta.options, example().options);
  EXPECT_THAT(meta.inputs, ElementsAre(Pair("k.csv", "0a")));
}

TEST(Provenance, is_in_comments_around_the_rows) {
  EXPECT_EQ(text_before_rows(example(), FormatId::csv),
            "# tcbsample 1.2.3\n# tangents: uniform\n# option: --step=1/24\n# option: "
            "--columns=position=\"a\\b\":# c\n#\n");
  EXPECT_EQ(text_after_rows(example(), FormatId::csv),
            "# input: k.csv\n# sha256: 0a\n# curves: 1\n# keys: 5\n# rows: 25\n");
}

TEST(Provenance, is_read_back_from_lines) {
  expect_example(
      read(text_before_rows(example(), FormatId::csv) + "t,x\n0,1\n" + text_after_rows(example(), FormatId::csv)));
  std::string carriage = text_before_rows(example(), FormatId::csv) + text_after_rows(example(), FormatId::csv);
  for (std::size_t at = 0; (at = carriage.find('\n', at)) != std::string::npos; at += 2) carriage.insert(at, "\r");
  expect_example(read(carriage));
}

TEST(Provenance, is_read_back_from_json_of_every_shape) {
  const std::string object = text_after_rows(example(), FormatId::json);
  expect_example(read("{\"rows\":[{\"meta\":{\"program\":\"no\"}}],\n" + object + "}\n"));
  expect_example(read("{" + object + ",\"curves\":[{\"id\":1,\"rows\":[]}]}"));
  expect_example(read("{\"t\":0,\"x\":1}\n{\"t\":1,\"x\":1}\n" + text_after_rows(example(), FormatId::jsonl)));
}

TEST(Provenance, is_an_error_where_there_is_none) {
  for (const char* text : {"", "t,x\n0,1\n", "# t x\n0 1\n", "[{\"t\":0}]", "{\"t\":0}\n{\"t\":1}\n", "{\"meta\":3}",
                           "{\"meta\":{\"options\":3,\"inputs\":[4]}}", "{\"me"}) {
    EXPECT_THROW(read(text), Error) << text;
  }
}

}  // namespace
}  // namespace tcb
