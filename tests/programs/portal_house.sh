#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# portal_house, seen from outside. Usage: portal_house.sh FOLDER_OF_PROGRAMS
. "$(dirname "$0")/../support/programs.sh" portal_house "$@"

# Three rooms in a row and one that only the last one sees.
rooms="cell a 0 0 1 0 1 3 0 3\ncell b 1 0 2 0 2 3 1 3\ncell c 2 0 3 0 3 3 2 3\ncell d 2 3 3 3 3 4 2 4\n"
rooms+="portal a b 1 1 1 2\nportal b c 2 1.5 2 2.5\nportal c d 2 3 2.1 3\n"
answers "all rooms" "a: a b c\nb: a b c d\nc: a b c d\nd: b c d" "$rooms"
answers "an eye" "a: a b c" "$rooms" --eye 0.5,1.5,0.5
answers "an eye that only touches ends" "a: a b" "$rooms" --eye 0,2.5,0.5
answers "no rooms" "" "# nothing\n"
run "$rooms" --eye 0.5,1.5,0.5 -o with.ppm --size 90x80
check "a picture: exit 0: $err" is "$status" 0
check "a picture: what was skipped: $out" has "$out" "of them in rooms that were skipped"
check "a picture: its size" is "$(sed -n 2p with.ppm)" "90 80"
run "$rooms" --eye 0.5,1.5,0.5 -o without.ppm --size 90x80 --skip off
check "a picture without skips: $out" has "$out" ", 0 of them"
check "a picture without skips: the same bytes" cmp -s with.ppm without.ppm
run "$rooms" --sets sets.bin
check "sets: exit 0: $err" is "$status" 0
check "sets: their first line" is "$(head -n 1 sets.bin)" "visible cells 4 unfinished 0"
check "sets: their bits" is "$(tail -c 4 sets.bin | od -An -tu1 | tr -s ' ')" " 7 15 15 14"

refused "a word that is none" "none of cell, heights and portal: stdin:1:1" "room a\n"
refused "a ragged cell" "stdin:1:17" "cell a 0 0 1 0 1\n"
refused "a cell that is not convex" "not convex: stdin:1:1" "cell a 0 0 4 0 1 1 0 4\n"
refused "a mirror" "mirrors are not supported: stdin:2:1" "cell a 0 0 1 0 0 1\nportal a a 0 0 1 0\n"
refused "a portal off the wall" "side of both of its cells: stdin:3:1" \
  "cell a 0 0 1 0 0 1\ncell b 1 0 2 0 2 1\nportal a b 0 0 1 0\n"
refused "an eye outside" "the eye is in no cell" "$rooms" --eye 9,9,9
refused "a picture without an eye" "needs an eye" "$rooms" -o p.ppm
refused "an eye that looks down" "straight up or down" "$rooms" --eye 0.5,1.5,0.5 --look 0.5,1.5,0 -o p.ppm
refused "no such file" "none.txt" "" --input none.txt

# In space: a cube, a pyramid on it, and a tent beside the cube.
hut="point 0 0 0\npoint 4 0 0\npoint 4 4 0\npoint 0 4 0\npoint 0 0 4\npoint 4 0 4\npoint 4 4 4\npoint 0 4 4\npoint 2 2 6\n"
hut+="cell room\nface 4 3 2 1\nface 5 6 7 8\nface 1 2 6 5\nface 2 3 7 6\nface 3 4 8 7\nface 4 1 5 8\n"
hut+="cell roof\nface 8 7 6 5\nface 5 6 9\nface 6 7 9\nface 7 8 9\nface 8 5 9\n"
hut+="point 8 2 0\ncell tent\nface 2 6 7 3\nface 2 10 6\nface 3 7 10\nface 6 10 7\nface 2 3 10\n"
hut+="point 1 1 4\npoint 3 1 4\npoint 3 3 4\npoint 4 1 1\npoint 4 3 1\npoint 4 2 2\n"
doors="portal room roof 11 12 13\nportal room tent 14 15 16\n"
answers "a plan in space" "room: room roof tent\nroof: room roof tent\ntent: room roof tent" "$hut$doors"
answers "an eye in space" "roof: room roof" "$hut$doors" --eye 3.5,2,4.25
run "$hut$doors" --sets sets.bin
check "sets in space: their bits" is "$(tail -c 3 sets.bin | od -An -tu1 | tr -s ' ')" " 7 7 7"
refused "a face that lacks a corner" "fewer than three corners, or the first three are on a line: stdin:11:1" \
  "${hut/face 4 3 2 1/face 4 3}$doors"
refused "a cell in space that is not convex" "not convex: a corner of it is before this face: stdin:18:1" \
  "${hut/point 2 2 6/point 2 2 3}$doors"
refused "a cell with a hole" "once each way: stdin:17:1" "${hut/face 7 8 9\\n/}$doors"
refused "a point that lacks a coordinate" "stdin:1:10" "point 1 2\n"
refused "a point that is nowhere" "not finite: stdin:1:11" "point 1 2 inf\n"
refused "a portal without area" "no area" "${hut}portal room roof 11 12 11\n"
refused "cells that do not share the portal" "both sides of it: stdin:36:1" "${hut}portal room roof 14 15 16\n"
refused "a portal beyond the wall" "in a face of both of its cells" "${hut/point 4 3 1/point 4 9 1}portal room tent 14 15 16\n"
refused "a mirror in space" "mirrors are not supported" "${hut}portal room room 14 15 16\n"
refused "a picture of a plan in space" "no picture" "$hut$doors" --eye 2,2,2 -o p.ppm
refused "an eye outside of all cells" "the eye is in no cell" "$hut$doors" --eye 9,9,9
refused "sets in no folder" "folder of the file does not exist: nowhere/sets" "$rooms" --eye 0.5,1.5,0.5 -o p.ppm \
  --sets nowhere/sets
"$program" <. >.out 2>.err
check "standard input that is a folder: exit 2" is "$?" 2
check "standard input that is a folder: says so" is "$(cat .err)" "portal_house: input cannot be read: stdin"
if [ -e /dev/full ]; then
  printf '%b' "$rooms" | "$program" --eye 0.5,1.5,0.5 -o full.ppm --sets full.bin >/dev/full 2>.err
  check "a full disk: exit 2" is "$?" 2
  check "a full disk: leaves no picture and no sets" is "$(ls full* 2>/dev/null)" ""
fi

conclude
