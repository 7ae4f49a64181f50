// Labels: a row has those of its key, or of the key before it; the texts around them; what is forgotten.
#include "output/labels.hpp"

#include <gtest/gtest.h>

#include "keys.hpp"

namespace tcb {
namespace {

SampleBlock batch_on(std::vector<std::uint64_t> pieces) {
  SampleBlock batch;
  for (const std::uint64_t number : pieces) {
    CurveSegment piece;
    piece.start = {static_cast<double>(number)};
    piece.end = {static_cast<double>(number + 1)};
    piece.number = number;
    piece.end_key = number + 1;
    batch.parts.push_back({piece, 0, 1});
  }
  return batch;
}

TEST(Labels, a_segment_has_those_of_its_first_key_and_its_end_those_of_its_last) {
  for (const bool forget : {false, true}) {
    const auto labels = std::make_shared<Labels>(1);
    const auto keys = Labels::heard(labels, keys_of("0 0 g a\n1 0 g b\n2 0 g c\n3 0 g d\n", 2));
    while (keys()) {
    }
    std::vector<SampleBlock> left{batch_on({2}), batch_on({0, 1})};
    if (forget) std::swap(left[0], left[1]);
    const Source<SampleBlock> batches = [&]() -> std::optional<SampleBlock> {
      if (left.empty()) return std::nullopt;
      SampleBlock batch = left.front();
      left.erase(left.begin());
      return batch;
    };
    const auto joined = Labels::joined(
        labels, batches, [](std::span<const std::string_view> texts) { return "<" + std::string(texts[0]) + ">"; },
        forget);
    std::string all;
    while (const auto labelled = joined()) {
      for (const auto& [inside, end] : labelled->ends) all += inside + end;
    }
    EXPECT_EQ(all, forget ? "<a><b><b><c><c><d>" : "<c><d><a><b><b><c>");
  }
}

TEST(Labels, a_closed_curve_comes_back_to_the_first) {
  const auto labels = std::make_shared<Labels>(0);
  const auto keys = Labels::heard(labels, keys_of("0 0 a\n1 0 b\n2 0 c\n3 0 d\n", 1));
  while (keys()) {
  }
  SampleBlock round = batch_on({0, 1, 2, 3});
  round.parts.back().segment.end_key = 0;
  const auto joined = Labels::joined(
      labels, [left = std::optional(round)]() mutable { return std::exchange(left, std::nullopt); },
      [](std::span<const std::string_view> texts) { return std::string(texts[0]); }, true);
  const auto labelled = joined();
  EXPECT_EQ(labelled->ends[2], (std::pair<std::string, std::string>{"c", "d"}));
  EXPECT_EQ(labelled->ends[3], (std::pair<std::string, std::string>{"d", "a"}));
}

}  // namespace
}  // namespace tcb
