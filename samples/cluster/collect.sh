#!/bin/sh
# Finishes a job, and puts the rows of all its files into one table: collect.sh JOB [OPTION]...
#
# JOB and the OPTIONs are those that the parts were sampled with. Files that the parts have not finished are sampled
# here. Files that cannot be sampled are reported again, with exit code 1 and no table. The table JOB/rows.csv has the
# name of the file before each row; it needs CSV with a header, and no other format.
set -eu
[ $# -ge 1 ] || { echo "usage: collect.sh JOB [OPTION]..." >&2; exit 2; }
cd "$1"
shift
rm -f rows.csv
tcbsample --recursive --update --output-dir rows "$@" parts/*
cd rows
names=$(find . -type f -name '*.csv' -exec sed -n 1p {} \; -quit)
export names
[ -n "$names" ] || exit 0
# shellcheck disable=SC2016 # for awk
{
  printf 'file,%s\n' "$names"
  find . -type f -name '*.csv' -print0 | LC_ALL=C sort -z | xargs -0 awk '
    FNR > 1 { print file "," $0; next }
    $0 != ENVIRON["names"] { print FILENAME ": other names above the rows: " $0 >"/dev/stderr"; exit 1 }
    { file = substr(FILENAME, 3) }
    gsub(/"/, "\"\"", file) || file ~ /,/ { file = "\"" file "\"" }'
} >../rows.csv.unfinished
mv ../rows.csv.unfinished ../rows.csv
