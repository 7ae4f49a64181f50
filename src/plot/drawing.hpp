// Drawing: the scene of the curves of files, and its picture.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "io/atomic_output.hpp"
#include "plot/picture.hpp"
#include "plot/scene.hpp"
#include "run/curve_pipeline.hpp"
#include "sample/request.hpp"
#include "schema/schema.hpp"

namespace tcb {

/// One picture of the curves of one file or of several.
class Drawing {
 public:
  /// The options outlive this.
  Drawing(const PictureOptions& options, const SamplingRequest& samples, std::string path)
      : options_(options), samples_(samples), output_(std::move(path)) {}

  /// Begins the curves of the next file; `rules` are those of its first curve. Throws: Error if they have other columns
  /// than the previous curves, lack the requested axes, or are too many.
  void begin(const std::string& path, const Schema& schema, const RuleFacts& rules);

  /// Adds a curve with its rules in words, and counts its samples; if they are few, they are evaluated to be drawn.
  void add(const std::vector<std::string>& group, const StoredCurve& stored, std::string rules);

  /// Draws, and ends the output. Throws: Error (usage) if it cannot be completed.
  void commit();

 private:
  void begin_scene(const Schema& schema, const CurveSpec& spec);
  std::size_t name_of(const std::vector<std::string>& group);
  std::string title() const;
  std::string subtitle() const;

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

/// The rules of a curve in words: the preset, or its tangents and ends where they differ, and further rules.
std::string short_rules(const RuleFacts& facts);

}  // namespace tcb
