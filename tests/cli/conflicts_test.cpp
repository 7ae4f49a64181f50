// Conflicts: options that exclude each other, need another, or have no effect are refused, and no others.
#include "cli/options.hpp"

#include "cli/command_line.hpp"

namespace tcb {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

using Words = std::vector<std::string>;

const Words modes{"--step=1",      "--rate=1",   "--count=2",     "--per-segment=1", "--at=1", "--arc-step=1",
                  "--arc-count=2", "--arc-at=1", "--tolerance=1", "--emit=poly",     "--fit=1"};

std::string name_of(const std::string& word) { return word.substr(0, word.find('=')); }

/// Expects that each of `options` has no effect with each of `others`.
void expect_no_effect(const Words& options, const Words& others, const Words& further = {}) {
  for (const std::string& option : options) {
    for (const std::string& other : others) {
      Words words{option, other};
      words.insert(words.end(), further.begin(), further.end());
      EXPECT_THAT(refusal(words), StartsWith(name_of(option) + " has no effect with " + name_of(other)));
    }
  }
}

TEST(Conflicts, of_two_sampling_options_each_pair_is_refused) {
  for (std::size_t i = 0; i < modes.size(); ++i) {
    for (std::size_t j = i + 1; j < modes.size(); ++j) {
      EXPECT_THAT(refusal({modes[j], modes[i]}),
                  StartsWith(name_of(modes[i]) + " and " + name_of(modes[j]) + " cannot be combined; "));
    }
  }
}

TEST(Conflicts, options_that_exclude_each_other_are_refused) {
  for (const auto& [option, other] :
       std::vector<std::pair<std::string, std::string>>{{"--output=a", "--output-dir=b"},
                                                        {"--header", "--no-header"},
                                                        {"--time-unit=ms", "--input-fps=24"},
                                                        {"--digits=3", "--fixed=3"},
                                                        {"--digits=3", "--hex"},
                                                        {"--fixed=3", "--hex"},
                                                        {"--output-format=svg", "--plot"}}) {
    EXPECT_THAT(stepped_refusal({other, option}),
                StartsWith(name_of(option) + " and " + name_of(other) + " cannot be combined; "));
  }
  EXPECT_THAT(refusal({"--identify=a", "--check=a"}), StartsWith("--check and --identify "));
  for (const char* other : {"--plot", "--explain"})
    EXPECT_THAT(refusal({"--fit=1", other}), HasSubstr("cannot be combined"));
}

TEST(Conflicts, options_without_effect_on_the_samples_are_refused) {
  expect_no_effect({"--from=1", "--to=1"}, {"--per-segment=1", "--at=1", "--arc-at=1", "--tolerance=1"});
  expect_no_effect({"--end=drop"}, {"--count=2", "--per-segment=1", "--at=1", "--arc-count=2", "--arc-at=1",
                                    "--tolerance=1", "--emit=poly"});
  expect_no_effect({"--keys"}, {"--per-segment=1", "--at=1", "--arc-at=1", "--emit=poly"});
}

TEST(Conflicts, options_about_rows_have_no_effect_on_a_report) {
  const Words reports{"--check=a", "--identify=a"};
  expect_no_effect(modes, {"--identify=a"});
  expect_no_effect({"--emit=poly", "--fit=1"}, {"--check=a"});
  for (const char* place : {"--step=1", "--count=2", "--at=1", "--arc-count=3", "--tolerance=1"}) {
    EXPECT_EQ(refusal({"--check=a", place}), "") << "the rows that are expected";
  }
  EXPECT_EQ(refusal({"--check=a", "--step=1", "--from=1", "--to=2", "--end=keep", "--keys", "--max-rows=9"}), "");
  expect_no_effect({"--from=1", "--to=1", "--end=drop", "--keys", "--max-rows=1"}, {"--identify=a"});
  EXPECT_THAT(refusal({"--check=a", "--to=1"}), StartsWith("--to 1 has no effect with --check a, which takes"));
  expect_no_effect({"--meta", "--output-dir=a", "--files=a", "--explain", "--digits=3", "--fixed=3", "--golden",
                    "--exact-input", "--hex", "--no-output-header", "--file-column", "--time-format=clock"},
                   reports);
  expect_no_effect({"--preset=vtk", "--tangents=uniform", "--ends=half", "--equal-speed", "--side=left"},
                   {"--identify=a"});
}

TEST(Conflicts, options_about_curves_and_rows_have_no_effect_on_a_fit) {
  expect_no_effect({"--tcb=0,0,0",
                    "--tcb-scale=none",
                    "--rotation-output=matrix",
                    "--preset=vtk",
                    "--tangents=uniform",
                    "--ends=half",
                    "--closed",
                    "--period=1",
                    "--equal-speed",
                    "--parameter=chordal",
                    "--rotation-curve=slerp",
                    "--no-ease",
                    "--extrapolate=hold",
                    "--from=1",
                    "--to=1",
                    "--end=drop",
                    "--keys",
                    "--max-rows=1",
                    "--fields=time",
                    "--side=left",
                    "--golden",
                    "--exact-input",
                    "--rename=a=b",
                    "--digits=3",
                    "--fixed=3"},
                   {"--fit=1"});
  expect_no_effect({"--meta"}, {"--explain"}, {"--step=1"});
}

TEST(Conflicts, an_option_that_needs_another_is_refused_alone) {
  for (const auto& [option, other] :
       std::vector<std::pair<std::string, std::string>>{{"--recursive", "--output-dir"},
                                                        {"--suffix=a", "--output-dir"},
                                                        {"--update", "--output-dir"},
                                                        {"--null", "--files"},
                                                        {"--abs=1", "--check"},
                                                        {"--rel=1", "--check"},
                                                        {"--ulp=1", "--check"},
                                                        {"--map=a=b", "--check"},
                                                        {"--angles=degrees", "--rotation"},
                                                        {"--fit-keys=tcb", "--fit"},
                                                        {"--keep-times=1", "--fit"},
                                                        {"--corner=30", "--fit"},
                                                        {"--exact-input", "--golden"}}) {
    EXPECT_THAT(stepped_refusal({option}), StartsWith(name_of(option) + " needs " + other));
  }
}

TEST(Conflicts, have_one_form_of_message) {
  EXPECT_EQ(stepped_refusal({"--arc-count=3"}),
            "--step and --arc-count cannot be combined; expected only one; remove the other");
  EXPECT_EQ(stepped_refusal({"--exact-input"}), "--exact-input needs --golden; give both, or neither");
}

TEST(Conflicts, that_depend_on_values_show_them) {
  EXPECT_EQ(stepped_refusal({"--decimal=,", "--delimiter=comma"}),
            "--delimiter comma and --decimal , cannot be combined; expected only one; remove the other");
  EXPECT_EQ(stepped_refusal({"-f", "npy", "--fixed", "3"}),
            "--fixed 3 has no effect with --output-format npy, which holds the doubles themselves; remove --fixed 3");
  EXPECT_EQ(stepped_refusal({"-f", "jsonl", "--hex"}),
            "--hex has no effect with --output-format jsonl, which has no hexadecimal numbers; remove --hex");
  EXPECT_EQ(stepped_refusal({"--digits", "18"}),
            "--digits 18 needs --golden, as a double has 17 significant digits; give both, or neither");
  EXPECT_EQ(stepped_refusal({"--fields", "time,arc_error", "--golden"}),
            "--golden and --fields time,arc_error cannot be combined, as the exact s has no error; expected only one; "
            "remove the other");
}

TEST(Conflicts, of_pictures_are_refused) {
  for (const char* option : {"--fields=time", "--digits=3", "--golden", "--meta", "--no-output-header"}) {
    EXPECT_THAT(stepped_refusal({option, "-f", "svg"}), HasSubstr("has no effect with --output-format svg"));
    EXPECT_THAT(stepped_refusal({option, "--plot"}), HasSubstr("has no effect with --plot"));
  }
  for (const char* option : {"--axes=x:y", "--title=a", "--size=200x200"}) {
    EXPECT_THAT(stepped_refusal({option}), HasSubstr("has no effect on an output"));
    EXPECT_EQ(stepped_refusal({option, "-f", "svg"}), "") << option;
  }
  EXPECT_EQ(stepped_refusal({"--plot", "--metric=x,y"}), "");
  EXPECT_THAT(stepped_refusal({"--plot", "-f", "csv"}), HasSubstr("--output-format and --plot cannot be combined"));
}

TEST(Conflicts, of_the_format_of_the_input_are_refused) {
  for (const char* option : {"--delimiter=;", "--header", "--no-header", "--comment=%", "--decimal=,"}) {
    EXPECT_THAT(stepped_refusal({option, "-i", "json"}), HasSubstr(" has no effect with --input-format json; remove "));
    EXPECT_EQ(stepped_refusal({option, "-i", "csv"}), "") << option;
  }
}

TEST(Conflicts, of_the_format_of_the_output_are_refused) {
  EXPECT_THAT(stepped_refusal({"--no-output-header", "-f", "json"}), HasSubstr("which has no line of names"));
  EXPECT_THAT(stepped_refusal({"--meta", "-f", "npy"}), HasSubstr("which has no comments"));
  EXPECT_EQ(stepped_refusal({"--meta", "-f", "json"}), "");
  EXPECT_THAT(refusal({"--check", "a", "-f", "tsv"}), HasSubstr("--output-format tsv has no effect"));
  EXPECT_EQ(refusal({"--check", "a", "-f", "json"}), "");
}

TEST(Conflicts, missing_cells_exclude_what_needs_all_channels) {
  EXPECT_EQ(stepped_refusal({"--missing", "skip-cell", "--equal-speed"}),
            "--missing skip-cell and --equal-speed cannot be combined, as all channels are needed at each key; "
            "expected only one; remove the other");
  EXPECT_THAT(stepped_refusal({"--missing", "skip-cell", "--parameter=0.5"}), HasSubstr("cannot be combined"));
  EXPECT_EQ(stepped_refusal({"--missing", "skip-cell", "--parameter=uniform"}), "");
  EXPECT_EQ(stepped_refusal({"--missing", "skip-row", "--equal-speed"}), "");
}

TEST(Conflicts, a_metric_needs_lengths_or_speeds) {
  EXPECT_THAT(stepped_refusal({"--metric=x"}), StartsWith("--metric x has no effect"));
  for (const char* use : {"--fields=speed", "--fields=s", "--equal-speed", "--parameter=chordal"}) {
    EXPECT_EQ(stepped_refusal({"--metric=x", use}), "") << use;
  }
  for (const char* use : {"--arc-step=1", "--tolerance=1", "--check=a", "--identify=a"}) {
    EXPECT_EQ(refusal({"--metric=x", use}), "") << use;
  }
}

TEST(Conflicts, a_side_needs_fields_that_may_differ) {
  EXPECT_THAT(stepped_refusal({"--side=left"}), StartsWith("--side left has no effect"));
  EXPECT_EQ(stepped_refusal({"--side=left", "--fields=velocity"}), "");
  EXPECT_EQ(refusal({"--side=left", "--check=a"}), "") << "the file may have any field";
  EXPECT_NE(refusal({"--side=left", "--check=a", "--fields=time,position"}), "");
}

TEST(Conflicts, an_extrapolation_needs_times_that_may_be_outside) {
  EXPECT_THAT(stepped_refusal({"--extrapolate=hold"}), StartsWith("--extrapolate hold has no effect"));
  EXPECT_EQ(stepped_refusal({"--extrapolate=hold", "--from=-1"}), "");
  EXPECT_EQ(stepped_refusal({"--extrapolate=error"}), "");
  EXPECT_EQ(refusal({"--extrapolate=hold", "--at=1"}), "");
  EXPECT_NE(refusal({"--extrapolate=hold", "--arc-at=1"}), "");
  EXPECT_NE(refusal({"--extrapolate=hold", "--arc-step=1", "--from=1"}), "");
}

}  // namespace
}  // namespace tcb
