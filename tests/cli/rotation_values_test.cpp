// Values of rotations: forms, orders of Euler angles, and the errors for others.
#include "cli/rotation_values.hpp"

#include "cli/command_line.hpp"

namespace tcb {
namespace {

using spline::RotationForm;
using testing::ElementsAre;
using testing::HasSubstr;

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
