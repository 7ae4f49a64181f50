// Places: lists, ranges, files of numbers, and columns of files as times of samples.
#include "cli/values.hpp"

#include <gmock/gmock.h>

#include "cli/command_line.hpp"
#include "io/file_fixture.hpp"

namespace tcb {
namespace {

using namespace std::string_literals;
using testing::ElementsAre;

class Places : public FileTest {
 protected:
  TypedOptions typed(const std::string& at) const {
    TypedOptions typed;
    store_places(typed, "--at", at);
    read_place_column(typed);
    return typed;
  }
};

TEST_F(Places, are_listed_or_in_ranges) {
  EXPECT_THAT(typed("0,1/2,-1e1").places.list, ElementsAre(Rational(0), Rational(1, 2), Rational(-10)));
  EXPECT_THAT(typed("1:0:-1/3").places.list, ElementsAre(Rational(1), Rational(2, 3), Rational(1, 3), Rational(0)));
}

TEST_F(Places, in_a_file_are_numbers_below_a_header) {
  const TypedOptions options = typed("@" + made("times", "when\n0.1 2\n3,4\n"));
  EXPECT_THAT(options.places.list, ElementsAre(Rational(1, 10), Rational(2), Rational(3), Rational(4)));
}

TEST_F(Places, in_a_file_are_read_as_keys_are) {
  const std::string packed = "\x1f\x8b\x08\0\0\0\0\0\0\x03\x33\xd0\x31\xe4\x02\0\x95\x76\xb0\xc6\x04\0\0\0"s;  // 0,1
  EXPECT_THAT(typed("@" + made("times.gz", packed)).places.list, ElementsAre(Rational(0), Rational(1)));
  EXPECT_THAT(typed("@" + made("marked",
                               "\xEF\xBB\xBF"
                               "0.5\n"))
                  .places.list,
              ElementsAre(Rational(1, 2)));
  EXPECT_THAT(error_of([&] { typed("@" + made("nul", "0,1\n\0"s)); }), testing::HasSubstr("NUL"));
  EXPECT_THAT(error_of([&] { typed("@" + made("quoted", "\"0.5\"\n1\n")); }), testing::HasSubstr("quoted:1: error"));
  EXPECT_THAT(error_of([&] { typed("@" + made("misspelt", "O.5\n1\n")); }),
              testing::HasSubstr("misspelt:1: error: \"O.5\""));
}

TEST_F(Places, in_a_column_keep_all_their_digits_and_their_order) {
  const std::string file = made("a.csv", "x,time\n7,1403637576.252524268\n7,0.1\n");
  const TypedOptions options = typed("@" + file + ":time");
  EXPECT_THAT(options.places.list, ElementsAre(*parse_rational("1403637576.252524268"), Rational(1, 10)));
}

TEST_F(Places, a_name_of_a_file_may_have_a_colon) {
  const std::string file = made("a:b", "1,2\n");
  EXPECT_THAT(typed("@" + file).places.list, ElementsAre(Rational(1), Rational(2)));
  EXPECT_THAT(typed("@" + file + ":2").places.list, ElementsAre(Rational(2)));
}

TEST_F(Places, of_groups_are_kept_by_the_contents_of_their_texts) {
  TypedOptions options;
  options.keys.input.columns.roles.push_back({Role::group, {"id"}});
  store_places(options, "--at", "@" + made("a.json", R"([{"id":"a","t":1},{"id":2,"t":3},{"id":"a","t":0}])") + ":t");
  read_place_column(options);
  EXPECT_THAT(options.places.grouped,
              ElementsAre(testing::Pair(ElementsAre("2"), ElementsAre(Rational(3))),
                          testing::Pair(ElementsAre("a"), ElementsAre(Rational(1), Rational(0)))));
}

}  // namespace
}  // namespace tcb
