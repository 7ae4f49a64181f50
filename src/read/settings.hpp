// Settings of a file: the members of the objects around keys, or beside columns, as settings of the curve.
//
// A member is a setting by its name, whatever the object is called. Each setting that applies has a note, which says
// what undoes it; the option that it undoes has priority, so that nothing is told of the member then.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "error.hpp"
#include "read/input_options.hpp"
#include "schema/curve_settings.hpp"
#include "tcb/spline/key.hpp"

namespace tcb {

/// A member of an object. One that is an object, or an array of objects or arrays, has no values.
struct FileMember {
  enum class Kind : std::uint8_t { missing, boolean, number, text };
  struct Value {
    Kind kind;
    std::string text;
  };
  std::string name;
  std::vector<Value> values = {};  ///< one, or those of an array
  bool is_array = false, is_object = false;
  bool holds_numbers = false;  ///< also deeper in it
  TextPosition position = {}, value_position = {};
};

/// Whether an object of this name holds settings of the object around it, as "params" and "defaults" do.
bool may_hold_settings(std::string_view name);

/// Whether a member of this name is tension, continuity or bias, or closes a curve.
bool may_shape_curve(std::string_view name);

/// Whether a member of this name is a setting that closes a curve or is known as the program writes it.
bool is_setting_name(std::string_view name);

/// An object on the way from the root of a file to the list of keys, or one in it that may hold settings.
struct FileObject {
  std::string path = {};  ///< of the object in the file, as "spline.params"; empty: the root
  std::vector<FileMember> members = {};
  bool is_own = false;    ///< it has the list "keys" or "curves", so that all of its members should be settings
  bool is_apart = false;  ///< it is beside the way to the keys, and its members, which would be settings there, are not
};

/// Erases the members of an object that change no settings, so that an object around many lists is read as a whole
/// only once. Requires: the object was read.
void keep_settings(FileObject& object);

struct FileSettings {
  CurveInfo curve_info = {};
  std::optional<spline::Tcb<double>> tcb = {};  ///< of keys that have none
  std::vector<std::string> channels = {};       ///< names of the numbers of "position"
  std::string frame_rate = {};                  ///< as --input-fps takes it; empty: none
  std::string rate_name = {};                   ///< the path of its member
  std::string shown_rate = {};                  ///< the same with the value
  std::vector<std::string> notes = {};
  std::vector<std::string> unused = {};  ///< members with numbers that are no settings
};

/// What lines above a table say of the curve or the times, as "# closed: true" and "fps = 25" do.
struct SettingsInText {
  std::vector<std::string> shown = {};    ///< names and values
  std::vector<std::string> options = {};  ///< that apply them
  std::string frame_rate = {};            ///< as --input-fps takes it; empty: none
  std::string shown_rate = {};            ///< its name and value
};

/// The settings among lines, each a name with a value behind ":" or "=", or both alone in a line, but not what
/// the options or the columns, if these `has_tcb`, say.
SettingsInText settings_in(std::string_view lines, const InputOptions& options, bool has_tcb);

/// The settings in objects from the root on, of which a later one has priority. Throws: Error (data) at a member whose
/// value is none of its setting, that may be something else, or whose name is nearly that of a setting.
FileSettings read_settings(std::span<const FileObject> objects, const InputOptions& options);

}  // namespace tcb
