// Tables: every option and preset is in the JSON.

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "cli/command_line.hpp"
#include "cli/help.hpp"
#include "cli/options.hpp"
#include "tcb/spline/rules.hpp"

namespace tcb {
namespace {

TEST(Tables, options_and_presets_are_json) {
  const auto tables = nlohmann::json::parse(tables_text());
  EXPECT_EQ("tcbsample " + tables["version"].get<std::string>(), version_text());
  ASSERT_EQ(tables["options"].size(), option_table().size());
  for (const auto& option : tables["options"]) {
    const OptionRow& row = row_of(option["name"].get<std::string>());
    EXPECT_EQ(option["other_name"], row.other_name);
    EXPECT_EQ(option["kind"] == "flag", row.kind == ValueKind::flag) << row.name;
    EXPECT_EQ(option["known"].empty(), row.known == nullptr) << row.name;
  }
  ASSERT_EQ(tables["presets"].size(), spline::presets.size());
  EXPECT_EQ(tables["presets"][0]["name"], spline::presets[0].name);
  EXPECT_EQ(printed_text({"--generate", "tables"}), tables_text());
}

}  // namespace
}  // namespace tcb
