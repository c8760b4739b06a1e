#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The contract of `plot_surface`, seen from outside: methods and their reasons, files, refusals.
# usage: plot_surface.sh FOLDER-WITH-THE-PROGRAMS
# shellcheck source=tests/support/programs.sh
. "$(dirname "$0")/../support/programs.sh" plot_surface "$@"

helps --function --terrain --image --samples --style --azimuth --elevation --labels -o --size --animate

run ""
check "a ripple: $err" is "$status" 0
check "by perimeter: $out" has "$out" "method: perimeter"
check "says why: $out" has "$out" "why: every point has a height"
run "" --style facets --samples 11
check "facets: $out" has "$out" "facets: 100"
run "" --function crater
check "a hole: $out" has "$out" "method: floating horizon"
run "" --function crater --elevation 89
check "a hole from above: $out" has "$out" "method: facets far to near"

run "" -o plot.svg --labels length,height,width --function saddle
check "vectors: $err" is "$status" 0
check "a line for each line" is "$(($(grep -c '<line' plot.svg) > $(sed -n 's/^lines: //p' .out)))" 1
run "" -o plot.png --style facets --size 320x240
check "pixels: $err" is "$status" 0
check "a PNG" is "$(head -c 4 plot.png | tail -c 3)" PNG
run "" -o steps.png --animate 4 --samples 9 --size 160x120
check "an animation: $err" is "$status" 0
check "its pictures" is "$(grep -a -o fcTL steps.png | wc -l)" 4
check "progress" has "$err" "picture 4 of 4"

printf 'ncols 4\nnrows 3\nxllcorner 0\nyllcorner 0\ncellsize 30\n1 2 3 4\n2 5 6 3\n1 -9999 2 1\n' >hills.asc
run "" --terrain hills.asc -o hills.png
check "a terrain with a gap: $err" is "$status" 0
check "its method: $out" has "$out" "method: floating horizon"
run "" --image plot.png --style facets -o relief.png
check "an image: $err" is "$status" 0
check "its facets: $out" has "$out" "facets: 76241"

fails "no such function" "" --function hills
fails "an empty name of the terrain" "" --terrain ""
fails "one sample" "" --samples 1
fails "too high" "" --elevation 91
fails "two labels" "" --labels a,b
fails "another ending" "" -o plot.gif
fails "an animation in vectors" "" -o plot.svg --animate 3
fails "two sources" "" --terrain hills.asc --image plot.png
fails "no such file" "" --terrain none.asc
fails "the input overwritten" "" --image plot.png -o plot.png
printf 'ncols 2\nnrows 2\ncellsize 1\n1 2 3\n' >short.asc
run "" --terrain short.asc
check "a short file: exit 2" is "$status" 2
check "its place: $err" is "$err" "plot_surface: text ends where a number is expected: short.asc:5:1"
printf 'ncols 1\nnrows 2\ncellsize 1\n1 2\n' >thin.asc
fails "one column" "" --terrain thin.asc

conclude
