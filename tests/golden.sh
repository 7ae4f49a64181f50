#!/bin/sh
# Runs one golden case: golden.sh PROGRAM FOLDER.
#
# FOLDER has cmd (a shell command, run in a scratch copy of the folder) and its expected results:
# expected (standard output, default none), errors (standard error, default none), status (exit code,
# default 0). Besides PROGRAM it may call those of the folder TCBSAMPLE_CALLS, if there is one; see
# called_programs.py. A case that ends with 77 is skipped, and says why. The numbers in `expected` are computed
# by hand or with fractions, never by the program.
set -u
program=$1 folder=$2
scratch=$(mktemp -d) || exit 1
trap 'rm -rf "$scratch"' EXIT
cp -R "$folder/." "$scratch" && cd "$scratch" || exit 1
[ ! -d "${TCBSAMPLE_CALLS-}" ] || PATH=$TCBSAMPLE_CALLS
PATH=$(dirname "$program"):$PATH

sh ./cmd >"$scratch.out" 2>"$scratch.err" </dev/null
status=$?
trap 'rm -rf "$scratch" "$scratch.out" "$scratch.err"' EXIT
[ "$status" != 77 ] || { cat "$scratch.out"; exit 77; } # skipped

failed=0
[ -f expected ] || : >expected
[ -f errors ] || : >errors
[ -f status ] || echo 0 >status
diff -u expected "$scratch.out" || failed=1
diff -u errors "$scratch.err" || failed=1
[ "$status" = "$(cat status)" ] || { echo "exit code $status, expected $(cat status)"; failed=1; }
exit $failed
