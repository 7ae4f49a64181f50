// Pairs: which of someone's rows are samples of which curve.
#include "compare/pairs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "input/texts.hpp"

namespace tcb {
namespace {

bool is_told(const std::vector<std::string>& group) {
  return std::ranges::any_of(group, [](const std::string& text) { return !text.empty(); });
}

/// What tells a curve apart, as it stands in a table.
std::vector<std::string> contents(const std::vector<std::string>& group) {
  std::vector<std::string> texts;
  for (const std::string& text : group) texts.emplace_back(content(text));
  return texts;
}

std::string title(const std::vector<std::string>& names, const std::vector<std::string>& group) {
  std::string text = "curve";
  for (std::size_t i = 0; i < group.size() && i < names.size(); ++i) {
    text += fmt::format(" {}={}", names[i], content(group[i]));
  }
  return text;
}

/// All rows as if they were those of one curve.
SampleRows joined(std::vector<SampleRows>& parts) {
  SampleRows all;
  for (SampleRows& part : parts) {
    all.times.insert(all.times.end(), part.times.begin(), part.times.end());
    all.numbers.insert(all.numbers.end(), part.numbers.begin(), part.numbers.end());
    all.lines.insert(all.lines.end(), part.lines.begin(), part.lines.end());
  }
  return all;
}

Pairs by_group(const KeptCurves& kept, SampleTable& table) {
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
    if (rows.size() == 0) result.problems.push_back(title(kept.input.groups, curve.group) + " has no rows");
    if (rows.size() > 0) result.pairs.push_back({&curve, std::move(rows)});
  }
  for (std::size_t i = 0; i < taken.size(); ++i) {
    if (taken[i]) continue;
    result.problems.push_back(fmt::format("{} of the rows in line {} and below has no keys",
                                          title(kept.input.groups, table.curves[i].group),
                                          table.curves[i].lines.at(0)));
  }
  return result;
}

}  // namespace

Pairs pair_up(const KeptCurves& kept, SampleTable& table) {
  if (kept.curves.size() > 0 && is_told(kept.curves[0].group) && !table.curves.empty() &&
      is_told(table.curves[0].group)) {
    return by_group(kept, table);
  }
  Pairs result;
  if (kept.curves.size() == 1) {
    result.pairs.push_back({&kept.curves[0], joined(table.curves)});
    return result;
  }
  const std::size_t both = std::min(kept.curves.size(), table.curves.size());
  for (std::size_t i = 0; i < both; ++i) result.pairs.push_back({&kept.curves[i], std::move(table.curves[i])});
  if (kept.curves.size() != table.curves.size()) {
    result.problems.push_back(
        fmt::format("the rows are those of {} curves; the keys make {}; the first {} are compared", table.curves.size(),
                    kept.curves.size(), both));
  }
  return result;
}

Compared compared(const ComparisonInputs& sides, const Pairs& pairs) {
  Compared result{sides.file, sides.keys, sides.columns.by_length, sides.columns.ignored, sides.columns.problems};
  result.problems.insert(result.problems.end(), pairs.problems.begin(), pairs.problems.end());
  return result;
}

}  // namespace tcb
