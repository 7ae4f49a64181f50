// Frame: the texts around the rows of all curves of an output.
#include "write/frame.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "error.hpp"
#include "option_names.hpp"
#include "schema/pose_formats.hpp"
#include "text/utf8.hpp"
#include "write/output_format.hpp"

namespace tcb {
namespace {

Error text_in_binary_format(std::string_view column, std::string_view format) {
  return data_error(
      "column {} holds text, but {} holds only numbers; expected a format with text; give another one, such as csv, to "
      "{}, or remove the column",
      in_quotes(column), format, option::output_format);
}

std::ptrdiff_t signed_size(std::size_t size) { return static_cast<std::ptrdiff_t>(size); }

}  // namespace

std::vector<std::string> OutputColumns::names() const {
  std::vector<std::string> all = groups;
  std::ranges::transform(numbers, std::back_inserter(all), &OutputColumn::name);
  all.insert(all.end(), labels.begin(), labels.end());
  return all;
}

Frame::Frame(const OutputColumns& columns, const FrameOptions& options)
    : options_(options),
      marks_(options.marks),
      nested_(options.format->nests && !columns.groups.empty()),
      groups_(columns.groups.size()),
      numbers_(columns.numbers.size()) {
  const Format& format = *options.format;
  for (const bool is_group : {true, false}) {
    const std::vector<std::string>& texts = is_group ? columns.groups : columns.labels;
    if (texts.empty() || (is_group ? format.output->has_groups : format.output->has_labels)) continue;
    if (format.poses == nullptr) throw text_in_binary_format(texts.front(), format.name);
    throw data_error(
        "column {} holds text, but {} holds only times and poses; expected rows without text; give another format, "
        "such as csv, to {}",
        in_quotes(texts.front()), format.name, option::output_format);
  }
  std::vector<OutputColumn> all;
  for (const std::string& name : columns.names()) all.push_back({name});
  const auto layout = format.output->layout;
  all_ = layout(all, marks_, options.header);
  if (options.keeper != nullptr) options.keeper->complete(all_);
  head_ = nested_ ? "{\"curves\":[\n" : (options.has_member ? "{\"rows\":" : "") + all_.head;
  if (format.poses != nullptr && options.keeper == nullptr) head_ = format.poses->head;
  rows_ = nested_ ? layout({all.begin() + signed_size(groups_), all.end()}, marks_, options.header) : all_;
  const auto labels_begin = rows_.before.begin() + signed_size(numbers_ + (nested_ ? 0 : groups_));
  rows_.before.assign(rows_.before.begin() + signed_size(nested_ ? 0 : groups_), labels_begin);
  if (options.notation.kind != Notation::Kind::shortest) rows_.notation = options.notation;
}

std::string Frame::begin(std::span<const std::string> group, bool divided) {
  const OutputFormat& format = *options_.format->output;
  const bool follows = std::exchange(any_curves_, true);
  std::string cells;
  for (std::size_t i = 0; i < group.size(); ++i) cells += all_.before[i] + format.text(group[i], marks_.delimiter);
  if (nested_) {
    std::string text = (follows ? end_curve() + ",\n" : "") + cells + ",\"rows\":" + all_.head;
    any_rows_ = false;
    return text;
  }
  rows_.before[0] = cells + all_.before[groups_];
  if (!divided || !any_rows_) return "";
  if (all_.divider.empty()) {
    throw data_error(
        "there is more than one curve, but {} holds one table of rows; expected one curve; give another format, such "
        "as csv, to {}",
        options_.format->name, option::output_format);
  }
  return all_.between_rows + all_.divider;
}

std::string Frame::row_end(std::span<const std::string_view> labels) const {
  const OutputFormat& format = *options_.format->output;
  std::string text;
  for (std::size_t i = 0; i < labels.size(); ++i)
    text += all_.before[groups_ + numbers_ + i] + format.text(labels[i], marks_.delimiter);
  return text + all_.row_end;
}

std::string Frame::counted_head(std::uint64_t bytes) const {
  const auto head = options_.format->output->counted_head;
  return head == nullptr ? "" : head(numbers_, bytes / (numbers_ * sizeof(double)));
}

std::string Frame::tail(std::string_view member) const {
  std::string text = any_rows_ ? all_.tail : all_.no_rows;
  if (nested_) text = any_curves_ ? end_curve() + "\n]" : "]";
  if (options_.has_member) text += fmt::format(",\n{}", member);
  if (nested_ || options_.has_member) text += '}';
  return text + all_.end;
}

}  // namespace tcb
