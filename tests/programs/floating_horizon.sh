#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The contract of `floating_horizon`, seen from outside: segments, horizons, tables, refusals, pictures.
# usage: floating_horizon.sh FOLDER-WITH-THE-PROGRAMS
# shellcheck source=tests/support/programs.sh
. "$(dirname "$0")/../support/programs.sh" floating_horizon "$@"

helps --function ripple --table --curves --samples --width --height --yaw --pitch --mode overlaid --test strict seed --list --horizons -o --size

# ---- a level square, seen from its side: two curves, as long as they are wide
level='0 0\n0 0\n'
printf "$level" >level.txt
flat="--table level.txt --curves 2 --width 4 --height 4 --pitch 0"
run "" $flat --yaw 0 --mode z --list
check "a level curve, drawn on both horizons: $out" is "$(sort -u <<<"$out")" $'0 0 1 0\n1 0 2 0\n2 0 3 0\n3 0 4 0'
run "" $flat --yaw 0 --mode z --horizons
check "its horizons: $out" is "$out" $'0 0\n0 0\n0 0\n0 0\n0 0'
run "" $flat --yaw 90 --mode x --horizons
check "turned by a right angle: $out" is "$out" $'0 0\n0 0\n0 0\n0 0\n0 0'
run "" $flat --yaw 0 --pitch 90 --mode both --horizons
check "from above: $out" is "$out" $'0 4\n0 4\n0 4\n0 4\n0 4'
printf '0 0 # near\n\n# between\n1 1\n' >ramp.txt
run "" --table ramp.txt --curves 3 --width 4 --height 4 --pitch 0 --yaw 0 --mode z --horizons
check "a ramp: $out" is "$out" $'0 4\n0 4\n0 4\n0 4\n0 4'

printf '\xEF\xBB\xBF0 0\r\n1 1\r\n' >marked.txt
run "" --table marked.txt --curves 3 --width 4 --height 4 --pitch 0 --yaw 0 --mode z --horizons
check "behind a byte order mark: $err$out" is "$out" $'0 4\n0 4\n0 4\n0 4\n0 4'
printf '\xEF\xBB\xBF0 x\n1 1\n' >marked.txt
fails "a word behind a byte order mark" "" --table marked.txt
check "its place does not count the mark: $err" ends "$err" "marked.txt:1:3"
printf '0 0 # near\r1 1\r' >marked.txt
run "" --table marked.txt --curves 3 --width 4 --height 4 --pitch 0 --yaw 0 --mode z --horizons
check "lines that carriage returns end: $err$out" is "$out" $'0 4\n0 4\n0 4\n0 4\n0 4'
rm marked.txt

# ---- both rules move the same horizons
run "" --horizons
horizons=$out
run "" --horizons --test seed
check "strict and seed: the same horizons" is "$out" "$horizons"
run "" --list
strict=$(wc -l <<<"$out")
check "no segment without length" is "$(awk '$1 == $3 && $2 == $4' <<<"$out")" ""
check "columns change by one at most" is "$(awk '$3 - $1 > 1 || $1 - $3 > 1' <<<"$out")" ""
run ""
check "segments: $out" is "$out" "segments: $strict"
run "" --mode z --samples 5 --curves 2 --width 100 --list
check "asked for few samples: $(wc -l <<<"$out")" test "$(wc -l <<<"$out")" -le 16

# ---- both families laid over each other, each with horizons of its own: one shows through the other
for view in "" "--yaw 60 --pitch 20 --curves 9" "--test seed --samples 40 --curves 5" "--yaw 0" "--yaw 90"; do
  run "" $view --mode z --list
  z=$out
  run "" $view --mode x --list
  both=$z$'\n'$out
  run "" $view --mode overlaid --list
  check "overlaid, $view: the curves of z, then those of x" is "$out" "$both"
done
run "" --mode overlaid -o over.ppm --size 200x150
check "overlaid: exit 0: $err" is "$status" 0
run "" -o right.ppm --size 200x150
check "another picture than the right one" is_not "$(cksum <over.ppm)" "$(cksum <right.ppm)"
fails "horizons of two drawings" "" --mode overlaid --horizons
check "says so: $err" has "$err" "--horizons needs --mode z, x or both"
rm -f over.ppm right.ppm

# ---- refusals
fails "one curve" "" --curves 1
fails "one sample" "" --samples 1
fails "no width" "" --width 0
fails "negative height" "" --height -3
fails "yaw beyond 90" "" --yaw 90.5
fails "negative yaw" "" --yaw -1
fails "pitch beyond -90" "" --pitch -91
fails "nan" "" --yaw nan
fails "no such mode" "" --mode y
fails "no such rule" "" --test loose
fails "no such function" "" --function sine
fails "two things to print" "" --list --horizons
fails "no such file" "" --table nowhere.txt
printf '1 2\n3\n' >short.txt
fails "a short row" "" --table short.txt
check "a short row: place: $err" ends "$err" "short.txt:2:2"
printf '1 2\n3 x4\n' >word.txt
fails "a word" "" --table word.txt
check "a word: place: $err" ends "$err" "word.txt:2:3"
printf '1 2\n' >one.txt
fails "one row" "" --table one.txt
printf '1\n2\n' >thin.txt
fails "one column" "" --table thin.txt
printf '' >empty.txt
fails "an empty table" "" --table empty.txt
fails "the table overwritten" "" --table level.txt -o level.txt
fails "no option" "" --deep
fails "no picture's name" "" -o counts.txt
fails "no such folder" "" -o nowhere/horizon.png

# ---- pictures
pictures_of_all_sizes ""
no_room ""
conclude
