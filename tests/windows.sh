#!/bin/sh
# Runs the cases of the command line with a program for Windows, by wine: windows.sh PROGRAM.EXE [GROUP...]
#
# A group is a folder of cases, such as batch, or a case; without groups all cases are run.
# All must have the bytes that they have on Linux. Left out are cases that need what only POSIX systems have.
set -eu
program=$(realpath "$1")
shift
tests=$(cd "$(dirname "$0")" && pwd)
command -v wine >/dev/null || {
  echo "skipped: there is no wine"
  exit 77
}

# Symbolic links, named pipes and /dev/fd; names and arguments that are no text, or that Windows does not allow; names
# that differ in their cases; permissions; terminals; messages of the C library; Zstandard; the time at which rows
# appear; and, which wine lacks, the identity of a redirected file and the locks of programs for Linux.
left_out='batch/bad-files-do-not-stop-others batch/killed-and-continued batch/links-in-the-output-folder
batch/lists-of-files cli/first-run errors/other-formats input/compressed input/encodings output/endings
output/keeps-permissions output/meta output/meta-command output/over-other-inputs output/rows-appear-while-keys-come
output/standard-streams'

made=$(mktemp -d)
trap 'wineserver -k 2>/dev/null || true; rm -rf "$made"' EXIT
WINEPREFIX=$made/prefix WINEDEBUG=-all
export WINEPREFIX WINEDEBUG
wineboot --init >/dev/null 2>&1
printf '#!/bin/sh\nexec wine "%s" "$@"\n' "$program" >"$made/tcbsample"
chmod +x "$made/tcbsample"
cases() {
  (cd "$tests/golden" && find "$@" -name cmd) | sed 's|^\./||; s|/cmd$||' | sort |
    grep -vxF "$(echo "$left_out" | tr ' ' '\n')"
}
run_case() {
  sh "$tests/golden.sh" "$made/tcbsample" "$tests/golden/$1" >"$made/$2.out" 2>&1 && return
  printf '== %s\n%s\n' "$1" "$(head -40 "$made/$2.out")"
  : >"$made/$2.failed"
}

# Two at a time: those with odd and those with even numbers.
[ $# -gt 0 ] || set -- .
# shellcheck disable=SC2046
set -- $(cases "$@")
run_all() {
  number=0
  parity=$1
  shift
  for case in "$@"; do
    number=$((number + 1))
    [ $((number % 2)) != "$parity" ] || run_case "$case" "$number"
  done
}
run_all 0 "$@" &
run_all 1 "$@"
wait
failed=$(find "$made" -maxdepth 1 -name '*.failed' | wc -l)
echo "$# cases, $failed failed"
mkdir "$made/console"
python3 "$tests/windows_console.py" "$program" "$made/console"
[ "$failed" = 0 ]
