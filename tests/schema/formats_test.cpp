// Formats: names, endings and capabilities.
#include "schema/formats.hpp"

#include <gtest/gtest.h>

#include <set>

namespace tcb {
namespace {

TEST(Formats, names_are_unique_and_csv_is_the_default) {
  std::set<std::string_view> names;
  for (const Format& format : formats) {
    EXPECT_TRUE(names.insert(format.name).second) << format.name;
    EXPECT_TRUE(format.ending.starts_with('.')) << format.ending;
    EXPECT_EQ(&format_of(format.id), &format);
    EXPECT_EQ(find_format(format.name), format.id);
  }
  EXPECT_EQ(formats[0].id, FormatId::csv);
}

TEST(Formats, names_are_in_lower_case) { EXPECT_EQ(find_format("CSV"), std::nullopt); }

TEST(Formats, a_file_ending_names_a_format_that_can_be_read) {
  EXPECT_EQ(find_input_format("a.b/keys.tsv"), FormatId::tsv);
  EXPECT_EQ(find_input_format("keys.jsonl"), FormatId::jsonl);
  EXPECT_EQ(find_input_format("rows.npy"), FormatId::npy);
  EXPECT_EQ(find_input_format("scene.gltf"), std::nullopt);
  EXPECT_EQ(find_input_format("csv"), std::nullopt);
}

TEST(Formats, an_ending_names_the_first_format_that_has_it) {
  EXPECT_EQ(find_input_format("path.json"), FormatId::json);
  EXPECT_EQ(find_output_format("path.json"), FormatId::json);
  EXPECT_EQ(find_output_format("pieces.csv"), FormatId::csv);
}

}  // namespace
}  // namespace tcb
