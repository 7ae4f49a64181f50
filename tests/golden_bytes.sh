#!/bin/sh
# The same bytes from every build: golden_bytes.sh PROGRAM [EMULATOR [OPTION]...]
#
# The output of every sample with each set of options below has the hash in golden_bytes.sha256; with an EMULATOR the
# cases of golden/ run too. UPDATE=1 writes the hashes again. same_bytes.py compares two programs. For aarch64, on
# Debian:
#   .ci/setup aarch64 && cmake --workflow --preset aarch64
#   tests/golden_bytes.sh build/aarch64/tcbsample qemu-aarch64-static
set -eu
here=$(cd "$(dirname "$0")" && pwd)
program=$(cd "$(dirname "$1")" && pwd)/$(basename "$1")
shift
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
printf '#!/bin/sh\nexec %s "%s" "$@"\n' "$*" "$program" >"$scratch/tcbsample"
chmod +x "$scratch/tcbsample"
PATH=$scratch:$PATH

fields=time,position,s,velocity,acceleration,jerk,speed,tangent,curvature,torsion,segment,u,key,arc_error
exact=${fields%,arc_error}
mixed() { # keys with tension, continuity, bias and ease, cusps and holds
  echo t,x,y,z,tension,continuity,bias,ease_in,ease_out
  echo 0,0.1,-0.2,3,0,0,0,0,0.3
  echo 0.7,1.5,2.25,-1e-3,0.3,-0.2,0.1,0.2,0
  echo 2,1.5,2.25,-1e-3,1,0,0,0.5,0.7
  echo 3.1,-40,7,0.5,0,-1,0,0,0
  echo 4,-38.5,6,0.25,-0.5,1,-1,0,0
  echo 6.5,3,3,3,0,0,0,0,0
}
ways() {
  echo "--count 501 --fields $fields"
  echo "--arc-count 333 --fields $fields"
  echo "--per-segment 7 --digits 9 -f tsv"
  echo "--tolerance 0.01 --keys -f jsonl"
  echo "--count 21 --golden --fields $exact"
  echo "--arc-count 7 --golden --digits 30 --fields s,time,position"
  echo "--emit poly --no-ease --fields s,length"
  echo "--emit bezier --no-ease --golden --from 0.3"
  for tangents in uniform interval interval-c finite-difference kb1984 synfig; do
    echo "--count 101 --tangents $tangents --ends natural,half --equal-speed --hex"
  done
}
hashes() {
  mixed >"$scratch/mixed.csv"
  for file in "$scratch/mixed.csv" "$here"/../samples/*.csv "$here"/../samples/*.tsv "$here"/../samples/*.json \
    "$here"/../samples/*.jsonl "$here"/../samples/*.txt; do
    ways | while read -r way; do
      # An error message is hashed as well, but no note.
      # shellcheck disable=SC2086
      sum=$( (cd "$(dirname "$file")" && tcbsample -q $way "$(basename "$file")" 2>&1 || echo "exit code $?") | sha256sum)
      echo "${sum%% *} $(basename "$file") $way"
    done
  done
}

hashes >"$scratch/hashes"
[ -z "${UPDATE-}" ] || cp "$scratch/hashes" "$here/golden_bytes.sha256"
diff -u "$here/golden_bytes.sha256" "$scratch/hashes"
[ $# -gt 0 ] || exit 0 # ctest runs the cases as its own tests
for command in $(cd "$here" && find golden -name cmd); do
  sh "$here/golden.sh" "$scratch/tcbsample" "$here/$(dirname "$command")" || exit 1
done
