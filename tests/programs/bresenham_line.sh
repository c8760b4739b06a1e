#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The contract of `bresenham_line`, seen from outside: cells, methods, windows, refusals, pictures.
# usage: bresenham_line.sh FOLDER-WITH-THE-PROGRAMS
# shellcheck source=tests/support/programs.sh
. "$(dirname "$0")/../support/programs.sh" bresenham_line "$@"

# answers_silently "what" "expected lines" "input" arguments...
answers_silently() {
  local what=$1 expected
  expected=$(printf '%b' "$2")
  shift 2
  run "$@"
  check "$what: exit 0, not $status: $err" is "$status" 0
  check "$what: nothing on standard error: $err" is "$err" ""
  check "$what: '$expected', not '$out'" is "$out" "$expected"
}
# refuses "what" "end of the message" "input" arguments...
refuses() {
  local what=$1 part=$2
  shift 2
  fails "$what" "$@"
  check "$what: ends with '$part': $err" ends "$err" "$part"
}

# ---- help
helps --input --method integer symmetric textbook seed --window --list -o --size 1048576

# ---- the course's line
course="10 10 200 100"
answers_silently "the course's line" "cells: 191\ndiffering: 0" "$course"
answers_silently "numbers on lines of their own, with comments" "cells: 191\ndiffering: 0" \
  "# from\n10\t10 # here\r\n\n200\n100# there\n"
answers_silently "a byte order mark, signs and leading zeros" "cells: 191\ndiffering: 0" "\xEF\xBB\xBF+10 010\r200 100"
answers_silently "textbook" "cells: 191\ndiffering: 0" "$course" --method textbook
answers_silently "symmetric" "cells: 191\ndiffering: 0" "$course" --method symmetric
answers_silently "seed lacks the last cell" "cells: 190\ndiffering: 1" "$course" --method seed
run "$course" --list
check "--list: 191 lines" is "$(wc -l <.out)" 191
check "--list: from" is "$(head -n 1 .out)" "10 10"
check "--list: to" is "$(tail -n 1 .out)" "200 100"
check "--list: the course's y at x" is "$(grep -E '^(11|12|13|14|20|50|105|150|199) ' .out | cut -d' ' -f2 | tr '\n' ' ')" \
  "10 11 11 12 15 29 55 76 100 "
check "--list: the course's sum of y" is "$(awk '{ s += $2 } END { print s }' .out)" 10505
check "--list: the course's sum of x y" is "$(awk '{ s += $1 * $2 } END { print s }' .out)" 1378215
check "--list: the course's 82 rows of 2, 9 of 3" is "$(cut -d' ' -f2 .out | uniq -c | awk '{ n[$1]++ } END { print n[2], n[3] }')" "82 9"
cp .out integer.txt
run "$course" --list --method textbook
check "textbook: the same cells" cmp -s .out integer.txt
run "$course" --list --method seed
check "seed: the same cells but the last" is "$out" "$(head -n 190 integer.txt)"

# ---- octants, ties, degenerate lines
answers_silently "5 2" "0 0\n1 0\n2 1\n3 1\n4 2\n5 2" "0 0 5 2" --list
answers_silently "2 5" "0 0\n0 1\n1 2\n1 3\n2 4\n2 5" "0 0 2 5" --list
answers_silently "-2 5" "0 0\n0 1\n-1 2\n-1 3\n-2 4\n-2 5" "0 0 -2 5" --list
answers_silently "-5 2" "0 0\n-1 0\n-2 1\n-3 1\n-4 2\n-5 2" "0 0 -5 2" --list --method textbook
answers_silently "-5 -2" "0 0\n-1 0\n-2 -1\n-3 -1\n-4 -2\n-5 -2" "0 0 -5 -2" --list
answers_silently "-2 -5" "0 0\n0 -1\n-1 -2\n-1 -3\n-2 -4\n-2 -5" "0 0 -2 -5" --list --method textbook
answers_silently "2 -5" "0 0\n0 -1\n1 -2\n1 -3\n2 -4\n2 -5" "0 0 2 -5" --list
answers_silently "5 -2" "0 0\n1 0\n2 -1\n3 -1\n4 -2\n5 -2" "0 0 5 -2" --list
answers_silently "a point" "3 3" "3 3 3 3" --list
answers_silently "a point, symmetric" "cells: 1\ndiffering: 0" "3 3 3 3" --method symmetric
answers_silently "a point, textbook" "cells: 1\ndiffering: 0" "3 3 3 3" --method textbook
answers_silently "ties stay on the start's side" "0 0\n1 0\n2 1\n3 1\n4 2" "0 0 4 2" --list
answers_silently "and back" "4 2\n3 2\n2 1\n1 1\n0 0" "4 2 0 0" --list
answers_silently "the textbook's ties, where doubles are no help" "0 0\n1 1\n2 2\n3 2\n4 3\n5 4\n6 5" "0 0 6 5" --list --method textbook
answers_silently "symmetric, forward" "0 0\n1 0\n2 1\n3 1\n4 2\n5 2\n6 3\n7 3\n8 4" "0 0 8 4" --list --method symmetric
answers_silently "symmetric, back" "8 4\n7 3\n6 3\n5 2\n4 2\n3 1\n2 1\n1 0\n0 0" "8 4 0 0" --list --method symmetric
answers_silently "symmetric, left and up" "0 0\n-1 1\n-2 1\n-3 2\n-4 2\n-5 3\n-6 3\n-7 4\n-8 4" "0 0 -8 4" --list --method symmetric
answers_silently "symmetric, steep" "4 8\n3 7\n3 6\n2 5\n2 4\n1 3\n1 2\n0 1\n0 0" "4 8 0 0" --list --method symmetric
answers_silently "symmetric differs at its ties" "cells: 9\ndiffering: 4" "8 4 0 0" --method symmetric

# ---- windows, both borders included
answers_silently "window" "1 0\n2 1\n3 1" "0 0 5 2" --list --window 1,0,3,1
answers_silently "window of one cell" "2 1" "0 0 5 2" --list --window 2,1,2,1
answers_silently "negative window" "-3 1\n-2 1" "-5 2 0 0" --list --window -3,0,-2,9
answers_silently "window that is missed" "cells: 0\ndiffering: 0" "0 0 5 2" --window 0,2,3,9
answers_silently "empty list" "" "0 0 5 2" --window 0,2,3,9 --list
answers_silently "inverted window" "cells: 0\ndiffering: 0" "0 0 5 2" --window 3,3,1,1
answers_silently "a differing cell counts where it is seen" "cells: 4\ndiffering: 2" "8 4 0 0" --method symmetric --window 3,0,6,9
answers_silently "a reference cell that is seen counts" "cells: 0\ndiffering: 1" "8 4 0 0" --method symmetric --window 1,1,1,1
answers_silently "seed's missing cell, out of sight" "cells: 2\ndiffering: 0" "0 0 5 2" --method seed --window 0,0,1,9
answers_silently "the whole of int" "cells: 6\ndiffering: 0" "0 0 5 2" --window -2147483648,-2147483648,2147483647,2147483647
for method in integer symmetric textbook seed; do
  run "0 0 900 411" --list --method $method
  awk '$1 >= 100 && $1 <= 707 && $2 >= 50 && $2 <= 300' .out >expected.txt
  run "0 0 900 411" --list --method $method --window 100,50,707,300
  check "$method: clipping changes no cell" cmp -s .out expected.txt
done

# ---- the whole of int, at once
far="-2147483648 -2147483648 2147483647 2147483647"
near="-2147483648 -2147483648 -2130706432 -2130706432"
for method in integer symmetric; do
  answers_silently "2^24 steps, $method" "cells: 16777217\ndiffering: 0" "$near" --method $method
done
answers_silently "2^24 steps, seed" "cells: 16777216\ndiffering: 1" "$near" --method seed
answers_silently "ties, 2^24 steps of slope 1/2" "cells: 16777217\ndiffering: 8388608" "0 8388608 -16777216 0" --method symmetric
answers_silently "seed at ties" "cells: 4000\ndiffering: 1" "-2147483648 0 -2147479648 1999" --method seed
if [ -n "${IRG_RELEASE_TIER:-}" ]; then  # half a minute each
  answers_silently "the longest line" "cells: 4294967296\ndiffering: 0" "$far"
  answers_silently "the longest line, symmetric" "cells: 4294967296\ndiffering: 0" "$far" --method symmetric
  answers_silently "the longest line, seed" "cells: 4294967295\ndiffering: 1" "$far" --method seed
  answers_silently "ties, 2^31 steps of slope 1/2" "cells: 2147483649\ndiffering: 1073741824" "0 1073741824 -2147483648 0" \
    --method symmetric
fi
answers_silently "the longest line in 64 x 64" "cells: 64\ndiffering: 0" "$far" --window 0,0,63,63
answers_silently "the greatest cells" "2147483646 2147483646\n2147483647 2147483647" "$far" --list \
  --window 2147483646,0,2147483647,2147483647
# Counted in one walk; the other way by comparing two lists.
for window in 5000000,0,5000999,9999999 4999990,2500000,6000000,2500003 5000001,2500000,5000001,2500000; do
  for line in "20000000 10000000 0 0" "20000001 10000002 1 2" "20000004 10000003 0 0"; do
    run "$line" --list --window $window
    cp .out first.txt
    run "$line" --list --window $window --method symmetric
    sort .out >second.txt
    sort first.txt | comm -3 - second.txt | sed 's/^\t//' | cut -d' ' -f1 | sort -u >differing.txt
    run "$line" --window $window --method symmetric
    check "ties counted in $window on $line" is "$(sed -n 's/differing: //p' .out)" "$(wc -l <differing.txt)"
  done
done

# ---- the methods' domains
limit="0 0 1048576 524289"
answers_silently "textbook: 2^20 steps" "cells: 1048577\ndiffering: 0" "$limit" --method textbook
answers_silently "textbook: 2^20 steps, all of them ties or near" "cells: 1048577\ndiffering: 0" "1048576 7 0 349532" --method textbook
refuses "textbook: one step more" "stdin:1:13" "0 0 1048577 5" --method textbook
for line in "0 0 2 5" "0 0 -5 2" "0 0 -5 -2" "0 0 5 -2" "0 0 0 0" "0 0 0 5"; do
  last=${line##* }
  refuses "seed: $line" "stdin:1:$((${#line} - ${#last} + 1))" "$line" --method seed
done
answers_silently "seed: 45 degrees" "cells: 3\ndiffering: 1" "0 0 3 3" --method seed
answers_silently "seed: level" "cells: 3\ndiffering: 1" "0 0 3 0" --method seed

# ---- pictures
run "$course" -o course.ppm --size 220x150
check "picture: exit 0: $err" is "$status" 0
check "picture: the answer is printed, too" is "$out" "$(printf 'cells: 191\ndiffering: 0')"
check "picture: its size" is "$(sed -n 2p course.ppm)" "220 150"
check "picture: 191 blue pixels" is "$(count course.ppm 48 90 140)" 191
check "picture: 191 red pixels" is "$(count course.ppm 204 96 72)" 191
row() { pixels "$1" | grep -n "^ *$2 *$3 *$4\$" | cut -d: -f1 | awk -v w="$5" '{ print ($1 - 1) % w, int(($1 - 1) / w) }'; }
row course.ppm 48 90 140 220 | awk '{ print $1, $2 + 20 }' >blue.txt
row course.ppm 204 96 72 220 >red.txt
check "picture: the reference line is the same, 20 rows further" cmp -s blue.txt red.txt
run "0 0 5 2" -o vector.svg --size 90x250
check "a picture as SVG" grep -q '<rect .*fill="#305a8c"/>' vector.svg
run "0 0 5 2" -o small.ppm --size 90x250 --method symmetric
check "small lines are enlarged: 6 squares of 9 x 9" is "$(count small.ppm 48 90 140)" $((6 * 9 * 9))
run "$course" -o picture.png
check "picture.png: exit 0: $err" is "$status" 0
check "PNG begins as it must" is "$(head -c 8 picture.png | od -An -tx1 | tr -d ' \n')" 89504e470d0a1a0a
lines=("$near" "2147483647 2147483647 2140000000 2144000000" "-2147483648 2147483647 -2147000000 2147483600" "5 5 5 5")
[ -z "${IRG_RELEASE_TIER:-}" ] ||
  lines+=("$far" "2147483647 2147483647 -2147483648 0" "-2147483648 2147483647 2147483647 2147483600")
for line in "${lines[@]}"; do
  run "$line" -o far.ppm
  check "picture of $line: exit 0: $err" is "$status" 0
  check "picture of $line: the line" test "$(count far.ppm 48 90 140)" -gt 0
  check "picture of $line: the reference line" test "$(count far.ppm 204 96 72)" -gt 0
done
run "$course" -o none.ppm --window 0,0,1,1
check "picture of no cell: exit 0: $err" is "$status" 0
check "picture of no cell: empty" is "$(count none.ppm 48 90 140)" 0
run "$course" --list -o listed.ppm
check "picture and list" is "$out" "$(cat integer.txt)"

# ---- files
printf '10 10\n200 100\n' >line.txt
answers_silently "--input" "cells: 191\ndiffering: 0" "" --input line.txt
refuses "no such file" "file does not exist: none.txt" "$course" --input none.txt
refuses "a folder" "path is a directory, not a file: ." "$course" --input .
: >empty.txt
refuses "an empty file" "x1 is missing: empty.txt:1:1" "" --input empty.txt
printf '1 2\n3 4\n\n  5' >more.txt
refuses "a left-over number in a file" "nothing more is expected, but there is '5': more.txt:4:3" "" --input more.txt
refuses "the input as picture" "overwritten: line.ppm" "$course" --input line.ppm -o line.ppm
refuses "a picture in no folder" "nowhere/x.png" "$course" -o nowhere/x.png
refuses "an ending that is not written" ".png, .ppm or .svg, not: x.gif" "$course" -o x.gif
refuses "no ending" ".png, .ppm or .svg, not: x" "$course" -o x
mkdir folder.png
refuses "a picture that is a folder" "folder.png" "$course" -o folder.png

# ---- numbers that are wrong
refuses "nothing" "x1 is missing: stdin:1:1" ""
refuses "a comment only" "x1 is missing: stdin:2:1" "# 1 2 3 4\n"
refuses "three numbers" "y2 is missing: stdin:1:6" "1 2 3"
refuses "three numbers and a line" "y2 is missing: stdin:3:1" "1 2\n3\n"
refuses "five numbers" "nothing more is expected, but there is '5': stdin:1:9" "1 2 3 4 5"
refuses "five numbers on lines" "there is '5': stdin:3:2" "1 2 # a\n3 4\n\t5"
refuses "no number" "y1 is not a number, 'two': stdin:1:3" "1 two 3 4"
refuses "a number and more" "x1 is not a number, '1x': stdin:1:1" "1x 2 3 4"
refuses "comma" "x1 is not a number, '1,2,3,4': stdin:1:1" "1,2,3,4"
refuses "NaN" "x2 is not a number, 'nan': stdin:1:5" "1 2 nan 4"
refuses "infinity" "x2 is not a number, '-inf': stdin:1:5" "1 2 -inf 4"
refuses "a decimal" "y2 is not a whole number, '4.5': stdin:1:7" "1 2 3 4.5"
refuses "an exponent" "y2 is not a whole number, '1e2': stdin:1:7" "1 2 3 1e2"
refuses "2^31" "to 2147483647: stdin:2:1" "1\n2147483648 3 4"
refuses "-2^31 - 1" "to 2147483647: stdin:1:1" "-2147483649 1 3 4"
refuses "2^64" "to 2147483647: stdin:1:1" "18446744073709551616 1 3 4"
refuses "two signs" "x1 is not a number, '--1': stdin:1:1" "--1 1 3 4"
refuses "a NUL byte" "stdin:1:3" "1 \0002 3 4"
refuses "a broken byte order mark" "stdin:1:1" "\xEF1 2 3 4"
refuses "a control character in a number stays on the line" "stdin:1:1" "1\0331 2 3 4"
refuses "a long line" "there is '5': stdin:1:100008" "1 2 3 4$(printf '%100000s' '')5"
(yes 1 | timeout 60 "$program" >.out 2>.err)
check "endless numbers end" is "$(cat .err)" "bresenham_line: nothing more is expected, but there is '1': stdin:5:1"
(tr '\0' 7 </dev/zero | timeout 60 "$program" >.out 2>.err)
check "an endless number ends" is "$(cat .err)" "bresenham_line: a number has more than a million characters: stdin:1:1"
timeout 60 "$program" <&- >.out 2>.err
check "no standard input: exit 2" is "$?" 2
check "no standard input: one line" is "$(wc -l <.err)" 1

# ---- options that are wrong
refuses "an unknown option" "--help lists them" "$course" --depth 3
refuses "a word" "unexpected word 'line.txt'; --help tells how" "$course" line.txt
refuses "an unknown method" "supported: integer, symmetric, textbook, seed" "$course" --method dda
refuses "a method missing" "needs a value" "$course" --method
refuses "a window of three" "not '0,0,1'" "$course" --window 0,0,1
refuses "a window of five" "not '0,0,1,1,1'" "$course" --window 0,0,1,1,1
refuses "a window with halves" "2147483647" "$course" --window 0,0,1.5,1
refuses "a window out of int" "2147483647" "$course" --window 0,0,2147483648,1
refuses "a window that is none" "not 'all'" "$course" --window all
refuses "an empty input" "needs a file's name" "$course" --input ""
refuses "a size of 0" "not '0x5'" "$course" --size 0x5
refuses "a size of one number" "not '5'" "$course" --size 5
refuses "a huge size" "not '65536x1'" "$course" --size 65536x1
refuses "too many pixels" "not '65535x65535'" "$course" --size 65535x65535
no_room "$course"

conclude
