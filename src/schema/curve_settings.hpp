// Curve settings: the settings of a curve as they are given, and where they come from.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "error.hpp"
#include "numbers/rational.hpp"

namespace tcb::spline {
enum class Preset : std::uint8_t;  // in tcb/spline/rules.hpp
enum class Timing : std::uint8_t;
}  // namespace tcb::spline

namespace tcb {

/// Where a setting comes from: an option, or a member of JSON at a text position.
struct SettingOrigin {
  std::string_view subject;  ///< the name of the option or the member
  TextPosition position = {};

  /// The exit code of an error about the setting.
  Exit exit() const { return position.line == 0 ? Exit::usage : Exit::data; }
};

template <class T>
struct Setting {
  T value;
  SettingOrigin origin = {};
};
using TextSetting = Setting<std::string>;

/// Settings of a curve as values of options or JSON members, before names are looked up.
/// Times that are multiplied by a factor, from one on that stays.
struct Retiming {
  Rational factor, origin;
};

struct CurveSettings {
  std::optional<TextSetting> preset;
  std::optional<TextSetting> tangents;
  std::optional<TextSetting> ends;  ///< RULE[,RULE]
  std::optional<Setting<bool>> closed;
  std::optional<TextSetting> period;     ///< a decimal or a ratio; implies closed
  std::optional<TextSetting> parameter;  ///< for keys without times: uniform, chordal, centripetal, or an exponent
  std::optional<TextSetting> extrapolate;
  std::optional<TextSetting> metric;  ///< names or numbers of channels, separated by commas
  std::optional<TextSetting> rotation_curve = {};
  std::optional<spline::Preset> rotation_preset = {};  ///< whose rules of rotations replace tangents and ends for these
  std::optional<spline::Timing> timing = {};           ///< nothing: that of the preset
  bool equal_speed = false;
  bool no_overshoot = false;
  bool no_ease = false;
  std::optional<Retiming> retiming = {};
};

/// The frames in which a viewer plays a curve: one at 0, step, 2 step, ... in the unit of the times.
struct ViewerFrames {
  Rational rate, seconds;  ///< frames per second, and how long all are shown, as the input says
  std::uint64_t count = 0;
  Rational step;
};

/// The information of an input about a curve, besides its keys.
struct CurveInfo {
  CurveSettings settings;
  std::optional<ViewerFrames> frames = {};
  std::vector<std::pair<std::string, TextPosition>> places = {};  ///< the text position of each setting
  std::string id = {};                                            ///< a text as in schema/texts.hpp
};

}  // namespace tcb
