// Completions: scripts for bash, zsh and fish, made from the table of options.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string>
#include <string_view>
#include <vector>

#include "cli/options.hpp"

namespace tcb {
namespace {

std::vector<std::string_view> known_names(const OptionRow& row) {
  return row.known == nullptr ? std::vector<std::string_view>{} : row.known();
}

/// Text inside single quotes of a shell, without the characters that mean something to it.
std::string plain(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (std::string_view("'[]:").find(c) == std::string_view::npos) out += c;
  }
  return out;
}

/// What zsh offers for the value of an option.
std::string zsh_value(const OptionRow& row) {
  switch (row.kind) {
    case ValueKind::flag: return "";
    case ValueKind::name: return fmt::format(":{}:({})", plain(row.value), fmt::join(known_names(row), " "));
    case ValueKind::file: return fmt::format(":{}:_files", plain(row.value));
    case ValueKind::folder: return fmt::format(":{}:_files -/", plain(row.value));
    case ValueKind::other: return fmt::format(":{}: ", plain(row.value));
  }
  return "";
}

/// What fish offers for the value of an option.
std::string fish_value(const OptionRow& row) {
  switch (row.kind) {
    case ValueKind::flag: return "";
    case ValueKind::name: return fmt::format(" -x -a '{}'", fmt::join(known_names(row), " "));
    case ValueKind::file: return " -r -F";
    case ValueKind::folder: return " -x -a '(__fish_complete_directories)'";
    case ValueKind::other: return " -x";
  }
  return "";
}

}  // namespace

std::string bash_completion() {
  std::vector<std::string_view> names;
  std::string values;
  for (const OptionRow& row : option_table()) {
    const auto own = row.all_names();
    names.insert(names.end(), own.begin(), own.end());
    if (row.kind != ValueKind::name) continue;
    values += fmt::format("    {}) COMPREPLY=($(compgen -W '{}' -- \"$word\")); return;;\n", fmt::join(own, "|"),
                          fmt::join(known_names(row), " "));
  }
  return fmt::format(
      "_tcbsample() {{\n"
      "  local word=${{COMP_WORDS[COMP_CWORD]}}\n"
      "  case ${{COMP_WORDS[COMP_CWORD-1]}} in\n"
      "{}"
      "  esac\n"
      "  if [[ $word == -* ]]; then\n"
      "    COMPREPLY=($(compgen -W '{}' -- \"$word\"))\n"
      "  fi\n"
      "}}\n"
      "complete -o default -F _tcbsample tcbsample",
      values, fmt::join(names, " "));
}

std::string zsh_completion() {
  std::string out = "#compdef tcbsample\n_arguments \\\n";
  for (const OptionRow& row : option_table()) {
    for (const std::string_view name : row.all_names()) {
      out += fmt::format("  '{}[{}]{}' \\\n", name, plain(row.description()), zsh_value(row));
    }
  }
  return out + "  '*:file:_files'";
}

std::string fish_completion() {
  std::string out;
  for (const OptionRow& row : option_table()) {
    out += out.empty() ? "complete -c tcbsample" : "\ncomplete -c tcbsample";
    for (const std::string_view name : row.all_names()) {
      const bool is_long = name.starts_with("--");
      out += fmt::format(" -{} {}", is_long ? "l" : "s", name.substr(is_long ? 2 : 1));
    }
    out += fmt::format("{} -d '{}'", fish_value(row), plain(row.description()));
  }
  return out;
}

}  // namespace tcb
