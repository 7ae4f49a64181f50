// Doubts: small inputs, and the note or the error that each of them causes.
#include "schema/doubts.hpp"

#include <gmock/gmock.h>

#include "read/reading.hpp"
#include "schema/usual_names.hpp"

namespace tcb {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// The notes of an input, a line each, or its error.
std::string doubts_of(const std::string& text, const InputOptions& options = {}) {
  std::string notes;
  const std::string error = error_of([&] {
    for (const std::string& note : open_input("f", pieces(text), options).facts.doubts) notes += note + "\n";
  });
  return error == "no error" ? notes : error;
}

struct Row {
  std::string text, words;
};

TEST(Doubts, are_notes_where_one_reading_is_plain) {
  for (const Row& row : std::initializer_list<Row>{
           {"time,T,RH\n0,21.5,40\n1,21.9,41\n", "positions by a single letter: T;"},
           {"time,R,G,B\n0,255,0,0\n1,0,255,0\n", "--columns bias=B gives the role"},
           {",time,x\n0,0,5\n1,1,6\n", "column 1 counts the rows"},
           {"index,t,x\n1,0,5\n2,1,6\n", "column \"index\" counts the rows"},
           {",x\n2024-03-01,5\n2024-03-02,6\n", "column 1 are taken as the times"},
           {"BaseDateTime,LAT\n2024-03-01T00:00:00,5\n2024-03-01T00:01:00,6\n",
            "the dates in column \"BaseDateTime\" are taken as the times"},
           {"DATE,TIME,x\n2024-03-01,08:00:00,5\n2024-03-01,09:00:00,6\n", "are taken as one time"},
           {"t,x\ns,mm\n0,5\n1,6\n", "the line below the names is taken as units: s, mm"},
           {"0,9,1,0,0,0\n1,8,0,1,0,0\n", "columns 3, 4, 5, 6 may be a quaternion; --rotation quaternion=3:4:5:6"},
           {"t,x\nTS,V\n\"\",Avg\n0,5\n1,6\n", "the line below the names is taken as units: TS, V"},
           {"t,rvec_x,rvec_y,rvec_z\n0,0,0,1\n1,0,1,0\n", "--rotation axis-angle=rvec_x:rvec_y:rvec_z"},
           {"\"#\",\"Date Time, GMT\",x\n1,2024-05-01 10:00,5\n2,2024-05-01 11:00,6\n", "column \"#\" counts the rows"},
           {"year,month,day,x\n2024,5,1,3\n2024,5,2,4\n", "columns year, month, day are taken as one time"},
           {"t,x\n1:30,5\n2:00,6\n", "times such as \"1:30\" are taken as minutes and seconds"},
       }) {
    EXPECT_THAT(doubts_of(row.text), HasSubstr(row.words)) << row.text;
    EXPECT_EQ(doubts_of(row.text).find("error:"), std::string::npos) << row.text;
  }
}

TEST(Doubts, are_errors_where_readings_give_different_numbers) {
  for (const Row& row : std::initializer_list<Row>{
           {"t,x,tensoin_x\n0,1,2\n1,2,3\n", "give --columns tension_x=tensoin_x if that is so"},
           {"t,x,T,C,B\n0,1,20,30,40\n1,2,21,31,41\n", "--columns position=x:T:C:B for channels, --tcb-scale none"},
           {"t,x,tension\n0,1,120\n1,2,125\n", "--columns position=x:tension for channels"},
           {"t,x,tension,continuity,bias\n0,1,25,50,25\n1,2,30,25,0\n", "--tcb-scale 3dsmax"},
           {",x,y\n0,1,2\n1,2,3\n", "give --columns time=1 if it is the time"},
           {"aDateTime,bDateTime,LAT\n2024-03-01,2024-03-01,6\n2024-03-02,2024-03-02,7\n", "--columns time=aDateTime"},
           {"sensor_time,x\n0,5\n0,6\n", "--columns time=sensor_time"},
           {"%time,header.stamp,x\n5,5,1\n6,6,2\n", "give --columns time=%time or --columns time=header.stamp"},
           {"t,w,x,y,z\n0,1,0,0,0\n1,0,1,0,0\n", "--rotation quaternion=x:y:z:w for a rotation"},
           {"t,x,x_tens\n0,1,2\n1,2,3\n", "give --columns tension_x=x_tens if that is so"},
           {"t,q[0],q[1],q[2],q[3]\n0,1,0,0,0\n1,0,1,0,0\n", "'quaternion=q[1]:q[2]:q[3]:q[0]'"},
           {"a:b,id,x\n1,1,2\n2,1,3\n", "give --group id"},
           {"DATE,x\n20240301,5\n20240302,6\n", "numbers such as 20240301; expected dates such as 2024-03-01"},
           {"Machine\t\nOrder\t7\nX\tV\n0.0\t1.5\n0.1\t1.7\n", "give --skip-lines 2"},
           {"title of all\n0.0\t1.5\n0.1\t1.7\n0.2\t1.8\n", "give --skip-lines 1"},
           {"\"A\",\"1\"\n\"TS\",\"x\"\n\"TS\",\"V\"\n\"\",\"Avg\"\n0,5\n1,6\n", "give --skip-lines 1"},
           {"t,lon\n0,26.9W\n1,27.1W\n", "\"26.9W\" is not a number"},
           {"Title\nof two words\nt,x\n0,1\n1,2\n", "give --skip-lines 2"},
       }) {
    EXPECT_THAT(doubts_of(row.text), HasSubstr(row.words)) << row.text;
    EXPECT_NE(doubts_of(row.text).find("error:"), std::string::npos) << row.text;
  }
}

TEST(Doubts, of_names_of_one_other_letter_than_a_role) {
  for (const char* name : {"tme", "ime", "tmie", "frmae", "ease_im"}) {
    EXPECT_THAT(doubts_of(std::string(name) + ",x\n0,0.5\n1,0.7\n"), HasSubstr("is close to the role")) << name;
  }
  for (const char* name : {"Tensoin", "tenison", "rension", "tenssion", "ension", "biass", "Bais_X"}) {
    EXPECT_THAT(doubts_of(std::string(name) + ",x\n0,0.5\n1,0.7\n"),
                HasSubstr("column " + std::string(name) + " may be"))
        << name;
  }
  for (const char* name : {"torsion", "extension", "tensor", "version", "bits", "bins", "tide", "dime", "bias1",
                           "time2", "game", "period", "temp", "timer2", "carry", "tensor_x", "x_T", "x_y", "time_x"}) {
    EXPECT_EQ(doubts_of("t,x," + std::string(name) + "\n0,0.5,0\n1,0.7,0\n"), "") << name;
  }
}

TEST(Doubts, are_none_where_the_request_or_the_input_decides) {
  EXPECT_EQ(doubts_of("t,x,T,C,B\n0,1,0.5,0,0\n1,2,0,0,-1\n"), "");
  EXPECT_EQ(doubts_of("t,x,tension,bias\n0,1,20,-30\n1,2,12,9\n"), "") << "as keys of fits have them";
  EXPECT_EQ(doubts_of("0,1,2\n1,2,3\n2,3,4\n"), "") << "numbers in steps of one";
  EXPECT_EQ(doubts_of("t,x,tension\n0,1,120\n1,2,125\n", with_columns("position=x:tension")), "");
  EXPECT_EQ(doubts_of("1700000000,100000000,1\n1700000001,200000000,2\n", with_columns("time=1")), "");
  InputOptions options;
  options.keys.tcb_scale = TcbScale::max3ds;
  EXPECT_EQ(doubts_of("t,x,tension,continuity,bias\n0,1,25,50,25\n1,2,30,25,0\n", options), "");
  options = {};
  options.rotation.none = true;
  EXPECT_EQ(doubts_of("t,w,x,y,z\n0,1,0,0,0\n1,0,1,0,0\n", options), "");
}

TEST(Doubts, a_column_of_texts_labels_curves_if_times_increase_beside_each_of_them) {
  const auto label = [](const std::string& rows) {
    return open_input("f", pieces("t,x,name\n" + rows), {}).keys.traits.label;
  };
  EXPECT_EQ(label("0,1,a\n0,1,b\n1,1,a\n1,1,b\n"), "name");
  EXPECT_EQ(label("0,1,a\n2,1,a\n1,1,b\n3,1,b\n"), "name");
  EXPECT_EQ(label("0,1,a\n2,1,a\n1,1,a\n3,1,b\n"), "");
  EXPECT_EQ(label("0,1,a\n2,1,b\n1,1,c\n3,1,d\n"), "") << "one each";
  EXPECT_EQ(label("0,1,a\n1,1,a\n2,1,a\n"), "") << "one for all";
  EXPECT_EQ(label("0,1,a\n1,1,b\n2,1,a\n"), "") << "times increase over all";
  EXPECT_EQ(label("2024-01-01,1,a\n2024-01-03,1,a\n2024-01-01,1,b\n2024-01-02,1,b\n"), "name");
  EXPECT_EQ(label("30.01.2024,1,a\n02.02.2024,1,a\n31.01.2024,1,b\n01.02.2024,1,b\n"), "name") << "day, month, year";
  EXPECT_EQ(label("0:10,1,a\n0:20,1,a\n0:05,1,b\n0:15,1,b\n"), "name");
}

TEST(Doubts, lengths_measure_space_where_channels_name_it) {
  EXPECT_THAT(spatial_channels({"x", "y", "z", "fov"}), ElementsAre(0, 1, 2));
  EXPECT_THAT(spatial_channels({"v", "pos_x", "pos_y"}), ElementsAre(1, 2));
  EXPECT_THAT(spatial_channels({"X [m]", "Y [m]", "w"}), ElementsAre(0, 1));
  EXPECT_THAT(spatial_channels({"x", "y"}), ElementsAre()) << "there are no others";
  EXPECT_THAT(spatial_channels({"vx", "vy", "fov"}), ElementsAre());
}

TEST(Doubts, about_requests) {
  Schema schema;
  schema.named = true;
  schema.time = {.is_given = true};
  schema.channels = {"x", "y", "fov"};
  EXPECT_THAT(doubts_of_request(schema, {.lengths = true}), ElementsAre(HasSubstr("measure x, y, without fov")));
  EXPECT_THAT(doubts_of_request(schema, {.lengths = true, .chooses_metric = true}), ElementsAre());
  EXPECT_THAT(doubts_of_request(schema, {}), ElementsAre());
  schema.channels = {"speed", "weight"};
  EXPECT_THAT(doubts_of_request(schema, {.lengths = true}), ElementsAre(HasSubstr("all channels together")));
  schema.channels = {"lat", "lon"};
  EXPECT_THAT(error_of([&] { (void)doubts_of_request(schema, {.lengths = true}); }), HasSubstr("--metric lat,lon"));
  EXPECT_THAT(error_of([&] { (void)doubts_of_request(schema, {.step = 1.0 / 60, .time_gap = 33}); }),
              HasSubstr("--time-unit ms"));
}

}  // namespace
}  // namespace tcb
