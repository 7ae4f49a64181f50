// The path of one curve, from its keys to its placed samples: which steps it needs, and in which order.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "curve/curve_plan.hpp"
#include "curve/index.hpp"
#include "curve/rows.hpp"
#include "exact/options.hpp"
#include "input/input.hpp"
#include "keys/key_store.hpp"
#include "sampling/at_places.hpp"
#include "sampling/request.hpp"
#include "sampling/spacing.hpp"

namespace tcb {

class ExactKeys;

/// What was found and decided, in words.
using Facts = std::vector<std::pair<std::string, std::string>>;

/// The samples of a curve in batches, and who knows where each of them is.
struct Placed {
  Source<SampleBlock> batches;
  std::shared_ptr<const Locator> locator;  ///< of the rows
  std::shared_ptr<const Sampler> sampler;  ///< the same, where the samples are placed as the curve goes by
  Facts facts;
  Evaluate evaluate = {};
};

/// A curve kept whole, to be looked up anywhere.
struct IndexedCurve {
  std::shared_ptr<const CurveIndex> curve;
  Extent extent;
  Extrapolation extrapolation;
};

class CurvePipeline {
 public:
  /// Throws: Error where the settings, given and beside the keys, do not fit the input.
  CurvePipeline(const SamplingRequest& request, const CurveSettings& settings, std::vector<std::size_t> fields,
                const std::optional<GoldenOptions>& golden, const Input& input, const CurveInfo& curve_info);

  /// Throws: Error (data) for keys that make no curve.
  Placed place(Source<KeyBlock> blocks) const;

  /// The whole curve, for samples that are placed by whoever asks. Throws: Error (data) for keys that make no curve.
  IndexedCurve whole(Source<KeyBlock> blocks) const;

  /// The rules of the curve in words.
  Facts rules() const;

 private:
  bool is_single() const;
  bool needs_lengths() const;
  Source<KeyBlock> prepared(Source<KeyBlock> blocks) const;
  Extent extent(KeyStore& kept) const;
  LinkedKeys linked(const KeyStore& kept, const Extent& extent) const;
  /// The exponent of the distances that make the times; 0: none do.
  double made_by() const { return timed_ ? 0 : curve_.parameter.value_or(0); }
  Source<SegmentBlock> segment_blocks(LinkedKeys keys, bool measured, bool sparse) const;
  Placed place_streamed(LinkedKeys keys, const Extent& extent, std::optional<Lengths> lengths = {},
                        bool sparse = false) const;
  Placed place_kept(KeyStore kept, bool anywhere, const ExactKeys& exact) const;
  Evaluate golden_rows(const ExactKeys& exact, std::size_t keys, const Extent& extent,
                       const std::shared_ptr<const Locator>& locator) const;
  Placed place_anywhere(LinkedKeys keys, const Extent& extent, bool sparse) const;
  std::vector<Time> grid_times(const Extent& extent) const;

  const SamplingRequest& request_;
  CurveSettings settings_;
  CurvePlan curve_;
  std::vector<std::size_t> fields_;
  std::optional<GoldenOptions> golden_;
  bool timed_;
  unsigned threads_;
  bool may_miss_;
  std::vector<std::string> channels_;
};

}  // namespace tcb
