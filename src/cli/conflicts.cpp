// Conflicts: options that change nothing of the product or its format by their rows in the table of options, and a
// table of those that exclude each other, need another, or have no effect.
#include "cli/options.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "error.hpp"
#include "numbers/print_number.hpp"
#include "sample/curve_spec.hpp"
#include "sample/table.hpp"
#include "schema/format.hpp"
#include "text/suggest.hpp"

namespace tcb {
namespace {

using Typed = TypedOptions;

/// Names of options, with blanks between them.
using OptionNames = std::string_view;

using When = bool (*)(const Typed& typed);

/// What each of some options has to do with others, if it is given.
struct Conflict {
  enum class Kind {
    excludes,       ///< at most one of the option and each of the others can be given
    needs,          ///< one of the others has to be given as well
    disables,       ///< the others have no effect with the option
    has_no_effect,  ///< the option itself has none
  };
  OptionNames options;
  Kind kind;
  OptionNames others = {};
  std::string_view reason = {};  ///< goes on after the last option in the message
  When when = nullptr;           ///< nothing: always
};
using enum Conflict::Kind;

bool writes_picture(const Typed& typed) { return typed.output.format->is_picture; }
bool writes_scene(const Typed& typed) { return typed.output.format->has_nodes; }

bool writes_no_report(const Typed& typed) { return !typed.output.format->has_reports && !writes_picture(typed); }

template <class Predicate>
bool any_field(const Typed& typed, Predicate predicate) {
  return std::ranges::any_of(typed.output.fields, [&](std::size_t field) { return predicate(fields()[field]); });
}

bool needs_all_channels(const Typed& typed) {
  const bool times_of_distances = typed.keys.rules.parameter && typed.keys.rules.parameter->exponent != 0;
  return typed.has("--equal-speed") || times_of_distances;
}

bool closes_curve(const Typed& typed) {
  const CurveSettings& rules = typed.keys.rules;
  return rules.period || (rules.closed && rules.closed->value);
}

bool paces_by_profile(const Typed& typed) { return typed.pace_profile.has_value(); }

bool extends_curve(const Typed& typed) {
  return typed.keys.rules.extrapolate && typed.keys.rules.extrapolate->extend_curve();
}

/// The curve is extended, but all samples are on it, as with steps and counts without a range in time.
bool stays_on_curve(const Typed& typed) {
  const bool has_range_of_times = !by_length(typed.sampling.mode) && (typed.has("--from") || typed.has("--to"));
  return extends_curve(typed) && !typed.has("--at") && !has_range_of_times;
}

bool has_one_mark_for_two(const Typed& typed) {
  const NumberMarks& marks = typed.keys.input.delimited.marks;
  return marks.decimal == marks.thousands;
}

/// The conflicts, in the order of the options. Where several apply, an error is about the first.
constexpr Conflict conflicts[] = {
    {"--null", needs, "--files"},
    {"--recursive", needs, "--output-dir --explain"},
    {"--suffix --update", needs, "--output-dir", ", an output for each file"},

    {"--check --identify --limits", disables, "--output-format --plot", ", whose report is text, json or svg",
     [](const Typed& typed) { return writes_no_report(typed) && (is_comparison(typed) || prints_limits(typed)); }},
    {"--retime", needs, "--limits"},
    {"--retime", disables, "--exact-input", ", which measures the curve through the doubles nearest to the numbers"},
    {"--retime", disables, "--output-dir --files", ", which computes the times of one file"},

    {"--delimiter", excludes, "--decimal", "",
     [](const Typed& typed) {
       const DelimitedOptions& text = typed.keys.input.delimited;
       return text.marks.decimal == ',' && text.delimiter == ',';
     }},
    {"--header", excludes, "--no-header"},
    {"--thousands", needs, "--decimal", ", as the point is the decimal mark", has_one_mark_for_two},
    {"--thousands", excludes, "--decimal", ", as it would be both", has_one_mark_for_two},
    {"--missing", excludes, "--equal-speed --parameter", ", as all channels are needed at each key",
     [](const Typed& typed) {
       return typed.keys.input.keys.missing == Missing::skip_cell && needs_all_channels(typed);
     }},
    {"--max-gap", excludes, "--closed --period", "", closes_curve},
    {"--time-unit", excludes, "--input-fps"},
    {"--time-start", needs, "--input-fps", ", the rate of the rows"},
    {"--input-fps", excludes, "--parameter", ", as both give rows their times",
     [](const Typed& typed) { return typed.keys.rules.parameter && typed.keys.rules.parameter->exponent != 0; }},
    {"--angles", needs, "--rotation --rotation-output", ", which tells where angles are"},

    {"--tangents", disables, "--tcb --tcb-scale --ends --equal-speed --no-overshoot",
     ", which draws straight lines between keys", [](const Typed& typed) { return is_linear(typed.keys.rules); }},

    {"--metric", has_no_effect, {}, ", as no length or speed is requested", needs_no_metric},

    {"--count", excludes, "--arc-step", "; --arc-count takes N samples by arc length"},
    {sampling_options, excludes, sampling_options},
    {"--count --arc-count", disables, "--end"},
    {"--per-segment --at --arc-at", disables, "--from --to --end --keys"},
    {"--tolerance", disables, "--from --to --end"},
    {"--pace", excludes, "--arc-step --arc-count --arc-at --tolerance",
     ", as the pace places rows at times along the curve"},
    {"--pace", excludes, "--keys", ", as a pace replaces the times of the keys"},
    {"--pace", excludes, "--extrapolate", ", as a pace stays on the curve"},
    {"--pace", excludes, "--retime", ", as limits are those of the motion by the times of the keys"},
    {"--pace", excludes, "--fields", ", as jerk is that of the times of the keys",
     [](const Typed& typed) { return any_field(typed, [](const Field& field) { return field.name == "jerk"; }); }},
    {"--pace", excludes, "--golden", ", as the distances of a profile are doubles", paces_by_profile},
    {"--pace", excludes, "--time-zero", ", as rows have the times of the profile", paces_by_profile},
    {"--pace", needs, "--step --rate --fps --count --per-segment --at", ", rows at times"},
    {"--emit", disables, "--extrapolate", ", whose pieces lie between keys", extends_curve},
    {"--emit", disables, "--end --keys"},
    {"--fit", excludes, "--plot"},
    {sampling_options, disables, "--extrapolate", " alone, whose samples are on the curve", stays_on_curve},
    {"--plot", disables, "--extrapolate", " alone, whose samples are on the curve", stays_on_curve},

    {"--output", excludes, "--output-dir"},
    {"--output-format", excludes, "--plot"},
    {"--output-format", disables, "--emit", ", whose pieces have the form hermite",
     [](const Typed& typed) { return writes_scene(typed) && typed.form && *typed.form != field_of("hermite"); }},
    {"--plot", disables, "--end --keys", ", as no samples are requested",
     [](const Typed& typed) { return !has_sampling_option(typed); }},
    {"--fields", excludes, "--emit", ", as a piece has the fields s and length only",
     [](const Typed& typed) {
       return any_field(typed, [](const Field& field) { return !field.of_piece && field.name != "s"; });
     }},
    {"--fields", needs, "--emit", ", for the length of each piece",
     [](const Typed& typed) { return any_field(typed, [](const Field& field) { return field.of_piece; }); }},
    {"--side",
     has_no_effect,
     {},
     " on these fields, which are the same on both sides",
     [](const Typed& typed) {
       if (is_comparison(typed) && !typed.has("--fields")) return false;  // it may have any field
       return !any_field(typed, [](const Field& field) { return field.has_side; });
     }},
    {"--digits", excludes, "--fixed --hex"},
    {"--digits", needs, "--golden", ", as a double has 17 significant digits",
     [](const Typed& typed) { return typed.output.notation.count > digits_of_double; }},
    {"--fixed", excludes, "--hex"},
    {"--golden", excludes, "--fields", ", as the exact s has no error",
     [](const Typed& typed) { return any_field(typed, [](const Field& field) { return !field.is_exact; }); }},
    {"--exact-input", needs, "--golden"},
    {"--output-decimal", excludes, "--hex"},
    {"--output-decimal", needs, "--output-delimiter", ", as the comma is the delimiter of csv",
     [](const Typed& typed) {
       const bool is_comma = typed.output.format->delimiter == ',';
       return typed.output.decimal == ',' && !typed.output.delimiter && is_comma;
     }},
    {"--output-decimal", excludes, "--output-delimiter", ", as the comma cannot be both",
     [](const Typed& typed) { return typed.output.decimal == ',' && typed.output.delimiter == ','; }},
    {"--time-format", needs, "--input-fps", ", the rate of the frames",
     [](const Typed& typed) { return typed.output.time_notation && counts_frames(*typed.output.time_notation); }},
};

/// A name, with the value if the conflict depends on values.
std::string shown(const Typed& typed, std::string_view option, When when) {
  const ValueKind kind = row_of(option).kind;
  const bool with_value = when != nullptr && kind != ValueKind::flag && typed.has(option);
  return std::string(option) + (with_value ? (kind == ValueKind::attached ? "=" : " ") + typed.value(option) : "");
}

/// Throws: Error (usage) if an option that is given is in this conflict.
void require_none(const Conflict& conflict, std::string_view name, const Typed& typed) {
  const auto others = split(conflict.others, ' ');
  const auto is_given = [&](std::string_view other) { return other != name && typed.has(other); };
  const auto other = std::ranges::find_if(others, is_given);
  const bool has_other = other != others.end();
  const bool needs_other = conflict.kind == needs || conflict.kind == has_no_effect;
  if (has_other == needs_other || (conflict.when != nullptr && !conflict.when(typed))) return;
  const std::string option = shown(typed, name, conflict.when);
  switch (conflict.kind) {
    case excludes:
      throw usage_error("{} and {} cannot be combined{}; expected only one; remove the other", option,
                        shown(typed, *other, conflict.when), conflict.reason);
    case needs:
      throw usage_error("{} needs {}{}; give {}, or neither", option, fmt::join(others, " or "), conflict.reason,
                        others.size() > 1 ? "one of them as well" : "both");
    case disables:
      throw usage_error("{0} has no effect with {1}{2}; remove {0}", shown(typed, *other, conflict.when), option,
                        conflict.reason);
    case has_no_effect: throw usage_error("{} has no effect{}; remove it", option, conflict.reason);
  }
}

/// A product, the options that request it, and what it is, as the end of an error about one without effect on it.
struct ProductRow {
  int products;
  OptionNames options;
  std::string_view reason;
};
constexpr ProductRow product_rows[] = {
    {of_check | of_expected_rows, "--check", ", which takes the samples of its file and prints a report"},
    {of_identify, "--identify", ", which tries all rules on the positions in its file"},
    {of_limits, "--limits", ", which prints a report on whole curves"},
    {of_explanation | of_explained_samples, "--explain", ", which prints no rows"},
    {of_fit, "--fit", ", which prints keys with the default rules, with the digits that they need"},
    {of_picture | of_drawn_samples, "--plot --output-format", ", which draws the curve and has no rows"},
    {of_pieces, "--emit", ", whose pieces lie between keys"},
};

/// The same products with requested samples.
int with_samples(Product product) {
  return product == of_check || product == of_picture || product == of_explanation ? product * 2 : 0;
}

/// Throws: Error (usage) for an option that changes no byte of the product.
void require_effect_on_product(const Typed& typed, const OptionRow& option) {
  const Product product = product_of(typed);
  const int products = option.effect.products;
  if ((products & product) != 0) return;
  std::vector<std::string_view> requests;
  for (const ProductRow& row : product_rows) {
    if ((row.products & products) != 0) requests.push_back(split(row.options, ' ').front());
  }
  const bool is_requested = std::ranges::any_of(requests, [&](std::string_view name) { return typed.has(name); });
  if ((products & of_samples) == 0 && !is_requested) {
    throw usage_error("{} needs {}; give {}, or neither", option.name, fmt::join(requests, " or "),
                      requests.size() > 1 ? "one of them as well" : "both");
  }
  const ProductRow& row = *std::ranges::find_if(
      product_rows, [&](const ProductRow& candidate) { return (candidate.products & product) != 0; });
  const auto names = split(row.options, ' ');
  const auto name = *std::ranges::find_if(names, [&](std::string_view request) { return typed.has(request); });
  const bool lacks_samples = (products & with_samples(product)) != 0;
  throw usage_error("{0} has no effect with {1}{2}; remove {0}", option.name,
                    shown(typed, name, name == "--output-format" ? writes_picture : nullptr),
                    lacks_samples ? ", as no samples are requested" : row.reason);
}

/// What a format has, and what one without it is, as the end of an error.
struct OfferRow {
  offer::Offer offer;
  std::string_view reason;
};
constexpr OfferRow offer_rows[] = {
    {offer::any_columns, "whose columns are its own"},
    {offer::column_names, "which has no names of columns"},
    {offer::keys, "whose rows are no keys"},
    {offer::pieces, "whose rows are poses"},
    {offer::decimals, "whose numbers are not text"},
    {offer::times, "which has no times"},
    {offer::words_of_time, "which holds numbers only"},
    {offer::marks, "which is not delimited text"},
    {offer::any_delimiter, "whose delimiter is not chosen"},
    {offer::provenance, "which has no comments"},
    {offer::drawing, "which is no picture"},
};

/// Throws: Error (usage) for an option that asks for what the format of rows does not have.
void require_effect_on_format(const Typed& typed, const OptionRow& option) {
  const offer::Offer asked = option.effect.asks_for;
  constexpr int reports = of_check | of_expected_rows | of_identify | of_limits;
  if (typed.output.format->offers(asked) || (asked != offer::drawing && (product_of(typed) & reports) != 0)) return;
  const std::string_view given = typed.has("--plot") ? "--plot" : "--output-format";
  throw usage_error("{0} has no effect {1}, {2}; remove {0}", shown(typed, option.name, writes_picture),
                    typed.has(given) ? "with " + shown(typed, given, writes_picture)
                                     : fmt::format("on {}", typed.output.format->name),
                    std::ranges::find(offer_rows, asked, &OfferRow::offer)->reason);
}

}  // namespace

Product product_of(const TypedOptions& typed) {
  const bool has_samples = has_sampling_option(typed);
  if (typed.has("--check")) return has_samples ? of_expected_rows : of_check;
  if (typed.has("--identify")) return of_identify;
  if (prints_limits(typed)) return of_limits;
  if (typed.has("--explain")) return has_samples || typed.has("--plot") ? of_explained_samples : of_explanation;
  if (typed.has("--fit")) return of_fit;
  if (writes_picture(typed)) return has_samples ? of_drawn_samples : of_picture;
  return typed.has("--emit") ? of_pieces : of_samples;
}

bool has_sampling_option(const TypedOptions& typed) {
  return std::ranges::any_of(split(sampling_options, ' '), [&](std::string_view option) { return typed.has(option); });
}

bool is_comparison(const TypedOptions& typed) { return typed.has("--check") || typed.has("--identify"); }
bool prints_limits(const TypedOptions& typed) { return typed.has("--limits") && !typed.has("--retime"); }

bool needs_no_metric(const TypedOptions& typed) {
  const bool by_metric =
      by_length(typed.sampling) || typed.has("--tolerance") || typed.has("--fit") || needs_all_channels(typed);
  if (typed.has("--identify")) return !needs_all_channels(typed);
  return !typed.has("--check") && !typed.has("--limits") && !writes_picture(typed) && !by_metric &&
         !any_field(typed, [](const Field& field) { return field.needs_lengths || field.over_metric; });
}

void require_no_conflict(const TypedOptions& typed) {
  for (const OptionRow& option : option_table()) {
    if (typed.has(option.name)) require_effect_on_product(typed, option);
  }
  for (const OptionRow& option : option_table()) {
    if (typed.has(option.name)) require_effect_on_format(typed, option);
  }
  for (const Conflict& conflict : conflicts) {
    for (const std::string_view option : split(conflict.options, ' ')) {
      if (typed.has(option)) require_none(conflict, option, typed);
    }
  }
}

}  // namespace tcb
