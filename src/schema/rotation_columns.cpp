// Rotation columns: which columns make rotations and angles, their channels, and the cells that show them.
#include "schema/columns.hpp"
#include "schema/schema.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "schema/usual_names.hpp"
#include "text/suggest.hpp"
#include "text/utf8.hpp"

namespace tcb {
namespace {

/// The number of the column of each channel, from 1.
std::vector<std::size_t> numbers_of_channels(const Columns& columns) {
  std::vector<std::size_t> numbers(columns.channels.size());
  for (std::size_t cell = 0; cell < columns.cells.size(); ++cell) {
    if (columns.cells[cell].role == Role::position) numbers[columns.cells[cell].channel] = cell + 1;
  }
  return numbers;
}

/// The index of a channel of keys as they are read: by its name, in any case if none has it exactly, by its name
/// without a unit, or else by the number of its column.
std::size_t requested_channel(const std::string& name, const Columns& columns, std::string_view option) {
  const std::vector<std::string>& channels = columns.channels;
  const auto exact = std::ranges::find(channels, name);
  const auto found = exact != channels.end() ? exact : std::ranges::find_if(channels, [&](const std::string& channel) {
    return same_in_any_case(channel, name);
  });
  if (found != channels.end()) return static_cast<std::size_t>(found - channels.begin());
  if (const auto channel = find_without_unit(channels, name)) return *channel;
  const std::vector<std::size_t> numbers = numbers_of_channels(columns);
  const auto number = in_digits<std::size_t>(name);
  const auto column = number ? std::ranges::find(numbers, *number) : numbers.end();
  if (column != numbers.end()) return static_cast<std::size_t>(column - numbers.begin());
  if (number && *number >= 1 && *number <= columns.cells.size()) {
    std::vector<std::string> others;
    others.reserve(numbers.size());
    for (const std::size_t other : numbers) others.push_back(std::to_string(other));
    throw data_error(
        "column {} is the time or has another role; expected one of the columns {}; give another number, or "
        "--parameter uniform if the keys have no times",
        name, listed(others))
        .about(option);
  }
  if (number && !columns.named) throw no_such_column_number(name, columns.cells.size()).about(option);
  if (std::ranges::count(columns.ignored, name) > 0 || find_without_unit(columns.ignored, name)) {
    throw data_error(
        "column {} is no position, as --columns chooses others; expected one of {}; add it to the positions in "
        "--columns",
        in_quotes(name), listed(channels))
        .about(option);
  }
  throw no_such_column(name, channels).about(option);
}

/// Replaces the name of an array, or of an object of x, y, z and w, by the columns of its numbers.
void find_elements(GivenRotation& request, const Columns& columns) {
  if (request.columns.size() != 1) return;
  std::vector<std::string> elements;
  std::ranges::copy_if(columns.channels, std::back_inserter(elements),
                       [&](const std::string& channel) { return is_element_of(request.columns[0], channel); });
  if (!elements.empty() && elements[0][request.columns[0].size()] == '.') {
    std::vector<std::string> letters;
    for (const char letter : std::string_view("xyzw").substr(0, elements.size())) {
      letters.push_back(fmt::format("{}.{}", request.columns[0], letter));
    }
    const bool are_letters = letters.size() == elements.size() && std::ranges::is_permutation(letters, elements);
    elements = are_letters ? std::move(letters) : std::vector<std::string>{};
  }
  const bool is_vector = request.notation.form == spline::RotationForm::axis_angle && elements.size() == 3;
  if (is_vector && !request.relative) request.notation.form = spline::RotationForm::rotation_vector;
  const std::size_t numbers = request.notation.numbers();
  if (elements.size() != numbers) {
    throw data_error("{} is {}; expected {}, or an array of {}; give the name of each number",
                     in_quotes(request.columns[0]),
                     elements.empty() ? "no array" : "an array of " + how_many(elements.size(), "number"),
                     how_many(numbers, "column"), numbers)
        .about("--rotation");
  }
  request.columns = std::move(elements);
}

/// Throws: Error (data) for four channels whose names have a number instead of x, y, z or w, as q0 to q3.
void require_letters(const std::vector<std::string>& channels) {
  std::map<std::string, std::map<char, std::string>> found;  // by stem and number
  for (const std::string& channel : channels) {
    std::string name = channel;  // q[0] as q0
    std::erase_if(name, [](char c) { return c == '[' || c == ']'; });
    const auto number = rotation_stem_of(name);
    if (number && number->second >= '0' && number->second <= '4') found[number->first][number->second] = channel;
  }
  for (const auto& [stem, numbered] : found) {
    if (numbered.size() != 4 || numbered.rbegin()->first - numbered.begin()->first != 3) continue;
    std::vector<std::string> names;
    for (const auto& [number, name] : numbered) names.push_back(name);
    const auto request = [&](std::size_t x, std::size_t y, std::size_t z, std::size_t w) {
      return "quaternion=" + names[x] + ":" + names[y] + ":" + names[z] + ":" + names[w];
    };
    throw data_error(
        "columns {} may be a quaternion, but their names do not tell which of them is w; expected names with x, y, z "
        "and w; give --rotation {} if it is {}, --rotation {} if it is {}, or --rotation none for plain channels",
        listed(names), in_shell(request(1, 2, 3, 0)), in_quotes(names.front()), in_shell(request(0, 1, 2, 3)),
        in_quotes(names.back()));
  }
}

/// The quaternions among channels by their names: those that differ in one letter alone, x, y, z or w, which is after a
/// "q" or after a usual name of rotations.
std::vector<spline::RotationChannels> rotations_by_name(const std::vector<std::string>& channels) {
  constexpr std::string_view letters = "xyzw";
  constexpr std::size_t none = static_cast<std::size_t>(-1);
  std::map<std::string, spline::RotationChannels> found;  // by the names without that letter
  const auto add = [&](std::string name, std::size_t at, std::size_t channel) {
    const std::size_t letter = letters.find(name[at]);
    if (letter == std::string_view::npos) return;
    name[at] = '*';
    auto& rotation = found.try_emplace(name, spline::RotationChannels{none, none, none, none}).first->second;
    rotation[letter] = channel;
  };
  for (std::size_t channel = 0; channel < channels.size(); ++channel) {
    const std::string name = in_lower_case(channels[channel]);
    for (std::size_t at = name.find('q'); at != std::string::npos && ++at < name.size();) add(name, at, channel);
    if (rotation_stem_of(name)) add(name, without_unit(name).size() - 1, channel);
  }
  std::vector<spline::RotationChannels> rotations;
  for (const auto& [name, rotation] : found) {
    const auto missing = std::ranges::count(rotation, none);
    if (missing == 0) rotations.push_back(rotation);
    const bool is_quaternion = name[0] == 'q' && (name[1] == '*' || name[1] == '_' || name[1] == '.');
    if (missing != 1 || !is_quaternion) continue;
    std::vector<std::string> others;
    for (const std::size_t channel : rotation) {
      if (channel != none) others.push_back(channels[channel]);
    }
    std::string lacking = name;
    lacking[name.find('*')] = letters[static_cast<std::size_t>(std::ranges::find(rotation, none) - rotation.begin())];
    throw data_error(
        "columns {} are three numbers of a quaternion, but there is no {}; expected four numbers; add the missing "
        "column, or give --rotation none to take the three as plain channels",
        listed(others), in_quotes(lacking));
  }
  std::ranges::sort(rotations, {}, [](const spline::RotationChannels& rotation) { return std::ranges::min(rotation); });
  return rotations;
}

/// The names of the numbers of a rotation, where its columns give none; `number` follows where it is not empty.
std::vector<std::string> names_in(const spline::RotationNotation& notation, const std::string& number) {
  std::vector<std::string> names;
  switch (notation.form) {
    case spline::RotationForm::quaternion: names = {"qx", "qy", "qz", "qw"}; break;
    case spline::RotationForm::rotation_vector: names = {"rx", "ry", "rz"}; break;
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

/// The index of the rotation whose numbers each channel of keys as they are read is one of; the number of rotations if
/// it is none.
std::vector<std::size_t> rotations_with(const std::vector<RotationSchema>& rotations, std::size_t channels) {
  std::vector<std::size_t> indices(channels, rotations.size());
  for (std::size_t i = rotations.size(); i-- > 0;) {  // the first one counts
    for (const std::size_t channel : rotations[i].given.channels) indices[channel] = i;
  }
  return indices;
}

/// Throws: Error (data) where a column is in two rotations or angles.
void require_own_columns(const Schema& schema, const Columns& columns) {
  std::vector<bool> taken(columns.channels.size());
  const auto take = [&](std::size_t channel, std::string_view option) {
    if (taken[channel])
      throw data_error(
          "column {} is used twice; expected different columns for each rotation and angle; name another column",
          in_quotes(columns.channels[channel]))
          .about(option);
    taken[channel] = true;
  };
  for (const AngleColumn& angle : schema.angles) take(angle.channel, "--angle");
  for (const RotationSchema& rotation : schema.rotations) {
    for (const std::size_t channel : rotation.given.channels) take(channel, "--rotation");
  }
}

/// Adds the channels of a quaternion in place of the columns of another form. They are named after these.
void add_quaternion(Schema& schema, RotationSchema& rotation) {
  const GivenRotation& given = rotation.given;
  for (std::size_t i = 0; i < rotation.columns.channels.size(); ++i) {
    rotation.columns.channels[i] = schema.channels.size();
    schema.channels.push_back(i < given.columns.size() ? given.columns[i] : "rotation of " + given.columns[0]);
    schema.sources.push_back(given.channels[0]);
  }
}

/// Sets the channels of keys with quaternions.
void set_channels(Schema& schema, const Columns& columns) {
  schema.channels.clear();
  const std::vector<std::size_t> rotations = rotations_with(schema.rotations, columns.channels.size());
  std::vector<std::size_t> now(columns.channels.size());  // the channel of each that is read
  for (std::size_t read = 0; read < now.size(); ++read) {
    now[read] = schema.channels.size();
    const std::size_t index = rotations[read];
    const bool is_plain = index == schema.rotations.size() || schema.rotations[index].given.notation.is_quaternion();
    if (is_plain) {
      schema.channels.push_back(columns.channels[read]);
      schema.sources.push_back(read);
    } else if (read == std::ranges::min(schema.rotations[index].given.channels)) {
      add_quaternion(schema, schema.rotations[index]);
    }
  }
  if (!rotations.empty() && rotations[0] < schema.rotations.size()) schema.time.likely.clear();
  for (AngleColumn& angle : schema.angles) angle.channel = now[angle.channel];
  for (RotationSchema& rotation : schema.rotations) {
    if (!rotation.given.notation.is_quaternion()) continue;
    std::ranges::transform(rotation.given.channels, rotation.columns.channels.begin(),
                           [&](std::size_t i) { return now[i]; });
  }
}

/// Sets where rows show the numbers of rotations: in the columns that give them, or another form in place of the first.
void set_places(Schema& schema, const Columns& columns) {
  const std::vector<std::size_t> rotations = rotations_with(schema.rotations, columns.channels.size());
  std::size_t next = 0;
  for (std::size_t read = 0; read < columns.channels.size(); ++read) {
    const std::size_t index = rotations[read];
    if (index == schema.rotations.size()) {
      ++next;
      continue;
    }
    const GivenRotation& given = schema.rotations[index].given;
    RotationColumns& rotation = schema.rotations[index].columns;
    const auto number = static_cast<std::size_t>(std::ranges::find(given.channels, read) - given.channels.begin());
    if (rotation.shown == given.notation) {
      rotation.places[number] = next++;
    } else if (read == std::ranges::min(given.channels)) {
      for (std::size_t i = 0; i < rotation.shown.numbers(); ++i) rotation.places[i] = next++;
    }
  }
}

/// Sets the form in which rows show a rotation, and the names of its numbers: those of the columns if it is the given
/// one.
void show_rotation(Schema& schema, std::size_t index, const spline::RotationNotation& shown) {
  RotationSchema& rotation = schema.rotations[index];
  const std::string number = schema.rotations.size() == 1 ? "" : "_" + std::to_string(index + 1);
  std::vector<std::string> names = shown == rotation.given.notation ? rotation.given.columns : names_in(shown, number);
  rotation.columns.shown = shown;
  if (shown.is_quaternion()) {
    for (std::size_t i = 0; i < names.size(); ++i) schema.channels[rotation.columns.channels[i]] = names[i];
  } else {
    rotation.names = std::move(names);
  }
}

/// Adds a rotation with channels of keys as they are read.
void add_rotation(Schema& schema, GivenRotation given, const Columns& columns) {
  RotationSchema rotation;
  const auto turns = std::ranges::count_if(schema.rotations, [](const auto& other) { return other.given.relative; });
  if (given.relative) rotation.columns.turn = static_cast<std::size_t>(turns);
  given.columns.clear();
  for (const std::size_t channel : given.channels) given.columns.push_back(columns.channels[channel]);
  rotation.given = std::move(given);
  schema.rotations.push_back(std::move(rotation));
}

/// Throws: Error (data) for angles that are in degrees by the name of their column.
void require_radians(const GivenRotation& rotation, const Columns& columns) {
  for (const std::size_t channel : rotation.channels) {
    const std::string& name = columns.channels[channel];
    if (!rotation.notation.has_angles() || !is_in_degrees(name)) continue;
    throw data_error(
        "column {} is in degrees by its name, but angles of rotations are in radians by default; expected their unit; "
        "give --angles degrees, or --angles radians if the name is wrong",
        in_quotes(name))
        .about("--rotation");
  }
}

}  // namespace

Schema with_rotations(Schema schema, const Columns& columns, const RotationOptions& options) {
  for (const NamedAngle& angle : options.angles) {
    schema.angles.push_back({{requested_channel(angle.channel, columns, "--angle"), angle.degrees}, false});
  }
  if (options.requests.empty() && !options.none) {
    require_letters(columns.channels);
    for (const spline::RotationChannels& channels : rotations_by_name(columns.channels)) {
      add_rotation(schema, {{}, false, {}, {channels.begin(), channels.end()}, options.normalize}, columns);
    }
  }
  for (GivenRotation request : options.requests) {
    request.notation.degrees = options.degrees.value_or(false);
    request.normalize = options.normalize;
    find_elements(request, columns);
    for (const std::string& column : request.columns) {
      request.channels.push_back(requested_channel(column, columns, "--rotation"));
    }
    if (!options.degrees) require_radians(request, columns);
    add_rotation(schema, std::move(request), columns);
  }
  require_own_columns(schema, columns);
  if (!options.shown_by_format && options.shown && schema.rotations.empty()) {
    const auto form = std::ranges::find(rotation_forms, options.shown->form, &Named<spline::RotationForm>::value);
    throw data_error("there is no rotation to show as {}; expected columns of a rotation; name them with --rotation",
                     form->name)
        .about("--rotation-output");
  }
  set_channels(schema, columns);
  for (std::size_t i = 0; i < schema.rotations.size(); ++i) {
    const spline::RotationNotation& given = schema.rotations[i].given.notation;
    spline::RotationNotation shown = options.as_curves ? spline::RotationNotation{} : options.shown.value_or(given);
    shown.degrees = options.degrees.value_or(false);
    if (!shown.is_quaternion() || !given.is_quaternion()) {
      show_rotation(schema, i, shown);
    }
  }
  set_places(schema, columns);
  if (options.shown) require_distinct_names(schema, "--rotation-output");
  return schema;
}

}  // namespace tcb
