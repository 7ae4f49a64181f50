// Options: the one table of the command line's options, and their typed values.
#pragma once

#include <array>
#include <bitset>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/job.hpp"
#include "error.hpp"

namespace tcb {

inline constexpr std::size_t option_count = static_cast<std::size_t>(Option::help);

constexpr std::size_t index_of(Option option) { return static_cast<std::size_t>(option) - 1; }

/// Texts that are printed instead of rows, by name.
enum class Generated { manual, bash, zsh, fish };
struct GeneratedName {
  std::string_view name;
  Generated kind;
};
inline constexpr std::array generated_names{
    GeneratedName{"man", Generated::manual}, GeneratedName{"bash", Generated::bash},
    GeneratedName{"zsh", Generated::zsh}, GeneratedName{"fish", Generated::fish}};

/// The values of the options, each by itself; what they mean together is decided by make_job.
struct TypedOptions {
  /// The value of each option as typed, "" where it is not given; of a list in a file, its numbers.
  std::array<std::string, option_count> texts;
  Job job;
  Comparison comparison;
  Notation notation;
  std::optional<Generated> generated;

  const std::string& text(Option option) const { return texts[index_of(option)]; }
  bool has(Option option) const { return !text(option).empty(); }
  /// A text is to be printed, and no other value is read.
  bool wants_text() const;
};

/// What the value of an option is, for completions.
enum class ValueKind { flag, name, file, folder, other };

/// An option. To add one: its name in enum class Option, and its row at the same place of the table.
struct OptionRow {
  Option id;
  std::string_view names;  ///< short and long, with their dashes, separated by commas
  std::string_view value;  ///< what the help calls its value; empty for a flag
  std::string_view group;
  std::string_view text;           ///< what it does, without a point at the end
  std::string_view default_value;  ///< as it would be typed; empty: none, or described in the text
  ValueKind kind;
  bool changes_rows;  ///< it is part of the provenance of the output
  /// Reads the value. Throws: Error (usage), which the caller makes an error about this option.
  void (*store)(TypedOptions& typed, const std::string& value);
  std::vector<std::string_view> (*known)() = nullptr;  ///< the names that the value is one of, for ValueKind::name

  /// With its dashes.
  std::string_view long_name() const;
  std::vector<std::string_view> all_names() const;
};

/// All options in the order of the help, which is that of enum class Option.
std::span<const OptionRow> option_table();

inline const OptionRow& row_of(Option option) { return option_table()[index_of(option)]; }

/// Reads the words of a command line. Throws: Error (usage) for unknown options, and for values that are wrong in
/// themselves.
TypedOptions read_options(const std::vector<std::string>& words);

/// What the program is asked for: a text to print, or else a job.
struct Invocation {
  std::optional<std::string> text;
  Job job;
};

/// Throws: Error (usage) that names the option, what was expected, and the remedy.
Invocation parse(int argc, const char* const* argv);

}  // namespace tcb
