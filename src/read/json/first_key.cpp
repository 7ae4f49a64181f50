// First key of JSON: its members, and those of the next keys if it has texts.
#include "read/json/first_key.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <unordered_set>
#include <utility>

#include "numbers/parse_number.hpp"
#include "numbers/print_number.hpp"
#include "read/json/errors.hpp"
#include "read/json/object_reader.hpp"
#include "schema/missing.hpp"

namespace tcb {
namespace {

/// Collects the members of the first key, then stops.
class FirstKeyReader : public JsonObjectReader {
 public:
  /// `texts` are the members that are requested as texts, `signs` those of missing numbers.
  FirstKeyReader(const JsonPart& part, std::vector<std::string> texts, std::vector<std::string> signs)
      : JsonObjectReader(part), texts_(std::move(texts)), signs_(std::move(signs)) {}
  std::vector<FoundMember> members;

  /// Where the key begins.
  const TextPosition& position() const { return position_; }

 private:
  bool on_member(const std::string& name) override {
    const LinePosition position = member_position();
    members.push_back({.name = name, .position = {"", position.line, position.column}});
    members.back().path = path();
    if (!names_.insert(name).second) throw at_value(json::member_repeats());
    return true;
  }
  std::string_view member() const override { return members.back().name; }
  bool on_number(const spline::Time<double>& number) override {
    if (!in_array()) members.back().value = time_text(number);
    return count();
  }
  bool on_null() override { return count(); }  // refused later, as a number that is missing
  void on_deep_value(bool is_number) override {
    members.back().empty = false;
    members.back().deep_numbers = members.back().deep_numbers || is_number;
  }
  bool on_nested() override {
    if (!in_array() && !is_requested_text() && role_of_name(members.back().name) != Role::position) {
      throw at_value(json::single_number_expected());
    }
    members.back().nested = true;
    return note(false);
  }
  void on_members() override { members.pop_back(); }
  bool on_text(std::string_view text) override {
    FoundMember& member = members.back();
    member.empty = false;
    const bool has_role = role_of_name(member.name) != Role::position;
    const bool is_sign = is_quoted() && is_missing_sign(text, signs_);
    if (!in_array() && is_quoted() && find_notation(text)) {
      member.value = text;
      if (role_of_name(member.name) == Role::time) return count();
    }
    if (has_role && is_sign && !in_array() && !is_requested_text()) return count();  // refused later, unless allowed
    const bool needs_number = has_role || (!is_sign && looks_numeric(text));
    if (!in_array() && !is_requested_text() && needs_number) throw at_value(json::not_a_number(text));
    return note(true);
  }
  bool on_key_start() override {
    const LinePosition key = key_position();
    position_ = {"", key.line, key.column};
    return true;
  }
  bool on_key_end() override { return false; }
  bool on_break() override { return true; }

  bool is_requested_text() const { return std::ranges::find(texts_, members.back().name) != texts_.end(); }

  /// A value that is not a number.
  bool note(bool text) {
    FoundMember& member = members.back();
    if (in_array() && (member.name == "position" || holds_tcb(member.name))) return count();  // refused later too
    member.text = text && !in_array();
    return true;
  }

  bool count() {
    members.back().array = in_array();
    members.back().empty = false;
    ++members.back().numbers;
    return true;
  }

  std::vector<std::string> texts_, signs_;
  std::unordered_set<std::string> names_;
  TextPosition position_;
};

/// Finds members that are texts in the first key, but numbers in one of the first keys.
class LaterKeys : public JsonObjectReader {
 public:
  LaterKeys(const JsonPart& part, const std::vector<std::string>& signs) : JsonObjectReader(part), signs_(signs) {}

  /// Whether it has a number in some key, or only signs of missing numbers.
  bool holds_numbers(const std::string& member) const {
    return numbers_.contains(member) || (missing_.contains(member) && !texts_.contains(member));
  }

 private:
  static constexpr std::uint64_t most_keys = 1000;

  bool on_member(const std::string& name) override {
    member_ = name;
    return true;
  }
  std::string_view member() const override { return member_; }
  bool on_number(const spline::Time<double>&) override { return take(numbers_); }
  bool on_text(std::string_view text) override {
    const bool is_sign = is_quoted() && is_missing_sign(text, signs_);
    return text.empty() || take(is_sign ? missing_ : texts_);
  }
  bool on_null() override { return true; }
  bool on_nested() override { return true; }
  bool on_break() override { return true; }
  bool on_key_end() override { return key_number() < most_keys; }

  bool take(std::unordered_set<std::string>& members) {
    if (!in_array()) members.insert(member_);
    return true;
  }

  const std::vector<std::string>& signs_;
  std::string member_;
  std::unordered_set<std::string> numbers_, missing_, texts_;
};

/// Members that are texts in the first key may hold numbers.
void find_missing_numbers(std::vector<FoundMember>& members, const JsonPart& part,
                          const std::vector<std::string>& signs) {
  if (std::ranges::none_of(members, &FoundMember::text)) return;
  LaterKeys keys(part, signs);
  try {
    keys.parse();
  } catch (const Error&) {  // thrown again when the keys are read
  }
  for (FoundMember& member : members) {
    if (!member.text || !keys.holds_numbers(member.name)) continue;
    member.text = false;
    member.numbers = 1;
  }
}

constexpr std::array quaternion_members{std::pair{"rotation.x", "qx"}, std::pair{"rotation.y", "qy"},
                                        std::pair{"rotation.z", "qz"}, std::pair{"rotation.w", "qw"}};

}  // namespace

bool has_quaternion(const std::vector<FoundMember>& members) {
  const auto is_array = [](const FoundMember& member) {
    return member.name == "rotation" && member.array && !member.nested && member.numbers == quaternion_members.size();
  };
  const auto is_number = [&](const auto& number) {
    return std::ranges::any_of(members, [&](const FoundMember& member) {
      return member.name == number.first && !member.array && !member.nested && member.numbers == 1;
    });
  };
  return std::ranges::any_of(members, is_array) ||
         (std::ranges::all_of(quaternion_members, is_number) &&
          std::ranges::count_if(members, is_of_rotation) == std::ssize(quaternion_members));
}

void require_quaternion(const std::vector<FoundMember>& members) {
  const auto first = std::ranges::find_if(members, is_of_rotation);
  if (first == members.end() || has_quaternion(members)) return;
  const bool is_array = first->array && !first->nested;
  if (is_array && first->numbers < 3) return;  // too few for a rotation in any form
  const Error fault = is_array ? json::rotation_size(first->numbers) : json::rotation_members();
  throw fault.about(first->path).at(first->position);
}

std::vector<std::string> quaternion_columns(const FoundMember& member) {
  std::vector<std::string> names;
  for (const auto& [name, column] : quaternion_members) {
    if (member.array || member.name == name) names.emplace_back(column);
  }
  return names;
}

FirstKey read_first_key(const JsonPart& part, const std::vector<RoleRequest>& requests,
                        const std::vector<std::string>& signs) {
  std::vector<std::string> texts;
  for (const RoleRequest& role : requests) {
    if (role.role == Role::group || role.role == Role::carry) {
      texts.insert(texts.end(), role.columns.begin(), role.columns.end());
    }
  }
  FirstKeyReader first(part, std::move(texts), signs);
  first.parse();
  find_missing_numbers(first.members, part, signs);
  return {std::move(first.members), first.position()};
}

}  // namespace tcb
