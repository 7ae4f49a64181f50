// Reading of options: from the words of a command line to typed options. CLI11 divides the words.

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <iterator>

#include "cli/options.hpp"
#include "cli/values.hpp"
#include "io/system.hpp"
#include "text/removed.hpp"
#include "text/suggest.hpp"
#include "text/utf8.hpp"

namespace tcb {

const TypedOptions::Given* TypedOptions::find(std::string_view option) const {
  const auto found = std::ranges::find(given_, option, &Given::option);
  return found == given_.end() ? nullptr : &*found;
}

std::string TypedOptions::value(std::string_view option) const {
  const Given* const given = find(option);
  return given == nullptr ? "" : given->value;
}

void TypedOptions::give(std::string_view option, std::string value) {
  const auto found = std::ranges::find(given_, option, &Given::option);
  if (found == given_.end()) {
    given_.push_back({option, std::move(value)});
  } else {
    found->value = std::move(value);
  }
}

namespace {

Error value_empty() {
  return usage_error("the value is empty; expected one as in --help; add it, or remove the option");
}

Error unknown_option(std::string_view name, std::string_view suggestion) {
  if (const auto gone = removed(suggestion, "")) return usage_error("unknown option {}; {}", name, gone->message());
  const std::string meant = suggestion.empty() ? "" : fmt::format("; did you mean {}?", suggestion);
  return usage_error("unknown option {}{} (--help lists all options)", name, meant);
}

/// Flags, and the lists that several options may give, as in --abs 1e-9 --abs x=1e-6.
bool may_repeat(const OptionRow& row) {
  return row.kind == ValueKind::flag || row.name == "--abs" || row.name == "--rel" || row.name == "--ulp" ||
         row.name == "--rotation" || row.name == "--angle";
}

/// Checks and stores the value of an option; if a text is to be printed, only stores its text.
void store(const OptionRow& row, TypedOptions& typed, const std::vector<std::string>& values, ColorWhen* color) {
  const std::string value = row.kind == ValueKind::flag ? "" : fmt::format("{}", fmt::join(values, ","));
  typed.give(row.name, value);
  if (typed.wants_text()) return;
  try {
    if (values.size() > 1 && !may_repeat(row))
      throw usage_error("the option is repeated; expected it once; remove all but one");
    row.store(typed, value);
    if (color != nullptr) *color = typed.color;
  } catch (const Error& error) {
    throw removed(row.name, value).value_or(error.about(row.name));
  }
}

/// Whether a word of the command line may name the option: it begins with a long name, or is a group of letters.
bool may_name(const std::string& word, const OptionRow& row) {
  const auto is_name = [&word](std::string_view name) {
    if (name.starts_with("--")) return word.starts_with(name);
    return !name.empty() && !word.starts_with("--") && word.find(name[1]) != std::string::npos;
  };
  return word.starts_with('-') && (is_name(row.name) || is_name(row.other_name));
}

/// Those about the program come first, so that an option for a text, such as --help, is stored before all others, and
/// then those of the input, whose units others need. CLI11 compares each new option with all others, so only those that
/// the words may name are declared.
void declare(CLI::App& app, TypedOptions& typed, const std::vector<std::string>& words, ColorWhen* color) {
  app.set_help_flag();
  app.add_option("FILE", typed.files.files);
  std::vector<const OptionRow*> rows;
  for (const OptionRow& row : option_table()) {
    if (std::ranges::none_of(words, [&row](const std::string& word) { return may_name(word, row); })) continue;
    rows.insert(row.group == about_group ? rows.begin() : rows.end(), &row);
  }
  for (const OptionRow* const row : rows) {
    const std::string names = fmt::format("{}", fmt::join(row->all_names(), ","));
    CLI::Option* const option = app.add_option(names, [row, &typed, color](const CLI::results_t& values) {
      store(*row, typed, values, color);
      return true;
    });
    option->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    if (row->kind == ValueKind::flag) option->expected(0)->disable_flag_override();  // --hex=false is no option
  }
}

/// A name as it is compared: in lower case, without the dashes of an option.
std::string compared(std::string_view name) {
  name.remove_prefix(std::min(name.find_first_not_of('-'), name.size()));
  return in_lower_case(name);
}

/// The last option that has this name among its values, with it, as in "--extrapolate hold"; or "".
std::string option_with_value(std::string_view name) {
  std::string found;
  for (const OptionRow& row : option_table()) {
    if (std::ranges::count(row.known_names(), name) > 0) found = fmt::format("{} {}", row.name, name);
  }
  return found;
}

/// A name that people guess, without dashes, and the options that do what they want.
struct GuessedOption {
  std::string_view name, meant;
};

constexpr GuessedOption guessed_options[] = {
    {"tension", "--tcb"},
    {"continuity", "--tcb"},
    {"bias", "--tcb"},
    {"format", "-f for the output, or -i for the input"},
    {"json", "-f json or -i json"},
    {"out", "--output"},
    {"samples", "--count"},
    {"frames", "--count or --fps"},
    {"interval", "--step"},
    {"dt", "--step"},
    {"arclength", "--arc-step"},
    {"unit", "--time-unit"},
    {"linear", "--tangents linear"},
    {"loop", "--closed or --extrapolate repeat"},
    {"speed", "--fields speed or --limits=speed=..."},
    {"precision", "--digits or --fixed"},
    {"round", "--digits or --fixed"},
};

/// The option that an unknown one probably means, or "": one with a value of this name, or one with a similar name,
/// which may be gone.
std::string meant_option(const std::string& unknown) {
  const std::string wanted = compared(unknown);
  const auto* const guessed = std::ranges::find(guessed_options, wanted, &GuessedOption::name);
  if (unknown.starts_with("--") && guessed != std::end(guessed_options)) return std::string(guessed->meant);
  std::vector<std::string_view> names;
  for (const OptionRow& row : option_table()) {
    for (const std::string_view name : row.all_names()) names.push_back(name);
  }
  for (const RemovedName& row : removed_names()) {
    if (row.value.empty()) names.push_back(row.option);
  }
  std::vector<std::string> all;
  std::ranges::transform(names, std::back_inserter(all), compared);
  const std::string_view likely = likely_name(wanted, std::vector<std::string_view>(all.begin(), all.end()));
  const std::string_view option =
      likely.empty() ? "" : names[static_cast<std::size_t>(std::ranges::find(all, likely) - all.begin())];
  if (unknown.starts_with("--") && !removed(option, "")) {
    if (std::string value = option_with_value(wanted); !value.empty()) return value;
  }
  return std::string(option);
}

/// CLI11's error as one of ours. It finds unknown options, and flags with a value.
[[noreturn]] void refuse(const CLI::ParseError& error, const CLI::App& app, const std::vector<std::string>& words) {
  const auto name_of = [](const std::string& word) { return word.substr(0, word.find('=')); };
  if (const auto unknown = app.remaining(); dynamic_cast<const CLI::ExtrasError*>(&error) && !unknown.empty()) {
    const std::string name = name_of(unknown[0]);
    throw unknown_option(name, meant_option(name));
  }
  for (const std::string& word : words) {
    const std::string name = name_of(word);
    const auto is_it = [&name](const OptionRow& row) {
      return row.kind == ValueKind::flag && (row.name == name || row.other_name == name);
    };
    if (name.size() < word.size() && std::ranges::any_of(option_table(), is_it))
      throw usage_error("{} takes no value; remove the value", name);
  }
  throw usage_error("{}; see --help", error.what());
}

/// Throws: Error (usage) for a long name after a single dash, as in -fps, which would be a short option with a value.
void require_two_dashes(const std::vector<std::string>& words) {
  for (const std::string& word : words) {
    if (word == "--") return;
    if (word.size() < 3 || !word.starts_with('-') || word.starts_with("--")) continue;
    const std::string name = word.substr(0, word.find('=')), meant = "-" + name;
    const auto is_meant = [&meant](const OptionRow& row) { return row.name == meant || row.other_name == meant; };
    if (std::ranges::any_of(option_table(), is_meant)) throw unknown_option(name, meant);
  }
}

/// Throws: Error (usage) for an option that is gone, also after a single dash.
void require_not_removed(const std::vector<std::string>& words) {
  for (auto word = words.begin(); word != words.end() && *word != "--"; ++word) {
    const std::size_t end = std::min(word->find('='), word->size());
    const std::string name = (word->starts_with("--") ? "" : "-") + word->substr(0, end);
    const std::string next = word + 1 == words.end() ? "" : word[1];
    if (const auto gone = removed(name, end == word->size() ? next : word->substr(end + 1))) throw *gone;
  }
}

/// The option that a word names, with the characters until the end of its name: --step=1, or the last of -qn3.
struct NamedOption {
  const OptionRow* row = nullptr;  ///< nothing: the word is no option, or an unknown one
  std::size_t end = 0;
};

NamedOption option_in(const std::string& word) {
  const auto row_with = [](const std::string& name) {
    const auto has_name = [&name](const OptionRow& row) { return row.name == name || row.other_name == name; };
    const auto found = std::ranges::find_if(option_table(), has_name);
    return found == option_table().end() ? nullptr : &*found;
  };
  if (word.starts_with("--")) {
    const std::size_t end = std::min(word.find('='), word.size());
    return {row_with(word.substr(0, end)), end};
  }
  NamedOption last;
  for (std::size_t i = 1; i < word.size() && word[0] == '-'; ++i) {
    last = {row_with({'-', word[i]}), i + 1};
    if (last.row == nullptr || last.row->kind != ValueKind::flag) break;
  }
  return last;
}

/// Whether a word after an option cannot be its value: another option, as scripts leave values out, for example in
/// --output $NAME --step 1. CLI11 takes any word.
bool is_option(const std::string& word) {
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  return word.size() > 1 && word[0] == '-' && (word[1] == '-' || is_letter(word[1]));
}

/// Throws: Error (usage) for a word after an option whose value follows =, if it is neither a file nor an option.
void require_file(std::string_view option, const std::string& word) {
  if (word.starts_with('-') || system::status_of(word)) return;
  throw usage_error(
      "{} takes its value after =, and there is no file {}; expected {}; write it so, or correct the name of the file",
      option, in_quotes(word), in_shell(fmt::format("{}={}", option, word)));
}

/// The words, with the value in the word of each option that may do without one, so that it does not take the name of a
/// file, and without the = in -n=3. Throws: Error (usage) for an option without value, and for an empty one.
std::vector<std::string> with_values(std::vector<std::string> words) {
  for (auto word = words.begin(); word != words.end() && *word != "--"; ++word) {
    const auto [row, end] = option_in(*word);
    if (row == nullptr || row->kind == ValueKind::flag) continue;
    const auto next = word + 1;
    if (end < word->size()) {
      const bool has_equals = (*word)[end] == '=';
      if (has_equals && end + 1 == word->size()) throw value_empty().about(row->name);
      if (has_equals && !word->starts_with("--")) word->erase(end, 1);
    } else if (next != words.end() && next->empty()) {
      throw value_empty().about(row->name);
    } else if (row->kind == ValueKind::attached) {
      if (next != words.end()) require_file(row->name, *next);
      *word += fmt::format("={}", row->default_value);
    } else {
      if (next == words.end())
        throw usage_error("{}: the value is missing; expected one after the option; see --help", row->name);
      if (is_option(*next)) {
        throw usage_error(
            "{0}: the value is missing before {1}; expected one after the option; add it, or write {0}={1}", row->name,
            *next);
      }
      word = next;
    }
  }
  return words;
}

}  // namespace

TypedOptions read_options(const std::vector<std::string>& given, ColorWhen* color) {
  const std::vector<std::string> words = with_values(given);
  TypedOptions typed;
  CLI::App app;
  require_not_removed(words);
  require_two_dashes(words);
  declare(app, typed, words, color);
  try {
    app.parse(std::vector(words.rbegin(), words.rend()));  // CLI11 takes them from the back
  } catch (const CLI::ParseError& error) {
    refuse(error, app, words);
  }
  if (std::ranges::count(typed.files.files, "") > 0)
    throw usage_error("the name of a file is empty; expected a file, or - for standard input; remove it");
  return typed;
}

}  // namespace tcb
