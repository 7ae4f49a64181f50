// Inputs of a comparison: curves with their keys in memory, samples, and which of their columns are compared.
#include "check/inputs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <string_view>
#include <unordered_map>
#include <utility>

#include "error.hpp"
#include "formats/formats.hpp"
#include "io/compression.hpp"
#include "io/input_file.hpp"
#include "keys/curves.hpp"
#include "numbers/decimal_time.hpp"
#include "read/input.hpp"
#include "read/input_options.hpp"
#include "run/curve_pipeline.hpp"
#include "stream/source.hpp"
#include "tcb/spline/angle.hpp"
#include "text/suggest.hpp"

namespace tcb {
namespace {

/// Whether the mark occurs between two digits.
bool has_between_digits(std::string_view text, char mark) {
  for (std::size_t at = text.find(mark); at != std::string_view::npos; at = text.find(mark, at + 1)) {
    if (at > 0 && at + 1 < text.size() && is_digit(text[at - 1]) && is_digit(text[at + 1])) return true;
  }
  return false;
}

/// The decimal mark of delimited text, from its first lines that are no comments.
char decimal_mark_of(std::string_view beginning, char of_keys) {
  while (beginning.starts_with('#')) beginning.remove_prefix(std::min(beginning.find('\n'), beginning.size() - 1) + 1);
  const bool delimited = beginning.find_first_of(";\t") != std::string_view::npos;
  const bool has_points = has_between_digits(beginning, '.') && of_keys == '.';  // otherwise these are in dates
  const bool commas = delimited && !has_points && has_between_digits(beginning, ',');
  return commas ? ',' : '.';
}

void append(SampleRows& rows, const KeyBlock& block) {
  rows.times.insert(rows.times.end(), block.keys.times.begin(), block.keys.times.end());
  rows.numbers.insert(rows.numbers.end(), block.keys.positions.begin(), block.keys.positions.end());
  rows.lines.insert(rows.lines.end(), block.text_positions.lines.begin(), block.text_positions.lines.end());
}

using Names = std::vector<std::string>;
using Fields = std::vector<std::size_t>;

Names names_of(const Fields& chosen, const Schema& keys) {
  Names names;
  for (const auto& column : output_columns(chosen, keys)) names.push_back(column.name);
  return names;
}

using ColumnIndex = std::unordered_map<std::string_view, std::size_t>;

std::optional<std::size_t> index_of(const ColumnIndex& index, std::string_view name) {
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
      candidates.resize(static_cast<std::size_t>(std::ranges::count(fields(), false, &Field::of_piece)));
      std::iota(candidates.begin(), candidates.end(), std::size_t{0});
    }
    for (const std::size_t field : candidates) {
      if (field != field_of("time") && !(result_.by_length && field == field_of("s"))) match_field(field);
    }
    if (result_.compared.empty()) {
      throw data_error("there is nothing to compare: the columns are {}; expected some of {}; rename the columns",
                       listed(table_.columns), listed(names_of(candidates, keys_)));
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
    if (repeated) {
      throw data_error("two columns are called \"{}\"; expected different names; rename one",
                       table_.columns[*repeated]);
    }
  }

  /// Times, or arc lengths if there are no times or no time is among the given fields.
  void find_places() {
    const auto s = index_of(keys_.channels, "s") ? std::nullopt : index_of(columns_, "s");
    const auto is_given = [this](std::size_t field) { return std::ranges::count(given_, field) > 0; };
    const bool wants_s = is_given(field_of("s")) && !is_given(field_of("time"));
    result_.by_length = s && (wants_s || !table_.timed);
    if (result_.by_length) result_.place = s;
    if (table_.timed || result_.by_length) return;
    throw data_error(
        "there is no column of times or arc lengths: the columns are {}; expected \"{}\", or \"s\" for arc lengths; "
        "add such a column, or rename one",
        listed(table_.columns), keys_.time.name);
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
    result_.problems.push_back(fmt::format("columns missing: {}", listed(missing)));
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
      result_.problems.push_back(
          fmt::format("columns of no field: {}; give the fields to compare with --fields", listed(unknown)));
  }

  const SampleTable& table_;
  const Schema& keys_;
  const Fields& given_;
  ColumnIndex columns_;  ///< of the table
  std::vector<bool> is_compared_;
  std::size_t cells_ = 0;  ///< of the fields in the result
  MatchedColumns result_;
};

/// How many columns the fields have before the time; nothing: the time is not among them.
std::optional<std::size_t> columns_before_time(const Fields& fields, const Schema& keys) {
  const auto time = std::ranges::find(fields, field_of("time"));
  if (fields.empty()) return 0;
  if (time == fields.end()) return std::nullopt;
  return names_of({fields.begin(), time}, keys).size();
}

MatchedColumns match_by_order(const SampleTable& table, const Schema& keys, const Fields& given) {
  const Fields chosen = given.empty() ? Fields{field_of("time"), field_of("position")} : given;
  const Names names = names_of(chosen, keys);
  MatchedColumns result;
  result.fields = chosen;
  const std::size_t columns = table.columns.size() + (table.timed ? 1 : 0);
  if (names.size() != columns) {
    throw data_error(
        "there are {} columns without names; expected {}: {}; name the columns in a first row, or list their fields "
        "with --fields",
        columns, names.size(), listed(names));
  }
  const auto time = columns_before_time(chosen, keys);
  const auto length = time ? std::nullopt : index_of(names, "s");
  if (!time && !length) {
    throw usage_error(
        "the fields give no times or arc lengths; expected the field time or s; add it at the position of its column")
        .about("--fields");
  }
  result.place = length;
  result.by_length = length.has_value();
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i != (time ? time : length)) result.compared.push_back({names[i], i - (time && i > *time ? 1 : 0), i});
  }
  return result;
}

}  // namespace

SampleTable read_samples(const Comparison& comparison, Source<std::string> bytes, const Schema& keys,
                         std::optional<std::size_t> time_place) {
  bytes = decompressed(std::move(bytes));
  std::string beginning = bytes().value_or("");
  InputOptions options;
  options.columns.samples =
      SampleNames{keys.time.name, keys.groups, keys.labels, time_place.value_or(0), comparison.maps};
  options.keys.missing = Missing::skip_cell;
  options.columns.timeless = !time_place;
  options.threads = comparison.threads.count();
  options.max_memory = comparison.keys.input.max_memory;
  const UnitOptions& units = comparison.keys.input.units;
  options.units = {.frame_rate = units.frame_rate, .date_order = units.date_order, .are_optional = true};
  options.delimited.marks.decimal = decimal_mark_of(beginning, comparison.keys.input.delimited.marks.decimal);
  const Input input = open_input(comparison.file, preceded_by(std::move(beginning), std::move(bytes)), options);
  const Schema& schema = input.schema;
  SampleTable table{schema.named, schema.time.is_given, schema.time.name, schema.channels, input.facts.ignored, {}};
  Curves curves(schema, input.keys, {.any_order = true});
  while (const std::optional<InputCurve> curve = curves.next()) {
    SampleRows& rows = table.curves.emplace_back(SampleRows{curve->group, {}, {}, {}});
    while (const std::optional<KeyBlock> block = curve->keys()) append(rows, *block);
  }
  return table;
}

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

MatchedColumns match_columns(const SampleTable& table, const Schema& keys, const std::vector<std::size_t>& given) {
  MatchedColumns columns = table.named ? Matcher(table, keys, given).match() : match_by_order(table, keys, given);
  ColumnIndex compared;
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

Error no_position_column(const std::vector<std::string>& channels) {
  return data_error("there is no column of positions; expected at least one of {}; rename a column, or add one",
                    listed(channels));
}

Source<KeyBlock> KeptKeys::keys() const {
  return [this, next = std::size_t{0}]() mutable {
    return next < blocks.size() ? std::optional(blocks[next++]) : std::nullopt;
  };
}

KeptInput keep_input(const Comparison& comparison, Source<std::string> bytes) {
  InputOptions options = comparison.keys.input;
  options.threads = comparison.threads.count();
  const Input input = open_input(comparison.keys_file, std::move(bytes), options);
  KeptInput kept{input.schema, input.keys.traits, {}};
  Curves curves(input.schema, input.keys, comparison.keys.curves);
  const auto frames = named_times({}, {}, input.schema.time);
  while (std::optional<InputCurve> curve = curves.next()) {
    if (comparison.time_zero) {
      if (!kept.zero) {
        const std::optional<Rational>& given = comparison.time_zero->time;
        kept.zero = {given ? *given : first_time(curve->keys, frames).value_or(0)};
        kept.zero->has_keys = true;
      }
      require_times(*kept.zero, input.schema.time);
      count_from(*curve, kept.zero->time, frames);
    }
    KeptKeys& one = kept.curves.emplace_back(KeptKeys{curve->group, curve->curve_info, {}});
    while (std::optional<KeyBlock> block = curve->keys()) one.blocks.push_back(std::move(*block));
    if (curve->part)
      one.part = {curve->part->number, curve->part->origin, [next = curve->part->next()] { return next; },
                  curve->part->max_gap};
  }
  return kept;
}

ComparisonInputs read_inputs(const Comparison& comparison, const std::vector<std::size_t>& chosen,
                             FileProgress* progress) {
  ComparisonInputs inputs;
  inputs.progress = progress;
  inputs.keys = shown_name(comparison.keys_file);
  inputs.file = shown_name(comparison.file);
  inputs.threads = comparison.threads.count();
  const auto bytes_of = [progress](const std::string& path) {
    return progress == nullptr ? read_file(path) : progress->observe_bytes(read_file(path));
  };
  inputs.kept = in_file(inputs.keys, [&] { return keep_input(comparison, bytes_of(comparison.keys_file)); });
  in_file(inputs.file, [&] {
    const auto before_time = columns_before_time(chosen, inputs.kept.schema);
    inputs.table = read_samples(comparison, bytes_of(comparison.file), inputs.kept.schema, before_time);
    inputs.columns = match_columns(inputs.table, inputs.kept.schema, chosen);
  });
  return inputs;
}

}  // namespace tcb
