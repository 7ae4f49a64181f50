// Writer: one output with its frames and rows.
#include "write/writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "schema/errors.hpp"
#include "schema/pose_formats.hpp"
#include "text/utf8.hpp"
#include "write/errors.hpp"
#include "write/pose_cells.hpp"

namespace tcb {

namespace {

/// Throws: Error (data) where the name is another column's, or the file's is not UTF-8.
void add_file_column(OutputColumns& columns, const std::string& name, const std::string& file) {
  if (std::ranges::count(columns.names(), name) > 0) throw file_column_taken(name);
  const std::size_t invalid = find_invalid_utf8(file);
  if (invalid != std::string::npos) throw file_name_not_utf8(file[invalid]);
  columns.groups.insert(columns.groups.begin(), name);
}

/// A text with another decimal mark, which is after the last colon.
std::string with_decimal(std::string text, char mark) {
  const std::size_t colon = text.rfind(':'), point = text.find('.', colon == std::string::npos ? 0 : colon);
  if (point != std::string::npos) text[point] = mark;
  return text;
}

/// A text with other ends of its lines.
std::string with_crlf(std::string_view text) {
  std::string result;
  for (const char c : text) result += c == '\n' ? "\r\n" : std::string(1, c);
  return result;
}

/// Throws: Error (data) unless the channels are x, y, z, and maybe yaw, and the times are seconds.
void require_path_with_yaw(const Schema& schema) {
  const bool has_yaw = schema.channels.size() == 4 && schema.channels.back() == "yaw";
  if (schema.channels.size() != 3 && !has_yaw) throw no_path_with_yaw(schema.channels);
  if (!schema.rotations.empty()) throw no_path_with_yaw(schema.channels);
  const TimeUnit unit = schema.time.unit.value_or(TimeUnit::s);
  if (unit != TimeUnit::s) throw durations_not_in_seconds(row_of(unit).name);
}

}  // namespace

TextMarks Writer::marks_for(const Schema& schema) const {
  if (options_.like_input) {
    if (!schema.marks) throw input_without_marks();
    return *schema.marks;
  }
  return {options_.delimiter.value_or(format_of(options_.format).delimiter), options_.decimal};
}

void Writer::begin(const Schema& schema, bool live, Facts rules, const std::string& file) {
  OutputColumns columns{schema.groups, output_columns(options_.fields, schema), schema.labels};
  if (options_.file_column) {
    add_file_column(columns, *options_.file_column, file);
    file_ = '"' + file;
  }
  const Format& format = format_of(options_.format);
  if (format.family == FormatFamily::scene) {
    if (schema.time.unit == TimeUnit::frames) throw times_without_rate(schema.time.name);
    if (scene_ == nullptr) {
      scene_ = std::make_unique<GltfScene>(std::ranges::count(options_.fields, field_of("time")) == 0);
    }
    scene_->begin(schema);
    columns.groups.clear();
  }
  if (format.family == FormatFamily::pieces) require_path_with_yaw(schema);
  const bool is_pose = has_pose_rows(format);
  cells_ = columns.numbers.size();
  if (is_pose) {
    order_ = pose_cells(pose_format(format.id), schema);
    std::vector<OutputColumn> numbers;
    for (const std::size_t cell : order_) numbers.push_back(columns.numbers[cell]);
    columns.numbers = std::move(numbers);
  }
  if (columns_.numbers.empty()) {
    columns_ = std::move(columns);
    marks_ = marks_for(schema);
    set_times(schema);
    if (format.family == FormatFamily::cameras) cameras_ = std::make_unique<CameraPath>(schema.camera_path);
    frame_ = Frame(columns_, {format.id, !is_pose && options_.header.value_or(schema.named), options_.notation,
                              format.nests && options_.provenance.has_value(), marks_, cameras_.get()});
    recorder_.set_rules(std::move(rules));
    const std::string provenance = recorder_.before_rows(format.id);
    output_.write((marks_.crlf ? with_crlf(provenance) : provenance) + frame_.head());
  } else if (columns.names() != columns_.names()) {
    throw columns_differ_from_before(columns.names(), columns_.names());
  }
  output_.set_live(live);
}

void Writer::begin_curve(std::vector<std::string> group, const std::optional<EulerTrack>& euler) {
  if (scene_ != nullptr) return scene_->begin_curve(group, euler);
  if (options_.file_column) group.insert(group.begin(), file_);
  const std::string text = frame_.begin(group, group_ == group);
  if (!text.empty()) output_.write(text);
  group_ = std::move(group);
}

void Writer::set_times(const Schema& schema) {
  const auto given = options_.time_notation;
  if (has_pose_rows(format_of(options_.format))) return set_times_of_poses(schema.time);
  if (!given) {
    if (format_of(options_.format).family != FormatFamily::array) notation_ = schema.time.notation;
    dates_ = schema.time.dates;
    return;
  }
  if (schema.time.unit == TimeUnit::frames) throw times_without_rate(schema.time.name);
  if (schema.time.unit) unit_ = Rational(1) / units_per_second(*schema.time.unit);
  const bool drops = given == TimeNotation::smpte && schema.time.notation == TimeNotation::drop_frame;
  notation_ = drops ? TimeNotation::drop_frame : *given;
}

/// The times of poses are numbers in the unit of their format. Those without a known unit are taken as seconds.
void Writer::set_times_of_poses(const TimeSchema& time) {
  const PoseFormat& format = pose_format(options_.format);
  if (!format.unit && cameras_ == nullptr) return;
  if (time.unit == TimeUnit::frames) throw times_without_rate(time.name);
  whole_times_ = format.unit == TimeUnit::ns;
  if (!time.unit && time.notation == TimeNotation::seconds && whole_times_) {
    throw poses_without_unit_of_time(time.name, format_of(options_.format).name);
  }
  unit_ = units_per_second(format.unit.value_or(TimeUnit::s)) / units_per_second(time.unit.value_or(TimeUnit::s));
}

std::vector<std::string> Writer::texts(const Table& table) const {
  const bool is_number = notation_ == TimeNotation::seconds || notation_ == TimeNotation::frames;
  std::vector<std::string> texts = table.texts;
  if (marks_.decimal != '.') {
    for (std::string& text : texts) text = with_decimal(std::move(text), marks_.decimal);
  }
  if ((notation_ == TimeNotation::seconds && unit_ == 1) || cameras_ != nullptr) return texts;
  texts.resize(table.cells.size());
  const bool is_fixed = options_.notation.kind == Notation::Kind::fixed;
  const auto decimals = is_fixed ? std::optional(options_.notation.count) : std::nullopt;
  const bool in_quotes = format_of(options_.format).family == FormatFamily::json;
  for (std::size_t i = 0; i < table.cells.size(); ++i) {
    if (columns_.numbers[i % columns_.numbers.size()].kind != CellKind::time) continue;
    const Rational seconds = exact_time(table.cells[i]) * unit_, rate = options_.frame_rate.value_or(1);
    if (is_number) {
      const Rational frames = Rational(table.cells[i].hi) * unit_ * rate;  // of the double, whose error is the smaller
      const bool counts = notation_ == TimeNotation::frames;
      Rational number = counts ? whole_frame(seconds, rate).value_or(frames) : seconds;
      if (whole_times_) number = floor(number + Rational(1, 2));
      Time time = nearest_time(number);
      if (const Time nanoseconds = nearest_time(number, 9); !order_.empty() && exact_time(nanoseconds) == number) {
        time = nanoseconds;  // poses have them in seconds
      }
      texts[i] = with_decimal(time_text(time), marks_.decimal);
      continue;
    }
    const auto text = time_in_words(seconds, notation_, rate, decimals, dates_);
    if (!text) {
      const char* const name = notation_ == TimeNotation::clock ? "clock" : is_date(notation_) ? "a date" : "timecode";
      throw time_not_in_notation(time_text(table.cells[i]), name);
    }
    const bool has_clock = text->find(':') != std::string::npos;
    texts[i] = in_quotes ? json_text(*text) : has_clock ? with_decimal(*text, marks_.decimal) : *text;
  }
  return texts;
}

Table Writer::ordered(const Table& table) const {
  Table result;
  for (std::size_t first = 0; first < table.cells.size(); first += cells_) {
    for (const std::size_t cell : order_) {
      result.cells.push_back(table.cells[first + cell]);
      if (!table.texts.empty()) result.texts.push_back(table.texts[first + cell]);
    }
  }
  return result;
}

void Writer::append(std::string& out, const Layout& layout, const Table& table, bool first) const {
  const bool is_first = first && frame_.is_first();
  if (order_.empty()) return append_rows(out, layout, columns_.numbers, table.cells, texts(table), is_first);
  if (cameras_ != nullptr) cameras_->add(table, cells_);
  const Table rows = ordered(table);
  append_rows(out, layout, columns_.numbers, rows.cells, texts(rows), is_first);
}

std::string Writer::print(const Table& table, bool first) const {
  std::string text;
  append(text, frame_.layout(), table, first);
  return text;
}

std::string Writer::print(const LabelledBlock& block, const Evaluate& evaluate) const {
  const auto print_row = [this, layout = frame_.layout()](std::string& out, const Table& row,
                                                          const std::string& row_end, bool first) mutable {
    layout.row_end = row_end;
    append(out, layout, row, first);
  };
  return print_labelled(block, evaluate, options_.fields, print_row);
}

void Writer::write(const Source<std::string>& rows) {
  bool any = false;
  while (const std::optional<std::string> text = rows()) {
    if (scene_ != nullptr) {
      scene_->add(*text);
    } else {
      output_.write(*text);
    }
    bytes_ += text->size();
    any = any || !text->empty();
  }
  if (any) frame_.set_written();
  if (scene_ != nullptr) scene_->end_curve();
}

std::vector<std::string> Writer::channels_in_extras() const {
  return scene_ == nullptr ? std::vector<std::string>{} : scene_->other_channels();
}

void Writer::commit() {
  if (scene_ != nullptr) output_.write(scene_->text());
  const std::string provenance = recorder_.after_rows(options_.format);
  const bool is_member = format_of(options_.format).nests;
  output_.write(is_member ? frame_.tail(provenance)
                          : frame_.tail() + (cameras_ == nullptr ? "" : cameras_->tail(unit_)) +
                                (marks_.crlf ? with_crlf(provenance) : provenance));
  if (const std::string head = frame_.counted_head(bytes_); !head.empty()) output_.write_beginning(head);
  output_.commit();
}

}  // namespace tcb
