// Provenance on the command line: which options are said, and in which words.
#include <gmock/gmock.h>

#include "cli/options.hpp"
#include "error.hpp"

namespace tcb {
namespace {

using testing::ElementsAre;

std::vector<std::string> options(std::vector<const char*> arguments) {
  arguments.insert(arguments.begin(), {"tcbsample", "--meta"});
  return parse(static_cast<int>(arguments.size()), arguments.data()).plan.meta->meta.options;
}

TEST(Provenance, has_the_options_that_make_bytes_each_as_a_word) {
  EXPECT_THAT(options({"-s", "1/24", "keys.csv", "--from=-1", "--closed", "--period", "9"}),
              ElementsAre("--closed", "--period=9", "--step=1/24", "--from=-1", "--meta"));
}

TEST(Provenance, has_no_options_that_say_where_or_how_fast) {
  EXPECT_THAT(options({"-n", "3", "-o", "out", "-j", "2", "-q", "--no-progress"}), ElementsAre("--count=3", "--meta"));
  EXPECT_THAT(options({"-n", "3", "--output-dir", "out", "--suffix", "s", "--recursive", "--update", "folder"}),
              ElementsAre("--count=3", "--meta"));
}

TEST(Provenance, is_not_there_unless_asked_for) {
  const char* const arguments[] = {"tcbsample", "-n", "3"};
  EXPECT_FALSE(parse(3, arguments).plan.meta);
}

}  // namespace
}  // namespace tcb
