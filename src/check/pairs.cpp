// Pairs: the rows of each curve, where they lie on it, and the numbers that it has there.
#include "check/pairs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <map>
#include <utility>

#include "numbers/decimal_time.hpp"
#include "sample/places.hpp"
#include "sample/rows.hpp"
#include "schema/texts.hpp"
#include "stream/ordered_map.hpp"
#include "text/utf8.hpp"

namespace tcb {
namespace {

bool has_content(const std::vector<std::string>& group) {
  return std::ranges::any_of(group, [](const std::string& text) { return !text.empty(); });
}

SampleRows concatenated(const std::vector<SampleRows>& parts) {
  SampleRows all;
  for (const SampleRows& part : parts) {
    for (std::size_t row = 0; row < part.size(); ++row) all.add(part, row);
  }
  return all;
}

/// The places of curves by their groups, in order.
using PlacesByGroup = std::map<std::vector<std::string>, std::deque<std::size_t>>;

template <class Curves>
PlacesByGroup places_by_group(const Curves& curves) {
  PlacesByGroup places;
  for (std::size_t i = 0; i < curves.size(); ++i) places[contents(curves[i].group)].push_back(i);
  return places;
}

/// The rows of each group in one, which lines without a row may divide.
std::vector<SampleRows> joined_by_group(const std::vector<SampleRows>& parts) {
  const PlacesByGroup places = places_by_group(parts);
  std::vector<SampleRows> all;
  for (const SampleRows& first : parts) {
    const std::deque<std::size_t>& same = places.at(contents(first.group));
    if (&first != &parts[same.front()]) continue;
    SampleRows& joined = all.emplace_back(SampleRows{first.group, {}, {}, {}});
    for (const std::size_t part : same) {
      for (std::size_t row = 0; row < parts[part].size(); ++row) joined.add(parts[part], row);
    }
  }
  return all;
}

/// Divides rows at the gaps of the keys, so that each part of a curve has its own; rows in a gap belong to the part
/// before it. `by_group`: rows belong to the curve of their group, else to the next one. Requires: the rows have times.
void divide_at_gaps(const KeptInput& kept, SampleTable& table, bool by_group) {
  const std::vector<KeptKeys>& curves = kept.curves;
  const auto is_first_part = [](const KeptKeys& curve) { return curve.part->number == 0; };
  if (by_group) {
    table.curves = joined_by_group(table.curves);
  } else if (std::ranges::count_if(curves, is_first_part) == 1) {
    table.curves = {concatenated(table.curves)};
  }
  std::vector<SampleRows> divided;
  const PlacesByGroup places = by_group ? places_by_group(curves) : PlacesByGroup();
  auto next = curves.begin();  // the first part of a curve
  for (SampleRows& rows : table.curves) {
    if (by_group) {
      const auto found = places.find(contents(rows.group));
      next = found == places.end() ? curves.end() : curves.begin() + static_cast<std::ptrdiff_t>(found->second.front());
    }
    if (next == curves.end()) {
      divided.push_back(std::move(rows));
      continue;
    }
    std::vector<bool> taken(rows.size());
    do {
      const std::optional<Time> end = next->part->next();
      SampleRows& part = divided.emplace_back(SampleRows{rows.group, {}, {}, {}});
      for (std::size_t row = 0; row < rows.size(); ++row) {
        if (taken[row] || (end && rows.times[row] >= *end)) continue;
        taken[row] = true;
        part.add(rows, row);
      }
    } while (++next != curves.end() && !is_first_part(*next));
  }
  table.curves = std::move(divided);
}

Pairs pairs_by_group(const KeptInput& kept, SampleTable& table) {
  const std::vector<std::string>& names = kept.schema.groups;
  Pairs result;
  std::vector<bool> taken(table.curves.size());
  PlacesByGroup places = places_by_group(table.curves);
  for (const KeptKeys& curve : kept.curves) {
    std::optional<SampleRows> rows;
    if (const auto same = places.find(contents(curve.group)); same != places.end() && !same->second.empty()) {
      taken[same->second.front()] = true;
      rows = std::move(table.curves[same->second.front()]);
      same->second.pop_front();
    }
    const bool is_later_part = curve.part && curve.part->number > 0;
    if (rows && (rows->size() > 0 || curve.part)) {
      result.pairs.push_back({&curve, *std::move(rows)});
    } else if (!is_later_part) {
      result.problems.push_back(fmt::format("curve {} has no rows", listed(group_title(names, curve.group))));
    }
  }
  for (std::size_t i = 0; i < taken.size(); ++i) {
    if (taken[i]) continue;
    const SampleRows& rows = table.curves[i];
    result.problems.push_back(fmt::format("curve {} has no keys; its rows are in line {} and below",
                                          listed(group_title(names, rows.group)), rows.lines.at(0)));
  }
  return result;
}

}  // namespace

Pairs pair_up(const KeptInput& kept, SampleTable& table) {
  const bool by_group = !kept.curves.empty() && has_content(kept.curves[0].group) && !table.curves.empty() &&
                        has_content(table.curves[0].group);
  if (!kept.curves.empty() && kept.curves[0].part && table.timed) divide_at_gaps(kept, table, by_group);
  if (by_group) return pairs_by_group(kept, table);
  Pairs result;
  if (kept.curves.size() == 1) {
    result.pairs.push_back({&kept.curves[0], concatenated(table.curves)});
    return result;
  }
  const std::size_t both = std::min(kept.curves.size(), table.curves.size());
  for (std::size_t i = 0; i < both; ++i) result.pairs.push_back({&kept.curves[i], std::move(table.curves[i])});
  if (kept.curves.size() != table.curves.size()) {
    result.problems.push_back(fmt::format("number of curves: {} in the rows, {} in the keys, {} compared",
                                          table.curves.size(), kept.curves.size(), both));
  }
  return result;
}

Places places_of(const SampleRows& rows, const MatchedColumns& columns, const KeptCurve& curve, const Limits& limits) {
  Places result{columns.by_length ? Time(0.0) : curve.extent().first,
                columns.by_length ? Time(curve.length()) : *curve.extent().last};
  const Time first = result.first, last = result.last;
  const auto is_extended_to = [&](const Time& place) {
    const auto& [before, after] = curve.extrapolations();
    return !columns.by_length && (place < first ? before : after) != Extrapolation::error;
  };
  std::uint64_t off_curve = 0;
  std::pair<std::size_t, Time> first_off;
  for (std::size_t row = 0; row < rows.size(); ++row) {
    Time place = columns.place                 ? Time(rows.row(row)[*columns.place])
                 : curve.extent().decimals > 0 ? with_all_digits(rows.times[row])
                                               : as_double(rows.times[row]);
    const Time& end = place < first ? first : last;
    const bool is_off = place < first || place > last, is_extended = place == place && is_extended_to(place);
    if (is_off && !is_extended && limits.admit(distance(place.hi, end.hi))) place = end;
    if (is_extended || (place >= first && place <= last)) {
      result.rows.push_back(row);
      result.places.push_back(place);
      continue;
    }
    if (off_curve++ == 0) first_off = {row, place};
  }
  if (off_curve > 0) {
    const auto& [row, place] = first_off;
    const bool has_place = place == place;
    result.off_curve =
        has_place
            ? fmt::format("rows outside the curve: {}; the first, in line {}, has {} {}; {} of the curve is {}",
                          off_curve, rows.lines[row], columns.by_length ? "arc length" : "time", time_text(place),
                          columns.by_length ? "the nearest one" : "the nearest time",
                          time_text(place < first ? first : last))
            : fmt::format("rows without a time or arc length: {}; the first is in line {}", off_curve, rows.lines[row]);
  }
  return result;
}

void for_each_row(const SampleRows& given, const Places& places, const MatchedColumns& columns,
                  const std::shared_ptr<const KeptCurve>& curve, spline::Side side, unsigned threads,
                  const std::function<void(std::size_t, std::span<const Cell>)>& use) {
  const FoundRows rows = find_rows(curve, {.places = places.places}, columns.by_length, side);
  const Evaluate in_gaps = without_gaps(fast_rows(rows.locator), rows.locator, curve->gaps());
  const auto cells_of = [&](const SampleBlock& block) {
    return curve->gaps().empty() ? evaluate(block, *rows.locator, columns.fields)
                                 : in_gaps(block, columns.fields).cells;
  };
  const auto cells = ordered_map(rows.blocks, cells_of, threads);
  std::size_t next = 0;
  while (std::optional<std::vector<Cell>> block = cells()) {
    const std::size_t width = block->size() / std::min<std::size_t>(SampleBlock::most_rows, places.rows.size() - next);
    for (std::size_t at = 0; at < block->size(); at += width) {
      const std::span row = std::span(*block).subspan(at, width);
      columns.align(row, given.row(places.rows[next]));
      use(places.rows[next++], row);
    }
  }
}

}  // namespace tcb
