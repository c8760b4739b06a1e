#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The contract of `combine_bodies`, seen from outside: volumes, files, refusals.
# usage: combine_bodies.sh FOLDER-WITH-THE-PROGRAMS
# shellcheck source=tests/support/programs.sh
. "$(dirname "$0")/../support/programs.sh" combine_bodies "$@"

helps union intersection difference symmetric-difference --move -o

# Two unit cubes that have an eighth in common.
volume() { sed -n 's/^volume: //p' .out; }
for pair in "union 1.875" "intersection 0.125" "difference 0.875" "symmetric-difference 1.75"; do
  run "" cube "${pair% *}" cube --move 0.5,0.5,0.5 -o made.obj
  check "${pair% *}: exit 0, $err" is "$status" 0
  check "${pair% *}: the volume" is "$(volume)" "${pair#* }"
  check "${pair% *}: of the two" has "$out" $'\nvolumes: 1 1\n'
  run "" made.obj intersection cube --move -5,0,0
  check "${pair% *}: what was written is a body, $err" is "$status" 0
  check "${pair% *}: which meets nothing far off" is "$out" "triangles: 0
positions: 0
volume: 0
volumes: ${pair#* } 1
from: 0 0"
done
run "" cube difference cube
check "a body less itself is nothing: $out" begins "$out" $'triangles: 0\npositions: 0\nvolume: 0\n'
run "" cube union cube --move 1,0,0
check "two cubes that touch in a face: $out" is "$(volume)" 2
for file in made.stl made.ply made.off made.xml; do
  run "" torus difference cube -o "$file"
  check "$file: exit 0, $err" is "$status" 0
  kept=$(volume)
  run "" "$file" union "$file"
  check "$file: as large again" is "$(volume)" "$kept"
done

printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n' >open.obj
fails "an open body" "" cube union open.obj
check "which: $err" ends "$err" "an edge has one face: open.obj"
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 4 2\nf 1 3 4\nf 2 4 3\n' >inside_out.obj
fails "a body turned inside out" "" cube union inside_out.obj --move 0.5,0.5,0.5
fails "a body turned inside out that meets nothing" "" cube union inside_out.obj --move 5,0,0
check "which: $err" ends "$err" ": inside_out.obj"
fails "no such file" "" cube union none.obj
fails "no such operation" "" cube minus cube
fails "one body" "" cube union
fails "another ending" "" cube union cube -o made.png
fails "an empty name of the result" "" cube union cube -o ""
fails "an unknown option" "" cube union cube --turn
fails "a folder that is not there" "" cube union cube -o none/a.obj
fails "writing over what is read" "" made.obj union cube -o made.obj

conclude
