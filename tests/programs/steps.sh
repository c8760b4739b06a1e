#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The steps 01 to 12 and their command lines; and --help of every program, each of which says how it is called.
# shellcheck disable=SC2154 # status, out, err and program come from programs.sh
sources=$(cd "$(dirname "$0")/../../examples" && pwd)
. "$(dirname "$0")/../support/programs.sh" 01_pixel "$@"
folder=$(dirname "$program")

# says_usage "help" NAME: one line begins with `usage: NAME`, and what can be given there, within 120 columns.
says_usage() {
  local lines
  lines=$(grep '^usage:' <<<"$1")
  [ "$(wc -l <<<"$lines")" = 1 ] && [ ${#lines} -le 120 ] && { is "$lines" "usage: $2" || begins "$lines" "usage: $2 "; }
}

steps=0
for program in "$folder"/[0-9][0-9]_*; do
  [ -f "$program" ] || continue
  name=$(basename "$program")
  steps=$((steps + 1))
  for word in --help -h; do
    run "" "$word"
    check "$name $word: exit 0" is "$status" 0
    check "$name $word: nothing on standard error" is "$err" ""
    check "$name $word: says what it is" begins "$out" "$name: "
    check "$name $word: says how it is called" says_usage "$out" "$name"
  done
  check "$name --help leaves no file" is "$(files)" ""
  fails "$name: an option that it has not" "" --size 3x3
  check "$name: the option is named: $err" has "$err" "unknown option '--size'"
  fails "$name: words too many" "" one.png two.png
  check "$name: the word is named: $err" has "$err" "unexpected word"
done
check "there are twelve steps, not $steps" is $steps 12

for name in 08_teapot 09_shader 10_renderer 11_own_method; do
  program=$folder/$name
  fails "$name: a folder that is not there" "" missing/picture.png
  check "$name: the file is named, without a position: $err" ends "$err" ": missing/picture.png"
  run "" picture.png
  check "$name FILE: exit 0, not $status: $err" is "$status" 0
  check "$name FILE: a PNG" has "$(head -c 4 picture.png)" PNG
  rm -f picture.png
done

name=12_depth_sort
program=$folder/$name
fails "12_depth_sort: a folder that is not there" "" missing/drawing.svg
fails "12_depth_sort: the name of no SVG" "" drawing.png
check "12_depth_sort: the name is in the message: $err" ends "$err" "must end in .svg, not: drawing.png"
run "" drawing.svg
check "12_depth_sort FILE: exit 0, not $status: $err" is "$status" 0
check "12_depth_sort FILE: an SVG of five parts" is "$(grep -c '^<path' drawing.svg)" 5
rm -f drawing.svg

programs=0
for program in "$folder"/[a-z]*; do
  [ -f "$program" ] && [ -x "$program" ] || continue
  name=$(basename "$program")
  programs=$((programs + 1))
  run "" --help
  help=$out
  run "" -h
  check "$name -h: exit 0" is "$status" 0
  check "$name -h is --help" is "$out" "$help"
  check "$name --help says what it is" begins "$help" "$name - "
  check "$name --help says how it is called" says_usage "$help" "$name"
done
for source in "$sources"/*.cpp; do  # no program is missing, none was forgotten
  check "$source is built" test -x "$folder/$(basename "$source" .cpp)"
done
check "as many programs as sources, not $programs" is $((steps + programs)) "$(find "$sources" -maxdepth 1 -name '*.cpp' | wc -l)"
conclude
