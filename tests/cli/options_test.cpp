// Options: the table is complete, and its defaults and names are values that the options take.
#include "cli/options.hpp"

#include <fstream>
#include <iterator>
#include <regex>
#include <set>

#include "cli/command_line.hpp"

namespace tcb {
namespace {

TEST(Options, each_has_the_row_at_its_place) {
  ASSERT_EQ(option_table().size(), option_count);
  for (std::size_t i = 0; i < option_count; ++i) {
    EXPECT_EQ(index_of(option_table()[i].id), i) << option_table()[i].names;
    EXPECT_EQ(row_of(option_table()[i].id).long_name(), option_table()[i].long_name());
  }
  EXPECT_EQ(row_of(Option::rate).long_name(), "--rate");
}

TEST(Options, names_are_unique_and_each_option_has_a_long_one) {
  std::set<std::string_view> names;
  for (const OptionRow& row : option_table()) {
    for (const std::string_view name : row.all_names()) EXPECT_TRUE(names.insert(name).second) << name;
    EXPECT_TRUE(row.long_name().starts_with("--")) << row.names;
  }
}

/// Errors and notes name options by the constants of option_names.hpp.
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
  for (const OptionRow& row : option_table()) in_table.emplace(row.long_name());
  EXPECT_EQ(names, in_table);
}

TEST(Options, texts_have_no_point_at_the_end_and_flags_no_value) {
  for (const OptionRow& row : option_table()) {
    EXPECT_FALSE(row.text.empty()) << row.names;
    EXPECT_FALSE(row.text.ends_with('.')) << row.names << ": the manual adds the point";
    EXPECT_EQ(row.kind == ValueKind::flag, row.value.empty()) << row.names;
    EXPECT_EQ(row.kind == ValueKind::name || row.kind == ValueKind::names, row.known != nullptr) << row.names;
  }
}

TEST(Options, groups_are_not_split) {
  std::set<std::string_view> groups;
  std::string_view group;
  for (const OptionRow& row : option_table()) {
    if (row.group == group) continue;
    EXPECT_TRUE(groups.insert(group = row.group).second) << row.names;
  }
}

TEST(Options, every_default_is_a_value_of_its_option) {
  for (const OptionRow& row : option_table()) {
    if (row.default_value.empty()) continue;
    TypedOptions typed;
    EXPECT_NO_THROW(row.store(typed, std::string(row.default_value))) << row.names;
  }
}

TEST(Options, every_name_is_a_value_of_its_option) {
  for (const OptionRow& row : option_table()) {
    if (row.known == nullptr) continue;
    for (const std::string_view name : row.known()) {
      TypedOptions typed;
      EXPECT_NO_THROW(row.store(typed, std::string(name))) << row.names << " " << name;
    }
  }
}

TEST(Options, an_unknown_name_is_refused_with_the_known_ones) {
  for (const OptionRow& row : option_table()) {
    if (row.known == nullptr || row.id == Option::ends || row.id == Option::parameter) continue;  // left to the curve
    if (row.id == Option::delimiter) continue;                                                    // also any character
    TypedOptions typed;
    try {
      row.store(typed, "wrong");
      ADD_FAILURE() << row.names;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::unknown_name) << row.names;
      EXPECT_EQ(std::get<std::vector<std::string>>(error.values().at(1)).size(), row.known().size()) << row.names;
    }
  }
}

}  // namespace
}  // namespace tcb
