// Open questions: the options in a remedy, and the next error with them.
#include "cli/open_questions.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <optional>
#include <string_view>
#include <system_error>
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
  const std::size_t remedy = message.rfind("give --");
  if (remedy == std::string_view::npos) return {};
  std::string_view rest = message.substr(remedy + give.size());
  while (rest.starts_with("--")) {
    const std::string_view name = rest.substr(0, rest.find_first_of(" ,;="));
    const auto row = std::ranges::find(option_table(), name, &OptionRow::name);
    if (row == option_table().end()) return words;
    if (name == "--max-memory") return {};  // more than a person allowed
    words.emplace_back(name);
    if (row->kind == ValueKind::flag) return words;
    if (rest.size() == name.size()) return {};
    const std::string_view value = value_in(rest.substr(name.size() + 1));
    if (value.empty()) return {};
    words.emplace_back(value);
    const std::size_t next = rest.find(' ', name.size() + 1 + value.size());
    if (next == std::string_view::npos) return words;
    rest.remove_prefix(next + 1);
  }
  return words;
}

/// Whether reading the inputs of a command again gives the same, soon: no pipe, whose bytes are gone, and no large
/// file.
bool can_be_read_again(const std::vector<std::string>& words, const ExplainJob& job) {
  constexpr std::uintmax_t most = 1UL << 26;
  const auto may_read_other = [](const std::string& word) { return word == "-" || word.find('@') != word.npos; };
  const auto is_small = [](const std::string& path) {
    std::error_code none;
    return std::filesystem::is_regular_file(path, none) && std::filesystem::file_size(path, none) <= most;
  };
  return std::ranges::none_of(words, may_read_other) && !job.files.files.empty() &&
         std::ranges::all_of(job.files.files, is_small);
}

/// The error of a command that is explained; nothing if there is none. Throws: Error (usage) where it is not explained.
std::optional<Error> error_with(std::vector<std::string> words) {
  words.emplace_back("--explain");
  const Job job = parse(words);
  const auto* const explained = std::get_if<ExplainJob>(&job);
  if (explained == nullptr || !can_be_read_again(words, *explained)) throw usage_error("not explained");
  try {
    require_explained(*explained);
  } catch (const Error& error) {
    if (error.exit() != Exit::data) throw;
    return error;
  }
  return std::nullopt;
}

/// Nothing unless several errors follow each other, and options settle all of them.
std::optional<OpenQuestions> several_questions(std::vector<std::string> words, const Error& first) {
  constexpr std::size_t most = 4;
  OpenQuestions open{first, ""};
  for (std::optional<Error> next = first; next;) {
    const std::vector<std::string> options = options_in(next->message());
    if (options.empty() || std::ranges::count(words, options[0]) > 0) return std::nullopt;
    for (const std::string& option : options) {
      open.settled_by += (open.settled_by.empty() ? "" : " ") + in_shell(option);
      words.push_back(option);
    }
    next = error_with(words);
    if (next) open.error.add(*next);
    if (open.error.others().size() > first.others().size() + most) return std::nullopt;
  }
  const bool is_alone = open.error.others().size() == first.others().size();
  return is_alone ? std::nullopt : std::optional(std::move(open));
}

}  // namespace

OpenQuestions open_questions(const std::vector<std::string>& words, const Error& error) {
  if (error.exit() != Exit::data) return {error, ""};
  try {
    if (auto open = several_questions(words, error)) return *std::move(open);
  } catch (const std::exception&) {  // what only a further attempt meets, such as too little memory
  }
  return {error, ""};
}

}  // namespace tcb
