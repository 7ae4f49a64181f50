#!/bin/sh
# The programs that test a spline with the published vectors pass, and fail if a number differs: consumers.sh VECTORS.
set -eu
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
vectors=$(cd "$1" && pwd)
cp -R "$vectors/." "$scratch"
cd "$scratch"
cc -std=c99 -Wall -Wextra -Werror -o check_vectors check_vectors.c -lm

passes() {
  "$@" || { echo "failed: $*"; exit 1; }
}
fails() {
  if "$@"; then echo "did not fail: $*"; exit 1; fi
}

passes ./check_vectors
passes python3 check_vectors.py
sed -i '0,/0x1[.]8p/s//0x1.9p/' presets/gte.csv
sed -i '0,/"value":\[1[.]/s//"value":[2./' presets/kb1984.json presets/vtk.json
fails ./check_vectors
fails python3 check_vectors.py
if command -v node >/dev/null; then
  fails node check_vectors.js
  cp "$vectors/presets/vtk.json" presets
  passes node check_vectors.js
else
  echo "not run: check_vectors.js needs node"
fi
