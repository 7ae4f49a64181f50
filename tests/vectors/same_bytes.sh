#!/bin/sh
# Makes the published vectors again, and compares all bytes: same_bytes.sh PROGRAM VECTORS.
set -eu
PATH=$(dirname "$1"):$PATH
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
python3 "$2/make_vectors.py" "$scratch"
for folder in presets tangents rotations; do
  diff -r "$scratch/$folder" "$2/$folder"
done
for file in "$scratch"/*.json "$scratch"/*.csv; do
  cmp "$file" "$2/$(basename "$file")"
done
