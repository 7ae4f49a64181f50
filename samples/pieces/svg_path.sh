#!/bin/sh
# The path of two channels as the data of an SVG path: svg_path.sh KEYS X Y
tcbsample --emit bezier --columns "position=$2:$3" --no-output-header "$1" | awk -F, '
  NR == 1 { printf "M %s %s\n", $3, $7 }
  { print "C", $4, $8 ",", $5, $9 ",", $6, $10 }'
