#!/bin/sh
# Draws the pictures for the documents of this folder: pictures.sh [FOLDER], by default this folder.
#
# It needs only tcbsample, in PATH or in ../build/release.
set -eu
cd "$(dirname "$0")"
folder=${1:-.}
PATH=$PATH:../build/release
mkdir -p "$folder/pictures"

draw() { # NAME OPTION... FILE
  name=$1
  shift
  tcbsample -f svg "$@" >"$folder/$name.svg"
}

# The samples.
draw camera --step 0.25 camera.csv
draw pictures/arm --count 51 arm.tsv
draw pictures/ball --step 0.06 ball.csv
draw pictures/loop --arc-step 5 loop.txt
draw pictures/pace --pace ease --fps 4 --columns position=x:y:z camera.csv
draw pictures/animation --step 1 --axes hip_z:hip_y animation.json
draw pictures/events --count 51 events.jsonl
draw pictures/poses --step 0.25 poses.csv
draw pictures/drive --angle heading=degrees --fit 0.1,heading=1 --title "14 keys for a drive" drive.csv

# Keys for a recording of the camera path.
tcbsample --rate 100 --columns position=x:y:z camera.csv |
  draw pictures/fit --fit 0.01 --title "11 keys within 0.01 of a recording"

# One parameter of the middle key, from -1 to 1.
family() { # NAME TITLE
  awk -v name="$1" 'BEGIN {
    print "value,time,x,y,tension,continuity,bias"
    for (v = -1; v <= 1; v += 0.5) {
      t = name == "tension" ? v : 0; c = name == "continuity" ? v : 0; b = name == "bias" ? v : 0
      printf "%g,0,0,0,0,0,0\n%g,1,1,1.5,0,0,0\n%g,2,2.5,2,%g,%g,%g\n%g,3,4,0.5,0,0,0\n%g,4,5,0,0,0,0\n", \
             v, v, v, t, c, b, v, v
    }
  }' | draw "pictures/$1" -g value --columns time=time,position=x:y --count 33 --title "$2"
}
family tension "Tension of the third key: -1 to 1"
family continuity "Continuity of the third key: -1 to 1"
family bias "Bias of the third key: -1 to 1"

# The same uneven keys with each of some rules.
rules() { # NAME SETTING TITLE RULE...
  name=$1 setting=$2 title=$3
  shift 3
  for rule in "$@"; do
    printf '{"id":"%s","%s":"%s","keys":[' "$rule" "$setting" "$rule"
    printf '{"time":0,"x":0,"y":0},{"time":1,"x":1,"y":2},{"time":1.5,"x":3,"y":2.5},'
    printf '{"time":4,"x":4,"y":0},{"time":4.5,"x":6,"y":1}]}\n'
  done | awk 'BEGIN { print "{\"curves\":[" } { print (NR > 1 ? "," : "") $0 } END { print "]}" }' |
    draw "pictures/$name" --count 91 --title "$title" --size 1022x560
}
rules presets preset "Each preset through the same uneven keys" \
  $(tcbsample --list-presets | awk 'NR > 1 && NF == 0 { exit } NR > 1 && !/^ / { print $1 }')
rules ends ends "Each end rule through the same uneven keys" \
  one-sided half mirror chord zero natural natural-tension cry lightwave
