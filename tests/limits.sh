#!/bin/sh
# The memory and the stack that the manual promises, and no time that grows with the square of the size: limits.sh
# PROGRAM. Not for programs with sanitizers.
set -u
program=$1 tests=$(cd "$(dirname "$0")" && pwd)
scratch=$(mktemp -d) || exit 1
trap 'rm -rf "$scratch"' EXIT
failed=0
fail() { echo "$1"; failed=1; }

# Typical modes with a stack of 128 KiB, also for threads.
printf '#!/bin/sh\nulimit -s 128\nexec "%s" "$@"\n' "$program" >"$scratch/tcbsample"
chmod +x "$scratch/tcbsample"
for case in batch/bad-files-do-not-stop-others cli/places compare/check-groups compare/check-picture curve/closed \
  curve/tcb-per-channel errors/columns-and-members errors/data errors/usage exact/cancelling exact/rows-at-keys fit/keys \
  fit/rotations input/curves-in-json input/limits input/rotations input/ten-errors-at-once output/endings output/formats \
  output/meta output/picture pieces/closed sampling/at-places sampling/tolerance-refusals; do
  sh "$tests/golden.sh" "$scratch/tcbsample" "$tests/golden/$case" || fail "$case with a stack of 128 KiB"
done
printf 't,x\n0,1\n1,2\n3,5\n' >"$scratch/keys.csv"
"$program" -n 5 "$scratch/keys.csv" >"$scratch/rows.csv"
"$scratch/tcbsample" --identify "$scratch/rows.csv" "$scratch/keys.csv" >"$scratch/out" || fail "--identify"
"$scratch/tcbsample" --step 1e-5 -j 4 "$scratch/keys.csv" >"$scratch/out" || fail "-j 4"

# --golden of many channels and keys; a kept segment takes 1.3 kB for each channel.
awk 'BEGIN { for (row = 0; row <= 70; ++row) for (i = 0; i <= 3000; ++i)
  printf "%s%s", row == 0 ? (i == 0 ? "t" : "x" i) : (i == 0 ? row : (row * i) % 7), i == 3000 ? "\n" : "," }' \
  >"$scratch/wide.csv"
(ulimit -v 160000 && "$program" -j 1 --per-segment 1 --golden "$scratch/wide.csv") >"$scratch/out" || fail "memory of --golden"
[ "$(wc -l <"$scratch/out")" = 71 ] || fail "rows of --golden"

exit $failed
