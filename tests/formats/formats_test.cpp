// Formats: names, endings and capabilities.
#include "formats/formats.hpp"

#include <gtest/gtest.h>

#include <set>

#include "read/input.hpp"
#include "read/input_options.hpp"
#include "read/reading.hpp"

namespace tcb {
namespace {

TEST(Formats, names_are_unique_and_csv_is_the_default) {
  std::set<std::string_view> names;
  for (const Format& format : formats()) {
    EXPECT_TRUE(names.insert(format.name).second) << format.name;
    EXPECT_TRUE(format.ending.starts_with('.')) << format.ending;
    EXPECT_TRUE(format.can_read() || format.can_write()) << format.name;
    EXPECT_EQ(find_format(format.name), &format);
  }
  EXPECT_EQ(formats().front().name, "csv");
}

TEST(Formats, names_are_in_lower_case) { EXPECT_EQ(find_format("CSV"), nullptr); }

/// The format of a text in a file.
std::string_view format_of(const std::string& file, const std::string& text) {
  return open_input(file, pieces(text), {}).facts.format->name;
}

TEST(Formats, a_file_ending_names_a_format_that_can_be_read) {
  EXPECT_EQ(format_of("a.b/keys.tsv", "t\tx\n0\t1\n"), "tsv");
  EXPECT_EQ(format_of("keys.jsonl", "{\"t\":0,\"x\":1}\n"), "jsonl");
  EXPECT_EQ(format_of("scene.gltf", "t,x\n0,1\n"), "csv");
  EXPECT_EQ(format_of("csv", "t,x\n0,1\n"), "csv");
}

TEST(Formats, a_text_without_a_known_ending_is_in_the_format_that_fits_best) {
  EXPECT_EQ(format_of("keys", " [{\"t\":0,\"x\":1}]"), "json");
  EXPECT_EQ(format_of("keys", "t\tx\n0\t1\n"), "csv") << "whose delimiter is found";
}

TEST(Formats, an_ending_names_the_first_format_that_has_it) {
  EXPECT_EQ(find_output_format("path.json")->name, "json");
  EXPECT_EQ(find_output_format("pieces.csv")->name, "csv");
}

}  // namespace
}  // namespace tcb
