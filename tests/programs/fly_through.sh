#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The contract of `fly_through`, seen from outside: files, progress, constant speed, refusals.
# usage: fly_through.sh FOLDER-WITH-THE-PROGRAMS
# shellcheck source=tests/support/programs.sh
. "$(dirname "$0")/../support/programs.sh" fly_through "$@"

arch='3  4 1 0  0 2 4  -4 1 0  0 0.5 -4'

helps -o --frames --move --look --curve --pictures --steps --delay --size --eye --target --input --list

run "$arch" cube -o fly.png --frames step --pictures 5 --size 48x36
check "a flight: exit 0, $err" is "$status" 0
check "says how many: $out" is "$(head -n 1 <<<"$out")" "pictures: 5"
check "says how far: $out" begins "$(tail -n 1 <<<"$out")" "length: "
check "progress, a line for each picture" is "$(grep -c '^picture [1-5] of 5$' .err)" 5
check "five numbered pictures: $(ls)" is "$(ls step*.png | tr '\n' ' ')" \
  "step0001.png step0002.png step0003.png step0004.png step0005.png "
names() { grep -a -o -E 'IHDR|acTL|fcTL|IDAT|fdAT|IEND' "$1" | tr '\n' ' '; }
check "the chunks: $(names fly.png)" is "$(names fly.png)" \
  "IHDR acTL fcTL IDAT fcTL fdAT fcTL fdAT fcTL fdAT fcTL fdAT IEND "
check "the pictures differ" is_not "$(cksum <step0001.png)" "$(cksum <step0003.png)"
run "$arch" cube -o again.png --pictures 5 --size 48x36 --threads 3
check "the same file from three threads" cmp -s fly.png again.png
run "$arch" cube -o all.png --pictures 5 --size 48x36 --cull none
check "back faces show when they are not left out" is_not "$(cksum <fly.png)" "$(cksum <all.png)"
for what in "--move target" "--move body" "--look ahead" "--curve bspline" "--curve bezier"; do
  # shellcheck disable=SC2086 # two words
  run "$arch" cube -o other.png --pictures 5 --size 48x36 $what
  check "$what: exit 0, $err" is "$status" 0
  check "$what: another flight" is_not "$(cksum <fly.png)" "$(cksum <other.png)"
done

# The steps of the list are equally long, but for the curve's bend within a step, and lead from end to end.
run "$arch" cube --pictures 1001 --list
check "a list: exit 0, $err" is "$status" 0
check "from the first point: $(head -n 1 <<<"$out")" is "$(head -n 1 <<<"$out")" "0 4 1 0"
check "to the last: $(tail -n 1 <<<"$out")" is "$(tail -n 1 <<<"$out")" "1000 0 0.5 -4"
spread=$(awk 'NR > 1 { d = sqrt(($2-x)^2 + ($3-y)^2 + ($4-z)^2); if (NR == 2 || d < low) low = d; if (d > high) high = d }
  { x = $2; y = $3; z = $4 } END { print (high < low * 1.001) }' .out)
check "at constant speed" is "$spread" 1
run "1  0 0 0  1 0 0" cube --pictures 3 --list
check "a straight line: $out" is "$out" $'0 0 0 0\n1 0.5 0 0\n2 1 0 0'
# By the parameter: the Bezier curve by Bernstein's polynomials, k DT while it is at most 1.
for step in 0.25 0.01 0.3 1; do
  run "$arch" cube --curve bezier --steps $step --list
  check "--steps $step: exit 0, $err" is "$status" 0
  off=$(awk -v step=$step '{ t = (NR - 1) * step; s = 1 - t; a = s * s * s; b = 3 * s * s * t; c = 3 * s * t * t; d = t * t * t
    e = ($1 - NR + 1) "" ; x = $2 - (4 * a - 4 * c); y = $3 - (a + 2 * b + c + 0.5 * d); z = $4 - (4 * b - 4 * d)
    if (e != 0 || x * x + y * y + z * z > 1e-26) ++n } END { print n + 0 }' .out)
  check "--steps $step: Bernstein's places" is "$off" 0
  check "--steps $step: as many as there are" is "$(wc -l <.out)" "$(awk -v s=$step 'BEGIN { while (k * s <= 1) ++k; print k }')"
done
check "a step of 1: both ends" is "$(wc -l <.out)" 2
run "$arch" cube --steps 0.01 --list
check "through the points: 101 places, from end to end" is "$(wc -l <.out) $(sed -n '1p;101p' .out | tr '\n' ' ')" \
  "101 0 4 1 0 100 0 0.5 -4 "
cp .out parameter
run "$arch" cube --pictures 101 --list
check "not those at constant speed" is_not "$(cat parameter)" "$out"
run "$arch" cube -o steps.png --frames t --steps 0.5 --size 16x12
check "a flight by the parameter: exit 0, $err" is "$status" 0
check "three pictures: $out" is "$(head -n 1 <<<"$out") $(echo t0*)" "pictures: 3 t0001.png t0002.png t0003.png"
for step in 0 -0.1 1.5 nan x 0.0001 1e-9; do fails "--steps $step" "$arch" cube --list --steps $step; done
fails "both ways to count" "$arch" cube --list --steps 0.1 --pictures 3
echo "$arch" >t0002.png
fails "a picture of a step over its input" "" cube --frames t --input t0002.png --steps 0.5
check "the input is as it was" is "$(cat t0002.png)" "$arch"
rm t0*.png

run "1  5 5 5  -5 -5 -5" cube -o across.png --pictures 3 --size 16x16
check "an eye in its target: $err" is "$status" 0
run "2  1 1 1  1 1 1  1 1 1" cube -o still.png --curve bezier --pictures 3 --size 16x16
check "a path without length: exit 0, $err" is "$status" 0
check "of length 0: $out" is "$(tail -n 1 <<<"$out")" "length: 0"

run "$arch" cube -o round.png --pictures 2 --move target --eye 0.5,0.5,0.5
check "an eye at the centre, which is not the target: $err" is "$status" 0
fails "an eye at the target" "$arch" cube -o fly2.png --move body --eye 1,2,3 --target 1,2,3
fails "an eye at the centre" "$arch" cube -o fly2.png --move body --eye 0.5,0.5,0.5
check "says so: $err" has "$err" "the eye is at the target"
fails "no up" "$arch" cube -o fly2.png --up 0,0,0
check "says so: $err" has "$err" "--up needs a direction"
fails "no model" "$arch" -o fly2.png
fails "an empty name of frames" "$arch" cube --frames ""
fails "nothing to write" "$arch" cube
fails "no such model" "$arch" none.obj -o fly2.png
fails "another ending" "$arch" cube -o fly2.ppm
fails "no pictures" "$arch" cube -o fly2.png --pictures 0
fails "one point" "0 1 2 3" cube -o fly2.png
fails "a point too few" "2 1 2 3 4 5 6" cube -o fly2.png
check "where: $err" ends "$err" ": stdin:1:14"
fails "a number too much" "1 1 2 3 4 5 6 7" cube -o fly2.png
fails "not a number" "1 1 2 3 4 five 6" cube -o fly2.png
fails "not finite" "1 1 2 3 4 nan 6" cube -o fly2.png
fails "too far" "1 1 2 3 4 1e200 6" cube -o fly2.png
fails "all points one" "2 1 1 1 1 1 1 1 1 1" cube -o fly2.png
fails "successive points one" "3 0 0 0 1 1 1 1 1 1 2 0 0" cube -o fly2.png
fails "no such thing to move" "$arch" cube -o fly2.png --move light
fails "an option of render" "$arch" cube -o fly2.png --style flat
run "$arch" cube -o none/fly.png --frames kept --pictures 2 --size 8x8
check "a folder that is not there: exit 2" is "$status" 2
check "takes its numbered pictures with it: $(ls)" is "$(ls kept* 2>/dev/null)" ""

echo "$arch" >own0002.png
fails "a picture over its input" "" cube --frames own --input own0002.png --pictures 2
check "the input is as it was" is "$(cat own0002.png)" "$arch"
fails "a picture over the animation" "$arch" cube --frames own -o ./own0001.png --pictures 2 --size 8x8
mv own0002.png own0003.png
run "" cube --frames own --input own0003.png --pictures 2 --size 8x8
check "beside its input: exit 0: $err" is "$status" 0

conclude
