#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The contract of `studio`, seen from outside: a script of events, states and pictures, refusals, and its window.
# usage: studio.sh FOLDER-WITH-THE-PROGRAMS
# shellcheck source=tests/support/programs.sh
here=$(cd "$(dirname "$0")" && pwd)
. "$here/../support/programs.sh" studio "$@"
. "$here/../support/window.sh"

run "" --help
check "--help: exit 0" is "$status" 0
for word in load drop show shade opacity colour add move remove aim orbit project pyramid helper light picture save \
  restore --input --size --window; do
  check "--help names $word" has "$out" "$word"
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
  open_window 'irg studio' --input script.txt --size 640x240
  xdotool key 2
  check "key 2 shows edges" said '^show "cube" edges on$'
  xdotool key s key r key Right key b
  check "key s shades" said '^shade "cube" gouraud$'
  check "an arrow moves" said '^add "cube" before translate 0.25 0 0$'
  check "key b reorders" said '^move "cube" before 2 1$'
  xdotool mousemove --window "$id" 100 100 mousedown 1 mousemove --window "$id" 120 110 mouseup 1
  check "the mouse orbits the main view" said '^orbit main -'
  xdotool mousemove --window "$id" 500 100 click 4
  check "the wheel brings the outer view nearer" said '^orbit outer 0 0 0.9$'
  xdotool key F5 key F6
  check "F6 writes the picture" said '^picture studio.png$'
  xdotool key Delete
  check "Delete drops the body" said '^drop "cube" $'
  end_window
  # What the window printed is a script, and the pictures are the same.
  { cat script.txt; grep -v -E '^(window|pictures|events|body)' window.out | sed '/^picture/,$d; s/studio.xml/again.xml/'
    echo 'picture again.png'; } >printed.txt
  run '' --input printed.txt --size 640x240
  check "its lines as a script: exit 0, $err" is "$status" 0
  check "give the same picture" cmp -s studio.png again.png
  check "and the same state" cmp -s studio.xml again.xml
fi

conclude
