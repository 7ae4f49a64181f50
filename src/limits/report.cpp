// Reports of limits: maxima as decimals around them, as text and as JSON.
#include "limits/report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

#include "exact/rounding.hpp"
#include "numbers/print_number.hpp"
#include "text/utf8.hpp"
#include "write/layout.hpp"

namespace tcb::limits {
namespace {

constexpr int most_digits = 15;

/// The largest whole number up to a number, or to its root. Requires for a root: 0 <= value < 10^32.
Rational whole_below(const Rational& value, bool root) {
  if (!root) return floor(value);
  Rational whole = floor(Rational(std::sqrt(nearest_double(value))));
  while (whole * whole > value) whole -= 1;
  while ((whole + 1) * (whole + 1) <= value) whole += 1;
  return whole;
}

/// The exponent of the first digit of a decimal. Requires: value > 0, finite.
int decimal_exponent(double value) {
  const std::string text = fmt::format("{:.17e}", value);
  const std::size_t mark = text.find('e') + 1;
  const int size = static_cast<int>(whole_number(*parse_rational(std::string_view(text).substr(mark + 1))));
  return text[mark] == '-' ? -size : size;
}

Rational power_of_ten(int exponent) { return *parse_rational(fmt::format("1e{}", exponent)); }

/// A measure of a curve in words: a maximum and a minimum of the same number have their own.
std::string_view extreme_of(const Measure& measure) {
  if (measure.is_size()) return "size";
  return measure.kind == Measure::Kind::smallest ? "minimum" : "maximum";
}

/// The numbers of a result as texts.
struct ResultTexts {
  std::string maximum = "null", bound = "null", time = "null", limit = "null", factor = "null";
  std::string_view side = "null", passed = "null";
  double part = 0;  ///< of the limit
};

std::string number_text(double value) {
  if (!std::isfinite(value)) return "null";
  std::string text;
  append_number(text, value);
  return text;
}

std::string decimal_text(const Rational& decimal) {
  return std::isfinite(nearest_double(decimal)) ? digits_text(decimal, most_digits) : "null";
}

ResultTexts texts_of(const LimitResult& result) {
  ResultTexts texts;
  if (result.limit) {
    texts.limit = number_text(nearest_double(*result.limit));
    texts.passed = result.passed ? "true" : "false";
  }
  if (!result.extreme) return texts;
  const Extreme& extreme = *result.extreme;
  if (extreme.is_unproved) return texts;
  texts.time = time_text(nearest_time(extreme.time));
  texts.side = extreme.side == spline::Side::left ? "left" : "right";
  if (extreme.is_unbounded) {
    texts.part = std::numeric_limits<double>::infinity();
    return texts;
  }
  auto [low, high] = decimal_bounds(extreme.low, extreme.high, result.measure.is_size());
  if (result.measure.kind == Measure::Kind::smallest) {
    low = -low;
    high = -high;
  }
  texts.maximum = decimal_text(low);
  texts.bound = decimal_text(high);
  if (!result.limit || *result.limit == 0) return texts;
  texts.part = nearest_double(low) / nearest_double(*result.limit) + 0;
  texts.factor = number_text(texts.part);
  return texts;
}

std::string names_of(const Corner& corner, const LimitsReport& report, std::string (*written)(std::string_view),
                     std::string_view between) {
  std::string names;
  for (const std::size_t channel : corner.channels) {
    names.append(names.empty() ? "" : between).append(written(report.channels[channel]));
  }
  return names;
}

std::string in_curve(const std::vector<std::string>& curve) {
  return curve.empty() ? "" : printable(fmt::format(" of curve {}", fmt::join(curve, ", ")));
}

std::string text(const LimitResult& result) {
  const ResultTexts texts = texts_of(result);
  const bool is_size = result.measure.is_size();
  std::string line = fmt::format("{}{}{}{}: ", printable(result.measure.name), is_size ? "" : " ",
                                 is_size ? "" : extreme_of(result.measure), in_curve(result.curve));
  if (!result.extreme) return line + "nothing in this range\n";
  if (result.extreme->is_unproved) return line + "no bound is proved, as numbers are too far apart\n";
  const std::string side = result.extreme->is_at_key ? fmt::format(" on the {} side", texts.side) : "";
  if (result.extreme->is_unbounded) {
    line += fmt::format("without a bound at time {}{}, where the curve rests", texts.time, side);
  } else if (texts.bound == "null") {
    line += fmt::format("beyond the range of doubles at time {}{}", texts.time, side);
  } else {
    line += fmt::format("{} at time {}{}, certainly {} {}", texts.maximum, texts.time, side,
                        result.measure.kind == Measure::Kind::smallest ? "at least" : "at most", texts.bound);
  }
  if (!result.limit) return line + '\n';
  return line + fmt::format("; limit {}{}: {}\n", texts.limit,
                            texts.factor == "null" ? "" : fmt::format(", {} of it", texts.factor),
                            result.passed      ? "passed"
                            : result.is_broken ? "failed, as the velocity jumps"
                                               : "failed");
}

}  // namespace

DecimalBounds decimal_bounds(const Rational& low, const Rational& high, bool root) {
  Rational size = std::max(abs(low), abs(high));
  if (size == 0) return {};
  int beyond = 0;  // of the exponents of doubles
  for (; size >= power_of_ten(300); beyond += 200) size /= power_of_ten(200);
  for (; size < power_of_ten(-200); beyond -= 200) size *= power_of_ten(200);
  const double rough = nearest_double(size);
  const int exponent = root ? beyond / 2 + decimal_exponent(std::sqrt(rough)) : beyond + decimal_exponent(rough);
  for (const int most_apart : {1, 2, 1'000'000'000}) {
    for (int digits = most_digits; digits > 0; --digits) {
      const Rational unit = power_of_ten(exponent - digits + 1);
      const Rational scale = root ? unit * unit : unit;
      const Rational below = whole_below(low / scale, root), near = whole_below(high / scale, root);
      const bool is_exact = (root ? near * near : near) * scale == high;
      const Rational above = is_exact ? near : near + 1;
      if (above - below <= Rational(most_apart)) return {below * unit, above * unit};
    }
  }
  return {};
}

const LimitResult* LimitsReport::tightest() const {
  const LimitResult* tightest = nullptr;
  for (const LimitResult& result : results) {
    if (!result.extreme || result.extreme->is_unproved) continue;
    const auto rank = [](const LimitResult& of) { return std::pair(!of.passed, texts_of(of).part); };
    if (tightest == nullptr || rank(result) > rank(*tightest)) tightest = &result;
  }
  return tightest;
}

std::string in_short(const LimitsReport& report) {
  const std::string result = report.passed() ? "limits: passed" : "limits: failed";
  const LimitResult* const tightest = report.tightest();
  if (tightest == nullptr) return result;
  const ResultTexts texts = texts_of(*tightest);
  const std::string part = texts.factor == "null" ? "" : fmt::format(", {} of its limit", texts.factor);
  return fmt::format("{} · {}: {}{}", result, tightest->measure.name,
                     tightest->extreme->is_unbounded ? "without a bound" : texts.maximum, part);
}

std::string text(const LimitsReport& report) {
  std::string out =
      fmt::format("limits: {}\nkeys: {}\n", report.passed() ? "passed" : "failed", printable(report.keys));
  for (const LimitResult& result : report.results) out += text(result);
  for (const auto& [curve, corner] : report.corners) {
    out += fmt::format("corner{}: at time {} the velocity jumps by {} ({})\n", in_curve(curve), time_text(corner.time),
                       number_text(corner.jump), names_of(corner, report, printable, ", "));
  }
  return out;
}

std::string json(const LimitsReport& report) {
  std::string limits, corners;
  for (const LimitResult& result : report.results) {
    const ResultTexts texts = texts_of(result);
    limits += fmt::format(
        "{}\n{{\"curve\":{},\"name\":{},\"extreme\":\"{}\",\"maximum\":{},\"bound\":{},\"time\":{},\"side\":{},"
        "\"limit\":{},\"factor\":{},\"passed\":{}}}",
        limits.empty() ? "" : ",", json_list(result.curve), json_text(result.measure.name), extreme_of(result.measure),
        texts.maximum, texts.bound, texts.time, texts.side == "null" ? "null" : json_text(texts.side), texts.limit,
        texts.factor, texts.passed);
  }
  for (const auto& [curve, corner] : report.corners) {
    corners += fmt::format("{}\n{{\"curve\":{},\"time\":{},\"jump\":{},\"channels\":[{}]}}", corners.empty() ? "" : ",",
                           json_list(curve), time_text(corner.time), number_text(corner.jump),
                           names_of(corner, report, json_text, ","));
  }
  return fmt::format("{{\"passed\":{},\"keys\":{},\n\"limits\":[{}],\n\"corners\":[{}]}}\n", report.passed(),
                     json_text(report.keys), limits, corners);
}

}  // namespace tcb::limits
