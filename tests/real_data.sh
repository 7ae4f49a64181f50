#!/bin/sh
# Real recordings resample with no option but the sampling one: real_data.sh PROGRAM FOLDER. Exit 77: no FOLDER.
set -eu
program=$1 folder=$2
[ -d "$folder" ] || { echo "skipped: there is no $folder"; exit 77; }
check() { [ "$2" = "$3" ] || { echo "$1: $2, expected $3"; exit 1; }; }

tum=$folder/tum_freiburg1_xyz.txt
rows=$("$program" --step 0.01 "$tum")
check "names" "$(echo "$rows" | head -1)" timestamp,tx,ty,tz,qx,qy,qz,qw
check "first row" "$(echo "$rows" | sed -n 2p | cut -d, -f1-4)" 1305031098.6659,1.3563,0.6305,1.638
# The number of whole hundredths from 1305031098.6659 to the last key, plus one.
last=$(grep -v '^#' "$tum" | tail -1 | cut -d' ' -f1)
count=$(awk -v t="$last" 'BEGIN { split(t, a, "."); split("1305031098.6659", b, "."); print int(((a[1] - b[1]) * 10000 + a[2] - b[2]) / 100) + 1 }')
check "rows" "$(echo "$rows" | sed 1d | wc -l)" "$count"

euroc=$folder/euroc_v102_first2000.csv
rows=$("$program" --step 5000000 "$euroc")
check "first name" "$(echo "$rows" | head -1 | cut -d, -f1,2)" "timestamp,p_RS_R_x [m]"
stamps=$(echo "$rows" | sed 1d | cut -d, -f1)
want=$(seq 0 $(($(echo "$stamps" | wc -l) - 1)) | awk '{printf "%s\n", $1}' | while read -r j; do echo $((1403715524907143168 + j * 5000000)); done)
check "stamps" "$(echo "$stamps" | cksum)" "$(echo "$want" | cksum)"

# Rotations stay rotations.
if command -v python3 >/dev/null; then
  unit() { python3 "$(dirname "$0")/unit_rotations.py" "$@"; }
  "$program" -q --step 0.01 "$tum" | unit qx qy qz qw
  "$program" -q --step 5000000 "$euroc" | unit 'q_RS_x []' 'q_RS_y []' 'q_RS_z []' 'q_RS_w []'
fi
