// Tests of the inputs: which files there are, and where the rows of each go.
#include "io/input_list.hpp"
#include "cli/remedies.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "error.hpp"

namespace {

namespace fs = std::filesystem;
using tcb::find_inputs;
using tcb::Job;
using tcb::output_path;

class Inputs : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "tcbsample_XXXXXX").string();
    ASSERT_NE(::mkdtemp(name.data()), nullptr);
    folder_ = name;
    fs::current_path(folder_);
  }
  void TearDown() override {
    fs::current_path("/");
    fs::remove_all(folder_);
  }

  static void touch(const std::string& path) {
    fs::create_directories(fs::path("./" + path).parent_path());
    std::ofstream(path) << path;
  }

  /// The files as "path -> output".
  static std::vector<std::string> found(const Job& plan) {
    std::vector<std::string> texts;
    for (const auto& file : find_inputs(plan).files) texts.push_back(file.path + " -> " + output_path(file, plan));
    return texts;
  }

  static std::string refusal(const Job& plan) {
    try {
      find_inputs(plan);
    } catch (const tcb::Error& error) {
      return error_text(error);
    }
    return "";
  }

 private:
  fs::path folder_;
};

TEST_F(Inputs, a_folder_is_mirrored) {
  for (const char* path : {"in/b.csv", "in/a/x.json", "in/a/x.png", "in/a/deep/y.csv"}) touch(path);
  Job plan;
  plan.files = {"in"};
  plan.batch.recursive = true;
  plan.output_folder = "out";
  const std::vector<std::string> expected{"in/a/deep/y.csv -> out/a/deep/y.csv", "in/a/x.json -> out/a/x.csv",
                                          "in/b.csv -> out/b.csv"};
  EXPECT_EQ(found(plan), expected);
  EXPECT_EQ(find_inputs(plan).left_alone, 1);
  plan.files = {"./in//"};
  EXPECT_EQ(found(plan).at(1), "./in//a/x.json -> out/a/x.csv");
  plan.input.format = tcb::FormatId::csv;  // every file is one of this format
  EXPECT_NE(refusal(plan).find("a/x.csv is that of"), std::string::npos);
}

TEST_F(Inputs, a_file_goes_by_its_name_alone) {
  touch("in/a.b.csv");
  Job plan;
  plan.files = {"in/a.b.csv"};
  plan.output_folder = "out";
  plan.batch.suffix = "-1";
  EXPECT_EQ(found(plan).at(0), "in/a.b.csv -> out/a.b-1.csv");
}

TEST_F(Inputs, an_output_is_current_where_it_is_not_older) {
  for (const char* path : {"a.csv", "b.csv", "c.csv", "out/a.csv", "out/b.csv"}) touch(path);
  const auto now = fs::last_write_time("a.csv");
  fs::last_write_time("out/a.csv", now);
  fs::last_write_time("out/b.csv", fs::last_write_time("b.csv") - std::chrono::milliseconds(1));
  Job plan;
  plan.files = {"a.csv", "b.csv", "c.csv"};
  plan.output_folder = "out";
  plan.batch.update = true;
  const auto inputs = find_inputs(plan);
  EXPECT_TRUE(inputs.files[0].is_current);
  EXPECT_FALSE(inputs.files[1].is_current);
  EXPECT_FALSE(inputs.files[2].is_current);
  EXPECT_EQ(inputs.files[0].size, 5);
}

TEST_F(Inputs, lists_name_more_files) {
  for (const char* path : {"a.csv", "b.csv"}) touch(path);
  std::ofstream("list") << "b.csv\n\na.csv";
  Job plan;
  plan.batch.list = "list";
  plan.output_folder = "out";
  const std::vector<std::string> expected{"b.csv -> out/b.csv", "a.csv -> out/a.csv"};
  EXPECT_EQ(found(plan), expected);
  plan.batch.nul = true;  // now it is one name, with line ends in it
  EXPECT_EQ(found(plan).size(), 1);
}

TEST_F(Inputs, no_output_takes_the_place_of_an_input) {
  for (const char* path : {"a.csv", "b.csv"}) touch(path);
  fs::create_symlink("../b.csv", "link");
  fs::create_directory("out");
  fs::create_hard_link("b.csv", "out/a.csv");
  Job plan;
  plan.files = {"a.csv", "b.csv"};
  plan.output_folder = "out";
  EXPECT_EQ(refusal(plan),
            "a.csv: error: its output out/a.csv is an input too; expected two files; give another output");
}

}  // namespace
