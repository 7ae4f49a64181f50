// Completions: scripts for bash, zsh and fish, made from the table of options, and the columns that they offer.
#include "cli/help.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "cli/options.hpp"
#include "formats/formats.hpp"
#include "io/input_file.hpp"
#include "read/input.hpp"
#include "read/input_options.hpp"
#include "schema/roles.hpp"
#include "text/utf8.hpp"

namespace tcb {
namespace {

// The scripts, with marks such as @OPTIONS@ for texts from the table.

/// The functions of the script for bash. The words of the line are put together again where bash divides them, at =, :
/// and @; the replies then go without the part of the word up to the last = or :.
constexpr std::string_view bash_script = R"script(_tcbsample_offer() { # SEPARATORS ENDING NAME...
  local part=${word##*[$1]} ending=$2 name
  local before=${word%"$part"}
  for name in "${@:3}"; do
    [[ $name == "$part"* ]] && COMPREPLY+=("$head$before$name$ending")
  done
}
_tcbsample_columns() { # SEPARATORS [KIND]
  local i file name names=()
  for ((i = 1; i < ${#words[@]}; i++)); do
    case ${words[i]} in
      @VALUED@) ((++i)); continue;;
    esac
    file=${words[i]//[\\\"\']/}
    [[ $file == "~/"* ]] && file=$HOME/${file:2}
    [[ $i -eq $current || $file == -* || ! -f $file ]] && continue
    while IFS= read -r name; do
      printf -v name %q "$name"
      names+=("$name")
    done < <(command tcbsample --generate "${2-columns}" "$file" 2>/dev/null)
    break
  done
  _tcbsample_offer "$1" '' "${names[@]}"
}
_tcbsample_files() {
  local name
  while IFS= read -r name; do
    [[ -d $name ]] && name+=/
    printf -v name %q "$name"
    COMPREPLY+=("$head@$name")
  done < <(compgen -f -- "${word#@}")
}
_tcbsample_value() {
  case $option in
@VALUES@    *) return 1;;
  esac
  return 0
}
_tcbsample() {
  local line=$COMP_LINE blanks words=() word option head= i current=0 breaks=${COMP_WORDBREAKS//[!=:]/} divided
  for ((i = 0; i < ${#COMP_WORDS[@]}; i++)); do
    blanks=${line%%[![:blank:]]*}
    line=${line#"$blanks"}
    line=${line#"${COMP_WORDS[i]}"}
    if [[ $i -gt 0 && -z $blanks ]]; then
      words[${#words[@]}-1]+=${COMP_WORDS[i]}
    else
      words+=("${COMP_WORDS[i]}")
    fi
    [[ $i -eq $COMP_CWORD ]] && current=$((${#words[@]} - 1))
  done
  COMPREPLY=()
  word=${words[current]} option=${words[current-1]}
  [[ " ${words[*]:1:current-1} " == *" -- "* ]] && return
  if [[ $word == --*=* ]]; then
    option=${word%%=*} head=$option= word=${word#*=}
  fi
  if _tcbsample_value; then
    word=$head$word
    [[ -z $breaks || $word != *[$breaks]* ]] && return
    divided=${word%"${word##*[$breaks]}"}
    COMPREPLY=("${COMPREPLY[@]#"$divided"}")
  elif [[ $word == -* ]]; then
    COMPREPLY=($(compgen -W '@OPTIONS@' -- "$word"))
  fi
} 2>/dev/null
complete -o default -F _tcbsample tcbsample)script";

/// The functions of the script for zsh.
constexpr std::string_view zsh_script = R"script(#compdef tcbsample
_tcbsample_columns() { # KIND OPTION...
  local -a names
  local i file kind=$1
  shift
  for ((i = 2; i <= $#words; i++)); do
    case $words[i] in
      @VALUED@) ((++i)); continue;;
    esac
    file=${(Q)words[i]/#\~\//$HOME/}
    [[ $i -eq $CURRENT || $file == -* || ! -f $file ]] && continue
    names=(${(f)"$(command tcbsample --generate $kind $file 2>/dev/null)"})
    break
  done
  compadd "$@" -- $names
}
_tcbsample_roles() {
  compset -P '*,'
  local kind=columns
  [[ $PREFIX == position=* ]] && kind=positions
  if compset -P '*[=:]'; then _tcbsample_columns $kind -S ''; else compadd -S '=' -- @ROLES@; fi
}
_tcbsample_pair() {
  compset -P '*:'
  _tcbsample_columns positions
}
_tcbsample_places() {
  compset -P '@' && _files
}
_arguments -s \
@OPTIONS@  '*:file:_files')script";

/// The functions of the script for fish.
constexpr std::string_view fish_script = R"script(function __tcbsample_value
  string replace -r '^--[^=]*=' '' -- (commandline -ct)
end
function __tcbsample_list # SEPARATORS NAME...
  set -l before (string replace -r "[^$argv[1]]*\$" '' -- (__tcbsample_value))
  for name in $argv[2..]
    echo $before$name
  end
end
function __tcbsample_columns # KIND
  set -l words (commandline -op)
  set -l i 2
  while test $i -le (count $words)
    if contains -- $words[$i] @VALUED@
      set i (math $i + 1)
    else if not string match -q -- '-*' $words[$i]; and test -f (string replace -r '^~/' "$HOME/" -- $words[$i])
      command tcbsample --generate $argv[1] (string replace -r '^~/' "$HOME/" -- $words[$i]) 2>/dev/null
      return
    end
    set i (math $i + 1)
  end
end
function __tcbsample_roles
  if string match -qr '(^|,)position=[^,]*$' -- (__tcbsample_value)
    __tcbsample_list ',=:' (__tcbsample_columns positions)
  else if string match -qr '=[^,]*$' -- (__tcbsample_value)
    __tcbsample_list ',=:' (__tcbsample_columns columns)
  else
    __tcbsample_list ',' (string split ' ' '@ROLES@')=
  end
end
function __tcbsample_places
  set -l value (__tcbsample_value)
  string match -q '@*' -- $value; or return
  for file in (__fish_complete_path (string sub -s 2 -- $value))
    echo @$file
  end
end
@OPTIONS@)script";

std::string known_names(const OptionRow& row) { return fmt::format("{}", fmt::join(row.known(), " ")); }

/// The options whose next word is a value.
std::string valued_options(std::string_view separator) {
  std::vector<std::string_view> names;
  for (const OptionRow& row : option_table()) {
    if (row.kind == ValueKind::flag || row.kind == ValueKind::attached) continue;
    const auto own = row.all_names();
    names.insert(names.end(), own.begin(), own.end());
  }
  return fmt::format("{}", fmt::join(names, separator));
}

std::string role_list() {
  std::vector<std::string_view> names;
  for (const Role role : {Role::time, Role::position, Role::tension, Role::continuity, Role::bias, Role::ease_in,
                          Role::ease_out, Role::group, Role::carry, Role::unused}) {
    names.push_back(role_name(role));
  }
  return fmt::format("{}", fmt::join(names, " "));
}

/// Text in single quotes, where the characters of `special` have a backslash in front, and a quote is `quote`.
std::string quoted(std::string_view text, std::string_view special, std::string_view quote) {
  std::string out;
  for (const char c : text) {
    if (special.find(c) != std::string_view::npos) out += '\\';
    out += c == '\'' ? std::string(quote) : std::string(1, c);
  }
  return out;
}

std::string zsh_text(std::string_view text) { return quoted(text, "[]:\\", "'\\''"); }
std::string fish_text(std::string_view text) { return quoted(text, "\\", "\\'"); }

/// What bash does for the value of an option.
std::string bash_value(const OptionRow& row) {
  switch (row.kind) {
    case ValueKind::flag:
    case ValueKind::attached: return "";
    case ValueKind::name: return fmt::format("_tcbsample_offer , '' {}", known_names(row));
    case ValueKind::names: return fmt::format("compopt -o nospace; _tcbsample_offer , '' {}", known_names(row));
    case ValueKind::file: return ":";
    case ValueKind::folder: return "compopt +o default -o dirnames";
    case ValueKind::columns: return "compopt +o default -o nospace; _tcbsample_columns ,";
    case ValueKind::column_pair: return "compopt +o default -o nospace; _tcbsample_columns : positions";
    case ValueKind::roles:
      return "compopt +o default -o nospace; if [[ ${word##*,} == position=* ]]; then _tcbsample_columns ,=: "
             "positions; elif [[ ${word##*,} == *=* ]]; "
             "then _tcbsample_columns ,=:; else "
             "_tcbsample_offer , = " +
             role_list() + "; fi";
    case ValueKind::places: return "compopt +o default -o nospace; if [[ $word == @* ]]; then _tcbsample_files; fi";
    case ValueKind::other: return "compopt +o default";
  }
  return "";
}

/// What zsh offers for the value of an option.
std::string zsh_value(const OptionRow& row) {
  const auto action = [&row](const std::string& what) { return fmt::format(":{}:{}", zsh_text(row.value), what); };
  switch (row.kind) {
    case ValueKind::flag: return "";
    case ValueKind::attached: return ":" + action(" ");
    case ValueKind::name: return action(fmt::format("({})", known_names(row)));
    case ValueKind::names: return action(fmt::format("_sequence -d compadd - {}", known_names(row)));
    case ValueKind::file: return action("_files");
    case ValueKind::folder: return action("_files -/");
    case ValueKind::columns: return action("_sequence _tcbsample_columns columns");
    case ValueKind::column_pair: return action("_tcbsample_pair");
    case ValueKind::roles: return action("_tcbsample_roles");
    case ValueKind::places: return action("_tcbsample_places");
    case ValueKind::other: return action(" ");
  }
  return "";
}

/// The beginning of a description that fits into a line of fish's list.
std::string_view brief(std::string_view text) {
  constexpr std::size_t longest = 60;
  text = text.substr(0, std::min({text.find(". "), text.find("; "), text.find(": ")}));
  if (text.size() <= longest) return text;
  const std::size_t end = std::max(text.rfind(", ", longest) + 1, text.rfind(" (", longest) + 1);
  return text.substr(0, end > 1 ? end - 1 : text.rfind(' ', longest));
}

/// What fish offers for the value of an option.
std::string fish_value(const OptionRow& row) {
  switch (row.kind) {
    case ValueKind::flag:
    case ValueKind::attached: return "";
    case ValueKind::name: return fmt::format(" -x -a '{}'", known_names(row));
    case ValueKind::names: return fmt::format(" -x -a '(__tcbsample_list , {})'", known_names(row));
    case ValueKind::file: return " -r -F";
    case ValueKind::folder: return " -x -a '(__fish_complete_directories)'";
    case ValueKind::columns: return " -x -a '(__tcbsample_list , (__tcbsample_columns columns))'";
    case ValueKind::column_pair: return " -x -a '(__tcbsample_list : (__tcbsample_columns positions))'";
    case ValueKind::roles: return " -x -a '(__tcbsample_roles)'";
    case ValueKind::places: return " -x -a '(__tcbsample_places)'";
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
    const std::string action = bash_value(row);
    if (!action.empty()) values += fmt::format("    {}) {};;\n", fmt::join(own, "|"), action);
  }
  return filled(bash_script, {{"@VALUED@", valued_options("|")},
                              {"@VALUES@", values},
                              {"@OPTIONS@", fmt::format("{}", fmt::join(names, " "))}});
}

std::string zsh_completion() {
  std::string options;
  for (const OptionRow& row : option_table()) {
    const std::vector<std::string_view> names = row.all_names();
    for (const std::string_view name : names) {
      std::string_view mark = name.starts_with("--") ? "=" : "+";  // the value may be in the same word
      if (row.kind == ValueKind::flag) mark = "";
      if (row.kind == ValueKind::attached) mark = "=-";
      const std::string others = names.size() > 1 ? fmt::format("({})", fmt::join(names, " ")) : "";
      options += fmt::format("  '{}{}{}[{}]{}' \\\n", others, name, mark, zsh_text(row.description()), zsh_value(row));
    }
  }
  return filled(zsh_script, {{"@VALUED@", valued_options("|")}, {"@ROLES@", role_list()}, {"@OPTIONS@", options}});
}

std::string fish_completion() {
  std::string options;
  for (const OptionRow& row : option_table()) {
    options += options.empty() ? "complete -c tcbsample" : "\ncomplete -c tcbsample";
    for (const std::string_view name : row.all_names()) {
      const bool is_long = name.starts_with("--");
      options += fmt::format(" -{} {}", is_long ? "l" : "s", name.substr(is_long ? 2 : 1));
    }
    options += fmt::format("{} -d '{}'", fish_value(row), fish_text(brief(row.text)));
  }
  return filled(fish_script, {{"@VALUED@", valued_options(" ")}, {"@ROLES@", role_list()}, {"@OPTIONS@", options}});
}

std::string columns_text(const std::vector<std::string>& files, bool positions_only) {
  std::vector<std::string> names;
  for (const std::string& file : files.empty() ? std::vector<std::string>{"-"} : files) {
    try {
      const Input input = open_input(file, read_file(file), {});
      const Schema& schema = input.schema;
      if (positions_only) {
        names.insert(names.end(), schema.channels.begin(), schema.channels.end());
        continue;
      }
      if (schema.time.is_given) names.push_back(schema.time.name);
      for (const auto* group : {&schema.channels, &schema.groups, &schema.labels, &input.facts.ignored}) {
        names.insert(names.end(), group->begin(), group->end());
      }
      names.insert(names.end(), input.facts.roles.begin(), input.facts.roles.end());
    } catch (const Error& error) {
      throw error.in(shown_name(file));
    }
  }
  std::ranges::transform(names, names.begin(), printable);
  return fmt::format("{}", fmt::join(names, "\n"));
}

}  // namespace tcb
