// From a request and what is known of the curve to the sampler that answers it.
#include "sampler/sampler.hpp"

#include <utility>

#include "sampler/by_length.hpp"
#include "sampler/by_time.hpp"

namespace tcb::sampler {
namespace {

constexpr std::uint64_t unlimited = ByTime::unlimited;

/// The rows asked for, and how far apart they are between two ends.
struct Spacing {
  std::uint64_t rows;
  Rational step;
};

Spacing spacing(const Request& request, const Rational& from, const std::optional<Rational>& to, bool closed) {
  if (!needs_end(request.mode)) return {unlimited, request.step};
  if (closed && request.mode != Mode::segments && !request.from && !request.to) {
    return {request.count, Rational((*to - from) / request.count)};
  }
  const std::uint64_t intervals = request.mode == Mode::segments ? request.count : request.count - 1;
  if (intervals == 0) return {1, Rational(0)};
  return {intervals + 1, Rational((*to - from) / intervals)};
}

std::unique_ptr<Sampler> make_by_length(const Request& request, const Extent& extent) {
  const Rational from = request.from.value_or(Rational(0));
  std::optional<Rational> to = request.to;
  if (!to && extent.length) to = exact_time({*extent.length});
  const auto [rows, step] = spacing(request, from, to, extent.closed);
  const auto end = to ? std::optional(nearest_time(*to).hi) : std::nullopt;
  return std::make_unique<ByLength>(Grid(from, step), end, rows);
}

}  // namespace

TimeRows time_rows(const Request& request, const Extent& extent) {
  const Rational from = request.from.value_or(exact_time(extent.first));
  std::optional<Rational> to = request.to;
  if (!to && extent.last) to = exact_time(*extent.last);
  const auto [rows, step] = spacing(request, from, to, extent.closed);
  return {Grid(from, step), rows, to ? std::optional(nearest_time(*to)) : std::nullopt};
}

std::unique_ptr<Sampler> make_sampler(const Request& request, const Extent& extent) {
  if (by_length(request.mode)) return make_by_length(request, extent);
  auto [grid, rows, end] = time_rows(request, extent);
  return std::make_unique<ByTime>(std::move(grid), end, rows);
}

}  // namespace tcb::sampler
