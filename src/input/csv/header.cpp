// The beginning of delimited text: its header, and which column is what.
#include "input/csv/header.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "error.hpp"
#include "text/decimal_mark.hpp"
#include "text/refusal.hpp"

namespace tcb {
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
class FirstRecords {
 public:
  struct Record {
    std::vector<std::string> cells;
    std::string comment;    ///< the comment line directly above
    std::size_t chunk = 0;  ///< in which it stands, and where there
    std::size_t offset = 0;
    std::uint64_t line = 1;
  };

  FirstRecords(const Source<Chunk>& source, const Dialect& dialect) {
    while (records.size() < 3) {
      std::optional<Chunk> chunk = source();
      if (!chunk) break;
      add(std::move(*chunk), dialect);
    }
  }

  std::vector<Record> records;
  std::vector<Chunk> chunks;  ///< with records, or with a line that sets curves apart

 private:
  void add(Chunk chunk, const Dialect& dialect) {
    Records walk(chunk, dialect);
    const std::size_t before = records.size();
    bool more = true;
    for (Cells cells; records.size() < 3 && (more = walk.next(cells));) {
      if (!walk.comment().empty() || walk.follows_blank()) comment_.clear();
      if (!walk.comment().empty()) comment_ = walk.comment();
      records.push_back({texts(cells), std::exchange(comment_, {}), chunks.size(), walk.offset(), walk.line()});
    }
    if (!more && walk.follows_blank()) comment_.clear();
    if (!more && !walk.comment().empty()) comment_ = walk.comment();
    if (records.size() == before && !walk.broken()) return;
    if (records.size() == before) chunk.text = "\n";
    if (!records.empty()) chunks.push_back(std::move(chunk));
  }

  std::string comment_;  ///< the last line, where that is one
};

/// The cell is for a column of numbers. One with another decimal mark is too, to be refused as a number.
bool looks_numeric(std::string_view cell, const DelimitedHead& head) {
  return Decimals('.').looks_numeric(cell) || (head.dialect.delimiter != ',' && Decimals(',').looks_numeric(cell));
}

bool is_header(const FirstRecords::Record& record, const DelimitedHead& head) {
  return !std::ranges::all_of(record.cells, [&](const auto& cell) { return looks_numeric(cell, head); });
}

/// A column holds numbers unless both of the first two data records have text there, or nothing, not even a name.
std::vector<bool> numeric_columns(const FirstRecords& first, std::size_t data, const std::vector<std::string>& names,
                                  const DelimitedHead& head) {
  const auto& one = first.records[data].cells;
  const auto& two = data + 1 < first.records.size() ? first.records[data + 1].cells : one;
  std::vector<bool> numeric(one.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    const std::string_view below = i < two.size() ? std::string_view(two[i]) : "";
    const bool nameless = i < names.size() && names[i].empty();
    const bool nothing = nameless && one[i].empty() && below.empty();
    numeric[i] = !nothing && (looks_numeric(one[i], head) || (i < two.size() && looks_numeric(below, head)));
  }
  return numeric;
}

/// Throws: Error (data) for a name that cannot be written again.
void require_characters(const std::vector<std::string>& names, const TextPosition& place) {
  for (const std::string& name : names) {
    const std::size_t foreign = find_foreign(name);
    if (foreign == std::string::npos) continue;
    throw Error(Exit::data, place, fmt::format("column {}: {}", shown(name), foreign_byte(name[foreign])));
  }
}

/// The name gives its column a role, or is asked for.
bool says_something(const std::string& name, const InputOptions& options) {
  return role_of_name(name) != Role::position || std::ranges::any_of(options.roles, [&](const RoleRequest& role) {
           return std::ranges::count(role.columns, name) > 0;
         });
}

/// A comment names columns where one name says something, and none is a number: it may be any other text, or a key
/// that somebody took out.
bool are_names(const std::vector<std::string>& words, const DelimitedHead& head, const InputOptions& options) {
  const auto is_number = [&](const std::string& word) { return looks_numeric(word, head); };
  return std::ranges::none_of(words, is_number) &&
         (options.timeless ||
          std::ranges::any_of(words, [&](const std::string& word) { return says_something(word, options); }));
}

/// Throws: Error (data) where a column of text seems to be meant for numbers, by its first record.
void require_text(const Chunk& data, const DelimitedHead& head, const std::vector<bool>& numeric) {
  Records records(data, head.dialect);
  Cells cells;
  records.next(cells);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (head.columns.cells[i].role != Role::left_out || numeric[i]) continue;
    const std::string cell = unquoted(cells[i]);
    constexpr std::string_view minus = "\xE2\x88\x92";  // as typesetters have it
    const std::size_t digit = cell.starts_with(minus) ? minus.size() : cell.find_first_not_of("+-.,");
    if (digit >= cell.size() || cell[digit] < '0' || cell[digit] > '9') continue;
    TextPosition place = records.place(cells[i]);
    throw Error(Exit::data, std::move(place),
                fmt::format("column {}: {}; or name the columns to take with --columns position=", i + 1,
                            no_number(cell, head.decimal)));
  }
}

/// Throws: Error (data) where the first record may be a header or a key with a slip in it: one of its cells is text,
/// another a number, and none a name that says something.
void require_clear_header(const FirstRecords::Record& record, const DelimitedHead& head, const InputOptions& options) {
  const auto is_number = [&](const std::string& cell) { return !is_missing(cell) && looks_numeric(cell, head); };
  const auto is_name = [&](const std::string& cell) { return !is_number(cell) && says_something(cell, options); };
  const auto number = std::ranges::find_if(record.cells, is_number);
  if (number == record.cells.end() || std::ranges::any_of(record.cells, is_name)) return;
  const auto text = std::ranges::find_if_not(record.cells, [&](const auto& cell) { return looks_numeric(cell, head); });
  throw Error(
      Exit::data, TextPosition{"", record.line, 1},
      fmt::format("the first record has text, {}, and a number, {}; expected names or numbers alone; give --header "
                  "if they are names, --no-header if they are not",
                  shown(*text), shown(*number)));
}

/// Throws: Error (data) for an input of one line.
[[noreturn]] void refuse_header_alone(const FirstRecords::Record& record) {
  const bool carriage_returns =
      std::ranges::any_of(record.cells, [](const auto& cell) { return cell.find('\r') != std::string::npos; });
  throw Error(Exit::data, TextPosition{"", record.line, 1},
              carriage_returns
                  ? "no keys: there is one line, with carriage returns in it; expected a line for each key; "
                    "change them to line feeds, for example with tr"
                  : "no keys: there is a header and no row; expected a row for each key; see --help");
}

}  // namespace

DelimitedHead read_head(const Source<Chunk>& chunks, const Dialect& dialect, const InputOptions& options,
                        std::vector<Chunk>& rest) {
  FirstRecords first(chunks, dialect);
  DelimitedHead head{dialect, {}, options.tcb, options.decimal, options.missing, options.keeps_decimals};
  if (first.records.empty()) {
    throw Error(Exit::data, "no keys: the input is empty; expected a row for each key; see --help");
  }
  const bool header = options.header.value_or(is_header(first.records[0], head));
  std::size_t data = header ? 1 : 0;
  std::vector<std::string> names = header ? first.records[0].cells : std::vector<std::string>{};
  TextPosition place{"", first.records[0].line, 0};  // of the names
  if (header && !options.header) require_clear_header(first.records[0], head, options);
  if (data == first.records.size()) refuse_header_alone(first.records[0]);
  if (!header && !options.header && !first.records[0].comment.empty()) {
    auto above = comment_names(first.records[0].comment, dialect);
    if (above.size() == first.records[0].cells.size() && are_names(above, head, options)) {
      names = std::move(above);
      --place.line;
    }
  }
  const auto& row = first.records[data];
  if (!names.empty() && names.size() != row.cells.size()) {
    throw Error(Exit::data, TextPosition{"", row.line, 1},
                fmt::format("the first row has {} where the header has {}; expected the same number; correct one of "
                            "them, or give the delimiter with -d",
                            row.cells.size(), names.size()));
  }
  require_characters(names, place);
  rest.assign(first.chunks.begin() + static_cast<std::ptrdiff_t>(row.chunk), first.chunks.end());
  rest[0].text.erase(0, row.offset);
  rest[0].line = row.line;
  const auto numeric = numeric_columns(first, data, names, head);
  at_position(place, [&] {
    head.columns = options.samples ? find_sample_columns(names, numeric, *options.samples, options.timeless)
                                   : find_columns(names, numeric, options.roles, options.timeless);
    if (!options.samples) require_no_slip(names, head.columns, options.roles, options.timeless);
  });
  const bool chosen = std::ranges::any_of(options.roles, [](const auto& role) { return role.role == Role::position; });
  if (!chosen && !options.samples) require_text(rest[0], head, numeric);
  return head;
}

}  // namespace tcb
