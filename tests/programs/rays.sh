#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The programs that draw scenes of their own by rays: pictures, threads, refusals.
# usage: rays.sh FOLDER-WITH-THE-PROGRAMS
if [ -z "${RAYS_OF:-}" ]; then
  for RAYS_OF in shadow glass cornell_box; do
    RAYS_OF=$RAYS_OF bash "$0" "$@" || exit 1
  done
  exit 0
fi
# shellcheck source=tests/support/programs.sh
. "$(dirname "$0")/../support/programs.sh" "$RAYS_OF" "$@"

run "" --help
check "help: exit 0" is "$status" 0
run "" -o one.ppm --size 48x36
check "a picture: exit 0, not $status: $err" is "$status" 0
check "its size" is "$(sed -n 2p one.ppm)" "48 36"
run "" -o two.ppm --size 48x36 --threads 3
check "on three threads: the same bytes" cmp -s one.ppm two.ppm
[ "$RAYS_OF" = cornell_box ] && option=--paths || option=--samples
run "" -o three.ppm --size 48x36 $option 1
check "other samples: another picture" is_not "$(cksum <one.ppm)" "$(cksum <three.ppm)"
fails "no picture" ""
fails "a name that no picture has" "" -o x.txt
fails "a word" "" -o x.ppm teapot
fails "an option" "" -o x.ppm --mirrors 3
for value in 0 70000 x ""; do fails "$option '$value'" "" -o x.ppm $option "$value"; done
for value in -1 65 x; do fails "--bounces '$value'" "" -o x.ppm --bounces "$value"; done
for value in 0 257 x; do fails "--threads '$value'" "" -o x.ppm --threads "$value"; done
conclude
