// Matched columns: which columns of a file of samples are compared with which cells of the curve's rows.
#include "check/matched_columns.hpp"

#include <algorithm>
#include <numeric>
#include <string_view>
#include <unordered_map>

#include "check/errors.hpp"
#include "check/problems.hpp"
#include "error.hpp"
#include "option_names.hpp"

namespace tcb {
namespace {

using Names = std::vector<std::string>;
using Fields = std::vector<std::size_t>;

Names names_of(const Fields& chosen, const Schema& keys) {
  Names names;
  for (const auto& column : output_columns(chosen, keys)) names.push_back(column.name);
  return names;
}

/// The index of each name.
using NameIndex = std::unordered_map<std::string_view, std::size_t>;

std::optional<std::size_t> index_of(const NameIndex& index, std::string_view name) {
  const auto found = index.find(name);
  return found == index.end() ? std::nullopt : std::optional(found->second);
}

std::optional<std::size_t> index_of(const Names& names, const std::string& name) {
  const auto found = std::ranges::find(names, name);
  if (found == names.end()) return std::nullopt;
  return static_cast<std::size_t>(found - names.begin());
}

/// Matches columns by name.
class Matcher {
 public:
  Matcher(const SampleTable& table, const Schema& keys, const Fields& given)
      : table_(table), keys_(keys), given_(given), is_compared_(table.columns.size()) {}

  /// Throws: Error (data) for names that repeat, and without places or columns to compare.
  MatchedColumns match() {
    index_columns();
    find_places();
    Fields candidates = given_;
    if (given_.empty()) {
      candidates.resize(sample_fields<double>.size());
      std::iota(candidates.begin(), candidates.end(), std::size_t{0});
    }
    for (const std::size_t field : candidates) {
      if (field != field_of("time") && !(result_.by_length && field == field_of("s"))) match_field(field);
    }
    if (result_.compared.empty()) {
      throw nothing_to_compare(table_.columns, names_of(candidates, keys_));
    }
    classify_other_columns();
    return std::move(result_);
  }

 private:
  void index_columns() {
    std::optional<std::size_t> repeated;  // the first column whose name another one has
    for (std::size_t i = 0; i < table_.columns.size(); ++i) {
      const auto [first, is_new] = columns_.try_emplace(table_.columns[i], i);
      if (!is_new) repeated = std::min(repeated.value_or(first->second), first->second);
    }
    if (repeated) throw samples_have_same_column(table_.columns[*repeated]);
  }

  /// Times, or arc lengths if there are no times or no time is among the given fields.
  void find_places() {
    const auto s = index_of(keys_.channels, "s") ? std::nullopt : index_of(columns_, "s");
    const auto is_given = [this](std::size_t field) { return std::ranges::count(given_, field) > 0; };
    const bool wants_s = is_given(field_of("s")) && !is_given(field_of("time"));
    result_.by_length = s && (wants_s || !table_.timed);
    if (result_.by_length) result_.place = s;
    if (table_.timed || result_.by_length) return;
    throw samples_without_places(table_.columns, keys_.time.name);
  }

  void match_field(std::size_t field) {
    const Names names = names_of({field}, keys_);
    const std::size_t first = cells_;
    const std::size_t before = result_.compared.size();
    Names missing;
    for (std::size_t i = 0; i < names.size(); ++i) {
      const auto given = index_of(columns_, names[i]);
      if (!given || is_compared_[*given]) {
        missing.push_back(names[i]);
        continue;
      }
      is_compared_[*given] = true;
      result_.compared.push_back({names[i], *given, first + i});
    }
    const bool found = result_.compared.size() > before;
    if (found) {
      result_.fields.push_back(field);
      cells_ += names.size();
    }
    if (missing.empty() || (given_.empty() && !found)) return;
    result_.problems.push_back(columns_missing(missing));
  }

  /// The columns of the samples that match none of the curve are ignored if fields are given.
  void classify_other_columns() {
    Names unknown;
    for (std::size_t i = 0; i < table_.columns.size(); ++i) {
      if (i != result_.place && !is_compared_[i]) unknown.push_back(table_.columns[i]);
    }
    result_.ignored = table_.ignored;
    if (!given_.empty())
      result_.ignored.insert(result_.ignored.end(), unknown.begin(), unknown.end());
    else if (!unknown.empty())
      result_.problems.push_back(columns_of_no_field(unknown));
  }

  const SampleTable& table_;
  const Schema& keys_;
  const Fields& given_;
  NameIndex columns_;  ///< of the table
  std::vector<bool> is_compared_;
  std::size_t cells_ = 0;  ///< of the fields in the result
  MatchedColumns result_;
};

/// Matches columns by their order.
MatchedColumns match_by_order(const SampleTable& table, const Schema& keys, const Fields& given) {
  const Fields chosen = given.empty() ? Fields{field_of("time"), field_of("position")} : given;
  const Names names = names_of(chosen, keys);
  MatchedColumns result;
  result.fields = chosen;
  const std::size_t columns = table.columns.size() + (table.timed ? 1 : 0);
  if (names.size() != columns) throw unnamed_sample_columns(columns, names);
  const auto time = columns_before_time(chosen, keys);
  const auto length = time ? std::nullopt : index_of(names, "s");
  if (!time && !length) throw fields_without_places().about(option::fields);
  result.place = length;
  result.by_length = length.has_value();
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i != (time ? time : length)) result.compared.push_back({names[i], i - (time && i > *time ? 1 : 0), i});
  }
  return result;
}

}  // namespace

void MatchedColumns::align(std::span<Cell> computed, std::span<const double> given_row) const {
  for (const auto& [i, degrees] : angles) {
    double& angle = computed[compared[i].computed].hi;
    const spline::DoubleDouble excess = spline::exact_difference(angle, given_row[compared[i].given]);
    angle -= spline::nearest_turns<double>(excess, degrees).hi;
  }
  for (const auto& numbers : rotations) {
    double cosine = 0;
    for (const std::size_t i : numbers) cosine += computed[compared[i].computed].hi * given_row[compared[i].given];
    if (!(cosine < 0)) continue;
    for (const std::size_t i : numbers) computed[compared[i].computed].hi *= -1;
  }
}

std::optional<std::size_t> columns_before_time(const Fields& fields, const Schema& keys) {
  const auto time = std::ranges::find(fields, field_of("time"));
  if (fields.empty()) return 0;
  if (time == fields.end()) return std::nullopt;
  return names_of({fields.begin(), time}, keys).size();
}

MatchedColumns match_columns(const SampleTable& table, const Schema& keys, const std::vector<std::size_t>& given) {
  MatchedColumns columns = table.named ? Matcher(table, keys, given).match() : match_by_order(table, keys, given);
  NameIndex compared;
  for (std::size_t i = 0; i < columns.compared.size(); ++i) compared.try_emplace(columns.compared[i].name, i);
  for (const AngleColumn& angle : keys.angles) {
    if (const auto found = index_of(compared, keys.channels[angle.channel])) {
      columns.angles.emplace_back(*found, angle.degrees);
    }
  }
  for (const RotationColumns& rotation : rotation_columns(keys)) {
    if (!rotation.shown.is_quaternion()) continue;
    std::array<std::size_t, 4> numbers{};
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      numbers[i] = index_of(compared, keys.channels[rotation.channels[i]]).value_or(columns.compared.size());
    }
    if (std::ranges::max(numbers) < columns.compared.size()) columns.rotations.push_back(numbers);
  }
  return columns;
}

}  // namespace tcb
