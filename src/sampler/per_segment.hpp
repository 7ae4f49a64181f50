// Samples at equal intervals within every segment: the inbetweens of the paper.
#pragma once

#include "sampler/sampler.hpp"

namespace tcb::sampler {

class PerSegment : public Sampler {
 public:
  explicit PerSegment(const Request& request) : intervals_(request.count), max_rows_(request.max_rows) {}

  Run place(const Piece& piece) override;
  void locate(const Piece& piece, std::uint64_t first, std::uint64_t last, Located& located) const override;
  bool done() const override { return false; }

 private:
  std::uint64_t intervals_;
  std::uint64_t max_rows_;
};

}  // namespace tcb::sampler
