// Reader of delimited text: from bytes to keys.
#include "read/csv/csv_reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>
#include <utility>

#include "io/encoding.hpp"
#include "numbers/parse_number.hpp"
#include "read/csv/splitter.hpp"
#include "read/csv/tokenizer.hpp"
#include "read/csv/vector_cells.hpp"
#include "read/input.hpp"
#include "read/json/text.hpp"
#include "read/key_builder.hpp"
#include "read/settings.hpp"
#include "schema/pose_formats.hpp"
#include "schema/usual_names.hpp"
#include "stream/ordered_map.hpp"
#include "text/suggest.hpp"
#include "text/utf8.hpp"

namespace tcb {
namespace {

/// A cell without a number, as the beginning of a sentence shows it.
std::string missing_cell(std::string_view cell) { return cell.empty() ? "an empty cell" : in_quotes(cell); }

Error wrong_number_of_cells(std::size_t cells, std::size_t expected) {
  return data_error(
      "the number of cells in the row is {}, but {} in the rows above; expected the same number; complete or correct "
      "the row, or give the delimiter with --delimiter",
      cells, expected);
}

/// A cell as a text of a key: a whole number as a number, everything else as a string.
std::string text_of(std::string_view cell) {
  const std::string_view digits = cell.substr(cell.starts_with('-') ? 1 : 0);
  const bool is_digits = !digits.empty() && digits.find_first_not_of("0123456789") == std::string_view::npos;
  const bool whole = is_digits && (digits == "0" ? digits.size() == cell.size() : digits[0] != '0');
  return (whole ? "" : "\"") + unquoted(cell);
}

/// A cell of a table that the program made, as a text of a key: a number or a word, unless it is in quotes.
std::string plain_text(std::string_view cell) {
  if (cell.starts_with('"')) return '"' + unquoted(cell);
  return cell == "null" ? "" : parse_number(cell) ? json_number_text(cell) : std::string(cell);
}

/// Whether a number of this role may be missing, as the curve has one for all keys.
bool shapes_curve(Role role) {
  return (role >= Role::tension && role <= Role::ease_out) ||
         (role >= Role::channel_tension && role <= Role::channel_bias);
}

/// Reads the records of a chunk as keys.
class RecordReader {
 public:
  RecordReader(const Chunk& chunk, const DelimitedHead& head)
      : head_(head),
        tokenizer_(chunk, head.dialect),
        decimals_(head.marks),
        keys_(head.columns, head.rules, head.units),
        time_cells_(head.columns.time_cells()) {}

  KeyBlock read() {
    while (!keys_.is_full() && next_record()) {
    }
    return keys_.finish();
  }

 private:
  bool next_record() {
    bool more = true, well_formed = true;
    try {
      more = tokenizer_.next(cells_);
    } catch (const Error& error) {
      keys_.add_fault(error);
      well_formed = false;
    }
    if (tokenizer_.broken()) keys_.break_curve();
    if (more && well_formed) add_key();
    return more;
  }

  void add_key() {
    const std::size_t expected = head_.columns.cells.size();
    if (cells_.size() != expected) {
      const auto unlike = head_.is_of_format ? line_unlike_format : wrong_number_of_cells;
      const Error fault = unlike(cells_.size(), expected);
      add_fault(cells_[std::min(cells_.size(), expected + 1) - 1],
                is_footer() ? data_error("{}{}", fault.message(), if_no_key()) : fault);
      return;
    }
    keys_.begin_key();
    for (std::size_t i = 0; i < expected && !keys_.is_full(); ++i) read_cell(cells_[i], head_.columns.cells[i]);
    if (!keys_.complete_time()) add_fault(cells_[time_cells_[0]], time_parts_not_whole(head_.columns.time));
    if (!keys_.end_key()) return;
    keys_.set_position(tokenizer_.line(), time_cells_.empty() ? 1 : tokenizer_.column(cells_[time_cells_[0]]));
  }

  void read_cell(std::string_view cell, const Columns::Column& column) {
    switch (column.role) {
      case Role::ignored:
        if (column.is_empty || (column.is_text && !head_.is_plain && tokenizer_.line() <= last_line_of_roles)) {
          require_text(cell, column);
        }
        break;
      case Role::group:
      case Role::carry: read_text(cell, column); break;
      case Role::clock: break;  // read with the date, or the year
      case Role::time:
        if (time_cells_.size() > 1) return read_joined_time(column);
        if (!keys_.has_times_as_numbers()) {
          if (!keys_.set_time_in_words(bare(cell))) read_no_number(cell, column);
          return;
        }
        [[fallthrough]];
      default: read_number(cell, column);
    }
  }

  void read_number(std::string_view cell, const Columns::Column& column) {
    const std::string_view text = bare(cell);
    if (cell.empty() && head_.is_plain && shapes_curve(column.role)) return;  // it is that of the curve
    if (is_one_of(decimals_.text(text), head_.rules.signs)) return read_no_number(cell, column);
    if (column.role == Role::time) {
      const auto time = decimals_.time(text);
      if (!time) return read_no_number(cell, column);
      keys_.set_time(*time);
    } else {
      const auto number = decimals_.number(text);
      if (!number) return read_no_number(cell, column);
      keys_.number(column) = *number;
    }
    if (keys_.takes_decimals() && !keys_.take_decimal(column, decimals_.text(text))) {
      add_fault(cell, number_beyond_doubles(head_.columns.name_of(column), unquoted(cell)));
    }
  }

  /// The time whose parts are in several cells.
  void read_joined_time(const Columns::Column& column) {
    std::vector<std::string> parts;
    std::optional<std::string_view> missing;
    for (const std::size_t cell : time_cells_) {
      parts.push_back(unquoted(cells_[cell]));
      if (!missing && is_missing_sign(bare(cells_[cell]), head_.rules.signs)) missing = cells_[cell];
    }
    if (missing) return read_no_number(*missing, column);
    const std::string text = joined_time(parts);
    if (!keys_.set_time_in_words(text)) add_fault(cells_[time_cells_[0]], no_time(head_.columns.time, text));
  }

  /// Why a text is not the time of a key.
  Error no_time(std::string_view column, std::string_view text) const {
    if (find_notation(text) == head_.units.notation) {
      return data_error(
          "{}: the time {} does not exist, or is not written as the first time is; expected a date of the calendar, a "
          "time of day without leap seconds, and a frame number that is below the frame rate and is not dropped",
          column, in_quotes(text));
    }
    return data_error("{}: {} is not in the notation of the first time; expected all times in one notation; convert it",
                      column, in_quotes(text));
  }

  /// A number such as -999 may be a sign of a missing one, also with a decimal comma.
  bool is_sign(std::string_view cell) {
    const auto& signs = head_.rules.signs;
    return is_missing_sign(bare(cell), signs) || is_one_of(decimals_.text(bare(cell)), signs);
  }

  /// A number in a column of text is a fault: that is a column of numbers with other texts in it, or without the first.
  void require_text(std::string_view cell, const Columns::Column& column) {
    if (!decimals_.number(bare(cell)) || is_missing_sign(bare(cell), head_.rules.signs)) return;
    if (column.is_empty)
      return add_fault(cell, number_in_empty_column(unquoted(cell), head_.columns, index_of(column)));
    add_fault(
        cell,
        data_error("{}: {} is a number in a column of text; expected only numbers or only text; give the text that "
                   "stands for missing numbers to --na, or leave the column out with --columns position=NAME:NAME",
                   fmt::format("column {}", index_of(column) + 1), in_quotes(unquoted(cell))));
  }

  void read_no_number(std::string_view cell, const Columns::Column& column) {
    const bool is_missing = is_sign(cell);
    if (is_missing && keys_.miss(column)) return;
    const std::string text = unquoted(cell);
    const std::string name = head_.columns.name_of(column);
    const bool is_time = column.role == Role::time;
    if (is_missing) {
      const bool is_of_time = is_time || column.role == Role::nanoseconds;
      add_fault(
          cell,
          column.role == Role::position && head_.columns.channels.size() > 1
              ? data_error("{}: found {}; expected a number; fill it in, or give --missing skip-cell, skip-row or "
                           "break, or --columns {} to leave the column out",
                           name, missing_cell(text),
                           in_shell("ignore=" + requested_as(head_.columns.named ? name : "", index_of(column))))
          : column.role == Role::position
              ? data_error("{}: found {}; expected a number; fill it in, or give --missing skip-row or break", name,
                           missing_cell(text))
          : is_of_time
              ? data_error("{}: found {}; expected a time; fill it in, or give --missing skip-row or break", name,
                           missing_cell(text))
              : data_error(
                    "{}: found {}; expected a number; fill it in, or give --missing skip-cell, skip-row or break", name,
                    missing_cell(text)));
    } else if (is_time && (!keys_.has_times_as_numbers() || find_notation(text))) {
      add_fault(cell, no_time(name, text));
    } else if (repeats_name(cell, column)) {
      if (std::exchange(line_of_names_, tokenizer_.line()) == tokenizer_.line()) return;  // that has its fault
      add_fault(cell, data_error("the line repeats the names of the columns; expected a key; remove it, or give the "
                                 "files that were joined one by one"));
    } else if (is_footer()) {
      const Error fault = why_not_number(name, text, head_.marks);
      add_fault(cell, data_error("{}{}", fault.message(), if_no_key()));
    } else if (is_word(text, column)) {
      const bool has_name = column.role == Role::position || head_.is_plain;
      const std::string request = requested_as(has_name ? name : "", index_of(column));
      add_fault(cell, data_error("{}: {} is not a number; expected a decimal such as -1.5 or 2e3; correct the cell, or "
                                 "give it to --na, along with --missing, if it stands for a missing number, "
                                 "--columns {} to leave the column out, or --group {} if it tells curves apart",
                                 name, in_quotes(text), in_shell("ignore=" + request), in_shell(request)));
    } else {
      add_fault(cell, why_not_number(name, text, head_.marks));
    }
  }

  bool repeats_name(std::string_view cell, const Columns::Column& column) const {
    return head_.columns.named && unquoted(cell) == head_.columns.name_of(column);
  }

  /// Whether a record begins with a word where the rows above have a number or a time, as totals and repeated names do.
  bool is_footer() const {
    const Role role = head_.columns.cells[0].role;
    if (!head_.begins_with_value || head_.is_of_format || head_.is_plain || role == Role::ignored ||
        role == Role::group || role == Role::carry) {
      return false;
    }
    const std::string_view word = bare(cells_[0]);
    return !word.empty() && word.find_first_of("0123456789") == std::string_view::npos &&
           !is_missing_sign(word, head_.rules.signs);
  }

  /// The remedy for a record that is no key.
  std::string if_no_key() const {
    return fmt::format(", or give --comment {} if such lines are no keys", in_shell(bare(cells_[0])));
  }

  /// Whether a cell without digits is in a column that may hold words by its name.
  bool is_word(std::string_view text, const Columns::Column& column) const {
    if (!head_.columns.named || column.role == Role::time || column.role == Role::nanoseconds) return false;
    return !is_coordinate(head_.columns.name_of(column)) && !looks_numeric(text) &&
           text.find_first_of("0123456789") == std::string_view::npos;
  }

  std::size_t index_of(const Columns::Column& column) const {
    return static_cast<std::size_t>(&column - head_.columns.cells.data());
  }

  void read_text(std::string_view cell, const Columns::Column& column) {
    std::string text = head_.is_plain ? plain_text(cell) : text_of(cell);
    if (!head_.facts.encoding.empty()) text = in_utf8(text, Encoding::windows_1252).value_or(text);
    const std::size_t invalid = find_invalid_utf8(text);
    if (invalid != std::string::npos)
      add_fault(cell, data_error("{} has the byte {:02X}, which is not UTF-8; expected UTF-8; convert the text, as in "
                                 "iconv -f WINDOWS-1252 -t UTF-8 <FILE | tcbsample",
                                 in_quotes(unquoted(cell)), static_cast<unsigned char>(text[invalid])));
    if (content(text).empty() && !keys_.miss(column))
      add_fault(
          cell,
          data_error("{}: found an empty cell; expected the name of a curve; fill it in, or give --missing skip-row",
                     head_.columns.name_of(column)));
    keys_.set_text(column, std::move(text));
  }

  void add_fault(std::string_view cell, const Error& fault) {
    if (!keys_.is_full()) keys_.add_fault(fault.at(tokenizer_.position(cell)));
  }

  const DelimitedHead& head_;
  Tokenizer tokenizer_;
  Decimals decimals_;
  KeyBuilder keys_;
  std::vector<std::string_view> cells_;
  const std::vector<std::size_t> time_cells_;  ///< in the order of the parts of a time
  std::uint64_t line_of_names_ = 0;            ///< the last line that repeats the names of the columns
};

/// Drops lines at the beginning. Throws: Error (data) where there are fewer.
Source<std::string> without_lines(Source<std::string> bytes, std::uint64_t lines) {
  return [bytes = std::move(bytes), lines]() mutable -> std::optional<std::string> {
    std::optional<std::string> text = bytes();
    while (lines > 0) {
      if (!text) {
        throw data_error(
            "the input ends within the lines that --skip-lines skips; expected more lines; give a smaller number");
      }
      std::size_t at = 0;
      while (lines > 0 && (at = text->find('\n')) != std::string::npos) {
        text->erase(0, at + 1);
        --lines;
      }
      if (lines > 0 || text->empty()) text = bytes();
      if (!text && lines == 0) return std::nullopt;
    }
    return text;
  };
}

/// Throws: Error (data) for the first fault of the records above a line.
void require_keys(const Chunk& data, std::uint64_t end, const DelimitedHead& head) {
  std::size_t size = 0;
  for (std::uint64_t line = data.line; line < end && size < data.text.size(); ++line) {
    size = std::min(data.text.find('\n', size), data.text.size() - 1) + 1;
  }
  const KeyBlock keys = parse_delimited(Chunk{data.text.substr(0, size), data.line, 0}, head);
  if (!keys.faults.errors.empty()) throw Error(keys.faults.errors.front());
}

/// Whether a quoted number with a decimal comma occurs, so that a comma outside quotes is the delimiter.
bool has_quoted_decimal(std::string_view text) {
  for (std::size_t comma = text.find(','); comma != std::string_view::npos; comma = text.find(',', comma + 1)) {
    const std::size_t begin = text.find_last_of("\",\n", comma - 1), end = text.find_first_of("\",\n", comma + 1);
    const bool is_quoted = comma > 0 && begin != std::string_view::npos && end != std::string_view::npos &&
                           text[begin] == '"' && text[end] == '"';
    if (is_quoted && Decimals({','}).number(text.substr(begin + 1, end - begin - 1))) return true;
  }
  return false;
}

/// The options with the columns of a format of poses, its rotation and its unit of times, unless others are requested.
InputOptions options_of_poses(const Format& format, Source<std::string>&, InputOptions options) {
  const PoseFormat& poses = *format.poses;
  options.delimited.names.assign(poses.columns.begin(), poses.columns.end());
  options.delimited.others.assign(poses.others.begin(), poses.others.end());
  options.delimited.delimiter = format.delimiter;
  options.delimited.header = false;
  if (poses.form == spline::RotationForm::matrix && options.rotation.requests.empty() && !options.rotation.none) {
    options.rotation.requests.push_back(rotation_of(poses));
  }
  if (poses.unit && !options.units.time && !options.units.frame_rate) options.units.time = poses.unit;
  if (!poses.unit) options.columns.timeless = true;
  return options;
}

/// Whether no quoted cell goes on in another line.
bool closes_quotes(std::string_view text) {
  if (text.find('"') == std::string_view::npos) return true;
  return std::ranges::all_of(split(text.substr(0, text.rfind('\n')), '\n'),
                             [](std::string_view line) { return std::ranges::count(line, '"') % 2 == 0; });
}

}  // namespace

std::string joined_time(std::span<const std::string> parts) {
  constexpr std::size_t least = 3;
  if (parts.size() < least) return fmt::format("{}", fmt::join(parts, " "));
  const auto part = [&](std::size_t i) { return i < parts.size() ? parts[i] : "0"; };
  const auto padded = [&](std::size_t i) {
    const bool has_one_digit = part(i).find_first_not_of("0123456789") == 1 || part(i).size() == 1;
    return (has_one_digit ? "0" : "") + part(i);
  };
  const std::string date = fmt::format("{}-{}-{}", part(0), padded(1), padded(2));
  return parts.size() == least ? date : fmt::format("{} {}:{}:{}", date, padded(3), padded(4), padded(5));
}

KeyBlock parse_delimited(const Chunk& chunk, const DelimitedHead& head) { return RecordReader(chunk, head).read(); }

namespace {

std::string_view first_lines(std::string_view text, std::uint64_t count) {
  std::size_t end = 0;
  for (; count > 0 && end < text.size(); --count) end = std::min(text.find('\n', end), text.size() - 1) + 1;
  return text.substr(0, end);
}

/// Notes what the lines above the keys say of the curve. Those of an earlier output of the program say what made it.
void tell_settings(std::string_view lines, const InputOptions& options, DelimitedHead& head) {
  const bool is_output = lines.substr(0, lines.find('\n')).find("tcbsample ") != std::string_view::npos;
  if (is_output) return;
  SettingsInText found = settings_in(lines, options, !head.columns.shape_roles().empty());
  head.facts.shown_rate = found.frame_rate;
  const bool are_rows = !found.frame_rate.empty() && !options.units.frame_rate && !head.columns.has(Role::time);
  if (are_rows) {
    found.shown.push_back(found.shown_rate);
    found.options.push_back("--input-fps " + found.frame_rate);
  }
  if (found.options.empty()) return;
  head.columns.doubts.push_back(fmt::format("a line above the keys says {}, which is not applied; {} applies it",
                                            listed(found.shown), fmt::join(found.options, " ")));
}

/// The options that apply what lines above a table say, each behind a blank.
std::string options_of_lines(std::string_view lines, const InputOptions& options, const LaterTable& table) {
  const SettingsInText found = settings_in(lines, options, table.has_tcb);
  std::string text;
  for (const std::string& option : found.options) text += " " + option;
  const bool takes_rate = table.takes_rate && !options.units.frame_rate && !found.frame_rate.empty();
  return takes_rate ? text + " --input-fps " + found.frame_rate : text;
}

}  // namespace

Records open_delimited(Source<std::string> bytes, InputOptions options) {
  if (options.delimited.skipped_lines > 0) bytes = without_lines(std::move(bytes), options.delimited.skipped_lines);
  const std::optional<char> named = take_named_delimiter(bytes);
  const std::optional<char> delimiter = options.delimited.delimiter ? options.delimited.delimiter : named;
  Beginning beginning = find_delimiter(bytes, delimiter, options.delimited);
  if (named) ++beginning.line;
  beginning.line += options.delimited.skipped_lines;
  const Dialect dialect{beginning.delimiter, options.delimited.comment, options.columns.samples.has_value()};
  const bool is_decimal = dialect.delimiter == options.delimited.marks.decimal;
  if (is_decimal && !has_quoted_decimal(beginning.text))
    throw data_error(
        "the comma is both the decimal mark and the delimiter; expected different characters; give another delimiter "
        "with --delimiter, or remove --decimal");
  constexpr std::size_t most_of_preamble = 1UL << 16;
  const std::string first = beginning.text.substr(0, most_of_preamble);
  const bool is_any = options.delimited.names.empty() && !options.columns.samples;
  const std::uint64_t first_line = beginning.line;
  Source<Chunk> chunks =
      split_delimited(preceded_by(std::move(beginning.text), std::move(bytes)), dialect, beginning.line);
  const bool may_have_vectors = is_any && options.delimited.marks.decimal != ',';
  const auto vectors = may_have_vectors ? take_vectors(chunks, dialect) : std::vector<VectorColumn>();
  if (!vectors.empty()) options = with_vectors(std::move(options), vectors);
  std::vector<Chunk> rest;
  const auto find_table_below = [&](std::string_view text) {
    return is_any ? find_later_table(text, dialect) : std::nullopt;
  };
  const auto head = std::make_shared<const DelimitedHead>([&] {
    try {
      DelimitedHead found = read_head(chunks, dialect, options, rest);
      constexpr std::size_t most = 1UL << 12;
      const std::string_view text = std::string_view(first).substr(0, most);
      const auto table = closes_quotes(text) ? find_table_below(text) : std::nullopt;
      const bool is_unlike = table && (table->follows_text || table->cells != found.columns.cells.size());
      if (is_unlike) require_keys(rest.front(), first_line + table->line, found);
      if (is_any && !found.is_plain) tell_settings(first_lines(first, rest.front().line - first_line), options, found);
      return found;
    } catch (const Error& error) {
      if (error.exit() != Exit::data) throw;
      auto table = find_table_below(first);
      if (!table) throw;
      table->options += options_of_lines(first_lines(first, table->line - 1), options, *table);
      const std::string_view reason = error.message();
      throw unlike_table(*table, first_line, options.columns.roles.empty() ? "" : reason.substr(0, reason.find(';')));
    }
  }());
  for (; !rest.empty(); rest.pop_back()) chunks = preceded_by(std::move(rest.back()), std::move(chunks));
  const auto parse = [head](const Chunk& chunk) { return parse_delimited(chunk, *head); };
  Records records{head->columns, head->units};
  if (!vectors.empty()) {
    std::vector<std::string> names;
    std::ranges::transform(vectors, std::back_inserter(names), &VectorColumn::name);
    records.columns.doubts.push_back(
        fmt::format("cells hold several numbers, which are taken as columns of their own: {}", listed(names)));
  }
  records.marks = {dialect.delimiter, head->marks.decimal};
  records.time_unit = head->time_unit;
  records.facts = head->facts;
  records.facts.comment = dialect.comment;
  records.keys.blocks = ordered_map(std::move(chunks), parse, options.threads);
  records.keys.traits.may_break =
      dialect.delimiter == ' ' || dialect.divided || options.keys.missing == Missing::break_curve;
  return records;
}

namespace {

/// The lines of a format, which has a delimiter, unless any may be found.
Records open_lines(const Format& format, Source<std::string> bytes, InputOptions options) {
  std::optional<char>& delimiter = options.delimited.delimiter;
  if (!delimiter && !format.offers(offer::any_delimiter)) delimiter = format.delimiter;
  return open_delimited(std::move(bytes), options);
}

}  // namespace

extern const InputFormat poses_input{.open = open_lines, .options = options_of_poses, .has_own_columns = true};
extern const InputFormat delimited_input{.open = open_lines, .fit = [](std::string_view) { return std::optional(1); }};

}  // namespace tcb
