// Columns: which column of the samples is which cell of a row of the curve.
#include <algorithm>
#include <numeric>

#include "compare/inputs.hpp"
#include "curve/fields.hpp"
#include "error.hpp"

namespace tcb {
namespace {

using Names = std::vector<std::string>;
using Fields = std::vector<std::size_t>;

Names names_of(const Fields& chosen, const Input& keys) {
  Names names;
  for (const auto& column : output_columns(chosen, keys)) names.push_back(column.name);
  return names;
}

std::optional<std::size_t> find(const Names& names, const std::string& name) {
  const auto found = std::ranges::find(names, name);
  if (found == names.end()) return std::nullopt;
  return static_cast<std::size_t>(found - names.begin());
}

bool has(const Fields& chosen, std::size_t field) { return std::ranges::count(chosen, field) > 0; }

/// Matches columns by name.
class Matcher {
 public:
  Matcher(const SampleTable& table, const Input& keys, const Fields& given)
      : table_(table), keys_(keys), given_(given) {}

  MatchedColumns match() {
    require_distinct_names();
    find_places();
    Fields candidates = given_;
    if (given_.empty()) {
      candidates.resize(fields().size());
      std::iota(candidates.begin(), candidates.end(), std::size_t{0});
    }
    for (const std::size_t field : candidates) {
      if (field != field_of("time") && !(result_.by_length && field == field_of("s"))) match_field(field);
    }
    if (result_.compared.empty()) {
      throw Error(Exit::data, ErrorCode::nothing_to_compare, {table_.columns, names_of(candidates, keys_)});
    }
    classify_other_columns();
    return std::move(result_);
  }

 private:
  void require_distinct_names() const {
    for (const std::string& name : table_.columns) {
      if (std::ranges::count(table_.columns, name) > 1) throw Error(Exit::data, ErrorCode::repeated_column, {name});
    }
  }

  /// Times, or arc lengths where there are no times or no time is among the given fields.
  void find_places() {
    const auto s = find(keys_.channels, "s") ? std::nullopt : find(table_.columns, "s");
    const bool wants_s = has(given_, field_of("s")) && !has(given_, field_of("time"));
    result_.by_length = s && (wants_s || !table_.timed);
    if (result_.by_length) result_.place = s;
    if (table_.timed || result_.by_length) return;
    throw Error(Exit::data, ErrorCode::samples_without_places, {table_.columns, keys_.time});
  }

  bool is_compared(std::size_t column) const {
    return std::ranges::count(result_.compared, column, &MatchedColumn::given) > 0;
  }

  void match_field(std::size_t field) {
    const Names names = names_of({field}, keys_);
    const std::size_t first = names_of(result_.fields, keys_).size();
    const std::size_t before = result_.compared.size();
    Names missing;
    for (std::size_t i = 0; i < names.size(); ++i) {
      const auto given = find(table_.columns, names[i]);
      if (given && !is_compared(*given))
        result_.compared.push_back({names[i], *given, first + i});
      else
        missing.push_back(names[i]);
    }
    const bool found = result_.compared.size() > before;
    if (found) result_.fields.push_back(field);
    if (missing.empty() || (given_.empty() && !found)) return;
    result_.problems.push_back({Exit::data, ErrorCode::missing_columns, {missing}});
  }

  /// The columns of the samples that match none of the curve are ignored where the fields are given.
  void classify_other_columns() {
    Names unknown;
    for (std::size_t i = 0; i < table_.columns.size(); ++i) {
      if (i != result_.place && !is_compared(i)) unknown.push_back(table_.columns[i]);
    }
    result_.ignored = table_.ignored;
    if (!given_.empty())
      result_.ignored.insert(result_.ignored.end(), unknown.begin(), unknown.end());
    else if (!unknown.empty())
      result_.problems.push_back({Exit::data, ErrorCode::unknown_columns, {unknown}});
  }

  const SampleTable& table_;
  const Input& keys_;
  const Fields& given_;
  MatchedColumns result_;
};

/// Matches columns by their order.
MatchedColumns match_by_order(const SampleTable& table, const Input& keys, const Fields& given) {
  const Fields chosen = given.empty() ? Fields{field_of("time"), field_of("position")} : given;
  const Names names = names_of(chosen, keys);
  MatchedColumns result{chosen, {}, {}, false, {}, {}};
  const std::size_t skipped = table.timed ? 1 : 0;
  if (names.size() != table.columns.size() + skipped) {
    throw Error(Exit::data, ErrorCode::unnamed_sample_columns, {table.columns.size() + skipped, names.size(), names});
  }
  const bool has_time = has(chosen, field_of("time"));
  const std::string place = has_time ? keys.time : "s";
  for (std::size_t i = skipped; i < names.size(); ++i) {
    if (!table.timed && !result.place && names[i] == place)
      result.place = i;
    else
      result.compared.push_back({names[i], i - skipped, i});
  }
  result.by_length = !has_time;
  if (table.timed || result.place) return result;
  throw Error(Exit::usage, ErrorCode::fields_without_places).about(Option::fields);
}

}  // namespace

std::size_t field_of(std::string_view name) {
  return static_cast<std::size_t>(std::ranges::find(fields(), name, &Field::name) - fields().begin());
}

MatchedColumns match_columns(const SampleTable& table, const Input& keys, const std::vector<std::size_t>& given) {
  return table.named ? Matcher(table, keys, given).match() : match_by_order(table, keys, given);
}

}  // namespace tcb
