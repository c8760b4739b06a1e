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
# refused "what" "part of the message" "input" arguments...: fails, and says so.
refused() {
  local what=$1 part=$2
  shift 2
  fails "$what" "$@"
  check "$what: says '$part': $err" has "$err" "$part"
}
# answers "what" "output" "input" arguments...: exit 0, and that output, escapes as in printf %b.
answers() {
  local what=$1 expected=$2
  shift 2
  run "$@"
  check "$what: exit 0, not $status: $err" is "$status" 0
  check "$what: $out" is "$out" "$(printf '%b' "$expected")"
}
# helps WORD...: --help ends with 0, says nothing on standard error, and names every word.
helps() {
  local word
  run "" --help
  check "--help: exit 0" is "$status" 0
  check "--help: silent on standard error" is "$err" ""
  for word; do check "--help names $word" has "$out" "$word"; done
}
# The value of a line `name: value` of the output.
line() { sed -n "s/^$1: //p" .out; }
files() { find . ! -name .out ! -name .err \( -type f -o -type l \) | sort; }

# strange_models arguments...: the program reads models as others write them (a tetrahedron whose vertices have colours, one
# with letters that make no pair of texture coordinates, one beside the text of others), and says of broken ones what they
# are by their names: binary STL that is too short, text STL behind a comment, and what is no OFF, PLY or XML.
strange_models() {
  local at=('0 0 0' '1 0 0' '0 1 0' '0 0 1') model message
  {
    printf 'OFF\n4 4 0\n'
    printf '%s 255 0 0\n' "${at[@]}"
    printf '3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n'
  } >coloured.off
  {
    printf 'ply\nformat ascii 1.0\nelement vertex 4\n'
    printf 'property float %s\n' x y z s u t texture_v
    printf 'element face 4\nproperty list uchar int vertex_indices\nend_header\n'
    printf '%s 1 nan 3 nan\n' "${at[@]}"
    printf '3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n'
  } >letters.ply
  {
    printf '<body><o:note>1 &lt; 2 <![CDATA[<b>]]></o:note><points>'
    printf '<point x="%s" y="%s" z="%s"/>' 0 0 0 1 0 0 0 1 0 0 0 1
    printf '</points><faces>'
    printf '<face points="%s"/>' '0 2 1' '0 1 3' '1 2 3' '2 0 3'
    printf '</faces></body>'
  } >others.xml
  for model in coloured.off letters.ply others.xml; do
    run "" "$model" "$@"
    check "$model: exit 0, not $status: $err" is "$status" 0
  done
  { printf '%-80s\1\0\0\0' 'by hand'; printf '%-49s' 'a triangle has fifty bytes'; } >short.stl
  printf '// by hand\nsolid a\nendsolid a\n' >comment.stl
  printf 'Off\n0 0 0\n' >none.off
  printf '# by hand\nply\n' >none.ply
  printf 'by hand <body/>' >none.xml
  while IFS='|' read -r model message; do
    fails "$model" "" "$model" "$@"
    check "$model: $err" is "$err" "$name: $message"
  done <<'END'
short.stl|file is too short for the number of triangles that stands here: short.stl, byte 81
comment.stl|expected the word solid: comment.stl:1:1
none.off|file does not begin with the word OFF: none.off:1:1
none.ply|file does not begin with the word ply: none.ply:1:1
none.xml|text stands where only elements may stand: none.xml:1:1
END
}

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
