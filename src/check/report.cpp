// Reports of comparisons: as text, as JSON, and in a line.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "check/check.hpp"
#include "check/ranking.hpp"
#include "numbers/print_number.hpp"
#include "text/utf8.hpp"
#include "write/layout.hpp"

namespace tcb {
namespace {

constexpr std::size_t most_listed = 30, most_ranked = 10;

/// The shortest text that reads back as the same double; "nothing" for NaN, "-" for an infinite number.
std::string number_text(double value) {
  if (std::isnan(value)) return "nothing";
  if (std::isinf(value)) return "-";
  std::string text;
  append_number(text, value);
  return text;
}

/// A number for JSON; null if it is not finite.
std::string number_json(double value) { return std::isfinite(value) ? number_text(value) : "null"; }

/// The last lines that all reports have.
std::string remarks(const ComparisonSummary& summary) {
  std::string out;
  for (const std::string& problem : summary.problems) out += fmt::format("problem: {}\n", printable(problem));
  if (!summary.ignored.empty())
    out += fmt::format("not compared: {}\n", printable(fmt::format("{}", fmt::join(summary.ignored, ", "))));
  return out;
}

std::string text(const Distance& distance) {
  return fmt::format("abs {}, rel {}, ulp {}", number_text(distance.abs), number_text(distance.rel), distance.ulp);
}

std::string text(const Difference& difference, const std::string& file) {
  const bool both = !std::isnan(difference.given) && !std::isnan(difference.computed);
  return fmt::format("{}:{}: row {}, {}: {} instead of {}{}", printable(file), difference.line, difference.row,
                     printable(difference.column), number_text(difference.given), number_text(difference.computed),
                     both ? "; " + text(difference.distance) : "");
}

std::string json(const Distance& distance) {
  return fmt::format("\"abs\":{},\"rel\":{},\"ulp\":{}", number_json(distance.abs), number_json(distance.rel),
                     std::isfinite(distance.abs) ? fmt::format("{}", distance.ulp) : "null");
}

std::string json(const std::optional<Difference>& difference) {
  if (!difference) return "null";
  return fmt::format("{{\"row\":{},\"line\":{},\"column\":{},\"theirs\":{},\"ours\":{},{}}}", difference->row,
                     difference->line, json_text(difference->column), number_json(difference->given),
                     number_json(difference->computed), json(difference->distance));
}

/// The number of rows that all curves should have; nothing if it is unknown for one of them.
std::optional<std::uint64_t> expected_rows(const Check& check) {
  if (check.coverage.empty()) return std::nullopt;
  std::uint64_t sum = 0;
  for (const Coverage& coverage : check.coverage) {
    if (!coverage.expected_rows) return std::nullopt;
    sum += *coverage.expected_rows;
  }
  return sum;
}

/// How many rows are expected; for a curve where that is unknown, how much of it the rows cover.
std::string coverage_text(const Check& check) {
  if (const auto rows = expected_rows(check)) return fmt::format("expected rows: {}\n", *rows);
  std::string out;
  for (const Coverage& coverage : check.coverage) {
    const std::string curve =
        coverage.curve.empty() ? "" : fmt::format(" of curve {}", fmt::join(coverage.curve, ", "));
    const std::string covered = coverage.covered
                                    ? fmt::format("{} {} to {}", coverage.place, time_text(coverage.covered->first),
                                                  time_text(coverage.covered->second))
                                    : "nothing";
    out += printable(fmt::format("rows{} cover: {} of {} to {}", curve, covered, time_text(coverage.first),
                                 time_text(coverage.last)));
    out += '\n';
  }
  return out;
}

std::string json(const Coverage& coverage) {
  const std::string from = coverage.covered ? time_text(coverage.covered->first) : "null";
  const std::string to = coverage.covered ? time_text(coverage.covered->second) : "null";
  const std::string expected = coverage.expected_rows ? fmt::format("{}", *coverage.expected_rows) : "null";
  return fmt::format("{{\"curve\":{},\"rows\":{},\"expected_rows\":{},\"from\":{},\"to\":{},\"first\":{},\"last\":{}}}",
                     json_list(coverage.curve), coverage.rows, expected, from, to, time_text(coverage.first),
                     time_text(coverage.last));
}

std::string_view samples_at(bool by_length) { return by_length ? "arc lengths" : "times"; }

const TcbOrders& order_of(const Identification& found, const Candidate& candidate) {
  return found.orders[candidate.convention.order];
}

/// A convention in words, such as "tangents velocity, ends one-sided".
std::string title(const Identification& found, const Candidate& candidate) {
  const Convention& convention = candidate.convention;
  const TcbOrder& order = order_of(found, candidate).order;
  std::string text = fmt::format("tangents {}", name_of(convention.tangents));
  if (const auto ends = ends_of(convention, found.parts)) text += ", ends " + *ends;
  if (convention.equal_speed) text += ", equal speed";
  if (convention.timing != spline::Timing::even) text += fmt::format(", timing {}", name_of(convention.timing));
  if (convention.rotation_curve) text += fmt::format(", rotation curve {}", name_of(*convention.rotation_curve));
  if (convention.rotation_preset) text += fmt::format(", rotations as in {}", name_of(*convention.rotation_preset));
  return text + (order.is_plain() ? "" : ", T,C,B from " + order.name());
}

/// The title with the names of the presets of the convention.
std::string full_title(const Identification& found, const Candidate& candidate) {
  const auto found_presets = presets_of(candidate.convention, found.parts);
  return title(found, candidate) + (found_presets.empty() ? "" : fmt::format(" ({})", fmt::join(found_presets, ", ")));
}

/// The conventions that fit, or the nearest one with its differences.
std::string verdict(const Identification& found) {
  const Candidate& best = found.ranking.candidates.front();
  if (!found.fits()) {
    return fmt::format("identify: none fits; the nearest is {}\n", full_title(found, best)) +
           (best.first ? fmt::format("departs first: {}\n", text(*best.first, found.file)) : "") +
           (best.worst ? fmt::format("departs most: {}\n", text(*best.worst, found.file)) : "");
  }
  std::string out = fmt::format("identify: {}\n", full_title(found, best));
  for (std::size_t i = 1; i < std::min(found.ranking.fitting, most_listed); ++i) {
    out += fmt::format("the same here: {}\n", full_title(found, found.ranking.candidates[i]));
  }
  if (found.ranking.fitting > most_listed)
    out += fmt::format("the same here: {} more\n", found.ranking.fitting - most_listed);
  return out;
}

/// The orders of tension, continuity and bias that are equivalent here.
std::string same_orders(const Identification& found) {
  const auto& same = order_of(found, found.ranking.candidates.front()).same;
  if (same.empty()) return "";
  return same.size() + 1 == all_tcb_orders ? "the same here: every order and sign of T, C, B\n"
                                           : fmt::format("the same here: T,C,B from {}\n", fmt::join(same, " or "));
}

std::string row_json(const Identification& found, const Candidate& candidate, bool fits) {
  const Convention& convention = candidate.convention;
  const auto& [curve, preset] = std::pair(convention.rotation_curve, convention.rotation_preset);
  std::string others = curve ? fmt::format("\"rotation_curve\":{},", json_text(name_of(*curve))) : "";
  if (preset) others += fmt::format("\"rotations_as\":{},", json_text(name_of(*preset)));
  if (convention.timing != spline::Timing::even)
    others += fmt::format("\"timing\":{},", json_text(name_of(convention.timing)));
  const std::optional<std::string> ends = ends_of(convention, found.parts);
  return fmt::format(
      "{{\"fits\":{},\"tangents\":{},\"ends\":{},\"equal_speed\":{},{}\"order\":{},\"presets\":{},\"largest\":{},"
      "\"rows_off\":{}}}",
      fits, json_text(name_of(convention.tangents)), ends ? json_text(*ends) : "null", convention.equal_speed, others,
      json_text(order_of(found, candidate).order.name()), json_list(presets_of(convention, found.parts)),
      number_json(candidate.largest), candidate.rows_off);
}

}  // namespace

std::string text(const Check& check) {
  std::string out =
      fmt::format("check: {}\nfile: {}\nkeys: {}\nsamples: at its {}\n", check.passed() ? "passed" : "failed",
                  printable(check.file), printable(check.keys), samples_at(check.by_length));
  out += fmt::format("rows: {}\nvalues: {}\nmismatches: {}\n", check.rows, check.values, check.mismatches);
  if (check.first) out += fmt::format("first: {}\n", text(*check.first, check.file));
  if (check.worst) out += fmt::format("worst: {}\n", text(*check.worst, check.file));
  for (const ColumnCheck& column : check.columns) {
    out += fmt::format("column {}: mismatches {}, largest {}\n", printable(column.name), column.mismatches,
                       text(column.largest));
  }
  return out + coverage_text(check) + remarks(check);
}

std::string json(const Check& check) {
  std::string columns;
  for (const ColumnCheck& column : check.columns) {
    columns += fmt::format("{}\n{{\"name\":{},\"mismatches\":{},{}}}", columns.empty() ? "" : ",",
                           json_text(column.name), column.mismatches, json(column.largest));
  }
  std::string coverage;
  for (const Coverage& one : check.coverage) coverage += (coverage.empty() ? "\n" : ",\n") + json(one);
  return fmt::format(
      "{{\"passed\":{},\"file\":{},\"keys\":{},\"samples\":\"{}\",\n"
      "\"rows\":{},\"values\":{},\"mismatches\":{},\n\"first\":{},\n\"worst\":{},\n"
      "\"columns\":[{}],\n\"coverage\":[{}],\n\"problems\":{},\n\"not_compared\":{}}}\n",
      check.passed(), json_text(check.file), json_text(check.keys), samples_at(check.by_length), check.rows,
      check.values, check.mismatches, json(check.first), json(check.worst), columns, coverage,
      json_list(check.problems), json_list(check.ignored));
}

std::string text(const Identification& found) {
  std::string out = verdict(found) + same_orders(found);
  out += fmt::format("file: {}\nkeys: {}\nsamples: at its {}\nrows: {}\nconventions: {}\n", printable(found.file),
                     printable(found.keys), samples_at(found.by_length), found.rows, found.conventions);
  out += remarks(found);
  out += "rank  largest error           rows off  convention\n";
  for (std::size_t i = 0; i < std::min(found.ranking.candidates.size(), most_ranked); ++i) {
    const Candidate& candidate = found.ranking.candidates[i];
    out += fmt::format("{:<4}  {:<22}  {:<8}  {}\n", i + 1, number_text(candidate.largest), candidate.rows_off,
                       title(found, candidate));
  }
  return out;
}

std::string json(const Identification& found) {
  const Ranking& ranking = found.ranking;
  std::string rows;
  for (std::size_t i = 0; i < std::min(ranking.candidates.size(), std::max(ranking.fitting, most_ranked)); ++i) {
    rows += fmt::format("{}\n{}", i == 0 ? "" : ",", row_json(found, ranking.candidates[i], i < ranking.fitting));
  }
  const Candidate& best = ranking.candidates.front();
  return fmt::format(
      "{{\"fits\":{},\"file\":{},\"keys\":{},\"samples\":\"{}\",\n"
      "\"rows\":{},\"conventions\":{},\"same_orders\":{},\n\"first\":{},\n\"worst\":{},\n"
      "\"ranking\":[{}],\n\"problems\":{},\n\"not_compared\":{}}}\n",
      found.fits(), json_text(found.file), json_text(found.keys), samples_at(found.by_length), found.rows,
      found.conventions, json_list(order_of(found, best).same), json(best.first), json(best.worst), rows,
      json_list(found.problems), json_list(found.ignored));
}

std::string in_short(const Check& check) {
  return fmt::format("check {} · {} rows · {} values · {} mismatches", check.passed() ? "passed" : "failed", check.rows,
                     check.values, check.mismatches);
}

std::string in_short(const Identification& found) {
  return fmt::format("{} · {} · {} rows", title(found, found.ranking.candidates.front()),
                     found.fits() ? "fits" : "the nearest, but it does not fit", found.rows);
}

}  // namespace tcb
