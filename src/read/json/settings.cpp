// Settings in JSON: the members around keys, or beside columns, as those of a file.
#include "read/settings.hpp"

#include <algorithm>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "read/json/keys.hpp"
#include "read/json/tape.hpp"
#include "text/suggest.hpp"
#include "text/utf8.hpp"

namespace tcb {
namespace {

using Kind = JsonNode::Kind;

FileMember::Value value_of(const JsonTape& tape, std::size_t value) {
  const Kind kind = tape.kind(value);
  const auto of_file = kind == Kind::number    ? FileMember::Kind::number
                       : kind == Kind::boolean ? FileMember::Kind::boolean
                       : kind == Kind::null    ? FileMember::Kind::missing
                                               : FileMember::Kind::text;
  return {of_file, kind == Kind::number ? json_number_text(tape.written(value)) : std::string(tape.shown(value))};
}

/// Positions of values that come in the order of the text, in linear time.
class Positions {
 public:
  explicit Positions(const JsonTape& tape) : tape_(tape), at_{tape.part().chunk.line, tape.part().chunk.column} {}

  TextPosition of(std::size_t value) {
    const JsonPart& part = tape_.part();
    const std::size_t byte = tape_[value].begin;
    if (byte_ < part.seam && byte >= part.seam) {
      byte_ = part.seam;
      at_ = part.after;
    }
    at_ = position_after(std::string_view(part.chunk.text).substr(byte_, byte - byte_), at_);
    byte_ = byte;
    return {"", at_.line, at_.column};
  }

 private:
  const JsonTape& tape_;
  std::size_t byte_ = 0;
  LinePosition at_;
};

FileMember member_of(const JsonTape& tape, std::size_t name, Positions& positions) {
  constexpr std::ptrdiff_t most = 32;  // of an array
  const std::size_t value = name + 1;
  FileMember member{.name = std::string(tape.text(name))};
  member.position = positions.of(name);
  member.value_position = positions.of(value);
  member.holds_numbers = tape.holds(value, Kind::number);
  const auto elements = tape.inside(value);
  const auto is_nested = [&](std::size_t element) { return tape[element].is_nested(); };
  if (!tape[value].is_nested()) {
    member.values = {value_of(tape, value)};
  } else if (tape.kind(value) == Kind::array && std::ranges::distance(elements) <= most &&
             std::ranges::none_of(elements, is_nested)) {
    member.is_array = true;
    for (const std::size_t element : elements) member.values.push_back(value_of(tape, element));
  }
  return member;
}

/// Adds an object, after those in it that may hold settings. `columns`: names of members that are none.
void add_object(const JsonTape& tape, std::size_t object, std::string path, std::span<const std::string> columns,
                Positions& positions, std::vector<FileObject>& objects) {
  FileObject found{.path = std::move(path)};
  for (const std::size_t name : tape.inside(object)) {
    if (std::ranges::count(columns, tape.text(name)) > 0) continue;
    found.members.push_back(member_of(tape, name, positions));
    const std::string& last = found.members.back().name;
    if (tape.kind(name + 1) == Kind::object && may_hold_settings(last)) {
      add_object(tape, name + 1, found.path.empty() ? last : found.path + "." + last, {}, positions, objects);
    }
  }
  objects.push_back(std::move(found));
}

}  // namespace

FileSettings settings_around(const JsonTape& tape, const JsonTable& table, const InputOptions& options) {
  std::vector<FileObject> objects;
  const std::size_t list = table.value();
  std::string path;
  for (std::size_t value = 0; value != list;) {
    const auto all = tape.inside(value);
    std::size_t index = 0;
    const auto inner = std::ranges::find_if(all, [&](std::size_t one) {
      ++index;
      return list < tape[tape.value_of(one)].next;
    });
    if (tape.kind(value) == Kind::object) {
      const std::vector<std::string> way{std::string(tape.text(*inner))};
      Positions positions(tape);
      add_object(tape, value, path, way, positions, objects);
      path += path.empty() ? way[0] : "." + way[0];
    } else {
      path += "[" + std::to_string(index - 1) + "]";
    }
    value = tape.value_of(*inner);
  }
  if (table.is_beside_settings()) {
    std::vector<std::string> columns = table.names();
    columns.insert(columns.end(), {"columns", "index", "data", "values", "rows", "schema"});
    Positions positions(tape);
    add_object(tape, list, path, columns, positions, objects);
  }
  return read_settings(objects, options);
}

JsonCurveInfo read_curve_info(const JsonPart& part, const InputOptions& options) {
  const JsonTape tape(part);
  if (tape.kind(0) != Kind::object) throw data_error("found no keys; expected at least two; add them");
  std::vector<FileObject> objects;
  Positions positions(tape);
  add_object(tape, 0, part.chunk.path, {}, positions, objects);
  objects.back().is_own = true;
  return {read_settings(objects, options), part.chunk.path, {"", part.chunk.line, part.chunk.column}};
}

FileSettings settings_before_keys(const Chunk& text, const InputOptions& options) {
  if (text.text.empty()) return {};
  JsonPart part{JsonPart::Kind::object, text};
  part.chunk.text += "[]}";
  try {
    return read_curve_info(part, options).settings;
  } catch (const Error&) {
    return {};  // thrown again when the whole object is read
  }
}

}  // namespace tcb
