// Values: the values that options take, and the errors for others.
#include "cli/values.hpp"

#include "cli/command_line.hpp"
#include "formats/formats.hpp"
#include "sample/table.hpp"

namespace tcb {
namespace {

using spline::RotationForm;
using testing::ElementsAre;
using testing::HasSubstr;

/// Matches the message about a value of an option that is followed by these words.
auto about(const std::string& option, const std::string& value, const std::string& words) {
  return testing::StartsWith(option + ": \"" + value + "\" " + words);
}

TEST(Values, steps_and_rates_are_above_0) {
  for (const std::string value : {"0", "-1", "x", "1/0", "0/5", "1e", "inf", "1/24x"}) {
    for (const std::string option : {"--step", "--rate", "--arc-step"}) {
      EXPECT_THAT(refusal({option, value}), about(option, value, "is not a number above 0"));
    }
  }
  EXPECT_THAT(refusal({"--rate", "1e-309"}), about("--rate", "1e-309", "is too small a rate"));
  EXPECT_THAT(refusal({"--step", "1e309"}), about("--step", "1e309", "is too large"));
}

TEST(Values, counts_are_in_digits_from_1_up) {
  EXPECT_EQ(positive_count("9223372036854775807"), 9223372036854775807U);
  for (const std::string value : {"0", "-1", "+1", "1.5", "1e3", " 1", "9223372036854775808", "99999999999999999999"}) {
    for (const std::string option : {"--count", "--per-segment", "--arc-count"}) {
      EXPECT_THAT(refusal({option, value}), about(option, value, "is not a count"));
    }
  }
}

TEST(Values, a_range_is_of_decimals_or_ratios) {
  EXPECT_EQ(time_value(expects_ratio, "-7/24").value, Rational(-7, 24));
  for (const std::string option : {"--from", "--to"}) {
    EXPECT_THAT(stepped_refusal({option, "now"}), about(option, "now", "is not a number"));
  }
}

TEST(Values, times_may_have_a_unit) {
  const auto value = [](std::string_view text) { return time_value(expects_ratio, text); };
  EXPECT_EQ(value("1/24").value, Rational(1, 24));
  EXPECT_FALSE(value("1e3").in_seconds);
  EXPECT_EQ(value("20ms").value, Rational(1, 50));
  EXPECT_EQ(value("-1.5h").value, Rational(-5400));
  EXPECT_EQ(value("1/2min").value, Rational(30));
  EXPECT_TRUE(value("1d").in_seconds);
  for (const char* text : {"5frames", "s", "1 s", "1sec", "1S"}) EXPECT_THROW(value(text), Error) << text;
}

TEST(Values, frame_rates_of_video_have_usual_decimals) {
  EXPECT_EQ(frame_rate("29.97"), Rational(30000, 1001));
  EXPECT_EQ(frame_rate("23.98"), Rational(24000, 1001));
  EXPECT_EQ(frame_rate("2997/100"), Rational(2997, 100));
  EXPECT_EQ(frame_rate("29.970"), Rational(2997, 100));
}

TEST(Values, lists_are_separated_by_commas) {
  EXPECT_THAT(refusal({"--at", "1,,2"}), about("--at", "", "is not a number"));
}

TEST(Values, whole_numbers_of_options_are_within_their_range) {
  EXPECT_EQ(count_between("1e9", 1, INT64_MAX), 1'000'000'000U);
  EXPECT_THAT(stepped_refusal({"--max-rows", "1.5"}),
              about("--max-rows", "1.5", "is not valid; expected a whole number from 1 to 9223372036854775807"));
  EXPECT_THAT(stepped_refusal({"--jobs", "1025"}),
              about("--jobs", "1025", "is not valid; expected a whole number from 1 to 1024"));
  EXPECT_THAT(stepped_refusal({"--digits", "0"}),
              about("--digits", "0", "is not valid; expected a whole number from 1 to 100"));
  EXPECT_THAT(stepped_refusal({"--fixed", "101"}),
              about("--fixed", "101", "is not valid; expected a whole number from 0 to 100"));
}

TEST(Values, a_tolerance_of_samples_is_above_0) {
  EXPECT_EQ(curve_tolerance("1e-9").distance, 1e-9);
  EXPECT_FALSE(curve_tolerance("1e-9").limits_angle());
  EXPECT_FALSE(curve_tolerance("0.5deg").limits_distance());
  EXPECT_DOUBLE_EQ(curve_tolerance("2,180deg").angle, 3.141592653589793);
  EXPECT_EQ(curve_tolerance("0.25rad,2").angle, 0.25);
  for (const std::string value : {"0", "-1", "x", "inf", "1,2", "1,2deg,3deg", "deg", "1,", "0deg"}) {
    EXPECT_THAT(refusal({"--tolerance", value}), about("--tolerance", value, "is not a tolerance"));
  }
}

TEST(Values, tolerances_are_for_all_columns_or_for_one) {
  const auto list = tolerances("1e-9,x=0.5,a=b=2");
  ASSERT_EQ(list.size(), 3U);
  EXPECT_EQ(list[0].column, "");
  EXPECT_EQ(list[0].most, 1e-9);
  EXPECT_EQ(list[1].column, "x");
  EXPECT_EQ(list[2].column, "a=b") << "a name may contain =";
  EXPECT_EQ(list[2].most, 2);
  for (const char* value : {"-1", "x", "=1", "1,", "x=", "nan"}) {
    EXPECT_THAT(refusal({"--check", "a", "--ulp", value}), testing::StartsWith("--ulp: \"")) << value;
  }
}

TEST(Values, delimiters_are_names_or_characters_that_no_number_has) {
  const std::pair<const char*, char> known[] = {{"tab", '\t'}, {"comma", ','}, {"semicolon", ';'}, {"space", ' '},
                                                {"pipe", '|'}, {":", ':'},     {"\t", '\t'},       {"x", 'x'}};
  for (const auto& [text, character] : known) EXPECT_EQ(delimiter(text), character) << text;
  for (const char* text : {"1", "e", "E", ".", "-", "+", "\"", "tabs", ",,", "é"}) {
    EXPECT_THAT(stepped_refusal({"--delimiter", text}), about("--delimiter", text, "is not a delimiter"));
  }
  EXPECT_THAT(stepped_refusal({"--delimiter", "\n"}), about("--delimiter", "\\x0A", "is not a delimiter"));
  EXPECT_THAT(stepped_refusal({"--delimiter", "\r"}), about("--delimiter", "\\x0D", "is not a delimiter"));
}

TEST(Values, tension_continuity_and_bias_are_three_numbers) {
  EXPECT_EQ(tcb_values("0,0.5,-0.25"), (spline::Tcb<double>{0, 0.5, -0.25}));
  for (const char* text : {"0", "0,0", "0,0,0,0", "0,,0", "0,0,x", "0,0,1e999", "0;0;0"}) {
    EXPECT_THAT(stepped_refusal({"--tcb", text}), about("--tcb", text, "is not a tension"));
  }
}

TEST(Values, columns_marks_and_parts_of_names) {
  EXPECT_THAT(column_list("id,take"), ElementsAre("id", "take"));
  EXPECT_THAT(stepped_refusal({"--group", "id,"}), about("--group", "id,", "has an empty item"));
  EXPECT_THAT(stepped_refusal({"--decimal", ";"}), about("--decimal", ";", "is not a decimal mark"));
  EXPECT_THAT(stepped_refusal({"--output-dir", "a", "--suffix", "a/b"}), about("--suffix", "a/b", "contains /"));
}

TEST(Values, fields_are_chosen_in_order_each_once) {
  EXPECT_THAT(field_list("s,position,time"), ElementsAre(2, 1, 0));
  EXPECT_EQ(
      stepped_refusal({"--fields", "time,positon"}),
      "--fields: \"positon\" is not a known name; expected one of time, position, s, velocity, acceleration, jerk, "
      "speed, tangent, curvature, torsion, angular_velocity, angular_speed, segment, u, key, arc_error, length; "
      "did you mean position?");
}

TEST(Values, forms_of_pieces_are_fields_with_columns_for_each_channel) {
  for (const std::string_view name : form_names()) EXPECT_EQ(fields()[form_of_pieces(std::string(name))].name, name);
  for (const char* text : {"poly3", "poly4", "poly8", "polynomial", "start", "length", "position", "", "Poly"}) {
    EXPECT_THROW(form_of_pieces(text), Error) << text;
  }
  EXPECT_THROW(field_list("start"), Error);
  EXPECT_THROW(field_list("poly"), Error);
}

TEST(Values, formats_are_those_that_can_be_read_or_written) {
  EXPECT_EQ(stepped_refusal({"-i", "gltf"}),
            "--input-format: \"gltf\" is not a known name; expected one of csv, tsv, ssv, json, jsonl, tum, euroc, "
            "kitti, nerfstudio, lws, 3ds, npy");
  EXPECT_EQ(
      stepped_refusal({"-f", "xml"}),
      "--output-format: \"xml\" is not a known name; expected one of csv, tsv, ssv, json, jsonl, tum, euroc, kitti, "
      "nerfstudio, gltf, npy, svg");
}

TEST(Values, names_come_from_the_tables) {
  EXPECT_EQ(stepped_refusal({"--missing", "skip"}),
            "--missing: \"skip\" is not a known name; expected one of error, skip-row, skip-cell, break");
  EXPECT_EQ(stepped_refusal({"--duplicates", "fist"}),
            "--duplicates: \"fist\" is not a known name; expected one of error, first, last, break, spread; did you "
            "mean first?");
}

TEST(Values, pictures) {
  EXPECT_EQ(axis_names("x:3"), (std::vector<std::string>{"x", "3"}));
  EXPECT_EQ(picture_size("800x600").height, 600);
  EXPECT_THAT(stepped_refusal({"-f", "svg", "--axes", "x"}), about("--axes", "x", "is not a pair of axes"));
  for (const char* size : {"800", "800x", "99x600", "800x10001", "-800x600", "800x600x2"}) {
    EXPECT_THAT(stepped_refusal({"--plot", std::string("--size=") + size}),
                testing::HasSubstr("expected width and height"))
        << size;
  }
}

TEST(RotationValues, several_rotations_of_different_forms) {
  bool none = false;
  const auto all = rotations("quaternion=a:b:c:d,axis-angle=e:f:g:h,relative,euler=i:j:k,order=ZYX", none);
  ASSERT_EQ(all.size(), 3U);
  EXPECT_FALSE(none);
  EXPECT_EQ(all[0].notation.form, RotationForm::quaternion);
  EXPECT_THAT(all[0].columns, ElementsAre("a", "b", "c", "d"));
  EXPECT_FALSE(all[0].relative);
  EXPECT_EQ(all[1].notation.form, RotationForm::axis_angle);
  EXPECT_TRUE(all[1].relative);
  EXPECT_THAT(all[2].columns, ElementsAre("i", "j", "k"));
  EXPECT_THAT(all[2].notation.axes, ElementsAre(2, 1, 0));
  const auto matrix = rotations("matrix=1:2:3:5:6:7:9:10:11", none);
  EXPECT_EQ(matrix.at(0).notation.form, RotationForm::matrix);
  EXPECT_THAT(matrix[0].columns, ElementsAre("1", "2", "3", "5", "6", "7", "9", "10", "11"));
}

TEST(RotationValues, small_letters_are_axes_at_rest) {
  EXPECT_TRUE(rotation_form("euler=XYZ").intrinsic);
  EXPECT_FALSE(rotation_form("euler=zxz").intrinsic);
  EXPECT_THAT(rotation_form("euler=zxz").axes, ElementsAre(2, 0, 2));
  EXPECT_EQ(rotation_form("matrix").form, RotationForm::matrix);
}

TEST(RotationValues, others_are_refused) {
  for (const std::string value :
       {"quaternion", "quaternion=a:b:c", "quaternion=a:b:c:", "euler=a:b:c", "order=XYZ",
        "quaternion=a:b:c:d,relative", "none,quaternion=a:b:c:d", "matrix=a:b", "euler=a:b:c,order=XYZ,order=XYZ"}) {
    EXPECT_THAT(refusal({"--rotation", value}), HasSubstr("--rotation: \"" + value + "\" ")) << value;
  }
  for (const std::string value : {"euler", "euler=XXY", "euler=XyZ", "euler=XY", "euler=ABC", "axis"}) {
    EXPECT_THAT(refusal({"--rotation-output", value}), HasSubstr("\"" + value + "\"")) << value;
  }
}

}  // namespace
}  // namespace tcb
