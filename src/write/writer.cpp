// Writer: one output with its frames and rows.
#include "write/writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

#include "error.hpp"
#include "numbers/decimal_time.hpp"
#include "sample/fields.hpp"
#include "schema/pose_formats.hpp"
#include "schema/units.hpp"
#include "text/suggest.hpp"
#include "text/utf8.hpp"
#include "write/labels.hpp"
#include "write/output_format.hpp"

namespace tcb {

namespace {

/// Throws: Error (data) where the name is another column's, or the file's is not UTF-8.
void add_file_column(OutputColumns& columns, const std::string& name, const std::string& file) {
  if (std::ranges::count(columns.names(), name) > 0)
    throw data_error(
        "there already is a column {}; expected another name for the column of files; give --file-column=NAME",
        in_quotes(name));
  const std::size_t invalid = find_invalid_utf8(file);
  if (invalid != std::string::npos)
    throw data_error(
        "the name of the file has the byte {:02X}, which is not UTF-8; expected UTF-8 for --file-column; rename the "
        "file",
        static_cast<unsigned char>(file[invalid]));
  columns.groups.insert(columns.groups.begin(), name);
}

}  // namespace

std::vector<std::string> OutputColumns::names() const {
  std::vector<std::string> all = groups;
  std::ranges::transform(numbers, std::back_inserter(all), &OutputColumn::name);
  all.insert(all.end(), labels.begin(), labels.end());
  return all;
}

void Writer::begin(const Schema& schema, bool live, Facts rules, const std::string& file) {
  OutputColumns columns{schema.groups, output_columns(options_.fields, schema), schema.labels};
  if (options_.file_column) {
    add_file_column(columns, *options_.file_column, file);
    file_ = '"' + file;
  }
  const Format& format = *options_.format;
  const OutputFormat& output = *format.output;
  if (output.keeper != nullptr && keeper_ == nullptr) keeper_ = output.keeper(schema, options_.fields);
  if (keeper_ != nullptr) keeper_->begin(schema);
  if (output.gathers_rows) columns.groups.clear();
  const bool is_pose = format.poses != nullptr;
  cells_ = columns.numbers.size();
  printed_.clear();
  for (std::size_t i = 0; i < cells_; ++i) printed_.push_back({columns.numbers[i].kind, i});
  if (is_pose) {
    const std::vector<std::size_t> order = pose_cells(format, schema);
    std::vector<OutputColumn> numbers;
    printed_.clear();
    for (const std::size_t cell : order) {
      numbers.push_back(columns.numbers[cell]);
      printed_.push_back({numbers.back().kind, cell});
    }
    columns.numbers = std::move(numbers);
  }
  if (columns_.numbers.empty()) {
    columns_ = std::move(columns);
    marks_ = {options_.delimiter.value_or(format.delimiter), options_.decimal};
    times_ = ShownTimes(options_, schema.time, keeper_ != nullptr);
    const std::string head = set_layouts(!is_pose && options_.header.value_or(schema.named));
    recorder_.set_rules(std::move(rules));
    const std::string provenance = recorder_.before_rows(format);
    output_.write(provenance + head);
  } else if (columns.names() != columns_.names()) {
    throw data_error(
        "the columns are {}; expected {}, as in the earlier files; give --output-dir to write an output for each file",
        listed(columns.names()), listed(columns_.names()));
  }
  output_.set_live(live);
}

std::string Writer::set_layouts(bool header) {
  const Format& format = *options_.format;
  for (const bool is_group : {true, false}) {
    const std::vector<std::string>& texts = is_group ? columns_.groups : columns_.labels;
    if (texts.empty() || (is_group ? format.output->has_groups : format.output->has_labels)) continue;
    throw data_error(
        "column {} holds text, but {} holds only numbers; expected a format with text; give another one, such as csv, "
        "to --output-format, or remove the column",
        in_quotes(texts.front()), format.name);
  }
  std::vector<OutputColumn> all;
  for (const std::string& name : columns_.names()) all.push_back({name});
  const auto layout = format.output->layout;
  all_ = layout(all, marks_, header);
  if (keeper_ != nullptr) keeper_->complete(all_);
  const std::size_t groups = columns_.groups.size();
  nested_ = format.nests && groups > 0;
  if (nested_) all.erase(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(groups));
  rows_ = nested_ ? layout(all, marks_, header) : all_;
  if (!nested_) rows_.before.erase(rows_.before.begin(), rows_.before.begin() + static_cast<std::ptrdiff_t>(groups));
  rows_.before.resize(columns_.numbers.size());
  if (options_.notation.kind != Notation::Kind::shortest) rows_.notation = options_.notation;
  if (format.poses != nullptr && keeper_ == nullptr) return std::string(format.poses->head);
  if (nested_) return "{\"curves\":[\n";
  return (format.nests && options_.provenance ? "{\"rows\":" : "") + all_.head;
}

std::string Writer::text_before(std::span<const std::string> group) {
  std::string cells;
  for (std::size_t i = 0; i < group.size(); ++i) {
    cells += all_.before[i] + options_.format->output->text(group[i], marks_.delimiter);
  }
  if (nested_) {
    std::string text = (group_ ? end_of_curve() + ",\n" : "") + cells + ",\"rows\":" + all_.head;
    any_rows_ = false;
    return text;
  }
  rows_.before[0] = cells + all_.before[columns_.groups.size()];
  if (!group_ || !std::ranges::equal(*group_, group) || !any_rows_) return "";
  if (all_.divider.empty()) {
    throw data_error(
        "there is more than one curve, but {} holds one table of rows; expected one curve; give another format, such "
        "as csv, to --output-format",
        options_.format->name);
  }
  return all_.between_rows + all_.divider;
}

std::string Writer::row_end(std::span<const std::string_view> labels) const {
  std::string text;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    text += all_.before[columns_.groups.size() + columns_.numbers.size() + i] +
            options_.format->output->text(labels[i], marks_.delimiter);
  }
  return text + all_.row_end;
}

std::string Writer::tail(std::string_view member) const {
  std::string text = any_rows_ ? all_.tail : all_.no_rows;
  if (nested_) text = group_ ? end_of_curve() + "\n]" : "]";
  const bool has_member = options_.format->nests && options_.provenance;
  if (has_member) text += fmt::format(",\n{}", member);
  if (nested_ || has_member) text += '}';
  return text + all_.end;
}

void Writer::begin_curve(std::vector<std::string> group, const std::optional<EulerTrack>& euler) {
  if (keeper_ != nullptr) keeper_->begin_curve(group, euler);
  if (options_.format->output->gathers_rows) return;
  if (options_.file_column) group.insert(group.begin(), file_);
  const std::string text = text_before(group);
  if (!text.empty()) output_.write(text);
  group_ = std::move(group);
}

std::string Writer::print(const Table& table, bool first) const {
  if (keeper_ != nullptr) keeper_->observe(table, cells_);
  std::string text;
  append_rows(text, rows_, printed_, {table, cells_}, times_, first && !any_rows_);
  return text;
}

std::string Writer::print(const LabelledBlock& block, const Evaluate& evaluate) const {
  std::vector<std::size_t> fields = options_.fields;
  fields.push_back(field_of("key"));
  Layout layout = rows_;
  std::string text;
  bool first = block.samples.first && !any_rows_;
  for (std::size_t i = 0; i < block.samples.parts.size(); ++i) {
    const SampleBlock::Part& part = block.samples.parts[i];
    const Table table = evaluate({block.samples.owner, {part}, false}, fields);
    const RowCells rows(table, cells_ + 1);
    for (std::size_t row = 0; row < table.cells.size(); row += rows.width) {
      const Cell& key = table.cells[row + cells_];
      const bool is_at_end = !is_empty(key) && key.hi == static_cast<double>(part.segment.end_key) &&
                             key.hi != static_cast<double>(part.segment.number);
      layout.row_end = is_at_end ? block.ends[i].second : block.ends[i].first;
      append_rows(text, layout, printed_, rows.row(row), times_, first);
      first = false;
    }
  }
  return text;
}

void Writer::write(const Source<std::string>& rows) {
  bool any = false;
  while (const std::optional<std::string> text = rows()) {
    if (options_.format->output->gathers_rows) {
      keeper_->add(*text);
    } else {
      output_.write(*text);
    }
    bytes_ += text->size();
    any = any || !text->empty();
  }
  any_rows_ = any_rows_ || any;
  if (keeper_ != nullptr) keeper_->end_curve();
}

void Writer::commit() {
  const std::string provenance = recorder_.after_rows(*options_.format);
  const bool is_member = options_.format->nests;
  output_.write(is_member ? tail(provenance)
                          : tail() + (keeper_ == nullptr ? "" : keeper_->tail(times_.unit())) + provenance);
  if (const auto counted_head = options_.format->output->counted_head) {
    const std::size_t columns = columns_.numbers.size();
    output_.write_beginning(counted_head(columns, bytes_ / (columns * sizeof(double))));
  }
  output_.commit();
}

}  // namespace tcb
