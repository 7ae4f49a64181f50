// Plan: the jobs that options make, and the errors of options that do not fit each other.
#include "cli/plan.hpp"

#include "cli/command_line.hpp"
#include "sample/fields.hpp"
#include "schema/columns.hpp"

namespace tcb {

namespace {

using testing::ElementsAre;

TEST(Plan, without_options_but_a_step_all_is_default) {
  const Job job = job_of({"--step", "0.1"});
  EXPECT_THAT(job.files, ElementsAre("-"));
  EXPECT_EQ(job.sampling.mode, Mode::step);
  EXPECT_EQ(job.sampling.step, Rational(1, 10)) << "a decimal is exact";
  EXPECT_FALSE(job.sampling.from || job.sampling.to);
  EXPECT_TRUE(job.sampling.from_left) << "no field differs between the sides of a key";
  EXPECT_THAT(job.fields, ElementsAre(0, 1));
  EXPECT_EQ(job.output_format, FormatId::csv);
  EXPECT_FALSE(job.output_header || job.output_folder || job.comparison || job.golden || job.meta);
  EXPECT_EQ(job.output, "-");
  EXPECT_FALSE(job.input.format || job.input.delimiter || job.input.header);
  EXPECT_EQ(job.input.comment, "#");
  EXPECT_EQ(job.input.decimal, '.');
  EXPECT_EQ(job.input.missing, Missing::error);
  EXPECT_EQ(job.input.tcb, spline::Tcb<double>{});
  EXPECT_EQ(job.curves.duplicates, Duplicates::error);
  EXPECT_FALSE(job.curves.sort);
}

TEST(Plan, each_sampling_option_has_its_mode_and_value) {
  const auto sampling = [](const char* option, const char* value) { return job_of({option, value}).sampling; };
  EXPECT_EQ(sampling("--step", "1001/30000").step, Rational(1001, 30000));
  EXPECT_EQ(sampling("--rate", "30000/1001").step, Rational(1001, 30000)) << "exactly 1/HZ";
  EXPECT_EQ(sampling("--rate", "24").mode, Mode::step);
  EXPECT_EQ(sampling("--count", "200").mode, Mode::count);
  EXPECT_EQ(sampling("--count", "200").count, 200U);
  EXPECT_EQ(sampling("--segments", "7").mode, Mode::segments);
  EXPECT_EQ(sampling("--segments", "7").count, 7U);
  EXPECT_EQ(sampling("--per-segment", "7").mode, Mode::per_segment);
  EXPECT_EQ(sampling("--at", "0,1/2").mode, Mode::at);
  EXPECT_THAT(sampling("--at", "0,1/2").places, ElementsAre(Rational(0), Rational(1, 2)));
  EXPECT_EQ(sampling("--arc-step", "2.5").mode, Mode::arc_step);
  EXPECT_EQ(sampling("--arc-step", "2.5").step, Rational(5, 2));
  EXPECT_EQ(sampling("--arc-count", "3").mode, Mode::arc_count);
  EXPECT_EQ(sampling("--arc-at", "3").mode, Mode::arc_at);
  EXPECT_EQ(sampling("--tolerance", "0.5").mode, Mode::tolerance);
  EXPECT_EQ(sampling("--tolerance", "0.5").tolerance.distance, 0.5);
  EXPECT_EQ(sampling("--emit", "poly").mode, Mode::emit);
}

TEST(Plan, rows_of_pieces_have_start_duration_the_form_and_further_fields) {
  const auto names = [](const std::vector<std::string>& words) {
    std::vector<std::string_view> found;
    for (const std::size_t field : job_of(words).fields) found.push_back(fields()[field].name);
    return found;
  };
  EXPECT_THAT(names({"--emit", "bezier"}), ElementsAre("start", "duration", "bezier"));
  EXPECT_THAT(names({"--emit", "poly8", "--fields", "length,s"}),
              ElementsAre("start", "duration", "poly8", "length", "s"));
}

TEST(Plan, a_sampling_option_is_needed) {
  EXPECT_EQ(refusal({"a.csv"}),
            "there is no sampling option; expected one of --step, --rate, --count, --segments, --per-segment, --at, "
            "--arc-step, --arc-count, --arc-at, --tolerance, --emit, --fit; for example tcbsample --step 0.1 keys.csv");
}

TEST(Plan, the_range_is_exact_and_goes_forward) {
  const Job job = stepped({"--from", "-7/24", "--to", "0.1"});
  EXPECT_EQ(job.sampling.from, Rational(-7, 24));
  EXPECT_EQ(job.sampling.to, Rational(1, 10));
  EXPECT_EQ(stepped_refusal({"--from", "-7/24", "--to", "-1"}),
            "--to -1 is before --from -7/24; expected a later end; swap the two");
  EXPECT_EQ(stepped_refusal({"--from", "1", "--to", "1"}), "") << "a single time is a range";
}

TEST(Plan, options_about_the_input_have_their_meaning) {
  EXPECT_EQ(stepped({"-i", "jsonl"}).input.format, FormatId::jsonl);
  EXPECT_EQ(stepped({"--comment", "//"}).input.comment, "//");
  EXPECT_EQ(stepped({"--comment", "none"}).input.comment, "");
  EXPECT_EQ(stepped({"--header"}).input.header, true);
  EXPECT_EQ(stepped({"--no-header"}).input.header, false);
  EXPECT_EQ(stepped({"--decimal", ","}).input.decimal, ',');
  EXPECT_EQ(stepped({"--missing", "skip-cell"}).input.missing, Missing::skip_cell);
  EXPECT_EQ(stepped({"--duplicates", "break"}).curves.duplicates, Duplicates::break_curve);
  EXPECT_TRUE(stepped({"--parameter", "chordal"}).input.timeless);
}

TEST(Plan, groups_come_after_the_columns_whatever_their_order) {
  for (const auto& words : {std::vector<std::string>{"--group", "id,take", "--columns", "carry=label"},
                            std::vector<std::string>{"--columns", "carry=label", "--group", "id,take"}}) {
    const auto roles = stepped(words).input.roles;
    ASSERT_EQ(roles.size(), 2U);
    EXPECT_EQ(roles[0].role, Role::carry);
    EXPECT_EQ(roles[1].role, Role::group);
    EXPECT_THAT(roles[1].columns, ElementsAre("id", "take"));
  }
}

TEST(Plan, notations_have_their_count) {
  using Kind = Notation::Kind;
  EXPECT_EQ(stepped({"--digits", "17"}).notation.kind, Kind::digits);
  EXPECT_EQ(stepped({"--digits", "17"}).notation.count, 17);
  EXPECT_EQ(stepped({"--fixed", "0"}).notation.kind, Kind::fixed);
  EXPECT_EQ(stepped({"--hex"}).notation.kind, Kind::hex);
  EXPECT_EQ(stepped({}).notation.kind, Kind::shortest);
}

TEST(Plan, golden_rows_take_more_digits_and_exact_input) {
  const Job job = stepped({"--golden", "--exact-input", "--digits", "100"});
  ASSERT_TRUE(job.golden.has_value());
  EXPECT_TRUE(job.golden->decimal && job.input.keeps_decimals);
  EXPECT_EQ(job.golden->notation.count, 100);
  EXPECT_FALSE(stepped({"--golden"}).golden->decimal);
}

TEST(Plan, the_output_goes_to_one_place) {
  EXPECT_EQ(stepped({"-o", "out.csv"}).output, "out.csv");
  const Job job = stepped({"--output-dir", "out", "a.csv", "b.csv"});
  EXPECT_EQ(job.output_folder, "out");
  EXPECT_THAT(job.files, ElementsAre("a.csv", "b.csv"));
  EXPECT_EQ(stepped({"--no-output-header"}).output_header, false);
}

TEST(Plan, standard_input_is_read_once) {
  EXPECT_EQ(
      stepped_refusal({"--files", "-", "-"}),
      "--files: the file is standard input, and so are the keys; expected standard input once; give a file name for "
      "one of them");
  EXPECT_EQ(stepped_refusal({"--files", "-", "a.csv"}), "");
  EXPECT_NE(refusal({"--check", "-"}), "");
  EXPECT_NE(refusal({"--identify", "-", "-"}), "");
  EXPECT_EQ(refusal({"--check", "-", "a.csv"}), "");
}

TEST(Plan, a_comparison_has_its_file_and_all_columns_unless_fields_are_given) {
  const Job check = job_of({"--check", "theirs.csv", "keys.csv"});
  ASSERT_TRUE(check.comparison);
  EXPECT_FALSE(check.comparison->identify);
  EXPECT_EQ(check.comparison->file, "theirs.csv");
  EXPECT_TRUE(check.fields.empty());
  EXPECT_FALSE(check.sampling.from_left);
  EXPECT_TRUE(job_of({"--identify", "theirs.csv"}).comparison->identify);
  EXPECT_EQ(job_of({"--check", "theirs.csv", "--fields", "position"}).fields.size(), 1U);
  EXPECT_TRUE(job_of({"--check", "theirs.csv", "--side", "left"}).sampling.from_left);
}

TEST(Plan, a_comparison_is_with_one_file_of_keys) {
  EXPECT_EQ(refusal({"--check", "a", "b", "c"}), "--check: there are 2 files of keys; expected one; remove the others");
}

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
  EXPECT_THAT(stepped_refusal({"--meta", "--group", "a\nb"}), testing::StartsWith("--group: the value has a line end"));
}

TEST(ProvenanceOptions, are_there_only_with_their_option) { EXPECT_FALSE(job_of({"-n", "3"}).meta); }

}  // namespace

TEST(Plan, a_plot_has_samples_of_its_own) {
  const Job job = job_of({"--plot"});
  EXPECT_EQ(job.output_format, FormatId::svg);
  EXPECT_EQ(job.sampling.mode, Mode::segments);
  EXPECT_EQ(job.sampling.count, 50U);
  EXPECT_EQ(job_of({"--plot", "--count=7"}).sampling.mode, Mode::count);
  EXPECT_THAT(refusal({"-f", "svg"}), testing::HasSubstr("--step"));
}

}  // namespace tcb
