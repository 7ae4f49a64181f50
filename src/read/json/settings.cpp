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

/// Whether an array has only objects of a name and a value, each of which is a member.
bool are_named_values(const Json& json, std::size_t array) {
  return json.has_only(array, Kind::object) && std::ranges::all_of(json.inside(array), [&](std::size_t value) {
           const auto name = json.member(value, "name");
           return name && json.is(*name, Kind::string) && json.member(value, "value");
         });
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

/// Adds an object, or an array of names and values, behind those in it that may hold settings.
void JsonSettings::add_object(std::size_t object, std::string path, bool is_own, std::vector<FileObject>& objects) {
  FileObject found{.path = std::move(path), .is_own = is_own};
  if (json_.is(object, Kind::array)) {
    for (const std::size_t value : json_.inside(object)) {
      const std::size_t name = *json_.member(value, "name");
      found.members.push_back(member_of(json_.text(name), name, *json_.member(value, "value")));
    }
  } else {
    for (const std::size_t value : json_.inside(object)) {
      if (tables_.contains(value)) continue;
      const std::string_view name = json_.name(value);
      if (may_hold_settings(name) && (json_.is(value, Kind::object) || are_named_values(json_, value))) {
        add_object(value, found.path.empty() ? std::string(name) : fmt::format("{}.{}", found.path, name), false,
                   objects);
      }
      FileMember member = member_of(name, value - 1, value);
      const bool has_values = !member.values.empty() || member.is_array;
      if (has_values || is_own || is_setting_name(name)) found.members.push_back(std::move(member));
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

}  // namespace tcb
