// Validators: the values that options take, and the errors for others.
#include "cli/options.hpp"

#include "cli/command_line.hpp"

namespace tcb {
namespace {

using testing::ElementsAre;

std::string expected(const std::string& option, const std::string& value, const std::string& words) {
  return option + " \"" + value + "\": expected " + words;
}

TEST(Validators, steps_and_rates_are_above_0) {
  for (const std::string value : {"0", "-1", "x", "1/0", "0/5", "1e", "inf", "1/24x"}) {
    for (const std::string option : {"--step", "--rate", "--arc-step"}) {
      EXPECT_EQ(refusal({option, value}), expected(option, value, "a decimal or a ratio above 0, such as 0.1 or 1/24"));
    }
  }
  EXPECT_EQ(refusal({"--rate", "1e-309"}),
            expected("--rate", "1e-309", "a rate whose step is a double, less than 1.8e308"));
  EXPECT_EQ(refusal({"--step", "1e309"}),
            expected("--step", "1e309", "at most 1.7976931348623157e308 in size, as doubles are"));
}

TEST(Validators, counts_are_in_digits_from_1_up) {
  EXPECT_EQ(positive_count("9223372036854775807"), 9223372036854775807U);
  for (const std::string value : {"0", "-1", "+1", "1.5", "1e3", " 1", "9223372036854775808", "99999999999999999999"}) {
    for (const std::string option : {"--count", "--segments", "--per-segment", "--arc-count"}) {
      EXPECT_EQ(refusal({option, value}), expected(option, value, "a whole number from 1 to 2^63 - 1, in digits"));
    }
  }
}

TEST(Validators, a_range_is_of_decimals_or_ratios) {
  EXPECT_EQ(ratio("-7/24"), Rational(-7, 24));
  for (const std::string option : {"--from", "--to"}) {
    EXPECT_EQ(stepped_refusal({option, "now"}), expected(option, "now", "a decimal or a ratio, such as 1.5 or 7/24"));
  }
}

TEST(Validators, lists_are_separated_by_commas) {
  EXPECT_EQ(refusal({"--at", "1,,2"}),
            expected("--at", "", "decimals or ratios, separated by commas, such as 0,0.5,7/24"));
}

TEST(Validators, whole_numbers_of_options_are_within_their_range) {
  EXPECT_EQ(count_between("1e9", 1, INT64_MAX), 1'000'000'000U);
  EXPECT_EQ(stepped_refusal({"--max-rows", "1.5"}),
            expected("--max-rows", "1.5", "a whole number from 1 to 9223372036854775807"));
  EXPECT_EQ(stepped_refusal({"--jobs", "1025"}), expected("--jobs", "1025", "a whole number from 1 to 1024"));
  EXPECT_EQ(stepped_refusal({"--digits", "0"}), expected("--digits", "0", "a whole number from 1 to 100"));
  EXPECT_EQ(stepped_refusal({"--fixed", "101"}), expected("--fixed", "101", "a whole number from 0 to 100"));
}

TEST(Validators, a_tolerance_of_samples_is_above_0) {
  EXPECT_EQ(curve_tolerance("1e-9").distance, 1e-9);
  EXPECT_FALSE(curve_tolerance("1e-9").limits_angle());
  EXPECT_FALSE(curve_tolerance("0.5deg").limits_distance());
  EXPECT_DOUBLE_EQ(curve_tolerance("2,180deg").angle, 3.141592653589793);
  EXPECT_EQ(curve_tolerance("0.25rad,2").angle, 0.25);
  for (const std::string value : {"0", "-1", "x", "inf", "1,2", "1,2deg,3deg", "deg", "1,", "0deg"}) {
    EXPECT_EQ(
        refusal({"--tolerance", value}),
        expected("--tolerance", value,
                 "a distance above 0, an angle with deg or rad for rotations, or both separated by a comma, such as "
                 "0.01 or 0.01,0.5deg"));
  }
}

TEST(Validators, tolerances_are_for_all_columns_or_for_one) {
  const auto list = tolerances("1e-9,x=0.5,a=b=2");
  ASSERT_EQ(list.size(), 3U);
  EXPECT_EQ(list[0].column, "");
  EXPECT_EQ(list[0].most, 1e-9);
  EXPECT_EQ(list[1].column, "x");
  EXPECT_EQ(list[2].column, "a=b") << "a name may contain =";
  EXPECT_EQ(list[2].most, 2);
  for (const char* value : {"-1", "x", "=1", "1,", "x=", "nan"}) {
    EXPECT_THAT(refusal({"--check", "a", "--ulp", value}), testing::StartsWith("--ulp \"")) << value;
  }
}

TEST(Validators, delimiters_are_names_or_characters_that_no_number_has) {
  const std::pair<const char*, char> known[] = {{"tab", '\t'}, {"comma", ','}, {"semicolon", ';'}, {"space", ' '},
                                                {"pipe", '|'}, {":", ':'},     {"\t", '\t'},       {"x", 'x'}};
  for (const auto& [text, character] : known) EXPECT_EQ(delimiter(text), character) << text;
  for (const char* text : {"1", "e", "E", ".", "-", "+", "\"", "\n", "\r", "tabs", ",,", "é"}) {
    EXPECT_EQ(stepped_refusal({"--delimiter", text}),
              expected("--delimiter", text,
                       "one character that cannot be part of a number, or tab, comma, semicolon, space or pipe"));
  }
}

TEST(Validators, tension_continuity_and_bias_are_three_numbers) {
  EXPECT_EQ(tcb_values("0,0.5,-0.25"), (spline::Tcb<double>{0, 0.5, -0.25}));
  for (const char* text : {"0", "0,0", "0,0,0,0", "0,,0", "0,0,x", "0,0,1e999", "0;0;0"}) {
    EXPECT_EQ(stepped_refusal({"--tcb", text}), expected("--tcb", text, "three numbers T,C,B, such as 0,0.5,-0.25"));
  }
}

TEST(Validators, columns_marks_and_parts_of_names) {
  EXPECT_THAT(column_list("id,take"), ElementsAre("id", "take"));
  EXPECT_EQ(stepped_refusal({"--group", "id,"}),
            expected("--group", "id,", "columns by name or number, separated by commas"));
  EXPECT_EQ(stepped_refusal({"--decimal", ";"}), expected("--decimal", ";", "a comma or a point"));
  EXPECT_EQ(stepped_refusal({"--output-dir", "a", "--suffix", "a/b"}),
            expected("--suffix", "a/b", "a part of a file name, without /"));
}

TEST(Validators, fields_are_chosen_in_order_each_once) {
  EXPECT_THAT(field_list("s,position,time"), ElementsAre(2, 1, 0));
  EXPECT_EQ(stepped_refusal({"--fields", "time,positon"}),
            "--fields: unknown name \"positon\"; expected one of time, position, s, velocity, acceleration, jerk, "
            "speed, tangent, curvature, torsion, angular_velocity, angular_speed, segment, u, key, arc_error, length; "
            "did you mean position?");
  EXPECT_EQ(stepped_refusal({"--fields", "time,s,time"}),
            "--fields: time is repeated; expected each field once; remove one");
}

TEST(Validators, forms_of_pieces_have_their_number_of_coefficients) {
  EXPECT_EQ(fields()[form_of_pieces("poly8")].columns, 8U);
  EXPECT_EQ(form_of_pieces("poly4"), form_of_pieces("poly"));
  for (const auto& [name] : form_table) EXPECT_EQ(fields()[form_of_pieces(std::string(name))].name, name);
  for (const char* text : {"poly3", "poly33", "poly08", "polynomial", "start", "length", "position", "", "Poly"}) {
    EXPECT_THROW(form_of_pieces(text), Error) << text;
  }
  EXPECT_THROW(field_list("start"), Error);
  EXPECT_THROW(field_list("poly"), Error);
}

TEST(Validators, formats_are_those_that_can_be_read_or_written) {
  EXPECT_EQ(input_format("jsonl"), FormatId::jsonl);
  EXPECT_EQ(output_format("npy"), FormatId::npy);
  EXPECT_EQ(stepped_refusal({"-i", "npy"}),
            "--input-format: unknown name \"npy\"; expected one of csv, tsv, ssv, json, jsonl");
  EXPECT_EQ(stepped_refusal({"-f", "xml"}),
            "--output-format: unknown name \"xml\"; expected one of csv, tsv, ssv, json, jsonl, npy, svg");
}

TEST(Validators, names_come_from_the_tables) {
  EXPECT_EQ(stepped_refusal({"--missing", "skip"}),
            "--missing: unknown name \"skip\"; expected one of error, skip-row, skip-cell, break");
  EXPECT_EQ(stepped_refusal({"--duplicates", "fist"}),
            "--duplicates: unknown name \"fist\"; expected one of error, first, last, break; did you mean first?");
}

TEST(Validators, pictures) {
  EXPECT_EQ(axis_names("x:3"), (std::vector<std::string>{"x", "3"}));
  EXPECT_EQ(picture_size("800x600").height, 600);
  EXPECT_EQ(stepped_refusal({"-f", "svg", "--axes", "x"}),
            "--axes \"x\": expected two channels by name or number, with a colon between them, such as x:z");
  for (const char* size : {"800", "800x", "99x600", "800x10001", "-800x600", "800x600x2"}) {
    EXPECT_THAT(stepped_refusal({"--plot", std::string("--size=") + size}),
                testing::HasSubstr("expected width and height"))
        << size;
  }
}

}  // namespace
}  // namespace tcb
