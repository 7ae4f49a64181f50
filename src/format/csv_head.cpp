// The beginning of delimited text: its header, and which column is what.
#include "format/csv_head.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "error.hpp"
#include "format/number.hpp"

namespace tcb::format {
namespace {

using Cells = std::vector<std::string_view>;

std::vector<std::string> texts(const Cells& cells) {
  std::vector<std::string> result;
  std::ranges::transform(cells, std::back_inserter(result), unquoted);
  return result;
}

/// The names in a comment line such as "# timestamp tx ty tz".
std::vector<std::string> comment_names(std::string_view comment, const Dialect& dialect) {
  comment.remove_prefix(dialect.comment.size());
  const Chunk chunk{std::string(comment), 1, 0};
  const Dialect no_comments{dialect.delimiter, ""};
  Cells cells;
  Records(chunk, no_comments).next(cells);
  return texts(cells);
}

/// The first three records of an input, or as many as there are: enough to tell header and columns.
struct FirstRecords {
  struct Record {
    std::vector<std::string> cells;
    std::string comment;  ///< the comment line directly above
    std::size_t offset = 0;
    std::uint64_t line = 1;
  };
  std::vector<Record> records;
};

FirstRecords first_records(const Chunk& chunk, const Dialect& dialect) {
  FirstRecords first;
  Records records(chunk, dialect);
  for (Cells cells; first.records.size() < 3 && records.next(cells);) {
    first.records.push_back({texts(cells), std::string(records.comment()), records.offset(), records.line()});
  }
  return first;
}

bool is_header(const FirstRecords::Record& record) { return !std::ranges::all_of(record.cells, looks_numeric); }

/// A column holds numbers unless both of the first two data records have text there.
std::vector<bool> numeric_columns(const FirstRecords& first, std::size_t data) {
  const auto& one = first.records[data].cells;
  const auto& two = data + 1 < first.records.size() ? first.records[data + 1].cells : one;
  std::vector<bool> numeric(one.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    numeric[i] = looks_numeric(one[i]) || (i < two.size() && looks_numeric(two[i]));
  }
  return numeric;
}

}  // namespace

DelimitedHead read_head(Source<Chunk>& chunks, const Dialect& dialect, const InputOptions& options, Chunk& rest) {
  FirstRecords first;
  rest = {};
  while (first.records.size() < 3) {
    std::optional<Chunk> more = chunks();
    if (!more) break;
    rest.text += more->text;
    first = first_records(rest, dialect);
  }
  if (first.records.empty()) {
    throw Error(Exit::data, "no keys: the input is empty; expected a row for each key; see --help");
  }
  const bool header = options.header.value_or(is_header(first.records[0]));
  std::size_t data = header ? 1 : 0;
  std::vector<std::string> names = header ? first.records[0].cells : std::vector<std::string>{};
  if (data == first.records.size()) {
    throw Error(Exit::data, Place{"", first.records[0].line, 1},
                "no keys: there is a header and no row; expected a row for each key; see --help");
  }
  if (!header && !options.header && !first.records[0].comment.empty()) {
    auto above = comment_names(first.records[0].comment, dialect);
    if (above.size() == first.records[0].cells.size()) names = std::move(above);
  }
  const auto& row = first.records[data];
  if (!names.empty() && names.size() != row.cells.size()) {
    throw Error(Exit::data, Place{"", row.line, 1},
                fmt::format("the first row has {} where the header has {}; expected the same number; correct one of "
                            "them, or give the delimiter with -d",
                            row.cells.size(), names.size()));
  }
  rest.text.erase(0, row.offset);
  rest.line = row.line;
  return {dialect, find_columns(names, numeric_columns(first, data), options.roles, options.timeless)};
}

std::vector<std::pair<std::string, std::string>> facts(const DelimitedHead& head) {
  const char delimiter = head.dialect.delimiter;
  const Columns& columns = head.columns;
  std::vector<std::pair<std::string, std::string>> found{{"delimiter", delimiter == '\t'  ? "tab"
                                                                       : delimiter == ' ' ? "blanks"
                                                                                          : std::string(1, delimiter)},
                                                         {"header", columns.named ? "yes" : "no"}};
  if (columns.has(Role::time)) found.emplace_back("time", columns.time);
  found.emplace_back("position", fmt::format("{}", fmt::join(columns.channels, ", ")));
  for (const auto& [role, name] :
       {std::pair{Role::tension, "tension"}, std::pair{Role::continuity, "continuity"}, std::pair{Role::bias, "bias"},
        std::pair{Role::ease_in, "ease_in"}, std::pair{Role::ease_out, "ease_out"}}) {
    if (columns.has(role)) found.emplace_back(name, "in a column");
  }
  if (!columns.left_out.empty()) found.emplace_back("left out", fmt::format("{}", fmt::join(columns.left_out, ", ")));
  return found;
}

}  // namespace tcb::format
