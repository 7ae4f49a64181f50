// Plot: pictures of curves and their samples, from the bytes of keys to the bytes of SVG.
#include "plot/plot_job.hpp"
#include "formats/formats.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "error.hpp"
#include "io/atomic_output.hpp"
#include "io/input_file.hpp"
#include "keys/curves.hpp"
#include "numbers/print_number.hpp"
#include "picture/picture.hpp"
#include "picture/scene.hpp"
#include "read/input.hpp"
#include "read/input_options.hpp"
#include "run/batch.hpp"
#include "run/curve_pipeline.hpp"
#include "run/file_notes.hpp"
#include "run/progress.hpp"
#include "sample/build.hpp"
#include "sample/request.hpp"
#include "sample/rows.hpp"
#include "sample/table.hpp"
#include "schema/schema.hpp"
#include "tcb/spline/rules.hpp"
#include "text/suggest.hpp"

namespace tcb {

namespace {

std::string counted(std::uint64_t count, std::string_view what) {
  return fmt::format("{} {}{}", with_thousands(count), what, count == 1 ? "" : "s");
}

/// A sample from its time, its position, and the velocities and angular velocities there, one after another.
SceneSample sample_of(std::span<const Cell> cells, const CurveSegment& segment) {
  const std::size_t channels = segment.cubics.size();
  SceneSample sample{cells[0], {}, std::vector<double>(channels)};
  for (const Cell& cell : cells.subspan(1, channels)) sample.position.push_back(cell.hi);
  std::size_t next = 1 + channels;
  const std::vector<bool> are_in_rotations = spline::in_rotations(segment.rotation_columns, channels);
  for (std::size_t i = 0; i < channels; ++i) {
    if (!are_in_rotations[i]) sample.velocity[i] = cells[next++].hi;
  }
  for (const auto& rotation : segment.rotation_columns) {
    const auto [x, y, z, w] = rotation.channels;
    const std::vector<double>& q = sample.position;
    const spline::Quaternion<double> rate{cells[next].hi, cells[next + 1].hi, cells[next + 2].hi, 0};
    const auto doubled = rate * spline::Quaternion<double>{q[x], q[y], q[z], q[w]};
    sample.velocity[x] = doubled.x / 2;
    sample.velocity[y] = doubled.y / 2;
    sample.velocity[z] = doubled.z / 2;
    sample.velocity[w] = doubled.w / 2;
    next += 3;
  }
  return sample;
}

/// The samples of a block, each with its position and velocity.
void append_samples(std::vector<SceneSample>& samples, const Evaluate& evaluate, const SampleBlock& block,
                    const std::vector<FirstRotation>& firsts) {
  const std::array chosen{field_of("time"), field_of("position"), field_of("velocity"), field_of("angular_velocity")};
  const Table table = evaluate(block, chosen);
  const std::size_t rows = block.rows();
  const std::size_t width = rows == 0 ? 0 : table.cells.size() / rows;
  for (std::size_t row = 0; row < rows; ++row) {
    samples.push_back(sample_of(std::span(table.cells).subspan(row * width, width), block.parts.front().segment));
    add_angles(samples.back(), firsts);
  }
}

/// The rules of rotations that differ from those of the preset.
void append_rotation_rules(std::vector<std::string>& words, const CurveSpec& spec,
                           const spline::RotationRules& of_preset) {
  const spline::CurveRules<double>& rules = spec.rules;
  const auto& [curve, tangents, ends] = rules.rotation_rules;
  if (curve != of_preset.curve) words.push_back(fmt::format("rotation curve {}", name_of(curve)));
  if (tangents != of_preset.tangents) {
    words.push_back(fmt::format("rotation tangents {}", name_of(tangents.value_or(rules.tangents))));
  }
  if (!spec.closed && ends != of_preset.ends) {
    words.push_back(fmt::format("rotation ends {}", name_of(ends.value_or(rules.start.rule))));
  }
}

/// The rules of a curve in words: the preset, or its tangents and ends where they differ, and further rules.
std::string short_rules(const CurveSpec& spec) {
  const spline::CurveRules<double>& rules = spec.rules;
  const auto preset = std::ranges::find(spline::presets, spec.preset, &spline::PresetRow::id);
  const bool has_ends = spec.closed || (rules.start.rule == preset->ends && rules.end.rule == preset->ends);
  std::vector<std::string> words;
  if (rules.tangents == preset->tangents && has_ends) {
    words.push_back(fmt::format("preset {}", preset->name));
  } else {
    words.push_back(fmt::format("tangents {}", name_of(rules.tangents)));
    if (!spec.closed) words.push_back(fmt::format("ends {}, {}", name_of(rules.start.rule), name_of(rules.end.rule)));
    if (rules.timing != spline::Timing::even) words.push_back(fmt::format("timing {}", name_of(rules.timing)));
  }
  if (spec.closed) words.emplace_back("closed");
  if (rules.equal_speed) words.emplace_back("equal speed");
  if (rules.no_overshoot) words.emplace_back("no overshoot");
  if (!rules.rotations.empty()) append_rotation_rules(words, spec, preset->rotations);
  if (!spec.timed) words.push_back(fmt::format("parameter {}", spec.parameter ? spec.parameter->name : "uniform"));
  return fmt::format("{}", fmt::join(words, ", "));
}

class Drawing {
 public:
  /// The options outlive this.
  Drawing(const PictureOptions& options, const SamplingRequest& samples, std::string path)
      : options_(options), samples_(samples), output_(std::move(path)) {}

  /// Begins the curves of the next file; `rules` are those of its first curve. Throws: Error if they have other columns
  /// than the previous curves, lack the requested axes, or are too many.
  void begin(const std::string& path, const Schema& schema, const CurveSpec& spec) {
    const std::string name = shown_name(path);
    files_.push_back(name.substr(name.rfind('/') + 1));
    std::vector<std::string> columns{schema.time.name};
    columns.insert(columns.end(), schema.channels.begin(), schema.channels.end());
    if (columns_.empty()) {
      columns_ = std::move(columns);
      begin_scene(schema, spec);
    } else if (columns != columns_) {
      throw data_error(
          "the columns are {}; expected {}, as in the earlier files; give --output-dir FOLDER to draw a picture of "
          "each file",
          listed(columns), listed(columns_));
    }
  }

  /// Adds a curve with its rules in words, and counts its samples; if they are few, they are evaluated to be drawn.
  void add(const std::vector<std::string>& group, const StreamedCurve& streamed, const CurveSamples& samples,
           std::string rules) {
    if (curves_ > 0 && rules != rules_) rules = "several rules";
    rules_ = std::move(rules);
    const std::vector<FirstRotation> firsts = first_rotations(streamed.keys, channels_.rotations);
    SceneCurve curve{0, with_angles(streamed.keys, firsts),
                     with_rotations_as_cubics([streamed] { return streamed.segments(); }, channels_, firsts),
                     streamed.extent.closed};
    const bool is_drawn = curves_++ < Scene::most_curves;
    while (const std::optional<SampleBlock> block = samples.blocks()) {
      curve.rows += block->rows();
      if (curve.rows > Scene::most_samples || !is_drawn) {
        curve.samples.clear();
      } else {
        append_samples(curve.samples, samples.evaluate, *block, firsts);
      }
    }
    rows_ += curve.rows;
    keys_ += curve.keys.size();
    if (!is_drawn) return;
    curve.name = name_of(group);
    scene_.curves.push_back(std::move(curve));
  }

  /// Draws, and ends the output. Throws: Error (usage) if it cannot be completed.
  void commit() {
    scene_.title = title();
    scene_.subtitle = subtitle();
    output_.write(picture(std::move(scene_), options_.size));
    output_.commit();
  }

 private:
  /// A rotation has one strip, for its angle, instead of those of its numbers, and the first one has axes along the
  /// path.
  void begin_scene(const Schema& schema, const CurveSpec& spec) {
    scene_.begin(schema, schema.channels, options_.axes, spec.rules.metric, spec.lacks_metric);
    channels_ = spec.channels();
    if (channels_.rotations.empty()) return scene_.require_few_strips();
    const std::vector<bool> are_in_rotations = spline::in_rotations(channels_.rotations, schema.channels.size());
    for (std::size_t i = 0; i < schema.channels.size(); ++i) {
      if (!are_in_rotations[i]) scene_.strips.push_back(i);
    }
    const auto place_in_space = [&](std::size_t channel) {
      return static_cast<std::size_t>(std::ranges::find(scene_.strips, channel) - scene_.strips.begin());
    };
    if (scene_.path) {
      const std::array axes{place_in_space((*scene_.path)[0]), place_in_space((*scene_.path)[1])};
      if (std::max(axes[0], axes[1]) < std::min<std::size_t>(scene_.strips.size(), 3)) {
        scene_.frame = {channels_.rotations[0].channels, axes};
      }
    }
    for (const RotationSchema& rotation : schema.rotations) {
      scene_.strips.push_back(scene_.channels.size());
      scene_.channels.push_back(
          fmt::format("angle from the first key, degrees ({})", fmt::join(rotation.given.columns, ", ")));
    }
    scene_.require_few_strips();
  }

  std::size_t name_of(const std::vector<std::string>& group) {
    std::vector<std::string_view> texts;
    texts.reserve(group.size());
    for (const std::string& text : group) texts.push_back(content(text));
    const std::string name = group.empty() ? files_.back() : fmt::format("{}", fmt::join(texts, ", "));
    const auto known = std::ranges::find(scene_.names, name);
    if (known == scene_.names.end()) {
      scene_.names.push_back(name);
      return scene_.names.size() - 1;
    }
    return static_cast<std::size_t>(known - scene_.names.begin());
  }

  std::string title() const {
    if (options_.title) return *options_.title;
    if (files_.size() < 2) return files_.empty() ? "" : files_.front();
    return fmt::format("{} and {} more", files_.front(), files_.size() - 1);
  }

  std::string subtitle() const {
    std::string text = fmt::format("{} · {} · {} · {}", rules_, counted(keys_, "key"), samples_in_words(samples_),
                                   counted(rows_, "row"));
    if (curves_ > scene_.curves.size()) text += fmt::format(" · {} of {} curves", scene_.curves.size(), curves_);
    return text;
  }

  const PictureOptions& options_;
  const SamplingRequest& samples_;
  Output output_;
  Scene scene_;
  std::vector<std::string> files_;    ///< names without their folders
  std::vector<std::string> columns_;  ///< of all files: the time and the channels
  CurveChannels channels_;
  std::string rules_;       ///< of the curves, in words
  std::size_t curves_ = 0;  ///< of all, also of those that are not drawn
  std::uint64_t rows_ = 0, keys_ = 0;
};

/// A picture of the curves of one file or of several.
class Picture final : public BatchOutput {
 public:
  Picture(const PlotJob& job, Report& report, const std::string& path)
      : job_(job), report_(report), drawing_(job.picture, job.samples.request, path) {}

  std::uint64_t add(const InputFile& file, unsigned threads) override {
    const bool live = is_live(file.path);
    const auto progress = report_.begin_file(file.path, file.size);
    FileNotes notes(report_, file.path);
    InputBytes opened = job_.keys.bytes_of(file.path);
    const Source<std::string> bytes = progress->observe_bytes(std::move(opened.bytes));
    InputOptions options = job_.keys.input;
    options.threads = job_.threads.for_reading(threads, live);
    const Input input = open_input(file.path, bytes, options);  // split, parse
    notes.add_input(input, job_.keys, job_.samples.request);
    Curves curves(input.schema, input.keys, job_.keys.curves, opened.arrive);  // group, order, split into curves
    std::uint64_t rows = 0;
    for (bool is_first = true; const std::optional<InputCurve> curve = curves.next(); is_first = false) {
      CurvePipeline pipeline = pipeline_of(input, *curve, options.threads);
      const CurveSpec& spec = pipeline.spec();
      if (is_first) drawing_.begin(file.path, input.schema, spec);
      const StreamedCurve streamed = pipeline.streamed(curve->keys);  // segments
      const bool has_samples = streamed.keys.size() > 1 || pipeline.needs().single_key;
      CurveSamples samples = has_samples ? pipeline.samples(streamed) : CurveSamples::none();  // measure, place
      samples.blocks = progress->observe_rows(std::move(samples.blocks), samples.expected_rows, rows);
      drawing_.add(curve->group, streamed, samples, short_rules(spec));  // evaluate, draw
      notes.add_samples(samples, job_.samples.request, spec.closed);
    }
    notes.end(curves, job_.keys);
    return rows;
  }

  void commit() override { drawing_.commit(); }

 private:
  CurvePipeline pipeline_of(const Input& input, const InputCurve& curve, unsigned threads) const {
    const CurveRequest request{.samples = job_.samples.of(curve, input.schema),
                               .rules = job_.keys.rules,
                               .fields = {field_of("time"), field_of("position")},
                               .threads = threads};
    return {request, input.schema, input.keys.traits, *curve.curve_info, curve.part};
  }

  const PlotJob& job_;
  Report& report_;
  Drawing drawing_;
};

}  // namespace

Exit plot(const PlotJob& job) {
  Report report(job.verbosity);
  return convert_files(job, report,
                       [&](const std::string& path) { return std::make_unique<Picture>(job, report, path); });
}

}  // namespace tcb
