// Pictures of fits: what they show, and what is refused.
#include "fit/fit_job.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>

#include "formats/formats.hpp"
#include "temporary_folder.hpp"

namespace tcb {
namespace {

using testing::HasSubstr;

class FitPicture : public testing::Test {
 protected:
  FitPicture() {
    std::ofstream(path_) << "t,x,y\n0,0,1\n1,2,1\n2,4,1\n3,6,1\n";
    job_.files.files = {path_};
    job_.files.outputs.file = picture_;
    job_.rows.format = find_format("svg");
    job_.options.tolerances = {{"", 0.1}};
    job_.verbosity.quiet = true;
  }
  std::string drawn() const {
    EXPECT_EQ(fit(job_), Exit::done);
    std::ostringstream text;
    text << std::ifstream(picture_).rdbuf();
    return text.str();
  }

  TemporaryFolder folder_;
  std::string path_ = folder_.path("fit_picture.csv"), picture_ = folder_.path("fit_picture.svg");
  FitJob job_;
};

TEST_F(FitPicture, shows_the_recording_the_keys_and_their_differences) {
  const std::string svg = drawn();
  EXPECT_THAT(svg, HasSubstr("4 samples · 2 keys · at least 2 are needed"));
  EXPECT_THAT(svg, HasSubstr(">x, difference<"));
  EXPECT_THAT(svg, HasSubstr(">fit_picture.csv<"));
  EXPECT_THAT(svg, HasSubstr(">keys<"));
}

TEST_F(FitPicture, of_several_files_is_refused) {
  job_.files.files.push_back(path_);
  try {
    fit(job_);
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_THAT(error.message(), HasSubstr("shows one recording"));
  }
}

}  // namespace
}  // namespace tcb
