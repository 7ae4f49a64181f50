// Provenance: written in comment lines and in JSON, and read from both.
#include "write/provenance.hpp"

#include <gmock/gmock.h>

#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "error.hpp"
#include "formats/formats.hpp"
#include "keys.hpp"
#include "read/earlier_output.hpp"

namespace tcb {
namespace {

using testing::ElementsAre;
using testing::Pair;

EarlierOutput read(const std::string& text) {
  return read_earlier_output([text, done = false]() mutable -> std::optional<std::string> {
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

void expect_example(const EarlierOutput& meta) {
  EXPECT_EQ(meta.program, "tcbsample 1.2.3");
  EXPECT_EQ(meta.options, example().options);
  EXPECT_THAT(meta.inputs, ElementsAre(Pair("k.csv", "0a")));
}

TEST(Provenance, is_in_comments_around_the_rows) {
  EXPECT_EQ(text_before_rows(example(), *find_format("csv")),
            "# tcbsample 1.2.3\n# tangents: uniform\n# option: --step=1/24\n# option: "
            "--columns=position=\"a\\b\":# c\n#\n");
  EXPECT_EQ(text_after_rows(example(), *find_format("csv")),
            "# input: k.csv\n# sha256: 0a\n# curves: 1\n# keys: 5\n# rows: 25\n");
}

TEST(Provenance, is_read_back_from_lines) {
  expect_example(read(text_before_rows(example(), *find_format("csv")) + "t,x\n0,1\n" +
                      text_after_rows(example(), *find_format("csv"))));
  std::string carriage =
      text_before_rows(example(), *find_format("csv")) + text_after_rows(example(), *find_format("csv"));
  for (std::size_t at = 0; (at = carriage.find('\n', at)) != std::string::npos; at += 2) carriage.insert(at, "\r");
  expect_example(read(carriage));
}

TEST(Provenance, is_read_back_from_json_of_every_shape) {
  const std::string object = text_after_rows(example(), *find_format("json"));
  expect_example(read("{\"rows\":[{\"meta\":{\"program\":\"no\"}}],\n" + object + "}\n"));
  expect_example(read("{" + object + ",\"curves\":[{\"id\":1,\"rows\":[]}]}"));
  expect_example(read("{\"t\":0,\"x\":1}\n{\"t\":1,\"x\":1}\n" + text_after_rows(example(), *find_format("jsonl"))));
}

TEST(Provenance, is_an_error_where_there_is_none) {
  for (const char* text : {"", "t,x\n0,1\n", "# t x\n0 1\n", "[{\"t\":0}]", "{\"t\":0}\n{\"t\":1}\n", "{\"meta\":3}",
                           "{\"meta\":{\"options\":3,\"inputs\":[4]}}", "{\"me"}) {
    EXPECT_THROW(read(text), Error) << text;
  }
}

Source<std::string> bytes_of(const std::string& text) {
  return [text, done = false]() mutable -> std::optional<std::string> {
    return std::exchange(done, true) ? std::nullopt : std::optional(text);
  };
}

/// SHA-256 of "abc", from FIPS 180-2.
constexpr const char* abc = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";

std::string message_of(const std::function<void()>& f) {
  try {
    f();
  } catch (const Error& error) {
    return error.message();
  }
  return "";
}

TEST(ProvenanceRecorder, counts_what_is_read_and_the_rest) {
  const std::optional<ProvenanceRequest> request(ProvenanceRequest{example(), {}, ""});
  ProvenanceRecorder recorder(request);
  (void)recorder.observe_bytes("abc.csv", bytes_of("abc"));
  (void)recorder.observe_keys(keys_of("0 1\n1 2\n2 3\n", 1))();
  recorder.end_curve();
  recorder.end_input();
  EXPECT_EQ(recorder.after_rows(*find_format("csv")), "# input: k.csv\n# sha256: 0a\n# input: abc.csv\n# sha256: " +
                                                          std::string(abc) + "\n# curves: 2\n# keys: 8\n# rows: 25\n");
}

TEST(ProvenanceRecorder, without_a_request_adds_nothing) {
  const std::optional<ProvenanceRequest> none;
  ProvenanceRecorder recorder(none);
  EXPECT_EQ(recorder.observe_bytes("a", bytes_of("abc"))(), "abc");
  recorder.end_input();
  EXPECT_EQ(recorder.before_rows(*find_format("csv")) + recorder.after_rows(*find_format("csv")), "");
}

TEST(ProvenanceRecorder, requires_the_inputs_of_the_earlier_output) {
  ProvenanceRequest request;
  request.earlier.inputs = {{"first.csv", abc}};
  const std::optional<ProvenanceRequest> made_from_one(request);
  ProvenanceRecorder recorder(made_from_one);
  EXPECT_THAT(message_of([&] { (void)recorder.after_rows(*find_format("csv")); }),
              testing::StartsWith("there are fewer"));
  EXPECT_EQ(recorder.observe_bytes("other name.csv", bytes_of("abc"))(), "abc");
  recorder.end_input();
  EXPECT_THAT(recorder.after_rows(*find_format("csv")), testing::StartsWith("# input: first.csv\n"));
  EXPECT_THAT(message_of([&] { (void)recorder.observe_bytes("second.csv", bytes_of("abc")); }),
              testing::StartsWith("there are more"));
  ProvenanceRecorder another(made_from_one);
  EXPECT_THAT(message_of([&] { (void)another.observe_bytes("first.csv", bytes_of("abd")); }),
              testing::HasSubstr(std::string("expected ") + abc));
}

}  // namespace
}  // namespace tcb
