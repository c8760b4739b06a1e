#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The contract of `convex_polygon`, seen from outside: the course's polygon, every rule, refusals, files left behind.
# usage: convex_polygon.sh FOLDER-WITH-THE-PROGRAMS
# shellcheck source=tests/support/programs.sh
# shellcheck disable=SC2154 # id comes from window.sh
here=$(cd "$(dirname "$0")" && pwd)
. "$here/../support/programs.sh" convex_polygon "$@"
. "$here/../support/window.sh"

course="4
50 200   150 350   300 150   100 50
150 200
"
: >empty

# ---- help
helps usage: --input --rule --list --size --window -o top-left course closed rounded half-open

# ---- the course's polygon
run "$course"
check "the course's polygon: exit 0: $err" is "$status" 0
check "silent on standard error" is "$err" ""
check "orientation" is "$(line orientation)" clockwise
check "convex" is "$(line convex)" yes
check "edges" is "$(line edge | tr '\n' ';')" "-150 100 -12500;200 150 -82500;100 -200 0;-150 -50 17500;"
check "point" is "$(line point)" inside
check "the order of the lines" is "$(sed 's/:.*//' .out | tr '\n' ' ')" "orientation convex edge edge edge edge point pixels "
check "top-left is the default: 38775 pixels, counted by brute force" is "$(line pixels)" 38775

declare -A pixels=([course]=38874 [closed]=38876 [rounded]=39074 [half-open]=38725 [top-left]=38775)
declare -A rows=([course]=299 [closed]=301 [rounded]=299 [half-open]=299 [top-left]=299)
reversed="4  100 50 300 150 150 350 50 200  150 200"
turned="4  300 150 100 50 50 200 150 350  150 200"
for rule in "${!pixels[@]}"; do
  run "$course" --rule "$rule"
  check "$rule: ${pixels[$rule]} pixels, not $(line pixels)" is "$(line pixels)" "${pixels[$rule]}"
  run "$course" --rule "$rule" --list
  cp .out spans
  check "--list $rule: rows" is "$(wc -l <spans)" "${rows[$rule]}"
  check "--list $rule: sums up to the pixels" is "$(awk '{ n += $3 - $2 + 1 } END { print n }' spans)" "${pixels[$rule]}"
  check "--list $rule: three whole numbers a line" is "$(grep -cvE '^-?[0-9]+ -?[0-9]+ -?[0-9]+$' spans)" 0
  check "--list $rule: ordered" sort -c -k1n -k2n spans
  check "--list $rule: no empty span" is "$(awk '$3 < $2' spans | wc -l)" 0
  for other in "$reversed" "$turned"; do
    run "$other" --rule "$rule" --list
    check "$rule: the same spans either way round and from any vertex" cmp -s .out spans
  done
done
run "$reversed"
check "reversed: orientation" is "$(line orientation)" counter-clockwise
check "reversed: the edges keep the given order" is "$(line edge | head -n 1)" "-100 200 0"
# Half-open samples of a polygon are the top-left centres of the polygon moved by half a pixel.
run "4 50.5 200.5 150.5 350.5 300.5 150.5 100.5 50.5 0 0"
check "top-left, moved by half a pixel, is half-open" is "$(line pixels)" 38725
run "$course" --rule course --list
check "course: row 100" has "$out" "
100 84 200
"
run "$course" --rule closed --list
check "closed: the one-point row 50" is "$(head -n 1 .out)" "50 100 100"

# ---- the point
for pair in "150 200=inside" "100 275=boundary" "50 200=boundary" "300 350=outside" "200 100=boundary" "0 0=outside" \
  "200.5 100=outside" "199.5 100=inside" "100 275.0000000001=outside" "100 274.9999999999=inside" "1e300 1e300=outside"; do
  run "4 50 200 150 350 300 150 100 50 ${pair%=*}"
  check "the point ${pair%=*} is ${pair#*=}, not $(line point)" is "$(line point)" "${pair#*=}"
done

# ---- convexity
run "5 0 1000 588 -809 -951 309 951 309 -588 -809 0 0"
check "a pentagram is not convex" is "$(line convex)" no
check "a pentagram's orientation" is "$(line orientation)" clockwise
check "a pentagram's middle is inside" is "$(line point)" inside
star=$(line pixels)
check "a pentagram is filled by the non-zero rule" test "$star" -gt 1000000
run "4 0 0 0 4 2 1 4 4 1 1"
check "a dart is not convex" is "$(line convex)" no
check "a dart is filled by top-left" is "$(line pixels)" 4
run "4 0 0 4 4 4 0 0 4 1 1"
check "a bow-tie is not convex" is "$(line convex)" no
check "a bow-tie has no orientation" is "$(line orientation)" degenerate
run "6 0 0 2 0 4 0 4 4 0 4 0 4 0 0"
check "collinear and repeated vertices are convex" is "$(line convex)" yes
check "and counter-clockwise" is "$(line orientation)" counter-clockwise
check "and filled" is "$(line pixels)" 16
run "3 0.1 0.3 0.2 0.6 0.3 0.9 0 0"
check "nearly collinear, decided for the numbers as read" is "$(line orientation)" counter-clockwise
run "3 0.5 0.5 12 12 24 24.000000000000004 0 0"
check "one ulp off is counter-clockwise" is "$(line orientation)" counter-clockwise
run "3 0 0 1e-320 0 0 1e-320 0 0"
check "the least numbers have an orientation" is "$(line orientation)" counter-clockwise
for rule in course closed rounded half-open; do
  refused "a pentagram by $rule" "not convex" "5 0 1000 588 -809 -951 309 951 309 -588 -809 0 0" --rule $rule
  refused "a dart by $rule, listed" "stdin:1:17" "4 0 0 0 4 2 1 4 4 1 1" --rule $rule --list -o x.png
done

# ---- decimals
run "4 0.5 0.25 0.5 3.75 3.125 3.75 3.125 0.25 1 1"
check "decimals: a edge" is "$(line edge | head -n 1)" "-3.5 0 1.75"
check "decimals: pixels" is "$(line pixels)" 12
run "4 0.5 0.25 0.5 3.75 3.125 3.75 3.125 0.25 1 1" --rule closed
check "decimals: closed" is "$(line pixels)" 9
run "3 0.001953125 0 4 0 0.001953125 4 0 0" --rule closed # 1/512 is rounded up to 1/256
check "vertices are rounded to 1/256" is "$(line pixels)" 10
# Rows times edges are too many here: 4 million times 3000.
awk 'BEGIN { n = 3000; print n; for (i = 0; i < n; ++i) printf "%.15g %.15g\n", 2e6 * cos(i * 6.283185307179586 / n), 2e6 * sin(i * 6.283185307179586 / n); print "0 0" }' >large
for rule in top-left course closed rounded half-open; do
  timeout 30 "$program" --rule $rule <large >.out 2>.err
  check "a large circle by $rule: $(line pixels)" is "$(line pixels | cut -c 1-7)" 1256636
done
# With memory for the report but not for the fill, nothing is printed. 126 and up: not even the program could start.
if (ulimit -v 48000 && "$program" --help) >/dev/null 2>&1; then
  awk 'BEGIN { n = 100000; print n; for (i = 0; i < n; ++i) print (i * 7919) % 211, (i * 104729) % 199; print "0 0" }' >tangle
  for memory in 12000 16000 24000 32000 48000; do
    (ulimit -v $memory && exec "$program" <tangle) >.out 2>.err
    status=$?
    check "in $memory KiB: an answer, or exit 2 and no output" \
      test "$status" = 0 -o "$status" = 2 -a ! -s .out -o "$status" = 126 -o "$status" = 127
  done
fi
run "3 0 0 1e-1 0 +0.0 .1 -0 -0.0"
check "minus zero is printed as 0" is "$(line edge | tr '\n' ';')" "0 0.1 0;-0.1 -0.1 0.010000000000000002;0.1 0 0;"
run "3 -2097152 -2097152 2097152 -2097152 2097152 2097152 0 0"
check "the largest polygon" is "$(line pixels)" 8796095119360
# A circle of many vertices, which rounding makes not quite convex: every rule still finds the disc.
awk 'BEGIN { n = 20000; print n; for (i = 0; i < n; ++i) printf "%.15g %.15g\n", 50 * cos(i * 6.283185307179586 / n), 50 * sin(i * 6.283185307179586 / n); print "0 0" }' >circle
for rule in top-left course closed rounded half-open; do
  run "$(cat circle)" --rule $rule
  check "a circle by $rule is convex" is "$(line convex)" yes
  check "a circle by $rule is filled, not $(line pixels)" test "$(line pixels)" -gt 7700 -a "$(line pixels)" -lt 8000
done

# ---- few vertices
for few in "0 3 4" "1 3 4 3 4" "2 0 0 2 4 1 2"; do
  refused "${few:0:1} vertices" "a polygon has at least three vertices, not ${few:0:1}: stdin:1:1" "$few"
  refused "${few:0:1} vertices, listed and drawn" "at least three" "$few" --list -o few.png --rule closed
done
run "3 0 0 2 4 4 8 1 2"
check "collinear vertices" is "$(line orientation) $(line pixels)" "degenerate 0"
run "3 0 0 2 4 4 8 1 2" --list
check "collinear vertices have no spans" is "$out" ""
run "3 0 0 2 4 4 8 1 2" --rule closed
check "collinear vertices, closed" is "$(line pixels)" 5

# ---- input
printf '# the polygon\n4 # vertices\n50 200\t150 350\r\n300 150 100 50#end\n150 200' >polygon.txt
run "" --input polygon.txt --rule course
check "comments, tabs, no line end: $err" is "$(line pixels)" 38874
refused "n missing" "n is missing: stdin:1:1" ""
refused "only a comment" "n is missing: stdin:2:1" "# nothing
"
refused "n < 0" "n is less than 0: stdin:1:1" "-1 0 0"
refused "n is no whole number" "stdin:1:1" "3.5 0 0 1 0 0 1 0 0"
refused "n is too large" "stdin:1:1" "99999999999 0 0"
refused "n is no number" "stdin:1:1" "three"
refused "a vertex is missing" "y of vertex 3 is missing: stdin:1:12" "3 0 0 1 0 0"
refused "n promises more than there is" "x of vertex 2 is missing" "2000000000 1 1"
refused "the point is missing" "x of the point is missing" "3 0 0 1 0 0 1"
refused "half of the point is missing" "y of the point is missing" "3 0 0 1 0 0 1 5"
refused "a number too many" "stdin:2:3" "3 0 0 1 0 0 1 5 5
  7"
for word in nan NaN inf -inf infinity 1e999 x 1,5 0x10 1e 1.5.2 --1; do
  refused "a vertex '$word'" "stdin:1:7" "3 0 0 $word 0 0 1 0 0"
  refused "a point '$word'" "stdin:2:3" "3 0 0 1 0 0 1
0 $word"
done
refused "a vertex out of range" "x of vertex 2 is out of range, it is not from -2097152 to 2097152: stdin:1:7" "3 0 0 2097152.5 0 0 1 0 0"
refused "a vertex far out of range" "stdin:1:5" "3 0 -1e300 1 0 0 1 0 0"
refused "a place in a file" "bad.txt:2:5" "" --input "$(printf '3 0 0\n1 0 nan 1 0 0' >bad.txt; echo bad.txt)"
refused "a missing file" "missing.txt" "" --input missing.txt
refused "an empty file" "empty:1:1" "" --input empty
mkdir folder
refused "a folder" "folder" "" --input folder
refused "an empty name" "--input" "$course" --input ""

# ---- options
refused "an unknown rule" "top-left, course, closed, rounded, half-open" "$course" --rule topleft
refused "half_open is spelled half-open" "half-open" "$course" --rule half_open
refused "no rule" "--rule" "$course" --rule
refused "an unknown option" "--colour" "$course" --colour red
refused "a word too many" "polygon.txt" "$course" polygon.txt
refused "no picture" "-o" "$course" -o
for size in 0x0 5x 5 axb 70000x1 65535x65535 -5x5 5x5x5 ""; do
  refused "--size '$size'" "--size" "$course" --size "$size" -o x.png
done

# ---- pictures
run "$course" -o p.ppm --size 320x340 --rule course
check "a picture: exit 0: $err" is "$status" 0
check "a picture beside the results" is "$(line pixels)" 38874
check "a picture's size" is "$(sed -n 2p p.ppm)" "320 340"
blue=$(count p.ppm 146 184 222)
check "most of the polygon is seen, $blue pixels" test "$blue" -gt 37500 -a "$blue" -lt 38874
run "$course" -o p.png --list
check "a PNG" is "$(head -c 4 p.png | tail -c 3)" PNG
check "a PNG and the list" is "$(wc -l <.out)" 299
for input in "$(cat circle)" "3 0 0 0 0 0 0 0 0" "3 5 5 6 6 7 7 5 5" "3 -2097152 -2097152 2097152 -2097152 2097152 2097152 1e300 -1e300" "4 0 0 0 4 2 1 4 4 1 1"; do
  pictures_of_all_sizes "$input"
done
refused "a picture of unknown ending" ".png" "$course" -o x.gif
refused "a picture in no folder" "nowhere/x.png" "$course" -o nowhere/x.png
mkdir folder.png
refused "a picture that is a folder" "folder.png" "$course" -o folder.png
cp polygon.txt self.ppm
refused "a picture over the input" "overwritten" "" --input self.ppm -o ./self.ppm
check "the input is as it was" cmp -s polygon.txt self.ppm
refused "a picture of bad input" "stdin" "3 0 0" -o x.png
no_room "$course"

# ---- vertices by mouse
if has_window; then
  fails "a window and a list" "" --window --list
  fails "a window and numbers" "" --window --input polygon.txt
  press() { xdotool mousemove --window "$id" "$1" "$2" click "${3:-1}"; }
  open_window 'irg convex polygon' --size 640x480
  press 50 200
  check "a vertex" said '^vertex: 50 200$'
  press 150 350
  check "another" said '^vertex: 150 350$'
  xdotool key Return
  check "two are refused" said '^refused: a polygon has at least three vertices, not 2$'
  press 300 150
  press 400 10
  check "a wrong one" said '^vertex: 400 10$'
  xdotool key BackSpace
  check "is taken back" said '^one less$'
  press 100 50
  press 150 200 3
  check "the point" said '^asked: 150 200$'
  xdotool key Return
  check "the report" said '^pixels: 38775$'
  xdotool key F6
  check "the picture" said '^picture: convex_polygon.png$'
  press 100 275 3
  check "another point" said '^point: boundary$'
  xdotool key Delete
  check "anew" said '^anew$'
  press 10 10
  press 20 10
  press 10 20
  press 20 20
  xdotool key Return
  check "a bow-tie is none but filled" said '^orientation: degenerate$'
  end_window
  # What is behind input: is the same polygon, read as numbers.
  sed -n '/^input: 4 50/,/^pixels/p' window.out | sed '/^pixels/q' >first
  sed -n '1s/^input: //p' first >numbers
  check "the numbers: $(cat numbers)" is "$(cat numbers)" "4 50 200 150 350 300 150 100 50 150 200"
  run "" --input numbers
  check "the same report: $out" is "$out" "$(sed 1d first)"
  check "a picture of the window's size" is "$(head -c 24 convex_polygon.png | tail -c 8 | od -An -tx1 | tr -d ' ')" "00000280000001e0"
  open_window 'irg convex polygon' --size 320x240 --rule closed -o other.ppm
  press 10 229
  check "with the other rules y points up" said '^vertex: 10 10$'
  press 100 229
  press 20 200
  press 10 100
  xdotool key Return
  check "and what is not convex is refused" said '^refused: the polygon is not convex; only --rule top-left'
  xdotool key BackSpace key Return
  check "three are filled" said '^pixels: '
  xdotool key F6
  check "into the picture that is named" said '^picture: other.ppm$'
  end_window
  check "its pixels are those that are told: $(count other.ppm 146 184 222)" \
    test "$(count other.ppm 146 184 222)" -le "$(sed -n 's/^pixels: //p' window.out)" -a "$(count other.ppm 146 184 222)" -gt 500
fi

check "no temporary file is left" is "$(find . -name '*.part' | wc -l)" 0
conclude
