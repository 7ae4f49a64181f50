// Plan: the jobs that options make, and the errors of options that do not fit each other.
#include "cli/plan.hpp"

#include "cli/command_line.hpp"
#include "fit/fit.hpp"
#include "formats/formats.hpp"
#include "sample/fields.hpp"
#include "schema/columns.hpp"

namespace tcb {

namespace {

using testing::ElementsAre;

TEST(Plan, without_options_but_a_step_all_is_default) {
  const ResampleJob job = job_of({"--step", "0.1"});
  EXPECT_THAT(job.files.files, ElementsAre("-"));
  EXPECT_EQ(job.samples.request.mode, Mode::step);
  EXPECT_EQ(job.samples.request.step, Rational(1, 10)) << "a decimal is exact";
  EXPECT_FALSE(job.samples.request.from || job.samples.request.to);
  EXPECT_TRUE(job.samples.request.from_left) << "no field differs between the sides of a key";
  EXPECT_THAT(job.rows.fields, ElementsAre(0, 1));
  EXPECT_EQ(job.rows.format, find_format("csv"));
  EXPECT_FALSE(job.rows.header || job.files.outputs.folder || job.golden || job.rows.provenance);
  EXPECT_EQ(job.files.outputs.file, "-");
  EXPECT_FALSE(job.keys.input.format || job.keys.input.delimited.delimiter || job.keys.input.delimited.header);
  EXPECT_EQ(job.keys.input.delimited.comment, "#");
  EXPECT_EQ(job.keys.input.delimited.marks.decimal, '.');
  EXPECT_EQ(job.keys.input.keys.missing, Missing::error);
  EXPECT_FALSE(job.keys.input.keys.tcb);
  EXPECT_EQ(job.keys.curves.duplicates, Duplicates::error);
  EXPECT_FALSE(job.keys.curves.sort);
}

TEST(Plan, each_sampling_option_has_its_mode_and_value) {
  const auto sampling = [](const char* option, const char* value) { return job_of({option, value}).samples.request; };
  EXPECT_EQ(sampling("--step", "1001/30000").step, Rational(1001, 30000));
  EXPECT_EQ(sampling("--rate", "30000/1001").step, Rational(1001, 30000)) << "exactly 1/HZ";
  EXPECT_EQ(sampling("--rate", "24").mode, Mode::step);
  EXPECT_EQ(sampling("--count", "200").mode, Mode::count);
  EXPECT_EQ(sampling("--count", "200").count, 200U);
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
    for (const std::size_t field : job_of(words).rows.fields) found.push_back(fields()[field].name);
    return found;
  };
  EXPECT_THAT(names({"--emit", "bezier"}), ElementsAre("start", "duration", "bezier"));
  EXPECT_THAT(names({"--emit", "poly", "--fields", "length,s"}),
              ElementsAre("start", "duration", "poly", "length", "s"));
}

TEST(Plan, the_range_is_exact_and_goes_forward) {
  const ResampleJob job = stepped({"--from", "-7/24", "--to", "0.1"});
  EXPECT_EQ(job.samples.request.from, Rational(-7, 24));
  EXPECT_EQ(job.samples.request.to, Rational(1, 10));
  EXPECT_EQ(stepped_refusal({"--from", "-7/24", "--to", "-1"}),
            "--to -1 is before --from -7/24; expected a later end; swap the two");
  EXPECT_EQ(stepped_refusal({"--from", "1", "--to", "1"}), "") << "a single time is a range";
}

TEST(Plan, groups_come_after_the_columns_whatever_their_order) {
  for (const auto& words : {std::vector<std::string>{"--group", "id,take", "--columns", "carry=label"},
                            std::vector<std::string>{"--columns", "carry=label", "--group", "id,take"}}) {
    const auto roles = stepped(words).keys.input.columns.roles;
    ASSERT_EQ(roles.size(), 2U);
    EXPECT_EQ(roles[0].role, Role::carry);
    EXPECT_EQ(roles[1].role, Role::group);
    EXPECT_THAT(roles[1].columns, ElementsAre("id", "take"));
  }
}

TEST(Plan, golden_rows_take_more_digits_and_exact_input) {
  const ResampleJob job = stepped({"--golden", "--exact-input", "--digits", "100"});
  ASSERT_TRUE(job.golden.has_value());
  EXPECT_TRUE(job.golden->decimal && job.keys.input.keys.keeps_decimals);
  EXPECT_EQ(job.golden->notation.count, 100);
  EXPECT_FALSE(stepped({"--golden"}).golden->decimal);
}

TEST(Plan, standard_input_is_read_once) {
  EXPECT_NE(stepped_refusal({"--files", "-", "-"}), "");
  EXPECT_EQ(stepped_refusal({"--files", "-", "a.csv"}), "");
  EXPECT_NE(refusal({"--check", "-"}), "");
  EXPECT_NE(refusal({"--identify", "-", "-"}), "");
  EXPECT_EQ(refusal({"--check", "-", "a.csv"}), "");
}

TEST(Plan, a_comparison_has_its_file_and_all_columns_unless_fields_are_given) {
  const auto check = job_of<CompareJob>({"--check", "theirs.csv", "keys.csv"});
  EXPECT_FALSE(check.identify);
  EXPECT_EQ(check.comparison.keys_file, "keys.csv");
  EXPECT_EQ(check.comparison.file, "theirs.csv");
  EXPECT_TRUE(check.comparison.fields.empty());
  EXPECT_FALSE(check.comparison.from_left);
  EXPECT_TRUE(job_of<CompareJob>({"--identify", "theirs.csv"}).identify);
  const auto of = [](const std::vector<std::string>& words) { return job_of<CompareJob>(words).comparison; };
  EXPECT_EQ(of({"--check", "theirs.csv", "--fields", "position"}).fields.size(), 1U);
  EXPECT_TRUE(of({"--check", "theirs.csv", "--side", "left"}).from_left);
}

TEST(Plan, each_product_has_a_job_of_its_own) {
  EXPECT_EQ(job_of<ExplainJob>({"--plot", "--explain"}).format, find_format("svg"));
  EXPECT_EQ(job_of<FitJob>({"--fit", "0.1", "-f", "svg"}).rows.format, find_format("svg"));
  const auto fit = job_of<FitJob>({"--fit", "0.1,x=2", "--keep-times", "1,2", "--fit-keys", "hermite"});
  EXPECT_EQ(fit.options.tolerances.size(), 2U);
  EXPECT_THAT(fit.options.kept_times, ElementsAre(Rational(1), Rational(2)));
  EXPECT_EQ(fit.options.keys, FitKeys::hermite);
}

std::vector<std::string> command(std::vector<std::string> words) {
  words.insert(words.begin(), "--meta");
  return job_of(words).rows.provenance->command;
}

TEST(CommandOfProvenance, has_the_options_that_change_bytes_each_as_one_word) {
  EXPECT_THAT(command({"-s", "1/24", "keys.csv", "--from=-1", "--closed", "--period", "9"}),
              ElementsAre("tcbsample", "--closed=yes", "--period=9", "--step=1/24", "--from=-1", "--meta"));
  EXPECT_THAT(command({"-n", "3", "-o", "out", "-j", "2", "-q", "--color=never", "--files=list"}),
              ElementsAre("tcbsample", "--files=list", "--count=3", "--meta"));
  EXPECT_THAT(command({"-n", "3", "--output-dir", "out", "--suffix", "s", "--recursive", "--update", "folder"}),
              ElementsAre("tcbsample", "--count=3", "--meta"));
}

TEST(CommandOfProvenance, has_the_files_of_one_output) {
  EXPECT_THAT(*job_of({"-n", "3", "--meta", "a.csv", "b.csv"}).rows.provenance->files, ElementsAre("a.csv", "b.csv"));
  EXPECT_THAT(*job_of({"-n", "3", "--meta"}).rows.provenance->files, ElementsAre("-"));
  EXPECT_FALSE(job_of({"-n", "3", "--meta", "--output-dir", "out", "a.csv", "b.csv"}).rows.provenance->files);
}

TEST(CommandOfProvenance, is_there_only_with_its_option) { EXPECT_FALSE(job_of({"-n", "3"}).rows.provenance); }

}  // namespace

TEST(Plan, a_plot_has_samples_of_its_own) {
  const SamplingRequest samples = job_of<PlotJob>({"--plot"}).samples.request;
  EXPECT_EQ(samples.mode, Mode::intervals);
  EXPECT_EQ(samples.count, 50U);
  EXPECT_EQ(job_of<PlotJob>({"--plot", "--count=7"}).samples.request.mode, Mode::count);
  EXPECT_THAT(refusal({"-f", "svg"}), testing::HasSubstr("--step"));
}

}  // namespace tcb
