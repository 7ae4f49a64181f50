// The whole path, from the bytes of keys to the bytes of samples.
#include "resample.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <thread>
#include <utility>

#include "error.hpp"
#include "explain.hpp"
#include "file.hpp"
#include "format/frame.hpp"
#include "labels.hpp"
#include "path.hpp"
#include "rows.hpp"

namespace tcb {
namespace {

/// One output, which takes the rows of one file or of several.
class Writer {
 public:
  Writer(const Plan& plan, std::string path)
      : plan_(plan), output_(std::move(path), format::formats()[plan.output_format].head != nullptr) {}

  /// The next file's rows follow. Throws: Error (data) where they have other columns than the rows before.
  void begin(const format::Input& input, bool live) {
    format::OutputColumns columns{input.groups, output_columns(plan_.fields, input), input.carried};
    if (columns_.numbers.empty()) {
      columns_ = std::move(columns);
      frame_ = format::Frame(format::formats()[plan_.output_format], columns_,
                             plan_.output_header.value_or(input.named), plan_.notation);
      output_.write(frame_.head());
    } else if (columns.names() != columns_.names()) {
      throw Error(Exit::data, fmt::format("its rows have the columns {}; expected {}, as in the files before; give "
                                          "--output-dir to write an output for each file",
                                          fmt::join(columns.names(), ", "), fmt::join(columns_.names(), ", ")));
    }
    group_.reset();
    output_.set_live(live);
  }

  /// The rows of the next curve of the file follow.
  void begin_curve(const std::vector<std::string>& group) {
    const std::string text = frame_.begin(group, group_ == group);
    if (!text.empty()) output_.write(text);
    group_ = group;
  }

  /// The text of some rows. A pure function but for the layout, which begin_curve() has set.
  std::string print(const Table& table, bool first) const {
    std::string text;
    format::append_rows(text, frame_.layout(), columns_.numbers, table.cells, table.texts, first && frame_.is_first());
    return text;
  }

  /// The same for rows that end in labels.
  std::string print(const LabelledBatch& batch, const Evaluate& evaluate) const {
    return print_labelled(batch, evaluate, plan_.fields,
                          [this, layout = frame_.layout()](std::string& out, const Table& row,
                                                           const std::string& row_end, bool first) mutable {
                            layout.row_end = row_end;
                            format::append_rows(out, layout, columns_.numbers, row.cells, row.texts,
                                                first && frame_.is_first());
                          });
  }

  std::string row_end(std::span<const std::string_view> labels) const { return frame_.row_end(labels); }

  /// Writes the rows of a curve as they come.
  void write(const Source<std::string>& rows) {
    bool any = false;
    while (const std::optional<std::string> text = rows()) {
      output_.write(*text);
      bytes_ += text->size();
      any = any || !text->empty();
    }
    if (any) frame_.set_written();
  }

  void commit() {
    output_.write(frame_.tail());
    if (const std::string head = frame_.counted_head(bytes_); !head.empty()) output_.write_beginning(head);
    output_.commit();
  }

 private:
  const Plan& plan_;
  Output output_;
  format::OutputColumns columns_;
  format::Frame frame_;
  std::optional<std::vector<std::string>> group_;  ///< of the curve before in the same file
  std::uint64_t bytes_ = 0;                        ///< of all rows
};

/// What the program tells the person at the terminal.
void note(const Plan& plan, const std::string& path, const std::string& text) {
  if (!plan.notes) return;
  (void)std::fputs(fmt::format("{}: note: {}\n", shown_name(path), text).c_str(), stderr);
}

/// What reading a file is told. Threads would have rows of a live pipe wait for those behind them.
format::InputOptions input_options(const Plan& plan, const std::string& path) {
  format::InputOptions options = plan.input;
  options.threads = plan.jobs.value_or(is_live(path) ? 1 : std::thread::hardware_concurrency());
  return options;
}

/// The rows of a curve as text.
Source<std::string> printed(const Placed& placed, const Plan& plan, const Writer& writer,
                            const std::shared_ptr<Labels>& labels, unsigned threads) {
  if (plan.golden) threads = 1;  // the rows share what was worked out for those before
  if (labels == nullptr) {
    const auto print = [&plan, &writer, &placed](const Batch& batch) {
      return writer.print(placed.evaluate(batch, plan.fields), batch.first);
    };
    return ordered_map(placed.batches, print, threads);
  }
  const auto row_end = [&writer](std::span<const std::string_view> texts) { return writer.row_end(texts); };
  const auto print = [&writer, &placed](const LabelledBatch& batch) { return writer.print(batch, placed.evaluate); };
  return ordered_map(Labels::joined(labels, placed.batches, row_end, placed.sampler != nullptr), print, threads);
}

/// Bytes to bytes, for one file.
void resample_file(const std::string& path, const Plan& plan, Writer& writer) {
  const bool live = is_live(path);
  const format::Input input = format::open_input(path, read_file(path), input_options(plan, path));
  if (!input.timed && !plan.curve.parameter) note(plan, path, "no time column; the keys stand at 0, 1, 2, ...");
  for (const auto& [name, value] : input.facts) {
    if (name == "left out") note(plan, path, fmt::format("columns of text are left out: {}", value));
  }
  Curves curves(input, plan.curves, live);
  std::optional<Path> way;
  for (std::shared_ptr<const format::BesideKeys> known; std::optional<CurveKeys> curve = curves.next();) {
    if (curve->beside_keys != known)
      way.emplace(plan.sampling, plan.curve, plan.fields, plan.golden, input, *curve->beside_keys);
    if (known == nullptr) writer.begin(input, live);
    known = curve->beside_keys;
    writer.begin_curve(curve->group);
    const auto labels = input.carried.empty() ? nullptr : std::make_shared<Labels>(input.groups.size());
    const Placed placed = way->place(labels == nullptr ? curve->keys : Labels::heard(labels, curve->keys));
    writer.write(printed(placed, plan, writer, labels, input.threads));
    if (const std::string text = left_out(placed); !text.empty()) note(plan, path, text);
    for (const auto& [name, value] : placed.facts) {
      if (name == "step" && plan.sampling.end != sampler::EndPolicy::drop)
        note(plan, path, fmt::format("the step is {}", value));
    }
  }
  if (curves.skipped() > 0) note(plan, path, fmt::format("rows left out for missing numbers: {}", curves.skipped()));
}

/// Where the samples of a file go: its name in the output folder, with the format's ending.
std::string output_path(const std::string& file, const Plan& plan) {
  if (file == "-") throw Error(Exit::usage, "standard input has no name; --output-dir needs files; give -o instead");
  const std::filesystem::path name = std::filesystem::path(file).stem();
  return *plan.output_folder / name += format::formats()[plan.output_format].ending;
}

/// Throws: Error (usage) where an output would take the place of an input, or of another output.
void require_distinct_paths(const Plan& plan) {
  std::map<std::string, std::string> inputs_by_output;
  for (const std::string& file : plan.files) {
    const std::string path = plan.output_folder ? output_path(file, plan) : plan.output;
    std::error_code none;
    if (std::filesystem::equivalent(path, file, none) && std::filesystem::is_regular_file(path, none)) {
      throw Error(Exit::usage, Place{file}, "it is an input and an output; expected two files; give another output");
    }
    const auto [other, fresh] = inputs_by_output.emplace(path, file);
    if (!fresh && plan.output_folder) {
      throw Error(Exit::usage, Place{file},
                  fmt::format("its output {} is that of {} too; expected one for each; rename "
                              "one of them, or use two folders",
                              path, other->second));
    }
  }
}

/// Runs f, and says of errors in which file they are.
template <class F>
void in_file(const std::string& path, F f) {
  try {
    f();
  } catch (const Error& error) {
    throw error.in(shown_name(path));
  }
}

}  // namespace

void resample(const Plan& plan) {
  const ThreadLimit limit(plan.jobs.value_or(std::max(1U, std::thread::hardware_concurrency())));
  if (plan.explain) {
    Output output("-");
    for (const std::string& file : plan.files) in_file(file, [&] { output.write(explanation(file, plan)); });
    output.commit();
    return;
  }
  require_distinct_paths(plan);
  if (plan.output_folder) {
    make_folder(*plan.output_folder);
    for (const std::string& file : plan.files) {
      Writer writer(plan, output_path(file, plan));
      in_file(file, [&] { resample_file(file, plan, writer); });
      writer.commit();
    }
    return;
  }
  Writer writer(plan, plan.output);
  for (const std::string& file : plan.files) {
    in_file(file, [&] { resample_file(file, plan, writer); });
  }
  writer.commit();
}

}  // namespace tcb
