// Exact rows are exact numbers rounded once.
#include "exact/exact_rows.hpp"

#include <gtest/gtest.h>

#include <array>

#include "sample/build.hpp"
#include "sample/rows.hpp"
#include "sample/sampler.hpp"
#include "tcb/spline/rules.hpp"

namespace tcb {
namespace {

/// Position and speed of the rows of a request on the line x = t / 3 through three keys.
Table exact_rows(const SamplingRequest& request, const Notation& notation) {
  KeyBlock block;
  block.keys.channels = 1;
  block.keys.times = {0.0, 3.0, 6.0};
  block.keys.positions = {0, 1, 2};
  block.text_positions.lines = {1, 2, 3};
  ExactKeys exact(true);
  exact.add(block);
  const KeyStore store([block, done = false]() mutable -> std::optional<KeyBlock> {
    return std::exchange(done, true) ? std::nullopt : std::optional(block);
  });
  Rules rules;
  rules.start.rule = rules.end.rule = spline::EndRule::chord;
  const Extent extent{0.0, Time(6.0), {}};
  ExactRows rows(exact.curve(3, rules, std::nullopt), request, extent, notation);
  const std::shared_ptr<Sampler> sampler = make_sampler(request, extent);
  const auto blocks = place(segment_blocks(store.source(), rules, {}), sampler, {});
  Table all;
  while (const auto samples = blocks()) {
    const std::array chosen{std::size_t{1}, std::size_t{6}};  // position, speed
    Table table = rows.evaluate(*samples, *sampler, chosen);
    all.cells.insert(all.cells.end(), table.cells.begin(), table.cells.end());
    all.texts.insert(all.texts.end(), table.texts.begin(), table.texts.end());
  }
  return all;
}

TEST(ExactRows, numbers_are_rounded_once) {
  SamplingRequest request;
  request.step = Rational(1);
  const Table table = exact_rows(request, {});
  ASSERT_EQ(table.cells.size(), 14U);
  for (std::size_t row = 0; row < 7; ++row) {
    const auto t = static_cast<double>(row);
    EXPECT_EQ(table.cells[2 * row].hi, t / 3);
    EXPECT_EQ(table.cells[2 * row + 1].hi, 1.0 / 3);
  }
}

TEST(ExactRows, texts_have_the_requested_digits) {
  SamplingRequest request;
  request.mode = Mode::count;
  request.count = 3;
  const Table table = exact_rows(request, {Notation::Kind::digits, 30});
  ASSERT_EQ(table.texts.size(), 6U);
  EXPECT_EQ(table.texts[2], "1");
  EXPECT_EQ(table.texts[3], "0.333333333333333333333333333333");
}

}  // namespace
}  // namespace tcb
