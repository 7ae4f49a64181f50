// Splitter: chunks of whole records, however the bytes arrive.
#include "read/csv/splitter.hpp"

#include <gmock/gmock.h>

#include "read/csv/records.hpp"

namespace tcb {
namespace {

std::vector<std::string> texts_of(const std::vector<Chunk>& chunks) {
  std::vector<std::string> texts;
  for (const Chunk& chunk : chunks) texts.push_back(chunk.text);
  return texts;
}

const char* const texts[] = {"0,1\n2,3\n",          "0,1\r\n2,3",        "\"a\nb\",1\n\"c\"\"\n\",2\n",
                             "# it\"s\n0,1\n2,3\n", "\n\n0,1\n#\n\n2,3", "0,\"\"\n1,\"a\r\n\r\nb\"\r\n"};

TEST(SplitDelimited, chunks_are_the_text_cut_between_records_with_their_first_lines) {
  for (const std::string text : texts) {
    const RecordTexts whole = table(text);
    for (std::size_t piece = 1; piece <= text.size(); ++piece) {
      std::string joined;
      RecordTexts rows;
      for (const Chunk& chunk : chunks(text, piece)) {
        EXPECT_EQ(chunk.line, 1U + static_cast<std::uint64_t>(std::ranges::count(joined, '\n'))) << text;
        joined += chunk.text;
        for (auto& row : table(chunk.text)) rows.push_back(std::move(row));
      }
      EXPECT_EQ(joined, text);
      EXPECT_EQ(rows, whole) << text << " in pieces of " << piece;
    }
  }
}

TEST(SplitDelimited, quotes_after_a_quoted_cell_open_no_cell) {
  for (const std::string line : {"\"\"a,\"", "\"a\"b,\"c", "\"a\" \r,\"", "\"a\" b\"", "\"\" \"\",\""}) {
    const std::string text = line + "\n1,2\n3,4\n";
    EXPECT_THAT(texts_of(chunks(text, 1)), testing::ElementsAre(line + "\n", "1,2\n", "3,4\n")) << text;
  }
}

TEST(SplitDelimited, a_record_is_passed_on_as_soon_as_its_line_ends) {
  std::vector<std::string> arriving{"3\n", "2,", "0,1\n"};
  const auto source = split_delimited(
      [&]() -> std::optional<std::string> {
        if (arriving.empty()) return std::nullopt;
        std::string piece = arriving.back();
        arriving.pop_back();
        return piece;
      },
      {});
  EXPECT_EQ(source()->text, "0,1\n");
  EXPECT_EQ(arriving.size(), 2U) << "nothing more was pulled";
  EXPECT_EQ(source()->text, "2,3\n");
  EXPECT_FALSE(source());
}

// Splitting and parsing have to agree on which quotes mean something.
TEST(SplitDelimited, a_quote_in_an_indented_comment_or_inside_a_cell_has_no_effect) {
  for (const std::string text : {"  # 5\" tall\n0,\"a\nb\"\n1,c\n", "0,5\"\n1,\"a\nb\"\n2,c\n"}) {
    RecordTexts rows;
    EXPECT_EQ(error_of([&] {
                for (const Chunk& chunk : chunks(text, std::string::npos)) {
                  for (auto& row : table(chunk.text)) rows.push_back(std::move(row));
                }
              }),
              "no error");
    EXPECT_EQ(rows, table(text));
  }
}

TEST(SplitDelimited, a_quote_left_open_is_an_error_at_64_mib) {
  const auto endless = [first = true]() mutable -> std::optional<std::string> {
    return std::exchange(first, false) ? "0,1\n\"" : std::string(16U << 20U, '\n');
  };
  EXPECT_EQ(
      error_of([&] {
        const auto source = split_delimited(endless, {});
        while (source()) {
        }
      }),
      "f:2:1: error: a record has more than 64 MiB; expected a line for each key; break the lines, or close a quote "
      "that was left open");
}

}  // namespace
}  // namespace tcb
