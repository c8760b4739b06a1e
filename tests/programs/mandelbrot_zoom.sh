#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The contract of `mandelbrot_zoom`, seen from outside: the file's chunks, progress, refusals.
# usage: mandelbrot_zoom.sh FOLDER-WITH-THE-PROGRAMS
# shellcheck source=tests/support/programs.sh
. "$(dirname "$0")/../support/programs.sh" mandelbrot_zoom "$@"

helps -o --centre --from --to --pictures --steps --delay --size --threads

run "" -o zoom.png --size 24x18 --pictures 5 --to 1e-30 --steps 500
check "a zoom: exit 0, $err" is "$status" 0
check "says how many: $out" is "$(head -n 1 <<<"$out")" "pictures: 5"
check "progress, a line for each picture" is "$(grep -c '^picture [1-5] of 5, width ' .err)" 5
check "the last width" has "$err" "picture 5 of 5, width 1e-30"
names() { grep -a -o -E 'IHDR|acTL|fcTL|IDAT|fdAT|IEND' "$1" | tr '\n' ' '; }
check "the chunks: $(names zoom.png)" is "$(names zoom.png)" \
  "IHDR acTL fcTL IDAT fcTL fdAT fcTL fdAT fcTL fdAT fcTL fdAT IEND "
run "" -o again.png --size 24x18 --pictures 5 --to 1e-30 --steps 500 --threads 3
check "the same file from three threads" cmp -s zoom.png again.png

run "" -o one.png --size 1x1 --pictures 1 --steps 1
check "one picture of one pixel: $err" is "$status" 0
run "" -o i.png --centre 0 1.0 --from 1e-60 --to 1e-65 --size 5x5 --pictures 2
check "about i: $err" is "$status" 0
check "orbits of many digits: $out" has "$out" "longest orbit: 3000"

fails "no file" ""
fails "another ending" "" -o zoom.ppm
fails "no pictures" "" -o z.png --pictures 0
fails "too narrow" "" -o z.png --to 1e-66
fails "no width" "" -o z.png --from nan
fails "a centre in words" "" -o z.png --centre here there
fails "a centre with an exponent" "" -o z.png --centre 1e-3 0
fails "half a centre" "" -o z.png --centre 0.5
fails "no such option" "" --zoom
run "" -o none/z.png --size 2x2 --pictures 1
check "no such folder: exit 2" is "$status" 2
check "no such folder: says so" has "$err" "mandelbrot_zoom: "

conclude
