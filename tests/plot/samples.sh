#!/bin/sh
# Draws the pictures of the samples again, and compares: samples.sh PROGRAM SAMPLES.
set -eu
PATH=$(dirname "$1"):$PATH
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
sh "$2/pictures.sh" "$scratch" 2>"$scratch/notes" || { cat "$scratch/notes"; exit 1; }
cmp "$scratch/camera.svg" "$2/camera.svg"
for picture in "$2"/pictures/*.svg; do
  cmp "$scratch/pictures/$(basename "$picture")" "$picture"
done
[ "$(ls "$scratch/pictures")" = "$(ls "$2/pictures" | grep '[.]svg$')" ]
