// Open questions: the options in a remedy, and the next error with them.
#include "cli/open_questions.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <exception>
#include <optional>
#include <string_view>
#include <utility>
#include <variant>

#include "cli/options.hpp"
#include "cli/plan.hpp"
#include "run/pipeline.hpp"
#include "text/suggest.hpp"

namespace tcb {
namespace {

/// The value at the beginning of a text, a word as in_shell() writes it. Empty: there is none, or it stands for one, as
/// NAME does.
std::string_view value_in(std::string_view text) {
  const bool is_quoted = text.starts_with('\'');
  const std::size_t end = is_quoted ? text.find('\'', 1) : std::min(text.find_first_of(" ;"), text.size());
  if (end == std::string_view::npos) return {};
  std::string_view value = text.substr(is_quoted ? 1 : 0, is_quoted ? end - 1 : end);
  if (!is_quoted && value.size() > 1 && value.ends_with(',')) value.remove_suffix(1);
  const bool has_placeholder = std::ranges::any_of(split(value, '='), [](std::string_view part) {
    return part.starts_with("NAME") || part == "HZ" || part == "T,C,B";
  });
  return has_placeholder ? std::string_view() : value;
}

/// The options that a remedy names first, as words of a command; empty if it names none that can be given as it stands.
std::vector<std::string> options_in(std::string_view message) {
  constexpr std::string_view give = "give ";
  std::vector<std::string> words;
  std::size_t at = message.find("give --");
  if (at == std::string_view::npos) return {};
  for (at += give.size(); message.substr(at).starts_with("--");) {
    const std::string_view rest = message.substr(at);
    const std::string_view name = rest.substr(0, std::min(rest.find_first_of(" ,;="), rest.size()));
    const auto row = std::ranges::find(option_table(), name, &OptionRow::name);
    if (row == option_table().end()) return words;
    words.emplace_back(name);
    if (row->kind == ValueKind::flag) return words;
    if (rest.size() == name.size()) return {};
    const std::string_view value = value_in(rest.substr(name.size() + 1));
    if (value.empty()) return {};
    words.emplace_back(value);
    at = std::min(message.find(' ', static_cast<std::size_t>(value.data() - message.data()) + value.size()),
                  message.size() - 1) +
         1;
  }
  return words;
}

/// The error of a command that is explained; nothing if there is none. A command that cannot be explained is an error.
std::optional<Error> error_with(std::vector<std::string> words) {
  words.emplace_back("--explain");
  try {
    const Job job = parse(words);
    const auto* const explained = std::get_if<ExplainJob>(&job);
    const bool has_files = explained != nullptr && !explained->files.files.empty();
    if (!has_files || std::ranges::count(explained->files.files, "-") > 0) return usage_error("there is no file");
    require_explained(*explained);
  } catch (const Error& error) {
    return error;
  }
  return std::nullopt;
}

}  // namespace

OpenQuestions open_questions(const std::vector<std::string>& words, Error error) {
  constexpr int most = 4;
  std::vector<std::string> settled, all = words;
  std::vector<Error> others;
  std::optional<Error> next = error;
  while (next) {
    if (next->exit() != Exit::data || others.size() == most) return {std::move(error), ""};
    std::vector<std::string> options = options_in(next->message());
    if (options.empty() || std::ranges::count(all, options[0]) > 0) return {std::move(error), ""};
    for (std::string& option : options) {
      settled.push_back(in_shell(option));
      all.push_back(std::move(option));
    }
    next = error_with(all);
    if (next) others.push_back(*next);
  }
  if (others.empty()) return {std::move(error), ""};
  for (Error& other : others) error.add(std::move(other));
  return {std::move(error), fmt::format("{}", fmt::join(settled, " "))};
}

}  // namespace tcb
