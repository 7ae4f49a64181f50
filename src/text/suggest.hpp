// Names: those of values; the known one nearest to one that is misspelt; comparison in any case, and with patterns;
// texts split at a separator; endings of names of files.
#pragma once

#include <charconv>
#include <concepts>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace tcb {

/// A name of a value, in a table of those that an option takes.
template <class T>
struct Named {
  std::string_view name;
  T value;
};

/// The known name nearest to `name`, or "" where none is near: within a third of the letters of the longer one changed,
/// dropped or added. Upper and lower case are different letters.
std::string nearest_name(std::string_view name, std::span<const std::string_view> known);

/// The known name that is probably meant, or "": the nearest one; else the only one that has the same letters, begins
/// with `name`, or contains it.
std::string_view likely_name(std::string_view name, std::span<const std::string_view> known);

/// "; did you mean NAME?" with the known name that is probably meant, whatever the case of its letters, or "".
std::string did_you_mean(std::string_view name, std::span<const std::string_view> known);
std::string did_you_mean(std::string_view name, std::span<const std::string> known);

/// Whether two names differ in one letter that is added or, in long names, changed, or in two that are swapped.
bool is_near(std::string_view name, std::string_view known);

/// Whether a list of words between blanks has a word.
bool lists_word(std::string_view words, std::string_view word);

/// The words of a name in lower case, such as "tcb" and "t" of "tcb_t", "tcb.T" and "tcbT": between other characters
/// than letters and digits, and where a capital follows a small letter, or a digit a letter.
std::vector<std::string> words_of(std::string_view name);

/// Names separated by ", ": all of them, or the first 20 and the number of the others.
std::string listed(std::span<const std::string> names);
std::string listed(std::span<const std::string_view> names);

/// A word of a command as a shell takes it: with quotes unless it needs none.
std::string in_shell(std::string_view word);

/// A command of these words as a line of printable characters that every POSIX shell takes. Words with other
/// characters, such as line ends, are made by printf, whose output the shell evaluates.
std::string command_in_shell(std::span<const std::string> words);

/// "1 cell", "2 cells".
std::string how_many(std::size_t count, std::string_view noun);

/// A letter of ASCII in lower case; any other character as it is.
constexpr char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + ('a' - 'A')) : c; }

constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// The whole number that a text of digits alone is; nothing for others.
template <class Int>
std::optional<Int> in_digits(std::string_view text) {
  Int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size() ? std::optional(value) : std::nullopt;
}

/// A text with its letters of ASCII in lower case.
std::string in_lower_case(std::string_view text);

/// Whether two texts are the same, whatever the case of their letters of ASCII.
bool same_in_any_case(std::string_view a, std::string_view b);

/// The parts of a text between separators, one at least.
std::vector<std::string_view> split(std::string_view text, char separator);
/// The parts would outlive a text that is made for the call.
template <std::same_as<std::string> Text>
std::vector<std::string_view> split(Text&& text, char separator) = delete;

/// Whether a name is one of a pattern's, in which * is any text and ? any character.
bool matches(std::string_view name, std::string_view pattern);

/// Whether the last name of a path ends in `ending`, which is in lower case, and is longer than that.
bool has_ending(std::string_view path, std::string_view ending);

/// The ending of compressed files that a path has, .gz or .zst in lower case; empty: it has none.
std::string_view compression_ending(std::string_view path);

/// The path without that ending.
std::string_view without_compression(std::string_view path);

}  // namespace tcb
