// Cells with several numbers: which become cells of their own, and which stay as they are.
#include "read/csv/vector_cells.hpp"

#include <gtest/gtest.h>

#include <deque>
#include <string>
#include <utility>
#include <vector>

#include "read/reading.hpp"

namespace tcb {
namespace {

/// The text with a cell for each number of a vector, of which the first `size` bytes are a chunk, and the rest another.
std::string spread_in_two(const std::string& text, std::size_t size, char delimiter = ',') {
  std::deque<Chunk> parts;
  parts.push_back({text.substr(0, size), 1});
  if (size < text.size()) parts.push_back({text.substr(size), 2});
  Source<Chunk> chunks = each_of(std::move(parts));
  (void)take_vectors(chunks, {delimiter});
  std::string result;
  while (const std::optional<Chunk> chunk = chunks()) result += chunk->text;
  return result;
}

std::string spread(const std::string& text, char delimiter = ',') {
  return spread_in_two(text, text.size(), delimiter);
}

TEST(VectorCells, each_number_is_a_cell_at_its_place) {
  EXPECT_EQ(spread("t,p\n0,\"(1.0, -2.5e3)\"\n"), "t,\"p.x\",\"p.y\"\n0,  1.0, -2.5e3  \n");
  EXPECT_EQ(spread("0,[1 2 3],5\n"), "0,[1 2 3],5\n");  // a single row may be names
  EXPECT_EQ(spread("0,[1 2 3],5\n1,[4 5 6],7\n"), "0, 1,2,3 ,5\n1, 4,5,6 ,7\n");
  EXPECT_EQ(spread("t;p\r\n0;(X=1,Y=2,Z=3,W=4)\r\n", ';'),
            "t;\"p.x\";\"p.y\";\"p.z\";\"p.w\"\r\n0;   1;  2;  3;  4 \r\n");
  EXPECT_EQ(spread("\"a b\",t\n{1;2},0\n"), "\"a b.x\",\"a b.y\",t\n 1,2 ,0\n");
}

TEST(VectorCells, tabs_may_delimit) {
  EXPECT_EQ(spread("t\tn\tp\n0\t\t(1, 2)\n1\ta\t (3, 4) \n", '\t'),
            "t\tn\t\"p.x\"\t\"p.y\"\n0\t\t 1\t 2 \n1\ta\t  3\t 4  \n");
}

TEST(VectorCells, names_and_rows_may_be_in_several_chunks) {
  const std::string text = "# p\n\nt,p\n0,(1,2)\n1,(3,4)\n";
  EXPECT_EQ(spread_in_two(text, 9), spread(text));
  EXPECT_EQ(spread_in_two(text, 17), "# p\n\nt,\"p.x\",\"p.y\"\n0, 1,2 \n1, 3,4 \n");
}

TEST(VectorCells, other_cells_stay_as_they_are) {
  for (const std::string text :
       {"t,p\n0,(1)\n", "t,p\n0,(1,x)\n", "t,p\n0,(1,2\n", "t,p\n0,(1,2) m\n", "t,p\n0,\"(1,2\"\n", "(1,2)\n(3,4)\n",
        "t,p\n0,(0,5, 1,5)\n", "t,p\n0,\"(1;2,3)\"\n", "t,p\n0,[1,5 2,5]\n", "t,p\n0,(1,,2)\n", "t,p\n0,(1,2,)\n",
        "t,p\n0,(,1,2)\n", "t,p\n0,(X=1Y=2)\n", "t\n0,(1,2)\n", "t,p\n0,\"say \"\"hi\"\", (1,2), ok\"\n"}) {
    EXPECT_EQ(spread(text), text);
  }
  EXPECT_EQ(spread("0 (1,2)\n1 (3,4)\n", ' '), "0 (1,2)\n1 (3,4)\n");
  EXPECT_EQ(spread("t,p,n\n0,(1,2),\"say \"\"hi\"\", (1,2), ok\"\n"),
            "t,\"p.x\",\"p.y\",n\n0, 1,2 ,\"say \"\"hi\"\", (1,2), ok\"\n");
  // Another number of them than in the first row, also where the row has as many in all.
  EXPECT_EQ(spread("t,p,q\n0,(1,2),(1,2,3)\n1,(1,2,3),(1,2)\n"),
            "t,\"p.x\",\"p.y\",\"q.x\",\"q.y\",\"q.z\"\n0, 1,2 , 1,2,3 \n1,(1,2,3),(1,2)\n");
}

TEST(VectorCells, a_request_names_the_numbers) {
  InputOptions options;
  options.columns.roles = {{Role::time, {"1"}}, {Role::position, {"a", "p"}}, {Role::unused, {"q"}}};
  const std::vector<VectorColumn> vectors{{1, "p", {"p.x", "p.y"}}};
  const auto roles = with_vectors(options, vectors).columns.roles;
  EXPECT_EQ(roles[0].columns, std::vector<std::string>{"1"});
  EXPECT_EQ(roles[1].columns, (std::vector<std::string>{"a", "p.x", "p.y"}));
  EXPECT_EQ(roles[2].columns, std::vector<std::string>{"q"});
}

TEST(VectorCells, a_number_from_the_first_vector_on_is_refused) {
  const std::vector<VectorColumn> vectors{{1, "p", {"p.x", "p.y"}}};
  const auto refuses = [&](const InputOptions& options) {
    const std::string message = error_of([&] { (void)with_vectors(options, vectors); });
    return message.find("column 3 is not clear by its number") != std::string::npos;
  };
  InputOptions role, rotation, angle;
  role.columns.roles = {{Role::position, {"3"}}};
  rotation.rotation.requests = {{.columns = {"3"}}};
  angle.rotation.angles = {{"3"}};
  EXPECT_TRUE(refuses(role));
  EXPECT_TRUE(refuses(rotation));
  EXPECT_TRUE(refuses(angle));
}

}  // namespace
}  // namespace tcb
