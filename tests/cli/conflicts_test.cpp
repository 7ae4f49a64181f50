// Conflicts: what the error says, and which values of options are no conflict. effects.py finds options without effect.
#include "cli/options.hpp"

#include "cli/command_line.hpp"

namespace tcb {
namespace {

using testing::StartsWith;

/// Expects that of these options each pair cannot be combined.
void expect_exclusive(const std::vector<std::string>& options) {
  for (std::size_t i = 0; i < options.size(); ++i) {
    for (std::size_t j = i + 1; j < options.size(); ++j) {
      const std::string first = options[i].substr(0, options[i].find('='));
      EXPECT_THAT(refusal({options[j], options[i]}), StartsWith(first + " and ")) << options[j];
    }
  }
}

TEST(Conflicts, of_options_that_exclude_each_other_each_pair_is_refused) {
  expect_exclusive({"--step=1", "--rate=1", "--count=2", "--per-segment=1", "--at=1", "--arc-step=1", "--arc-count=2",
                    "--arc-at=1", "--tolerance=1"});
  expect_exclusive({"--output=a", "--output-dir=b"});
  expect_exclusive({"--header", "--no-header"});
  expect_exclusive({"--time-unit=ms", "--input-fps=24"});
}

struct Refused {
  const char *words, *message;  ///< the words follow --step=1
};

constexpr Refused refused[] = {
    {"--arc-count=3", "--step and --arc-count cannot be combined; expected only one; remove the other"},
    {"--exact-input", "--exact-input needs --golden; give both, or neither"},
    {"--map a=b", "--map needs --check or --identify; give one of them as well, or neither"},
    {"--null", "--null needs --files; give both, or neither"},
    {"--fit-keys tcb", "--fit-keys needs --fit; give both, or neither"},
    {"--retime", "--retime needs --limits; give both, or neither"},
    {"--update", "--update needs --output-dir, an output for each file; give both, or neither"},
    {"--decimal=, --delimiter=comma",
     "--delimiter comma and --decimal , cannot be combined; expected only one; remove the other"},
    {"-f npy --fixed 3",
     "--fixed 3 has no effect with --output-format npy, whose numbers are not text; remove --fixed 3"},
    {"-f jsonl --hex", "--hex has no effect with --output-format jsonl, which is not delimited text; remove --hex"},
    {"--title T", "--title T has no effect on csv, which is no picture; remove --title T"},
    {"--plot --title T --digits 3",
     "--digits has no effect with --plot, which draws the curve and has no rows; remove --digits"},
    {"--output-format csv --plot",
     "--output-format and --plot cannot be combined; expected only one; remove the other"},
    {"--digits 3 --hex", "--digits and --hex cannot be combined; expected only one; remove the other"},
    {"--digits 18", "--digits 18 needs --golden, as a double has 17 significant digits; give both, or neither"},
    {"--fields time,arc_error --golden",
     "--golden and --fields time,arc_error cannot be combined, as the exact s has no error; expected only one; remove "
     "the other"},
    {"--missing skip-cell --equal-speed",
     "--missing skip-cell and --equal-speed cannot be combined, as all channels are needed at each key; expected only "
     "one; remove the other"},
    {"--metric x", "--metric x has no effect, as no length or speed is requested; remove it"},
    {"--side left", "--side left has no effect on these fields, which are the same on both sides; remove it"},
    {"--extrapolate hold",
     "--extrapolate hold has no effect with --step 1 alone, whose samples are on the curve; remove --extrapolate hold"},
    {"--check a -f tsv",
     "--output-format tsv has no effect with --check a, whose report is text, json or svg; remove --output-format tsv"},
    {"--check a --meta",
     "--meta has no effect with --check, which takes the samples of its file and prints a report; remove --meta"},
    {"--explain --from 1 --digits 3", "--digits has no effect with --explain, which prints no rows; remove --digits"},
};

TEST(Conflicts, have_messages_that_show_what_decides) {
  for (const auto& [words, message] : refused) {
    std::vector<std::string> all;
    for (const std::string_view word : split(words, ' ')) all.emplace_back(word);
    EXPECT_EQ(stepped_refusal(all), message) << words;
  }
  EXPECT_EQ(refusal({"--plot", "--end=keep"}),
            "--end has no effect with --plot, as no samples are requested; remove --end");
}

TEST(Conflicts, are_none_where_other_values_or_options_give_an_effect) {
  for (const char* words :
       {"--plot --metric=x,y", "--plot --title=T", "--meta -f json", "--missing skip-cell --parameter=uniform",
        "--missing skip-row --equal-speed", "--metric=x --fields=speed", "--metric=x --fields=s",
        "--metric=x --equal-speed", "--metric=x --parameter=chordal", "--metric=x --check=a", "--side=left --check=a",
        "--side=left --fields=velocity", "--extrapolate=hold --from=-1", "--extrapolate=error", "--check=a -f json",
        "--check=a --from=1 --to=2 --end=keep --keys --max-rows=9", "--explain --no-output-header",
        "--explain --recursive"}) {
    std::vector<std::string> all;
    for (const std::string_view word : split(words, ' ')) all.emplace_back(word);
    EXPECT_EQ(stepped_refusal(all), "") << words;
  }
  EXPECT_EQ(refusal({"--metric=x", "--arc-step=1"}), "");
  EXPECT_EQ(refusal({"--extrapolate=hold", "--at=1"}), "");
  EXPECT_NE(refusal({"--extrapolate=hold", "--arc-at=1"}), "");
}

}  // namespace
}  // namespace tcb
