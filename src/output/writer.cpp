// The writer of one output: what stands around the rows of files and curves, and the rows themselves.
#include "output/writer.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <utility>

#include "error.hpp"

namespace tcb {

void Writer::begin(const Input& input, bool live, Facts rules) {
  OutputColumns columns{input.groups, output_columns(plan_.fields, input), input.carried};
  if (columns_.numbers.empty()) {
    columns_ = std::move(columns);
    const Format& format = format_of(plan_.output_format);
    frame_ = Frame(format, columns_, plan_.output_header.value_or(input.named), plan_.notation);
    output_.write(recorder_.head(format, std::move(rules), frame_.head(), frame_.is_nested()));
  } else if (columns.names() != columns_.names()) {
    throw Error(Exit::data, fmt::format("its rows have the columns {}; expected {}, as in the files before; give "
                                        "--output-dir to write an output for each file",
                                        fmt::join(columns.names(), ", "), fmt::join(columns_.names(), ", ")));
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

std::string Writer::print(const LabelledBlock& batch, const Evaluate& evaluate) const {
  return print_labelled(batch, evaluate, plan_.fields,
                        [this, layout = frame_.layout()](std::string& out, const Table& row, const std::string& row_end,
                                                         bool first) mutable {
                          layout.row_end = row_end;
                          append_rows(out, layout, columns_.numbers, row.cells, row.texts, first && frame_.is_first());
                        });
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
  output_.write(recorder_.tail(frame_.tail()));
  if (const std::string head = frame_.counted_head(bytes_); !head.empty()) output_.write_beginning(head);
  output_.commit();
}

}  // namespace tcb
