// From a request and what is known of the curve to the sampler that answers it.
#include "sampler/sampler.hpp"

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

Spacing spacing(const Request& request, const Rational& from, const std::optional<Rational>& to) {
  if (!needs_end(request.mode)) return {unlimited, request.step};
  const std::uint64_t intervals = request.mode == Mode::segments ? request.count : request.count - 1;
  if (intervals == 0) return {1, Rational(0)};
  return {intervals + 1, Rational((*to - from) / intervals)};
}

std::unique_ptr<Sampler> make_by_length(const Request& request, const Extent& extent) {
  const Rational from = request.from.value_or(Rational(0));
  std::optional<Rational> to = request.to;
  if (!to && extent.length) to = exact_time({*extent.length});
  const auto [rows, step] = spacing(request, from, to);
  const auto end = to ? std::optional(nearest_time(*to).hi) : std::nullopt;
  return std::make_unique<ByLength>(Grid(from, step), end, rows);
}

std::unique_ptr<Sampler> make_by_time(const Request& request, const Extent& extent) {
  const Rational from = request.from.value_or(exact_time(extent.first));
  std::optional<Rational> to = request.to;
  if (!to && extent.last) to = exact_time(*extent.last);
  const auto [rows, step] = spacing(request, from, to);
  const auto end = to ? std::optional(nearest_time(*to)) : std::nullopt;
  return std::make_unique<ByTime>(Grid(from, step), end, rows);
}

}  // namespace

std::unique_ptr<Sampler> make_sampler(const Request& request, const Extent& extent) {
  return by_length(request.mode) ? make_by_length(request, extent) : make_by_time(request, extent);
}

}  // namespace tcb::sampler
