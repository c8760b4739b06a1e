#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The contract of `linear_system`, seen from outside: solutions, the two kinds of singular systems, refusals.
# usage: linear_system.sh FOLDER-WITH-THE-PROGRAMS
# shellcheck source=tests/support/programs.sh
. "$(dirname "$0")/../support/programs.sh" linear_system "$@"

# solves "what" "input" "line"
solves() {
  run "$2"
  check "$1: exit 0: $err" is "$status" 0
  check "$1: $out" is "$out" "$3"
}

helps --input --list --size -o

# ---- the course's values
course="1 1 1 6\n-1 -2 1 -2\n2 1 3 13\n"
solves "the course's system" "$course" "solution: 1 2 3"
solves "two equations alike" "1 1 1 6  2 2 2 12  1 -1 0 0" "singular: dependent"
solves "two equations against each other" "1 1 1 6  2 2 2 13  1 -1 0 0" "singular: inconsistent"
run "$course" --list
check "--list" is "$out" "1 2 3"
run "1 1 1 6  2 2 2 13  1 -1 0 0" --list
check "--list of a singular system" is "$out" "inconsistent"

# ---- decided for the numbers as they are read
solves "nothing at all" "0 0 0 0  0 0 0 0  0 0 0 0" "singular: dependent"
solves "0 = 1" "0 0 0 0  0 0 0 1  0 0 0 0" "singular: inconsistent"
solves "one plane" "1 2 3 4  2 4 6 8  3 6 9 12" "singular: dependent"
solves "parallel planes" "1 2 3 4  2 4 6 8  3 6 9 13" "singular: inconsistent"
solves "a prism" "1 0 0 0  0 1 0 0  1 1 0 1" "singular: inconsistent"
solves "a sheaf" "1 0 0 0  0 1 0 0  1 1 0 0" "singular: dependent"
solves "small is not singular" "1e-7 0 0 1e-7  0 1e-7 0 2e-7  0 0 1e-7 3e-7" "solution: 1 2 3"
solves "very small" "5e-324 0 0 5e-324  0 5e-324 0 0  0 0 5e-324 5e-324" "solution: 1 0 1"
solves "of all sizes" "1e300 0 0 1e300  0 1e-300 0 1e-300  0 0 1 -4" "solution: 1 1 -4"
solves "an ulp beside singular" "1 1 0 2  1 1.0000000000000002 0 2  0 0 1 5" "solution: 2 0 5"
solves "0.1 + 0.2 is not 0.3" "0.1 0.2 0 0.3  0.2 0.4 0 0.6  0 0 1 1" "singular: dependent"
solves "a pivot that is zero" "0 1 0 2  0 0 1 3  1 0 0 1" "solution: 1 2 3"
solves "no -0" "-1 0 0 0  0 -1 0 0  0 0 -1 0" "solution: 0 0 0"
solves "thirds" "3 0 0 1  0 3 0 2  0 0 3 1" "solution: 0.3333333333333333 0.6666666666666666 0.3333333333333333"

# ---- refusals
fails "nothing" ""
check "nothing: place: $err" ends "$err" "a of row 1 is missing: stdin:1:1"
fails "eleven numbers" "1 1 1 6\n-1 -2 1 -2\n2 1 3\n"
check "eleven: place: $err" ends "$err" "d of row 3 is missing: stdin:4:1"
fails "thirteen" "$course 1"
fails "a word" "1 1 one"
check "a word: $err" ends "$err" "c of row 1 is not a number, 'one': stdin:1:5"
fails "infinity" "1 1 1 inf"
fails "a solution beyond the numbers" "1e-300 0 0 1e300  0 1 0 0  0 0 1 0"
fails "unknown option" "$course" --method

printf '%b' "$course" >system
run "" --input system -o out.ppm
check "--input: $err" is "$out" "solution: 1 2 3"
check "the solution is drawn in red" is_not "$(count out.ppm 204 96 72)" 0
run "1 2 3 4  2 4 6 8  0 0 0 13" -o out.svg
check "a singular system has a picture" test -s out.svg
pictures_of_all_sizes "$course"
no_room "1 1 1 6 -1 -2 1 -2 2 1 3 13"
conclude
