// The whole path, from the bytes of keys to the bytes of samples.
#include "resample.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <map>
#include <memory>
#include <utility>

#include "error.hpp"
#include "file.hpp"
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
    } else if (columns.size() != columns_.size()) {
      throw Error(Exit::data, fmt::format("its rows have {} columns; expected {}, as in the files before; give "
                                          "--output-dir to write an output for each file",
                                          columns.size(), columns_.size()));
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
  const Plan& plan_;
  Output output_;
  std::vector<format::OutputColumn> columns_;
  format::Layout layout_;
  bool any_rows_ = false;
};

bool needs_lengths(const Plan& plan) {
  bool needed = sampler::by_length(plan.sampling.mode);
  for (const std::size_t field : plan.fields) needed = needed || fields()[field].needs_lengths;
  return needed;
}

/// The stretches of the curve, and the sampler for it: at once where the first key is enough to know,
/// otherwise after all keys were read.
std::pair<Source<Stretch>, std::shared_ptr<sampler::Sampler>> prepare(Source<Keys> keys, const Plan& plan) {
  const sampler::Request& request = plan.sampling;
  sampler::Extent extent;
  if (sampler::needs_end(request.mode)) {
    const KeptKeys kept(keys);
    extent.last = kept.last_time();
    if (sampler::by_length(request.mode)) extent.length = total_length(stretches(kept.source(), plan.curve, true));
    keys = kept.source();
  }
  std::optional<Keys> first = keys();
  while (first && first->size() == 0) first = keys();
  extent.first = first->times.front();
  auto source = stretches(preceded_by(std::move(*first), std::move(keys)), plan.curve, needs_lengths(plan));
  return {std::move(source), sampler::make_sampler(request, extent)};
}

/// Bytes to bytes, for one file.
void resample_file(const std::string& path, const Plan& plan, Writer& writer) {
  format::Input input = format::open_input(path, read_file(path), plan.input);
  writer.begin(input, is_live(path));
  auto [pieces, sampler] = prepare(increasing(std::move(input.keys)), plan);
  const auto print = [&plan, &writer, sampler = sampler](const Batch& batch) {
    return writer.print(evaluate(batch, *sampler, plan.fields), batch.first);
  };
  const Source<std::string> rows = ordered_map(place(std::move(pieces), sampler, plan.curve.metric), print);
  bool any = false;
  while (const std::optional<std::string> text = rows()) {
    writer.write(*text);
    any = any || !text->empty();
  }
  writer.end(any);
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
