// Options: the table is complete, and its defaults and names are values that the options take.
#include "cli/options.hpp"

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
  EXPECT_EQ(row_of(option::step).other_name, "-s");
}

TEST(Options, names_are_unique_and_each_option_has_a_long_one) {
  std::set<std::string_view> names;
  for (const OptionRow& row : option_table()) {
    for (const std::string_view name : row.all_names()) EXPECT_TRUE(names.insert(name).second) << name;
    EXPECT_TRUE(row.name.starts_with("--")) << row.name;
  }
}

/// Rows begin with the constants of option_names.hpp.
TEST(Options, constants_of_names_are_those_of_the_table) {
  std::ifstream file(SOURCE_FOLDER "/src/option_names.hpp");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  const std::regex constant(R"re(string_view (\w+) = "([^"]*)";)re");
  std::set<std::string> names;
  for (std::sregex_iterator at(text.begin(), text.end(), constant), end; at != end; ++at) {
    std::string expected = "--" + at->str(1);
    std::ranges::replace(expected, '_', '-');
    EXPECT_EQ(at->str(2), expected);
    names.insert(at->str(2));
  }
  std::set<std::string> in_table;
  for (const OptionRow& row : option_table()) in_table.emplace(row.name);
  EXPECT_EQ(names, in_table);
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
      if (name == "velocity" && row.name == option::ends) continue;  // it needs numbers
      TypedOptions typed;
      EXPECT_NO_THROW(row.store(typed, std::string(name))) << row.name << " " << name;
    }
  }
}

TEST(Options, an_unknown_name_is_refused_with_the_known_ones) {
  for (const OptionRow& row : option_table()) {
    if (row.known == nullptr || row.name == option::ends || row.name == option::parameter)
      continue;  // left to the curve
    if (row.name == option::delimiter || row.name == option::output_delimiter || row.name == option::thousands)
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
