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
#include "keys.hpp"

namespace tcb {

namespace {

SampleBlock samples_on(std::vector<std::uint64_t> segments) {
  SampleBlock block;
  for (const std::uint64_t number : segments) {
    CurveSegment segment;
    segment.start = {static_cast<double>(number)};
    segment.end = {static_cast<double>(number + 1)};
    segment.number = number;
    segment.end_key = number + 1;
    block.parts.push_back({segment, 0, 1});
  }
  return block;
}

TEST(Labels, a_segment_has_the_labels_of_its_first_key_and_its_end_those_of_its_last) {
  for (const bool forget : {false, true}) {
    const auto labels = std::make_shared<Labels>(1);
    const auto keys = Labels::observe(labels, keys_of("0 0 g a\n1 0 g b\n2 0 g c\n3 0 g d\n", 2));
    while (keys()) {
    }
    std::vector<SampleBlock> left{samples_on({2}), samples_on({0, 1})};
    if (forget) std::swap(left[0], left[1]);
    const Source<SampleBlock> blocks = [&]() -> std::optional<SampleBlock> {
      if (left.empty()) return std::nullopt;
      SampleBlock block = left.front();
      left.erase(left.begin());
      return block;
    };
    const auto attached = Labels::attach(
        labels, blocks, [](std::span<const std::string_view> texts) { return "<" + std::string(texts[0]) + ">"; },
        forget);
    std::string all;
    while (const auto labelled = attached()) {
      for (const auto& [inside, end] : labelled->ends) all += inside + end;
    }
    EXPECT_EQ(all, forget ? "<a><b><b><c><c><d>" : "<c><d><a><b><b><c>");
  }
}

TEST(Labels, a_closed_curve_returns_to_the_first_labels) {
  const auto labels = std::make_shared<Labels>(0);
  const auto keys = Labels::observe(labels, keys_of("0 0 a\n1 0 b\n2 0 c\n3 0 d\n", 1));
  while (keys()) {
  }
  SampleBlock round = samples_on({0, 1, 2, 3});
  round.parts.back().segment.end_key = 0;
  const auto attached = Labels::attach(
      labels, [left = std::optional(round)]() mutable { return std::exchange(left, std::nullopt); },
      [](std::span<const std::string_view> texts) { return std::string(texts[0]); }, true);
  const auto labelled = attached();
  EXPECT_EQ(labelled->ends[2], (std::pair<std::string, std::string>{"c", "d"}));
  EXPECT_EQ(labelled->ends[3], (std::pair<std::string, std::string>{"d", "a"}));
}

/// Options for the fields time and position.
WriterOptions options_of(FormatId format) {
  WriterOptions options;
  options.format = format;
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
  EXPECT_EQ(written(options_of(FormatId::csv), {"x", "x"}), "t,x\n0,0.5\n\n1,0.5\n");
  EXPECT_EQ(written(options_of(FormatId::json), {"x", "x"}),
            "[\n{\"t\":0,\"x\":0.5},\nnull,\n{\"t\":1,\"x\":0.5}\n]\n");
}

TEST(Writer, files_have_the_same_columns) { EXPECT_THROW(written(options_of(FormatId::csv), {"x", "y"}), Error); }

TEST(Writer, provenance_is_around_the_rows_or_a_member_after_them) {
  WriterOptions options = options_of(FormatId::csv);
  options.provenance.emplace();
  options.provenance->meta.program = "tcbsample 1";
  EXPECT_EQ(written(options, {"x"}),
            "# tcbsample 1\n# tangents: tcb\n#\nt,x\n0,0.5\n# curves: 0\n# keys: 0\n# rows: 0\n");
  const std::string member =
      "\"meta\":{\"program\":\"tcbsample 1\",\"tangents\":\"tcb\",\"options\":[],\"inputs\":[],"
      "\"curves\":0,\"keys\":0,\"rows\":0}";
  options.format = FormatId::json;
  EXPECT_EQ(written(options, {"x"}), "{\"rows\":[\n{\"t\":0,\"x\":0.5}\n],\n" + member + "}\n");
  options.format = FormatId::jsonl;
  EXPECT_EQ(written(options, {"x"}), "{\"t\":0,\"x\":0.5}\n{" + member + "}\n");
}

TEST(Writer, the_head_of_a_binary_output_has_the_number_of_rows) {
  const std::string bytes = written(options_of(FormatId::npy), {"x"});
  EXPECT_EQ(bytes.size(), 128U + 16U);
  EXPECT_NE(bytes.find("'shape': (1, 2), }"), std::string::npos);
}

}  // namespace

}  // namespace tcb
