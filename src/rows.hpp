// From pieces of the curve to rows of text: which samples lie on each, what is known there, how it is printed.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "format/layout.hpp"
#include "pieces.hpp"
#include "sampler/sampler.hpp"
#include "stream.hpp"

namespace tcb {

/// What a row can show. To add a field: a row of the table in rows.cpp.
struct Field {
  std::string_view name;
  format::CellKind kind;
  bool per_channel;    ///< a column for each channel, named after it; otherwise one
  bool needs_lengths;  ///< the segments before it have to be measured
  void (*append)(std::vector<format::Cell>& row, const sampler::Piece& piece, const sampler::Sample& sample);
};

std::span<const Field> fields();

/// The names of the output's columns.
std::vector<format::OutputColumn> output_columns(std::span<const std::size_t> chosen, const format::Input& input);

/// Samples on some pieces, few enough to be worked out at once.
struct Batch {
  struct Part {
    sampler::Piece piece;
    sampler::Run run;
  };
  std::shared_ptr<const void> owner;  ///< keeps what the pieces look into
  std::vector<Part> parts;
  bool first = false;  ///< no row came before these

  static constexpr std::uint64_t most_rows = 4096;
};

/// The samples of a curve in order, in batches; nothing is held back.
Source<Batch> place(Source<Stretch> stretches, std::shared_ptr<sampler::Sampler> sampler,
                    std::vector<std::size_t> metric);

/// The cells of a batch, row after row. A pure function. Throws: Error (data) for a number beyond
/// the range of doubles.
std::vector<format::Cell> evaluate(const Batch& batch, const sampler::Locator& locator,
                                   std::span<const std::size_t> chosen);

}  // namespace tcb
