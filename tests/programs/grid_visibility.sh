#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# grid_visibility, seen from outside. Usage: grid_visibility.sh FOLDER_OF_PROGRAMS
. "$(dirname "$0")/../support/programs.sh" grid_visibility "$@"

room="8 6 1\n........\n...#....\n....#...\n.#......\n..#.....\n........\n0 0\n"
for method in sweep exact thesis thesis-face-path; do answers "a room, $method" "seen: 31" "$room" --method $method; done
answers "a full cell is seen, what is behind it is not" "0 0 0\n1 0 0" "3 1 1\n.#.\n0 0\n" --list
answers "a closed door" "0 0 0" "2 1 1\n..\n0 0\nwall 0 0 0 x+ closed-door\n" --list
answers "a laser field" "0 0 0\n1 0 0" "2 1 1\n..\n0 0\nwall 0 0 0 x+ laser\n" --list
answers "corners: pinch" "seen: 3" "2 2 1\n.#\n#.\n0 0\n"
answers "corners: open" "seen: 4" "2 2 1\n.#\n#.\n0 0\n" --corners open
answers "corners: pinch, one" "seen: 4" "2 2 1\n.#\n..\n0 0\n"
answers "corners: closed, one" "seen: 3" "2 2 1\n.#\n..\n0 0\n" --corners closed
# The thesis has a rule of its own.
answers "corners of the thesis" "seen: 3" "2 2 1\n.#\n#.\n0 0\n" --method thesis --corners pinch
answers "corners of the thesis, one" "seen: 4" "2 2 1\n.#\n..\n0 0\n" --corners pinch --method thesis
for method in thesis thesis-face-path; do
  for corners in open closed; do
    refused "$method, corners $corners" "--corners" "2 2 1\n.#\n#.\n0 0\n" --method $method --corners $corners
    refused "corners $corners, $method, drawn" "sweep or exact" "$room" --corners $corners --method $method -o room.ppm
  done
done
# The three cells two steps away leave no way from face to face, but are none of the two sets that the thesis prints.
cube="2 2 2\n..\n.#\n\n.#\n#.\n0 0 0\n"
answers "three axes: the thesis" "seen: 8" "$cube" --method thesis
answers "three axes: all sets" "seen: 7" "$cube" --method thesis-face-path
answers "in space" "seen: 8" "2 2 2\n.#\n#.\n\n##\n..\n0 0 0\n" --corners open
answers "no unit" "seen: 0" "2 1 1\n..\n"
answers "pairs" "1 1 0\n1 1 0\n0 0 1" "4 1 1\n..#.\n0 0\n1 0\n3 0\n" --pairs
answers "percent" "0 0 0 100\n1 0 0 100" "3 1 1\n.#.\n0 0\n" --percent
run "$room" -o room.ppm --size 90x80
check "a picture: exit 0: $err" is "$status" 0
check "a picture: its size" is "$(sed -n 2p room.ppm)" "90 80"

# A map of more cells than pixels is drawn smaller, whole, with its units.
wide=$(printf '.%.0s' $(seq 1000))
run "1000 2 1\n$wide\n${wide%.}#\n998 0\n3 1\n" -o wide.ppm --size 50x40
check "a wide map: exit 0: $err" is "$status" 0
check "a wide map: both units are drawn" is "$(count wide.ppm 204 96 72)" 2
check "a wide map: the first at the right end" is "$(pixels wide.ppm | awk '$1 == 204 && $2 == 96 { print (NR - 1) % 50 }' | sort -n | tail -1)" 49
check "a wide map: bright from end to end" test "$(count wide.ppm 255 228 140)" -ge 45
tall=$(for _ in $(seq 300); do printf '%s' '..\n'; done)
run "2 300 2\n$tall$tall\n0 299 1\n" -o tall.ppm --size 64x48
check "a tall map of two layers: exit 0: $err" is "$status" 0
check "a tall map: the unit is drawn" is "$(count tall.ppm 204 96 72)" 1

# The three answers of the thesis: 26 cells seen fully beside the unit, 2 in part, 15 not at all; 2 of 4 pillars.
# A cell is 9 pixels wide and shows 8 x 8 of them.
colours() { # colours FILE: how many cells have the colours of full sight, partial sight, none, a seen and an unseen pillar
  echo $(($(count "$1" 255 228 140) / 64)) $(($(count "$1" 178 200 140) / 64)) $(($(count "$1" 150 150 146) / 64)) \
    $(($(count "$1" 120 96 60) / 64)) $(($(count "$1" 60 66 84) / 64))
}
check "a picture of the exact method has two answers" is "$(colours room.ppm)" "28 0 15 2 2"
for method in thesis thesis-face-path; do
  run "$room" --method $method -o room.ppm --size 90x80
  check "a picture of $method: exit 0: $err" is "$status" 0
  check "a picture of $method has three" is "$(colours room.ppm)" "26 2 15 2 2"
done
run "8 6 1\n........\n...#....\n....#...\n.#......\n..#.....\n........\n0 0\n7 0\n" --method thesis -o room.ppm --size 90x80
check "of two units the better answer: $(colours room.ppm)" is "$(count room.ppm 178 200 140)" 64
run "5 5 1\n.....\n.....\n.#...\n...#.\n.....\n0 0\n" --method thesis -o pillar.ppm --size 70x70
check "a pillar that is seen in part" test "$(count pillar.ppm 96 108 64)" -gt 0
# Walls in the colours of their kinds, seen through or not.
kinds="1 6 1\n.\n.\n.\n.\n.\n.\n0 0\n"
wall_kinds="wall half open-door closed-door laser"
n=0
for kind in $wall_kinds; do kinds="${kinds}wall 0 $n 0 y+ $kind\n" n=$((n + 1)); done
run "$kinds" -o kinds.ppm --size 90x240
check "walls of all kinds: exit 0: $err" is "$status" 0
for colour in "32 44 66" "120 130 150" "200 132 48" "120 72 40" "220 40 60"; do
  check "a wall in $colour" test "$(count kinds.ppm $colour)" -gt 20
done
for kind in $wall_kinds; do
  for side in x y; do
    run "2 2 1\n..\n..\n0 0\nwall 0 0 0 $side+ $kind\n" -o wall.ppm --size 120x120
    seen=$(printf '%s\n' "$out" | sed -n 's/^seen: //p')
    for pair in "32 44 66 wall" "120 130 150 half" "200 132 48 open-door" "120 72 40 closed-door" "220 40 60 laser"; do
      pixels_of_it=$(count wall.ppm ${pair% *})
      if [ "${pair##* }" = $kind ]; then
        check "$kind at $side+ is drawn" test "$pixels_of_it" -gt 20
      else
        check "$kind at $side+ is not drawn as ${pair##* }" is "$pixels_of_it" 0
      fi
    done
    case $kind in
      wall | closed-door) check "$kind blocks" is "$seen" 3 ;;
      *) check "$kind does not block" is "$seen" 4 ;;
    esac
  done
done
run "3 3 2\n...\n...\n...\n...\n...\n...\n0 0\nwall 2 2 1 x+ half\nwall 2 2 1 y+ laser\nwall 0 0 1 x+ wall\n" -o edge.ppm --size 9x9
check "walls at the border of a map of two pixels a cell: $err" is "$status" 0

refused "nothing" "stdin:1:1" ""
refused "a unit in a full cell" "the unit is in a full cell: stdin:3:1" "2 1 1\n.#\n1 0\n"
refused "a unit outside" "the unit is outside of the map: stdin:3:1" "2 1 1\n.#\n2 0\n"
refused "a ragged row" "stdin:2:3" "3 1 1\n..\n"
refused "an unknown cell" "stdin:2:2" "3 1 1\n.x.\n"
refused "percent in space" "depth 1" "1 1 2\n.\n.\n0 0\n" --percent
refused "two lists" "only one of" "$room" --list --pairs
refused "an unknown method" "supported: sweep, exact, thesis, thesis-face-path" "$room" --method fov
refused "no such file" "none.txt" "" --input none.txt
no_room "$(printf "%b" "$room")"

conclude
