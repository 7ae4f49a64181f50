// Tables in JSON: which texts are tables, and the list that each form gives.
#include "read/json/tables.hpp"

#include <gtest/gtest.h>

#include <string>

#include "error.hpp"

namespace tcb {
namespace {

/// The list of a table in parts of a size; "none" for other texts, whose bytes have to stay.
std::string list_of_text(const std::string& text, std::size_t size) {
  Source<std::string> bytes = [&text, size, at = std::size_t{0}]() mutable -> std::optional<std::string> {
    if (at >= text.size()) return std::nullopt;
    return text.substr(std::exchange(at, at + size), size);
  };
  const std::optional<JsonTable> table = take_table(bytes);
  if (table) return (table->has_times_in_index ? "by index: " : "") + table->list;
  std::string all;
  while (const auto part = bytes()) all += *part;
  EXPECT_EQ(all, text);
  return "none";
}

void expect_list(const std::string& text, const std::string& list) {
  for (const std::size_t size : {1U, 7U, 1000U}) EXPECT_EQ(list_of_text(text, size), list) << text << " by " << size;
}

TEST(JsonTables, all_forms_give_the_same_list) {
  const std::string list = R"([{"t":0,"x":1.50},{"t":1,"x":2}])";
  expect_list("[[0,1.50],[1,2]]", list);
  expect_list(R"({"columns":["t","x"],"index":[0,1],"data":[[0,1.50],[1,2]]})", list);
  expect_list(R"({"index":[0,1],"columns":["t","x"],"data":[[0,1.50],[1,2]]})", list);
  expect_list(R"({"schema":{"fields":[]},"data":[{"index":0,"t":0,"x":1.50},{"index":1,"t":1,"x":2}]})", list);
  expect_list(R"( {"t" : {"0":0,"1":1}, "x" : {"0":1.50,"1":2}})", list);
  expect_list(R"({"0":{"t":0,"x":1.50},"1":{"t":1,"x":2}})", list);
  expect_list(R"({"t":[0,1],"x":[1.50,2]})", list);
}

TEST(JsonTables, an_index_that_is_no_count_is_the_time) {
  expect_list(R"({"x":{"0.5":1,"1.50":2}})", R"(by index: [{"time":0.5,"x":1},{"time":1.50,"x":2}])");
  expect_list(R"({"x":{"2024-01-01":1}})", R"(by index: [{"time":"2024-01-01","x":1}])");
  expect_list(R"({"columns":["x"],"index":[0,1],"data":[[1],[2]]})", R"([{"x":1},{"x":2}])");
  expect_list(R"({"columns":["t"],"index":[5],"data":[[1]]})", R"([{"t":1}])");
}

TEST(JsonTables, cells_may_be_texts_arrays_or_missing) {
  expect_list(R"({"t":[0],"position":[[1,2]],"name":["a\"b"]})", R"([{"t":0,"position":[1,2],"name":"a\"b"}])");
  expect_list(R"({"t":{"0":0,"1":1},"x":{"1":2}})", R"([{"t":0,"x":null},{"t":1,"x":2}])");
}

TEST(JsonTables, columns_without_names_are_t_and_x_y_z) {
  expect_list("[[0,1,2,3]]", R"([{"t":0,"x":1,"y":2,"z":3}])");
  expect_list("[[0,1,2,3,4]]", R"([{"t":0,"p1":1,"p2":2,"p3":3,"p4":4}])");
}

TEST(JsonTables, other_texts_stay) {
  for (const char* text :
       {"", "[", "[]", "{", "{}", R"([{"t":0,"x":1}])", R"({"keys":[{"t":0}]})", R"({"curves":[]})", "0",
        R"({"channels":["x","y"],"keys":[{"time":0,"position":[1,2]}]})", R"({"time":0,"position":[1,2]})",
        R"({"position":[1,2],"time":0})", R"({"tcb":{"x":[0,0,0]},"time":0,"x":1})", R"({"x":[0,"a\"],[",1]})",
        "[[0,1]", "[[[[[[[[[[[[0"}) {
    expect_list(text, "none");
  }
}

TEST(JsonTables, incomplete_ones_are_refused) {
  for (const char* text :
       {R"({"t":[0,1],"x":[1]})", "[[0,1],[2]]", R"({"columns":["t"],"index":[0]})", R"({"schema":{"fields":[]}})"}) {
    EXPECT_THROW(list_of_text(text, 100), Error) << text;
  }
}

}  // namespace
}  // namespace tcb
