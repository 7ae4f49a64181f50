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

# LightWave wrote its own tangents into its scene: the two last numbers but one of each key of the moving channel.
scene=$folder/lws/move_x.lws
slopes() { "$program" -q --per-segment 1 --fields time,velocity --side "$1" "$scene" | sed 1d | cut -d, -f3,4; }
awk '/^Channel 0/ { n = 1 } n == 1 && $1 == "Key" { print $3, $8, $9 } /^Channel 1/ { exit }' "$scene" |
  awk -v left="$(slopes left)" -v right="$(slopes right)" '
    BEGIN { split(left, into, "\n"); split(right, out, "\n") }
    { time[NR] = $1; incoming[NR] = $2; outgoing[NR] = $3 }
    function differs(slope, tangent, h) { d = slope - tangent / h; return d > 4e-16 * 10 || d < -4e-16 * 10 }
    END {
      for (i = 1; i <= NR; ++i) {
        split(into[i], a, ","); split(out[i], b, ",")
        if (i > 1 && differs(a[2], incoming[i], time[i] - time[i - 1])) { print "incoming tangent of key", i; exit 1 }
        if (i < NR && differs(b[2], outgoing[i], time[i + 1] - time[i])) { print "outgoing tangent of key", i; exit 1 }
      }
      if (NR != 3) exit 1
    }'
check "old scene" "$("$program" -q --per-segment 1 "$folder/lws/move_x_oldformat_56.lws" | tail -1)" "simple_cube,position,1.333333,-2.374866,-0.04,0"

# The camera of a .3ds file moves between its four keys.
check "camera" "$("$program" -q --only Camera01/position --per-segment 1 "$folder/3ds/TargetCameraAnim.3ds" | sed 1d | cut -d, -f3 | tr '\n' ' ')" "0 30 60 90 "
