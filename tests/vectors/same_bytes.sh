#!/bin/sh
# Makes the published vectors again, and compares all bytes: same_bytes.sh PROGRAM VECTORS.
set -eu
PATH=$(dirname "$1"):$PATH
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
python3 "$2/make_vectors.py" "$scratch"
diff -r "$scratch/presets" "$2/presets"
diff -r "$scratch/tangents" "$2/tangents"
for file in "$scratch"/*.json "$scratch"/*.csv; do
  cmp "$file" "$2/$(basename "$file")"
done
