// Provenance on the command line: which options an output says it was made with, and the way back.
#include "cli/meta.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <string_view>

#include "cli/input.hpp"
#include "cli/reference.hpp"
#include "cli/sampling.hpp"
#include "error.hpp"
#include "io/file.hpp"
#include "io/formats.hpp"

namespace tcb {
namespace {

std::string name_of(const CLI::Option& option) {
  return option.get_lnames().empty() ? "-" + option.get_snames()[0] : "--" + option.get_lnames()[0];
}

/// The typed options that say which bytes are made; the others say where they go, and how fast.
std::vector<const CLI::Option*> telling(const CLI::App& app) {
  constexpr std::array<std::string_view, 6> others{"--output", "--jobs",     "--from-meta",
                                                   "--quiet",  "--progress", "--no-progress"};
  std::vector<const CLI::Option*> options;
  for (const CLI::Option* option : app.get_options()) {
    if (option->count() == 0 || option->get_positional() || option->get_group() == "Many files") continue;
    if (std::ranges::count(others, name_of(*option)) == 0) options.push_back(option);
  }
  return options;
}

/// An option as one word; places are listed in it, wherever they came from.
std::string word(const CLI::Option& option, const TypedOptions& typed) {
  std::string name = name_of(option);
  if (option.get_items_expected_max() == 0) return name;
  std::string value = fmt::format("{}", fmt::join(option.results(), ","));
  if (name == "--at") value = typed.at;
  if (name == "--arc-at") value = typed.arc_at;
  if (value.find_first_of("\r\n") != std::string::npos) {
    throw Error(Exit::usage, fmt::format("{}: a value with a line end cannot be said by --meta; expected one without; "
                                         "take --meta out, or rename columns",
                                         name));
  }
  return name + "=" + value;
}

/// Throws: Error unless all options of an earlier output are known, and make bytes with provenance.
void require_telling(const std::vector<std::string>& words) {
  TypedOptions typed;
  const auto app = declare(typed);
  read_words(*app, words);
  const auto is_used = [](const CLI::Option* option) { return option->count() > 0; };
  if (static_cast<std::size_t>(std::ranges::count_if(app->get_options(), is_used)) != telling(*app).size()) {
    throw Error(Exit::data,
                "its provenance has an option that does not say what the rows are; expected none; correct it");
  }
  if (!typed.meta) throw Error(Exit::data, "its provenance lacks the option --meta; expected all options; add it");
}

/// Throws: Error (usage) where there is no place for provenance.
void require_place(const TypedOptions& typed) {
  if (!typed.check.empty() || !typed.identify.empty() || typed.explain) {
    throw Error(Exit::usage, "--meta has no effect where a report is printed and no rows; take it out");
  }
  const std::string name = typed.output_format.empty() ? "csv" : typed.output_format;
  if (!format_of(named_format("--output-format", name, &Format::can_write)).has_provenance) {
    throw Error(Exit::usage, fmt::format("--meta has no place in {}; expected a format of text; take it out", name));
  }
}

}  // namespace

Provenance new_meta(const CLI::App& app, const TypedOptions& typed) {
  require_place(typed);
  Provenance meta;
  meta.program = version_text();
  for (const CLI::Option* option : telling(app)) meta.options.push_back(word(*option, typed));
  return meta;
}

ProvenanceRequest earlier_meta(const CLI::App& app, const TypedOptions& typed) {
  const auto typed_too = telling(app);
  if (!typed_too.empty()) {
    throw Error(Exit::usage,
                fmt::format("{} has no place beside --from-meta, which takes every option from {}; take it "
                            "out",
                            name_of(*typed_too[0]), typed.from_meta));
  }
  ProvenanceRequest request;
  request.from = typed.from_meta;
  try {
    request.earlier = read_meta(read_file(typed.from_meta));
    require_telling(request.earlier.options);
  } catch (const Error& error) {
    throw error.in(shown_name(typed.from_meta));
  }
  const std::size_t files = std::max<std::size_t>(typed.files.size(), 1);
  const bool counted = typed.list.empty() && !typed.recursive;
  if (counted && files != request.earlier.inputs.size()) {
    throw Error(Exit::usage, fmt::format("{} was made from another number of files of keys, {}; {} given; give as many",
                                         typed.from_meta, request.earlier.inputs.size(), files));
  }
  return request;
}

}  // namespace tcb
