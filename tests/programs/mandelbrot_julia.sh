#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The contract of `mandelbrot_julia`, seen from outside: counts, both sets, refusals, pictures.
# usage: mandelbrot_julia.sh FOLDER-WITH-THE-PROGRAMS
# shellcheck source=tests/support/programs.sh
. "$(dirname "$0")/../support/programs.sh" mandelbrot_julia "$@"

helps --input --julia --list -o --size --threads

# ---- the course's samples
course="100 16  -1.5 0.5  -1 1  8 8" julia="100 16  -1 1  -1.2 1.2  8 8"
run "$course"
check "points: $out $err" is "$out" "pixels: 81"
run "$course" --list
check "the first row is at vmin" is "$(head -n 1 <<<"$out")" "4 4 4 5 5 8 16 5 4"
check "the middle row" is "$(sed -n 5p <<<"$out")" "16 16 16 16 16 16 16 16 6"
check "nine rows" is "$(wc -l <<<"$out")" 9
run "$julia" --list --julia 0.32 0.043
check "Julia, the first row" is "$(head -n 1 <<<"$out")" "3 3 4 5 5 5 4 3 3"
check "Julia, the last row but one" is "$(sed -n 8p <<<"$out")" "4 5 16 16 10 16 16 5 3"
sum() { tr ' ' '\n' <<<"$out" | awk '{ s += $1 } END { print s }'; }
run "100 16 -1.5 0.5 -1 1 64 64" --list --threads 3
check "65 x 65 points: $(sum)" is "$(sum)" 47026
run "100 16 -1 1 -1.2 1.2 64 64" --list --julia 0.32 0.043
check "65 x 65 points, Julia: $(sum)" is "$(sum)" 46350

# ---- the ends of what may be asked for
run "100 0 -1.5 0.5 -1 1 1 1" --list
check "no steps: $out" is "$out" $'0 0\n0 0'
run "0 9 -1.5 0.5 -1 1 1 1" --list
check "a disc without points: $out" is "$out" $'0 0\n0 0'
run "1e300 9 0 1 0 1 1 1" --list
check "a disc of any size: $err" is "$status" 0
run "2 7 0.5 -1.5 1 -1 2 2" --list
check "mirrored: $out" is "$(tail -n 1 <<<"$out" | cut -d' ' -f3)" "1"

# ---- refusals
fails "nothing" ""
fails "one number short" "${course% *}"
fails "one number more" "$course 7"
fails "negative m" "100 -1 -1 1 -1 1 8 8"
check "negative m: place: $err" ends "$err" "stdin:1:5"
fails "xmax 0" "100 9 -1 1 -1 1 0 8"
fails "too many points" "100 9 -1 1 -1 1 100000 100000"
fails "nan" "100 9 nan 1 -1 1 8 8"
fails "infinite eps" "inf 9 -1 1 -1 1 8 8"
fails "m beyond int" "100 99999999999 -1 1 -1 1 8 8"
fails "no such folder" "$course" -o nowhere/set.png
fails "a size of 1e300" "$course" -o set.png --size 1e300x8
fails "one number for --julia" "$course" --julia 0.3
fails "a word for --julia" "$course" --julia 0.3 x
fails "no option" "$course" --deep
fails "no picture's name" "$course" -o counts.txt

# ---- pictures
run "2 60 -2 0.5 -1.25 1.25 9 4" -o set.ppm
check "a pixel for each point: $err" is "$(sed -n 2p set.ppm)" "10 5"
run "2 60 -2 0.5 -1.25 1.25 9 4" -o set.ppm --size 50x40
check "--size" is "$(sed -n 2p set.ppm)" "50 40"
check "what stays is black" is_not "$(count set.ppm 0 0 0)" 0
run "100 16 -2 0.5 0.5 3 1 1" -o top.ppm
check "vmax is at the top: far outside" is "$(pixels top.ppm | head -n 1)" "$(pixels top.ppm | sed -n 2p)"
pictures_of_all_sizes "$course"
no_room "$course"
conclude
