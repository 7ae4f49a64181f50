// Provenance options: which options provenance has, and in which words.
#include "cli/command_line.hpp"

namespace tcb {
namespace {

using testing::ElementsAre;

std::vector<std::string> options(std::vector<std::string> words) {
  words.insert(words.begin(), "--meta");
  return job_of(words).meta->meta.options;
}

TEST(ProvenanceOptions, are_those_that_change_bytes_each_as_one_word) {
  EXPECT_THAT(options({"-s", "1/24", "keys.csv", "--from=-1", "--closed", "--period", "9"}),
              ElementsAre("--closed", "--period=9", "--step=1/24", "--from=-1", "--meta"));
}

TEST(ProvenanceOptions, are_not_those_of_files_and_speed) {
  EXPECT_THAT(options({"-n", "3", "-o", "out", "-j", "2", "-q", "--no-progress"}), ElementsAre("--count=3", "--meta"));
  EXPECT_THAT(options({"-n", "3", "--output-dir", "out", "--suffix", "s", "--recursive", "--update", "folder"}),
              ElementsAre("--count=3", "--meta"));
}

TEST(ProvenanceOptions, have_no_line_ends) {
  EXPECT_THAT(stepped_refusal({"--meta", "--group", "a\nb"}), testing::StartsWith("--group: --meta cannot hold"));
}

TEST(ProvenanceOptions, are_there_only_with_their_option) { EXPECT_FALSE(job_of({"-n", "3"}).meta); }

}  // namespace
}  // namespace tcb
