// The whole path, from the bytes of keys to the bytes of samples.
#include "resample.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <utility>

#include "closed.hpp"
#include "curve_plan.hpp"
#include "error.hpp"
#include "file.hpp"
#include "lookup.hpp"
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

/// One curve on its way from keys to rows.
class Path {
 public:
  Path(const Plan& plan, const format::Input& input)
      : plan_(plan),
        settings_(over(plan.curve, input.settings)),
        curve_(fitted(make_curve(settings_), settings_, input.channels)),
        timed_(input.timed) {
    if (timed_ && curve_.parameter) {
      throw Error(Exit::data,
                  fmt::format("--parameter makes times, but column \"{}\" has them; expected one of the two; "
                              "take --parameter out, or choose other columns with --columns",
                              input.time));
    }
  }

  /// The samples in batches, and who knows where each of them is.
  struct Placed {
    Source<Batch> batches;
    std::shared_ptr<const sampler::Locator> locator;
  };

  Placed place(Source<format::KeyBlock> blocks) {
    if (!timed_) blocks = parameterized(std::move(blocks), curve_.parameter.value_or(0), curve_.rules.metric);
    blocks = checked(without_ease(std::move(blocks)), plan_.sampling.count == 1 ? 1 : 2);
    const bool leaves = curve_.extrapolation != sampler::Extrapolation::error;
    if (curve_.closed || leaves || sampler::needs_end(plan_.sampling.mode)) return place_kept(KeptKeys(blocks), leaves);
    Source<Keys> keys = ordered_map(std::move(blocks), [](format::KeyBlock block) { return std::move(block.keys); });
    std::optional<Keys> first = keys();
    while (first && first->size() == 0) first = keys();
    const sampler::Extent extent{first->times.front(), {}, {}};
    return place_streamed({preceded_by(std::move(*first), std::move(keys)), {}}, extent);
  }

 private:
  Source<format::KeyBlock> without_ease(Source<format::KeyBlock> blocks) const {
    if (curve_.ease) return blocks;
    return ordered_map(std::move(blocks), [](format::KeyBlock block) {
      block.keys.eases.clear();
      return block;
    });
  }

  bool needs_lengths() const {
    return sampler::by_length(plan_.sampling.mode) ||
           std::ranges::any_of(plan_.fields, [](std::size_t field) { return fields()[field].needs_lengths; });
  }

  /// Rows as the curve goes by.
  Placed place_streamed(LinkedKeys keys, const sampler::Extent& extent) const {
    const std::shared_ptr<sampler::Sampler> sampler = sampler::make_sampler(plan_.sampling, extent);
    auto pieces = stretches(std::move(keys), curve_.rules, needs_lengths());
    return {tcb::place(std::move(pieces), sampler, curve_.rules.metric), sampler};
  }

  /// Rows once all keys are there: counts, closed curves, and times outside the curve.
  Placed place_kept(KeptKeys kept, bool leaves) const {
    sampler::Extent extent{kept.key(0).times[0], {}, {}, curve_.closed};
    extent.last = curve_.closed ? close(kept, curve_, timed_) : kept.key(kept.size() - 1).times[0];
    const auto linked = [&] { return curve_.closed ? going_round(kept, *extent.last) : LinkedKeys{kept.source(), {}}; };
    if (sampler::by_length(plan_.sampling.mode)) {
      extent.length = total_length(stretches(linked(), curve_.rules, true));
    } else if (leaves) {
      return place_anywhere(linked(), extent);
    }
    return place_streamed(linked(), extent);
  }

  /// Rows at times in any order, also outside the curve.
  Placed place_anywhere(LinkedKeys keys, const sampler::Extent& extent) const {
    auto [grid, rows, end] = sampler::time_rows(plan_.sampling, extent);
    const std::uint64_t count = std::min(rows, grid.step() == 0 ? 1 : grid.rows_through(*end));
    const auto time = [grid = grid](std::uint64_t j) { return grid.time(j); };
    const auto locator =
        std::make_shared<const sampler::Anywhere>(time, count, curve_.extrapolation, extent.first, *extent.last);
    const auto curve = std::make_shared<const WholeCurve>(stretches(std::move(keys), curve_.rules, needs_lengths()),
                                                          curve_.rules.metric);
    return {look_up(curve, locator), locator};
  }

  const Plan& plan_;
  CurveSettings settings_;
  CurvePlan curve_;
  bool timed_;
};

/// Bytes to bytes, for one file.
void resample_file(const std::string& path, const Plan& plan, Writer& writer) {
  format::Input input = format::open_input(path, read_file(path), plan.input);
  writer.begin(input, is_live(path));
  auto [batches, locator] = Path(plan, input).place(std::move(input.keys));
  const auto print = [&plan, &writer, locator = locator](const Batch& batch) {
    return writer.print(evaluate(batch, *locator, plan.fields), batch.first);
  };
  const Source<std::string> rows = ordered_map(std::move(batches), print);
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
