// Settings in JSON: the members of the objects around a table, or beside its columns, as those of a file.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "read/input_options.hpp"
#include "read/json/tables.hpp"
#include "read/json/text.hpp"
#include "read/settings.hpp"

namespace tcb {

/// Reads the settings around the tables of a text. Requires: the text outlives it.
class JsonSettings {
 public:
  /// `tables`: all that are read, whose members are no settings.
  JsonSettings(const Json& json, std::span<const JsonTable> tables);

  /// The settings in the objects from the root to a table, and beside its columns; of a curve as the program writes it,
  /// those of its own object alone. Throws: Error (data).
  FileSettings around(const JsonTable& table, const InputOptions& options);
  /// The settings in the object around the curves that the program writes, one of which is given.
  FileSettings around_curves(const JsonTable& curve, const InputOptions& options);
  /// The settings in an object before the keys.
  FileSettings of_object(std::size_t object, const InputOptions& options);

 private:
  FileMember member_of(std::string_view name, std::size_t named, std::size_t value);
  void add_apart(std::size_t object, const std::string& path, std::vector<FileObject>& objects);
  void add_object(std::size_t object, std::string path, bool is_own, std::vector<FileObject>& objects);
  const std::vector<FileObject>& objects_in(std::size_t object, std::string_view path, bool is_own);

  const Json& json_;
  struct Known {
    std::vector<FileObject> objects = {};
    bool is_read = false;  ///< and only the members that are settings are kept
  };
  std::unordered_set<std::size_t> tables_ = {};        ///< members that are on the way to tables
  std::unordered_map<std::size_t, Known> known_ = {};  ///< by the object
  Json::Mark mark_ = {0, {0, 0}};                      ///< the last member
};

}  // namespace tcb
