// Provenance: in comment lines and in JSON.
#include "write/provenance.hpp"

#include <gmock/gmock.h>

#include <optional>
#include <string>
#include <utility>

#include "formats/formats.hpp"
#include "keys.hpp"

namespace tcb {
namespace {

Provenance example() {
  return {"tcbsample 1.2.3",
          {{"tangents", "uniform"}},
          "tcbsample '--columns=position=\"a\\b\"'",
          {{"k.csv", "0a"}},
          1,
          5,
          25};
}

TEST(Provenance, is_in_comments_around_the_rows) {
  EXPECT_EQ(text_before_rows(example(), *find_format("csv")),
            "# tcbsample 1.2.3\n# tangents: uniform\n# command: tcbsample '--columns=position=\"a\\b\"'\n#\n");
  EXPECT_EQ(text_after_rows(example(), *find_format("csv")),
            "# input: k.csv\n# sha256: 0a\n# curves: 1\n# keys: 5\n# rows: 25\n");
}

TEST(Provenance, is_a_member_of_json) {
  EXPECT_EQ(text_after_rows(example(), *find_format("json")),
            "\"meta\":{\"program\":\"tcbsample 1.2.3\",\"tangents\":\"uniform\",\"command\":\"tcbsample "
            "'--columns=position=\\\"a\\\\b\\\"'\",\"inputs\":[{\"name\":\"k.csv\",\"sha256\":\"0a\"}],"
            "\"curves\":1,\"keys\":5,\"rows\":25}");
}

Source<std::string> bytes_of(const std::string& text) {
  return [text, done = false]() mutable -> std::optional<std::string> {
    return std::exchange(done, true) ? std::nullopt : std::optional(text);
  };
}

/// SHA-256 of "abc", from FIPS 180-2.
constexpr const char* abc = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";

TEST(ProvenanceRecorder, counts_what_is_read_and_the_rest) {
  const std::optional<ProvenanceRequest> request(ProvenanceRequest{"tcbsample 1.2.3", {"tcbsample", "-n=3"}, {}});
  ProvenanceRecorder recorder(request);
  (void)recorder.observe_bytes("abc.csv", bytes_of("abc"));
  (void)recorder.observe_keys(keys_of("0 1\n1 2\n2 3\n", 1))();
  recorder.end_curve();
  recorder.end_input();
  EXPECT_EQ(recorder.before_rows(*find_format("csv")), "# tcbsample 1.2.3\n# command: tcbsample -n=3 abc.csv\n#\n");
  EXPECT_EQ(recorder.after_rows(*find_format("csv")),
            "# input: abc.csv\n# sha256: " + std::string(abc) + "\n# curves: 1\n# keys: 3\n# rows: 0\n");
}

TEST(ProvenanceRecorder, without_a_request_adds_nothing) {
  const std::optional<ProvenanceRequest> none;
  ProvenanceRecorder recorder(none);
  EXPECT_EQ(recorder.observe_bytes("a", bytes_of("abc"))(), "abc");
  recorder.end_input();
  EXPECT_EQ(recorder.before_rows(*find_format("csv")) + recorder.after_rows(*find_format("csv")), "");
}

}  // namespace
}  // namespace tcb
