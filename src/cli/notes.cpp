// Words for notes: from codes and values to sentences, with the options that are the remedy.
#include <fmt/args.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "cli/remedies.hpp"

namespace tcb {
namespace {

/// {0}, {1}, … are the values of the note, lists joined by ", ".
struct NoteWords {
  NoteCode code;
  std::string_view text;
};

constexpr std::array note_words{
    NoteWords{NoteCode::no_time_column, "no time column; the times of the keys are 0, 1, 2, ..."},
    NoteWords{NoteCode::ignored_columns, "columns of text are left out: {0}"},
    NoteWords{NoteCode::remainder,
              "the end lies {0} behind the last row and is left out; --end keep or --end fit includes it"},
    NoteWords{NoteCode::step, "the step is {0}"},
    NoteWords{NoteCode::skipped_rows, "rows left out for missing numbers: {0}"},
    NoteWords{NoteCode::made_times, "none; made with --parameter {0}"},
    NoteWords{NoteCode::other_program, "made by {0}; this is {1}, whose digits may differ"},
};

}  // namespace

std::string note_text(const Note& note) {
  const auto words = std::ranges::find(note_words, note.code, &NoteWords::code);
  fmt::dynamic_format_arg_store<fmt::format_context> values;
  for (const ErrorValue& value : note.values) {
    if (const auto* list = std::get_if<std::vector<std::string>>(&value)) {
      values.push_back(fmt::format("{}", fmt::join(*list, ", ")));
    } else if (const auto* text = std::get_if<std::string>(&value)) {
      values.push_back(*text);
    } else if (const auto* number = std::get_if<double>(&value)) {
      values.push_back(*number);
    } else {
      values.push_back(std::get<std::uint64_t>(value));
    }
  }
  return fmt::vformat(words->text, values);
}

}  // namespace tcb
