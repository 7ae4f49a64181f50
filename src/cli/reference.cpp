// What the declaration of the options says to people and shells: help, manual page, completions.
#include "cli/reference.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <vector>

#include "cli/manual.hpp"
#include "cli/presets.hpp"
#include "cli/text.hpp"
#include "error.hpp"

namespace tcb {
namespace {

struct Entry {
  std::string group;
  std::vector<std::string> names;  ///< with their dashes, the short one first
  std::string value;               ///< what stands for its value, empty for a flag
  std::string text;
};

std::vector<Entry> entries(const CLI::App& app) {
  std::vector<Entry> result;
  for (const CLI::Option* option : app.get_options()) {
    if (option->get_positional()) continue;
    Entry entry{option->get_group(), {}, "", option->get_description()};
    for (const auto& name : option->get_snames()) entry.names.push_back("-" + name);
    for (const auto& name : option->get_lnames()) entry.names.push_back("--" + name);
    if (option->get_items_expected_max() > 0) entry.value = option->get_type_name();
    result.push_back(std::move(entry));
  }
  return result;
}

std::string joined(const std::vector<std::string>& parts, std::string_view between) {
  return fmt::format("{}", fmt::join(parts, between));
}

std::string manual_options(const CLI::App& app) {
  std::string out, group;
  for (const Entry& entry : entries(app)) {
    if (entry.group != group) out += fmt::format(".SS {}\n", group = entry.group);
    std::vector<std::string> names;
    for (const std::string& name : entry.names) names.push_back("\\fB" + escaped(name) + "\\fR");
    const std::string value = entry.value.empty() ? "" : " \\fI" + escaped(entry.value) + "\\fR";
    out += fmt::format(".TP\n{}{}\n{}.\n", joined(names, ", "), value, escaped(entry.text));
  }
  return out;
}

/// The prose of the manual page, with the tables in the places marked for them.
std::string manual(const CLI::App& app) {
  std::string page(manual_template);
  const auto fill = [&](std::string_view mark, const std::string& text) {
    page.replace(page.find(mark), mark.size(), text);
  };
  fill("@OPTIONS@\n", manual_options(app));
  fill("@PRESETS@\n", manual_presets());
  fill("@TANGENTS@\n", manual_tangents());
  fill("@ENDS@\n", manual_ends());
  return page.substr(0, page.find_last_not_of('\n') + 1);
}

std::string bash_completion(const CLI::App& app) {
  std::vector<std::string> names;
  for (const Entry& entry : entries(app)) names.insert(names.end(), entry.names.begin(), entry.names.end());
  return fmt::format(
      "_tcbsample() {{\n"
      "  if [[ ${{COMP_WORDS[COMP_CWORD]}} == -* ]]; then\n"
      "    COMPREPLY=($(compgen -W '{}' -- \"${{COMP_WORDS[COMP_CWORD]}}\"))\n"
      "  fi\n"
      "}}\n"
      "complete -o default -F _tcbsample tcbsample",
      joined(names, " "));
}

/// Text inside single quotes of a shell, without the characters that mean something to it.
std::string plain(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (std::string_view("'[]:").find(c) == std::string_view::npos) out += c;
  }
  return out;
}

std::string zsh_completion(const CLI::App& app) {
  std::string out = "#compdef tcbsample\n_arguments \\\n";
  for (const Entry& entry : entries(app)) {
    for (const std::string& name : entry.names) {
      out += fmt::format("  '{}[{}]{}' \\\n", name, plain(entry.text),
                         entry.value.empty() ? "" : fmt::format(":{}:_files", plain(entry.value)));
    }
  }
  return out + "  '*:file:_files'";
}

std::string fish_completion(const CLI::App& app) {
  std::string out;
  for (const Entry& entry : entries(app)) {
    out += out.empty() ? "complete -c tcbsample" : "\ncomplete -c tcbsample";
    for (const std::string& name : entry.names) {
      const bool is_long = name.starts_with("--");
      out += fmt::format(" -{} {}", is_long ? "l" : "s", name.substr(is_long ? 2 : 1));
    }
    out += fmt::format("{} -d '{}'", entry.value.empty() ? "" : " -r", plain(entry.text));
  }
  return out;
}

}  // namespace

std::string help_text(const CLI::App& app) {
  std::string out =
      "Usage: tcbsample [OPTION]... [FILE]...\n"
      "Reads keys with times, positions and tension, continuity and bias\n"
      "(Kochanek-Bartels splines), and prints samples of the curve through them.\n"
      "\n"
      "  tcbsample --step 0.1 keys.csv            a sample every 0.1 of time\n"
      "  tcbsample --fps 30000/1001 keys.json     exact NTSC frames\n"
      "  tcbsample -n 200 < keys.csv              200 samples, both ends included\n"
      "  tcbsample --arc-step 5 path.csv          equal distances along the curve\n"
      "  tcbsample -s 0.1 --output-dir out *.csv  a file for each file\n";
  std::string group;
  for (const Entry& entry : entries(app)) {
    if (entry.group != group) out += fmt::format("\n{}:\n", group = entry.group);
    out += fmt::format("  {}{}\n", joined(entry.names, ", "), entry.value.empty() ? "" : " " + entry.value);
    out += wrapped(entry.text, 6);
  }
  out +=
      "\nExit status: 0 done, 1 the data was rejected or differs, 2 wrong usage or a\n"
      "file that cannot be opened or written.";
  return out;
}

std::string version_text() { return fmt::format("tcbsample {}", TCBSAMPLE_VERSION); }

std::string generated_text(const CLI::App& app, std::string_view kind) {
  if (kind == "man") return manual(app);
  if (kind == "bash") return bash_completion(app);
  if (kind == "zsh") return zsh_completion(app);
  if (kind == "fish") return fish_completion(app);
  throw Error(Exit::usage, fmt::format("--generate \"{}\": expected man, bash, zsh or fish", kind));
}

}  // namespace tcb
