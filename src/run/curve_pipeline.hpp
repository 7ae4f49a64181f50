// The pipeline of one curve: the stages that its keys go through, in this order:
//   keys -> prepared keys, in order and with times
//        -> a streamed curve: its segments as keys are read, or once all keys are read, as often as they are needed;
//           or a kept curve: its segments in any order
//        -> samples, which a sampler places segment after segment, or which are found on a kept curve
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "keys/curves.hpp"
#include "keys/prepare.hpp"
#include "run/job.hpp"
#include "sample/curve_spec.hpp"
#include "sample/request.hpp"
#include "sample/table.hpp"
#include "schema/key_block.hpp"
#include "schema/schema.hpp"
#include "tcb/spline/curve_keys.hpp"

namespace tcb {

struct ExactCurve;
class ExactKeys;
class GapRows;
class KeptCurve;
class KeyStore;
class Locator;
struct SampleBlock;
class Sampler;
struct SegmentBlock;
struct StreamedCurve;
struct WriterOptions;

/// The rows that are requested of a curve, and the settings that make it.
struct CurveRequest {
  SamplingRequest samples;
  CurveSettings rules = {};                  ///< of the job; those of the curve's input complete them
  std::vector<std::size_t> fields = {};      ///< of the rows, as indices into fields()
  std::optional<GoldenOptions> golden = {};  ///< rows are exact, and rounded once
  unsigned threads = 1;
  std::optional<TimeNotation> time_notation = {};  ///< in which rows show times; nothing: that of the input
  std::optional<Rational> frame_rate = {};         ///< of the rows' frames
  std::optional<CountedFrom> zero = {};            ///< which is subtracted from the times of keys, and of `samples`
  bool leaves_gaps = false;                        ///< cells are empty where a channel has a gap
  bool counts_gap_rows = false;                    ///< rows between keys that are far apart are counted
};

/// What a request needs of a curve before its first row.
struct CurveNeeds {
  bool all_keys = false;       ///< every key is read before the first row; otherwise memory is constant
  bool random_access = false;  ///< segments are needed in any order, so the curve is kept
  bool lengths = false;        ///< every segment is measured
  bool whole_length = false;   ///< the length of the whole curve is known before the first row
  bool single_key = false;     ///< a single key is enough
  bool angle_signs = false;    ///< whether any angle is negative is known before the first row, from all keys
  bool metric = false;
};

/// How fast rows move at a pace.
struct PaceFacts {
  double duration = 0, mean_speed = 0, largest_speed = 0;
};

/// The extent of a curve and its samples, as far as they are known before the first row.
struct SampleFacts {
  std::optional<Time> first, last;  ///< times of the first and the last key
  std::optional<double> length;
  std::optional<Time> step;                                ///< of time or of arc length
  std::optional<std::uint64_t> rows = std::nullopt;        ///< within a distance
  std::optional<std::uint64_t> least_rows = std::nullopt;  ///< of any polyline within it
  std::optional<PaceFacts> pace = std::nullopt;
};

/// The samples of a curve in blocks, and how they are evaluated. Functions are of the segments that were made so far.
struct CurveSamples {
  Source<SampleBlock> blocks;
  Evaluate evaluate = {};
  bool in_order = false;  ///< they are placed segment after segment
  SampleFacts facts = {};
  std::function<double()> expected_rows = [] { return 0.0; };                     ///< about how many there will be
  std::function<std::size_t()> limited_tangents = [] { return std::size_t{0}; };  ///< so that it does not overshoot
  std::vector<spline::ChannelGap> gaps = {};                                      ///< where cells of channels are empty
  std::shared_ptr<GapRows> gap_rows = nullptr;  ///< once all blocks were taken; null: rows are not counted
  std::shared_ptr<const Locator> locator = nullptr;
  /// How far the end of the range is from the last row, once all blocks were taken; nothing if it is a row.
  std::function<std::optional<Rational>()> remainder = [] { return std::nullopt; };

  static CurveSamples none();
};

class CurvePipeline {
 public:
  /// `part`: of a curve that gaps divide. Throws: Error if the settings of the job and of the input contradict each
  /// other, or do not fit the input.
  CurvePipeline(const CurveRequest& request, const Schema& schema, const KeyTraits& traits, const CurveInfo& curve_info,
                std::optional<CurvePart> part = {});

  // From the keys of a curve. Throws: Error (data) for keys that make no curve.

  /// The samples of the request, in constant memory if it does not need all keys.
  CurveSamples samples(Source<KeyBlock> blocks);
  /// The curve as it is drawn; it may have a single key.
  StreamedCurve streamed(Source<KeyBlock> blocks);
  /// The curve for samples that the request does not have; it may have a single key.
  std::shared_ptr<const KeptCurve> kept(Source<KeyBlock> blocks);

  /// The samples of the request on a curve of this pipeline. `exact`: its keys, if rows are exact.
  CurveSamples samples(const StreamedCurve& curve, const ExactKeys* exact = nullptr);

  /// A curve of this pipeline without any rounding; the numbers of rotations are rounded.
  ExactCurve exact(const StreamedCurve& curve) const;

  const CurveSpec& spec() const { return spec_; }
  const CurveNeeds& needs() const { return needs_; }

  /// The request, with its step in the unit of the times.
  const SamplingRequest& request() const { return request_; }

 private:
  /// The exponent of the distances that make the times; 0: none do.
  double time_exponent() const { return spec_.timed ? 0 : spec_.exponent(); }

  Source<KeyBlock> prepared(Source<KeyBlock> blocks, std::size_t least);
  std::vector<spline::ChannelGap> channel_gaps(const KeyStore& store) const;
  Source<KeyBlock> with_placeholders(const Source<KeyBlock>& blocks);
  StreamedCurve read(Source<KeyBlock> blocks);
  CurveSamples samples_as_read(Source<KeyBlock> blocks);
  CurveSamples samples_on_grid(const StreamedCurve& curve) const;
  CurveSamples samples_in_order(Source<SegmentBlock> segments, std::shared_ptr<Sampler> sampler) const;
  std::shared_ptr<GapRows> new_gap_rows(std::shared_ptr<const Locator> locator, bool in_order) const;
  CurveSamples samples_at_places(const StreamedCurve& curve) const;
  void count_from(const CountedFrom& zero, const TimeSchema& time);
  bool take_places_of_part(const Extent& extent);
  void set_key_times(const StreamedCurve& curve, const ExactKeys& exact);
  Rational exact_end(const ExactKeys& exact, const StreamedCurve& curve) const;
  ExactCurve exact_curve(const ExactKeys& exact, const StreamedCurve& curve) const;
  Evaluate exact_rows(const ExactKeys& exact, const StreamedCurve& curve, const CurveSamples& samples) const;

  SamplingRequest request_;
  CurveSpec spec_;
  std::optional<GoldenOptions> golden_;
  CurveNeeds needs_;
  unsigned threads_;
  KeyPreparation preparation_;
  std::optional<Rational> zero_;            ///< which is subtracted from the times of keys
  std::optional<FrameTimes> given_frames_;  ///< of their times before that
  std::optional<CurvePart> part_;
  bool may_be_point_, may_miss_, leaves_gaps_, counts_gap_rows_;
  std::vector<bool> empty_;  ///< channels without a position in a part of a curve
};

std::string in_words(const CurveNeeds& needs);

/// From which the times of rows count; nothing: it is not given, or is that of the first key.
std::optional<CountedFrom> given_zero(const WriterOptions& rows);

/// Throws: Error (usage) where times count from another one than 0, and keys have none.
void require_times(const CountedFrom& zero, const TimeSchema& time);

/// The times that the texts of rows name: where these are times in words or frames; nothing: they are numbers. `shown`:
/// the notation of rows, if it is not that of the input; `rate`: of their frames.
std::optional<FrameTimes> named_times(std::optional<TimeNotation> shown, const std::optional<Rational>& rate,
                                      const TimeSchema& time);

}  // namespace tcb
