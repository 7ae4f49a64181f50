// Frame: groups, divided curves, and another member of JSON around the rows.
#include "write/frame.hpp"

#include <gtest/gtest.h>

#include "error.hpp"
#include "formats/formats.hpp"

namespace tcb {
namespace {

struct CurveRows {
  std::vector<std::string> group;
  std::vector<std::pair<double, std::string>> rows;  ///< a number and a label
};

/// An output with these curves. Labels are written only where `labelled`.
std::string written(const std::string& format, const std::vector<CurveRows>& curves, bool labelled,
                    const std::string& member = "") {
  OutputColumns names{{}, {{"x"}}, {}};
  if (!curves.empty()) names.groups.assign(curves[0].group.size(), "id");
  if (labelled) names.labels = {"label"};
  const Format* const chosen = find_format(format);
  Frame frame(names, {chosen, true, {}, !member.empty(), {chosen->delimiter}});
  std::string out = frame.head();
  std::optional<std::vector<std::string>> before;
  for (const CurveRows& curve : curves) {
    out += frame.begin(curve.group, before == curve.group);
    before = curve.group;
    bool first = true;
    for (const auto& [number, label] : curve.rows) {
      Layout layout = frame.layout();
      const std::vector<std::string_view> labels(labelled ? 1 : 0, label);
      layout.row_end = frame.row_end(labels);
      append_rows(out, layout, names.numbers, {Cell(number)}, first && frame.is_first());
      first = false;
    }
    if (!first) frame.set_written();
  }
  return out + frame.tail(member);
}

const std::vector<CurveRows> two{{{"\"a"}, {{1, "\"p"}, {2, ""}}}, {{"7"}, {{3, "\"q,\""}}}};
const std::vector<CurveRows> divided{{{}, {{1, ""}}}, {{}, {{2, ""}}}};

TEST(Frame, a_group_is_in_each_row_of_its_curve) {
  EXPECT_EQ(written("csv", two, true), "id,x,label\na,1,p\na,2,\n7,3,\"q,\"\"\"\n");
  EXPECT_EQ(written("ssv", two, true), "id x label\na 1 p\na 2 NA\n7 3 \"q,\"\"\"\n");
  EXPECT_EQ(written("jsonl", two, true),
            "{\"id\":\"a\",\"x\":1,\"label\":\"p\"}\n{\"id\":\"a\",\"x\":2,\"label\":null}\n"
            "{\"id\":7,\"x\":3,\"label\":\"q,\\\"\"}\n");
}

TEST(Frame, in_json_a_group_is_in_an_object_around_the_rows) {
  EXPECT_EQ(
      written("json", two, false),
      "{\"curves\":[\n{\"id\":\"a\",\"rows\":[\n{\"x\":1},\n{\"x\":2}\n]},\n{\"id\":7,\"rows\":[\n{\"x\":3}\n]}\n]}\n");
  EXPECT_EQ(written("json", {{{"\"a"}, {}}, {{"\"b"}, {}}}, false),
            "{\"curves\":[\n{\"id\":\"a\",\"rows\":[\n]},\n{\"id\":\"b\",\"rows\":[\n]}\n]}\n");
}

TEST(Frame, without_groups_a_line_without_a_row_divides_curves) {
  EXPECT_EQ(written("csv", divided, false), "x\n1\n\n2\n");
  EXPECT_EQ(written("json", divided, false), "[\n{\"x\":1},\nnull,\n{\"x\":2}\n]\n");
  EXPECT_EQ(written("jsonl", divided, false), "{\"x\":1}\nnull\n{\"x\":2}\n");
}

TEST(Frame, parts_of_a_curve_that_breaks_off_are_divided) {
  const std::vector<CurveRows> parts{{{"\"a"}, {{1, ""}}}, {{"\"a"}, {{2, ""}}}, {{"\"b"}, {{3, ""}}}};
  EXPECT_EQ(written("csv", parts, false), "id,x\na,1\n\na,2\nb,3\n");
}

TEST(Frame, in_json_another_member_may_follow_the_rows) {
  const std::string member = "\"meta\":{}";
  EXPECT_EQ(written("json", divided, false, member), "{\"rows\":[\n{\"x\":1},\nnull,\n{\"x\":2}\n],\n\"meta\":{}}\n");
  EXPECT_EQ(written("json", {}, false, member), "{\"rows\":[\n],\n\"meta\":{}}\n");
  EXPECT_EQ(written("json", {{{"\"a"}, {{1, ""}}}}, false, member),
            "{\"curves\":[\n{\"id\":\"a\",\"rows\":[\n{\"x\":1}\n]}\n],\n\"meta\":{}}\n");
}

TEST(Frame, a_table_of_numbers_has_neither_texts_nor_several_curves) {
  EXPECT_THROW(written("npy", two, false), Error);
  EXPECT_THROW(written("npy", divided, true), Error);
  EXPECT_THROW(written("npy", divided, false), Error);
}

}  // namespace
}  // namespace tcb
