// Samples at equal intervals within every segment: the inbetweens of the paper.
#pragma once

#include "sampling/sampler.hpp"

namespace tcb {

class PerSegment : public Sampler {
 public:
  explicit PerSegment(const SamplingRequest& request) : intervals_(request.count), max_rows_(request.max_rows) {}

  Run place(const CurveSegment& piece) override;
  void locate(const CurveSegment& piece, std::uint64_t first, std::uint64_t last, Located& located) const override;
  bool done() const override { return false; }

 private:
  std::uint64_t intervals_;
  std::uint64_t max_rows_;
};

}  // namespace tcb
