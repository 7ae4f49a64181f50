// Match: pairs of curves and given rows, and evaluation of a curve at the places of the rows.
#include "compare/match.hpp"

#include <algorithm>
#include <utility>

#include "curve/index.hpp"
#include "curve/rows.hpp"
#include "input/texts.hpp"
#include "stream/ordered_map.hpp"
#include "text/print_number.hpp"

namespace tcb {
namespace {

bool has_content(const std::vector<std::string>& group) {
  return std::ranges::any_of(group, [](const std::string& text) { return !text.empty(); });
}

/// The texts of a group without their kinds, which differ between formats.
std::vector<std::string> contents(const std::vector<std::string>& group) {
  std::vector<std::string> texts;
  for (const std::string& text : group) texts.emplace_back(content(text));
  return texts;
}

/// NAME=VALUE for each column of a group.
std::vector<std::string> title_of(const std::vector<std::string>& names, const std::vector<std::string>& group) {
  std::vector<std::string> title;
  for (std::size_t i = 0; i < group.size() && i < names.size(); ++i) {
    title.push_back(names[i] + "=" + std::string(content(group[i])));
  }
  return title;
}

/// All rows as those of one curve.
SampleRows concatenated(const std::vector<SampleRows>& parts) {
  SampleRows all;
  for (const SampleRows& part : parts) {
    all.times.insert(all.times.end(), part.times.begin(), part.times.end());
    all.numbers.insert(all.numbers.end(), part.numbers.begin(), part.numbers.end());
    all.lines.insert(all.lines.end(), part.lines.begin(), part.lines.end());
  }
  return all;
}

Pairs pairs_by_group(const KeptCurves& kept, SampleTable& table) {
  const std::vector<std::string>& names = kept.input.groups;
  Pairs result;
  std::vector<bool> taken(table.curves.size());
  for (const KeptCurve& curve : kept.curves) {
    const auto wanted = contents(curve.group);
    SampleRows rows;
    for (std::size_t i = 0; i < taken.size(); ++i) {
      if (taken[i] || contents(table.curves[i].group) != wanted) continue;
      taken[i] = true;
      rows = std::move(table.curves[i]);
      break;
    }
    if (rows.size() == 0)
      result.problems.push_back({Exit::data, ErrorCode::curve_without_rows, {title_of(names, curve.group)}});
    else
      result.pairs.push_back({&curve, std::move(rows)});
  }
  for (std::size_t i = 0; i < taken.size(); ++i) {
    if (taken[i]) continue;
    const SampleRows& rows = table.curves[i];
    result.problems.push_back(
        {Exit::data, ErrorCode::rows_without_keys, {title_of(names, rows.group), rows.lines.at(0)}});
  }
  return result;
}

}  // namespace

Pairs pair_up(const KeptCurves& kept, SampleTable& table) {
  if (!kept.curves.empty() && has_content(kept.curves[0].group) && !table.curves.empty() &&
      has_content(table.curves[0].group)) {
    return pairs_by_group(kept, table);
  }
  Pairs result;
  if (kept.curves.size() == 1) {
    result.pairs.push_back({&kept.curves[0], concatenated(table.curves)});
    return result;
  }
  const std::size_t both = std::min(kept.curves.size(), table.curves.size());
  for (std::size_t i = 0; i < both; ++i) result.pairs.push_back({&kept.curves[i], std::move(table.curves[i])});
  if (kept.curves.size() != table.curves.size()) {
    result.problems.push_back({Exit::data, ErrorCode::curve_counts, {table.curves.size(), kept.curves.size(), both}});
  }
  return result;
}

ComparisonSummary summary(const ComparisonInputs& inputs, const Pairs& pairs) {
  const MatchedColumns& columns = inputs.columns;
  ComparisonSummary result{inputs.file, inputs.keys, columns.by_length, columns.ignored, columns.problems};
  result.problems.insert(result.problems.end(), pairs.problems.begin(), pairs.problems.end());
  return result;
}

Places places_of(const SampleRows& rows, const SampleTable& table, const MatchedColumns& columns,
                 const IndexedCurve& curve, const Limits& limits) {
  const Time first = columns.by_length ? Time(0.0) : curve.extent.first;
  const Time last = columns.by_length ? Time(curve.curve->length()) : *curve.extent.last;
  const bool anywhere = !columns.by_length && curve.extrapolation != Extrapolation::error;
  const std::size_t width = table.columns.size();
  Places result;
  std::uint64_t off_curve = 0;
  std::pair<std::size_t, Time> first_off;
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
    if (off_curve++ == 0) first_off = {row, place};
  }
  if (off_curve > 0) {
    const auto& [row, place] = first_off;
    const bool missing = !(place == place);
    result.off_curve = Error(Exit::data,
                             missing             ? ErrorCode::rows_without_place
                             : columns.by_length ? ErrorCode::lengths_off_curve
                                                 : ErrorCode::times_off_curve,
                             {off_curve, rows.lines[row], time_text(place), time_text(place < first ? first : last)});
  }
  return result;
}

void for_each_row(const Places& places, const MatchedColumns& columns, const IndexedCurve& curve, bool from_left,
                  unsigned threads, const std::function<void(std::size_t, std::span<const Cell>)>& use) {
  const auto place = [&places](std::uint64_t row) { return places.places[row]; };
  const auto evaluate_all = [&](const auto& locator) {
    const auto cells_of = [&columns, locator](const SampleBlock& block) {
      return evaluate(block, *locator, columns.fields);
    };
    return ordered_map(look_up(curve.curve, locator, from_left), cells_of, threads);
  };
  const std::uint64_t rows = places.places.size();
  const auto cells = columns.by_length
                         ? evaluate_all(std::make_shared<const AnywhereInLength>(place, rows, curve.curve->length()))
                         : evaluate_all(std::make_shared<const AnywhereInTime>(place, rows, curve.extrapolation,
                                                                               curve.extent.first, *curve.extent.last));
  std::size_t next = 0;
  while (const std::optional<std::vector<Cell>> block = cells()) {
    const std::size_t width = block->size() / std::min<std::size_t>(SampleBlock::most_rows, places.rows.size() - next);
    for (std::size_t at = 0; at < block->size(); at += width) {
      use(places.rows[next++], std::span(*block).subspan(at, width));
    }
  }
}

}  // namespace tcb
