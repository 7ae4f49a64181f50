// Command line: from the words to the texts and values of the options, and on to a job or a text to print.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "cli/help.hpp"
#include "cli/options.hpp"
#include "cli/plan.hpp"
#include "text/suggest.hpp"

namespace tcb {
namespace {

/// Flags, and the lists that several options may give, as in --abs 1e-9 --abs x=1e-6.
bool may_repeat(const OptionRow& row) {
  return row.kind == ValueKind::flag || row.id == Option::abs || row.id == Option::rel || row.id == Option::ulp;
}

/// Checks and stores the value of an option, of which only the text is needed where a text is to be printed.
void store(const OptionRow& row, TypedOptions& typed, const std::vector<std::string>& values) {
  const bool wants_text = typed.wants_text();
  std::string& text = typed.texts[index_of(row.id)];
  text = row.kind == ValueKind::flag ? "true" : fmt::format("{}", fmt::join(values, ","));
  if (wants_text) return;
  try {
    if (values.size() > 1 && !may_repeat(row)) throw Error(Exit::usage, ErrorCode::option_repeated);
    if (std::ranges::count(values, "") > 0) throw Error(Exit::usage, ErrorCode::empty_value);
    row.store(typed, text);
  } catch (const Error& error) {
    throw error.about(row.id);
  }
}

/// From the last to the first, so that an option for a text, such as --help, is stored before all others.
void declare(CLI::App& app, TypedOptions& typed) {
  app.set_help_flag();
  app.add_option("FILE", typed.job.files);
  for (std::size_t i = option_count; i-- > 0;) {
    const OptionRow& row = option_table()[i];
    CLI::Option* const option = app.add_option(std::string(row.names), [&row, &typed](const CLI::results_t& values) {
      store(row, typed, values);
      return true;
    });
    option->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    if (row.kind == ValueKind::flag) option->expected(0)->disable_flag_override();  // --hex=false is no option
  }
}

/// CLI11's error as one of ours. It finds unknown options, flags with a value, and values that are missing at the end.
[[noreturn]] void refuse(const CLI::ParseError& error, const CLI::App& app, const std::vector<std::string>& words) {
  const auto name_of = [](const std::string& word) { return word.substr(0, word.find('=')); };
  std::vector<std::string> known, flags;
  for (const OptionRow& row : option_table()) {
    for (const std::string_view name : row.all_names()) {
      known.emplace_back(name);
      if (row.kind == ValueKind::flag) flags.emplace_back(name);
    }
  }
  if (const auto unknown = app.remaining(); dynamic_cast<const CLI::ExtrasError*>(&error) && !unknown.empty()) {
    throw Error(Exit::usage, ErrorCode::unknown_option, {name_of(unknown[0]), known});
  }
  for (const std::string& word : words) {
    const std::string name = name_of(word);
    if (name.size() < word.size() && std::ranges::count(flags, name) > 0) {
      throw Error(Exit::usage, ErrorCode::flag_with_value, {name});
    }
  }
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) && !words.empty()) {
    throw Error(Exit::usage, ErrorCode::value_missing, {name_of(words.back())});
  }
  throw Error(Exit::usage, ErrorCode::wrong_command_line, {std::string(error.what())});
}

std::string asked_text(const TypedOptions& typed) {
  if (typed.has(Option::help)) return help_text();
  if (typed.has(Option::list_presets)) return presets_text();
  if (typed.has(Option::version)) return version_text();
  return generated_text(*typed.generated);
}

}  // namespace

TypedOptions read_options(const std::vector<std::string>& words) {
  TypedOptions typed;
  CLI::App app;
  declare(app, typed);
  try {
    app.parse(std::vector(words.rbegin(), words.rend()));  // CLI11 takes them from the back
  } catch (const CLI::ParseError& error) {
    refuse(error, app, words);
  }
  if (std::ranges::count(typed.job.files, "") > 0) throw Error(Exit::usage, ErrorCode::empty_file_name);
  return typed;
}

Invocation parse(int argc, const char* const* argv) {
  std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
  TypedOptions typed = read_options(words);
  if (typed.wants_text()) return {asked_text(typed), {}};
  std::optional<ProvenanceRequest> provenance;
  if (typed.has(Option::from_meta)) {
    provenance = earlier_provenance(typed);
    words.insert(words.begin(), provenance->earlier.options.begin(), provenance->earlier.options.end());
    typed = read_options(words);
  }
  require_no_conflict(typed);
  if (typed.has(Option::meta)) {
    if (!provenance) provenance.emplace();
    provenance->meta = new_provenance(typed);
  }
  Job job = make_job(typed);
  job.meta = std::move(provenance);
  return {std::nullopt, std::move(job)};
}

}  // namespace tcb
