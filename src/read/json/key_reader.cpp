// Reader of JSON keys: from the members of key objects to keys.
#include "read/json/key_reader.hpp"

#include <algorithm>
#include <utility>

#include "numbers/parse_number.hpp"
#include "numbers/print_number.hpp"
#include "read/errors.hpp"
#include "read/json/errors.hpp"
#include "read/json/object_reader.hpp"
#include "read/key_builder.hpp"
#include "text/utf8.hpp"

namespace tcb {
namespace {

using Column = Columns::Column;
using Member = JsonColumns::Member;

bool is_text(const Column& column) { return column.role == Role::group || column.role == Role::carry; }

/// Passes the members of keys to the key builder, as cells.
class KeyReader : public JsonObjectReader {
 public:
  KeyReader(const JsonPart& part, const JsonColumns& columns)
      : JsonObjectReader(part),
        columns_(columns),
        signs_(columns.rules.signs),
        keys_(columns.columns, columns.rules, columns.units),
        path_(part.chunk.path),
        seen_(columns.members.size()) {}

  KeyBlock read() {
    try {
      parse();
    } catch (const Error& error) {
      add_fault(error);
      keys_.set_unreadable();
    }
    return keys_.finish(path_);
  }

 private:
  bool on_key_start() override {
    keys_.begin_key();
    position_ = key_position();
    number_ = key_number();
    tcb_given_ = 0;
    std::ranges::fill(seen_, 0);
    expected_ = 0;
    is_provenance_ = false;
    return true;
  }

  bool on_member(const std::string& name) override {
    const auto& members = columns_.members;
    is_provenance_ = is_provenance_ || name == "meta";
    if (expected_ == members.size() || members[expected_].name != name) {
      expected_ = static_cast<std::size_t>(std::ranges::find(members, name, &Member::name) - members.begin());
    }
    current_ = expected_ < members.size() ? &members[expected_] : nullptr;
    if (current_ == nullptr) {
      unknown_ = name;
      return true;
    }
    if (seen_[expected_] != 0) return add_value_fault(json::member_repeats());
    seen_[expected_++] = 1;
    return true;
  }

  std::string_view member() const override { return current_ == nullptr ? unknown_ : current_->name; }

  bool on_number(const spline::Time<double>& value) override {
    if (current_ == nullptr) {  // an array is one fault
      return (in_array() && element() > 0) || is_provenance_ || add_value_fault(json::member_unknown());
    }
    if (current_->cells == 0) return true;
    if (current_->array != in_array()) return add_shape_fault();
    if (!signs_.empty() && is_given_sign(value)) return on_missing(decimal_text(value));
    const std::size_t index = in_array() ? element() : 0;
    if (index < current_->cells) store(columns_.columns.cells[current_->cell + index], value);
    return true;
  }

  bool on_text(std::string_view text) override {
    if (current_ != nullptr && current_->cells > 0) mark(text);
    const Column* const column = current_column();
    if (column == nullptr) return true;
    if (is_text(*column)) {
      keys_.set_text(*column, (is_quoted() ? "\"" : "") + std::string(text));
      return true;
    }
    if (column->role == Role::time && is_quoted()) {
      if (keys_.set_time_in_words(*column, text)) return true;
      if (find_notation(text) || (!keys_.has_times_as_numbers() && !is_missing_sign(text, signs_))) {
        return add_value_fault(columns_.units.notation == find_notation(text) ? json::no_such_time(text)
                                                                              : json::time_in_other_notation(text));
      }
    }
    if (is_quoted() && is_missing_sign(text, signs_)) return on_missing(text);
    return add_value_fault(json::not_a_number(text));
  }

  bool on_null() override {
    const Column* const column = current_column();
    if (column == nullptr || column->role == Role::carry) return true;
    if (current_->array && !in_array()) return add_shape_fault();
    if (keys_.miss(*column)) return true;
    return add_value_fault(is_text(*column) ? json::text_missing()
                                            : json::number_missing("null", column->role == Role::time));
  }

  /// A sign of a missing number.
  bool on_missing(std::string_view sign) {
    const Column* const column = current_column();
    if (column == nullptr || keys_.miss(*column)) return true;
    return add_value_fault(json::number_missing(in_quotes(sign), column->role == Role::time));
  }

  std::string decimal_text(const spline::Time<double>& value) const {
    return decimal().empty() ? time_text(value) : std::string(decimal());
  }

  /// A number such as -999 may be a sign of a missing one.
  bool is_given_sign(const spline::Time<double>& value) const {
    const Column* const column = current_column();
    return column != nullptr && !is_text(*column) && std::ranges::count(signs_, decimal_text(value)) > 0;
  }

  bool on_nested() override { return current_column() == nullptr || add_shape_fault(); }

  bool on_array_end() override {
    if (current_ == nullptr || current_->cells == 0) return true;
    if (!current_->array) return element() > 0 || add_shape_fault();
    if (element() == current_->cells) return true;
    return add_value_fault(json::array_size(element(), current_->cells));
  }

  bool on_key_end() override {
    if (is_provenance_ && std::ranges::count(seen_, 1) == 0) return true;
    for (std::size_t i = 0; i < seen_.size(); ++i) {
      if (seen_[i] == 0 && columns_.members[i].required) miss_member(columns_.members[i]);
    }
    if (!keys_.complete_time()) add_fault(at_key(time_parts_not_whole(columns_.columns.time)));
    if (!keys_.end_key()) return !keys_.is_full();
    keys_.set_number(number_);
    keys_.set_position(position_.line, position_.column);
    return true;
  }

  bool on_break() override {
    keys_.break_curve();
    return true;
  }

  bool on_bad_line(const Error& error) override {
    add_fault(error);
    return !keys_.is_full();
  }

  /// The column of the current cell; nothing if it is ignored.
  const Column* current_column() const {
    if (current_ == nullptr || current_->cells == 0) return nullptr;
    const std::size_t index = in_array() ? element() : 0;
    if (index >= current_->cells) return nullptr;
    const Column& column = columns_.columns.cells[current_->cell + index];
    return column.role == Role::ignored ? nullptr : &column;
  }

  void mark(std::string_view text) {
    const Column& column = columns_.columns.cells[current_->cell];
    if (column.role == Role::ignored) keys_.set_mark(column, text);
  }

  void store(const Column& column, const spline::Time<double>& value) {
    if (column.role == Role::time && !keys_.has_times_as_numbers()) {
      add_value_fault(json::time_in_other_notation(decimal_text(value)));
      return;
    }
    switch (column.role) {
      case Role::ignored: keys_.set_mark(column, decimal_text(value)); return;
      case Role::group:
      case Role::carry: keys_.set_text(column, time_text(value)); return;
      case Role::time: keys_.set_time(decimal().empty() ? value : parse_time(decimal()).value_or(value)); break;
      case Role::tension: store_once(0, column, value.hi); break;
      case Role::continuity: store_once(1, column, value.hi); break;
      case Role::bias: store_once(2, column, value.hi); break;
      default: keys_.number(column) = value.hi;
    }
    if (keys_.keeps_decimals()) keys_.keep_decimal(column, decimal_text(value));
    if (keys_.scales() && !keys_.scale(column, decimal_text(value))) {
      add_value_fault(json::number_too_large(decimal_text(value)));
    }
  }

  /// Tension, continuity or bias: a member, or a number of "tcb", but not both.
  void store_once(unsigned number, const Column& column, double value) {
    if (((tcb_given_ >> number) & 1U) != 0) add_value_fault(json::also_in_tcb());
    tcb_given_ |= 1U << number;
    keys_.number(column) = value;
  }

  void miss_member(const Member& member) {
    const auto begin = columns_.columns.cells.begin() + static_cast<std::ptrdiff_t>(member.cell);
    const auto end = begin + static_cast<std::ptrdiff_t>(member.cells);
    const auto may_miss = [&](const Column& column) { return keys_.miss(column); };
    if (std::all_of(begin, end, may_miss)) return;
    add_fault(at_key(json::member_missing(member.name, begin->role == Role::time)));
  }

  void add_fault(Error error) { keys_.add_fault(std::move(error)); }

  /// Adds a fault of the current value; true.
  bool add_value_fault(const Error& fault) {
    if (!keys_.is_full()) add_fault(at_value(fault));
    return true;
  }

  bool add_shape_fault() {
    const bool text = is_text(columns_.columns.cells[current_->cell]);
    return add_value_fault(current_->array ? json::array_expected()
                           : text          ? json::text_expected()
                                           : json::number_expected());
  }

  const JsonColumns& columns_;
  const std::vector<std::string>& signs_;
  KeyBuilder keys_;
  std::string path_;
  std::vector<unsigned char> seen_;  ///< 1 for the members of the current key; bits would take longer
  bool is_provenance_ = false;       ///< the object has "meta", and is no key if it has no member of a key
  LinePosition position_;            ///< of the current key
  std::uint64_t number_ = 0;         ///< of the current key
  unsigned tcb_given_ = 0;           ///< a bit for each of the three
  std::size_t expected_ = 0;         ///< the next member, if all keys have the same order
  const Member* current_ = nullptr;
  std::string unknown_;  ///< the name of the current member, if the first key has no such member
};

}  // namespace

KeyBlock parse_json(const JsonPart& part, const JsonColumns& columns) { return KeyReader(part, columns).read(); }

}  // namespace tcb
