#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# street_view_2d, seen from outside. Usage: street_view_2d.sh FOLDER_OF_PROGRAMS
. "$(dirname "$0")/../support/programs.sh" street_view_2d "$@"

open="0 0 4 4 0"
square="0 0 8 8 1 4 3 3 5 3 5 5 3 5 # a house in the middle"
answers "no houses" "view: 1 1 16 0\nseen:" "$open 1 1"
answers "a house in the middle, from the left" "view: 1 4 41.5 1\nseen: 0" "$square\n1 4"
answers "its other way round" "view: 1 4 41.5 1\nseen: 0" "0 0 8 8 1 4 3 5 5 5 5 3 3 3 1 4"
answers "from within" "view: 4 4 house 0\nseen:" "$square\n4 4"
answers "from its wall" "view: 3 4 house 0\nseen:" "$square\n3 4"
answers "a path in the open" "view: 1 1 16 0\nview: 3 1 16 0\nseen:\nleg: 0 16 0 0" "$open 1 1 3 1"
answers "with steps" "view: 1 1 16 0\nview: 2 1 16 0\nview: 3 1 16 0\nseen:\nleg: 0 16 0 0" "$open 1 1 3 1" --step 1
run "0 0 10 10 2 4 0 0 1 0 1 10 0 10 4 0 0 1 0 1 5 0 5 2 1 8 1" # along a house and one in it
check "a leg: the insides of houses are not seen: $out" ends "$out" "leg: 0 90 0 10"
answers "a path through the house" "view: 1 4 41.5 1\nview: 7 4 41.5 1\nseen: 0\nleg: 0 crosses a wall" "$square\n1 4 7 4"
answers "without legs" "view: 1 4 41.5 1\nview: 7 4 41.5 1\nseen: 0" "$square\n1 4 7 4" --legs off
answers "a house that hides another" "view: 1 4 41.5 1\nseen: 0" "0 0 8 8 2 4 3 3 5 3 5 5 3 5 3 7 4 6 3.5 6 4.5 1 4"
answers "houses without corners" "view: 1 1 16 0\nseen:" "0 0 4 4 2 0 0 1 1"
answers "the polygon" "0 4 4 border\n0 0 4 border\n0 0 0 border\n0 4 0 border" "$open 1 1" --list
run "$square\n1 4" --list
check "the polygon of a house: $out" is "$(awk '$4 == 0' .out)" "0 3 3 0"
check "two lines of sight" is "$(awk '$4 == "-"' .out | wc -l)" 2
# A town of a hundred houses, walked through: the areas of all and some of a leg are what is seen from its ends at least.
town=$(awk 'BEGIN { printf "0 0 100 100 100"
  for (i = 0; i < 100; ++i) { x = 10 * (i % 10) + 2; y = 10 * int(i / 10) + 2; w = 4 + i * 7 % 3; h = 4 + i * 5 % 3
    printf " 4 %d %d %d %d %d %d %d %d", x, y, x + w, y, x + w, y + h, x, y + h } }')
run "$town 0.5 0.5 0.5 99" --step 9
check "a hundred houses: $err" is "$status" 0
check "no legs among so many walls" is "$(grep -c leg .out)" 0
check "the places of a path" is "$(grep -c view .out)" 12
small="0 0 20 20 3 4 5 5 8 5 8 9 5 9 4 12 3 15 3 15 8 12 8 3 9 12 14 12 11 16"
run "$small 2 10 18 10"
check "some of a leg is seen from more places than its end: $out" \
  is "$(awk '/^view/ { if ($4 > most) most = $4 } /^leg/ { print ($3 + $4 >= most && $3 + $4 + $5 > 399.999 && $3 + $4 + $5 < 400.001) }' .out)" 1
pictures_of_all_sizes "$small 2 10 18 10"
pictures_of_all_sizes "$open 1 1"
run "$small 2 10" -o t.svg
check "in vectors: regions, not pixels" is "$(grep -c '<path' t.svg)" 4
check "no rows of pixels" is "$(grep -c '<rect' t.svg)" 1

refused "nothing" "stdin:1:1" ""
refused "no place" "x of place 1" "$open"
refused "half a place" "y of place 1" "$open 1"
refused "no number" "stdin:1:9" "0 0 4 4 x"
refused "a town without area" "no area" "0 0 0 4 0 1 1"
refused "a town too large" "1e150" "-1e308 -1e308 1e308 1e308 0 1 1"
refused "a place out of the town" "not in the town" "$open 5 1"
refused "a house out of the town" "not in the town" "0 0 4 4 1 3 1 1 5 1 1 2 1 3"
refused "infinity" "stdin:1:11" "$open inf 1"
refused "a house too many corners" "stdin:1:11" "0 0 4 4 1 100001"
refused "no step" "over 0" "$open 1 1" --step 0
refused "steps without end" "100000 places" "$open 1 1 3 1" --step 1e-9
refused "an unknown option" "--colour" "$open 1 1" --colour red
refused "legs of another kind" "on, off" "$open 1 1" --legs maybe
refused "a picture of unknown ending" ".png" "$open 1 1" -o x.gif
refused "no such file" "none.txt" "" --input none.txt
refused "a folder that does not exist" "folder" "$open 1 1" -o none/x.svg
no_room "$open 1 1"

conclude
