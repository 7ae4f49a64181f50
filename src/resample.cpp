// The whole path, from the bytes of keys to the bytes of samples.
#include "resample.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <thread>
#include <utility>

#include "error.hpp"
#include "file.hpp"
#include "path.hpp"
#include "rows.hpp"

namespace tcb {
namespace {

/// One output, which takes the rows of one file or of several.
class Writer {
 public:
  Writer(const Plan& plan, std::string path) : plan_(plan), output_(std::move(path)) {}

  /// The next file's rows follow. Throws: Error (data) where they have other columns than the rows before.
  void begin(const format::Input& input, bool live) {
    auto columns = output_columns(plan_.fields, input);
    if (columns_.empty()) {
      columns_ = std::move(columns);
      layout_ = format::formats()[plan_.output_format].layout(columns_, plan_.output_header.value_or(input.named));
      output_.write(layout_.head);
    } else if (!std::ranges::equal(columns, columns_, {}, &format::OutputColumn::name, &format::OutputColumn::name)) {
      throw Error(Exit::data, fmt::format("its rows have the columns {}; expected {}, as in the files before; give "
                                          "--output-dir to write an output for each file",
                                          names(columns), names(columns_)));
    }
    output_.set_live(live);
  }

  /// The text of some rows. A pure function but for the layout, which begin() has set.
  std::string print(const std::vector<format::Cell>& cells, bool first) const {
    std::string text;
    format::append_rows(text, layout_, columns_, cells, first && !any_rows_);
    return text;
  }

  void write(const std::string& rows) { output_.write(rows); }
  void end(bool any_rows) { any_rows_ = any_rows_ || any_rows; }

  void commit() {
    output_.write(any_rows_ ? layout_.tail : layout_.no_rows);
    output_.commit();
  }

 private:
  static std::string names(const std::vector<format::OutputColumn>& columns) {
    std::string text;
    for (const auto& column : columns) text += (text.empty() ? "" : ", ") + column.name;
    return text;
  }

  const Plan& plan_;
  Output output_;
  std::vector<format::OutputColumn> columns_;
  format::Layout layout_;
  bool any_rows_ = false;
};

/// What the program tells the person at the terminal.
void note(const Plan& plan, const std::string& path, const std::string& text) {
  if (!plan.notes) return;
  (void)std::fputs(fmt::format("{}: note: {}\n", shown_name(path), text).c_str(), stderr);
}

std::string shown(const sampler::Rational& value) { return fmt::format("{}", sampler::nearest_time(value).hi); }

/// How far the end lies behind the last row, and what to do about it; empty where it does not.
std::string left_out(const Placed& placed) {
  const auto rest = placed.sampler == nullptr ? std::nullopt : placed.sampler->left_out();
  if (!rest) return "";
  return fmt::format("the end lies {} behind the last row and is left out; --end keep or --end fit includes it",
                     shown(*rest));
}

/// What reading a file is told. Threads would have rows of a live pipe wait for those behind them.
format::InputOptions input_options(const Plan& plan, const std::string& path) {
  format::InputOptions options = plan.input;
  options.threads = plan.jobs.value_or(is_live(path) ? 1 : std::thread::hardware_concurrency());
  return options;
}

/// Bytes to bytes, for one file.
void resample_file(const std::string& path, const Plan& plan, Writer& writer) {
  format::Input input = format::open_input(path, read_file(path), input_options(plan, path));
  const Path curve(plan.sampling, plan.curve, plan.fields, input);
  if (!input.timed && !plan.curve.parameter) note(plan, path, "no time column; the keys stand at 0, 1, 2, ...");
  for (const auto& [name, value] : input.facts) {
    if (name == "left out") note(plan, path, fmt::format("columns of text are left out: {}", value));
  }
  writer.begin(input, is_live(path));
  const Placed placed = curve.place(std::move(input.keys));
  const auto print = [&plan, &writer, &placed](const Batch& batch) {
    return writer.print(evaluate(batch, *placed.locator, plan.fields), batch.first);
  };
  const Source<std::string> rows = ordered_map(placed.batches, print, input.threads);
  bool any = false;
  while (const std::optional<std::string> text = rows()) {
    writer.write(*text);
    any = any || !text->empty();
  }
  writer.end(any);
  if (const std::string text = left_out(placed); !text.empty()) note(plan, path, text);
  for (const auto& [name, value] : placed.facts) {
    if (name == "step" && plan.sampling.end != sampler::EndPolicy::drop)
      note(plan, path, fmt::format("the step is {}", value));
  }
}

/// What was found in a file and would be done, a line each.
std::string explanation(const std::string& path, const Plan& plan) {
  format::Input input = format::open_input(path, read_file(path), input_options(plan, path));
  const Path curve(plan.sampling, plan.curve, plan.fields, input);
  Facts facts{{"file", shown_name(path)}};
  const auto add = [&](const Facts& more) { facts.insert(facts.end(), more.begin(), more.end()); };
  add(input.facts);
  add(curve.rules());
  const auto keys = std::make_shared<std::size_t>(0);
  const Placed placed = curve.place(mapped(std::move(input.keys), [keys](format::KeyBlock block) {
    *keys += block.lines.size();
    return block;
  }));
  std::uint64_t rows = 0;
  while (const auto batch = placed.batches()) {
    for (const auto& part : batch->parts) rows += part.last - part.first;
  }
  facts.emplace_back("keys", fmt::format("{}", *keys));
  add(placed.facts);
  facts.emplace_back("rows", fmt::format("{}", rows));
  if (const std::string text = left_out(placed); !text.empty()) facts.emplace_back("note", text);
  std::string out;
  for (const auto& [name, value] : facts) out += fmt::format("{}: {}\n", name, value);
  return out;
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
