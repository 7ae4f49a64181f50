// The writer: outputs of several files and curves, with provenance, and heads that are counted at the end.
#include "write/writer.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "error.hpp"
#include "formats/formats.hpp"

namespace tcb {

namespace {

/// Options for the fields time and position.
WriterOptions options_of(std::string_view format) {
  WriterOptions options;
  options.format = find_format(format);
  options.fields = {0, 1};
  return options;
}

Schema schema_with(const std::string& channel) {
  Schema schema;
  schema.named = schema.time.is_given = true;
  schema.channels = {channel};
  return schema;
}

/// An output of two curves with one row each; each row of `channels` is the input of a file.
std::string written(const WriterOptions& options, const std::vector<std::string>& channels) {
  const auto path = std::filesystem::temp_directory_path() / ("tcbsample_writer_" + std::to_string(::getpid()));
  std::string text;
  {
    Writer writer(options, path.string());
    double number = 0;
    for (const std::string& channel : channels) {
      writer.begin(schema_with(channel), false, {{"tangents", "tcb"}});
      writer.begin_curve({});
      const std::string row = writer.print({{Cell(number), Cell(0.5)}}, true);
      writer.write([left = std::optional(row)]() mutable { return std::exchange(left, std::nullopt); });
      ++number;
    }
    writer.commit();
  }
  std::ostringstream content;
  content << std::ifstream(path, std::ios::binary).rdbuf();
  std::filesystem::remove(path);
  return content.str();
}

TEST(Writer, curves_of_several_files_are_one_table) {
  EXPECT_EQ(written(options_of("csv"), {"x", "x"}), "t,x\n0,0.5\n\n1,0.5\n");
  EXPECT_EQ(written(options_of("json"), {"x", "x"}), "[\n{\"t\":0,\"x\":0.5},\nnull,\n{\"t\":1,\"x\":0.5}\n]\n");
}

TEST(Writer, files_have_the_same_columns) { EXPECT_THROW(written(options_of("csv"), {"x", "y"}), Error); }

TEST(Writer, provenance_is_around_the_rows_or_a_member_after_them) {
  WriterOptions options = options_of("csv");
  options.provenance.emplace();
  options.provenance->meta.program = "tcbsample 1";
  EXPECT_EQ(written(options, {"x"}),
            "# tcbsample 1\n# tangents: tcb\n#\nt,x\n0,0.5\n# curves: 0\n# keys: 0\n# rows: 0\n");
  const std::string member =
      "\"meta\":{\"program\":\"tcbsample 1\",\"tangents\":\"tcb\",\"options\":[],\"inputs\":[],"
      "\"curves\":0,\"keys\":0,\"rows\":0}";
  options.format = find_format("json");
  EXPECT_EQ(written(options, {"x"}), "{\"rows\":[\n{\"t\":0,\"x\":0.5}\n],\n" + member + "}\n");
  options.format = find_format("jsonl");
  EXPECT_EQ(written(options, {"x"}), "{\"t\":0,\"x\":0.5}\n{" + member + "}\n");
}

TEST(Writer, the_head_of_a_binary_output_has_the_number_of_rows) {
  const std::string bytes = written(options_of("npy"), {"x"});
  EXPECT_EQ(bytes.size(), 128U + 16U);
  EXPECT_NE(bytes.find("'shape': (1, 2), }"), std::string::npos);
}

}  // namespace

}  // namespace tcb
