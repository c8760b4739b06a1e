#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The contract of `vectors`, seen from outside: the course's values, refusals, files left behind.
# usage: vectors.sh FOLDER-WITH-THE-PROGRAMS
# shellcheck source=tests/support/programs.sh
. "$(dirname "$0")/../support/programs.sh" vectors "$@"

helps --example --input --list --size -o

# ---- the course's values
expected='v1: 1 7 -5
s: 32
v2: 38 -14 -12
v3: 0.899676075239719 -0.33145960666726487 -0.28410823428622706
v4: -38 14 12
M1: 0 4 0 7 -1 10 0 4 4
M2: -6 22 3 -9 29 0 3 17 -18
M3: 2.5833333333333335 1.25 0.6666666666666666 1.6666666666666667 1 0.3333333333333333 4.666666666666667 2 0.3333333333333333'
course="2 3 -4  -1 4 -1  2 2 4   1 2 3  2 1 3  4 5 1   -1 2 -3  5 -2 7  -4 -1 3"
run "" --example
check "--example: exit 0: $err" is "$status" 0
check "--example" is "$out" "$expected"
run "$course # with a comment\n"
check "the same numbers, read" is "$out" "$expected"
run "$course" --list
check "--list: without names" is "$out" "$(sed 's/^[^:]*: //' <<<"$expected")"
printf '%s' "$course" >numbers
run "" --input numbers
check "--input" is "$out" "$expected"

# ---- singular, parallel, far apart
run "1 0 0  0 0 0  2 0 0   1 0 0 0 1 0 0 0 1   1 2 3  2 4 6  0 0 1"
check "v3 of a zero v2" has "$out" "v3: none"
check "no -0" has "$out" "v4: 0 0 0"
check "B without inverse" has "$out" "M3: singular"
run "1 0 0  0 0 0  2 0 0   1 0 0 0 1 0 0 0 1   0.1 0.2 0  0.3 0.6000000000000001 0  0 0 1"
check "B an ulp beside singular has one: $out" is_not "${out##*M3: }" singular
run "1e154 0 0  0 0 0  0 1e-154 0   1 0 0 0 1 0 0 0 1   1e-200 0 0 0 1e-200 0 0 0 1"
check "no overflow on the way: $err" has "$out" "v2: 0 0 1"
check "no underflow on the way" has "$out" "M3: 1e+200 0 0 0 1e+200 0 0 0 1"

# ---- refusals
fails "nothing" ""
check "nothing: place" ends "$err" "stdin:1:1"
fails "one number short" "${course% *}"
fails "one number more" "$course 7"
check "one more: place: $err" has "$err" "'7'"
fails "a word" "1 2 x"
check "a word: what and where: $err" ends "$err" "z of a is not a number, 'x': stdin:1:5"
fails "NaN" "1 2 nan"
fails "infinity" "1 2 1e999"
fails "too large a sum" "1e308 0 0  1e308 0 0  0 0 0   1 0 0 0 1 0 0 0 1   1 0 0 0 1 0 0 0 1"
fails "unknown option" "$course" --what
fails "example and input" "" --example --input numbers
fails "no such file" "" --input nowhere

# ---- pictures
for kind in png ppm svg; do
  run "" --example -o "out.$kind" --size 200x100
  check "$kind: exit 0: $err" is "$status" 0
  check "$kind is there" test -s "out.$kind"
done
check "v2 is drawn in red" is_not "$(count out.ppm 204 96 72)" 0
check "v4 is drawn in green" is_not "$(count out.ppm 78 148 96)" 0
fails "another ending" "" --example -o out.gif
cp numbers n.png
fails "the input would be overwritten" "" --input n.png -o n.png
pictures_of_all_sizes "$course"
no_room "$course"
conclude
