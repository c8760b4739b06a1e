#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# gallery_guards, seen from outside. Usage: gallery_guards.sh FOLDER_OF_PROGRAMS
. "$(dirname "$0")/../support/programs.sh" gallery_guards "$@"

room="1 4 0 0 2 0 2 2 0 2"
bent="1 6 0 0 3 0 3 1 1 1 1 3 0 3 # an L"
answers "a room" "guards: 1\nat_least: 1\nparts: 1\nguard: 0 0" "$room"
answers "the proof of a room" "0 0 0 2 0 0 2 0 2 2" "$room" --list
answers "no rings" "guards: 0\nat_least: 0\nparts: 0" "0"
answers "an empty ring" "guards: 0\nat_least: 0\nparts: 0" "1 0"
run "$bent"
check "an L: one guard: $out" begins "$out" "guards: 1
at_least: 1"
hole="2 4 0 0 9 0 9 9 0 9 4 4 4 5 4 5 5 4 5"
run "$hole"
check "round a pillar: two guards: $out" begins "$out" "guards: 2"
run "$hole" --list
check "round a pillar: each part has a guard and three corners or more" \
  is "$(awk 'NF < 8 || NF % 2 { bad = 1 } END { print (NR > 4 && !bad) }' .out)" 1
pictures_of_all_sizes "$hole"
pictures_of_all_sizes "0"

refused "nothing" "stdin:1:1" ""
refused "a corner too few" "y of corner 4" "1 4 0 0 2 0 2 2 0"
refused "no number" "stdin:2:5" "1 3\n0 0 x 1 1 1"
refused "a number too many" "stdin:1:21" "$room 7"
refused "too many corners" "stdin:1:3" "1 101"
refused "too many corners of two rings" "more than 100" "2 3 0 0 1 0 0 1 98"
refused "an endless corner" "stdin:1:5" "1 3 inf 0 1 0 0 1"
refused "rings that cross" "the rings cross" "1 4 0 0 2 2 2 0 0 2"
refused "a ring without area" "the rings cross" "1 3 0 0 1 1 2 2"
refused "an unknown option" "--colour" "$room" --colour red
refused "a picture of unknown ending" ".png" "$room" -o x.gif
refused "no such file" "none.txt" "" --input none.txt
no_room "$room"

conclude
