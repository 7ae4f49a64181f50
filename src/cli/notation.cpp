// How numbers are printed: the options that say it, and which of them have a meaning together.
#include "cli/notation.hpp"

#include <fmt/format.h>

#include <charconv>
#include <vector>

#include "curve/fields.hpp"
#include "error.hpp"
#include "text/suggest.hpp"

namespace tcb {
namespace {

using Kind = Notation::Kind;

int count(std::string_view option, const std::string& text, int least) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = error == std::errc() && end == text.data() + text.size();
  if (!whole || value < least || value > most_digits)
    refuse_value(option, text, fmt::format("a whole number from {} to {}", least, most_digits));
  return value;
}

}  // namespace

Notation make_notation(const TypedOptions& typed, FormatId output_format) {
  std::vector<std::string_view> given;
  Notation notation;
  if (!typed.digits.empty()) {
    given.emplace_back("--digits");
    notation = {Kind::digits, count("--digits", typed.digits, 1)};
    if (notation.count > digits_of_double && !typed.golden) {
      throw Error(Exit::usage,
                  fmt::format("--digits {}: a double has {} digits that say something; expected as many at "
                              "most, or --golden, which works out more; give one of the two",
                              typed.digits, digits_of_double));
    }
  }
  if (!typed.fixed.empty()) {
    given.emplace_back("--fixed");
    notation = {Kind::fixed, count("--fixed", typed.fixed, 0)};
  }
  if (typed.hex) {
    given.emplace_back("--hex");
    notation = {Kind::hex};
  }
  if (given.size() > 1) {
    throw Error(Exit::usage,
                fmt::format("{} and {} both say how numbers are printed; expected one of them; take one out", given[0],
                            given[1]));
  }
  const Format& output = format_of(output_format);
  if (!given.empty() && output.is_binary) {
    throw Error(Exit::usage, fmt::format("{} has no effect on {}, which holds the doubles themselves; take it out",
                                         given[0], output.name));
  }
  if (typed.hex && !output.has_header) {
    throw Error(Exit::usage,
                fmt::format("--hex: {} has no hexadecimal numbers; expected csv, tsv or ssv; take one of the "
                            "two out",
                            output.name));
  }
  return notation;
}

void set_golden(Job& plan, const TypedOptions& typed) {
  if (typed.exact_input && !typed.golden) {
    throw Error(Exit::usage,
                "--exact-input has no effect without --golden, which works exactly; give both, or neither");
  }
  if (!typed.golden) return;
  for (const std::size_t field : plan.fields) {
    if (fields()[field].is_exact) continue;
    throw Error(Exit::usage, fmt::format("--golden: {} is about the error of s, which then is only rounded; take the "
                                         "field out",
                                         fields()[field].name));
  }
  plan.golden = GoldenOptions{typed.exact_input, plan.notation};
  plan.input.keeps_decimals = typed.exact_input;
}

}  // namespace tcb
