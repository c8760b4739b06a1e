#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The contract of `barycentric`, seen from outside: the course's triangles, what is singular and degenerate, refusals.
# usage: barycentric.sh FOLDER-WITH-THE-PROGRAMS
# shellcheck source=tests/support/programs.sh
. "$(dirname "$0")/../support/programs.sh" barycentric "$@"

# gives "what" "input" "direct" "robust" "in_plane" "where"
gives() {
  run "$2"
  check "$1: exit 0: $err" is "$status" 0
  local expected="direct: $3
robust: $4"
  [ "$4" = degenerate ] || expected="$expected
in_plane: $5
where: $6"
  check "$1: $out" is "$out" "$expected"
}

helps --input --list --size -o

# ---- the course's triangles and degenerate ones
gives B1 "1 0 0 0 1 0 0 0 1 0.5 0.25 0.25" "0.5 0.25 0.25" "0.5 0.25 0.25" yes inside
gives B2 "1 0 0 0 1 0 0 0 1 2 -0.5 -0.5" "2 -0.5 -0.5" "2 -0.5 -0.5" yes outside
gives B3 "1 0 0 0 1 0 0 0 1 1 1 1" "1 1 1" "-1 1 1" no outside
gives B4 "1 2 3 4 0 1 2 5 -1 2 2.25 1.5" "0.5 0.25 0.25" "0.5 0.25 0.25" yes inside
gives B4b "1 2 3 4 0 1 2 5 -1 2 2 1.5" "0.47761194029850745 0.27611940298507465 0.208955223880597" \
  "0.4642857142857143 0.32142857142857145 0.21428571428571427" no inside
gives B6 "0 0 0 4 0 0 0 4 0 1 1 0" singular "0.5 0.25 0.25" yes inside
gives B7 "1 1 0 5 1 0 1 4 0 2 2 0" singular "0.4166666666666667 0.25 0.3333333333333333" yes inside
gives B8 "3 0 3 0 3 3 3 3 6 2 2 4" singular "0.3333333333333333 0.3333333333333333 0.3333333333333333" yes inside
gives B9 "0 0 1 1 1 1 2 2 1 1 1 1" singular degenerate
run "1 2 3 4 0 1 0 0 0 1.6666666666666667 0.6666666666666666 1.3333333333333333"
check "B5: T is rounded and thus beside the plane: $out" has "$out" "in_plane: no"
check "B5: singular" has "$out" "direct: singular"

# ---- the outline, and decisions by one ulp
gives "on an edge" "0 0 0 4 0 0 0 4 0 2 2 0" singular "0 0.5 0.5" yes edge
gives "at a corner" "1 0 0 0 1 0 0 0 1 0 1 0" "0 1 0" "0 1 0" yes vertex
gives "over a corner" "0 0 0 4 0 0 0 4 0 4 0 1" singular "0 1 0" no vertex
gives "beside an edge" "0 0 0 4 0 0 0 4 0 2 -5e-324 0" singular "0.5 0.5 0" yes outside
run "0.5 0.5000000000000001 1 12 12 1 24 24 1 12 12 1"
check "a sliver of one ulp is a triangle: $out" has "$out" "where: vertex"
gives "ends of the exponents" "1e308 0 0 0 1e308 0 0 0 1e308 0 0 1e308" "0 0 1" "0 0 1" yes vertex
gives "one point" "1 1 1 1 1 1 1 1 1 0 0 0" singular degenerate

run "1 0 0 0 1 0 0 0 1 1 1 1" --list
check "--list" is "$out" "-1 1 1"
run "0 0 1 1 1 1 2 2 1 1 1 1" --list
check "--list of a degenerate triangle" is "$out" degenerate

# ---- refusals and pictures
fails "nothing" ""
fails "eleven numbers" "1 0 0 0 1 0 0 0 1 1 1"
check "eleven: $err" has "$err" "z of T is missing: stdin:1:"
fails "a word" "1 0 0 0 b"
check "a word: $err" ends "$err" "y of B is not a number, 'b': stdin:1:9"
fails "too many" "1 0 0 0 1 0 0 0 1 1 1 1 1"
fails "unknown option" "" --robust
fails "weights beyond the numbers" "0 0 0 5e-324 0 0 0 5e-324 0 1 1 0"
course="1 2 3 4 0 1 2 5 -1 2 2 1.5"
run "$course" -o out.ppm
check "T is drawn in red" is_not "$(count out.ppm 204 96 72)" 0
run "1 1 1 1 1 1 1 1 1 0 0 0" -o out.png
check "a degenerate triangle has a picture" test -s out.png
pictures_of_all_sizes "$course"
no_room "$course"
conclude
