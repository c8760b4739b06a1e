#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The contract of `shaded_body`, seen from outside: the course's cube, back faces, options, refusals, files left behind.
# usage: shaded_body.sh FOLDER-WITH-THE-PROGRAMS
# shellcheck disable=SC2086 # $small and some options are several words
# shellcheck source=tests/support/programs.sh
. "$(dirname "$0")/../support/programs.sh" shaded_body "$@"

one_line() { tr '\n' ' ' <.out; }

# near "words" "words": as many; equal words, or numbers not further apart than 1e-12
near() {
  awk -v a="$1" -v b="$2" 'BEGIN {
    n = split(a, x, " "); if (n != split(b, y, " ")) exit 1
    for (i = 1; i <= n; ++i) {
      if (x[i] == y[i]) continue
      d = x[i] - y[i]; if (x[i] !~ /^[0-9]/ || d > 1e-12 || d < -1e-12) exit 1
    }
  }'
}

# refuses "what" "part of the message" arguments...
refuses() {
  local what=$1 part=$2
  shift 2
  fails "$what" "" "$@"
  check "$what: says '$part': $err" has "$err" "$part"
}

# listed "what" "expected list" arguments...: the list, and that the counts agree with it; models of triangles only.
listed() {
  local what=$1 expected=$2
  shift 2
  run "" "$@" --list
  check "$what: exit 0: $err" is "$status" 0
  check "$what: $(one_line)" near "$(one_line)" "$expected"
  local all seen
  all=$(wc -l <.out) seen=$(grep -vc hidden .out)
  run "" "$@"
  check "$what: triangles" is "$(line triangles)" "$all"
  check "$what: visible" is "$(line visible)" "$seen"
}

small="--size 48x36"

cat >cube.obj <<'END'
# the course's cube: 12 triangles, counter-clockwise seen from outside
v 0 0 0
v 0 0 1
v 1 0 0
v 1 0 1
v 1 1 0
v 1 1 1
v 0 1 0
v 0 1 1
f 1 3 2
f 3 4 2
f 3 5 4
f 5 6 4
f 5 7 6
f 7 8 6
f 7 1 8
f 1 2 8
f 1 5 3
f 1 7 5
f 2 4 6
f 2 6 8
END
printf 'v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nf 1 2 3 4\nf 1 2 3\n' >square.obj
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\n' >points.obj
printf 'v 0 0 0\nv 1 1 0\nv 2 2 0\nv 0 0 0\nf 1 2 3\nf 1 1 4\n' >lines.obj
: >empty.obj
printf 'v 0 0 0\nv 1 0 0\nv nan 0 0\nf 1 2 3\n' >nan.obj
printf 'v 1e200 0 0\nv -1e200 0 0\nv 0 1e200 0\nf 1 2 3\n' >huge.obj

# ---- help
helps usage: MODEL --fit --list -o --stats --size --eye --target --up --fov --project --hidden --style --light --cull --skip \
  --threads teapot cube sphere torus

# ---- a lamp at (3, 2, 4)
lamp="--light 3,2,4"
listed "from (3, 2, 2)" "hidden hidden 73.3699507995993 78.3997116070745 46.9076633390697 47.3702931657094 hidden hidden hidden hidden 106.74768752147 105.115923873823" cube.obj --eye 3,2,2 $lamp
listed "from (1, 1, 3): four faces are seen from their edge" "hidden hidden hidden hidden hidden hidden hidden hidden hidden hidden 106.74768752147 105.115923873823" cube.obj --eye 1,1,3 $lamp
listed "from (0.5, 0.5, 5)" "hidden hidden hidden hidden hidden hidden hidden hidden hidden hidden 106.74768752147 105.115923873823" cube.obj --eye 0.5,0.5,5 $lamp
listed "from (5, 0.5, 0.5)" "hidden hidden 73.3699507995993 78.3997116070745 hidden hidden hidden hidden hidden hidden hidden hidden" cube.obj --eye 5,0.5,0.5 $lamp
listed "from (-2, -3, -4): the dark side" "20 20 hidden hidden hidden hidden 20 20 20 20 hidden hidden" cube.obj --eye -2,-3,-4 $lamp
listed "from (1, 5, 1)" "hidden hidden hidden hidden 46.9076633390697 47.3702931657094 hidden hidden hidden hidden hidden hidden" cube.obj --eye 1,5,1 $lamp
listed "from inside: nothing" "hidden hidden hidden hidden hidden hidden hidden hidden hidden hidden hidden hidden" cube.obj --eye 0.5,0.4,0.6 $lamp
listed "a lamp in a corner of the face and one behind it" "hidden hidden hidden hidden hidden hidden hidden hidden hidden hidden 20 20" cube.obj --eye 0.5,0.5,5 --light 1,1,1 --light 0,0,-3
listed "two lamps add up" "hidden hidden hidden hidden hidden hidden hidden hidden hidden hidden 193.49537504294 190.231847747646" cube.obj --eye 0.5,0.5,5 $lamp $lamp
listed "three are cut off at 255" "hidden hidden hidden hidden hidden hidden hidden hidden hidden hidden 255 255" cube.obj --eye 0.5,0.5,5 $lamp $lamp $lamp
listed "a face of no area is hidden" "hidden hidden" lines.obj --eye 0,0,3

# ---- parallel projections: the eye is infinitely far away
listed "orthographic, along z" "hidden hidden hidden hidden hidden hidden hidden hidden hidden hidden 106.74768752147 105.115923873823" cube.obj --project orthographic --eye 3,3,9 --target 3,3,0 $lamp
listed "the same eye in perspective sees more" "hidden hidden 73.3699507995993 78.3997116070745 46.9076633390697 47.3702931657094 hidden hidden hidden hidden 106.74768752147 105.115923873823" cube.obj --eye 3,3,9 --target 3,3,0 $lamp
for project in isometric dimetric trimetric oblique; do
  listed "$project" "hidden hidden 73.3699507995993 78.3997116070745 46.9076633390697 47.3702931657094 hidden hidden hidden hidden 106.74768752147 105.115923873823" cube.obj --project $project $lamp
done

# ---- into [-1, 1], and an eye inside
sed 's/^v \(.*\) \(.*\) \(.*\)$/v \1e3 \2e3 \3e3/' cube.obj >large.obj
listed "a large cube fitted: the course's twice as large about the origin" "hidden hidden 73.3699507995993 78.3997116070745 46.9076633390697 47.3702931657094 hidden hidden hidden hidden 106.74768752147 105.115923873823" large.obj --fit --eye 5,3,3 --light 5,3,7
run "" cube.obj --eye 5,3,3 --light 5,3,7 --list
check "which it is not without --fit" is_not "$(one_line)" "$(run "" cube.obj --fit --eye 5,3,3 --light 5,3,7 --list; one_line)"
run "" huge.obj --fit --eye 0,0,5 --list
check "fitted from the end of the range: exit 0: $err" is "$status" 0
check "and seen from the eye that is given" is "$(one_line | awk '{ print ($1 > 20) }')" 1
word="shaded_body: the eye is inside the body, which is meant to be seen from outside"
run "" cube.obj --eye 0.5,0.4,0.6 --list
check "an eye inside: exit 0" is "$status" 0
check "and a word about it: $err" is "$err" "$word"
run "" cube.obj --eye 0.5,0.4,0.6 --list --project orthographic
check "in parallel projection no eye is inside: $err" is "$err" ""
run "" cube.obj --eye 0,0.4,0.6 --list
check "on a face it is not inside: $err" is "$err" ""
run "" cube.obj --eye -0.5,0.4,0.6 --fit --list
check "inside of what is fitted: $err" is "$err" "$word"

# ---- faces of more corners: one line a face, counted as triangles
run "" square.obj --eye 0,0,5 --light 0,0,9 --list
check "a square and a triangle: two lines" is "$(wc -l <.out)" 2
check "straight below the lamp: 140" is "$(head -n 1 .out)" 140
run "" square.obj --eye 0,0,5
check "a square is two triangles" is "$out" "triangles: 3
visible: 3"
run "" square.obj --eye 0,0,-5
check "from behind: none" is "$out" "triangles: 3
visible: 0"
run "" square.obj --eye 5,0,0
check "from its edge: none" is "$(line visible)" 0

# ---- the model's own eye and lamp
for model in teapot cube sphere torus; do
  run "" $model
  check "$model: exit 0: $err" is "$status" 0
  check "$model: silent" is "$err" ""
  check "$model: two lines" is "$(sed 's/:.*//' .out | tr '\n' ' ')" "triangles visible "
  triangles=$(line triangles) seen=$(line visible)
  check "$model: some are seen" test "$seen" -gt 0 -a "$seen" -lt "$triangles"
  run "" $model --list
  check "$model: intensities are from 20 to 255" is "$(awk '$1 != "hidden" && !($1 >= 20 && $1 <= 255)' .out | wc -l)" 0
  cp .out all
  run "" $model --list --cull none --style wire --skip off --threads 3 $small --hidden none
  check "$model: the list does not depend on how it is drawn" cmp -s .out all
  run "" $model $small -o p.ppm --stats s.json
  check "$model: as many triangles as are drawn" is "$(sed -n 's/.*"triangles": \([0-9]*\).*/\1/p' s.json)" "$triangles"
  check "$model: the picture has that size" is "$(sed -n 2p p.ppm)" "48 36"
done
run "" cube
check "a cube: half of it" is "$out" "triangles: 12
visible: 6"

# ---- pictures
run "" cube.obj --eye 0.5,0.5,5 --light 0.5,0.5,1e9 --style flat $small -o flat.ppm --list
check "a picture: exit 0: $err" is "$status" 0
check "a picture and the list" is "$(wc -l <.out)" 12
# 140 of 255 as light is 196 in sRGB
check "the front of the cube in grey" test "$(count flat.ppm 196 196 196)" -gt 100
check "and nothing else" is "$(($(count flat.ppm 196 196 196) + $(count flat.ppm 250 249 246)))" $((48 * 36))
run "" teapot $small -o p.png
check "a PNG" is "$(head -c 4 p.png | tail -c 3)" PNG
for style in gouraud flat phong wire; do
  run "" teapot $small --style $style -o $style.ppm
  check "$style: exit 0: $err" is "$status" 0
done
check "flat and Gouraud differ" is_not "$(cksum <flat.ppm)" "$(cksum <gouraud.ppm)"
run "" cube $small --stats only.json
check "statistics without a picture: exit 0: $err" is "$status" 0
check "statistics without a picture" test -s only.json

# ---- refusals
refuses "no model" "no model"
refuses "an empty picture name" "-o needs" cube -o ""
refuses "an empty name of statistics" "--stats needs" cube --stats ""
refuses "two models" "torus" cube torus
refuses "a missing file" "missing.obj" missing.obj
refuses "an empty file" "empty" empty.obj --list
strange_models
refuses "a model without faces" "no faces" points.obj
refuses "a vertex that is no number" "nan.obj:3:3" nan.obj -o x.png
printf 'v 1 0 0\nv -1 0 0\nv 0 1 0\nf 1 2 3\n' >ordinary.obj
run "" ordinary.obj --list
ordinary=$out
run "" huge.obj --list
check "a large model is shaded as a small one" is "$out" "$ordinary"
refuses "an eye out of range" "too far" cube --eye 1e200,0,0
refuses "the eye at the target" "the eye is at the target" cube --eye 0,0,5 --target 0,0,5
refuses "the eye at the target, orthographic" "the eye is at the target" cube --list --project orthographic --eye 0,0,5 --target 0,0,5
refuses "the eye at the centre" "the eye is at the target" cube --eye 0.5,0.5,0.5 -o x.png --stats x.json
refuses "no up" "--up needs a direction" cube --up 0,0,0
refuses "an unknown option" "--colour" cube --colour red
refuses "an unknown projection" "isometric" cube --project round
refuses "an eye of two numbers" "--eye" cube --eye 1,2
refuses "a lamp that is no number" "--light" cube --light 1,nan,2
for option in -o --stats --size --eye --target --up --fov --project --hidden --style --light --cull --skip --threads; do
  refuses "$option without a value" "$option" cube $option
done
refuses "a picture of unknown ending" ".png" cube -o x.gif
refuses "a picture in no folder" "nowhere/x.png" cube $small -o nowhere/x.png
refuses "statistics in no folder" "nowhere/x.json" cube $small -o x.png --stats nowhere/x.json
refuses "statistics in no folder, without a picture" "nowhere/x.json" cube $small --stats nowhere/x.json
refuses "one file for both" "both.png" cube $small -o both.png --stats both.png
cp cube.obj self.ppm
refuses "a picture over its model" "overwritten" self.ppm -o ./self.ppm
check "the model is as it was" cmp -s self.ppm cube.obj
if [ -e /dev/full ]; then
  "$program" cube $small -o full.png --stats full.json >/dev/full 2>.err
  check "a full disk: exit 2" is "$?" 2
  check "a full disk: leaves no picture" test ! -e full.png
  check "a full disk: leaves no statistics" test ! -e full.json
  "$program" sphere $small --list --stats full.json >/dev/full 2>.err # more than standard output holds back
  check "a full disk, a long list: exit 2" is "$?" 2
  check "a full disk, a long list: leaves no statistics" test ! -e full.json
  ln -s /dev/null device.json
  "$program" cube $small --stats device.json >/dev/full 2>.err
  check "a full disk: a device that stands for the statistics stays" test -L device.json
fi

check "no temporary file is left" is "$(find . -name '*.part' | wc -l)" 0
conclude
