// Words for errors: from codes, subjects and values to what was wrong, what was expected, and the remedy.
#include "cli/remedies.hpp"

#include <fmt/args.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "text/refusal.hpp"

namespace tcb {
namespace {

/// The words of a code. {0}, {1}, … are its values, lists joined by ", "; {subject} is the option, as --NAME, or the
/// member of JSON that the error is about.
struct Words {
  ErrorCode code;
  std::string_view text;
};

constexpr std::array all_words{
    Words{ErrorCode::legacy, "{0}"},
    // text
    // io
    // input
    // input/csv
    // input/json
    // keys
    Words{ErrorCode::equal_times,
          "time {0} repeats the time {1} in line {2}; expected times that increase; take one of them out, or give "
          "--duplicates first, last or break"},
    Words{ErrorCode::equal_times_in_list,
          "{3}: time {0} repeats the time {1} of {2}; expected times that increase; take one of them out, or give "
          "--duplicates first, last or break"},
    Words{ErrorCode::decreasing_times,
          "time {0} is less than the time {1} in line {2}; expected times that increase; sort the rows by time, or "
          "give --sort"},
    Words{ErrorCode::decreasing_times_in_list,
          "{3}: time {0} is less than the time {1} of {2}; expected times that increase; sort the rows by time, or "
          "give --sort"},
    Words{ErrorCode::sort_without_times,
          "--sort orders rows by time, and there is no time column; take it out, or name the column with --columns "
          "time=NAME"},
    Words{ErrorCode::duplicates_without_times,
          "--duplicates is about equal times, and there is no time column; take it out, or name the column with "
          "--columns time=NAME"},
    Words{ErrorCode::no_keys, "only 0 keys; a curve needs two at least; add keys"},
    Words{ErrorCode::single_key, "only 1 key; a curve needs two at least; add keys"},
    Words{ErrorCode::ease_out_of_range, "{0} is {1}; expected 0 to 1; correct it, or give --no-ease"},
    Words{ErrorCode::position_repeats,
          "the position repeats that in line {0}; times are made from distances, and here the distance is 0; take one "
          "of the rows out, or give --parameter uniform"},
    Words{ErrorCode::parameter_step_lost,
          "the distance makes a step of {0}, which is lost when it is added to the time {1}; expected times that "
          "doubles distinguish; give --parameter a smaller exponent"},
    // sampling
    // curve
    // exact
    // output
    // app
    // compare
    // cli
};

struct AppendValue {
  fmt::dynamic_format_arg_store<fmt::format_context>& to;
  void operator()(const std::vector<std::string>& list) const {
    to.push_back(fmt::format("{}", fmt::join(list, ", ")));
  }
  void operator()(const auto& value) const { to.push_back(value); }
};

std::string line_of(const Error& error) {
  const TextPosition& position = error.position();
  if (position.file.empty()) return in_one_line("tcbsample: error: " + error_message(error));
  std::string where = position.file;
  if (position.line != 0) where += fmt::format(":{}", position.line);
  if (position.line != 0 && position.column != 0) where += fmt::format(":{}", position.column);
  return in_one_line(where + ": error: " + error_message(error));
}

}  // namespace

std::string_view option_name(Option) { return ""; }

std::string error_message(const Error& error) {
  const auto words = std::ranges::find(all_words, error.code(), &Words::code);
  fmt::dynamic_format_arg_store<fmt::format_context> values;
  for (const ErrorValue& value : error.values()) std::visit(AppendValue{values}, value);
  const std::string subject = error.member().empty() ? std::string(option_name(error.option())) : error.member();
  values.push_back(fmt::arg("subject", subject));
  return fmt::vformat(words->text, values);
}

std::string error_text(const Error& error) {
  std::string text = line_of(error);
  for (const Error& other : error.others()) text += "\n" + error_text(other);
  return text;
}

}  // namespace tcb
