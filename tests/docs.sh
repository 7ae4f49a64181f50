#!/bin/sh
# Runs the commands that a Markdown file shows, and compares what they print: docs.sh PROGRAM FILE.md.
#
# In each ```console block a line that begins with "$ " is a command; the lines up to the next command,
# or to the end of the block, are its standard output and error, byte for byte. The commands of a file
# run one after another, in one scratch copy of the file's folder (without build/ and dot files), with
# the folder of PROGRAM first in PATH. Exit 1: something differs, or there was nothing to run.
set -u
[ $# -eq 2 ] && [ -x "$1" ] && [ -r "$2" ] || { echo "usage: docs.sh PROGRAM FILE.md" >&2; exit 2; }
program_folder=$(cd "$(dirname "$1")" && pwd) || exit 2
folder=$(cd "$(dirname "$2")" && pwd) || exit 2
file=$folder/$(basename "$2")

scratch=$(mktemp -d) || exit 2
trap 'rm -rf "$scratch"' EXIT
trap 'exit 130' INT TERM
LANGUAGE=en # the language of other programs' messages, whatever the locale
export LANGUAGE
mkdir "$scratch/folder" "$scratch/cases" || exit 2
for entry in "$folder"/*; do
  [ "$entry" = "$folder/build" ] || cp -R "$entry" "$scratch/folder" || exit 2
done

# Case N: N.command, N.expected, and N.line, the line of its command.
awk -v cases="$scratch/cases/" '
  function refuse(what) { print FILENAME ":" FNR ": " what; exit failed = 1 }
  !inside && /^```console[ \t]*$/ { inside = 1; waiting = 1; next }
  inside && /^```/ { if (waiting) refuse("a console block without a command"); inside = 0; next }
  inside && /^\$ / {
    close(expected)
    ++number; waiting = 0
    expected = cases number ".expected"
    print substr($0, 3) >(cases number ".command"); close(cases number ".command")
    print FNR >(cases number ".line"); close(cases number ".line")
    printf "" >expected
    next
  }
  inside && waiting { refuse("output before the first command of a console block") }
  inside { print >expected }
  END { if (!failed && inside) { print FILENAME ": a console block without an end"; exit 1 } }
' "$file" || exit 1

[ ! -d "${TCBSAMPLE_CALLS-}" ] || PATH=$TCBSAMPLE_CALLS # see called_programs.py
PATH=$program_folder:$PATH
export PATH
cd "$scratch/folder" || exit 2
failed=0 number=0
while [ -f "$scratch/cases/$((number + 1)).command" ]; do
  number=$((number + 1))
  case=$scratch/cases/$number
  sh -c "$(cat "$case.command")" >"$case.printed" 2>&1 </dev/null
  diff -u --label expected --label printed "$case.expected" "$case.printed" && continue
  echo "$file:$(cat "$case.line"): \$ $(cat "$case.command")"
  failed=1
done
# In a clone, Git ignores what the commands make, and they change no file.
if git -C "$folder" rev-parse --git-dir >/dev/null 2>&1; then
  LC_ALL=C diff -rq --exclude=build --exclude='.*' "$folder" . >"$scratch/differences"
  sed -n 's|^Only in \(\.[^:]*\): |\1/|p' "$scratch/differences" >"$scratch/made"
  while IFS= read -r made; do
    git -C "$folder" check-ignore -q --no-index "$made" && continue
    echo "$file: its commands make $made, which Git does not ignore"
    failed=1
  done <"$scratch/made"
  ! grep ' differ$' "$scratch/differences" || failed=1
fi
echo "$number commands run"
[ $number -gt 0 ] && exit $failed
exit 1
