// The pipeline of one curve: which stages its keys go through to become placed samples, and in which order.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "keys/angles.hpp"
#include "keys/curves.hpp"
#include "keys/key_store.hpp"
#include "keys/rotations.hpp"
#include "run/curve_needs.hpp"
#include "run/job.hpp"
#include "run/row_estimate.hpp"
#include "sample/build.hpp"
#include "sample/grid.hpp"
#include "sample/request.hpp"
#include "sample/rows.hpp"
#include "sample/sampler.hpp"
#include "sample/shown_curve.hpp"
#include "schema/input_keys.hpp"
#include "schema/schema.hpp"

namespace tcb {

class ExactKeys;
class ExactRows;

/// The rows that are requested of a curve, and the settings that make it.
struct CurveRequest {
  SamplingRequest samples;
  CurveSettings rules = {};                  ///< of the job; those of the curve's input complete them
  std::vector<std::size_t> fields = {};      ///< of the rows, as indices into fields()
  std::optional<GoldenOptions> golden = {};  ///< rows are exact, and rounded once
  unsigned threads = 1;
  std::optional<TimeNotation> time_notation = {};  ///< in which rows show times; nothing: that of the input
  std::optional<Rational> frame_rate = {};         ///< of the rows' frames
  bool counts_from_zero = false;                   ///< a time is subtracted from those of rows
};

/// How a curve is built.
struct RuleFacts {
  CurveSpec spec;
  bool timed = false;  ///< the keys have times; otherwise the parameter makes them
};

/// The extent of a curve and its samples, as far as they are known before the first row.
struct PlacementFacts {
  std::optional<Time> first, last;  ///< times of the first and the last key
  std::optional<double> length;
  std::optional<Time> step;                                ///< of time or of arc length
  std::optional<std::uint64_t> rows = std::nullopt;        ///< within a distance
  std::optional<std::uint64_t> least_rows = std::nullopt;  ///< of any polyline within it
};

/// The samples of a curve in blocks, and how they are located and evaluated.
struct PlacedCurve {
  Source<SampleBlock> blocks;
  std::shared_ptr<const Locator> locator;  ///< of the rows
  std::shared_ptr<const Sampler> sampler;  ///< the same, where the samples are placed segment after segment
  PlacementFacts facts;
  Evaluate evaluate = {};
  std::function<double()> expected_rows = {};  ///< about the number of rows, by the segments that were made so far
  std::shared_ptr<ExactRows> golden = {};      ///< null: rows are not exact
  Time first_key = {};                         ///< its time
  std::function<std::size_t()> limited_tangents = {};  ///< so that it does not overshoot, of the segments made so far

  /// How far the end of the range is from the last row, once all blocks were taken; nothing if it is a row.
  std::optional<Rational> remainder() const { return sampler == nullptr ? std::nullopt : sampler->remainder(); }
};

/// A curve whose segments can be made more than once, and its samples.
struct StoredCurve {
  KeyStore keys;
  std::function<Source<SegmentBlock>()> segments;
  bool closed = false;
  std::optional<PlacedCurve> placed;  ///< nothing if a single key has no samples, or none are wanted
};

/// A curve with random access.
struct WholeCurve {
  std::shared_ptr<const ShownCurve> curve;
  Extent extent;
  Extrapolations extrapolations;
};

class CurvePipeline {
 public:
  /// Throws: Error if the settings of the job and of the input contradict each other, or do not fit the input.
  CurvePipeline(const CurveRequest& request, const Schema& schema, const KeyTraits& traits,
                const CurveInfo& curve_info);

  // From the keys of a curve. Throws: Error (data) for keys that make no curve.

  /// The samples of the request, in constant memory if it does not need all keys.
  /// `part`: of a curve that gaps divide.
  PlacedCurve place(Source<KeyBlock> blocks, const std::optional<CurvePart>& part = {});
  /// The curve itself, for samples that the request does not have; it may have a single key.
  WholeCurve whole(Source<KeyBlock> blocks);
  /// The curve as it is drawn, and unless it is not `sampled`, its samples; it may have a single key.
  StoredCurve stored(Source<KeyBlock> blocks, bool sampled = true, const std::optional<CurvePart>& part = {});

  RuleFacts facts() const { return {spec_, timed_}; }
  const CurveNeeds& needs() const { return needs_; }

  /// The request, with its step in the unit of the times.
  const SamplingRequest& request() const { return request_; }

 private:
  /// The exponent of the distances that make the times; 0: none do.
  double time_exponent() const { return timed_ ? 0 : spec_.parameter.value_or(0); }

  Source<KeyBlock> prepared(Source<KeyBlock> blocks, std::size_t least);
  Source<KeyBlock> recorded(Source<KeyBlock> blocks, const std::shared_ptr<ExactKeys>& exact) const;
  Extent extent(KeyStore& keys);
  Source<SegmentBlock> segments(const KeyStore& keys, const Extent& extent, bool measured) const;
  PlacedCurve place_as_read(Source<KeyBlock> blocks);
  void set_origin(const Time& first);
  std::size_t set_part(const std::optional<CurvePart>& part);
  bool takes_places_of(const CurvePart& part, const Extent& extent);
  bool has_exact_times() const { return golden_ && golden_->decimal && time_exponent() == 0; }
  Rational exact_end(const ExactKeys& exact, std::size_t keys, const Time& end) const;
  void set_key_times(const KeyStore& keys, const Extent& extent, const ExactKeys& exact);
  std::vector<Rational> exact_places(const Extent& extent) const;
  PlacedCurve place_stored(const KeyStore& keys, Extent extent, const ExactKeys& exact) const;
  PlacedCurve place_on_grid(const KeyStore& keys, Extent& extent) const;
  PlacedCurve place_in_order(Source<SegmentBlock> segments, const Extent& extent,
                             std::shared_ptr<const RowEstimate> estimate) const;
  void require_extended_to(std::string_view option, const Rational& time, const Bound& first, const Bound& last) const;
  PlacedCurve place_anywhere(const KeyStore& keys, const Extent& extent, const std::vector<Rational>& exact) const;
  std::shared_ptr<const ShownCurve> shown(const KeyStore& keys, const Extent& extent) const;
  std::vector<Time> grid_times(const Extent& extent) const;
  std::vector<Time> places(const ShownCurve& curve, const Extent& extent, PlacementFacts& facts) const;
  std::shared_ptr<ExactRows> exact_rows(const ExactKeys& exact, std::size_t keys, const Extent& extent,
                                        std::vector<Rational> times) const;

  SamplingRequest request_;
  CurveSpec spec_;
  std::optional<GoldenOptions> golden_;
  bool timed_, may_be_timed_, has_tcb_scale_;
  CurveNeeds needs_;
  unsigned threads_;
  std::vector<std::string> channels_;
  RotationsOfKeys rotations_;
};

}  // namespace tcb
