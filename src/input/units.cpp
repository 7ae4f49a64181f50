// Units and names of an input: factors of its numbers, the unit of its times, its rotations, and new names for its
// columns.
#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <vector>

#include "error.hpp"
#include "input/columns.hpp"
#include "input/input.hpp"
#include "text/suggest.hpp"

namespace tcb {
namespace {

/// Whether the times of these columns are frames that a rate turns into seconds.
bool is_converted(const InputOptions& options, const std::string& time) {
  if (!options.input_rate) return false;
  return !options.samples || unit_of_time(time) == TimeUnit::frames;
}

/// Throws: Error (data) where the column's name has another unit than the options.
void require_unit(const InputOptions& options, const std::string& time) {
  const auto named = unit_of_time(time);
  if (!named || options.samples) return;
  const auto refuse = [&](Option option, TimeUnit unit) {
    throw Error(Exit::data, ErrorCode::time_units_differ,
                {time, std::string(row_of(*named).name), std::string(row_of(unit).name)})
        .about(option);
  };
  if (options.input_rate && *named != TimeUnit::frames) refuse(Option::input_fps, TimeUnit::frames);
  if (options.time_unit && *options.time_unit != *named) refuse(Option::time_unit, *options.time_unit);
}

/// All names of an input.
std::vector<std::string*> names_of(Input& input) {
  std::vector<std::string*> names;
  if (input.timed) names.push_back(&input.time);
  const auto is_shown = [&](std::size_t channel) {
    return std::ranges::none_of(input.rotations, [&](const spline::RotationColumns& rotation) {
      return rotation.shown.form != spline::RotationForm::quaternion && rotation.has(channel);
    });
  };
  for (std::size_t i = 0; i < input.channels.size(); ++i) {
    if (is_shown(i)) names.push_back(&input.channels[i]);
  }
  for (auto& list : input.rotation_names) {
    for (std::string& name : list) names.push_back(&name);
  }
  for (auto* const list : {&input.groups, &input.carried}) {
    for (std::string& name : *list) names.push_back(&name);
  }
  return names;
}

/// Throws: Error (data) about an option by which two columns have the same name.
void require_other_names(Input& input, Option option) {
  std::vector<std::string> known;
  for (const std::string* name : names_of(input)) {
    if (std::ranges::count(known, *name) > 0) {
      throw Error(Exit::data, ErrorCode::same_column_names, {*name}).about(option);
    }
    known.push_back(*name);
  }
}

/// Throws: Error (data) for a name that no column has, and where two columns would have the same name.
void rename(Input& input, const std::vector<Renaming>& renamings) {
  const std::vector<std::string*> names = names_of(input);
  std::vector<std::string> before;
  before.reserve(names.size());
  for (const std::string* name : names) before.push_back(*name);
  for (const Renaming& renaming : renamings) {
    const auto found = std::ranges::find(before, renaming.from);
    if (found == before.end()) {
      throw Error(Exit::data, ErrorCode::no_such_column, {renaming.from, before}).about(Option::rename);
    }
    *names[static_cast<std::size_t>(found - before.begin())] = renaming.to;
  }
  require_other_names(input, Option::rename);
}

/// The index of a channel by its name, in any case if none has it exactly.
std::size_t requested_channel(const std::string& name, const std::vector<std::string>& channels,
                              Option option = Option::rotation) {
  const auto exact = std::ranges::find(channels, name);
  const auto found = exact != channels.end() ? exact : std::ranges::find_if(channels, [&](const std::string& channel) {
    return same_in_any_case(channel, name);
  });
  if (found != channels.end()) return static_cast<std::size_t>(found - channels.begin());
  throw Error(Exit::data, ErrorCode::no_such_column, {name, channels}).about(option);
}

/// The quaternions among channels by their names: those that differ in one letter alone, x, y, z or w, after a "q".
std::vector<spline::RotationColumns> rotations_by_name(const std::vector<std::string>& channels) {
  constexpr std::string_view letters = "xyzw";
  constexpr std::size_t none = static_cast<std::size_t>(-1);
  std::map<std::string, spline::RotationChannels> found;  // by the names without that letter
  for (std::size_t channel = 0; channel < channels.size(); ++channel) {
    const std::string name = in_lower_case(channels[channel]);
    for (std::size_t at = name.find('q'); at != std::string::npos && ++at < name.size();) {
      const std::size_t letter = letters.find(name[at]);
      if (letter == std::string_view::npos) continue;
      std::string others = name;
      others[at] = '*';
      auto& rotation = found.try_emplace(others, spline::RotationChannels{none, none, none, none}).first->second;
      rotation[letter] = channel;
    }
  }
  std::vector<spline::RotationColumns> rotations;
  for (const auto& [name, rotation] : found) {
    const auto missing = std::ranges::count(rotation, none);
    if (missing == 0) rotations.push_back({rotation});
    const bool is_quaternion = name[0] == 'q' && (name[1] == '*' || name[1] == '_' || name[1] == '.');
    if (missing != 1 || !is_quaternion) continue;
    std::vector<std::string> others;
    for (const std::size_t channel : rotation) {
      if (channel != none) others.push_back(channels[channel]);
    }
    std::string lacking = name;
    lacking[name.find('*')] = letters[static_cast<std::size_t>(std::ranges::find(rotation, none) - rotation.begin())];
    throw Error(Exit::data, ErrorCode::rotation_column_missing, {lacking, others}).about(Option::rotation);
  }
  std::ranges::sort(rotations, {},
                    [](const spline::RotationColumns& rotation) { return std::ranges::min(rotation.channels); });
  return rotations;
}

/// The names of the numbers of a rotation, where its columns give none; `number` follows where it is not empty.
std::vector<std::string> names_in(const spline::RotationNotation& notation, const std::string& number) {
  std::vector<std::string> names;
  switch (notation.form) {
    case spline::RotationForm::quaternion: names = {"qx", "qy", "qz", "qw"}; break;
    case spline::RotationForm::axis_angle: names = {"ax", "ay", "az", "angle"}; break;
    case spline::RotationForm::matrix: names = {"r11", "r12", "r13", "r21", "r22", "r23", "r31", "r32", "r33"}; break;
    case spline::RotationForm::euler:
      for (std::size_t i = 0; i < notation.axes.size(); ++i) {
        const bool is_named = notation.axes[0] != notation.axes[2];
        names.push_back(std::string("r") + (is_named ? "xyz"[notation.axes[i]] : "123"[i]));
      }
  }
  for (std::string& name : names) name += number;
  return names;
}

/// Adds a rotation with the requested columns. One with three columns gets a channel more.
void add_rotation(Input& input, const GivenRotation& request) {
  spline::RotationColumns rotation;
  const std::size_t given = request.columns.size();
  for (std::size_t i = 0; i < given; ++i) {
    rotation.channels[i] = requested_channel(request.columns[i], input.channels);
  }
  if (given == 3) {
    rotation.channels[3] = input.channels.size();
    input.channels.push_back("rotation of " + input.channels[rotation.channels[0]]);
  }
  const auto relative =
      static_cast<std::size_t>(std::ranges::count(input.given_rotations, true, &GivenRotation::relative));
  if (request.relative) rotation.turn = relative;
  input.rotations.push_back(rotation);
  input.given_rotations.push_back(request);
  for (std::size_t i = 0; i < given; ++i) {
    input.given_rotations.back().columns[i] = input.channels[rotation.channels[i]];
  }
}

/// Sets the form in which rows show a rotation, and the names of its cells, those of the columns in their order if the
/// form is the given one.
void show_rotation(Input& input, std::size_t index, const spline::RotationNotation& shown) {
  spline::RotationColumns& rotation = input.rotations[index];
  rotation.shown = shown;
  const std::string number = input.rotations.size() == 1 ? "" : "_" + std::to_string(index + 1);
  std::vector<std::string> names = names_in(shown, number);
  if (shown == input.given_rotations[index].notation) {
    std::vector<std::size_t> columns(rotation.channels.begin(), rotation.channels.begin() + names.size());
    std::ranges::sort(columns);
    for (std::size_t i = 0; i < names.size(); ++i) {
      names[i] = input.channels[columns[i]];
      const auto cell = std::ranges::find(columns, rotation.channels[i]) - columns.begin();
      rotation.cells[i] = static_cast<std::uint8_t>(cell);
    }
  } else if (shown.form == spline::RotationForm::quaternion) {
    for (std::size_t i = 0; i < names.size(); ++i) input.channels[rotation.channels[i]] = names[i];
    return;
  }
  input.rotation_names[index] = std::move(names);
}

/// Throws: Error (data) where a column is in two rotations or angles.
void require_own_columns(const Input& input) {
  std::vector<bool> taken(input.channels.size());
  const auto take = [&](std::size_t channel, Option option) {
    if (taken[channel])
      throw Error(Exit::data, ErrorCode::rotation_columns_shared, {input.channels[channel]}).about(option);
    taken[channel] = true;
  };
  for (const spline::AngleChannel& angle : input.angles) take(angle.channel, Option::angle);
  for (const spline::RotationColumns& rotation : input.rotations) {
    for (const std::size_t channel : rotation.channels) take(channel, Option::rotation);
  }
}

}  // namespace

void set_units(KeyRules& rules, const InputOptions& options, const Columns& columns, std::string_view first_time) {
  const bool is_timed = columns.has(Role::time);
  if (is_timed) rules.notation = find_notation(first_time).value_or(TimeNotation::seconds);
  rules.frame_rate = options.input_rate;
  if (counts_frames(rules.notation) && !options.input_rate) {
    throw Error(Exit::data, ErrorCode::timecode_without_rate, {columns.time});
  }
  const bool is_number = rules.notation == TimeNotation::seconds;
  if (is_timed && is_number) require_unit(options, columns.time);
  const bool is_time_converted = is_timed && is_number && is_converted(options, columns.time);
  if (!is_time_converted && options.scales.empty()) return;
  const std::size_t channels = columns.channels.size();
  rules.factors.assign(NumberOfKey::position + channels * NumberOfKey::kinds, 1);
  if (is_time_converted) rules.factors[NumberOfKey::time] = Rational(1) / *options.input_rate;
  for (const ChannelScale& scale : options.scales) {
    const auto channel = std::ranges::find(columns.channels, scale.channel);
    if (channel == columns.channels.end()) {
      throw Error(Exit::data, ErrorCode::no_such_column, {scale.channel, columns.channels}).about(Option::scale);
    }
    rules.factors[NumberOfKey::position + static_cast<std::size_t>(channel - columns.channels.begin())] = scale.factor;
  }
  rules.factors[NumberOfKey::duration] = rules.factors[NumberOfKey::time];
  for (std::size_t i = 0; i < channels; ++i) {
    rules.factors[NumberOfKey::of_channel(NumberOfKey::end_position_of, i, channels)] =
        rules.factors[NumberOfKey::position + i];
    for (const auto kind : {NumberOfKey::velocity_in_of, NumberOfKey::velocity_out_of, NumberOfKey::end_velocity_of}) {
      rules.factors[NumberOfKey::of_channel(kind, i, channels)] =
          rules.factors[NumberOfKey::position + i] / rules.factors[NumberOfKey::time];
    }
  }
}

void set_rotations(Input& input, const RotationOptions& options) {
  input.normalize = options.normalize;
  for (const NamedAngle& angle : options.angles) {
    input.angles.push_back({requested_channel(angle.channel, input.channels, Option::angle), angle.degrees});
  }
  if (options.requests.empty() && !options.none) {
    input.rotations = rotations_by_name(input.channels);
    for (const spline::RotationColumns& rotation : input.rotations) {
      GivenRotation& given = input.given_rotations.emplace_back();
      for (const std::size_t channel : rotation.channels) given.columns.push_back(input.channels[channel]);
    }
  }
  for (GivenRotation request : options.requests) {
    request.notation.degrees = options.degrees;
    add_rotation(input, request);
  }
  require_own_columns(input);
  if (options.shown && input.rotations.empty()) {
    const auto form = std::ranges::find(rotation_forms, options.shown->form, &RotationFormName::form);
    throw Error(Exit::data, ErrorCode::no_rotation, {std::string(form->name)}).about(Option::rotation_output);
  }
  input.rotation_names.resize(input.rotations.size());
  for (std::size_t i = 0; i < input.rotations.size(); ++i) {
    const spline::RotationNotation& given = input.given_rotations[i].notation;
    spline::RotationNotation shown = options.as_curves ? spline::RotationNotation{} : options.shown.value_or(given);
    shown.degrees = options.degrees;
    if (shown.form != spline::RotationForm::quaternion || given.form != spline::RotationForm::quaternion) {
      show_rotation(input, i, shown);
    }
  }
  if (options.shown) require_other_names(input, Option::rotation_output);
}

void set_units_and_names(Input& input, const InputOptions& options) {
  if (!input.timed) {
    if (options.input_rate || options.time_unit) {
      throw Error(Exit::data, ErrorCode::unit_without_times)
          .about(options.input_rate ? Option::input_fps : Option::time_unit);
    }
  } else {
    const bool is_number = input.time_notation == TimeNotation::seconds;
    input.time_unit = options.time_unit ? options.time_unit : unit_of_time(input.time);
    if (!is_number) {
      input.time_unit = TimeUnit::s;
      if (counts_frames(input.time_notation)) input.frame_rate = options.input_rate;
    } else if (is_converted(options, input.time)) {
      input.time_unit = TimeUnit::s;
      input.frame_rate = options.input_rate;
      if (unit_of_time(input.time) == TimeUnit::frames && !options.samples) input.time = "time";
    }
  }
  if (!options.renamings.empty()) rename(input, options.renamings);
}

}  // namespace tcb
