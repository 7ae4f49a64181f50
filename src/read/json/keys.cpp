// JSON keys: records on a tape become keys.
#include "read/json/keys.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "numbers/dates.hpp"
#include "numbers/parse_number.hpp"
#include "numbers/time_notation.hpp"
#include "read/key_builder.hpp"

namespace tcb {
namespace {

using Column = Columns::Column;
using Kind = JsonNode::Kind;
using Member = JsonColumns::Member;

bool is_text(const Column& column) { return column.role == Role::group || column.role == Role::carry; }

/// Passes the cells of records to the key builder.
class KeyReader {
 public:
  /// `number`: of the next record, in the list at `path`.
  KeyReader(const JsonTape& tape, const JsonColumns& columns, std::string path, std::uint64_t number)
      : tape_(tape),
        columns_(columns),
        signs_(columns.rules.signs),
        keys_(columns.columns, columns.rules, columns.units),
        path_(std::move(path)),
        number_(number),
        seen_(columns.all_members) {
    find_required(columns.key);
  }

  bool is_full() const { return keys_.is_full(); }
  void add_fault(Error error) { keys_.add_fault(std::move(error)); }
  KeyBlock finish() { return keys_.finish(path_); }
  KeyBlock finish_unreadable(const Error& error) {
    add_fault(error);
    keys_.set_unreadable();
    return finish();
  }
  void skip_record() { ++number_; }

  /// Reads a record, or null, which breaks the curve and counts as one in a list. Throws: Error (data) for another
  /// value.
  void read(const JsonTable& table, std::size_t row, LineCounter& lines, bool is_in_list = true) {
    const std::size_t place = table.place(row);
    if (!table.is_record(row)) {
      const bool is_break = tape_.kind(place) == Kind::null && tape_.written(place) == "null";
      if (!is_break) throw not_a_record(tape_, place, table.columns() > 0);
      keys_.break_curve();
      if (is_in_list) skip_record();
      return;
    }
    begin_key();
    const LinePosition position = lines.to(tape_.part().chunk.text, tape_[place].begin);
    table.get_cells(row, cells_);
    for (const JsonCell& cell : cells_) read_member(cell);
    if (const std::size_t cells = table.columns(); cells > 0 && tape_.count(place) != cells) {
      add_fault(row_of_other_size(number_, tape_.count(place), cells).at(tape_.position(place)));
    }
    end_key(place, position);
  }

 private:
  void begin_key() {
    keys_.begin_key();
    tcb_given_ = 0;
    std::ranges::fill(seen_, 0);
    is_provenance_ = false;
  }

  void end_key(std::size_t place, const LinePosition& position) {
    const std::uint64_t number = number_++;
    if (is_provenance_ && std::ranges::count(seen_, 1) == 0) return;
    for (const Member* member : required_) {
      if (keys_.is_missing()) break;
      if (seen_[member->number] == 0) miss_member(*member, place);
    }
    if (!keys_.complete_time()) add_fault(time_parts_not_whole(columns_.columns.time).at(tape_.position(place)));
    if (!keys_.end_key()) return;
    keys_.set_number(number);
    keys_.set_position(position.line, position.column);
  }

  void find_required(const Member& outer) {
    for (const Member& member : outer.inner) {
      if (member.required) required_.push_back(&member);
      find_required(member);
    }
  }

  void read_member(const JsonCell& cell) {
    cell_ = &cell;
    is_provenance_ = is_provenance_ || cell.name == "meta";
    const Member* const member = columns_.key.find(cell.name, tape_.kind(cell.value));
    const bool is_spread = (cell.name == "tcb" || cell.name == "rotation") && tape_.kind(cell.value) == Kind::object;
    if (member != nullptr && (!is_spread || member->is_nested())) return read_value(*member, cell.value);
    if (!is_spread) return refuse_unknown(cell.value);
    for (const std::size_t name : tape_.inside(cell.value)) refuse_unknown(name + 1);
  }

  /// Numbers that the first key does not have are faults.
  void refuse_unknown(std::size_t value) {
    const std::size_t first = tape_.kind(value) == Kind::array ? value + 1 : value;
    const bool is_number = first < tape_[value].next && tape_.kind(first) == Kind::number;
    if (is_number && !is_provenance_) {
      add_value_fault(
          first, data_error("the first key has no such number; expected the same members in every key; add it there"));
    }
  }

  void read_value(const Member& member, std::size_t value) {
    if (member.is_nested()) return read_inner(member, value);
    if (seen_[member.number] != 0) {
      return add_value_fault(cell_->place, twice_in("key"));
    }
    seen_[member.number] = 1;
    if (member.cells == 0) return;
    const Column& column = columns_.columns.cells[member.cell];
    const Kind kind = tape_.kind(value);
    const bool is_number = kind == Kind::number || kind == Kind::null;
    if (member.array && kind == Kind::array) {
      read_array(member, value);
    } else if (!tape_[value].is_nested() && !(member.array && is_number)) {
      read_cell(column, value);
    } else if (column.role != Role::ignored) {
      add_shape_fault(member, value);
    }
  }

  void read_array(const Member& member, std::size_t array) {
    std::size_t index = 0;
    for (const std::size_t value : tape_.inside(array)) {
      if (index++ >= member.cells) continue;
      const Column& column = columns_.columns.cells[member.cell + index - 1];
      if (!tape_[value].is_nested()) {
        read_cell(column, value);
      } else if (column.role != Role::ignored) {
        add_shape_fault(member, value);
      }
    }
    if (index == member.cells) return;
    add_value_fault(array, data_error("the array has {}; expected {}, as in the first key; correct it",
                                      how_many(index, "element"), member.cells));
  }

  /// The members of an object, or the elements of an array, that have columns.
  void read_inner(const Member& member, std::size_t value) {
    const Kind kind = tape_.kind(value);
    if (kind == Kind::null) return;  // what a key needs is missing
    const bool is_object = kind == Kind::object;
    if (!is_object && (kind != Kind::array || !member.inner[0].name.starts_with('['))) {
      return refuse_unknown(value);  // what a key needs is missing
    }
    std::size_t index = 0;
    for (const std::size_t inner : tape_.inside(value)) {
      const std::string step = is_object ? "" : fmt::format("[{}]", index++);
      const std::size_t of_inner = tape_.value_of(inner);
      const Member* const found = member.find(is_object ? tape_.text(inner) : step, tape_.kind(of_inner));
      if (found != nullptr) {
        read_value(*found, of_inner);
      } else if (member.is_whole) {
        refuse_unknown(of_inner);
      }
    }
  }

  void read_cell(const Column& column, std::size_t value) {
    const Kind kind = tape_.kind(value);
    const bool is_quoted = kind == Kind::string || kind == Kind::name;
    const std::string_view text = tape_.shown(value);
    if (column.is_empty && (kind == Kind::number || (is_quoted && parse_number(text)))) {
      const auto cell = static_cast<std::size_t>(&column - columns_.columns.cells.data());
      return add_value_fault(value, number_in_empty_column(text, columns_.columns, cell));
    }
    if (column.role == Role::ignored) return kind == Kind::null ? void() : keys_.set_mark(column, text);
    if (is_text(column)) return read_text(column, text, value);
    const bool is_time = column.role == Role::time && is_quoted;
    if (is_time && keys_.set_time_in_words(text)) return;
    const bool is_sign =
        is_quoted ? is_missing_sign(text, signs_) : !signs_.empty() && std::ranges::count(signs_, text);
    if (kind == Kind::null || is_sign)
      return miss(column, text == "null" && !is_quoted ? "null" : in_quotes(text), value);
    if (kind == Kind::number || (is_quoted && parse_number(text))) return store(column, text, value);
    const bool is_other_time = is_time && (find_notation(text) || !keys_.has_times_as_numbers());
    const std::string date = is_time ? date_in_known_form(text) : "";
    if (!date.empty()) {
      add_value_fault(value, data_error("{} is a date in a form that is not read; expected it as {}; write it so",
                                        in_quotes(text), date));
    } else if (!is_other_time) {
      add_value_fault(
          value,
          is_time ? data_error(
                        "{} is no time in a known notation; expected a number, or a time such as 2024-03-01T13:00:00Z "
                        "or 13:00:00, with years of four digits; convert it",
                        in_quotes(text))
                  : data_error("{} is not a number; expected a number; correct it", in_quotes(text)));
    } else if (columns_.units.notation != find_notation(text)) {
      add_value_fault(value, time_in_other_notation(text));
    } else {
      add_value_fault(value, data_error("{} does not exist, or is not written as the first time is; expected a date of "
                                        "the calendar, a time of day "
                                        "without leap seconds, and an undropped frame below the rate; correct it",
                                        in_quotes(text)));
    }
  }

  /// The text of a group, or one that is kept: as it is quoted, or a number.
  void read_text(const Column& column, std::string_view text, std::size_t value) {
    switch (tape_.kind(value)) {
      case Kind::string:
      case Kind::name: return keys_.set_text(column, '"' + std::string(text));
      case Kind::number: return keys_.set_text(column, json_number_text(text));
      case Kind::null: break;
      default: return keys_.set_text(column, std::string(text));
    }
    if (column.role == Role::carry || keys_.miss(column)) return;
    add_value_fault(value, data_error("found null; expected a text; fill it in, or give --missing skip-row"));
  }

  static Error time_in_other_notation(std::string_view time) {
    return data_error("{} is not in the notation of the first time; expected one notation in all keys; convert it",
                      in_quotes(time));
  }

  /// A number is missing. `sign`: as a message shows it.
  void miss(const Column& column, const std::string& sign, std::size_t value) {
    if (keys_.miss(column)) return;
    add_value_fault(value, data_error("found {}; expected a number; fill it in, or give --missing {}skip-row or break",
                                      sign, column.role == Role::time ? "" : "skip-cell, "));
  }

  /// A number, or one in quotes.
  void store(const Column& column, std::string_view decimal, std::size_t value) {
    if (column.role == Role::time && !keys_.has_times_as_numbers()) {
      return add_value_fault(value, time_in_other_notation(decimal));
    }
    constexpr std::array parameters{Role::tension, Role::continuity, Role::bias};
    const auto parameter = std::ranges::find(parameters, column.role) - parameters.begin();
    if (parameter < std::ssize(parameters)) require_once(1U << parameter, value);
    if (!keys_.take(column, parse_number(decimal).value_or(0), decimal)) add_value_fault(value, too_large(decimal));
  }

  /// Tension, continuity or bias is a member, or a number of "tcb", but not both.
  void require_once(unsigned parameter, std::size_t value) {
    if ((tcb_given_ & parameter) != 0) {
      add_value_fault(value,
                      data_error("this parameter is given twice, in \"tcb\" and alone; expected it once; remove one"));
    }
    tcb_given_ |= parameter;
  }

  void miss_member(const Member& member, std::size_t place) {
    const auto begin = columns_.columns.cells.begin() + static_cast<std::ptrdiff_t>(member.cell);
    const auto end = begin + static_cast<std::ptrdiff_t>(member.cells);
    if (std::all_of(begin, end, [&](const Column& column) { return keys_.miss(column); })) {
      if (columns_.rules.missing == Missing::skip_cell) missing_.add(member.cells * bytes_of_missing_number);
      return;
    }
    if (is_full()) return;
    add_fault(data_error("the key has no member {}; expected the members of the first key; add it, or give --missing "
                         "{}skip-row or break",
                         in_quotes(member.title), begin->role == Role::time ? "" : "skip-cell, ")
                  .at(tape_.position(place)));
  }

  /// Adds a fault of a value of the current member.
  void add_value_fault(std::size_t value, const Error& fault) {
    if (is_full()) return;
    const std::string path = fmt::format("{}[{}].{}{}", path_.empty() ? "keys" : path_, number_, cell_->name,
                                         value == cell_->place ? "" : tape_.path(cell_->value, value));
    add_fault(fault.about(path).at(tape_.position(value)));
  }

  void add_shape_fault(const Member& member, std::size_t value) {
    const bool text = is_text(columns_.columns.cells[member.cell]);
    add_value_fault(value,
                    member.array
                        ? data_error("this is not an array; expected one of numbers, as in the first key; correct it")
                    : text ? data_error("this is not a text or a number; expected one, as in the first key; correct it")
                           : data_error("this is not a number; expected one, as in the first key; correct it"));
  }

  const JsonTape& tape_;
  const JsonColumns& columns_;
  const std::vector<std::string>& signs_;
  KeyBuilder keys_;
  MemoryUse missing_{columns_.max_memory};  ///< of the numbers that no record has
  std::string path_;
  std::uint64_t number_;             ///< of the current or the next record
  std::vector<unsigned char> seen_;  ///< 1 for the members of the current key; bits would take longer
  std::vector<const Member*> required_;
  JsonCells cells_;                 ///< of the current key
  const JsonCell* cell_ = nullptr;  ///< the current member
  bool is_provenance_ = false;      ///< the object has "meta", and is no key if it has no member of a key
  unsigned tcb_given_ = 0;          ///< a bit for each of the three
};

}  // namespace

Error not_a_record(const JsonTape& tape, std::size_t value, bool is_row) {
  const Kind kind = tape.kind(value);
  const std::string what = kind == Kind::number   ? "a number"
                           : kind == Kind::null   ? std::string(tape.written(value))
                           : kind == Kind::array  ? "an array"
                           : kind == Kind::object ? "an object"
                           : kind == Kind::string ? in_quotes(tape.text(value))
                                                  : in_quotes(tape.written(value));
  return data_error("found {} as a key; expected {}; correct it", what, is_row ? "an array" : "an object")
      .at(tape.position(value));
}

KeyBlock parse_table(const JsonTable& table, std::size_t first, std::size_t last, const JsonColumns& columns,
                     LineCounter& lines) {
  KeyReader reader(table.tape(), columns, table.path(), table.first() + first);
  try {
    for (std::size_t row = first; row < last && !reader.is_full(); ++row) reader.read(table, row, lines);
  } catch (const Error& error) {
    return reader.finish_unreadable(error);
  }
  return reader.finish();
}

KeyBlock parse_json(const JsonPart& part, const JsonColumns& columns) {
  const Chunk& chunk = part.chunk;
  LineCounter lines({chunk.line, chunk.column});
  if (part.kind == JsonPart::Kind::values) {
    JsonTape tape(part);
    KeyReader reader(tape, columns, chunk.path, chunk.first);
    const JsonTable value(tape, {0}, columns.row_names, chunk.path, chunk.first);
    for (bool more = true; more && !reader.is_full();) {
      try {
        more = tape.read_next();
        if (more) reader.read(value, 0, lines, false);
      } catch (const Error& error) {
        reader.add_fault(error);
        reader.skip_record();
      }
    }
    return reader.finish();
  }
  try {
    const JsonTape tape(part);
    const JsonTable list(tape, tape.elements(0), columns.row_names, chunk.path, chunk.first);
    if (list.size() > 0) return parse_table(list, 0, list.size(), columns, lines);
    throw no_key_at_comma().at(tape.position_at(1));
  } catch (const Error& error) {
    KeyBuilder keys(columns.columns, columns.rules, columns.units);
    keys.add_fault(error);
    keys.set_unreadable();
    return keys.finish(chunk.path);
  }
}

}  // namespace tcb
