// Camera path: the texts around the cameras of nerfstudio, and the rate of its frames.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "numbers/rational.hpp"
#include "sample/table.hpp"
#include "write/layout.hpp"
#include "write/output_format.hpp"

namespace tcb {
namespace {

/// The members that the viewer and the renderer need.
constexpr const char* usual_members =
    R"({"keyframes":[],"camera_type":"perspective","render_height":1080,"render_width":1920,"is_cycle":false,)"
    R"("smoothness_value":0})";

/// The least number of seconds in which int(seconds * rate), computed in doubles, is this number of frames.
double least_seconds(const Rational& frames, const Rational& exact_rate) {
  const double count = nearest_double(frames), rate = nearest_double(exact_rate);
  double seconds = nearest_double(frames / exact_rate);
  while (seconds * rate < count) seconds = std::nextafter(seconds, std::numeric_limits<double>::infinity());
  while (seconds > 0 && std::nextafter(seconds, 0) * rate >= count) seconds = std::nextafter(seconds, 0);
  return seconds;
}

/// One row after the other is a camera, {"camera_to_world": 16 numbers, "fov", "aspect"}. The cameras are played in
/// seconds n h, with n their number and h the mean duration between them, as nerfstudio plays n = int(seconds * fps)
/// frames at times i h.
/// Source: the viewer of nerfstudio, which reads and writes such files.
class CameraPath : public RowKeeper {
 public:
  /// `members`: those of a camera path that was read, as in Schema; empty: one without keyframes.
  explicit CameraPath(const std::string& members) {
    auto all = nlohmann::ordered_json::parse(members.empty() ? usual_members : members);
    const auto usual = nlohmann::ordered_json::parse(usual_members);
    for (const auto& [name, value] : usual.items()) {
      if (!all.contains(name)) all[name] = value;
    }
    const auto size = [&](const char* name) { return all[name].is_number() ? all[name].get<double>() : 0.0; };
    const double height = size("render_height");
    aspect_ = height > 0 ? size("render_width") / height : 1;
    members_ = for_pages(all.dump());
  }

  void complete(Layout& layout) const override {
    layout.head = members_.substr(0, members_.size() - 1) + ",\"camera_path\":[\n";
    layout.row_end = fmt::format(",\"aspect\":{}}}", aspect_);
  }

  /// Requires: the first cell of each row is its time.
  void observe(const Table& rows, std::size_t cells_per_row) override {
    if (rows.cells.empty()) return;
    const Cell first = rows.cells.front(), last = rows.cells[rows.cells.size() - cells_per_row];
    const std::lock_guard lock(mutex_);
    first_ = rows_ == 0 ? first : std::min(first_, first);
    last_ = rows_ == 0 ? last : std::max(last_, last);
    rows_ += rows.cells.size() / cells_per_row;
  }

  /// Instead of frames at the mean duration between rows.
  void set_frames(const PlayedFrames& frames) override { frames_ = frames; }

  std::string tail(const Rational& unit) override {
    const Rational duration = (exact_time(last_) - exact_time(first_)) * unit;
    const Rational mean = rows_ > 1 && duration > 0 ? Rational(rows_ - 1) / duration : Rational(1);
    const PlayedFrames frames = frames_.value_or(PlayedFrames{mean});
    const double seconds =
        frames.seconds ? nearest_double(*frames.seconds) : least_seconds(Rational(rows_), frames.rate);
    return fmt::format(",\"fps\":{},\"seconds\":{}}}\n", nearest_double(frames.rate), seconds);
  }

 private:
  std::string members_;
  double aspect_ = 0;
  std::mutex mutex_;
  std::uint64_t rows_ = 0;
  Cell first_{}, last_{};  ///< times
  std::optional<PlayedFrames> frames_;
};

/// The rows, each the 12 numbers of the first three rows of the matrix, and the field of view.
Layout camera_layout(const std::vector<OutputColumn>& columns, const TextMarks&, bool) {
  Layout layout;
  layout.before.assign(columns.size(), ",");
  layout.before.front() = "{\"camera_to_world\":[";
  constexpr std::size_t of_matrix = 12;
  for (std::size_t i = of_matrix; i < columns.size(); ++i) {
    layout.before[i] = (i == of_matrix ? ",0,0,0,1]," : ",") + json_text(columns[i].name) + ":";
  }
  layout.row_end = "}";
  layout.empty = "null";
  layout.between_rows = ",\n";
  layout.tail = "\n]";
  layout.no_rows = "]";
  return layout;
}

}  // namespace

extern const OutputFormat camera_path_output{
    .layout = camera_layout,
    .keeper = [](const Schema& schema, std::span<const std::size_t>) -> std::unique_ptr<RowKeeper> {
      return std::make_unique<CameraPath>(schema.camera_path);
    },
    .has_groups = false,
    .has_labels = false};

}  // namespace tcb
