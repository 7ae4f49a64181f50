// Rows: blocks of samples in order, whatever the blocks of segments, and numbers beyond doubles are refused.
#include "sample/rows.hpp"
#include "sample/build.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <utility>
#include <vector>

#include "error.hpp"
#include "sample/sampler.hpp"

namespace tcb {
namespace {

/// Segments of one channel x = t^2 / 4 between keys at 0, 1, ... `count`, `size` of them in a block.
Source<SegmentBlock> segments(std::size_t count, std::size_t size, double scale = 1) {
  return [=, next = std::size_t{0}]() mutable -> std::optional<SegmentBlock> {
    if (next == count) return std::nullopt;
    SegmentBlock block{{1, {static_cast<double>(next)}, {}, {}}, {}, false, false};
    for (const std::size_t end = std::min(next + size, count); next < end; ++next) {
      const auto t = static_cast<double>(next);
      const auto x = [&](double at) { return scale * at * at / 4; };
      block.segments.cubics.push_back(spline::cubic<double>(x(t), x(t + 1), scale * t / 2, scale * (t + 1) / 2));
      block.segments.times.emplace_back(t + 1);
    }
    block.last = next == count;
    return block;
  };
}

std::vector<double> cells(const Source<SegmentBlock>& source, std::vector<std::uint64_t>* sizes = nullptr) {
  SamplingRequest request;
  request.step = Rational(1, 256);
  const std::shared_ptr<Sampler> sampler = make_sampler(request, {0.0, {}, {}});
  const auto blocks = place(source, sampler, {});
  std::vector<double> all;
  bool first = true;
  while (const auto block = blocks()) {
    if (block->parts.empty()) continue;
    EXPECT_EQ(block->first, std::exchange(first, false));
    if (sizes != nullptr) sizes->push_back(block->rows());
    const std::array chosen{std::size_t{0}, std::size_t{1}};
    for (const Cell& cell : evaluate(*block, *sampler, chosen)) all.push_back(cell.hi);
  }
  return all;
}

TEST(Rows, blocks_of_segments_do_not_matter) {
  std::vector<std::uint64_t> sizes;
  const std::vector<double> whole = cells(segments(9, 9), &sizes);
  EXPECT_EQ(whole.size(), 2U * (9 * 256 + 1));
  for (std::size_t i = 0; i < whole.size(); i += 2) EXPECT_EQ(whole[i + 1], whole[i] * whole[i] / 4);
  for (const std::uint64_t size : sizes) EXPECT_LE(size, SampleBlock::most_rows);
  for (const std::size_t size : {1U, 2U, 5U}) EXPECT_EQ(cells(segments(9, size)), whole);
}

TEST(Rows, numbers_beyond_doubles_are_refused) {
  try {
    cells(segments(9, 9, std::numeric_limits<double>::max()));
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(error.message().find("has a number beyond the range of doubles"), std::string::npos);
    EXPECT_EQ(error.exit(), Exit::data);
  }
}

}  // namespace
}  // namespace tcb
