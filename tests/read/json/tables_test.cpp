// Tables in JSON: the lists of records in a text, and the cells of each layout.
#include "read/json/tables.hpp"

#include <gmock/gmock.h>

#include "read/json/cells.hpp"
#include "read/reading.hpp"

namespace tcb {
namespace {

/// The rows of a table as NAME=CELL, with the sign ? for a cell that a row does not have.
std::string table_of(const std::string& text) {
  const Json json(text, {}, text.size());
  std::vector<JsonTable> tables = find_tables(json, {});
  if (tables.empty() || !tables[0].path.empty()) return "none";
  const JsonLayout layout = find_layout(json, tables[0], {.columns = {.samples = SampleNames{}}}, {});
  JsonRows rows(json, tables[0], layout);
  std::string shown = tables[0].index.empty() ? "" : "by index: ";
  for (std::size_t row = 0; row < tables[0].size(); ++row) {
    std::vector<std::uint32_t> cells;
    rows.get(row, cells);
    for (std::size_t i = 0; i < cells.size(); ++i) {
      shown += fmt::format("{}={} ", layout.columns[i].path, cells[i] == 0 ? "?" : std::string(json.written(cells[i])));
    }
    shown += "; ";
  }
  return shown;
}

/// The paths of the lists in a text that can be keys, or the error.
std::string paths(const std::string& text, std::string_view records = "") {
  std::string shown;
  const Json json(text, {}, text.size());
  const std::string error = error_of([&] {
    for (const JsonTable& table : find_tables(json, {.records = std::string(records)})) shown += table.path + " ";
  });
  return error == "no error" ? shown : error;
}

TEST(JsonTables, all_layouts_have_the_same_cells) {
  const std::string rows = "t=0 x=1.50 ; t=1 x=2 ; ";
  EXPECT_EQ(table_of("[[0,1.50],[1,2]]"), rows);
  EXPECT_EQ(table_of(R"({"columns":["t","x"],"index":[0,1],"data":[[0,1.50],[1,2]]})"), rows);
  EXPECT_EQ(table_of(R"({"index":[0,1],"columns":["t","x"],"data":[[0,1.50],[1,2]]})"), rows);
  EXPECT_EQ(table_of(R"({"schema":{"fields":[]},"data":[{"index":0,"t":0,"x":1.50},{"t":1,"x":2,"index":1}]})"),
            "index=0 t=0 x=1.50 ; index=1 t=1 x=2 ; ");
  EXPECT_EQ(table_of(R"( {"t" : {"0":0,"1":1}, "x" : {"0":1.50,"1":2}})"), rows);
  EXPECT_EQ(table_of(R"({"0":{"t":0,"x":1.50},"1":{"t":1,"x":2}})"), rows);
  EXPECT_EQ(table_of(R"({"t":[0,1],"x":[1.50,2]})"), rows);
  EXPECT_EQ(table_of("[[0,1,2,3,4]]"), "t=0 p1=1 p2=2 p3=3 p4=4 ; ");
}

TEST(JsonTables, an_index_that_is_no_count_is_the_time) {
  EXPECT_EQ(table_of(R"({"x":{"0.5":1,"1.50":2}})"), R"(by index: time="0.5" x=1 ; time="1.50" x=2 ; )");
  EXPECT_EQ(table_of(R"({"0.5":[1,2],"1.5":[3,4]})"), R"(by index: time="0.5" x=1 y=2 ; time="1.5" x=3 y=4 ; )");
  EXPECT_EQ(table_of(R"({"columns":["x"],"index":[0,1],"data":[[1],[2]]})"), "x=1 ; x=2 ; ");
  EXPECT_EQ(table_of(R"({"columns":["t"],"index":[5],"data":[[1]]})"), "t=1 ; ");
  EXPECT_EQ(table_of(R"({"schema":{},"data":[{"index":0.0,"x":1},{"index":0.5,"x":2}]})"),
            "by index: time=0.0 x=1 ; time=0.5 x=2 ; ");
}

TEST(JsonTables, null_before_the_first_record_is_no_record) {
  EXPECT_EQ(table_of(R"([null,{"t":0,"x":1},{"t":1,"x":2}])"), "t=0 x=1 ; t=1 x=2 ; ");
  EXPECT_EQ(table_of("[null,null,[0,1],[1,2]]"), "t=0 x=1 ; t=1 x=2 ; ");
  EXPECT_EQ(paths(R"({"keys":[null,{"t":0,"x":1}]})"), "keys ");
  EXPECT_EQ(paths(R"({"a":{"points":[null,{"t":0,"x":1},{"t":1,"x":2}]}})"), "a.points ");
  EXPECT_EQ(table_of("[null]"), "none");
}

TEST(JsonTables, cells_that_a_row_does_not_have_take_no_place) {
  EXPECT_EQ(table_of(R"({"t":{"0":0,"1":1},"x":{"1":2},"y":{"1":3,"0":4}})"), "t=0 x=? y=4 ; t=1 x=2 y=3 ; ");
  EXPECT_EQ(table_of(R"({"0":{"t":0},"1":{"t":1,"x":2}})"), "t=0 x=? ; t=1 x=2 ; ");
}

TEST(JsonTables, other_texts_are_none) {
  for (const char* text : {"[]", "{}", R"({"time":0,"position":[1,2]})", R"({"position":[1,2],"time":0})",
                           R"({"tcb":{"x":[0,0,0]},"time":0,"x":1})", R"({"x":[0,"a\"],[",1]})", "[1,2]"}) {
    EXPECT_EQ(table_of(text), "none") << text;
  }
}

TEST(JsonTables, rows_columns_and_indices_that_differ_in_length_are_refused) {
  for (const char* text :
       {R"({"t":[0,1],"x":[1]})", "[[0,1],[2]]",
        R"({"columns":["x","y"],"index":[5],"data":[[0,1],[1,2],[2,3],[3,4]]})",
        R"({"x":{"0":1,"0.5":2,"0.5":7,"1":3}})", R"({"columns":["t"],"columns":["x"],"data":[[0]]})",
        R"({"columns":["t"],"index":{},"data":[[0]]})"}) {
    EXPECT_THROW(table_of(text), Error) << text;
  }
}

TEST(JsonTables, lists_are_found_with_their_paths) {
  EXPECT_EQ(paths(R"({"tracks":[{"times":[0,1],"values":[0,1,2,3]}]})"), "tracks[0] ");
  EXPECT_EQ(paths(R"({"fps":30,"animation":[{"frame":0,"zoom":1},{"frame":24,"zoom":2}]})"), "animation ");
  EXPECT_EQ(paths(R"({"a":{"points":[{"t":0,"p":{"x":1}},{"t":1,"p":{"x":2}}]},"tags":["a"],"size":[1,2]})"),
            "a.points ");
  EXPECT_EQ(paths(R"({"data":{"result":[{"metric":{},"values":[[1,"2"],[3,"4"]]}]}})"), "data.result[0].values ");
  EXPECT_EQ(paths(R"({"b":{"leg":{"rotation":{"0.0":[0,1],"0.5":[1,2]}}}})"), "b.leg.rotation ");
  EXPECT_EQ(paths(R"({"hourly":{"time":["2024-01-01T00:00","2024-01-01T01:00"],"x":[1,2]},"v":1})"), "hourly ");
  EXPECT_EQ(paths(R"({"marks":[{"x":1},{"x":2}],"keys2":[{"t":0,"x":1},{"t":1,"x":1}]})"), "keys2 ")
      << "the only one with times";
  EXPECT_EQ(paths(R"({"curves":[3],"points":[{"t":0,"x":1},{"t":1,"x":2}]})"), "points ");
}

TEST(JsonTables, several_lists_are_an_error_that_names_them) {
  const std::string text = R"({"a":[[0,1],[1,2]],"b":[{"c":[[0,1],[1,3]]}]})";
  EXPECT_EQ(
      paths(text),
      "f:1:1: error: 2 lists may be the keys: a, b[0].c; expected one; give --records a, another one of these, or "
      "a path with * for any name or number, which makes a curve of each list");
  EXPECT_EQ(paths(text, "b[0].c"), "b[0].c ");
  EXPECT_EQ(paths(text, "b[*].c"), "b[0].c ");
  EXPECT_EQ(paths(R"({"m":{"p.q":{"k":[[0,1],[1,2]]},"r":{"k":[[0,1]]}}})", "m.*.k"), "m.p.q.k m.r.k ");
  EXPECT_EQ(paths(R"({"m":{"p.q":{"k":[[0,1],[1,2]]}}})", "m.p.q.k"), "m.p.q.k ");
  EXPECT_EQ(paths(text, "c"),
            "usage: f: error: --records c: there is no such value; expected the path of a list of records, such as a, "
            "b[0].c");
  EXPECT_EQ(
      paths(R"({"a":{"b":5}})", "a.b"),
      "f:1:11: error: a.b: this is not a list of records; expected an array of objects or of rows, or an object of "
      "columns; give another path");
}

TEST(JsonTables, each_path_that_an_error_names_leads_to_one_list) {
  const std::string list = "[[0,1],[1,2]]";
  const auto choice = [](std::string_view listed, std::string_view command, std::string_view all) {
    return fmt::format(
        "f:1:1: error: 2 lists may be the keys: {}; expected one; give --records {}, another one of "
        "these, or {}, which makes a curve of each list",
        listed, command, all);
  };
  const std::string stars = R"({"*":)" + list + R"(,"":)" + list + "}";
  EXPECT_EQ(paths(stars), choice(R"(["*"], [""])", R"('["*"]')", "--records '*'"));
  EXPECT_EQ(paths(stars, R"(["*"])"), "* ");
  EXPECT_EQ(paths(stars, R"([""])"), " ");
  EXPECT_EQ(paths(stars, "*"), "*  ");
  const std::string points = R"({"a.b":{"k":[)" + list + R"(]},"a":{"b":{"k":[)" + list + "]}}}";
  EXPECT_THAT(paths(points),
              testing::HasSubstr(R"(keys: ["a.b"].k[0], a.b.k[0]; expected one; give --records '["a.b"].k[0]', )"));
  EXPECT_EQ(paths(points, R"(["a.b"].k[0])"), "a.b.k[0] ");
  EXPECT_EQ(paths(points, "a.b.k[0]"), "a.b.k[0] ");
  const std::string runs = R"({"a.x":{"k":)" + list + R"(},"a.y":{"k":)" + list + "}}";
  EXPECT_EQ(paths(runs), choice(R"(["a.x"].k, ["a.y"].k)", R"('["a.x"].k')", "--records '*.k'"));
  const std::string empty = R"({"":{"":)" + list + R"(},"b":)" + list + "}";
  EXPECT_THAT(paths(empty), testing::HasSubstr(R"(keys: [""][""], b; expected one; give --records '[""][""]', )"));
  EXPECT_EQ(paths(empty, R"([""][""])"), " ");
  EXPECT_THAT(paths(R"({"a":{"k":)" + list + R"(},"a":{"k":)" + list + "}}"),
              testing::StartsWith("f:1:26: error: a: the object has this member twice"));
}

TEST(JsonTables, files_of_other_products_are_named) {
  EXPECT_NE(paths(R"({"v":"5","fr":30,"ip":0,"op":60,"layers":[{"ks":{}}]})").find("a Lottie animation"),
            std::string::npos);
}

}  // namespace
}  // namespace tcb
