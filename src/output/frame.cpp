// Frames: the rows of several curves in one output, with what tells them apart and the labels that they carry.
#include "output/frame.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "error.hpp"

namespace tcb {
namespace {

std::ptrdiff_t signed_size(std::size_t size) { return static_cast<std::ptrdiff_t>(size); }

/// Without its line end.
std::string chomped(std::string text) {
  if (text.ends_with('\n')) text.pop_back();
  return text;
}

}  // namespace

std::vector<std::string> OutputColumns::names() const {
  std::vector<std::string> all = groups;
  std::ranges::transform(numbers, std::back_inserter(all), &OutputColumn::name);
  all.insert(all.end(), labels.begin(), labels.end());
  return all;
}

Frame::Frame(const Format& format, const OutputColumns& columns, bool header, const Notation& notation)
    : format_(&format),
      written_(&output_format(format.id)),
      nested_(format.nests && !columns.groups.empty()),
      groups_(columns.groups.size()),
      numbers_(columns.numbers.size()) {
  if (format.is_binary && groups_ + columns.labels.size() > 0) {
    const std::string& name = groups_ > 0 ? columns.groups.front() : columns.labels.front();
    throw Error(Exit::data, fmt::format("column \"{}\" holds texts, and {} holds numbers only; expected a format with "
                                        "texts, such as csv; choose another one, or take the column out",
                                        name, format.name));
  }
  std::vector<OutputColumn> all;
  for (const std::string& name : columns.names()) all.push_back({name});
  all_ = written_->layout(all, header);
  head_ = nested_ ? "{\"curves\":[\n" : all_.head;
  rows_ = nested_ ? written_->layout({all.begin() + signed_size(groups_), all.end()}, header) : all_;
  const auto labels_begin = rows_.before.begin() + signed_size(numbers_ + (nested_ ? 0 : groups_));
  rows_.before.assign(rows_.before.begin() + signed_size(nested_ ? 0 : groups_), labels_begin);
  if (notation.kind != Notation::Kind::shortest) rows_.notation = notation;
}

std::string Frame::begin(std::span<const std::string> group, bool apart) {
  const bool follows = std::exchange(any_curves_, true);
  std::string cells;
  for (std::size_t i = 0; i < group.size(); ++i) cells += all_.before[i] + written_->text(group[i]);
  if (nested_) {
    std::string text = (follows ? end_curve() + ",\n" : "") + cells + ",\"rows\":" + all_.head;
    any_rows_ = false;
    return text;
  }
  rows_.before[0] = cells + all_.before[groups_];
  if (!apart || !any_rows_) return "";
  if (written_->divider.empty()) {
    throw Error(Exit::data,
                fmt::format("there is more than one curve, and {} holds one table of rows; expected one; choose "
                            "another format, such as csv",
                            format_->name));
  }
  return all_.between_rows + std::string(written_->divider);
}

std::string Frame::row_end(std::span<const std::string_view> labels) const {
  std::string text;
  for (std::size_t i = 0; i < labels.size(); ++i)
    text += all_.before[groups_ + numbers_ + i] + written_->text(labels[i]);
  return text + all_.row_end;
}

std::string Frame::counted_head(std::uint64_t bytes) const {
  return written_->head == nullptr ? "" : written_->head(numbers_, bytes / (numbers_ * sizeof(double)));
}

std::string Frame::end_curve() const { return chomped(any_rows_ ? rows_.tail : rows_.no_rows) + "}"; }

std::string Frame::tail() {
  if (!nested_) return any_rows_ ? all_.tail : all_.no_rows;
  return any_curves_ ? end_curve() + "\n]}\n" : "]}\n";
}

}  // namespace tcb
