// Input lists: files of folders and lists, the paths of outputs, and outputs that would replace inputs.
#include "io/input_list.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "error.hpp"
#include "io/system.hpp"
#include "io/terminal.hpp"
#include "temporary_folder.hpp"

namespace {

namespace fs = std::filesystem;
using tcb::find_inputs;
using tcb::InputListOptions;
using tcb::output_path;

class Inputs : public testing::Test {
 protected:
  void SetUp() override { fs::current_path(folder_.path()); }
  void TearDown() override { fs::current_path("/"); }

  static void touch(const std::string& path) {
    fs::create_directories(fs::path("./" + path).parent_path());
    std::ofstream(path) << path;
  }

  /// The files as "path -> output".
  static std::vector<std::string> found(const InputListOptions& options) {
    std::vector<std::string> texts;
    for (const auto& file : find_inputs(options).files)
      texts.push_back(file.path + " -> " + output_path(file, options.outputs));
    return texts;
  }

  static std::string refusal(const InputListOptions& options) {
    try {
      find_inputs(options);
    } catch (const tcb::Error& error) {
      return error_text(error);
    }
    return "";
  }

 private:
  tcb::TemporaryFolder folder_;
};

TEST_F(Inputs, a_folder_is_mirrored) {
  for (const char* path : {"in/b.csv", "in/c.csv.gz", "in/a/x.json", "in/a/x.png", "in/a/deep/y.csv"}) touch(path);
  InputListOptions options;
  options.files = {"in"};
  options.recursive = true;
  options.endings = {".csv", ".json"};
  options.outputs.folder = "out";
  options.outputs.ending = ".csv";
  const std::vector<std::string> expected{"in/a/deep/y.csv -> out/a/deep/y.csv", "in/a/x.json -> out/a/x.csv",
                                          "in/b.csv -> out/b.csv", "in/c.csv.gz -> out/c.csv"};
  EXPECT_EQ(found(options), expected);
  EXPECT_EQ(find_inputs(options).others, 1);
  options.files = {"./in//"};
  EXPECT_EQ(found(options).at(1), "./in//a/x.json -> out/a/x.csv");
  options.endings.clear();
  EXPECT_NE(refusal(options).find("a/x.csv is also the output of"), std::string::npos);
}

TEST_F(Inputs, lists_name_more_files) {
  for (const char* path : {"a.csv", "b.csv"}) touch(path);
  std::ofstream("list") << "\xEF\xBB\xBF"
                        << "b.csv\n\na.csv";  // after a byte order mark
  InputListOptions options;
  options.list = "list";
  options.outputs.folder = "out";
  options.outputs.ending = ".csv";
  const std::vector<std::string> expected{"b.csv -> out/b.csv", "a.csv -> out/a.csv"};
  EXPECT_EQ(found(options), expected);
  options.nul = true;  // now it is one name, with line ends in it
  EXPECT_EQ(found(options).size(), 1);
}

TEST_F(Inputs, lists_that_are_no_text_are_refused_at_once) {
  InputListOptions options;
  options.list = "/dev/zero";
  EXPECT_NE(refusal(options).find("NUL"), std::string::npos);
  std::ofstream("long") << std::string(100000, 'a');
  options.list = "long";
  EXPECT_NE(refusal(options).find("a name of more than 65536 bytes"), std::string::npos);
}

TEST_F(Inputs, no_output_replaces_an_input) {
  for (const char* path : {"a.csv", "b.csv"}) touch(path);
  fs::create_symlink("../b.csv", "link");
  fs::create_directory("out");
  fs::create_hard_link("b.csv", "out/a.csv");
  InputListOptions options;
  options.files = {"a.csv", "b.csv"};
  options.outputs.folder = "out";
  options.outputs.ending = ".csv";
  EXPECT_EQ(
      refusal(options),
      "a.csv: error: its output out/a.csv would replace an input; expected a different file; give another output");
}

TEST_F(Inputs, no_output_replaces_a_file_that_is_read_besides) {
  for (const char* path : {"a.csv", "times"}) touch(path);
  std::ofstream("list") << "a.csv\n";
  InputListOptions options;
  options.list = "list";
  options.other_inputs = {"times"};
  for (const char* path : {"times", "./list"}) {
    options.outputs.file = path;
    EXPECT_NE(refusal(options).find("would replace an input"), std::string::npos) << path;
  }
}

TEST_F(Inputs, an_output_made_older_is_not_current) {
  for (const char* path : {"a.csv", "out/a.csv"}) touch(path);
  InputListOptions options;
  options.files = {"a.csv"};
  options.update = true;
  options.outputs.folder = "out";
  options.outputs.ending = ".csv";
  EXPECT_TRUE(find_inputs(options).files[0].is_current);
  tcb::system::make_older("out/a.csv", "a.csv");
  EXPECT_FALSE(find_inputs(options).files[0].is_current);
}

}  // namespace
