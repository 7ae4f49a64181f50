#!/bin/sh
# Distributes rows to N partitions by curve, as the shuffle of an engine does: by_curve.sh COLUMN N FOLDER <rows
#
# Cells are separated by tabs; COLUMN is the number of the cell with the name of the curve. FOLDER is created and gets
# the files 0 to N-1.
set -eu
[ $# -eq 3 ] || { echo "usage: by_curve.sh COLUMN N FOLDER <rows" >&2; exit 2; }
mkdir "$3"
awk -F '\t' -v column="$1" -v parts="$2" -v folder="$3" '
  BEGIN { for (part = 0; part < parts; ++part) printf "" >(folder "/" part) }
  { name = $column }
  !(name in part_of) { part_of[name] = curves++ % parts }
  { print >(folder "/" part_of[name]) }'
