// Conflicts: each row of the table refuses the options that it is about.
#include "cli/options.hpp"

#include "cli/command_line.hpp"

namespace tcb {
namespace {

using testing::AnyOf;
using testing::HasSubstr;

/// The option with a value that it takes.
std::string word(Option option) {
  const OptionRow& row = row_of(option);
  const std::string name(row.long_name());
  switch (row.kind) {
    case ValueKind::flag: return name;
    case ValueKind::name:
    case ValueKind::names: return name + "=" + std::string(row.known().front());
    case ValueKind::file:
    case ValueKind::folder: return name + "=theirs.csv";
    default: break;
  }
  if (!row.default_value.empty()) return name + "=" + std::string(row.default_value);
  switch (option) {
    case Option::columns:
    case Option::map:
    case Option::rename: return name + "=time=t";
    case Option::delimiter: return name + "=tab";
    case Option::angle: return name + "=x=degrees";
    case Option::rotation_output: return name + "=matrix";
    case Option::tcb: return name + "=0,0,0";
    default: return name + "=1";
  }
}

std::vector<Option> members(const OptionSet& options) {
  std::vector<Option> list;
  for (const OptionRow& row : option_table()) {
    if (options.has(row.id)) list.push_back(row.id);
  }
  return list;
}

void expect_conflict(const std::vector<std::string>& words) {
  try {
    parsed(words);
    ADD_FAILURE() << testing::PrintToString(words);
  } catch (const Error& error) {
    EXPECT_THAT(error.code(), AnyOf(ErrorCode::options_exclude, ErrorCode::option_needs, ErrorCode::option_idle_with,
                                    ErrorCode::option_idle))
        << testing::PrintToString(words);
  }
}

TEST(Conflicts, of_options_that_exclude_each_other_each_pair_is_refused) {
  for (const Conflict& conflict : conflict_table()) {
    if (conflict.relation != Relation::exclude || conflict.applies != nullptr) continue;
    const auto options = members(conflict.options);
    for (const Option option : options) {
      for (const Option other : conflict.others.empty() ? options : members(conflict.others)) {
        if (option != other) expect_conflict({word(option), word(other)});
      }
    }
  }
}

TEST(Conflicts, an_option_without_effect_is_refused) {
  for (const Conflict& conflict : conflict_table()) {
    if (conflict.relation != Relation::idle || conflict.applies != nullptr) continue;
    for (const Option option : members(conflict.options)) {
      for (const Option other : members(conflict.others)) expect_conflict({word(option), word(other)});
    }
  }
}

TEST(Conflicts, an_option_that_needs_another_is_refused_alone) {
  for (const Conflict& conflict : conflict_table()) {
    if (conflict.relation != Relation::need || conflict.applies != nullptr) continue;
    for (const Option option : members(conflict.options)) expect_conflict({"--step=1", word(option)});
  }
}

TEST(Conflicts, have_one_form_of_message) {
  EXPECT_EQ(stepped_refusal({"--arc-count=3"}),
            "--step and --arc-count exclude each other; expected one of them; remove one");
  EXPECT_EQ(stepped_refusal({"--exact-input"}), "--exact-input needs --golden; give both, or neither");
  EXPECT_EQ(refusal({"--at=1", "--keys"}), "--keys has no effect with --at; remove it");
  EXPECT_EQ(stepped_refusal({"--check=a"}),
            "--step has no effect with --check, which takes the samples of its file and prints a report; remove it");
}

TEST(Conflicts, that_depend_on_values_show_them) {
  EXPECT_EQ(stepped_refusal({"--decimal=,", "--delimiter=comma"}),
            "--delimiter comma and --decimal , exclude each other; expected one of them; remove one");
  EXPECT_EQ(stepped_refusal({"-f", "npy", "--fixed", "3"}),
            "--fixed 3 has no effect with --output-format npy, which holds the doubles themselves; remove it");
  EXPECT_EQ(stepped_refusal({"-f", "jsonl", "--hex"}),
            "--hex has no effect with --output-format jsonl, which has no hexadecimal numbers; remove it");
  EXPECT_EQ(stepped_refusal({"--digits", "18"}),
            "--digits 18 needs --golden, as a double has 17 significant digits; give both, or neither");
  EXPECT_EQ(stepped_refusal({"--fields", "time,arc_error", "--golden"}),
            "--golden and --fields time,arc_error exclude each other, as the exact s has no error; expected one of "
            "them; remove one");
}

TEST(Conflicts, of_pictures_are_refused) {
  for (const char* option : {"--fields=time", "--digits=3", "--golden", "--meta", "--no-output-header"}) {
    EXPECT_THAT(stepped_refusal({option, "-f", "svg"}),
                HasSubstr("has no effect with --output-format svg, which draws the curve and has no rows; remove it"));
    EXPECT_THAT(stepped_refusal({option, "--plot"}), HasSubstr("has no effect with --plot, which draws the curve"));
  }
  for (const char* option : {"--axes=x:y", "--title=a", "--size=200x200"}) {
    EXPECT_THAT(stepped_refusal({option}), HasSubstr("has no effect on an output that is not a picture; remove it"));
    EXPECT_EQ(stepped_refusal({option, "-f", "svg"}), "") << option;
  }
  EXPECT_EQ(stepped_refusal({"--plot", "--metric=x,y"}), "");
  EXPECT_THAT(stepped_refusal({"--plot", "-f", "csv"}), HasSubstr("--plot and --output-format exclude each other"));
}

TEST(Conflicts, of_the_format_of_the_input_are_refused) {
  for (const char* option : {"--delimiter=;", "--header", "--no-header", "--comment=%", "--decimal=,"}) {
    EXPECT_THAT(stepped_refusal({option, "-i", "json"}),
                HasSubstr(" has no effect with --input-format json; remove it"));
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
            "--missing skip-cell and --equal-speed exclude each other, as all channels are needed at each key; "
            "expected one of them; remove one");
  EXPECT_THAT(stepped_refusal({"--missing", "skip-cell", "--parameter=0.5"}), HasSubstr("exclude each other"));
  EXPECT_EQ(stepped_refusal({"--missing", "skip-cell", "--parameter=uniform"}), "");
  EXPECT_EQ(stepped_refusal({"--missing", "skip-row", "--equal-speed"}), "");
}

TEST(Conflicts, a_metric_needs_lengths_or_speeds) {
  EXPECT_EQ(stepped_refusal({"--metric=x"}), "--metric x has no effect, as no length or speed is requested; remove it");
  for (const char* use : {"--fields=speed", "--fields=s", "--equal-speed", "--parameter=chordal"}) {
    EXPECT_EQ(stepped_refusal({"--metric=x", use}), "") << use;
  }
  for (const char* use : {"--arc-step=1", "--tolerance=1", "--check=a", "--identify=a"}) {
    EXPECT_EQ(refusal({"--metric=x", use}), "") << use;
  }
}

TEST(Conflicts, a_side_needs_fields_that_may_differ) {
  EXPECT_EQ(stepped_refusal({"--side=left"}),
            "--side left has no effect on these fields, which are the same on both sides; remove it");
  EXPECT_EQ(stepped_refusal({"--side=left", "--fields=velocity"}), "");
  EXPECT_EQ(refusal({"--side=left", "--check=a"}), "") << "the file may have any field";
  EXPECT_NE(refusal({"--side=left", "--check=a", "--fields=time,position"}), "");
}

TEST(Conflicts, an_extrapolation_needs_times_that_may_be_outside) {
  EXPECT_EQ(stepped_refusal({"--extrapolate=hold"}),
            "--extrapolate hold has no effect with --step 1 alone, whose samples are on the curve; remove it");
  EXPECT_EQ(stepped_refusal({"--extrapolate=hold", "--from=-1"}), "");
  EXPECT_EQ(stepped_refusal({"--extrapolate=error"}), "");
  EXPECT_EQ(refusal({"--extrapolate=hold", "--at=1"}), "");
  EXPECT_NE(refusal({"--extrapolate=hold", "--arc-at=1"}), "");
  EXPECT_NE(refusal({"--extrapolate=hold", "--arc-step=1", "--from=1"}), "");
}

}  // namespace
}  // namespace tcb
