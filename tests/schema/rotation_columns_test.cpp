// Rotation columns: by name, on request by name or number, their channels, and the places of their numbers in rows.
#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "read/reading.hpp"

namespace tcb {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Input opened(const std::string& text, const RotationOptions& rotation, bool timeless = false) {
  InputOptions options;
  options.rotation = rotation;
  options.columns.timeless = timeless;
  return open_input("keys.csv", pieces(text), options);
}

TEST(RotationsByName, four_names_that_differ_in_a_letter_after_a_q) {
  using Four = spline::RotationChannels;
  const auto rotations = [](const std::string& header, const RotationOptions& options = {}) {
    std::vector<Four> channels;
    const Input input = opened(header + "\n0,1,1,1,1,1,1,1,1\n1,1,1,1,1,1,1,1,1\n", options);
    for (const RotationColumns& rotation : rotation_columns(input.schema)) channels.push_back(rotation.channels);
    return channels;
  };
  EXPECT_THAT(rotations("t,x,y,z,qx,qy,qz,qw,b"), ElementsAre(Four{3, 4, 5, 6}));
  EXPECT_THAT(rotations("t,a,b,c,QW,QX,QY,QZ,d"), ElementsAre(Four{4, 5, 6, 3}));
  EXPECT_THAT(rotations("t,q_RS_w [],q_RS_x [],q_RS_y [],q_RS_z [],quat.x,quat.y,quat.z,quat.w"),
              ElementsAre(Four{1, 2, 3, 0}, Four{4, 5, 6, 7}));
  EXPECT_THAT(rotations("t,orientation_x,orientation_y,orientation_z,orientation_w,rot.x,rot.y,rot.z,rot.w"),
              ElementsAre(Four{0, 1, 2, 3}, Four{4, 5, 6, 7}));
  EXPECT_THAT(rotations("t,a.pose.orientation.w,a.pose.orientation.x,a.pose.orientation.y,a.pose.orientation.z,"
                        "RotationX,RotationY,RotationZ,RotationW"),
              ElementsAre(Four{1, 2, 3, 0}, Four{4, 5, 6, 7}));
  EXPECT_THAT(rotations("t,rot_x,rot_y,rot_z,carrot_x,carrot_y,carrot_z,carrot_w,s"), ElementsAre());
  EXPECT_THAT(rotations("t,position.x,position.y,position.z,position.w,a,b,c,d"), ElementsAre());
  EXPECT_THAT(
      error_of([&] { rotations("t,x,y,z,u,q0,q1,q2,q3"); }),
      HasSubstr("give --rotation quaternion=q1:q2:q3:q0 if it is \"q0\", --rotation quaternion=q0:q1:q2:q3 if"));
  EXPECT_THAT(rotations("t,x,y,z,u,q0,q1,q2,q3", {.none = true}), ElementsAre());
  EXPECT_THAT(rotations("t,rx,ry,rz,rw,seq_x,seq_y,seq_z,s"), ElementsAre());
  EXPECT_THAT(error_of([&] { rotations("t,x,y,z,qx,qy,qz,u,v"); }), HasSubstr("\"qw\""));
  EXPECT_THAT(rotations("t,x,y,z,qx,qy,qz,u,v", {.none = true}), ElementsAre());
  EXPECT_THAT(rotations("t,a,b,c,d,qx,qy,qz,qw", {.requests = {{{}, false, {"B", "c", "d", "a"}}}}),
              ElementsAre(Four{1, 2, 3, 0}));
  EXPECT_THAT(error_of([&] {
                rotations("t,a,b,c,d,e,f,g,h",
                          {.requests = {{{}, false, {"a", "b", "c", "d"}}, {{}, false, {"d", "e", "f", "g"}}}});
              }),
              HasSubstr("column \"d\" is used twice"));
  EXPECT_THAT(error_of([&] {
                rotations("t,a,b,c,d,e,f,g,h", {.requests = {{{}, false, {"a", "b", "c", "z"}}}});
              }),
              HasSubstr("no column \"z\""));
}

TEST(RotationColumns, are_requested_by_the_numbers_of_columns) {
  const std::string tum = "0 1 2 3 0 0 0 1\n1 1 2 3 0 0 0 1\n";
  const auto quaternion = [](std::vector<std::string> columns) {
    return RotationOptions{.requests = {{{}, false, std::move(columns)}}};
  };
  const Input input = opened(tum, quaternion({"5", "6", "7", "8"}));
  EXPECT_EQ(input.schema.rotations.at(0).columns.channels, (spline::RotationChannels{3, 4, 5, 6}));
  EXPECT_THAT(input.schema.rotations[0].given.columns, ElementsAre("p4", "p5", "p6", "p7"));
  EXPECT_THAT(error_of([&] { opened(tum, quaternion({"1", "6", "7", "8"})); }), HasSubstr("column 1 is the time"));
  EXPECT_THAT(error_of([&] {
                opened(tum, quaternion({"5", "6", "7", "9"}));
              }),
              HasSubstr("no column \"9\"; the columns have no names"));
  EXPECT_EQ(opened(tum, {.angles = {{"8", true}}}).schema.angles.at(0).channel, 6U);
  const std::string named = "6,t,a,b,c,d,e\n0,0,0,0,0,0,1\n0,1,0,0,0,0,1\n";
  EXPECT_EQ(opened(named, quaternion({"6", "3", "4", "7"})).schema.rotations.at(0).columns.channels,
            (spline::RotationChannels{0, 1, 2, 5}))
      << "names come first";
}

TEST(RotationColumns, of_a_matrix_become_four_channels_and_stay_where_they_are_in_rows) {
  const std::string kitti = "1 0 0 5 0 1 0 6 0 0 1 7\n1 0 0 5 0 1 0 6 0 0 1 7\n";
  RotationOptions options{.requests = {{{spline::RotationForm::matrix}, false, {}}}};
  options.requests[0].columns = {"1", "2", "3", "5", "6", "7", "9", "10", "11"};
  const Input input = opened(kitti, options, true);
  EXPECT_EQ(input.schema.rotations.at(0).columns.channels, (spline::RotationChannels{0, 1, 2, 3}));
  EXPECT_THAT(input.schema.channels, ElementsAre("p1", "p2", "p3", "p5", "p4", "p8", "p12"));
  EXPECT_THAT(input.schema.sources, ElementsAre(0, 0, 0, 0, 3, 7, 11));
  EXPECT_THAT(input.schema.rotations[0].columns.places, ElementsAre(0, 1, 2, 4, 5, 6, 8, 9, 10));
  options.shown.emplace();
  EXPECT_THAT(opened(kitti, options, true).schema.channels, ElementsAre("qx", "qy", "qz", "qw", "p4", "p8", "p12"));
}

}  // namespace
}  // namespace tcb
