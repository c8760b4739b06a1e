#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The contract of `mend_body`, seen from outside: faults, what is mended, files, refusals.
# usage: mend_body.sh FOLDER-WITH-THE-PROGRAMS
# shellcheck source=tests/support/programs.sh
. "$(dirname "$0")/../support/programs.sh" mend_body "$@"

helps before after turned volume --list -o

# A tetrahedron with a position twice and a face the wrong way round.
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 1 0 0\nf 1 3 2\nf 4 2 1\nf 1 4 3\nf 3 4 5\n' >torn.obj
for file in mended.obj mended.stl mended.ply mended.off mended.xml; do
  run "" torn.obj -o "$file"
  check "mended: exit 0, $err" is "$status" 0
  check "mended: $out" is "$out" $'before: 7\nafter: 0\nturned: done\nvolume: 0.16666666666666666'
  run "" "$file"
  check "$file: nothing is left to mend: $out" ends "$out" $'after: 0\nturned: done\nvolume: 0.16666666666666666'
done
run "" mended.obj
check "OBJ keeps it so: $out" begins "$out" "before: 0"
run "" torn.obj --list
check "no faults left, none listed" is "$out" ""

printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n' >open.obj
run "" open.obj
check "an open surface: $out" is "$out" $'before: 3\nafter: 3\nturned: open'
run "" open.obj --list
check "its faults in words: $out" has "$out" "the edge from position 0 to 1 has only one face, 0"
check "a line for each" is "$(wc -l <.out)" 3
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 0 -1\nf 1 2 3\nf 1 2 4\nf 1 2 5\n' >fan.obj
run "" fan.obj
check "three faces at an edge: $out" ends "$out" "turned: no-surface"

fails "no model" ""
fails "an empty name of the result" "" cube -o ""
fails "no such file" "" none.obj
fails "another ending" "" torn.obj -o mended.png
fails "writing over what is read" "" torn.obj -o torn.obj
fails "a folder that is not there" "" torn.obj -o none/a.obj
fails "an unknown option" "" torn.obj --weld
fails "a second model" "" torn.obj open.obj
printf 'v 0 0 0\nf 1 2 3\n' >broken.obj
fails "a broken file" "" broken.obj
check "where: $err" ends "$err" ": broken.obj:2:5"

conclude
