#!/bin/sh
# Divides the files below a folder into parts of N files, for the other scripts here: split.sh KEYS JOB [N]
#
# JOB is created and gets folders parts/0000, parts/0001, ... with hard links to the files, in the same folders as in
# KEYS; so JOB and KEYS have to be on one file system. N is 5000 by default.
set -eu
[ $# -ge 2 ] || { echo "usage: split.sh KEYS JOB [N]" >&2; exit 2; }
keys=$1 job=$2 count=${3-5000}
# The output's ending is that of its format, so x.csv and x.json would both become x.csv, in two parts unnoticed.
twice=$(cd "$keys" && find . -type f | sed -nE 's/\.(csv|tsv|ssv|jsonl?)$//p' | LC_ALL=C sort | uniq -d | head -3)
[ -z "$twice" ] || { echo "split.sh: these differ by their endings only, rename some: $twice" >&2; exit 2; }
mkdir "$job" "$job/parts"
parts=$(cd "$job/parts" && pwd)
cd "$keys"
# shellcheck disable=SC2016 # split sets FILE
find . -type f -print0 | LC_ALL=C sort -z |
  split -t '\0' -l "$count" -d -a 4 --filter='mkdir "$FILE" && xargs -0 cp -l --parents -t "$FILE"' - "$parts/"
