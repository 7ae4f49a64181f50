// The rows of a curve at the places that someone's samples have.
#include "compare/lookup.hpp"

#include <fmt/format.h>

#include "curve/index.hpp"
#include "curve/rows.hpp"
#include "text/number.hpp"

namespace tcb {
namespace {

/// The rows of a curve in batches, with who locates them.
struct Found {
  Source<SampleBlock> batches;
  std::shared_ptr<const Locator> locator;
};

Found find(const Places& places, bool by_length, const IndexedCurve& whole, bool from_left) {
  const auto place = [&places](std::uint64_t row) { return places.places[row]; };
  const std::uint64_t rows = places.places.size();
  if (by_length) {
    const auto locator = std::make_shared<const AnywhereInLength>(place, rows, whole.curve->length());
    return {look_up(whole.curve, locator, from_left), locator};
  }
  const auto locator =
      std::make_shared<const AnywhereInTime>(place, rows, whole.extrapolation, whole.extent.first, *whole.extent.last);
  return {look_up(whole.curve, locator, from_left), locator};
}

std::string off_in_words(const Time& place, const Time& first, const Time& last, bool by_length) {
  const char* what = by_length ? "the arc length" : "the time";
  if (!(place < first) && !(place > last)) return fmt::format("{} is missing", what);
  return fmt::format("{} {} is {} the curve's {}, {}", what, time_text(place), place < first ? "before" : "behind",
                     place < first ? "first" : "last", time_text(place < first ? first : last));
}

}  // namespace

Places places_of(const SampleRows& rows, const SampleTable& table, const MatchedColumns& columns,
                 const IndexedCurve& whole, const Limits& limits) {
  const Time first = columns.by_length ? Time(0.0) : whole.extent.first;
  const Time last = columns.by_length ? Time(whole.curve->length()) : *whole.extent.last;
  const bool anywhere = !columns.by_length && whole.extrapolation != Extrapolation::error;
  const std::size_t width = table.columns.size();
  Places result;
  for (std::size_t row = 0; row < rows.size(); ++row) {
    Time place = columns.place ? Time(rows.numbers[row * width + *columns.place]) : rows.times[row];
    const bool on_curve = place >= first && place <= last;
    const Time end = place < first ? first : last;
    if (place == place && !on_curve && !anywhere && limits.admit(distance(place.hi, end.hi))) place = end;
    if ((place >= first && place <= last) || (anywhere && place == place)) {
      result.rows.push_back(row);
      result.places.push_back(place);
      continue;
    }
    if (result.off_curve.empty()) result.off_in_words = off_in_words(place, first, last, columns.by_length);
    result.off_curve.push_back(row);
  }
  return result;
}

std::string off_curve(const Places& places, const SampleRows& rows) {
  const std::size_t count = places.off_curve.size();
  return fmt::format("{} outside the curve, the first in line {}: {}",
                     count == 1 ? "1 row" : fmt::format("{} rows", count), rows.lines[places.off_curve[0]],
                     places.off_in_words);
}

void for_each_row(const Places& places, const MatchedColumns& columns, const IndexedCurve& whole, bool from_left,
                  unsigned threads, const std::function<void(std::size_t, std::span<const Cell>)>& hear) {
  Found found = find(places, columns.by_length, whole, from_left);
  const auto cells_of = [&](const SampleBlock& batch) { return evaluate(batch, *found.locator, columns.fields); };
  const auto cells = ordered_map(std::move(found.batches), cells_of, threads);
  std::size_t next = 0;
  while (const std::optional<std::vector<Cell>> batch = cells()) {
    const std::size_t width = batch->size() / std::min<std::size_t>(SampleBlock::most_rows, places.rows.size() - next);
    for (std::size_t at = 0; at < batch->size(); at += width) {
      hear(places.rows[next++], std::span(*batch).subspan(at, width));
    }
  }
}

}  // namespace tcb
