// From pieces of the curve to rows: which samples lie on each, and the cells of their rows.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "curve/fields.hpp"
#include "curve/segment_blocks.hpp"
#include "output/layout.hpp"
#include "sampling/sampler.hpp"
#include "stream/stream.hpp"

namespace tcb {

/// Samples on some pieces, few enough to be worked out at once.
struct SampleBlock {
  struct Part {
    CurveSegment piece;
    std::uint64_t first, last;  ///< rows from first to before last
  };
  std::shared_ptr<const void> owner;  ///< keeps what the pieces look into
  std::vector<Part> parts;
  bool first = false;  ///< no row came before these

  static constexpr std::uint64_t most_rows = 1024;
  std::uint64_t rows() const;
};

/// The samples of a curve in order, in batches; nothing is held back.
Source<SampleBlock> place(Source<SegmentBlock> segment_blocks, std::shared_ptr<Sampler> sampler,
                          std::vector<std::size_t> metric);

/// The cells of some rows, row after row.
struct Table {
  std::vector<Cell> cells;
  std::vector<std::string> texts = {};  ///< of the cells, where they say more than these; else none, or empty ones
};

/// The rows of a batch with the chosen fields.
using Evaluate = std::function<Table(const SampleBlock& batch, std::span<const std::size_t> chosen)>;

/// The cells of a batch, row after row. A pure function. Throws: Error (data) for a number beyond
/// the range of doubles.
std::vector<Cell> evaluate(const SampleBlock& batch, const Locator& locator, std::span<const std::size_t> chosen);

/// The rows that evaluate() makes.
Evaluate fast_rows(std::shared_ptr<const Locator> locator);

/// Throws: Error (data) for a number in the row of a sample.
[[noreturn]] void refuse_overflow(const Sample& sample);

}  // namespace tcb
