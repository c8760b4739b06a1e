#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The contract of `grid_surface`, seen from outside: views, orders, visible parts, refusals, pictures.
# usage: grid_surface.sh FOLDER-WITH-THE-PROGRAMS
# shellcheck source=tests/support/programs.sh
. "$(dirname "$0")/../support/programs.sh" grid_surface "$@"

helps --order --list --input -o --size

tower='3 3  0 0 0 0  0 2 0 0  0 0 0 0  0 0 0 0 '
# ---- views and orders
run "$tower -1 3 -2"
check "a corner: $out" is "$out" $'view: corner\nfacets: 9'
run "$tower 3 9 0"
check "the border: $out" is "$out" $'view: front\nfacets: 9'
run "$tower 1 0.5 -2"
check "a side: $out" is "$out" $'view: side\nfacets: 9'
run "$tower -1 0 1"
check "in the plane: $out" is "$out" $'view: horizontal\nfacets: 9'
run "$tower 1.5 4 1.5" --order
check "front order: $out" is "${out//$'\n'/,}" "2 2,2 3,3 2,3 3,1 2,1 3,2 1,3 1,1 1"
run "$tower 1 4 1" --order
check "over a grid point: $out" is "${out//$'\n'/,}" "1 1,1 2,1 3,2 1,2 2,2 3,3 1,3 2,3 3"

# ---- visible parts
run "$tower -1 3 -2" --list
check "a tower: edges" is "$(wc -l <<<"$out")" 19
check "a tower: parts" is "$(grep -v ' 0 1$' <<<"$out")" $'0 2 1 2 0 0.8333333333333334\n1 2 1 3 0.2 1\n1 3 2 3 0 0.6666666666666666\n2 2 3 2 0.5 1'
check "ordered" is "$out" "$(sort -n -k1,1 -k2,2 -k3,3 -k4,4 -k5,5 <<<"$out")"
run '1 1 0 0 0 0 0.5 1 0.5' --list
check "one facet: $out" is "$out" $'0 0 0 1 0 1\n0 0 1 0 0 1\n0 1 1 1 0 1\n1 0 1 1 0 1'
run '1 1 1e300 -1e300 1e-300 5e-324 -1 2 -1e300' --list
check "numbers of all sizes" is "$status" 0

# ---- refusals
fails "nothing" ""
fails "no facets" "0 1 0 0 1 1 1"
fails "heights missing" "1 1 0 0 0"
fails "no eye" "1 1 0 0 0 0 1 1"
fails "a word" "1 1 0 0 x 0 1 1 1"
check "a word: place: $err" ends "$err" "stdin:1:9"
fails "nan" "1 1 0 0 nan 0 1 1 1"
fails "left over" "1 1 0 0 0 0 1 1 1 1"
fails "an eye on the surface" "1 1 0 0 0 0 0.5 0 0.5"
fails "an eye at a point of the surface" "1 1 7 0 0 0 0 7 0"
fails "too many heights" "2000000000 2000000000"
fails "two things to print" "1 1 0 0 0 0 1 1 1" --list --order
fails "no option" "1 1 0 0 0 0 1 1 1" --deep
fails "no picture's name" "1 1 0 0 0 0 1 1 1" -o picture.txt
printf '1 1 0 0 0 0 1 1 1' >grid.svg
fails "the input overwritten" "" --input grid.svg -o grid.svg

# ---- pictures
# An eye over the grid sees lines at its side as long as can be: what is drawn of them leaves the rest its size.
hills="20 20 $(awk 'BEGIN { for (i = 0; i <= 20; i++) for (j = 0; j <= 20; j++) print cos(sqrt((i - 10) ^ 2 + (j - 10) ^ 2) / 2) }' | tr '\n' ' ')"
for eye in "3 2.5 4" "10.3 1.5 10.2" "17 1.2 9.5" "0 1.3 20"; do
  run "$hills $eye" -o over.svg
  check "over the grid, $eye: exit 0: $err" is "$status" 0
  long=$(tr '"' ' ' <over.svg | awk '/^<line/ { n++; if (($3 - $7) ^ 2 + ($5 - $9) ^ 2 > 64) l++ } END { print (n > 50 && l > n / 4) }')
  check "over the grid, $eye: a quarter of all lines are longer than 8 pixels" is "$long" 1
  check "over the grid, $eye: all in the picture" is "$(tr '"' ' ' <over.svg |
    awk '/^<line/ && ($3 < 0 || $3 > 640 || $7 < 0 || $7 > 640 || $5 < 0 || $5 > 480 || $9 < 0 || $9 > 480)' | wc -l)" 0
done
run "1 1 0 0 0 0 0.5 0.001 0.5" -o over.svg
check "just over one facet: $err" is "$status" 0
# Beside the grid all of it is drawn, however wide it looks.
run "$hills -1 0.5 10" -o over.svg
check "close to a side: from (0, 0) to (0, 20)" is "$(tr '"' ' ' <over.svg | awk '/^<line/ { print int($3 + 0.5); print int($7 + 0.5) }' | sort -n | sed -n '1p;$p' | xargs)" "32 608"
run "$hills -1 0.5 10" --list
check "close to a side: every part is a line" is "$(grep -c '^<line' over.svg)" "$(wc -l <<<"$out")"
rm -f over.svg
pictures_of_all_sizes "$tower -1 3 -2"
no_room "$tower -1 3 -2"
conclude
