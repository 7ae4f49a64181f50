// ASE: the controllers of objects in the ASCII export of 3ds Max as keys.
//
// Each object has the tracks position, rotation and scale that its controllers give, by TCB keys, linear keys or
// samples; between linear keys and between samples the curve is straight. Times are converted from ticks to seconds.
// Rotations are as in .3ds files. The preset is 3dsmax. Bezier keys have no documented unit of their tangents, and are
// refused. Source: the exporter among the samples of the 3ds Max SDK.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "read/scenes/text_lines.hpp"
#include "read/scenes/tracks.hpp"
#include "tcb/spline/rules.hpp"

namespace tcb {
namespace {

/// The keys of a track, whose lines begin with *CONTROL_TCB_WORD_KEY, *CONTROL_WORD_KEY or *CONTROL_WORD_SAMPLE.
struct AseTrack {
  std::string_view word, name;
  std::size_t numbers;  ///< of a value
  std::vector<std::string_view> channels;
};
const std::array<AseTrack, 5> ase_tracks{{
    {"POS", "position", 3, {"x", "y", "z"}},
    {"ROT", "rotation", 4, {"axis_x", "axis_y", "axis_z", "angle"}},
    {"SCALE", "scale", 7, {"x", "y", "z"}},
    {"FLOAT", "value", 1, {"value"}},
    {"POINT3", "color", 3, {"red", "green", "blue"}},
}};

/// Gives straight spans to the keys of a channel.
void make_linear(TrackChannel& channel) {
  require_increasing_times(channel);
  std::vector<TrackSpan> spans;
  for (std::size_t i = 0; i + 1 < channel.keys.size(); ++i) {
    const TrackKey &key = channel.keys[i], &next = channel.keys[i + 1];
    const Rational slope =
        (exact_number(next.value) - exact_number(key.value)) / (exact_number(next.time) - exact_number(key.time));
    spans.push_back({TrackSpan::Kind::cubic, slope, slope});
  }
  if (!spans.empty()) set_spans(channel, spans);
}

/// Reads the objects of an export.
class AseExport {
 public:
  AseExport(std::string_view text, MemoryUse& memory) : lines_(text), memory_(memory) {}

  std::vector<Track> read() {
    lines_.require_next();
    if (lines_.word(0) != "*3DSMAX_ASCIIEXPORT")
      throw lines_.at(
          data_error("the text is not an ASCII export of 3ds Max; expected *3DSMAX_ASCIIEXPORT in its first line; give "
                     "another --input-format"));
    while (lines_.next()) read_line();
    end_track();
    return std::move(tracks_);
  }

 private:
  void read_line() {
    const std::string_view word = lines_.word(0);
    if (word == "*SCENE_FRAMESPEED") {
      rate_ = positive(1);
    } else if (word == "*SCENE_TICKSPERFRAME") {
      ticks_ = positive(1);
    } else if (word == "*NODE_NAME") {
      name_object();
    } else if (word.find("BEZIER") != std::string_view::npos && word.ends_with("_KEY")) {
      throw lines_
          .at(data_error("the controller has Bezier keys, whose tangents have no documented unit; expected TCB or "
                         "linear keys, or samples; change the controller in 3ds Max, or export samples"))
          .about(object_);
    } else if (word.starts_with("*CONTROL_") && lines_.words().back() == "{") {
      end_track();  // the keys of a controller follow
    } else if (word.starts_with("*CONTROL_")) {
      read_key(word.substr(word.find('_') + 1));
    }
  }

  WrittenNumber positive(std::size_t word) const {
    WrittenNumber number = lines_.number_in(word);
    if (!(number.value > 0)) throw lines_.at(number_of_file_expected(lines_.word(word)));
    return number;
  }

  /// The name of a node, which is in quotes. It is repeated in the animation of the node.
  void name_object() {
    std::string_view name = lines_.from_word(1);
    if (name.size() > 1 && name.starts_with('"') && name.ends_with('"')) name = name.substr(1, name.size() - 2);
    end_track();
    object_ = name;
  }

  void read_key(std::string_view word) {
    const bool is_tcb = word.starts_with("TCB_"), is_sample = !is_tcb && word.ends_with("_SAMPLE");
    if (is_tcb) word.remove_prefix(4);
    if (!is_sample && !word.ends_with("_KEY")) return;
    const auto kind = std::ranges::find(ase_tracks, word.substr(0, word.rfind('_')), &AseTrack::word);
    if (kind == ase_tracks.end()) return;
    if (!track_ || track_->name != kind->name || is_tcb_ != is_tcb) begin_track(*kind, is_tcb, is_sample);
    TrackKey key;
    key.line = lines_.number();
    key.time = written_number(exact_number(lines_.number_in(1)) / exact_number(ticks_) / exact_number(rate_));
    std::size_t next = 2 + kind->numbers;
    if (is_tcb) {
      for (WrittenNumber* const number : {&key.tension, &key.continuity, &key.bias, &key.ease_in, &key.ease_out}) {
        *number = lines_.number_in(next++);
      }
      track_->has_ease = track_->has_ease || key.ease_in.value != 0 || key.ease_out.value != 0;
    }
    lines_.require_end(next);
    memory_.add(memory_of_key * track_->channels.size());
    for (std::size_t i = 0; i < track_->channels.size(); ++i) {
      key.value = lines_.number_in(2 + i);
      if (track_->rotation && i == angle) key.value = written_number(-exact_number(key.value));
      track_->channels[i].keys.push_back(key);
    }
  }

  void begin_track(const AseTrack& kind, bool is_tcb, bool is_sample) {
    end_track();
    track_ = Track{object_, std::string(kind.name)};
    is_tcb_ = is_tcb;
    for (const std::string_view name : kind.channels) track_->channels.push_back({std::string(name)});
    track_->is_recording = is_sample;
    track_->settings.preset = spline::Preset::max3ds;
    if (kind.name != "rotation") return;
    track_->rotation = turns_around_axes(kind.channels);
    if (!is_tcb_) track_->settings.rotation_curve = spline::RotationCurve::slerp;
  }

  void end_track() {
    if (!track_) return;
    Track track = *std::exchange(track_, std::nullopt);
    try {
      if (!is_tcb_ && !track.rotation) std::ranges::for_each(track.channels, make_linear);
    } catch (const Error& error) {
      throw error.about(fmt::format("{}/{}", track.object, track.name));
    }
    const std::size_t number = ++names_[track.object + "/" + track.name];
    if (number > 1) track.object += fmt::format(" ({})", number);
    tracks_.push_back(std::move(track));
  }

  static constexpr std::size_t angle = 3;  ///< among the numbers of a rotation

  TextLines lines_;
  MemoryUse& memory_;
  WrittenNumber rate_{30, "30"}, ticks_{160, "160"};  ///< frames per second, ticks per frame
  std::string object_;
  bool is_tcb_ = false;
  std::optional<Track> track_;  ///< the current one
  std::map<std::string, std::size_t> names_;
  std::vector<Track> tracks_;
};

constexpr SceneFormat ase{[](std::string_view file, MemoryUse& memory) { return AseExport(file, memory).read(); }};

}  // namespace

extern const InputFormat ase_input =
    input_of_scenes<ase>([](std::string_view beginning) { return beginning.starts_with("*3DSMA"); });

}  // namespace tcb
