// Provenance in JSON: the member "meta" of an earlier output.
#include "read/json/provenance.hpp"

#include <gmock/gmock.h>

namespace tcb {
namespace {

TEST(JsonProvenance, is_the_member_meta_of_the_text_or_of_its_last_line) {
  const std::string meta = R"("meta":{"program":"p 1","options":["a","b"],"inputs":[{"name":"n","sha256":"0f"}]})";
  for (const std::string& text : {"{\"rows\":[{\"t\":0}]," + meta + "}\n", "{\"t\":0}\n{" + meta + "}\n"}) {
    const EarlierOutput found = json_provenance(text);
    EXPECT_EQ(found.program, "p 1");
    EXPECT_THAT(found.options, testing::ElementsAre("a", "b"));
    EXPECT_THAT(found.inputs, testing::ElementsAre(testing::Pair("n", "0f")));
  }
  EXPECT_EQ(json_provenance("{\"t\":0}\n").program, "");
  EXPECT_EQ(json_provenance("{\"t\":").program, "");
}

}  // namespace
}  // namespace tcb
