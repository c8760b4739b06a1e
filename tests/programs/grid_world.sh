#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The contract of `grid_world`, seen from outside: clicks, walks and turns, both tests against grid_visibility, refusals,
# and its window.
# shellcheck disable=SC2154 # status, out, err and program come from programs.sh
here=$(cd "$(dirname "$0")" && pwd)
. "$here/../support/programs.sh" grid_world "$@"
. "$here/../support/window.sh"
visibility=$(dirname "$program")/grid_visibility

run "" --help
for option in --script --size --window; do
  check "--help names $option" has "$out" "$option"
done

cells='5 4 2\n.....\n..#..\n.....\n#....\n.....\n..#..\n.....\n.....\n'
walls='wall 3 2 0 x+ wall\nwall 3 1 0 x+ wall\n'
printf "$cells$walls" >map.txt
seen_by() { printf "$1" | "$visibility" | sed -n 's/^seen: //p'; }
said_of() { printf '%s\n' "$out" | sed -n "s/^$1: //p"; }

run "" map.txt
check "no units: exit 0, not $status: $err" is "$status" 0
check "nothing is seen: $out" is "$out" $'units: 0\nseen: 0\ntest: 3'

# The middle of the picture shows the middle of the map: cell (2, 2), in front of the cubes.
run 'click 320 240\n' map.txt
check "a unit: $out" is "$(said_of units)" 1
check "sees what grid_visibility says" is "$(said_of seen)" "$(seen_by "$cells""2 2 0\n$walls")"
run 'click 320 240\ntest 2\n' map.txt
check "in its layer" is "$(said_of seen)" "$(seen_by "5 4 1\n.....\n..#..\n.....\n#....\n2 2 0\n$walls")"
check "test 2 is told: $out" is "$(said_of test)" 2
run 'click 320 240\ntest 2\ntest 3\n' map.txt
check "and back again" is "$(said_of seen)" "$(seen_by "$cells""2 2 0\n$walls")"

# On top of a full cell of the uppermost layer nothing is free; on a low one the cell above it is.
printf '1 1 1\n#\n' >cube.txt
run 'click 320 240\n' cube.txt
check "no room above the map: $out" has "$out" "refused: 1: no cell under the cursor is free"
printf '1 1 2\n#\n.\n' >low.txt
run 'click 320 240\nwalk 0 0\n' low.txt
check "a unit on a cube: $out" is "$(said_of units)" 1
check "which sees the cube it stands on: $out" is "$(said_of seen)" 2

# Pictures: what changes them, and what does not.
run 'picture a.png\nwalk 1 0\npicture b.png\nwalk -1 0\npicture c.png\nturn 90 10\npicture d.png\nturn -90 -10\npicture e.png\nturn 360 0\npicture f.ppm\n' map.txt --size 160x120
check "pictures: exit 0, not $status: $err" is "$status" 0
check "walking changes the picture" is_not "$(cksum <a.png)" "$(cksum <b.png)"
check "and back gives the same" cmp -s a.png c.png
check "turning changes it" is_not "$(cksum <a.png)" "$(cksum <d.png)"
check "and back gives the same" cmp -s a.png e.png
check "the size is that of --size" is "$(sed -n 2p f.ppm)" "160 120"
check "without units nothing is bright" is "$(pixels f.ppm | awk '$1 > 230 && $3 < 160' | wc -l)" 0
run 'click 80 60\npicture g.ppm\n' map.txt --size 160x120
check "with one something is" [ "$(pixels g.ppm | awk '$1 > 230 && $3 < 160' | wc -l)" -gt 100 ]
rm -f ./*.png ./*.ppm

# The thesis' three answers: the room of its reference has 31 cells that are seen, 2 of them in part, in the lowest layer
# by either test, in another by the test of the plane.
room='........\n...#....\n....#...\n.#......\n..#.....\n........\n'
open=$(printf '........\\n%.0s' 1 2 3 4 5 6)
printf "8 6 1\n${room}0 0\n" >room.txt
printf "8 6 2\n$open${room}0 0 1\n" >above.txt
run 'picture exact.ppm\nmethod thesis\npicture thesis.ppm\n' room.txt --size 160x120
check "thesis: $out" is "$out" $'units: 1\nseen: 31\ntest: 3\nin part: 2'
green() { pixels "$1" | awk '$2 > $1 + 8 && $2 > $3 + 8' | wc -l; }
check "what is seen in part is green: $(green thesis.ppm)" test "$(green thesis.ppm)" -gt 20
check "exactly nothing is seen in part" is "$(green exact.ppm)" 0
run 'method thesis\nmethod exact\npicture again.ppm\n' room.txt --size 160x120
check "and back again: $out" is "$out" $'units: 1\nseen: 31\ntest: 3'
check "the same picture" cmp -s exact.ppm again.ppm
run 'method thesis\ntest 2\n' room.txt
check "thesis, in the plane: $out" is "$out" $'units: 1\nseen: 31\ntest: 2\nin part: 2'
run 'method thesis\ntest 2\n' above.txt
check "thesis, in an upper layer: $out" is "$out" $'units: 1\nseen: 31\ntest: 2\nin part: 2'
run 'method thesis\n' above.txt
check "thesis, in space, from an upper layer: $out" has "$out" 'in part: 0'
check "as grid_visibility says: $out" is "$(said_of seen)" "$("$visibility" --method thesis <above.txt | sed -n 's/^seen: //p')"

# Walls of each kind, in every direction, have pictures of their own; what does not block is seen through.
for side in x y z; do
  : >sums.txt
  for kind in none wall half open-door closed-door laser; do
    { printf '3 3 2\n...\n...\n...\n...\n...\n...\n0 0\n1 1\n'; [ $kind = none ] || echo "wall 1 1 0 $side+ $kind"; } >wall.txt
    run "picture $kind.ppm\n" wall.txt --size 160x120
    check "$kind at $side+: $out" is "$(said_of seen)" "$("$visibility" <wall.txt | sed -n 's/^seen: //p')"
    cksum <$kind.ppm >>sums.txt
  done
  check "six pictures at $side+" is "$(sort -u sums.txt | wc -l)" 6
  red() { pixels "$1" | awk '$1 > 130 && $2 < 60' | wc -l; }
  check "beams at $side+ are red" test "$(red laser.ppm)" -gt "$(red none.ppm)"
done
rm -f ./*.png ./*.ppm

# Lines that cannot be.
run '# nothing\n\nclick 1\nclick 1 2 3\nclick x y\nclick 0 0\nclick 1e9 1\nclick -5 -5\nwalk nan 1\ntest 4\ntest 2.5\nfly\nmethod\nmethod exactly\npicture\npicture a.gif\n' map.txt
check "refusals: exit 0, not $status" is "$status" 0
check "each of them is told: $out" is "$(printf '%s\n' "$out" | grep -c '^refused: ')" 14
check "with its line" has "$out" "refused: 16: the picture's name must end in .png, .ppm or .svg: a.gif"
check "and the world is as it was" has "$out" $'units: 0\nseen: 0\ntest: 3'

# A script may begin with a byte order mark.
run '\xEF\xBB\xBFclick 320 240\r\n# nothing\r\nwalk 1 0\r\n' map.txt
check "behind a byte order mark: $out" is "$(said_of units)/$(said_of refused)" 1/

# What was read is not written over.
cp room.txt map.ppm
printf 'picture map.ppm\npicture ./script.ppm\npicture other.ppm\n' >script.ppm
run '' map.ppm --script script.ppm --size 16x12
check "the map and the script: exit 0, not $status: $err" is "$status" 0
check "the map is kept: $out" has "$out" "refused: 1: the map would be overwritten: map.ppm"
check "the script is kept: $out" has "$out" "refused: 2: the script would be overwritten: ./script.ppm"
check "the map is as it was" cmp -s map.ppm room.txt
check "another file is written" test -s other.ppm
rm -f map.ppm script.ppm other.ppm

fails "no map" ""
fails "a map that is not there" "" nosuch.txt
printf '2 1 1\n.x\n' >bad.txt
fails "a broken map" "" bad.txt
check "with its place: $err" has "$err" "bad.txt:2:2"
fails "two maps" "" map.txt map.txt
fails "no such option" "" map.txt --list
fails "a script that is not there" "" map.txt --script nosuch
fails "no size" "" map.txt --size 0x3
fails "a folder that is not there" 'picture a.png\npicture missing/a.png\n' map.txt
if [ -w /dev/full ]; then
  printf 'picture a.png\n' | "$program" map.txt >/dev/full 2>.err
  check "no room for what is printed: exit 2" is "$?" 2
  check "no room: no picture is left" is "$(find . -name '*.png')" ""
fi

if has_window; then
  open_window 'irg grid world' map.txt --size 640x480
  xdotool mousemove --window "$id" 320 240 click 1
  check "a click sets a unit down" said '^click 320 240$'
  xdotool key w key d key 2
  check "w walks" said '^walk 1 0$'
  check "d walks to the right" said '^walk 0 1$'
  check "2 chooses the test" said '^test 2$'
  xdotool key t key e
  check "t chooses the thesis" said '^method thesis$'
  check "e the exact method" said '^method exact$'
  xdotool mousemove --window "$id" 300 200 mousedown 3 mousemove --window "$id" 310 195 mouseup 3
  check "dragging turns" said '^turn '
  xdotool key F6
  check "F6 writes the picture" said '^picture grid_world.png$'
  end_window
  # What the window printed is a script, and the picture is the same.
  { sed '/^window/d; /^picture/,$d' window.out; echo 'picture again.png'; } >printed.txt
  run '' map.txt --script printed.txt --size 640x480
  check "its lines as a script: exit 0, $err" is "$status" 0
  check "give the same picture" cmp -s grid_world.png again.png
fi

conclude
