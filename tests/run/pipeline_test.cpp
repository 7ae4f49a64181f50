// Pipeline: whole runs, from the bytes of files to the bytes of an output or of one for each file.
#include "run/pipeline.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "error.hpp"
#include "formats/formats.hpp"

namespace {

namespace fs = std::filesystem;

/// A folder with two files of keys on the line x = t, which is removed afterwards.
class Pipeline : public testing::Test {
 protected:
  Pipeline() {
    fs::create_directories(folder_);
    for (const char* name : {"a.csv", "b.csv"}) std::ofstream(folder_ / name) << "t,x\n0,0\n2,2\n";
    job_.files.files = {folder_ / "a.csv", folder_ / "b.csv"};
    job_.samples.request.mode = tcb::Mode::count;
    job_.samples.request.count = 3;
    job_.rows.format = tcb::find_format("csv");
    job_.rows.fields = {0, 1};
    job_.keys.rules.ends = tcb::TextSetting{"natural"};
    job_.verbosity.quiet = true;
  }
  ~Pipeline() override { fs::remove_all(folder_); }

  tcb::Exit run() const { return tcb::resample(job_); }
  static std::string text_of(const fs::path& path) {
    std::ifstream file(path);
    return {std::istreambuf_iterator<char>(file), {}};
  }

  const fs::path folder_ = fs::temp_directory_path() / ("pipeline_test." + std::to_string(getpid()));
  tcb::ResampleJob job_;
};

TEST_F(Pipeline, files_share_an_output_and_its_header) {
  job_.files.outputs.file = folder_ / "all.csv";
  EXPECT_EQ(run(), tcb::Exit::done);
  EXPECT_EQ(text_of(job_.files.outputs.file), "t,x\n0,0\n1,1\n2,2\n\n0,0\n1,1\n2,2\n");
}

TEST_F(Pipeline, a_file_that_fails_has_no_output_and_the_others_do) {
  std::ofstream(folder_ / "a.csv") << "t,x\n0,0\n0,2\n";
  job_.files.outputs.folder = folder_ / "out";
  job_.files.outputs.ending = ".csv";
  testing::internal::CaptureStderr();
  EXPECT_EQ(run(), tcb::Exit::data);
  EXPECT_NE(testing::internal::GetCapturedStderr().find("a.csv:3"), std::string::npos);
  EXPECT_FALSE(fs::exists(folder_ / "out/a.csv"));
  EXPECT_EQ(text_of(folder_ / "out/b.csv"), "t,x\n0,0\n1,1\n2,2\n");
}

TEST_F(Pipeline, an_error_of_the_only_file_is_the_error_of_the_run) {
  job_.files.files = {folder_ / "none.csv"};
  job_.files.outputs.folder = folder_ / "out";
  job_.files.outputs.ending = ".csv";
  EXPECT_THROW(run(), tcb::Error);
}

}  // namespace
