#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The contract of `view_projection`, seen from outside: the course's views, models, refusals, files left behind.
# usage: view_projection.sh FOLDER-WITH-THE-PROGRAMS
# shellcheck source=tests/support/programs.sh
. "$(dirname "$0")/../support/programs.sh" view_projection "$@"

# near "numbers" "numbers": as many, and no two further apart than 1e-12
near() {
  awk -v a="$1" -v b="$2" 'BEGIN {
    n = split(a, x, " "); if (n != split(b, y, " ")) exit 1
    for (i = 1; i <= n; ++i) { d = x[i] - y[i]; if (d > 1e-12 || d < -1e-12) exit 1 }
  }'
}

# ---- help
helps usage: MODEL --fit --input --list --size -o

# ---- the course's first view
cube="0 0 0  0 0 1  1 0 0  1 0 1  1 1 0  1 1 1  0 1 0  0 1 1"
run "1 1 3  0 0 0  8  $cube"
check "the cube: exit 0: $err" is "$status" 0
check "silent on standard error" is "$err" ""
check "the order of the lines" is "$(sed 's/:.*//' .out | head -n 7 | tr '\n' ' ')" "T P H eye screen eye screen "
check "two lines a point" is "$(wc -l <.out)" 19
check "T" near "$(line T)" "-0.707106781186548 -0.639602149066831 -0.301511344577764 0 0.707106781186548 -0.639602149066831 -0.301511344577764 0 0 0.426401432711221 -0.904534033733291 0 0 0 3.3166247903554 1"
check "P" near "$(line P)" "1 0 0 0 0 1 0 0 0 0 0 0.301511344577764 0 0 0 0"
check "H" is "$(line H)" 3.3166247903554
check "eye" near "$(line eye | sed -n 4p)" "-0.707106781186548 -0.213200716355610 2.110579412044345"
check "screen" near "$(line screen | tr '\n' ' ')" "0 0  0 0.586301969977929  -0.777817459305202 -0.703562363973514 -1.11116779900743 -0.335029697130245  0 -1.56347191994114  0 -1.56347191994114  0.777817459305202 -0.703562363973514 1.11116779900743 -0.335029697130245"
cp .out whole
run "1 1 3  0 0 0  8  $cube" --list
check "--list: the places, one a line" is "$out" "$(sed -n 's/^screen: //p' whole)"

# ---- views in whole numbers
run "0 -5 0  0 0 0  4  1 0 0  0 0 1  1 5 1  -2 -1 3"
check "the second view" is "$(tr '\n' ';' <.out)" "T: 1 0 0 0 0 0 1 0 0 1 0 0 0 0 5 1;P: 1 0 0 0 0 1 0 0 0 0 0 0.2 0 0 0 0;H: 5;eye: 1 0 5;screen: 1 0;eye: 0 1 5;screen: 0 1;eye: 1 1 10;screen: 0.5 0.5;eye: -2 3 4;screen: -2.5 3.75;"
run "4 6 3  1 2 3  1  2 2 4"
check "the third view" near "$(line T) $(line H) $(line eye) $(line screen)" "-0.8 0 -0.6 0 0.6 0 -0.8 0 0 1 0 0 -0.4 -3 7.2 1 5 -0.8 1 4.4 -0.909090909090909 1.136363636363636"
run "0 0 5  0 0 0  2  1 0 0  0 1 0"
check "straight down" is "$(tr '\n' ';' <.out)" "T: 0 1 0 0 -1 0 0 0 0 0 -1 0 0 0 5 1;P: 1 0 0 0 0 1 0 0 0 0 0 0.2 0 0 0 0;H: 5;eye: 0 1 5;screen: 0 1;eye: -1 0 5;screen: -1 0;"

# ---- at and behind the eye; decided exactly
run "1 1 3  0 0 0  5  1 1 3  4 -2 3  2 2 6  4 -2 3.0000000000000004  4 -2 2.9999999999999996"
check "at the eye" is "$(line eye | head -n 1)" "0 0 0"
check "none at, beside and behind the eye" is "$(line screen | head -n 4 | tr '\n' ' ')" "none none none none "
check "beside the eye the depth is 0" is "$(line eye | sed -n '2s/.* //p')" 0
check "an ulp ahead is seen, far aside" test "$(line screen | tail -n 1 | awk '{ print ($1 < -1e15) }')" = 1
run "0 0 1  0 0 0  1  1e300 0 0.9999" --list
check "beyond the largest number: a place" is "$(grep -c e+304 .out)" 1
run "0 -1 0  0 0 0  2  1e300 -0.99999999999999 0  1 -0.99999999999999 1e300" --list
check "beyond the largest number: none" is "$(tr '\n' ' ' <.out)" "none none "
run "0 0 1  0 0 0  0"
check "no point" is "$(wc -l <.out)" 3
run "0 0 1  0 0 0  0" --list
check "no point, listed" is "$(wc -c <.out)" 0

# ---- models
run "2 -3 1.5  0 0 0" cube
check "a built-in model: exit 0: $err" is "$status" 0
check "the cube's vertices" is "$(line eye | wc -l)" 8
cat >body.obj <<'END'
# a tetrahedron and a vertex of no face
v 0 0 0
v 1 0 0
v 0 1 0
v 0 0 1
v 5 5 5
f 1 3 2
f 1 2 4
f 2 3 4
f 3 1 4
END
run "1 1 3  0 0 0" body.obj
check "a file's vertices in their order" near "$(line eye | sed -n 4p) $(line eye | sed -n 1p)" "0 0.426401432711221 2.412090756622109  0 0 3.3166247903554"
check "all of them" is "$(line eye | wc -l)" 5
check "those behind the eye too" is "$(line screen | tail -n 1)" none
sed -n '/^v/p' body.obj >points.obj
run "1 1 3  0 0 0" points.obj --list
check "vertices without faces" is "$(wc -l <.out)" 5
refused "a model that is missing" "missing.obj" "1 1 3 0 0 0" missing.obj
printf 'v 1 2 x\n' >bad.obj
refused "a model that is no model" "bad.obj:1:7" "1 1 3 0 0 0" bad.obj
printf '# nothing\n' >empty.obj
refused "a model without vertices" "empty.obj" "1 1 3 0 0 0" empty.obj
# ---- into [-1, 1], and an eye inside
cat >box.obj <<'END'
v 2 0 1
v 10 4 3
v 4 1 1.5
END
run "0 0 9  0 0 0" box.obj --fit
check "--fit: exit 0: $err" is "$status" 0
# Their box goes from (2, 0, 1) to (10, 4, 3): its centre is (6, 2, 2), its longest side 8. Seen straight down, x is up, y to the left.
check "--fit: $(line eye | tr '\n' ';')" is "$(line eye | tr '\n' ';')" "0.5 -1 9.25;-0.5 1 8.75;0.25 -0.5 9.125;"
run "0 0 9  0 0 0" box.obj
check "without it they are where they are" is "$(line eye | head -n 1)" "0 2 8"
check "a body fitted is in [-1, 1]" is "$(for m in teapot cube sphere torus; do
  run '0 0 9  0 0 0' $m --fit
  line eye | awk '{ for (i = 1; i <= 2; ++i) if ($i > 1 + 1e-15 || $i < -1 - 1e-15) bad = 1; if ($3 > 10 || $3 < 8) bad = 1
    for (i = 1; i <= 3; ++i) { x = i == 3 ? $3 - 9 : $i; if (x < 0) x = -x; if (x > most) most = x } }
    END { print bad + 0, (most > 1 - 1e-15) }'; done | tr '\n' ';')" "0 1;0 1;0 1;0 1;"
refused "--fit without a model" "--fit needs a model" "0 0 9 0 0 0 0" --fit
printf 'v 3 3 3\nv 3 3 3\n' >one.obj
run "0 0 9  0 0 0" one.obj --fit
check "one place goes to the origin: $err" is "$(line eye | tail -n 1)" "0 0 9"
word="view_projection: the eye is inside the body, which is meant to be seen from outside"
run "0.5 0.25 0.75  3 2 1" cube
check "an eye inside: exit 0" is "$status" 0
check "and a word about it: $err" is "$err" "$word"
run "0 0.25 0.5  3 2 1" cube --fit
check "inside of what is fitted: $err" is "$err" "$word"
for input in "-0.1 0.5 0.5  3 2 1" "0 0.5 0.5  3 2 1" "1.5 0.5 0.5  3 2 1"; do
  run "$input" cube
  check "from $input nothing: $err" is "$err" ""
done
run "0.25 0.25 0.25  3 2 1" points.obj
check "nothing about a model that encloses nothing: $err" is "$err" ""
run "0 0 0  3 2 1" torus
check "nothing in the hole of a torus: $err" is "$err" ""
printf 'v 1e308 1.7e308 1.7e308\n' >far.obj
refused "a model out of range" "vertex 1 is too far out" "0 0 0 1 1 1" far.obj
refused "two models" "one model" "1 1 3 0 0 0" cube torus
refused "no model's name" "empty" "1 1 3 0 0 0" ""
refused "points beside a model" "nothing more" "1 1 3 0 0 0 1 0 0 0" cube

# ---- input
printf '# the view\n1 1 3 # eye\n0\t0 0\r\n1\n0 0 1#end' >view.txt
run "" --input view.txt
check "comments, tabs, no line end: $err" near "$(line screen)" "0 0.586301969977929"
refused "nothing" "x of the eye is missing: stdin:1:1" ""
refused "half of an eye" "z of the eye is missing: stdin:1:4" "1 1"
refused "no target" "x of the target is missing" "1 1 3"
refused "no n" "n is missing" "1 1 3 0 0 0"
refused "n < 0" "n is out of range" "1 1 3 0 0 0 -1"
refused "n is no whole number" "stdin:1:13" "1 1 3 0 0 0 1.5 0 0 0"
refused "a point is missing" "x of point 2 is missing" "1 1 3 0 0 0 2 0 0 0"
refused "half of a point is missing" "z of point 1 is missing" "1 1 3 0 0 0 2000000000 0 0"
refused "a number too many" "stdin:2:1" "1 1 3 0 0 0 1 0 0 0\n7"
for word in nan NaN inf -inf infinity 1e999 x 1,5 0x10 1e --1; do
  refused "an eye '$word'" "stdin:1:3" "1 $word 3 0 0 0 0"
  refused "a point '$word'" "stdin:2:3" "1 1 3 0 0 0 1\n0 $word 0"
done
refused "the eye at the target" "no direction" "1 2 3 1.0 2 3e0 0"
refused "the eye too near" "too near" "0 0 0 1e-320 0 0 0"
refused "the eye too far out" "too far out" "1e308 0 0 0 0 0 0"
refused "a point too far out" "point 2 is too far out to be seen: stdin:2:21" "0 0 0 1 1 1 2\n0 0 0 1e308 1.7e308 1.7e308"
run "0 0 0 1e-300 0 0 1 5e-301 1e-301 0"
check "a small world: $err" near "$(line screen | awk '{ print $1 * 1e300, $2 }')" "-0.2 0"
refused "a missing file" "missing.txt" "" --input missing.txt
refused "an empty name" "--input" "" --input ""
refused "an unknown option" "--colour" "1 1 3 0 0 0 0" --colour red
refused "no picture" "-o" "1 1 3 0 0 0 0" -o
refused "a size" "--size" "1 1 3 0 0 0 0" --size 0x5
printf '1 1 3 0 0 0 2 0 0 0 1e-320 -0 -0.0' >zero
run "$(cat zero)"
check "minus zero is printed as 0" is "$(grep -cE '(^| )-0( |$)' .out)" 0

# ---- pictures
run "0 -5 0  0 0 0  4  1 0 1  -1 0 1  -1 0 -1  1 0 -1" -o p.ppm --size 200x100
check "a picture: exit 0: $err" is "$status" 0
check "a picture beside the results" is "$(line H)" 5
check "a picture's size" is "$(sed -n 2p p.ppm)" "200 100"
check "four points of 49 pixels" is "$(count p.ppm 204 96 72)" 196
check "and the square between them" is "$(count p.ppm 32 44 66)" 332
run "3 -4 2  0 0 0" torus -o t.ppm
check "a wire frame: exit 0: $err" is "$status" 0
wire=$(count t.ppm 32 44 66)
check "a wire frame, $wire pixels" test "$wire" -gt 5000 -a "$wire" -lt 200000
check "without points" is "$(count t.ppm 204 96 72)" 0
run "2 -3 1.5  0 0 0" cube -o c.png --list
check "a PNG" is "$(head -c 4 c.png | tail -c 3)" PNG
check "a PNG and the list" is "$(wc -l <.out)" 8
run "0.1 0.2 0.3  3 2 1" cube -o inside.ppm
check "from inside the model: exit 0: $err" is "$status" 0
check "from inside the model: something is seen" test "$(count inside.ppm 32 44 66)" -gt 100
for input in "0 0 1 0 0 0 0" "0 0 1 0 0 0 1 0 0 5" "0 0 1 0 0 0 1 0 0 0" "0 0 1 0 0 0 2 0 0 0 0 0 5" "0 0 1 0 0 0 3 1e300 0 0 0 -1e300 0.9999999 0 0 5" "0 0 4e307 0 0 0 2 4e307 0 0 0 4e307 -1" "0 0 1e-300 0 0 0 3 1e-320 0 0 0 1e-300 0 0 0 1e-300"; do
  pictures_of_all_sizes "$input"
done
refused "a picture of unknown ending" ".png" "1 1 3 0 0 0 0" -o x.gif
refused "a picture in no folder" "nowhere/x.png" "1 1 3 0 0 0 0" -o nowhere/x.png
refused "a picture of bad input" "stdin" "1 1 3" -o x.png
cp view.txt self.ppm
refused "a picture over the input" "overwritten" "" --input self.ppm -o ./self.ppm
cp body.obj body.ppm
refused "a picture over the model" "overwritten" "1 1 3 0 0 0" body.ppm -o ./body.ppm
check "the model is as it was" cmp -s body.obj body.ppm
no_room "1 1 3 0 0 0 0"

check "no temporary file is left" is "$(find . -name '*.part' | wc -l)" 0
conclude
