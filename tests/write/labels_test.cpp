// Labels: the texts after rows on segments, at their ends, and on closed curves.
#include "write/labels.hpp"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace tcb
