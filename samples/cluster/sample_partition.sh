#!/bin/sh
# Samples one partition of an engine that pipes records to a command: sample_partition.sh OPTION... <rows >samples
#
# Neither the rows nor the samples have a header. An engine may have empty partitions, which have no samples.
set -eu
IFS= read -r first || [ -n "$first" ] || exit 0
{ printf '%s\n' "$first" && cat; } | tcbsample --no-header --no-output-header "$@"
