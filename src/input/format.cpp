// The one table of formats: their names, their file endings, how they are read and written.
#include "input/format.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "error.hpp"
#include "input/csv/key_parser.hpp"
#include "input/csv/records.hpp"
#include "input/json/shapes.hpp"
#include "input/texts.hpp"
#include "output/npy.hpp"

namespace tcb {
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
Layout npy_rows(const std::vector<OutputColumn>& columns, bool) { return npy_layout(columns); }

std::string csv_text(std::string_view text) { return delimited_text(content(text), ','); }
std::string tsv_text(std::string_view text) { return delimited_text(content(text), '\t'); }
std::string ssv_text(std::string_view text) { return text.empty() ? "NA" : delimited_text(content(text), ' '); }
std::string json_cell(std::string_view text) {
  return text.empty() ? "null" : is_string(text) ? json_text(content(text)) : std::string(text);
}

/// Throws: Error (data) for a text in two or four bytes a character, and for what is no text.
void require_bytes(std::string_view beginning) {
  using namespace std::string_view_literals;
  if (beginning.starts_with("\x93NUMPY")) {
    throw Error(Exit::data, TextPosition{"", 1, 1},
                "the file is one of NumPy's; expected text; convert it, for example with numpy.savetxt");
  }
  const bool four = beginning.starts_with("\xFF\xFE\0\0"sv) || beginning.starts_with("\0\0\xFE\xFF"sv);
  if (!four && !beginning.starts_with("\xFF\xFE") && !beginning.starts_with("\xFE\xFF")) return;
  const char* const name = four ? "UTF-32" : "UTF-16";
  throw Error(
      Exit::data, TextPosition{"", 1, 1},
      fmt::format("the text is {}; expected UTF-8; convert it, for example with iconv -f {} -t UTF-8", name, name));
}

/// Drops a UTF-8 byte order mark. Throws: Error (data) for two.
Source<std::string> without_mark(Source<std::string> bytes) {
  constexpr std::string_view mark = "\xEF\xBB\xBF";
  std::string beginning;
  constexpr std::size_t enough = 6;  // to tell what require_bytes() looks for
  while (beginning.size() < enough) {
    auto more = bytes();
    if (!more) break;
    beginning += *more;
  }
  require_bytes(beginning);
  if (beginning.starts_with(mark)) beginning.erase(0, mark.size());
  if (beginning.starts_with(mark)) {
    throw Error(Exit::data, TextPosition{"", 1, 1}, "a byte order mark twice; expected one at most; take it out");
  }
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
      {"csv", ".csv", open_delimited, csv_rows, true, csv_text, "\n", false},
      {"tsv", ".tsv", open_tsv, tsv_rows, true, tsv_text, "\n", false},
      {"ssv", ".ssv", open_ssv, ssv_rows, true, ssv_text, "\n", false},
      {"json", ".json", open_json, json_rows, false, json_cell, "null", true},
      {"jsonl", ".jsonl", open_json, jsonl_rows, false, json_cell, "null\n", false},
      {"npy", ".npy", nullptr, npy_rows, false, nullptr, "", false, npy_head},
  };
  return table;
}

std::size_t find_format(std::string_view option, std::string_view name, bool read) {
  std::vector<std::string_view> names;
  for (std::size_t i = 0; i < formats().size(); ++i) {
    if (read && formats()[i].open == nullptr) continue;
    if (formats()[i].name == name) return i;
    names.push_back(formats()[i].name);
  }
  throw Error(Exit::usage,
              fmt::format("{}: unknown format \"{}\"; expected one of {}", option, name, fmt::join(names, ", ")));
}

Input open_input(const std::string& path, Source<std::string> bytes, const InputOptions& options) {
  bytes = without_mark(std::move(bytes));
  std::string beginning;
  for (bool blank = true; blank;) {
    auto more = bytes();
    if (!more) break;
    blank = more->find_first_not_of(" \t\r\n") == std::string::npos;
    beginning += *more;
    if (beginning.size() > longest_record) refuse_long_record(1);
  }
  const std::size_t format = options.format ? *options.format : detect(path, beginning);
  Input input = formats()[format].open(preceded_by(std::move(beginning), std::move(bytes)), options);
  input.threads = options.threads;
  input.facts.emplace(input.facts.begin(), "format", formats()[format].name);
  return input;
}

}  // namespace tcb
