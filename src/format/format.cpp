// The one table of formats: their names, their file endings, how they are read and written.
#include "format/format.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "error.hpp"
#include "format/csv.hpp"
#include "format/json.hpp"

namespace tcb::format {
namespace {

Input open_with(char delimiter, Source<std::string> bytes, InputOptions options) {
  if (!options.delimiter) options.delimiter = delimiter;
  return open_delimited(std::move(bytes), options);
}

Input open_tsv(Source<std::string> bytes, const InputOptions& options) {
  return open_with('\t', std::move(bytes), options);
}
Input open_ssv(Source<std::string> bytes, const InputOptions& options) {
  return open_with(' ', std::move(bytes), options);
}

Layout csv_rows(const std::vector<OutputColumn>& columns, bool header) {
  return delimited_layout(columns, ',', header);
}
Layout tsv_rows(const std::vector<OutputColumn>& columns, bool header) {
  return delimited_layout(columns, '\t', header);
}
Layout ssv_rows(const std::vector<OutputColumn>& columns, bool header) {
  return delimited_layout(columns, ' ', header);
}
Layout json_rows(const std::vector<OutputColumn>& columns, bool) { return json_layout(columns); }
Layout jsonl_rows(const std::vector<OutputColumn>& columns, bool) { return jsonl_layout(columns); }

/// Drops a UTF-8 byte order mark.
Source<std::string> without_mark(Source<std::string> bytes) {
  constexpr std::string_view mark = "\xEF\xBB\xBF";
  std::string beginning;
  while (beginning.size() < mark.size()) {
    auto more = bytes();
    if (!more) break;
    beginning += *more;
  }
  if (beginning.starts_with(mark)) beginning.erase(0, mark.size());
  return preceded_by(std::move(beginning), std::move(bytes));
}

/// The format that a file's ending or its first byte that is not blank tells.
std::size_t detect(const std::string& path, const std::string& beginning) {
  for (std::size_t i = 0; i < formats().size(); ++i) {
    if (path.ends_with(formats()[i].ending) && formats()[i].open != nullptr) return i;
  }
  const std::size_t at = beginning.find_first_not_of(" \t\r\n");
  const bool json = at != std::string::npos && (beginning[at] == '[' || beginning[at] == '{');
  return find_format("", json ? "json" : "csv");
}

}  // namespace

const std::vector<Format>& formats() {
  static const std::vector<Format> table{
      {"csv", ".csv", open_delimited, csv_rows, true},   {"tsv", ".tsv", open_tsv, tsv_rows, true},
      {"ssv", ".ssv", open_ssv, ssv_rows, true},         {"json", ".json", open_json, json_rows, false},
      {"jsonl", ".jsonl", open_json, jsonl_rows, false},
  };
  return table;
}

std::size_t find_format(std::string_view option, std::string_view name) {
  const auto row = std::ranges::find(formats(), name, &Format::name);
  if (row != formats().end()) return static_cast<std::size_t>(row - formats().begin());
  std::vector<std::string_view> names;
  std::ranges::transform(formats(), std::back_inserter(names), &Format::name);
  throw Error(Exit::usage,
              fmt::format("{}: unknown format \"{}\"; expected one of {}", option, name, fmt::join(names, ", ")));
}

Input open_input(const std::string& path, Source<std::string> bytes, const InputOptions& options) {
  bytes = without_mark(std::move(bytes));
  std::string beginning;
  while (beginning.find_first_not_of(" \t\r\n") == std::string::npos) {
    auto more = bytes();
    if (!more) break;
    beginning += *more;
  }
  const std::size_t format = options.format ? *options.format : detect(path, beginning);
  Input input = formats()[format].open(preceded_by(std::move(beginning), std::move(bytes)), options);
  input.threads = options.threads;
  input.facts.emplace(input.facts.begin(), "format", formats()[format].name);
  return input;
}

}  // namespace tcb::format
