// The whole path, from the bytes of keys to the bytes of samples.
#include "app/pipeline.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstdio>
#include <memory>
#include <utility>

#include "app/batch.hpp"
#include "app/curve_pipeline.hpp"
#include "app/explain.hpp"
#include "app/progress.hpp"
#include "curve/rows.hpp"
#include "error.hpp"
#include "input/reader.hpp"
#include "io/input_list.hpp"
#include "output/writer.hpp"
#include "text/number.hpp"

namespace tcb {
namespace {

WriterOptions writer_options(const Job& plan) {
  return {plan.output_format, plan.output_header, plan.notation, plan.fields, plan.meta};
}

/// The bytes of a file, which are told as they come.
Source<std::string> told_bytes(const std::string& path, Report& report) {
  return mapped(read_file(path), [&report](std::string bytes) {
    report.add_read(bytes.size());
    return bytes;
  });
}

/// The same batches; their rows are counted and told.
Source<SampleBlock> counted(Source<SampleBlock> batches, std::uint64_t& rows, Report& report) {
  return mapped(std::move(batches), [&rows, &report](SampleBlock batch) {
    rows += batch.rows();
    report.add_rows(batch.rows());
    return batch;
  });
}

/// The rows of a curve as text.
Source<std::string> printed(const PlacedCurve& placed, const Job& plan, const Writer& writer,
                            const std::shared_ptr<Labels>& labels, unsigned threads) {
  if (plan.golden) threads = 1;  // the rows share what was worked out for those before
  if (labels == nullptr) {
    const auto print = [&plan, &writer, &placed](const SampleBlock& batch) {
      return writer.print(placed.evaluate(batch, plan.fields), batch.first);
    };
    return ordered_map(placed.batches, print, threads);
  }
  const auto row_end = [&writer](std::span<const std::string_view> texts) { return writer.row_end(texts); };
  const auto print = [&writer, &placed](const LabelledBlock& batch) { return writer.print(batch, placed.evaluate); };
  return ordered_map(Labels::attach(labels, placed.batches, row_end, placed.sampler != nullptr), print, threads);
}

/// The rules of a curve in words, with the preset that they are based on.
Facts rules(const CurvePipeline& pipeline) {
  Facts facts{{"preset", std::string(name_of(pipeline.facts().spec.preset))}};
  const Facts more = in_words(pipeline.facts());
  facts.insert(facts.end(), more.begin(), more.end());
  return facts;
}

/// Bytes to bytes, for one file; answers how many rows it has.
std::uint64_t resample_file(const std::string& path, const Job& plan, unsigned threads, Report& report,
                            Writer& writer) {
  const bool live = is_live(path);
  InputOptions options = plan.input;
  options.threads = live && !plan.jobs ? 1 : threads;  // more would have rows wait for those behind them
  ProvenanceRecorder& recorder = writer.recorder();
  const Input input = open_input(path, recorder.observe_bytes(shown_name(path), told_bytes(path, report)), options);
  if (!input.timed && !plan.curve.parameter) report.note(path, "no time column; the keys stand at 0, 1, 2, ...");
  if (!input.ignored.empty()) {
    report.note(path, fmt::format("columns of text are left out: {}", fmt::join(input.ignored, ", ")));
  }
  Curves curves(input, plan.curves, live);
  std::uint64_t rows = 0;
  std::optional<CurvePipeline> pipeline;
  for (std::shared_ptr<const CurveInfo> known; std::optional<CurveKeys> curve = curves.next();) {
    if (curve->curve_info != known)
      pipeline.emplace(plan.sampling, plan.curve, plan.fields, plan.golden, input, *curve->curve_info);
    if (known == nullptr) writer.begin(input, live, rules(*pipeline));
    known = curve->curve_info;
    writer.begin_curve(curve->group);
    const std::size_t grouping = input.own_curves ? 0 : input.groups.size();  // texts of a key that are no labels
    const auto labels = input.carried.empty() ? nullptr : std::make_shared<Labels>(grouping);
    const auto keys = recorder.observe_keys(curve->keys);
    PlacedCurve placed = pipeline->place(labels == nullptr ? keys : Labels::observe(labels, keys));
    placed.batches = recorder.observe_rows(counted(std::move(placed.batches), rows, report));
    writer.write(printed(placed, plan, writer, labels, input.threads));
    recorder.end_curve();
    if (const std::string text = remainder_in_words(placed); !text.empty()) report.note(path, text);
    if (placed.facts.step && plan.sampling.end != EndPolicy::drop) {
      report.note(path, fmt::format("the step is {}", time_text(*placed.facts.step)));
    }
  }
  recorder.end_input();
  if (curves.skipped() > 0) report.note(path, fmt::format("rows left out for missing numbers: {}", curves.skipped()));
  return rows;
}

/// An output made again by another version may have other digits.
void warn_of_other_maker(const Job& plan) {
  if (!plan.meta || plan.meta->from.empty() || plan.meta->earlier.program == plan.meta->meta.program) return;
  if (plan.verbosity.quiet) return;
  (void)std::fputs(fmt::format("{}: warning: made by {}; this is {}, whose digits may differ\n", plan.meta->from,
                               plan.meta->earlier.program, plan.meta->meta.program)
                       .c_str(),
                   stderr);
}

void explain(const Inputs& inputs, const Job& plan) {
  Output output("-");
  for (const InputFile& file : inputs.files) {
    in_file(shown_name(file.path), [&] { output.write(explanation(file.path, plan)); });
  }
  output.commit();
}

/// An output for each file.
Exit resample_each(const Inputs& inputs, const Job& plan, unsigned threads, Report& report) {
  make_folder(*plan.output_folder);
  const WriterOptions options = writer_options(plan);
  const auto convert = [&](const InputFile& file, unsigned inner_threads) {
    const std::string path = output_path(file, plan);
    if (file.inside > 0) make_folder(folder_of(path));
    Writer writer(options, path);
    const std::uint64_t rows = resample_file(file.path, plan, inner_threads, report, writer);
    writer.commit();
    return rows;
  };
  const InputFile& first = inputs.files.front();
  if (inputs.files.size() + inputs.left_alone == 1 && !first.is_current) {  // its errors are the program's
    in_file(shown_name(first.path), [&] { convert(first, threads); });
    return Exit::done;
  }
  const Summary summary = convert_all(inputs, plan, threads, report, convert);
  report.summary(summary);
  return summary.failed == 0 ? Exit::done : Exit::data;
}

/// One output for all files.
void resample_together(const Inputs& inputs, const Job& plan, unsigned threads, Report& report) {
  const WriterOptions options = writer_options(plan);
  Writer writer(options, plan.output);
  for (const InputFile& file : inputs.files) {
    in_file(shown_name(file.path), [&] { resample_file(file.path, plan, threads, report, writer); });
    report.add_file(file.size);
  }
  writer.commit();
}

}  // namespace

Exit resample(const Job& plan) {
  const unsigned threads = plan.threads();
  const ThreadLimit limit(threads);
  const Inputs inputs = find_inputs(plan);
  if (plan.explain) {
    explain(inputs, plan);
    return Exit::done;
  }
  warn_of_other_maker(plan);
  Report report(plan.verbosity);
  std::uintmax_t bytes = 0;
  for (const InputFile& file : inputs.files) bytes += file.size;
  report.expect(inputs.files.size(), bytes);
  if (plan.output_folder) return resample_each(inputs, plan, threads, report);
  resample_together(inputs, plan, threads, report);
  return Exit::done;
}

}  // namespace tcb
