// Settings in JSON: the members of the objects around a table, or beside its columns, as those of a file.
#include "read/json/settings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>

namespace tcb {
namespace {

using Kind = Json::Kind;

FileMember::Value value_of(const Json& json, std::size_t value) {
  const Kind kind = json.kind(value);
  const auto of_file = kind == Kind::number    ? FileMember::Kind::number
                       : kind == Kind::boolean ? FileMember::Kind::boolean
                       : kind == Kind::null    ? FileMember::Kind::missing
                                               : FileMember::Kind::text;
  return {of_file, kind == Kind::number ? json_number_text(json.text(value)) : std::string(json.text(value))};
}

/// The name and the value in an object of these, such as {"name":"tension","value":0.5}.
std::optional<std::pair<std::size_t, std::size_t>> named_value_in(const Json& json, std::size_t object) {
  for (const std::string_view key : {"name", "key"}) {
    const auto name = json.member(object, key), value = json.member(object, "value");
    if (name && value && json.is(*name, Kind::string)) return std::pair(*name, *value);
  }
  return std::nullopt;
}

/// Whether an array has only objects of a name and a value, each of which is a member.
bool are_named_values(const Json& json, std::size_t array) {
  return json.has_only(array, Kind::object) && std::ranges::all_of(json.inside(array), [&](std::size_t value) {
           return named_value_in(json, value).has_value();
         });
}

std::string joined(std::string_view path, std::string_view name) {
  return path.empty() ? std::string(name) : fmt::format("{}.{}", path, name);
}

}  // namespace

JsonSettings::JsonSettings(const Json& json, std::span<const JsonTable> tables) : json_(json) {
  for (const JsonTable& table : tables) {
    tables_.insert(table.members.begin(), table.members.end());
    for (const JsonTable::Outer& outer : table.around) tables_.insert(outer.member);
  }
}

FileMember JsonSettings::member_of(std::string_view name, std::size_t named, std::size_t value) {
  constexpr std::ptrdiff_t most = 32;  // of an array
  FileMember member{.name = std::string(name)};
  mark_ = json_.mark_at(json_.offset(named), mark_);
  member.position = {"", mark_.at.line, mark_.at.column};
  mark_ = json_.mark_at(json_.offset(value), mark_);
  member.value_position = {"", mark_.at.line, mark_.at.column};
  member.holds_numbers = json_.holds(value, Kind::number);
  member.is_object = json_.is(value, Kind::object);
  const JsonRange elements = json_.inside(value);
  const auto is_nested = [&](std::size_t element) { return json_.is_nested(element); };
  if (!json_.is_nested(value)) {
    member.values = {value_of(json_, value)};
  } else if (json_.is(value, Kind::array) && std::ranges::distance(elements.begin(), elements.end()) <= most &&
             std::ranges::none_of(elements, is_nested)) {
    member.is_array = true;
    for (const std::size_t element : elements) member.values.push_back(value_of(json_, element));
  }
  return member;
}

/// Adds what an object beside the way to the keys, or one in it, has of names of settings that shape the curve.
void JsonSettings::add_apart(std::size_t object, const std::string& path, std::vector<FileObject>& objects) {
  FileObject found{.path = path, .is_apart = true};
  for (const std::size_t value : json_.inside(object)) {
    if (tables_.contains(value)) continue;
    const std::string_view name = json_.name(value);
    if (json_.is(value, Kind::object)) {
      add_apart(value, joined(path, name), objects);
    } else if (may_shape_curve(name)) {
      found.members.push_back(member_of(name, value - 1, value));
    }
  }
  if (!found.members.empty()) objects.push_back(std::move(found));
}

/// Adds an object, or an array of names and values, behind those in it that may hold settings.
void JsonSettings::add_object(std::size_t object, std::string path, bool is_own, std::vector<FileObject>& objects) {
  FileObject found{.path = std::move(path), .is_own = is_own};
  if (json_.is(object, Kind::array)) {
    for (const std::size_t value : json_.inside(object)) {
      const auto [name, inner] = *named_value_in(json_, value);
      found.members.push_back(member_of(json_.text(name), name, inner));
    }
  } else {
    for (const std::size_t value : json_.inside(object)) {
      if (tables_.contains(value)) continue;
      const std::string_view name = json_.name(value);
      const std::string inner = joined(found.path, name);
      const bool is_object = json_.is(value, Kind::object);
      if (may_hold_settings(name) && (is_object || are_named_values(json_, value))) {
        add_object(value, inner, false, objects);
      } else if (is_object) {
        add_apart(value, inner, objects);
      }
      FileMember member = member_of(name, value - 1, value);
      const bool has_values = !member.values.empty() || member.is_array;
      if (has_values || is_own || is_setting_name(name) || may_shape_curve(name))
        found.members.push_back(std::move(member));
    }
  }
  objects.push_back(std::move(found));
}

const std::vector<FileObject>& JsonSettings::objects_in(std::size_t object, std::string_view path, bool is_own) {
  const auto [at, is_new] = known_.try_emplace(object);
  Known& known = at->second;
  if (is_new) {
    add_object(object, std::string(path), is_own, known.objects);
  } else if (!std::exchange(known.is_read, true)) {
    std::ranges::for_each(known.objects, keep_settings);
  }
  return known.objects;
}

FileSettings JsonSettings::around(const JsonTable& table, const InputOptions& options) {
  std::vector<FileObject> objects;
  const auto add = [&](std::size_t object, std::string_view path) {
    const std::vector<FileObject>& found = objects_in(object, path, table.is_own);
    objects.insert(objects.end(), found.begin(), found.end());
  };
  for (const JsonTable::Outer& outer : table.around) {
    const bool is_around_curves = table.is_own && &outer != &table.around.back();
    if (!is_around_curves) add(outer.object, std::string_view(table.path).substr(0, outer.path_size));
  }
  const bool has_members = !table.members.empty() && json_.is(table.value, Kind::object);
  if (has_members) add(table.value, table.path);
  return read_settings(objects, options);
}

FileSettings JsonSettings::around_curves(const JsonTable& curve, const InputOptions& options) {
  return read_settings(objects_in(curve.around[0].object, "", true), options);
}

FileSettings JsonSettings::of_object(std::size_t object, const InputOptions& options) {
  return read_settings(objects_in(object, "", false), options);
}

}  // namespace tcb
