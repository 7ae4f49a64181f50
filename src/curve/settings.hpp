// What is said about a curve, by name: on the command line, or beside the keys in JSON.
#pragma once

#include <optional>
#include <string>

namespace tcb {

struct CurveSettings {
  std::optional<std::string> preset;
  std::optional<std::string> tangents;
  std::optional<std::string> ends;  ///< RULE[,RULE]
  std::optional<bool> closed;
  std::optional<std::string> period;     ///< a decimal or a ratio; implies closed
  std::optional<std::string> parameter;  ///< where keys carry no times: uniform, chordal, centripetal, or an exponent
  std::optional<std::string> extrapolate;
  std::optional<std::string> metric;  ///< names or numbers of channels, apart by commas
  bool equal_speed = false;
  bool no_ease = false;
};

/// These settings, and where they are silent those beside the keys. A preset silences all rules beside the keys.
inline CurveSettings over(CurveSettings settings, const CurveSettings& curve_info) {
  const auto fill = [](auto& wanted, const auto& other) {
    if (!wanted) wanted = other;
  };
  const bool closed_given = settings.closed.has_value() || settings.period.has_value();
  if (!settings.preset) {
    settings.preset = curve_info.preset;
    fill(settings.tangents, curve_info.tangents);
    fill(settings.ends, curve_info.ends);
  }
  if (!closed_given) {
    settings.closed = curve_info.closed;
    settings.period = curve_info.period;
  } else if (settings.closed.value_or(true)) {
    fill(settings.period, curve_info.period);
  }
  return settings;
}

}  // namespace tcb
