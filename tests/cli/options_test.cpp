// Options: the table is complete, and its defaults and names are values that the options take.
#include "cli/options.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>

#include "cli/command_line.hpp"
#include "cli/values.hpp"

namespace tcb {
namespace {

TEST(Options, each_is_found_by_its_name) {
  for (const OptionRow& row : option_table()) EXPECT_EQ(&row_of(row.name), &row) << row.name;
  EXPECT_EQ(row_of("--step").other_name, "-s");
}

TEST(Options, names_are_unique_and_each_option_has_a_long_one) {
  std::set<std::string_view> names;
  for (const OptionRow& row : option_table()) {
    for (const std::string_view name : row.all_names()) EXPECT_TRUE(names.insert(name).second) << name;
    EXPECT_TRUE(row.name.starts_with("--")) << row.name;
  }
}

/// Messages and conditions name options as they are typed, and those of the programs that convert files. A sign of
/// missing numbers looks like one.
TEST(Options, sources_name_options_of_the_table) {
  std::set<std::string> known{"--batch", "--csv", "--json", "--long", "--topics", "--undefined--"};
  for (const OptionRow& row : option_table()) {
    for (const std::string_view name : row.all_names()) known.emplace(name);
  }
  const std::regex text(R"re('(?:[^'\\]|\\.)'|"(?:[^"\\]|\\.)*")re"), option(R"re((?:^|[^\w-])(--[a-z][a-z-]*))re");
  for (const auto& entry : std::filesystem::recursive_directory_iterator(SOURCE_FOLDER "/src")) {
    const auto ending = entry.path().extension();
    const bool names_what_is_gone = entry.path().filename() == "removed.cpp";
    if ((ending != ".cpp" && ending != ".hpp") || names_what_is_gone) continue;
    std::ifstream file(entry.path());
    for (std::string line; std::getline(file, line);) {
      for (std::sregex_iterator at(line.begin(), line.end(), text), end; at != end; ++at) {
        const std::string literal = at->str();
        for (std::sregex_iterator name(literal.begin(), literal.end(), option); name != end; ++name) {
          EXPECT_TRUE(known.contains(name->str(1))) << entry.path() << ": " << name->str(1);
        }
      }
    }
  }
}

TEST(Options, texts_have_no_point_at_the_end_and_flags_no_value) {
  for (const OptionRow& row : option_table()) {
    EXPECT_FALSE(row.text.empty()) << row.name;
    EXPECT_FALSE(row.text.ends_with('.')) << row.name << ": the manual adds the point";
    EXPECT_EQ(row.kind == ValueKind::flag, row.value.empty()) << row.name;
    EXPECT_EQ(row.kind == ValueKind::name || row.kind == ValueKind::names, row.known != nullptr) << row.name;
  }
}

TEST(Options, groups_are_not_split) {
  std::set<std::string_view> groups;
  std::string_view group;
  for (const OptionRow& row : option_table()) {
    if (row.group == group) continue;
    EXPECT_TRUE(groups.insert(group = row.group).second) << row.name;
  }
}

TEST(Options, every_default_is_a_value_of_its_option) {
  for (const OptionRow& row : option_table()) {
    if (row.default_value.empty()) continue;
    TypedOptions typed;
    EXPECT_NO_THROW(row.store(typed, std::string(row.default_value))) << row.name;
  }
}

TEST(Options, every_name_is_a_value_of_its_option) {
  for (const OptionRow& row : option_table()) {
    if (row.known == nullptr) continue;
    for (const std::string_view name : row.known()) {
      if (name == "velocity" && row.name == "--ends") continue;  // it needs numbers
      TypedOptions typed;
      EXPECT_NO_THROW(row.store(typed, std::string(name))) << row.name << " " << name;
    }
  }
}

TEST(Options, an_unknown_name_is_refused_with_the_known_ones) {
  for (const OptionRow& row : option_table()) {
    if (row.known == nullptr || row.name == "--ends" || row.name == "--parameter") continue;  // left to the curve
    if (row.name == "--delimiter" || row.name == "--output-delimiter" || row.name == "--thousands")
      continue;  // also a character
    TypedOptions typed;
    try {
      row.store(typed, "wrong");
      ADD_FAILURE() << row.name;
    } catch (const Error& error) {
      EXPECT_EQ(error.message(), unknown_value("wrong", row.known()).message()) << row.name;
    }
  }
}

}  // namespace
}  // namespace tcb
