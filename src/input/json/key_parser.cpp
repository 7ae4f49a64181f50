// Key objects of JSON: from events to keys.
#include "input/json/key_parser.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "error.hpp"
#include "input/json/events.hpp"
#include "text/number.hpp"
#include "text/refusal.hpp"

namespace tcb {
namespace {

using Member = JsonColumns::Member;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Turns events into keys.
class KeyBuilder : public JsonEvents {
 public:
  KeyBuilder(const Chunk& chunk, const JsonColumns& columns)
      : JsonEvents(chunk), columns_(columns), seen_(columns.members.size()), texts_(columns.columns.texts()) {
    block_.keys.channels = columns.columns.channels.size();
    block_.path = chunk.path;
    if (columns.keeps_decimals) written_.resize(NumberOfKey::position + block_.keys.channels);
    timed_ = columns.columns.has(Role::time);
    eased_ = columns.columns.has(Role::ease_in) || columns.columns.has(Role::ease_out);
  }

  KeyBlock build() {
    try {
      parse();
    } catch (const Error& error) {
      block_.faults.push_back(error);
      block_.unreadable = true;
    }
    block_.keys.positions.resize(block_.lines.size() * block_.keys.channels);
    block_.break_after = breaks_;
    return std::move(block_);
  }

 private:
  bool on_key_start() override {
    block_.keys.positions.resize(block_.lines.size() * block_.keys.channels);
    block_.keys.positions.resize((block_.lines.size() + 1) * block_.keys.channels, nan);
    place_ = place_of_key();
    number_ = key_number();
    tcb_ = columns_.tcb;
    tcb_given_ = 0;
    ease_ = {};
    time_ = Time(nan);
    std::ranges::fill(texts_, std::string());
    std::ranges::fill(written_, std::string());
    std::fill(seen_.begin(), seen_.end(), false);
    expected_ = 0;
    missing_ = is_meta_ = false;
    faults_ = block_.faults.size();
    return true;
  }

  bool on_member(const std::string& name) override {
    const auto& members = columns_.members;
    is_meta_ = is_meta_ || name == "meta";
    if (expected_ == members.size() || members[expected_].name != name) {
      expected_ = static_cast<std::size_t>(std::ranges::find(members, name, &Member::name) - members.begin());
    }
    current_ = expected_ < members.size() ? &members[expected_] : nullptr;
    if (current_ == nullptr) return true;
    if (seen_[expected_]) return refuse("a second time in one key; expected once; take one out");
    seen_[expected_++] = true;
    return true;
  }

  bool on_number(const spline::Time<double>& value) override {
    if (current_ == nullptr) {
      return in_array() || refuse("not in the first key; expected the same members in every key; add it there");
    }
    if (current_->cells == 0) return true;
    if (current_->array != in_array()) return refuse_shape();
    const std::size_t index = in_array() ? element() : 0;
    if (index < current_->cells) store(columns_.columns.cells[current_->cell + index], value);
    return true;
  }

  bool on_other(std::string_view text) override {
    if (current_ == nullptr || current_->cells == 0) return true;
    const std::size_t index = in_array() ? element() : 0;
    if (index >= current_->cells) return true;
    const Columns::Column column = columns_.columns.cells[current_->cell + index];
    if (column.role == Role::left_out) return true;
    const bool is_null = text == "null" && !is_quoted();
    if (!is_quoted() && text.starts_with("an ")) return refuse_shape();
    if (is_text(column) && !is_null) return store_text(column, text);
    if (column.role == Role::carry) return true;
    if (!is_null) {
      return refuse(fmt::format("{} is not a number; expected one without quotes; correct it", shown(text)));
    }
    if (current_->array && !in_array()) return refuse_shape();
    if (may_miss(column)) return true;
    return refuse(fmt::format("null where a {} was expected; fill it in, or give --missing skip-row, {}break",
                              is_text(column) ? "text" : "number", is_text(column) ? "" : "skip-cell or "));
  }

  bool on_array_end() override {
    if (current_ == nullptr || current_->cells == 0) return true;
    if (!current_->array) return element() > 0 || refuse_shape();
    if (element() == current_->cells) return true;
    return refuse(fmt::format("an array of {}; expected {} numbers, as in the first key; correct it", element(),
                              current_->cells));
  }

  bool on_key_end() override {
    if (is_meta_ && std::ranges::count(seen_, true) == 0) return true;
    for (std::size_t i = 0; i < seen_.size(); ++i) {
      if (columns_.members[i].required && !seen_[i]) miss_member(columns_.members[i]);
    }
    const bool breaks_off = missing_ && columns_.missing == Missing::break_curve;
    if (block_.faults.size() > faults_ || (missing_ && !breaks_off)) {
      if (block_.faults.size() == faults_) ++block_.skipped;
      return block_.faults.size() < most_faults;
    }
    if (breaks_off) block_.gaps.push_back(block_.lines.size());
    if (timed_) block_.keys.times.push_back(time_);
    if (eased_) block_.keys.eases.push_back(ease_);
    block_.keys.tcbs.push_back(tcb_);
    for (const std::string& text : texts_) block_.texts.add(text);
    for (const std::string& decimal : written_) block_.decimals.add(decimal);
    if (std::exchange(breaks_, false)) block_.breaks.push_back(block_.lines.size());
    block_.numbers.push_back(number_);
    block_.lines.push_back(place_.line);
    block_.columns.push_back(static_cast<std::uint32_t>(place_.column));
    return true;
  }

  bool on_break() override { return breaks_ = true; }

  bool on_bad_line(const Error& error) override {
    block_.faults.push_back(error);
    return block_.faults.size() < most_faults;
  }

  void store(Columns::Column column, const spline::Time<double>& value) {
    if (const auto place = number_of_key(column); place && !written_.empty()) {
      written_[*place] = decimal().empty() ? time_text(value) : std::string(decimal());
    }
    double* const position = block_.keys.positions.data() + block_.lines.size() * block_.keys.channels;
    switch (column.role) {
      case Role::left_out: break;
      case Role::time: time_ = value; break;
      case Role::position: position[column.channel] = value.hi; break;
      case Role::tension: store_once(0, tcb_.tension, value.hi); break;
      case Role::continuity: store_once(1, tcb_.continuity, value.hi); break;
      case Role::bias: store_once(2, tcb_.bias, value.hi); break;
      case Role::ease_in: ease_.in = value.hi; break;
      case Role::ease_out: ease_.out = value.hi; break;
      case Role::group:
      case Role::carry: texts_[column.channel] = time_text(value); break;
    }
  }

  /// Tension, continuity or bias, which may stand in two ways but not in both.
  void store_once(unsigned number, double& target, double value) {
    if (((tcb_given_ >> number) & 1U) != 0) refuse("besides \"tcb\"; expected one of them; take one out");
    tcb_given_ |= 1U << number;
    target = value;
  }

  bool store_text(Columns::Column column, std::string_view text) {
    texts_[column.channel] = (is_quoted() ? "\"" : "") + std::string(text);
    return true;
  }

  static bool is_text(Columns::Column column) { return column.role == Role::group || column.role == Role::carry; }
  /// Whether --missing says what becomes of a number that is not there; a time or a group cannot be skipped alone.
  bool may_miss(Columns::Column column) {
    const bool skips_cell = columns_.missing == Missing::skip_cell;
    if (columns_.missing == Missing::error || (skips_cell && column.role == Role::time)) return false;
    if (column.role == Role::group && columns_.missing != Missing::skip_row) return false;
    missing_ = missing_ || !skips_cell;
    return true;
  }

  void miss_member(const Member& member) {
    const auto begin = columns_.columns.cells.begin() + static_cast<std::ptrdiff_t>(member.cell);
    const auto end = begin + static_cast<std::ptrdiff_t>(member.cells);
    if (std::all_of(begin, end, [&](const auto& column) { return column.role == Role::left_out || may_miss(column); }))
      return;
    add_fault(
        key_error(fmt::format("a key without \"{}\"; expected the members of the first key; add it, or give "
                              "--missing skip-row, skip-cell or break",
                              member.name)));
  }

  void add_fault(Error error) {
    if (block_.faults.size() < most_faults) block_.faults.push_back(std::move(error));
  }

  /// Says what is wrong with the value at hand; true.
  bool refuse(std::string_view what) {
    add_fault(error(fmt::format("{}: {}", path(), what)));
    return true;
  }

  bool refuse_shape() {
    return refuse(fmt::format("expected {}, as in the first key; correct it",
                              current_->array                                   ? "an array of numbers"
                              : is_text(columns_.columns.cells[current_->cell]) ? "a text or a number"
                                                                                : "a number"));
  }

  const JsonColumns& columns_;
  std::vector<bool> seen_;
  std::vector<std::string> texts_;    ///< of the key at hand
  std::vector<std::string> written_;  ///< its numbers, where they are kept
  bool timed_ = false, eased_ = false;
  bool breaks_ = false;       ///< the curve breaks off before the next key
  bool missing_ = false;      ///< the key at hand is not to be one
  bool is_meta_ = false;      ///< the object at hand is provenance, unless it has a member of a key
  LinePosition place_;        ///< of the key at hand
  std::uint64_t number_ = 0;  ///< of the key at hand
  Time time_;
  spline::Tcb<double> tcb_;
  unsigned tcb_given_ = 0;  ///< a bit for each of the three
  spline::Ease<double> ease_;
  std::size_t faults_ = 0;    ///< how many there were before the key at hand
  std::size_t expected_ = 0;  ///< the member that comes next if all keys look alike
  const Member* current_ = nullptr;
  KeyBlock block_;
};

}  // namespace

KeyBlock parse_json(const Chunk& chunk, const JsonColumns& columns) { return KeyBuilder(chunk, columns).build(); }

}  // namespace tcb
