#!/bin/sh
# Runs the cases of the command line with a program for Windows, by wine: windows.sh PROGRAM.EXE [CASE...]
#
# All must have the bytes that the program for Linux has. A case that needs what only POSIX systems have (its processes,
# its devices, its permissions, its messages, Zstandard) is in windows.skip, with the reason.
set -eu
program=$(realpath "$1")
shift
tests=$(cd "$(dirname "$0")" && pwd)
command -v wine >/dev/null || {
  echo "skipped: there is no wine"
  exit 77
}
made=$(mktemp -d)
trap 'wineserver -k 2>/dev/null || true; rm -rf "$made"' EXIT
WINEPREFIX=$made/prefix WINEDEBUG=-all
export WINEPREFIX WINEDEBUG
wineboot --init >/dev/null 2>&1
printf '#!/bin/sh\nexec timeout 20 wine "%s" "$@"\n' "$program" >"$made/tcbsample"
chmod +x "$made/tcbsample"
[ $# -gt 0 ] || set -- $(cd "$tests/golden" && find . -name cmd | sed 's|^\./||; s|/cmd$||' | sort | grep -vxFf "$tests/windows.skip.names")
failed=0 run=0
for case in "$@"; do
  run=$((run + 1))
  sh "$tests/golden.sh" "$made/tcbsample" "$tests/golden/$case" >"$made/out" 2>&1 || {
    failed=$((failed + 1))
    echo "== $case"
    head -40 "$made/out"
  }
done
echo "$run cases, $failed failed"
[ "$failed" = 0 ]
