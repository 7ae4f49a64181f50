// Reports: what a comparison came to, as text and as JSON.
#include "compare/report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "compare/words.hpp"
#include "output/layout.hpp"
#include "tcb/spline/rules.hpp"

namespace tcb {
namespace {

constexpr std::size_t most_listed = 30, most_ranked = 10;

std::string text(const Distance& distance) {
  return fmt::format("abs {}, rel {}, ulp {}", number_text(distance.abs), number_text(distance.rel), distance.ulp);
}

std::string text(const Difference& difference, const std::string& file) {
  const bool both = !std::isnan(difference.theirs) && !std::isnan(difference.ours);
  return fmt::format("{}:{}: row {}, {}: {} instead of {}{}", file, difference.line, difference.row, difference.column,
                     number_text(difference.theirs), number_text(difference.ours),
                     both ? "; " + text(difference.distance) : "");
}

std::string json(const Distance& distance) {
  return fmt::format("\"abs\":{},\"rel\":{},\"ulp\":{}", number_json(distance.abs), number_json(distance.rel),
                     std::isfinite(distance.abs) ? fmt::format("{}", distance.ulp) : "null");
}

std::string json(const std::optional<Difference>& difference) {
  if (!difference) return "null";
  return fmt::format("{{\"row\":{},\"line\":{},\"column\":{},\"theirs\":{},\"ours\":{},{}}}", difference->row,
                     difference->line, json_text(difference->column), number_json(difference->theirs),
                     number_json(difference->ours), json(difference->distance));
}

std::string_view samples_at(bool by_length) { return by_length ? "arc lengths" : "times"; }

const TcbOrders& order_of(const Identified& identified, const Candidate& candidate) {
  return identified.orders[candidate.convention.order];
}

/// A convention in words.
std::string title(const Identified& identified, const Candidate& candidate) {
  const TcbOrder& order = order_of(identified, candidate).order;
  return name_of(candidate.convention, identified.closed) + (order.is_plain() ? "" : ", T,C,B from " + order.name());
}

/// The same with the presets that it is.
std::string full_title(const Identified& identified, const Candidate& candidate) {
  const auto presets = presets_of(candidate.convention, identified.closed);
  return title(identified, candidate) + (presets.empty() ? "" : fmt::format(" ({})", fmt::join(presets, ", ")));
}

/// What is said of the one that fits, or of the nearest.
std::string verdict(const Identified& identified) {
  const Candidate& best = identified.ranking.candidates.front();
  if (!identified.fits()) {
    return fmt::format("identify: none fits; the nearest is {}\n", full_title(identified, best)) +
           (best.first ? fmt::format("departs first: {}\n", text(*best.first, identified.file)) : "") +
           (best.worst ? fmt::format("departs most: {}\n", text(*best.worst, identified.file)) : "");
  }
  std::string out = fmt::format("identify: {}\nfits: within {}\n", full_title(identified, best),
                                precisions[*identified.ranking.precision]);
  for (std::size_t i = 1; i < std::min(identified.ranking.fitting, most_listed); ++i) {
    out += fmt::format("the same here: {}\n", full_title(identified, identified.ranking.candidates[i]));
  }
  if (identified.ranking.fitting > most_listed)
    out += fmt::format("the same here: {} more\n", identified.ranking.fitting - most_listed);
  return out;
}

/// What cannot be told of tension, continuity and bias.
std::string same_orders(const Identified& identified) {
  const auto& same = order_of(identified, identified.ranking.candidates.front()).same;
  if (same.empty()) return "";
  return same.size() == 47 ? "the same here: every order and sign of T, C, B\n"
                           : fmt::format("the same here: T,C,B from {}\n", fmt::join(same, " or "));
}

std::string row_json(const Identified& identified, const Candidate& candidate, bool fits) {
  const Convention& convention = candidate.convention;
  return fmt::format(
      "{{\"fits\":{},\"tangents\":{},\"ends\":{},\"equal_speed\":{},\"order\":{},\"presets\":{},\"largest\":{},"
      "\"rows_off\":{}}}",
      fits, json_text(name_of(convention.tangents)), identified.closed ? "null" : json_text(ends_of(convention)),
      convention.equal_speed, json_text(order_of(identified, candidate).order.name()),
      list_json(presets_of(convention, identified.closed)), number_json(candidate.largest), candidate.rows_off);
}

}  // namespace

std::string text(const Check& check) {
  std::string out =
      fmt::format("check: {}\nfile: {}\nkeys: {}\nsamples: at its {}\n", check.passed() ? "passed" : "failed",
                  check.file, check.keys, samples_at(check.by_length));
  out += fmt::format("rows: {}\nvalues: {}\nmismatches: {}\n", check.rows, check.values, check.mismatches);
  if (check.first) out += fmt::format("first: {}\n", text(*check.first, check.file));
  if (check.worst) out += fmt::format("worst: {}\n", text(*check.worst, check.file));
  for (const ColumnCheck& column : check.columns) {
    out += fmt::format("column {}: mismatches {}, largest {}\n", column.name, column.mismatches, text(column.largest));
  }
  for (const std::string& problem : check.problems) out += fmt::format("problem: {}\n", problem);
  if (!check.ignored.empty()) out += fmt::format("not compared: {}\n", fmt::join(check.ignored, ", "));
  return out;
}

std::string json(const Check& check) {
  std::string columns;
  for (const ColumnCheck& column : check.columns) {
    columns += fmt::format("{}\n{{\"name\":{},\"mismatches\":{},{}}}", columns.empty() ? "" : ",",
                           json_text(column.name), column.mismatches, json(column.largest));
  }
  return fmt::format(
      "{{\"passed\":{},\"file\":{},\"keys\":{},\"samples\":\"{}\",\n\"rows\":{},\"values\":{},\"mismatches\":{},\n"
      "\"first\":{},\n\"worst\":{},\n\"columns\":[{}],\n\"problems\":{},\n\"not_compared\":{}}}\n",
      check.passed(), json_text(check.file), json_text(check.keys), samples_at(check.by_length), check.rows,
      check.values, check.mismatches, json(check.first), json(check.worst), columns, list_json(check.problems),
      list_json(check.ignored));
}

std::string text(const Identified& identified) {
  std::string out = verdict(identified) + same_orders(identified);
  out += fmt::format("file: {}\nkeys: {}\nsamples: at its {}\nrows: {}\nconventions: {}\n", identified.file,
                     identified.keys, samples_at(identified.by_length), identified.rows, identified.conventions);
  for (const std::string& problem : identified.problems) out += fmt::format("problem: {}\n", problem);
  if (!identified.ignored.empty()) out += fmt::format("not compared: {}\n", fmt::join(identified.ignored, ", "));
  out += "rank  largest error           rows off  convention\n";
  for (std::size_t i = 0; i < std::min(identified.ranking.candidates.size(), most_ranked); ++i) {
    const Candidate& candidate = identified.ranking.candidates[i];
    out += fmt::format("{:<4}  {:<22}  {:<8}  {}\n", i + 1, number_text(candidate.largest), candidate.rows_off,
                       title(identified, candidate));
  }
  return out;
}

std::string json(const Identified& identified) {
  const Ranking& ranking = identified.ranking;
  std::string rows;
  for (std::size_t i = 0; i < std::min(ranking.candidates.size(), std::max(ranking.fitting, most_ranked)); ++i) {
    rows += fmt::format("{}\n{}", i == 0 ? "" : ",", row_json(identified, ranking.candidates[i], i < ranking.fitting));
  }
  const Candidate& best = ranking.candidates.front();
  return fmt::format(
      "{{\"fits\":{},\"within\":{},\"file\":{},\"keys\":{},\"samples\":\"{}\",\n\"rows\":{},\"conventions\":{},"
      "\"same_orders\":{},\n\"first\":{},\n\"worst\":{},\n\"ranking\":[{}],\n\"problems\":{},\n\"not_compared\":{}}}\n",
      identified.fits(), ranking.precision ? json_text(precisions[*ranking.precision]) : "null",
      json_text(identified.file), json_text(identified.keys), samples_at(identified.by_length), identified.rows,
      identified.conventions, list_json(order_of(identified, best).same), json(best.first), json(best.worst), rows,
      list_json(identified.problems), list_json(identified.ignored));
}

}  // namespace tcb
