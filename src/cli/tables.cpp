// Tables: the options and the presets as JSON, from which the Python module is made.
#include "cli/tables.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string_view>
#include <vector>

#include "cli/options.hpp"
#include "tcb/spline/rules.hpp"
#include "write/layout.hpp"

namespace tcb {
namespace {

std::string_view kind_name(ValueKind kind) {
  switch (kind) {
    case ValueKind::flag: return "flag";
    case ValueKind::name: return "name";
    case ValueKind::names: return "names";
    case ValueKind::file: return "file";
    case ValueKind::folder: return "folder";
    case ValueKind::columns: return "columns";
    case ValueKind::column_pair: return "column_pair";
    case ValueKind::roles: return "roles";
    case ValueKind::places: return "places";
    case ValueKind::attached: return "attached";
    case ValueKind::other: return "other";
  }
  return "";
}

std::string option_object(const OptionRow& row) {
  std::vector<std::string> known;
  if (row.known != nullptr) {
    for (const std::string_view name : row.known()) known.push_back(json_text(name));
  }
  return fmt::format(R"({{"name":{},"other_name":{},"group":{},"kind":"{}","value":{},"known":[{}],"text":{}}})",
                     json_text(row.name), json_text(row.other_name), json_text(row.group), kind_name(row.kind),
                     json_text(row.value), fmt::join(known, ","), json_text(row.description()));
}

}  // namespace

std::string tables_text() {
  std::vector<std::string> options, preset_rows;
  for_each_group([](std::string_view) {}, [&options](const OptionRow& row) { options.push_back(option_object(row)); });
  for (const auto& row : spline::presets) {
    preset_rows.push_back(fmt::format(R"({{"name":{},"tangents":{},"ends":{},"timing":{},"product":{}}})",
                                      json_text(row.name), json_text(name_of(row.tangents)),
                                      json_text(name_of(row.ends)), json_text(name_of(row.timing)),
                                      json_text(row.product)));
  }
  return fmt::format("{{\"version\":{},\n\"options\":[\n{}],\n\"presets\":[\n{}]}}", json_text(TCBSAMPLE_VERSION),
                     fmt::join(options, ",\n"), fmt::join(preset_rows, ",\n"));
}

}  // namespace tcb
