// Plans: what typed options mean, and the exact refusal of each that means nothing.
#include "cli/plan.hpp"

#include <gmock/gmock.h>

#include "error.hpp"

namespace tcb {
namespace {

using testing::ElementsAre;

/// What is typed where only this one option besides --step is.
TypedOptions typed(std::string TypedOptions::*option, const std::string& value) {
  TypedOptions result;
  result.step = "1";
  result.*option = value;
  return result;
}

TypedOptions only(std::string TypedOptions::*option, const std::string& value) {
  TypedOptions result;
  result.*option = value;
  return result;
}

/// The error of a plan, which is always one of usage.
std::string refusal(const TypedOptions& options) {
  try {
    make_plan(options);
  } catch (const Error& error) {
    EXPECT_EQ(error.exit(), Exit::usage);
    return error.what();
  }
  return "no error";
}

TEST(Job, without_options_but_a_step_all_is_default) {
  const Job plan = make_plan(only(&TypedOptions::step, "0.1"));
  EXPECT_THAT(plan.files, ElementsAre("-"));
  EXPECT_EQ(plan.sampling.mode, Mode::step);
  EXPECT_EQ(plan.sampling.step, Rational(1, 10)) << "a decimal is what it says";
  EXPECT_FALSE(plan.sampling.from || plan.sampling.to);
  EXPECT_THAT(plan.fields, ElementsAre(0, 1));
  EXPECT_EQ(plan.output_format, FormatId::csv);
  EXPECT_FALSE(plan.output_header || plan.output_folder);
  EXPECT_EQ(plan.output, "-");
  EXPECT_FALSE(plan.input.format || plan.input.delimiter || plan.input.header);
  EXPECT_EQ(plan.input.comment, "#");
  EXPECT_EQ(plan.input.tcb, spline::Tcb<double>{});
}

TEST(Job, notations_are_told_apart) {
  using Kind = Notation::Kind;
  const Notation digits = make_plan(typed(&TypedOptions::digits, "17")).notation;
  EXPECT_EQ(digits.kind, Kind::digits);
  EXPECT_EQ(digits.count, 17);
  EXPECT_EQ(make_plan(typed(&TypedOptions::fixed, "0")).notation.kind, Kind::fixed);
  EXPECT_EQ(refusal(typed(&TypedOptions::digits, "0")), "--digits \"0\": expected a whole number from 1 to 100");
  EXPECT_EQ(refusal(typed(&TypedOptions::fixed, "101")), "--fixed \"101\": expected a whole number from 0 to 100");
  EXPECT_EQ(
      refusal(typed(&TypedOptions::digits, "18")),
      "--digits 18: a double has 17 digits that say something; expected as many at most, or --golden, which works "
      "out more; give one of the two");
  TypedOptions both = typed(&TypedOptions::digits, "3");
  both.hex = true;
  EXPECT_EQ(refusal(both), "--digits and --hex both say how numbers are printed; expected one of them; take one out");
}

TEST(Job, golden_rows_take_more_digits_and_exact_input) {
  TypedOptions options = typed(&TypedOptions::digits, "100");
  options.golden = options.exact_input = true;
  const Job plan = make_plan(options);
  ASSERT_TRUE(plan.golden.has_value());
  EXPECT_TRUE(plan.golden->decimal && plan.input.keeps_decimals);
  EXPECT_EQ(plan.golden->notation.count, 100);
  options.golden = false;
  options.digits = "17";
  EXPECT_EQ(refusal(options),
            "--exact-input has no effect without --golden, which works exactly; give both, or neither");
  TypedOptions error = typed(&TypedOptions::fields, "time,arc_error");
  error.golden = true;
  EXPECT_EQ(refusal(error),
            "--golden: arc_error is about the error of s, which then is only rounded; take the field out");
}

TEST(Job, notations_without_a_meaning_in_a_format_are_refused) {
  TypedOptions npy = typed(&TypedOptions::output_format, "npy");
  EXPECT_EQ(make_plan(npy).output_format, FormatId::npy);
  npy.fixed = "3";
  EXPECT_EQ(refusal(npy), "--fixed has no effect on npy, which holds the doubles themselves; take it out");
  TypedOptions json = typed(&TypedOptions::output_format, "jsonl");
  json.hex = true;
  EXPECT_EQ(refusal(json),
            "--hex: jsonl has no hexadecimal numbers; expected csv, tsv or ssv; take one of the two out");
  EXPECT_EQ(refusal(typed(&TypedOptions::input_format, "npy")),
            "--input-format: unknown format \"npy\"; expected one of csv, tsv, ssv, json, jsonl");
}

TEST(Job, options_about_curves_and_cells_have_their_meaning) {
  const Job plain = make_plan(only(&TypedOptions::step, "1"));
  EXPECT_EQ(plain.input.missing, Missing::error);
  EXPECT_EQ(plain.input.decimal, '.');
  EXPECT_EQ(plain.curves.duplicates, Duplicates::error);
  EXPECT_FALSE(plain.curves.sort);
  EXPECT_EQ(make_plan(typed(&TypedOptions::missing, "skip-cell")).input.missing, Missing::skip_cell);
  EXPECT_EQ(make_plan(typed(&TypedOptions::duplicates, "break")).curves.duplicates, Duplicates::break_curve);
  EXPECT_EQ(make_plan(typed(&TypedOptions::decimal, ",")).input.decimal, ',');
  TypedOptions grouped = typed(&TypedOptions::group, "id,take");
  grouped.columns = "carry=label";
  const auto roles = make_plan(grouped).input.roles;
  ASSERT_EQ(roles.size(), 2U);
  EXPECT_EQ(roles[1].role, Role::group);
  EXPECT_THAT(roles[1].columns, ElementsAre("id", "take"));
  EXPECT_EQ(roles[1].option, "--group");
}

TEST(Job, options_about_curves_and_cells_that_mean_nothing_are_refused) {
  EXPECT_EQ(refusal(typed(&TypedOptions::missing, "skip")),
            "--missing: unknown name \"skip\"; expected one of error, skip-row, skip-cell, break");
  EXPECT_EQ(refusal(typed(&TypedOptions::duplicates, "fist")),
            "--duplicates: unknown name \"fist\"; expected one of error, first, last, break; did you mean first?");
  EXPECT_EQ(refusal(typed(&TypedOptions::decimal, ";")), "--decimal \";\": expected a comma or a point");
  EXPECT_EQ(refusal(typed(&TypedOptions::group, "id,")),
            "--group \"id,\": expected columns by name or number, apart by commas");
  TypedOptions comma = typed(&TypedOptions::decimal, ",");
  comma.delimiter = "comma";
  EXPECT_EQ(refusal(comma),
            "--decimal , and --delimiter , contradict each other; expected another delimiter; take one of them out");
  TypedOptions json = typed(&TypedOptions::decimal, ",");
  json.input_format = "json";
  EXPECT_EQ(refusal(json),
            "--delimiter, --header, --no-header, --comment and --decimal have no effect on JSON; take them out");
  TypedOptions sparse = typed(&TypedOptions::missing, "skip-cell");
  sparse.curve.equal_speed = true;
  EXPECT_EQ(
      refusal(sparse),
      "--missing skip-cell leaves channels apart, and --equal-speed and --parameter need all of them at each key; "
      "expected one of the two; take one out");
}

TEST(Job, each_way_to_sample_has_its_mode_and_value) {
  const auto sampling = [](std::string TypedOptions::*option, const std::string& value) {
    return make_plan(only(option, value)).sampling;
  };
  EXPECT_EQ(sampling(&TypedOptions::step, "1001/30000").step, Rational(1001, 30000));
  EXPECT_EQ(sampling(&TypedOptions::rate, "30000/1001").step, Rational(1001, 30000)) << "exactly 1/HZ";
  EXPECT_EQ(sampling(&TypedOptions::rate, "24").mode, Mode::step);
  EXPECT_EQ(sampling(&TypedOptions::count, "200").mode, Mode::count);
  EXPECT_EQ(sampling(&TypedOptions::count, "9223372036854775807").count, 9223372036854775807U);
  EXPECT_EQ(sampling(&TypedOptions::segments, "7").mode, Mode::segments);
  EXPECT_EQ(sampling(&TypedOptions::segments, "7").count, 7U);
  EXPECT_EQ(sampling(&TypedOptions::arc_step, "2.5").mode, Mode::arc_step);
  EXPECT_EQ(sampling(&TypedOptions::arc_step, "2.5").step, Rational(5, 2));
  EXPECT_EQ(sampling(&TypedOptions::arc_count, "3").mode, Mode::arc_count);
  EXPECT_EQ(sampling(&TypedOptions::arc_count, "3").count, 3U);
}

TEST(Job, samples_are_asked_for_in_exactly_one_way) {
  EXPECT_EQ(refusal({}),
            "nothing says where the samples are; expected one of --step, --rate, --count, --segments, --per-segment, "
            "--at, --arc-step, --arc-count, --arc-at, --tolerance; for example tcbsample --step 0.1 keys.csv");
  TypedOptions two = only(&TypedOptions::arc_count, "3");
  two.rate = "24";
  EXPECT_EQ(refusal(two), "--rate and --arc-count both say where the samples are; expected one of them; take one out");
}

TEST(Job, steps_are_above_0_and_counts_from_1_up) {
  for (const char* value : {"0", "-1", "x", "1/0", "0/5", "1e", "inf", "1/24x"}) {
    const std::string expected =
        std::string(" \"") + value + "\": expected a decimal or a ratio above 0, such as 0.1 or 1/24";
    EXPECT_EQ(refusal(only(&TypedOptions::step, value)), "--step" + expected);
    EXPECT_EQ(refusal(only(&TypedOptions::rate, value)), "--rate" + expected);
    EXPECT_EQ(refusal(only(&TypedOptions::arc_step, value)), "--arc-step" + expected);
  }
  for (const char* value : {"0", "-1", "+1", "1.5", "1e3", " 1", "9223372036854775808", "99999999999999999999"}) {
    const std::string expected =
        std::string(" \"") + value + "\": expected a whole number from 1 to 2^63 - 1, in digits";
    EXPECT_EQ(refusal(only(&TypedOptions::count, value)), "--count" + expected);
    EXPECT_EQ(refusal(only(&TypedOptions::segments, value)), "--segments" + expected);
    EXPECT_EQ(refusal(only(&TypedOptions::arc_count, value)), "--arc-count" + expected);
  }
}

TEST(Job, the_range_is_exact_and_goes_forward) {
  TypedOptions range = typed(&TypedOptions::from, "-7/24");
  range.to = "0.1";
  const Job plan = make_plan(range);
  EXPECT_EQ(plan.sampling.from, Rational(-7, 24));
  EXPECT_EQ(plan.sampling.to, Rational(1, 10));
  EXPECT_EQ(refusal(typed(&TypedOptions::from, "now")),
            "--from \"now\": expected a decimal or a ratio, such as 1.5 or 7/24");
  EXPECT_EQ(refusal(typed(&TypedOptions::to, "1/0")),
            "--to \"1/0\": expected a decimal or a ratio, such as 1.5 or 7/24");
  range.to = "-1";
  EXPECT_EQ(refusal(range), "--to -1 is before --from -7/24; expected it after; exchange them");
  range.to = range.from;
  EXPECT_EQ(refusal(range), "no error") << "a single time is a range";
}

TEST(Job, delimiters_are_names_or_characters_that_no_number_has) {
  const std::pair<const char*, char> known[] = {{"tab", '\t'}, {"comma", ','}, {"semicolon", ';'}, {"space", ' '},
                                                {"pipe", '|'}, {":", ':'},     {"\t", '\t'},       {"x", 'x'}};
  for (const auto& [text, character] : known) {
    EXPECT_EQ(make_plan(typed(&TypedOptions::delimiter, text)).input.delimiter, character) << text;
  }
  for (const char* text : {"1", "e", "E", ".", "-", "+", "\"", "\n", "\r", "tabs", ",,", "é"}) {
    EXPECT_EQ(refusal(typed(&TypedOptions::delimiter, text)),
              std::string("--delimiter \"") + text +
                  "\": expected one character that is no part of a number, or tab, comma, semicolon, space or pipe");
  }
}

TEST(Job, tension_continuity_and_bias_are_three_numbers) {
  EXPECT_EQ(make_plan(typed(&TypedOptions::tcb, "0,0.5,-0.25")).input.tcb, (spline::Tcb<double>{0, 0.5, -0.25}));
  for (const char* text : {"0", "0,0", "0,0,0,0", "0,,0", "0,0,x", "0,0,1e999", "0;0;0"}) {
    EXPECT_EQ(refusal(typed(&TypedOptions::tcb, text)),
              std::string("--tcb \"") + text + "\": expected three numbers T,C,B, such as 0,0.5,-0.25");
  }
}

TEST(Job, the_input_is_described) {
  TypedOptions options = typed(&TypedOptions::input_format, "jsonl");
  EXPECT_EQ(make_plan(options).input.format, FormatId::jsonl);
  EXPECT_EQ(make_plan(typed(&TypedOptions::comment, "//")).input.comment, "//");
  EXPECT_EQ(make_plan(typed(&TypedOptions::comment, "none")).input.comment, "");
  const Job roles = make_plan(typed(&TypedOptions::columns, "time=frame"));
  ASSERT_EQ(roles.input.roles.size(), 1U);
  EXPECT_EQ(roles.input.roles[0].role, Role::time);
  options = only(&TypedOptions::step, "1");
  options.no_header = true;
  EXPECT_EQ(make_plan(options).input.header, false);
  options.header = true;
  EXPECT_EQ(refusal(options), "--header and --no-header contradict each other; expected one of them; take one out");
  options.no_header = false;
  EXPECT_EQ(make_plan(options).input.header, true);
}

TEST(Job, unknown_formats_are_refused_by_the_option_that_asked) {
  EXPECT_EQ(refusal(typed(&TypedOptions::input_format, "xml")),
            "--input-format: unknown format \"xml\"; expected one of csv, tsv, ssv, json, jsonl");
  EXPECT_EQ(refusal(typed(&TypedOptions::output_format, "xml")),
            "--output-format: unknown format \"xml\"; expected one of csv, tsv, ssv, json, jsonl, npy");
}

TEST(Job, fields_are_chosen_in_order) {
  EXPECT_THAT(make_plan(typed(&TypedOptions::fields, "s,position,time")).fields, ElementsAre(2, 1, 0));
  EXPECT_EQ(refusal(typed(&TypedOptions::fields, "time,positon")),
            "--fields: no field \"positon\"; expected some of time, position, s, velocity, acceleration, jerk, speed, "
            "tangent, curvature, torsion, segment, u, key, arc_error; did you mean position?");
  EXPECT_EQ(refusal(typed(&TypedOptions::fields, "time,")),
            "--fields: no field \"\"; expected some of time, position, s, velocity, acceleration, jerk, speed, "
            "tangent, curvature, torsion, segment, u, key, arc_error");
}

TEST(Job, the_output_goes_to_one_place) {
  TypedOptions options = typed(&TypedOptions::output, "out.csv");
  EXPECT_EQ(make_plan(options).output, "out.csv");
  options.output_dir = "out";
  EXPECT_EQ(refusal(options),
            "--output and --output-dir both say where the rows go; expected one of them; take one out");
  options.output.clear();
  options.files = {"a.csv", "b.csv"};
  const Job plan = make_plan(options);
  EXPECT_EQ(plan.output_folder, "out");
  EXPECT_THAT(plan.files, ElementsAre("a.csv", "b.csv"));
  EXPECT_EQ(make_plan(typed(&TypedOptions::output_format, "json")).output_format, FormatId::json);
  options.no_output_header = true;
  EXPECT_EQ(make_plan(options).output_header, false);
}

TEST(Job, an_option_without_effect_is_refused) {
  TypedOptions input = typed(&TypedOptions::input_format, "json");
  input.delimiter = ";";
  EXPECT_NE(refusal(input), "no error") << "JSON has no delimiter";
  input.delimiter.clear();
  input.header = true;
  EXPECT_NE(refusal(input), "no error") << "JSON has no header";
  TypedOptions output = typed(&TypedOptions::output_format, "json");
  output.no_output_header = true;
  EXPECT_NE(refusal(output), "no error") << "JSON has no names above the rows";
}

}  // namespace
}  // namespace tcb
