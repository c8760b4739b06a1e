#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The contract of `body_point`, seen from outside: the course's cube, a prism over an L, planes, refusals, files.
# usage: body_point.sh FOLDER-WITH-THE-PROGRAMS
# shellcheck source=tests/support/programs.sh
. "$(dirname "$0")/../support/programs.sh" body_point "$@"

answer() { tr '\n' ';' <.out; }

helps MODEL OBJ STL PLY OFF XML --input --list --size -o

# ---- the course's cube
run "0.5 0.5 0.5  0.25 0.75 0.1  2 0 0  1 1 1  0.5 0.5 1  1 1 0.5  -1 -1 -1  0.5 0.5 1.1 # the end" cube
check "the cube: exit 0: $err" is "$status" 0
check "silent on standard error" is "$err" ""
check "points of the cube" is "$(answer)" "point: inside;point: inside;point: outside;point: boundary;point: boundary;point: boundary;point: outside;point: outside;convex: yes;closed: yes;"
run "" cube
check "no points" is "$(answer)" "convex: yes;closed: yes;"
run "" cube --list
check "the planes of its faces" is "$(answer)" "0 -1 0 0;0 -1 0 0;1 0 0 -1;1 0 0 -1;0 1 0 -1;0 1 0 -1;-1 0 0 0;-1 0 0 0;0 0 -1 0;0 0 -1 0;0 0 1 -1;0 0 1 -1;"

# ---- a concave body, its bases of six corners
cat >l.obj <<'END'
v 0 0 0
v 3 0 0
v 3 1 0
v 1 1 0
v 1 3 0
v 0 3 0
v 0 0 1
v 3 0 1
v 3 1 1
v 1 1 1
v 1 3 1
v 0 3 1
f 6 5 4 3 2 1
f 7 8 9 10 11 12
f 1 2 8 7
f 2 3 9 8
f 3 4 10 9
f 4 5 11 10
f 5 6 12 11
f 6 1 7 12
END
run "0.5 0.5 0.5 2 2 0.5 2.5 0.5 0.25 0.5 2.5 0.75 5 5 5 -1 0.5 0.5 1 1 0.5 2 2 1 2 1 0.5" l.obj
check "points of the prism" is "$(answer)" "point: inside;point: outside;point: inside;point: inside;point: outside;point: outside;point: boundary;point: outside;point: boundary;convex: no;closed: yes;"
run "" l.obj --list
check "planes, with the sign that three corners give" is "$(answer)" "0 0 -2 0;0 0 3 -3;0 -3 0 0;1 0 0 -3;0 2 0 -2;2 0 0 -2;0 1 0 -3;-3 0 0 0;"

# ---- at the ends of the range, and one unit in the last place off
scaled() { sed -E "s/^v (.*)/v \1/; s/^v ([0-9]) ([0-9]) ([0-9])/v \1e$1 \2e$1 \3e$1/" l.obj >scaled.obj; }
for e in 300 -300 -320; do
  scaled "$e"
  run "1e$e 1e$e 0.5e$e  0.5e$e 2.5e$e 0.75e$e  2e$e 2e$e 0.5e$e" scaled.obj
  check "size 1e$e" is "$(answer)" "point: boundary;point: inside;point: outside;convex: no;closed: yes;"
done
run "1 1.0000000000000002 0.5  0.9999999999999999 0.9999999999999999 0.5" l.obj
check "an ulp beside a side" is "$(answer)" "point: boundary;point: inside;convex: no;closed: yes;"
printf 'v 1e16 0 0\nv 10000000000000002 0 0\nv 1e16 2 0\nv 1e16 0 2\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n' >thin.obj
run "10000000000000002 0 0" thin.obj
check "a body that is two units in the last place wide" is "$(answer)" "point: boundary;convex: yes;closed: yes;"

# ---- open, turned inside out, faces without area, corners on a line
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n' >open.obj
run "" open.obj
check "an open surface" is "$(answer)" "convex: no;closed: no;"
printf 'v 0 0 0\nv 1 1 1\nv 2 2 2\nf 1 2 3\nf 1 1 2\n' >line.obj
run "" line.obj --list
check "no plane through corners on a line" is "$(answer)" "0 0 0 0;0 0 0 0;"
printf 'v 0 0 0\nv 0 0 0\nv 1 0 0\nv 2 0 0\nv 2 2 0\nf 1 2 3 4 5\n' >late.obj
run "" late.obj --list
check "the first three corners that are not on a line" is "$(answer)" "0 0 2 0;"

# ---- pictures
run "0.5 0.5 0.5 1 1 1 2 2 2" cube -o wire.png --size 200x150
check "a picture: exit 0: $err" is "$status" 0
check "a picture" test -s wire.png
run "0.5 0.5 0.5" cube -o wire.svg --list
check "as SVG" has "$(cat wire.svg)" "<svg"

# ---- refusals
refused "no model" "no model" ""
refused "two models" "torus" "" cube torus
refused "a missing file" "missing.obj" "" missing.obj
printf '# nothing\nv 0 0 0\n' >points.obj
refused "a model without faces" "no faces" "" points.obj
printf 'v 0 0 0\nf 1 2 3\n' >range.obj
refused "an index out of range" "range.obj:2:5" "" range.obj
strange_models
refused "two of three numbers" "stdin:1:4" "1 2" cube
refused "a word" "stdin:2:3" "1 2 3\n4 five 6" cube
refused "NaN" "stdin:1:1" "nan 0 0" cube
refused "infinity" "stdin:1:3" "0 inf 0" cube
refused "an unknown option" "--planes" "" cube --planes
refused "a picture of no kind" ".svg" "" cube -o picture.jpg
cp l.obj l.ppm
refused "a picture over its model" "overwritten" "" l.ppm -o ./l.ppm
conclude
