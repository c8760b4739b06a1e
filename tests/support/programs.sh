# shellcheck shell=bash
# SPDX-License-Identifier: MIT
# What the scripts in tests/programs share. A script sources it with the name of its program and its own arguments:
#   . "$(dirname "$0")/../support/programs.sh" NAME "$@"
# From then on it stands in an empty folder that is removed at its end, and `$program` is the program's full path.
set -u
export LC_ALL=C
name=$1
if [ ! -x "${2:-}/$name" ] || [ -z "${2:-}" ]; then
  echo "usage: $0 FOLDER (that holds the program $name)"
  exit 1
fi
program=$(cd "$2" && pwd)/$name
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
passed=0 failed=0

check() { # check "what" condition...
  local what=$1
  shift
  if "$@"; then passed=$((passed + 1)); else failed=$((failed + 1)); echo "failed: $what"; fi
}
has() { case $1 in *"$2"*) true ;; *) false ;; esac; }
begins() { case $1 in "$2"*) true ;; *) false ;; esac; }
ends() { case $1 in *"$2") true ;; *) false ;; esac; }
is() { [ "$1" = "$2" ]; }
is_not() { [ "$1" != "$2" ]; }

# run "input" arguments...: the program with that standard input, escapes as in printf %b; leaves status, out and err,
# and the files .out and .err.
# shellcheck disable=SC2034 # out is read by the scripts
run() {
  local input=$1
  shift
  printf '%b' "$input" | timeout 120 "$program" "$@" >.out 2>.err
  status=$?
  out=$(cat .out)
  err=$(cat .err)
}

# fails "what" "input" arguments...: exit 2, one line `NAME: ...`, nothing on standard output, and no file that was not
# there before.
fails() {
  local what=$1 before after
  shift
  before=$(files)
  run "$@"
  after=$(files)
  check "$what: exit 2, not $status" is "$status" 2
  check "$what: one line on standard error, not: $err" is "$(wc -l <.err)" 1
  check "$what: begins with the program's name: $err" begins "$err" "$name: "
  check "$what: standard output is empty" is "$(wc -c <.out)" 0
  check "$what: leaves no file" is "$before" "$after"
}
files() { find . ! -name .out ! -name .err \( -type f -o -type l \) | sort; }

# The pixels of a PPM picture: red, green and blue, one pixel on a line, or as many as the second argument says.
pixels() { tail -c +$((1 + $(head -n 3 "$1" | wc -c))) "$1" | od -An -v -w$((3 * ${2:-1})) -tu1; }
# count FILE red green blue: how many pixels have that colour.
count() { pixels "$1" | grep -c "^ *$2 *$3 *$4\$"; }

# pictures_of_all_sizes "input" arguments...: of one pixel, of many, and a strip.
pictures_of_all_sizes() {
  local input=$1 size
  shift
  for size in 1x1 640x480 3x700; do
    run "$input" "$@" -o p.ppm --size $size
    check "a picture of ${input:0:30} in $size: $err" is "$status" 0
    check "it has that size" is "$(sed -n 2p p.ppm)" "${size/x/ }"
  done
}

# no_room "input" arguments...: exit 2 and one line where standard output is full, with a picture or without, and none
# left.
no_room() {
  local input=$1
  shift
  [ -w /dev/full ] || return 0
  printf '%s' "$input" | "$program" "$@" >/dev/full 2>.err
  check "a full disk: exit 2" is "$?" 2
  check "a full disk: says so" is "$(cat .err)" "$name: standard output cannot be written"
  printf '%s' "$input" | "$program" "$@" -o full.png >/dev/full 2>.err
  check "a full disk: exit 2 with a picture" is "$?" 2
  check "a full disk: leaves no picture" test ! -e full.png
}

# The last line of a script: its result.
conclude() {
  echo "$passed passed, $failed failed"
  [ "$failed" = 0 ]
}
