// The writer: one output with the texts around the rows of files and curves, and the rows themselves.
#include "output/writer.hpp"

#include <utility>

#include "error.hpp"

namespace tcb {

void Writer::begin(const Input& input, bool live, Facts rules) {
  OutputColumns columns{input.groups, output_columns(options_.fields, input), input.carried};
  if (columns_.numbers.empty()) {
    const Format& format = format_of(options_.format);
    columns_ = std::move(columns);
    frame_ = Frame(columns_, {format.id, options_.header.value_or(input.named), options_.notation,
                              format.nests && options_.provenance.has_value()});
    recorder_.set_rules(std::move(rules));
    output_.write(recorder_.before_rows(format.id) + frame_.head());
  } else if (columns.names() != columns_.names()) {
    throw Error(Exit::data, ErrorCode::other_columns, {columns.names(), columns_.names()});
  }
  output_.set_live(live);
}

void Writer::begin_curve(const std::vector<std::string>& group) {
  const std::string text = frame_.begin(group, group_ == group);
  if (!text.empty()) output_.write(text);
  group_ = group;
}

std::string Writer::print(const Table& table, bool first) const {
  std::string text;
  append_rows(text, frame_.layout(), columns_.numbers, table.cells, table.texts, first && frame_.is_first());
  return text;
}

std::string Writer::print(const LabelledBlock& block, const Evaluate& evaluate) const {
  const auto print_row = [this, layout = frame_.layout()](std::string& out, const Table& row,
                                                          const std::string& row_end, bool first) mutable {
    layout.row_end = row_end;
    append_rows(out, layout, columns_.numbers, row.cells, row.texts, first && frame_.is_first());
  };
  return print_labelled(block, evaluate, options_.fields, print_row);
}

void Writer::write(const Source<std::string>& rows) {
  bool any = false;
  while (const std::optional<std::string> text = rows()) {
    output_.write(*text);
    bytes_ += text->size();
    any = any || !text->empty();
  }
  if (any) frame_.set_written();
}

void Writer::commit() {
  const std::string provenance = recorder_.after_rows(options_.format);
  const bool is_member = format_of(options_.format).nests;
  output_.write(is_member ? frame_.tail(provenance) : frame_.tail() + provenance);
  if (const std::string head = frame_.counted_head(bytes_); !head.empty()) output_.write_beginning(head);
  output_.commit();
}

}  // namespace tcb
