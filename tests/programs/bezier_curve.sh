#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The contract of `bezier_curve`, seen from outside: the course's curve in both forms, steps, degrees, refusals.
# usage: bezier_curve.sh FOLDER-WITH-THE-PROGRAMS
# shellcheck source=tests/support/programs.sh
. "$(dirname "$0")/../support/programs.sh" bezier_curve "$@"

course="3 0 0 0 1 3 0 4 3 2 5 0 4"
helps --input --list --size --step --form -o

# ---- the course's curve
run "$course"
check "101 points: $out" is "$out" "points: 101"
for form in bernstein bezier; do
  run "$course" --list --step 0.25 --form $form
  check "$form: $out" is "$out" "0 0 0 0
0.25 1.0625 1.6875 0.34375
0.5 2.5 2.25 1.25
0.75 3.9375 1.6875 2.53125
1 5 0 4"
  run "$course" --list --form $form
  check "$form: 101 lines" is "$(wc -l <.out)" 101
  check "$form: t = 0.01" is "$(sed -n 2p .out)" "0.01 0.030596 0.0891 0.000598"
  check "$form: t = 0.1" is "$(awk 'NR == 11 {printf "%.14f %.14f %.14f", $2, $3, $4}' .out)" \
    "0.35600000000000 0.81000000000000 0.05800000000000"
  check "$form: t = 0.9" is "$(awk 'NR == 91 {printf "%.14f %.14f %.14f", $2, $3, $4}' .out)" \
    "4.64400000000000 0.81000000000000 3.40200000000000"
  check "$form: the sum of all" is "$(awk '{x+=$2; y+=$3; z+=$4} END {printf "%.9f %.9f %.9f", x, y, z}' .out)" \
    "252.500000000 149.985000000 152.005000000"
done
run "$course" --list
check "Bernstein is the default" is "$out" "$(printf %s "$course" | "$program" --list --form bernstein)"

# ---- steps: t = k * step, not summed; 1 only if it is reached
run "$course" --list --step 0.3
check "steps of 0.3" is "$(cut -d' ' -f1 .out | tr '\n' ' ')" "0 0.3 0.6 0.8999999999999999 "
run "$course" --step 1
check "a step of 1" is "$out" "points: 2"
run "$course" --step 0.6
check "a step of 0.6" is "$out" "points: 2"
run "$course" --step 1e-15
check "many: $out" is "$out" "points: 1000000000000001"

# ---- degrees, coincident points, sizes
run "0 7 8 9" --list --step 0.5
check "degree 0" is "$out" "0 7 8 9
0.5 7 8 9
1 7 8 9"
run "1 0 0 -0 2 4 -0" --list --step 0.25
check "degree 1, and -0 as 0" is "$(sed -n 2p .out)" "0.25 0.5 1 0"
run "4 0 0 0 1 0 0 2 8 0 3 0 0 4 0 0" --list --step 0.5
check "degree 4" is "$(sed -n 2p .out)" "0.5 2 3 0"
for form in bernstein bezier; do
  run "2 0.1 5 5 0.1 5 5 0.1 5 5" --list --form $form
  check "$form: coincident points" is "$(cut -d' ' -f2- .out | sort -u)" "0.1 5 5"
  run "2 1.7976931348623157e308 0 0 -1.7976931348623157e308 0 0 1.7976931348623157e308 0 0" --list --step 0.5 --form $form
  check "$form: the largest numbers: $out" is "$out" "0 1.7976931348623157e+308 0 0
0.5 0 0 0
1 1.7976931348623157e+308 0 0"
  run "2 5e-324 0 0 5e-324 0 0 5e-324 0 0" --list --step 0.5 --form $form
  check "$form: the smallest number at the ends" is "$(sed -n '1p;3p' .out | cut -d' ' -f2 | sort -u)" 5e-324
done
{
  echo 50
  for k in $(seq 0 50); do echo "$k $((k % 2 * 2 - 1)) 0"; done
} >fifty.txt
run "" --input fifty.txt --list --step 0.125
check "degree 50 is linear in x" is "$(awk '$2 != 50 * $1' .out)" ""
check "degree 50: (2t - 1)^50 with its sign" is "$(sed -n 3p .out | cut -d' ' -f3)" "-8.881784197001252e-16"

# ---- refusals and pictures
fails "nothing" ""
fails "a negative degree" "-1"
check "a negative degree: $err" ends "$err" "stdin:1:1"
fails "half a degree" "1.5 0 0 0 1 1 1"
fails "a point too few" "2 0 0 0 1 1 1"
check "a point too few: $err" has "$err" "x of point 2 is missing: stdin:1:"
fails "a number too many" "0 1 2 3 4"
fails "no number" "1 0 0 0 1 nan 1"
fails "infinity" "0 inf 0 0"
for step in 0 -0.1 1.5 x 1e-300 nan; do fails "--step $step" "$course" --step $step; done
fails "an unknown form" "$course" --form power
fails "an unknown option" "$course" --degree
run "$course" -o out.ppm
check "the curve is drawn in red" is_not "$(count out.ppm 204 96 72)" 0
pictures_of_all_sizes "$course"
pictures_of_all_sizes "0 1 2 3"
no_room "$course"
conclude
