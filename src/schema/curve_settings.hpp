// Curve settings: how the keys of an input make curves, as options and inputs say it, and where a setting comes from.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "error.hpp"
#include "numbers/rational.hpp"
#include "text/suggest.hpp"

namespace tcb::spline {  // in tcb/spline/rules.hpp
enum class EndRule : std::uint8_t;
enum class Preset : std::uint8_t;
enum class RotationCurve : std::uint8_t;
enum class TangentRule : std::uint8_t;
enum class Timing : std::uint8_t;
}  // namespace tcb::spline

namespace tcb {

/// The treatment of keys with equal times.
enum class Duplicates { error, first, last, break_curve, spread };
inline constexpr auto duplicates_names = std::to_array<Named<Duplicates>>({{"error", Duplicates::error},
                                                                           {"first", Duplicates::first},
                                                                           {"last", Duplicates::last},
                                                                           {"break", Duplicates::break_curve},
                                                                           {"spread", Duplicates::spread}});

/// How the keys of an input are arranged and divided into curves.
struct CurveOptions {
  Duplicates duplicates = Duplicates::error;
  bool sort = false;
  std::optional<Rational> max_gap = {};  ///< where keys are further apart in time, a new curve begins
  bool is_max_gap_in_seconds = false;    ///< it is a duration, not in the unit of the times
  bool any_order = false;                ///< keys stay in the order of the input, whatever their times
};

/// Where a setting comes from: an option, or a member of JSON at a text position.
struct SettingOrigin {
  std::string subject;  ///< the name of the option or the member
  TextPosition position = {};

  /// The exit code of an error about the setting.
  Exit exit() const { return position.line == 0 ? Exit::usage : Exit::data; }
  /// An error about the setting, with that code.
  Error error(const Error& fault) const { return Error(exit(), fault.message()).about(subject).at(position); }
};

/// A setting that errors may be about.
template <class T>
struct Setting {
  T value;
  SettingOrigin origin = {};
};

using MetricSetting = Setting<std::vector<std::string>>;  ///< channels by name or number; or "all"

/// The rule at one end of a curve, and the velocity there if it takes one.
struct EndSetting {
  spline::EndRule rule;
  std::vector<double> velocity = {};  ///< one number per channel
};
struct EndsSetting {
  EndSetting first, last;
};

struct PeriodSetting {
  Rational value;
  bool in_seconds = false;  ///< it is a duration, not in the unit of the times
};

/// What makes the times of keys without any: an exponent of the distances between them.
struct ParameterSetting {
  double exponent;
  std::string name;  ///< as given
};
inline constexpr auto parameter_names =
    std::to_array<Named<double>>({{"uniform", 0}, {"chordal", 1}, {"centripetal", 0.5}});

/// What happens at times outside the keys.
enum class Extrapolation { error, hold, linear, repeat, offset, oscillate };

/// In the order of the enumeration; the first is the default.
inline constexpr auto extrapolations = std::to_array<Named<Extrapolation>>({{"error", Extrapolation::error},
                                                                            {"hold", Extrapolation::hold},
                                                                            {"linear", Extrapolation::linear},
                                                                            {"repeat", Extrapolation::repeat},
                                                                            {"offset", Extrapolation::offset},
                                                                            {"oscillate", Extrapolation::oscillate}});
constexpr std::string_view name_of(Extrapolation rule) { return extrapolations[static_cast<std::size_t>(rule)].name; }

/// What happens before the first key, and after the last one.
struct Extrapolations {
  Extrapolation before = Extrapolation::error, after = Extrapolation::error;

  bool extend_curve() const { return before != Extrapolation::error || after != Extrapolation::error; }
};

/// Times that are multiplied by a factor, from one on that stays.
struct Retiming {
  Rational factor, origin;
};

/// The settings of a curve.
struct CurveSettings {
  std::optional<spline::Preset> preset;
  std::optional<spline::TangentRule> tangents;
  std::optional<Setting<EndsSetting>> ends;
  std::optional<Setting<bool>> closed;
  std::optional<Setting<PeriodSetting>> period;  ///< implies closed
  std::optional<ParameterSetting> parameter;
  std::optional<Extrapolations> extrapolate;
  std::optional<MetricSetting> metric;
  std::optional<spline::RotationCurve> rotation_curve = {};
  std::optional<spline::Preset> rotation_preset = {};  ///< whose rules of rotations replace tangents and ends for these
  std::optional<spline::Timing> timing = {};           ///< nothing: that of the preset
  bool equal_speed = false;
  bool no_overshoot = false;
  bool no_ease = false;
  std::optional<Retiming> retiming = {};
};

/// The value of a setting in a text. Throws: Error (usage), which the caller makes one about the option or the member.
spline::Preset preset_in(std::string_view text);

/// What serves in place of a preset that people expect under this name, and that there is not; or "".
std::string_view in_place_of_preset(std::string_view name);
spline::TangentRule tangents_in(std::string_view text);
EndsSetting ends_in(std::string_view text);              ///< RULE or RULE,RULE
PeriodSetting period_in(std::string_view text);          ///< a decimal, a ratio or a duration
ParameterSetting parameter_in(const std::string& text);  ///< a name or an exponent
Error too_many_rules(std::size_t rules);

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
