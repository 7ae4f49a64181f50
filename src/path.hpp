// The path of one curve, from its keys to its placed samples: which steps it needs, and in which order.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "curve_plan.hpp"
#include "format/input.hpp"
#include "golden/options.hpp"
#include "kept_keys.hpp"
#include "lookup.hpp"
#include "rows.hpp"
#include "sampler/anywhere.hpp"
#include "sampler/request.hpp"
#include "sampler/spacing.hpp"

namespace tcb {

namespace golden {
class ExactKeys;
}

/// What was found and decided, in words.
using Facts = std::vector<std::pair<std::string, std::string>>;

/// The samples of a curve in batches, and who knows where each of them is.
struct Placed {
  Source<Batch> batches;
  std::shared_ptr<const sampler::Locator> locator;  ///< of the rows
  std::shared_ptr<const sampler::Sampler> sampler;  ///< the same, where the samples are placed as the curve goes by
  Facts facts;
  Evaluate evaluate = {};
};

/// A curve kept whole, to be looked up anywhere.
struct Whole {
  std::shared_ptr<const WholeCurve> curve;
  sampler::Extent extent;
  sampler::Extrapolation extrapolation;
};

class Path {
 public:
  /// Throws: Error where the settings, given and beside the keys, do not fit the input.
  Path(const sampler::Request& request, const CurveSettings& settings, std::vector<std::size_t> fields,
       const std::optional<golden::Options>& golden, const format::Input& input, const format::BesideKeys& beside_keys);

  /// Throws: Error (data) for keys that make no curve.
  Placed place(Source<format::KeyBlock> blocks) const;

  /// The whole curve, for samples that are placed by whoever asks. Throws: Error (data) for keys that make no curve.
  Whole whole(Source<format::KeyBlock> blocks) const;

  /// The rules of the curve in words.
  Facts rules() const;

 private:
  bool is_single() const;
  bool needs_lengths() const;
  Source<format::KeyBlock> prepared(Source<format::KeyBlock> blocks) const;
  sampler::Extent extent(KeptKeys& kept) const;
  LinkedKeys linked(const KeptKeys& kept, const sampler::Extent& extent) const;
  /// The exponent of the distances that make the times; 0: none do.
  double made_by() const { return timed_ ? 0 : curve_.parameter.value_or(0); }
  Source<Stretch> stretches(LinkedKeys keys, bool measured, bool sparse) const;
  Placed place_streamed(LinkedKeys keys, const sampler::Extent& extent, std::optional<Lengths> lengths = {},
                        bool sparse = false) const;
  Placed place_kept(KeptKeys kept, bool anywhere, const golden::ExactKeys& exact) const;
  Evaluate golden_rows(const golden::ExactKeys& exact, std::size_t keys, const sampler::Extent& extent,
                       const std::shared_ptr<const sampler::Locator>& locator) const;
  Placed place_anywhere(LinkedKeys keys, const sampler::Extent& extent, bool sparse) const;
  std::vector<sampler::Time> grid_times(const sampler::Extent& extent) const;

  const sampler::Request& request_;
  CurveSettings settings_;
  CurvePlan curve_;
  std::vector<std::size_t> fields_;
  std::optional<golden::Options> golden_;
  bool timed_;
  unsigned threads_;
  bool may_miss_;
  std::vector<std::string> channels_;
};

}  // namespace tcb
