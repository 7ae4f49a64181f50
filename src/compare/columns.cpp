// MatchedColumns: which column of someone's samples is which number of a row of ours.
#include "compare/columns.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <numeric>

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

[[noreturn]] void refuse(const SampleTable& table, const Names& known) {
  throw Error(Exit::data, fmt::format("nothing to compare: its columns are {}; expected some of {}; rename them",
                                      fmt::join(table.columns, ", "), fmt::join(known, ", ")));
}

/// Matches columns that have names.
class Matcher {
 public:
  Matcher(const SampleTable& table, const Input& keys, const Fields& given)
      : table_(table), keys_(keys), given_(given) {}

  MatchedColumns match() {
    require_once();
    find_places();
    Fields candidates = given_;
    if (given_.empty()) {
      candidates.resize(fields().size());
      std::iota(candidates.begin(), candidates.end(), std::size_t{0});
    }
    for (const std::size_t field : candidates) {
      if (field != field_of("time") && !(result_.by_length && field == field_of("s"))) match_field(field);
    }
    if (result_.compared.empty()) refuse(table_, names_of(candidates, keys_));
    sort_out_the_rest();
    return std::move(result_);
  }

 private:
  void require_once() const {
    for (const std::string& name : table_.columns) {
      if (std::ranges::count(table_.columns, name) == 1) continue;
      throw Error(Exit::data, fmt::format("two columns are called \"{}\"; expected different names; rename one", name));
    }
  }

  /// Times, or arc lengths where there are no times or no time is among the given fields.
  void find_places() {
    const auto s = find(keys_.channels, "s") ? std::nullopt : find(table_.columns, "s");
    const bool wants_s = has(given_, field_of("s")) && !has(given_, field_of("time"));
    result_.by_length = s && (wants_s || !table_.timed);
    if (result_.by_length) result_.place = s;
    if (table_.timed || result_.by_length) return;
    throw Error(Exit::data, fmt::format("its columns are {}; expected {}, or s for arc lengths, which say where the "
                                        "samples are; add one, or rename it",
                                        fmt::join(table_.columns, ", "), keys_.time));
  }

  void match_field(std::size_t field) {
    const Names names = names_of({field}, keys_);
    const std::size_t first = names_of(result_.fields, keys_).size();
    const std::size_t before = result_.compared.size();
    Names missing;
    for (std::size_t i = 0; i < names.size(); ++i) {
      const auto theirs = find(table_.columns, names[i]);
      const bool taken = theirs && std::ranges::any_of(result_.compared, [&](const MatchedColumn& other) {
                           return other.theirs == *theirs;
                         });
      if (theirs && !taken)
        result_.compared.push_back({names[i], *theirs, first + i});
      else
        missing.push_back(names[i]);
    }
    const bool found = result_.compared.size() > before;
    if (found) result_.fields.push_back(field);
    if (missing.empty() || (given_.empty() && !found)) return;
    result_.problems.push_back(fmt::format("columns missing: {}", fmt::join(missing, ", ")));
  }

  /// MatchedColumns of theirs without one of ours.
  void sort_out_the_rest() {
    Names unknown;
    for (std::size_t i = 0; i < table_.columns.size(); ++i) {
      const bool known = i == result_.place || std::ranges::count(result_.compared, i, &MatchedColumn::theirs) > 0;
      if (!known) unknown.push_back(table_.columns[i]);
    }
    result_.ignored = table_.left_out;
    if (!given_.empty()) {
      result_.ignored.insert(result_.ignored.end(), unknown.begin(), unknown.end());
    } else if (!unknown.empty()) {
      result_.problems.push_back(fmt::format(
          "columns of no field: {}; --fields says which fields alone are to be compared", fmt::join(unknown, ", ")));
    }
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
    throw Error(Exit::data, fmt::format("{} columns without names; expected {}: {}; name them in a first row, or say "
                                        "with --fields what they are",
                                        table.columns.size() + skipped, names.size(), fmt::join(names, ", ")));
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
  throw Error(Exit::usage,
              "--fields names neither time nor s, which say where the samples are; expected one of them; "
              "add it where its column is");
}

}  // namespace

std::size_t field_of(std::string_view name) {
  return static_cast<std::size_t>(std::ranges::find(fields(), name, &Field::name) - fields().begin());
}

MatchedColumns match_columns(const SampleTable& table, const Input& keys, const std::vector<std::size_t>& given) {
  return table.named ? Matcher(table, keys, given).match() : match_by_order(table, keys, given);
}

}  // namespace tcb
