// Pieces: a row for each segment, or for the part of it that lies in the range of the request.
#include "sample/piece_sampler.hpp"

#include <algorithm>

#include "error.hpp"
#include "numbers/print_number.hpp"
#include "option_names.hpp"
#include "sample/errors.hpp"

namespace tcb {
namespace {

class PieceSampler : public Sampler {
 public:
  explicit PieceSampler(const SamplingRequest& request) : request_(request) {}

  SegmentRows place(const CurveSegment& segment) override;
  void locate(const CurveSegment& segment, std::uint64_t first, std::uint64_t last, Located& located) const override;
  bool done() const override { return done_; }

 private:
  struct Range {
    Time start, end;
  };

  /// The part of the segment in the range of the request; it has no duration where there is none.
  Range range(const CurveSegment& segment) const {
    const auto bound = [&](const std::optional<Rational>& given, const Time& key) {
      return given ? std::clamp(nearest_time(*given, segment.decimals), segment.start, segment.end) : key;
    };
    return {bound(request_.from, segment.start), bound(request_.to, segment.end)};
  }

  void require_bounds(const CurveSegment& segment) const;

  SamplingRequest request_;
  std::uint64_t rows_ = 0;
  bool done_ = false;
};

/// Throws: Error where the range leaves the curve.
void PieceSampler::require_bounds(const CurveSegment& segment) const {
  const auto require = [&](std::string_view option, const std::optional<Rational>& given) {
    if (!given) return;
    const Bound first{before_first_piece, request_.exact(segment.start)};
    const Bound last{after_last_piece, request_.exact(segment.end)};
    if (segment.number == 0) require_not_before(option, *given, first);
    if (segment.last) require_not_after(option, *given, last);
  };
  require(option::from, request_.from);
  require(option::to, request_.to);
}

SegmentRows PieceSampler::place(const CurveSegment& segment) {
  if (segment.number == 0 || segment.last) require_bounds(segment);
  const auto [start, end] = range(segment);
  done_ = request_.to && nearest_time(*request_.to, segment.decimals) <= segment.end;
  const bool has_row = start < end;
  if (has_row && !segment.warp.is_identity()) {
    throw piece_with_ease(segment.number, time_text(segment.start), time_text(segment.end));
  }
  if (has_row && ++rows_ > request_.max_rows) require_rows(Rational(rows_ - 1), request_.max_rows, !segment.last);
  if (rows_ == 0 && (done_ || segment.last)) throw no_piece_in_range();
  return {segment.number, segment.number + (has_row ? 1 : 0)};
}

void PieceSampler::locate(const CurveSegment& segment, std::uint64_t first, std::uint64_t last,
                          Located& located) const {
  const spline::TimeMap<double> locate = segment.time_map();
  const auto [start, end] = range(segment);
  const auto at = [&](const Time& t) -> Sample { return {t, locate(segment.precise(t))}; };
  fill(located, first, last, [&, start = start](std::uint64_t) { return at(start); });
  located.ends.assign(last - first, at(end));
}

}  // namespace

std::unique_ptr<Sampler> make_piece_sampler(const SamplingRequest& request) {
  return std::make_unique<PieceSampler>(request);
}

}  // namespace tcb
