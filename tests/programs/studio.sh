#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The contract of `studio`, seen from outside: a script of events, states and pictures, refusals, and its window.
# usage: studio.sh FOLDER-WITH-THE-PROGRAMS
# shellcheck source=tests/support/programs.sh
here=$(cd "$(dirname "$0")" && pwd)
. "$here/../support/programs.sh" studio "$@"
. "$here/../support/window.sh"

helps load drop show shade opacity colour add change move remove aim orbit project pyramid helper lamp drop-lamp \
  ambient light picture save restore --input --size --window --replay
for key in Tab Delete "1 2 3 4" "arrows" Backspace F1 F2 F4 F5 F6 F7 Return Escape "drag in a view" "wheel in a view" \
  "press in a panel" "drop a file"; do
  check "--help tells of $key" has "$out" "
  $key"
done

cat >kocka.obj <<'END'
v 0 0 0
v 1 0 0
v 0 1 0
v 0 0 1
f 1 3 2
f 1 2 4
f 1 4 3
f 2 3 4
END
printf 'v 0 0 0\nv 1 0 0\nf 1 2 9\n' >broken.obj

# A state, saved, spoiled and restored, gives the same picture again.
script='load teapot\nload kocka.obj\nload kocka.obj # the second\nload torus ring\nshade teapot gouraud
colour teapot 200 120 60\nadd kocka before translate -2 0 1\nadd "kocka(2)" before scale 2 2 2
add "kocka(2)" before translate 1 0 2\nshow "kocka(2)" edges on\nshow "kocka(2)" points on\nopacity ring 0.5
add ring after rotate-z 20\nhelper main axes on\npicture a.png\nsave state.xml\n'
run "$script" --size 320x120
check "a script: exit 0, $err" is "$status" 0
check "what it did: $out" is "$out" $'pictures: 1\nevents: 15\nbody: teapot\nbody: kocka\nbody: kocka(2)\nbody: ring'
run 'restore state.xml\npicture b.png\nsave again.xml' --size 320x120
check "restored: exit 0, $err" is "$status" 0
check "the same picture" cmp -s a.png b.png
check "the same state" cmp -s state.xml again.xml
run 'load state.xml\n' --size 320x120
check "a state is a file of bodies: $out" has "$out" $'body: kocka(2)\nbody: ring'
run 'restore state.xml\nadd "kocka(2)" before rotate-y 40\nmove "kocka(2)" before 3 1\npicture c.png
move "kocka(2)" before 1 3\npicture d.png\nremove "kocka(2)" before 3\npicture e.png\n' --size 320x120
check "exchanged transformations give another picture" is_not "$(cksum <c.png)" "$(cksum <d.png)"
check "without the new one the first" cmp -s a.png e.png
: >.seen
for view in perspective orthographic isometric dimetric trimetric cavalier cabinet "cabinet 30" "oblique 60 0.8"; do
  run "restore state.xml\nproject main $view\npicture view.png main\n" --size 80x60
  check "$view: exit 0, $err" is "$status" 0
  check "$view: a picture of its own" is "$(grep -c -F "$(cksum <view.png)" .seen)" 0
  cksum <view.png >>.seen
done
for what in points edges backs; do
  run "restore state.xml\nshow * $what on\npicture view.png\n" --size 320x120
  check "$what: another picture" is_not "$(cksum <view.png)" "$(cksum <a.png)"
done

# What cannot be is said, and all is as before; the picture shows the sentence.
run "load kocka.obj\npicture f.png\nload broken.obj\npicture g.png\ndrop nobody\norbit main 0 0 0
aim main 1 1 1 1 1 1\nadd kocka before central 1 0 0 0 0 5 5\npicture kept.png main\nload none.obj\nrestore broken.obj
shade kocka flat\npicture h.png\n" --size 320x120
check "refusals: exit 2 on a transformation without a matrix" is "$status" 2
run "load kocka.obj\npicture f.png\nload broken.obj\npicture g.png\ndrop nobody\norbit main 0 0 0
aim main 1 1 1 1 1 1\nload none.obj\nrestore broken.obj\npicture view.gif\nshade kocka flat\npicture h.png\n" \
  --size 320x120
check "refusals: exit 0, $err" is "$status" 0
check "each is said: $out" is "$out" "refused: 3: face index is larger than the number of vertices: broken.obj:3:7
refused: 5: no body has this name
refused: 6: eye and target are one point, or too far apart
refused: 7: eye and target are one point, or too far apart
refused: 8: file does not exist: none.obj
refused: 9: text stands where only elements may stand: broken.obj:1:1
refused: 10: the picture's name must end in .png, .ppm or .svg: view.gif
pictures: 3
events: 2
body: kocka"
check "the sentence is in the picture" is_not "$(cksum <f.png)" "$(cksum <g.png)"
check "and gone in the next" cmp -s f.png h.png

# Several lamps.
run 'load sphere\npicture one.png main\nlamp 2 6 0 2 1 1 0.2 0.1\npicture two.png main\nlamp 3 0 0 9 0 0 0 1
save lamps.xml\ndrop-lamp 3\npicture again.png main\ndrop-lamp 2\npicture first.png main\nrestore lamps.xml
drop-lamp 2\ndrop-lamp 2\nlamp 3 1 1 1 1\ndrop-lamp 2\nlamp 1 1 1 1 1 2 0 0\nambient 2\nambient 1\npicture all.png main
drop-lamp 1\npicture none.png main\n' --size 60x60
check "lamps: exit 0, $err" is "$status" 0
check "a second lamp shows" is_not "$(cksum <one.png)" "$(cksum <two.png)"
check "a third one comes and goes" cmp -s two.png again.png
check "and so does the second" cmp -s one.png first.png
check "of light from everywhere alone no lamp matters" cmp -s all.png none.png
check "lamps that are none: $out" is "$(sed -n '/^refused/p' .out)" "refused: 14: no lamp has this number
refused: 15: no lamp has this number
refused: 16: part of a lamp's light is not from 0 to 1
refused: 17: ambient light is not from 0 to 1"
rm -f ./*.png

# Keys and the mouse without a window. desk "what" "expected lines" moves...: what they say with a cube in the studio.
printf 'load cube\n' >cube.txt
desk() {
  local what=$1 expected=$2
  shift 2
  printf '%s\n' "$@" >moves.txt
  run "" --input cube.txt --replay moves.txt --size 1280x720
  check "$what: exit 0, $err" is "$status" 0
  check "$what: $out" is "$out" "$expected"
}
desk "Tab, load and drop" $'load teapot\ndrop "teapot"\ndrop "cube"' 'press 120 15' 'key delete delete delete tab 1 [ u'
desk "a file that is dropped" $'load "kocka.obj"\nshow "kocka" points on' 'drop kocka.obj' 'key 1'
desk "a file that is not there" 'load "none.obj"  # refused: file does not exist: none.obj' 'drop none.obj'
desk "parts" $'show "cube" points on\nshow "cube" edges on\nshow "cube" faces off\nshow "cube" backs on' 'key 1 2 3 4'
desk "parts by the mouse" $'show "cube" points on\nshow "cube" backs on' 'press 100 546' 'press 300 546'
desk "looks" $'shade "cube" gouraud\nopacity "cube" 0.5\nopacity "cube" 1\ncolour "cube" 205 128 70' 'key s t t c'
desk "looks by the mouse" $'shade "cube" phong\nopacity "cube" 0.9\nopacity "cube" 1\nopacity "cube" 1
colour "cube" 240 255 255' 'press 300 564' 'wheel 100 582 -1' 'wheel 100 582 1' 'wheel 100 582 1' 'wheel 220 582 -1'
desk "moves" $'add "cube" before translate -0.25 0 0\nadd "cube" before translate 0.25 0 0
add "cube" before translate 0 0.25 0\nadd "cube" before translate 0 -0.25 0\nadd "cube" before translate 0 0 -0.25
add "cube" after translate 0 0 0.25' 'key left right up down pageup w pagedown'
desk "turns and scales" $'add "cube" before rotate-x 15\nadd "cube" before rotate-y 15\nadd "cube" before rotate-z 15
add "cube" before rotate-x -15\nadd "cube" before rotate-y -15\nadd "cube" before rotate-z -15
add "cube" before scale 1.25 1.25 1.25\nadd "cube" before scale 0.8 0.8 0.8\nadd "cube" after rotate-z 15' \
  'key x y z shift-x shift-y shift-z + - a'
desk "lists" $'add "cube" before rotate-x 15\nadd "cube" before rotate-y 15\nadd "cube" before rotate-z 15
move "cube" before 3 2\nmove "cube" before 2 3\nmove "cube" before 2 1\nremove "cube" before 1\nremove "cube" before 1
remove "cube" before 1\nremove "cube" before 1  # refused: list has no transformation of this number' \
  'key x y z u d [ b backspace backspace backspace backspace'
desk "both lists" $'add "cube" before rotate-x 15\nadd "cube" after rotate-z 15\nadd "cube" after rotate-z 15
remove "cube" before 1\nremove "cube" after 1\nadd "cube" after rotate-x 15' 'key x a a [ [ backspace' 'key ] backspace x'
desk "adding by the mouse" $'add "cube" after rotate-x 15\nadd "cube" after translate 0 0 -0.25
add "cube" after scale 1.25 1.25 1.25\nadd "cube" after mirror 1 0 0 0' \
  'press 300 51' 'press 100 69' 'press 210 87' 'press 320 105' 'press 150 123'
for kind in "70 rotate 1 1 1 30" "110 shear 0.5 0 0 0 0 0" "150 mirror 1 0 0 0" "200 parallel 0 1 0 1 1 -2 1" \
  "260 central 0 1 0 1 0 10 0" "310 matrix 1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1"; do
  desk "adding ${kind#* }" "add \"cube\" before ${kind#* }" "press ${kind%% *} 123"
done
desk "a list by the mouse" $'add "cube" before rotate-x 15\nadd "cube" before translate -0.25 0 0
change "cube" before 1 rotate-x 20\nmove "cube" before 1 2\nmove "cube" before 2 1\nremove "cube" before 2' \
  'key x left' 'wheel 120 159 1' 'press 308 159' 'press 288 177' 'press 328 177'
desk "a number as a line" $'add "cube" before rotate-x 15\nchange "cube" before 1 rotate-x 19' 'key x' 'press 120 159' \
  'key backspace' 'type 9' 'key return'
desk "the view's keys" $'orbit main -5 0\norbit main 5 0\norbit main 0 5\norbit outer 0 -5\norbit outer 0 0 0.9
orbit outer 0 0 1.1\nproject outer orthographic\nhelper outer axes off\nhelper outer pyramid off
lamp 2 19.9999999999 14 -4 1 0.5 0.5 0.5\ndrop-lamp 2' 'key j l i v k' 'key n m p h' 'key return' \
  'type lamp 2 19.9999999999 14 -4 1 0.5 0.5 0.5' 'key return shift-g'
desk "a lamp at the eye" 'lamp 2 4 3 6 1 0.5 0.5 0.5' 'key g'
desk "views by the mouse" $'orbit main -20 10\norbit outer 0 0 0.9\norbit outer 5 0\norbit main 0 0 1.1' 'press 500 300' \
  'drag 20 10' 'wheel 1000 300 1' 'press 1000 300' 'drag -5 0' 'wheel 500 300 -1'
desk "from a panel nothing is dragged" "" 'press 200 250' 'drag 20 10'
desk "eye, target and up" $'aim main 4.25 3 6 0 0 0 0 1 0\naim main 4.25 3 6 0 -0.25 0 0 1 0
aim main 4.25 3 6 0 -0.25 0 0 1 0.25\naim outer 20.25 14 -4 0 0 0 0 1 0' 'wheel 110 312 1' 'wheel 200 330 -1' \
  'wheel 300 348 1' 'press 290 294' 'wheel 110 312 1'
desk "projections" $'project main orthographic\nproject main oblique 45 0.5\nproject main cavalier\nproject main cabinet
project main isometric\nproject main dimetric\nproject main trimetric\nproject main perspective' 'press 200 420' \
  'press 300 420' 'press 50 438' 'press 110 438' 'press 170 438' 'press 230 438' 'press 300 438' \
  'press 120 420'
desk "an oblique one's numbers" $'project main cavalier\nproject main oblique 50 1\nproject main oblique 50 0.9' \
  'press 50 438' 'wheel 160 456 1' 'wheel 280 456 -1'
desk "the pyramid" $'pyramid main 2.5 2 1.5 1 15\npyramid main 2.5 2 1.5 1 12' 'wheel 100 492 1' 'wheel 320 492 -1'
desk "helpers" $'helper main axes on\nhelper main camera-axes on\nhelper main camera on\nhelper main pyramid on
helper main axes off' 'press 95 510' 'press 160 510' 'press 240 510' 'press 300 510' 'press 95 510'
desk "light" $'ambient 0.3\nlamp 1 -4.5 10 8 1 1 1 1\nlamp 1 -4.5 10 8 0 1 1 1\nlamp 1 -4.5 10 8 0 1 1 0.9\ndrop-lamp 1
lamp 1 5 10 8 1 0.5 0.5 0.5' 'wheel 180 618 1' 'wheel 60 654 1' 'wheel 170 654 1' 'wheel 290 654 -1' 'press 325 654' \
  'press 245 618'
desk "by keys alone" $'load sphere\nproject main oblique 45 0.5' 'key f2 up right right' 'key return f2 f2 f2 f2' \
  'key down down down down right right return'
desk "a number by keys" $'aim main 4 2.75 6 0 0 0 0 1 0\naim main 7 2.75 6 0 0 0 0 1 0' 'key f2 f2 down -' 'key return home' \
  'key right right right right right right right right right delete' 'type 7' 'key return'
desk "any line" $'colour * 1 2 3\nshw  # refused: line begins with a word that is not known
show * edges on' 'key return' 'type colour * 1 2 3' 'key return return' 'type shw' 'key return left left' 'type X' \
  'key backspace right' 'type o' 'key end home right right right right' 'type  * edges on' 'key return'
desk "files" $'save studio.xml\npicture studio.png\nadd "cube" before rotate-x 15\nrestore studio.xml\nsave studio.xml
restore studio.xml\npicture studio.png' 'key f5 f6 x f8' 'press 110 600' 'press 175 600' 'press 245 600'
desk "Escape ends" 'show "cube" points on' 'key 1 escape 2' 'key 3'
cp studio.png small.png
desk "the window's pictures" 'show "cube" edges on' 'key f7 2'
mv studio_window.png panels.png
desk "without panels" "" 'key f4 f7'
mv studio_window.png plain.png
desk "with keys" "" 'key f1 f7'
mv studio_window.png keys.png
desk "with a cell for keys" "" 'key f2 f7'
for other in plain keys studio_window; do
  check "$other: another picture" is_not "$(cksum <panels.png)" "$(cksum <$other.png)"
done
for size in 1x1 20x700 687x30 3000x400; do
  printf 'key f2 f2 down f7\npress 5 5\nwheel 5 5 1\nkey f1 f4 f7' >moves.txt
  run "" --input cube.txt --replay moves.txt --size $size
  check "a window of $size: exit 0, $err" is "$status" 0
done
printf 'key 1\n\npress 1\n' >moves.txt
fails "a move that is none" "" --replay moves.txt --input none.txt
run "" --replay moves.txt
check "a move that is none: exit 2" is "$status" 2
check "where: $err" is "$err" "studio: no key and no move of the mouse: moves.txt:3:1"
for bad in 'key' 'press 1 x' 'press 1 2 3' 'drag 1' 'wheel 1 2 0' 'drop' 'wheel 1 2 99999999999' 'pres 1 2'; do
  echo "$bad" >moves.txt
  run "" --replay moves.txt
  check "'$bad': exit 2" is "$status" 2
done
fails "a replay that is not there" "" --replay none.txt
rm -f ./*.png studio.xml

fails "a word that is none" 'load cube\nshw cube\n'
check "where: $err" ends "$err" ": stdin:2:1"
fails "an unknown part" 'show cube skin on'
check "where: $err" ends "$err" ": stdin:1:11"
fails "an empty name of the script" "" --input ""
fails "a number missing" 'pyramid main 1 2 3 4'
fails "a folder that is not there" 'load cube\nsave kept.xml\npicture none/a.png\n'
fails "a file that is not there" '' --input none.txt
fails "an unknown option" '' --colour
fails "a size that is none" '' --size 0x5
run '' --size 20x10
check "no events: exit 0" is "$status" 0
check "no events: $out" is "$out" $'pictures: 0\nevents: 0'
printf 'load cube\npicture i.png\n' >script.txt
run '' --input script.txt --size 20x10
check "a script from a file: $out" has "$out" "pictures: 1"

# The window: real keys and a real mouse in a screen of memory, where there are such things.
if has_window; then
  open_window 'irg studio' --input script.txt --size 1000x700
  xdotool key 2
  check "key 2 shows edges" said '^show "cube" edges on$'
  xdotool key s key r key Right key b
  check "key s shades" said '^shade "cube" gouraud$'
  check "an arrow moves" said '^add "cube" before translate 0.25 0 0$'
  check "key b reorders" said '^move "cube" before 2 1$'
  xdotool key shift+x key plus key KP_Subtract key bracketleft key d
  check "Shift turns back" said '^add "cube" before rotate-x -15$'
  check "plus makes larger" said '^add "cube" before scale 1.25 1.25 1.25$'
  check "minus of the key pad makes smaller" said '^add "cube" before scale 0.8 0.8 0.8$'
  check "the chosen one goes down" said '^move "cube" before 4 5$'
  xdotool mousemove --window "$id" 500 100 mousedown 1 mousemove --window "$id" 520 110 mouseup 1
  check "the mouse orbits the main view" said '^orbit main -'
  xdotool mousemove --window "$id" 500 100 mousedown 3 mousemove --window "$id" 520 110 mouseup 3
  check "its right button goes sideways" said '^aim main '
  xdotool mousemove --window "$id" 900 100 click 4
  check "the wheel brings the outer view nearer" said '^orbit outer 0 0 0.9$'
  xdotool mousemove --window "$id" 180 15 click 1
  check "the panel loads" said '^load cube$'
  xdotool mousemove --window "$id" 100 574 click 5
  check "the wheel changes a number of a panel" said '^opacity "cube(2)" 0.9$'
  xdotool key F2 key Right key Return key Down key minus
  check "keys go to a panel and change its number" said '^aim outer '
  xdotool key F2 key Return
  xdotool type 'lamp 2 9 9 9 1 1 0 0'
  xdotool key Return
  check "a line that is typed" said '^lamp 2 9 9 9 1 1 0 0$'
  xdotool key F5 key F6
  check "F6 writes the picture" said '^picture studio.png$'
  xdotool key Delete
  check "Delete drops the body" said '^drop "cube'
  end_window
  # What the window printed is a script, and the pictures are the same.
  { cat script.txt; grep -v -E '^(window|pictures|events|body)' window.out | sed '/^picture/,$d; s/studio.xml/again.xml/'
    echo 'picture again.png'; } >printed.txt
  run '' --input printed.txt --size 1000x700
  check "its lines as a script: exit 0, $err" is "$status" 0
  check "give the same picture" cmp -s studio.png again.png
  check "and the same state" cmp -s studio.xml again.xml
fi

conclude
