// Completion scripts: the functions for bash, zsh and fish, with marks such as @OPTIONS@ for texts from the table.
#pragma once

#include <string_view>

namespace tcb {

/// The functions of the script for bash. The words of the line are put together again where bash divides them, at =, :
/// and @; the replies then go without the part of the word up to the last = or :.
inline constexpr std::string_view bash_script = R"script(_tcbsample_offer() { # SEPARATORS ENDING NAME...
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
inline constexpr std::string_view zsh_script = R"script(#compdef tcbsample
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
inline constexpr std::string_view fish_script = R"script(function __tcbsample_value
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

}  // namespace tcb
