#!/bin/sh
# NumPy reads the files of -f npy bit for bit: numpy.sh PROGRAM. Exit 77: there is no NumPy.
set -eu
program=$1
here=$(cd "$(dirname "$0")" && pwd)
sh "$here/python.sh" numpy -c '' || exit 77
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"
printf 't,x,y\n0,0,1\n1,2,-1\n3,-1,4\n4,3,3\n' >keys.csv

for mode in '--step 0.0001' '--count 5' '--at 7 --extrapolate hold' '--arc-count 777 --fields s,curvature,torsion,x_key'; do
  options=$(echo "$mode" | sed 's/x_key/key/')
  # shellcheck disable=SC2086
  {
    "$program" $options --hex --no-output-header keys.csv >rows.csv
    "$program" $options -f npy -o file.npy keys.csv
    "$program" $options -f npy keys.csv | cat >pipe.npy
    "$program" $options -f npy keys.csv >redirected.npy
    printf before >appended
    "$program" $options -f npy keys.csv >>appended
  }
  for other in pipe.npy redirected.npy; do cmp file.npy "$other"; done
  tail -c +7 appended | cmp file.npy -
  sh "$here/python.sh" numpy - <<'PYTHON'
import numpy
table = numpy.load("file.npy", allow_pickle=False)
assert table.dtype == numpy.dtype("<f8") and table.flags.c_contiguous, table.dtype
def number(cell):
    return float.fromhex(cell) if cell else float("nan")
rows = numpy.array([[number(cell) for cell in line.rstrip("\n").split(",")] for line in open("rows.csv")])
assert table.shape == rows.shape, (table.shape, rows.shape)
same = (table.view("<u8") == rows.view("<u8")) | (numpy.isnan(table) & numpy.isnan(rows))
assert same.all(), numpy.argwhere(~same)
PYTHON
done
if "$program" -s 1 -f npy -o full.npy keys.csv missing.csv 2>/dev/null; then exit 1; fi
[ ! -e full.npy ] # whole or not at all
