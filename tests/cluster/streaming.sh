#!/bin/sh
# Partitions of a grouped file, sampled one by one, give the rows of the whole file: streaming.sh PROGRAM SCRIPTS.
#
# As after the shuffle of an engine, the rows of a partition have no order, and one partition is empty.
set -eu
scripts=$(realpath "$2")
PATH=$(dirname "$(realpath "$1")"):$PATH
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"
seq 0 49999 | awk '
  BEGIN { OFS = "\t" }
  { curve = $1 * 7919 % 1000; print "c" curve, $1, sin($1), curve - $1 / 1e4, $1 % 3 - 1 }' >keys
sample() { "$@" -i tsv -f tsv --columns group=1,time=2,position=3:4,tension=5 --sort --step 250; }

sample tcbsample --no-header --no-output-header <keys | sort -s -k 1,1 >whole
sh "$scripts/by_curve.sh" 1 7 parts <keys
: >parts/7
for part in parts/*; do
  sort -t "$(printf '\t')" -k 3,3 "$part" >shuffled
  sample sh "$scripts/sample_partition.sh" <shuffled >>rows
done
sort -s -k 1,1 rows >joined
[ "$(cut -f 1 whole | uniq | wc -l)" = 1000 ] || { echo "not all curves are there"; exit 1; }
cmp whole joined

# A failure is the exit code of the command, which the engine checks.
! printf 'c\t0\tzero\nc\t1\t1\n' | sh "$scripts/sample_partition.sh" --step 1 --group 1 2>errors || { echo "bad data passed"; exit 1; }
grep -q 'zero' errors || { cat errors; exit 1; }
