#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The contract of `render`, seen from outside: options, refusals, files left behind, hashes.
# usage: render.sh FOLDER-WITH-THE-PROGRAMS
# shellcheck disable=SC2086,SC2207,SC2258 # $small and some options are several words, and ,,, is a value
# shellcheck source=tests/support/programs.sh
. "$(dirname "$0")/../support/programs.sh" render "$@"
number() { sed -n "s/.*\"$1\": \([0-9][0-9.]*\).*/\1/p" "$2"; }
hash_in() { sed -n 's/^  "hash": "\([0-9a-f]\{16\}\)"$/\1/p' "$1"; }

# refuses "what" "part of the message" arguments...
refuses() {
  local what=$1 part=$2
  shift 2
  fails "$what" "" "$@"
  check "$what: says '$part': $err" has "$err" "$part"
  check "$what: no full stop or trace" is "${err%.}" "$err"
}

# drawn "what" arguments...: the picture p.ppm and s.json come out, silently but for a hint beside an empty picture.
drawn() {
  local what=$1
  shift
  rm -f p.ppm s.json
  run "" "$@" -o p.ppm --stats s.json
  check "$what: exit 0, not $status: $err" is "$status" 0
  check "$what: silent" is "$(wc -c <.out)" 0
  if grep -q '"pixels_drawn": 0,' s.json; then
    check "$what: the hint alone: $err" begins "$err" "render: the picture is empty"
    check "$what: the hint is a line" is "$(wc -l <.err)" 1
  else
    check "$what: silent on standard error: $err" is "$err" ""
  fi
  check "$what: a picture" test -s p.ppm
  check "$what: a hash" is_not "$(hash_in s.json)" ""
}

# FNV-1a of width and height, then R, G, B and opacity 255 of each pixel of a PPM picture.
hash_of_ppm() {
  local -a words
  local width height h=$((0xcbf29ce484222325)) i p=1099511628211
  read -r width height < <(sed -n 2p "$1" | tr -d '\r')
  local header=$(($(printf 'P6\n%s %s\n255\n' "$width" "$height" | wc -c)))
  for i in "$width" "$height"; do
    for shift in 0 8 16 24; do h=$(((h ^ (i >> shift & 255)) * p)); done
  done
  words=($(tail -c +$((header + 1)) "$1" | od -An -v -tu1))
  is "${#words[@]}" $((width * height * 3)) || return 1
  for ((i = 0; i < ${#words[@]}; i += 3)); do
    h=$(((h ^ words[i]) * p))
    h=$(((h ^ words[i + 1]) * p))
    h=$(((h ^ words[i + 2]) * p))
    h=$(((h ^ 255) * p))
  done
  printf '%016x' "$h"
}

small="--size 48x36"

# ---- models
cat >square.obj <<'END'
v -1 -1 0
v 1 -1 0
v 1 1 0
v -1 1 0
f 1 2 3 4
END
printf 'OFF\n4 1 0\n-1 -1 0\n1 -1 0\n1 1 0\n-1 1 0\n4 0 1 2 3\n' >square.off
printf 'ply\nformat ascii 1.0\nelement vertex 4\nproperty int x\nproperty int y\nproperty int z\nelement face 1\n%s\n%s\n%s\n' \
  'property list uchar int vertex_indices' end_header '-1 -1 0 1 -1 0 1 1 0 -1 1 0 4 0 1 2 3' >square_in_any.name
{
  printf 'solid\n'
  for corners in '-1 -1 0,1 -1 0,1 1 0' '-1 -1 0,1 1 0,-1 1 0'; do
    printf 'facet normal 0 0 1 outer loop\n'
    printf 'vertex %s\n' "${corners%%,*}" "$(cut -d, -f2 <<<"$corners")" "${corners##*,}"
    printf 'endloop endfacet\n'
  done
  printf 'endsolid\n'
} >square.stl
printf 'ply\nformat binary_big_endian 1.0\nelement vertex 1\nproperty int x\nproperty int y\nproperty int z\nend_header\n1234' \
  >cut.ply
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\n' >points.obj
: >empty.obj
printf 'v 0 0 0\nv 1 0 0\nv nan 0 0\nf 1 2 3\n' >nan.obj
printf 'v 0 0 0\nv 1 0 0\nv inf 0 0\nf 1 2 3\n' >inf.obj
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n' >range.obj
printf 'v 0 0 0\nv 0 0 0\nv 0 0 0\nf 1 2 3\n' >dot.obj
printf 'v 1e200 0 0\nv -1e200 0 0\nv 0 1e200 0\nf 1 2 3\n' >huge.obj
mkdir folder

# ---- help and defaults
helps MODEL -o --stats --size --eye --target --up --fov --project --hidden --style --edges --light --cull --skip --threads \
  teapot cube sphere torus 1280x720 gouraud zbuffer perspective orthographic isometric dimetric trimetric oblique
run "" cube --help
check "--help after a model: exit 0" is "$status" 0

run "" cube -o default.ppm --stats default.json
check "defaults: exit 0: $err" is "$status" 0
check "defaults: 1280 x 720" is "$(sed -n 2p default.ppm)" "1280 720"
run "" cube -o same.ppm --stats same.json --size 1280x720 --up 0,1,0 --fov 40 --project perspective --hidden zbuffer \
  --style gouraud --cull back --skip on --threads 1
check "the defaults, spelled out, are the defaults" is "$(hash_in same.json)" "$(hash_in default.json)"
check "the same bytes" cmp -s default.ppm same.ppm

for model in teapot cube sphere torus square.obj; do drawn "$model" $model $small; done
run "" cube $small -o picture.png
check "a .png picture: exit 0" is "$status" 0
check "PNG begins as it must" is "$(head -c 8 picture.png | od -An -tx1 | tr -d ' \n')" 89504e470d0a1a0a

# ---- statistics
drawn "statistics" teapot $small
for key in triangles frustum backface small occluded pixels_tested pixels_shaded pixels_drawn depth_ties; do
  check "statistics have a number for $key" is "$(grep -c "\"$key\": [0-9]" s.json)" 1
done
for stage in load draw write; do check "milliseconds of $stage" is_not "$(number $stage s.json)" ""; done
check "skipped is an object" has "$(cat s.json)" '"skipped": {"frustum": '
check "ms is an object" has "$(cat s.json)" '"ms": {"'
check "braces match" is "$(tr -cd '{' <s.json | wc -c)" "$(tr -cd '}' <s.json | wc -c)"
check "one object" is "$(head -c 1 s.json)$(tail -n 1 s.json)" "{}"
check "no comma before a brace" is "$(tr -d ' \n' <s.json | grep -c ',}')" 0
check "an even number of quotes" is $(($(tr -cd '"' <s.json | wc -c) % 2)) 0
check "as many pixels drawn as are not background" is "$(number pixels_drawn s.json)" \
  $((48 * 36 - $(count p.ppm 250 249 246)))
check "no more shaded than tested" test "$(number pixels_shaded s.json)" -le "$(number pixels_tested s.json)"
check "no more drawn than shaded" test "$(number pixels_drawn s.json)" -le "$(number pixels_shaded s.json)"
drawn "a cube's statistics" cube $small
check "a cube has 12 triangles" is "$(number triangles s.json)" 12
check "6 of them face away" is "$(number backface s.json)" 6
drawn "a cube's statistics without culling" cube $small --cull none
check "none of them is left out" is "$(number backface s.json)" 0

# ---- the classical methods draw the z-buffer's picture
for style in gouraud flat phong; do
  drawn "$style zbuffer" teapot $small --style $style --cull none
  hash=$(hash_in s.json)
  for hidden in painter warnock bsp raycast raytrace; do
    drawn "$style $hidden" teapot $small --style $style --cull none --hidden $hidden --threads 2
    check "$style $hidden: the z-buffer's picture" is "$(hash_in s.json)" "$hash"
    [ $style = flat ] || continue
    drawn "$style $hidden without skips" teapot $small --style $style --cull none --hidden $hidden --skip off
    check "$style $hidden without skips: the z-buffer's picture" is "$(hash_in s.json)" "$hash"
  done
done
drawn "wire zbuffer" teapot $small --style wire
hash=$(hash_in s.json)
drawn "wire painter" teapot $small --style wire --hidden painter
check "edges hide nothing, whatever the method" is "$(hash_in s.json)" "$hash"

# ---- what rays add
drawn "phong by rays" teapot $small --style phong --hidden raytrace
plain=$(hash_in s.json)
for option in "--shadows on" "--mirror 0.5" "--samples 2"; do
  drawn "$option" teapot $small --hidden raytrace $option
  hash=$(hash_in s.json)
  check "$option: another picture" test "$hash" != "$plain"
  drawn "$option on 3 threads" teapot $small --hidden raytrace $option --threads 3
  check "$option on 3 threads: the same hash" is "$(hash_in s.json)" "$hash"
  refuses "$option without rays" "--hidden raytrace" cube -o x.png $option
  refuses "$option of edges" "style of faces" cube -o x.png --hidden raytrace --style wire $option
done
for value in -1 1.5 nan x ""; do refuses "--mirror '$value'" "--mirror" cube -o x.png --hidden raytrace --mirror "$value"; done
for value in 0 17 1.5 x ""; do refuses "--samples '$value'" "--samples" cube -o x.png --hidden raytrace --samples "$value"; done

# ---- hashes
for style in gouraud wire hidden-line flat phong; do
  for hidden in zbuffer none; do
    drawn "$style $hidden" teapot $small --style $style --hidden $hidden
    hash=$(hash_in s.json)
    check "$style $hidden: the hash is that of the picture" is "$(hash_of_ppm p.ppm)" "$hash"
    cp p.ppm first.ppm
    for threads in 2 3 16; do
      drawn "$style $hidden on $threads threads" teapot $small --style $style --hidden $hidden --threads $threads
      check "$style $hidden on $threads threads: the same hash" is "$(hash_in s.json)" "$hash"
      check "$style $hidden on $threads threads: the same bytes" cmp -s p.ppm first.ppm
    done
    for cull in back none; do
      drawn "$style $hidden $cull" teapot $small --style $style --hidden $hidden --cull $cull
      hash=$(hash_in s.json)
      tested=$(number pixels_tested s.json)
      drawn "$style $hidden $cull without skips" teapot $small --style $style --hidden $hidden --cull $cull --skip off --threads 2
      check "$style $hidden $cull without skips: the same hash" is "$(hash_in s.json)" "$hash"
      check "$style $hidden $cull without skips: the same pixels tested" is "$(number pixels_tested s.json)" "$tested"
      for key in frustum small occluded; do
        check "$style $hidden $cull without skips: no $key" is "$(number $key s.json)" 0
      done
      if [ $cull = none ]; then
        check "$style $hidden without culling: no backface" is "$(number backface s.json)" 0
      else
        check "$style $hidden with culling: backface" test "$(number backface s.json)" -gt 0
      fi
    done
  done
done

# ---- what is beyond the picture is passed over and counted, to the same bytes
# The last views are of a square, a side of which is the given pixels to the left of the picture.
near_by() { # model view...: with edges and as hidden lines, skips on and off
  for style in wire hidden-line "hidden-line --edges all --cull none" "hidden-line --edges all --hidden-edges dashed" \
    "hidden-line --edges all --hidden none"; do
    drawn "$* $style" "$@" $small --style $style
    cp p.ppm first.ppm
    beyond=$(number frustum s.json)
    shaded=$(number pixels_shaded s.json)
    drawn "$* $style without skips" "$@" $small --style $style --skip off
    check "$* $style without skips: the same bytes" cmp -s p.ppm first.ppm
    check "$* $style without skips: as many pixels" is "$(number pixels_shaded s.json)" "$shaded"
    check "$* $style without skips: nothing counted" is "$(number frustum s.json)" 0
    check "$* $style: more than $least are beyond the picture: $beyond" test "$beyond" -gt "$least"
    [ "$style" = wire ] && continue
    for skip in on off; do run "" "$@" $small --style $style --skip $skip -o $skip.svg; done
    check "$* $style without skips: the same lines" cmp -s on.svg off.svg
  done
}
least=5000
near_by teapot --eye 3,2,4 --target 0,1,0 --fov 5
near_by teapot --eye 6,3,5 --target 1,1,0 --fov 3
near_by teapot --eye 0.5,0.6,0.9 --target 0,0.5,0
least=-1
near_by teapot --eye 4,3,6 --target 0.4,0.8,0 --fov 22
near_by sphere --project orthographic --fov 20
for beside in 0.001 0.0015 0.5 1 2.5; do
  x=$(awk "BEGIN { printf \"%.9f\", 1 + (24 + $beside) * 9 * 0.17632698 / 18 }")
  near_by square.obj --eye $x,0,9 --target $x,0,0 --fov 20
done

# ---- hidden lines as lines: a cube seen from beside a corner has twelve edges, nine of which are seen
lines_of() { grep -c '^<line ' "$1"; }
run "" cube $small --style hidden-line -o lines.svg
check "an .svg of hidden lines: exit 0: $err" is "$status" 0
check "nine lines" is "$(grep -c '^<line x1="[0-9.]*" y1="[0-9.]*" x2="[0-9.]*" y2="[0-9.]*"/>$' lines.svg)" 9
check "no pixels" is "$(grep -c '<rect' lines.svg)" 1
run "" cube $small --style hidden-line --hidden none --cull none -o lines.svg
check "nothing hidden: all edges" is "$(lines_of lines.svg)" 12
run "" square.obj $small --style hidden-line --cull none --eye 0.5,0.5,9 -o lines.svg
check "a polygon has no diagonals" is "$(lines_of lines.svg)" 4

# ---- which edges: sharp ones, those of the outline, or all, the diagonals of faces that triangles make up among them
lines_with() { # arguments...: how many lines are drawn
  run "" "$@" $small --style hidden-line -o edges.svg
  check "$*: exit 0: $err" is "$status" 0
  edges=$(lines_of edges.svg)
}
lines_with cube --edges sharp
check "a cube's sharp edges: $edges" is "$edges" 9
lines_with cube --edges outline
check "a cube's outline: $edges" is "$edges" 6
lines_with cube --edges all
check "a cube's edges with the diagonals of three faces: $edges" is "$edges" 12
lines_with cube --edges all --hidden none --cull none
check "with those of six: $edges" is "$edges" 18
lines_with cube --crease 100
check "nothing is sharper than 100 degrees: the outline: $edges" is "$edges" 6
# A cube whose triangles share no vertex, with one that two equal corners leave without area.
{
  printf 'v %s\n' "0 0 0" "0 0 1" "1 0 0" "1 0 1" "0 1 0" "0 1 1" "1 1 0" "1 1 1" >corners.txt
  n=0
  for face in "1 3 4" "1 4 2" "3 7 8" "3 8 4" "7 5 6" "7 6 8" "5 1 2" "5 2 6" "1 5 7" "1 7 3" "2 4 8" "2 8 6" "1 1 3"; do
    for v in $face; do sed -n "${v}p" corners.txt; done
    echo "f $((n + 1)) $((n + 2)) $((n + 3))"
    n=$((n + 3))
  done
} >soup.obj
lines_with soup.obj
check "a cube of single triangles: $edges" is "$edges" 9
lines_with soup.obj --edges all
check "a cube of single triangles, with diagonals: $edges" is "$edges" 12
run "" soup.obj $small --style hidden-line -o p.ppm --stats s.json
check "all its triangles are counted" is "$(number triangles s.json)/$(number backface s.json)" 13/7
# A roof of two triangles that meet at 20 degrees, with a wide one beside them.
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 -0.9397 0.3420\nf 1 2 3\nf 1 4 2\n' >roof.obj
for want in "4 " "5 --crease_10" "4 --crease_25" "5 --edges_all" "4 --edges_outline_--crease_10"; do
  options=${want#* }
  lines_with roof.obj --cull none --eye 0.4,0.3,9 ${options//_/ }
  check "a ridge of 20 degrees, ${options:-without options}: $edges" is "$edges" "${want%% *}"
done

# ---- hidden edges dashed: the other three edges, in a group before the visible ones
run "" cube $small --style hidden-line --cull none --hidden-edges dashed -o dashed.svg
check "dashed: exit 0: $err" is "$status" 0
check "dashed: two groups, the first of dashes" is "$(grep -n '^<g ' dashed.svg | grep -c dasharray)/$(grep -c '^<g ' dashed.svg)" 1/2
check "dashed: three lines before nine" is "$(sed '/^<\/g>/q' dashed.svg | grep -c '^<line ')/$(lines_of dashed.svg)" 3/12
run "" cube $small --style hidden-line --cull none -o plain.svg
run "" cube $small --style hidden-line --hidden-edges dashed -o default.svg
check "dashed: back faces are not culled unless one says so" cmp dashed.svg default.svg
run "" cube $small --style hidden-line --cull back --hidden-edges dashed -o fronts.svg
check "dashed, backs culled: nothing is hidden" is "$(sed '/^<\/g>/q' fronts.svg | grep -c '^<line ')" 0

run "" cube $small --style hidden-line --cull none --hidden-edges none -o none.svg
check "hidden edges are left out unless asked for" cmp plain.svg none.svg
check "the visible ones are the same" is "$(sed '1,/^<\/g>/d' dashed.svg | grep '^<line ')" "$(grep '^<line ' plain.svg)"

# ---- what options do
hash_with() { drawn "$*" "$@" && hash_in s.json; }
for model in square.off square_in_any.name square.stl; do
  check "$model is the body of square.obj" is "$(hash_with $model $small)" "$(hash_with square.obj $small)"
done
# A cube without normals, which a wide crease makes a pillow: its smooth styles differ.
cat >bare.obj <<END
v 0 0 0
v 0 0 1
v 1 0 0
v 1 0 1
v 1 1 0
v 1 1 1
v 0 1 0
v 0 1 1
f 1 3 4 2
f 3 5 6 4
f 5 7 8 6
f 7 1 2 8
f 1 7 5 3
f 2 4 6 8
END
pillow="bare.obj $small --crease 120"
plain=$(hash_with $pillow)
for option in "--crease 60" "--crease 0" "--style wire" "--style hidden-line" "--style flat" "--style phong" "--fov 60" "--up 1,0,0" \
  "--up -1,0.5,0" "--light -3,2,-4" \
  "--project orthographic" "--project isometric" "--project dimetric" "--project trimetric" "--project oblique" \
  "--eye 3,2,5" "--eye -3,2,-5" "--target 0.5,0.75,0.5" "--size 36x48"; do
  check "$option changes the picture" is_not "$(hash_with $pillow $option)" "$plain"
done
check "two lights are not one" is_not "$(hash_with cube $small --light 3,4,5 --light -3,0,5)" "$(hash_with cube $small --light 3,4,5)"
check "the order of options does not matter" is "$(hash_with --fov 50 $small --eye 3,2,5 cube)" "$(hash_with cube --eye 3,2,5 --fov 50 $small)"
check "an eye without a target looks at the centre" is "$(hash_with cube $small --eye 3,2,5)" \
  "$(hash_with cube $small --eye 3,2,5 --target 0.5,0.5,0.5)"
check "the last of two wins" is "$(hash_with bare.obj --size 9x9 $small --crease 10 --crease 120)" "$plain"
check "the built-in cube has the normals of its faces" is "$(hash_with cube $small --crease 120)" "$(hash_with cube $small)"
check "and is shaded as one without, creased" is "$(hash_with cube $small --crease 120)" "$(hash_with bare.obj $small)"

# The sphere around a model touches the picture: a square picture of a sphere is filled from border to border.
for project in perspective orthographic isometric dimetric trimetric oblique; do
  drawn "the sphere fits, $project" sphere --size 101x101 --style flat --project $project
  rows=$(pixels p.ppm 101 |
    awk '{ for (i = 1; i <= 303; i += 3) if ($i != 250 || $(i + 1) != 249 || $(i + 2) != 246) { print NR - 1; next } }')
  check "the sphere reaches the upper border, $project" test "$(echo "$rows" | head -n 1)" -le 2
  check "the sphere reaches the lower border, $project" test "$(echo "$rows" | tail -n 1)" -ge 98
done

# Every projection gives a picture of its own.
hashes=$(for project in perspective orthographic isometric dimetric trimetric oblique; do
  hash_with cube $small --project $project
done)
check "six projections, six pictures" is "$(echo "$hashes" | sort -u | wc -l)" 6
# Isometric: the three faces of a cube that are seen have equal areas. A lamp far away gives each one colour.
drawn "an isometric cube" cube --size 301x301 --project isometric --style flat --light 3e6,2e6,1e6
areas=$(pixels p.ppm | grep -v "^ *250 *249 *246\$" | sort | uniq -c | awk '{ print $1 }' | sort -n)
check "an isometric cube shows three faces" is "$(echo "$areas" | wc -l)" 3
check "the faces of an isometric cube are equally large" test \
  $(($(echo "$areas" | tail -n 1) - $(echo "$areas" | head -n 1))) -le 300
# Oblique: the front face keeps its true shape, half of the depth is drawn.
drawn "an oblique cube" cube --size 301x301 --project oblique --style flat --light 3e6,2e6,1e6
areas=$(pixels p.ppm | grep -v "^ *250 *249 *246\$" | sort | uniq -c | awk '{ print $1 }' | sort -n)
front=$(echo "$areas" | tail -n 1)
check "an oblique cube shows three faces" is "$(echo "$areas" | wc -l)" 3
check "top and side have sin(45)/2 of the front's area" test \
  $(($(echo "$areas" | head -n 1) * 1000 / front)) -ge 345 -a $(($(echo "$areas" | sed -n 2p) * 1000 / front)) -le 362
# The direction of technical drawings is their own: the eye says how far away it is.
for project in isometric dimetric trimetric oblique; do
  check "$project: of an eye only its distance counts" is "$(hash_with cube $small --project $project --eye 3.5,0.5,0.5)" \
    "$(hash_with cube $small --project $project --eye 0.5,3.5,0.5)"
  check "$project: a nearer eye shows less" is_not "$(hash_with cube $small --project $project --eye 3.5,0.5,0.5)" \
    "$(hash_with cube $small --project $project --eye 2.5,0.5,0.5)"
  check "$project: another target" is_not "$(hash_with cube $small --project $project --target 0,0,0)" \
    "$(hash_with cube $small --project $project)"
  check "$project: up along z" is_not "$(hash_with cube $small --project $project --up 0,0,1 --style wire --target 0,0,0)" \
    "$(hash_with cube $small --project $project --style wire --target 0,0,0)"
done

# ---- pictures of awkward scenes
drawn "the eye inside the model" cube $small --eye 0.5,0.4,0.6 --target 0.1,0.2,0.3
check "the eye inside the model: backs are culled" is "$(number pixels_drawn s.json)" 0
drawn "the eye inside the model without culling" cube $small --eye 0.5,0.4,0.6 --target 0.1,0.2,0.3 --cull none
check "the eye inside the model without culling: all pixels" is "$(number pixels_drawn s.json)" $((48 * 36))
for project in perspective orthographic isometric dimetric trimetric oblique; do
  drawn "up parallel to the view, $project" cube $small --up 1,1,1 --project $project
  drawn "up next to nothing, $project" cube $small --up 0,1e-320,0 --project $project
  check "up next to nothing is a direction, $project" is "$(hash_in s.json)" "$(hash_with cube $small --project $project)"
  drawn "a model of no size, $project" dot.obj $small --project $project
  check "a model of no size: the background, $project" is "$(number pixels_drawn s.json)" 0
done
for project in perspective orthographic; do
  drawn "up along the view, $project" cube $small --eye 0.5,5,0.5 --project $project
  check "up along the view: something is seen, $project" test "$(number pixels_drawn s.json)" -gt 0
done
drawn "a model without area" dot.obj $small
check "no place of the eye is blamed: $err" is "$err" "render: the picture is empty: no face of the model shows"
drawn "the widest angle" cube $small --fov 179.99999999999997
drawn "the narrowest angle" cube $small --fov 0.000001
for size in 1x1 3x1 1x3 65535x1 1x65535; do
  drawn "$size" cube --size $size
  check "$size: that size" is "$(sed -n 2p p.ppm)" "${size/x/ }"
done

# ---- refusals
refuses "no arguments" "no model"
refuses "no picture" "-o" cube
refuses "a missing file" "missing.obj" missing.obj -o x.png --stats x.json
refuses "a folder" "folder" folder -o x.png --stats x.json
refuses "bytes that are cut off" "cut.ply, byte 111" cut.ply -o x.png --stats x.json
refuses "an empty file" "empty" empty.obj -o x.png --stats x.json
strange_models -o strange.png --size 20x10
rm -f strange.png
refuses "a model without faces" "no faces" points.obj -o x.png --stats x.json
refuses "a vertex that is no number" "nan.obj:3:3" nan.obj -o x.png --stats x.json
refuses "an infinite vertex" "inf.obj:3:3" inf.obj -o x.png --stats x.json
refuses "an index out of range" "range.obj:4:7" range.obj -o x.png --stats x.json
if [ "$(id -u)" != 0 ]; then
  cp square.obj locked.obj && chmod 000 locked.obj
  refuses "a file that may not be read" "locked.obj" locked.obj -o x.png --stats x.json
  mkdir locked && chmod 555 locked
  refuses "a folder that may not be written" "locked" cube $small -o locked/x.png --stats x.json
else
  echo "skipped: files that may not be read or written (running as root)"
fi
refuses "a picture in no folder" "nowhere/x.png" cube $small -o nowhere/x.png --stats x.json
refuses "a picture in a file" "square.obj/x.png" cube $small -o square.obj/x.png --stats x.json
refuses "a picture that is a folder" "folder" cube $small -o folder --stats x.json
mkdir folder.png
refuses "a picture that is a folder called .png" "folder.png" cube $small -o folder.png --stats x.json
refuses "statistics in no folder" "nowhere/x.json" cube $small -o x.png --stats nowhere/x.json
refuses "statistics that are a folder" "folder" cube $small -o x.png --stats folder
refuses "a picture of unknown ending" ".png" cube -o x.gif --stats x.json
refuses "a picture without ending" ".png" cube -o png --stats x.json
for size in 0x0 0x5 5x0 -5x3 5x-3 100000x100000 65536x1 1x65536 65535x65535 12 x 5x x5 5x5x5 5.5x5 axb nanx5 infx5 1e400x5 "" " 5x5"; do
  refuses "--size '$size'" "--size" cube -o x.png --stats x.json --size "$size"
done
for option in --eye --target --up --light; do
  for value in 1,2 1,2,3,4 1,2, ,,, "" nan,0,0 0,inf,0 1e999,0,0 "1, 2,3" 1x,2,3 cube; do
    refuses "$option '$value'" "$option" cube -o x.png --stats x.json $option "$value"
  done
done
for value in -1 181 nan x "" 1,2; do refuses "--crease '$value'" "--crease" cube -o x.png --crease "$value"; done
for value in 0 180 -1 1e-310 nan inf x "" 1,2; do refuses "--fov '$value'" "--fov" cube -o x.png --stats x.json --fov "$value"; done
for value in 0 -1 257 1.5 1e300 nan x ""; do refuses "--threads '$value'" "--threads" cube -o x.png --stats x.json --threads "$value"; done
refused_choice() { # option value supported...
  local option=$1 value=$2
  shift 2
  for word in "$@"; do refuses "$option '$value' names $word" "$word" cube -o x.png --stats x.json "$option" "$value"; done
}
for value in nothing "" Wire; do
  refused_choice --project "$value" perspective orthographic isometric dimetric trimetric oblique
  refused_choice --hidden "$value" zbuffer painter warnock bsp raycast raytrace none
  refused_choice --style "$value" gouraud wire flat phong
  refused_choice --cull "$value" back none
  refused_choice --hidden-edges "$value" none dashed
  refused_choice --edges "$value" all sharp outline
  refused_choice --skip "$value" on off
done
# What is promised for later works or is refuses with the list; never anything else.
for pair in "--hidden raytrace" "--style hidden-line"; do
  run "" cube $small -o later.ppm $pair
  if [ "$status" = 0 ]; then
    check "$pair: a picture" test -s later.ppm
  else
    rm -f later.ppm
    refuses "$pair" "supported: " cube $small -o x.png --stats x.json $pair
  fi
done
for option in -o --stats --size --eye --target --up --fov --project --hidden --style --edges --light --cull --skip --threads; do
  refuses "$option without a value" "$option" cube $small -o x.png $option
done
refuses "an unknown option" "--colour" cube -o x.png --colour red
refuses "an unknown short option" "-q" cube -o x.png -q
refuses "two models" "sphere" cube sphere -o x.png
for project in perspective orthographic isometric dimetric trimetric oblique; do
  refuses "the eye at the target, $project" "the eye is at the target" cube -o x.png --eye 0,0,5 --target 0,-0,5 --project $project
  refuses "the eye at the centre, $project" "the eye is at the target" cube -o x.png --eye 0.5,0.5,0.5 --project $project
  refuses "the target at the eye of a model of no size, $project" "the eye is at the target" dot.obj -o x.png --stats x.json \
    --eye 0,0,0 --project $project
done
refuses "the eye at the target of a huge model" "the eye is at the target" huge.obj -o x.png --eye 1e200,0,0 --target 1e200,0,0
for up in 0,0,0 -0,0,-0 1e-400,0,0; do refuses "no up, $up" "--up needs a direction" cube -o x.png --stats x.json --up $up; done
refuses "an eye out of range" "too far" cube -o x.png --eye 1e200,0,0
refuses "a target out of range" "too far" cube -o x.png --target 1e300,0,0 --project orthographic

run "" cube $small -o empty.png --eye 0,0,9 --target 0,0,20
check "an empty picture is a picture: exit 0" is "$status" 0
check "an empty picture comes with a hint: $err" has "$err" "render: the picture is empty"
run "" cube $small -o full.png
check "a picture of the model comes without" is "$err" ""
printf '\377\376v\0' >utf16.obj
refuses "a text of another kind" "UTF-8: utf16.obj" utf16.obj -o x.png
check "what is wrong with a whole file has no position: $err" ends "$err" ": utf16.obj"

# A picture that stood there before stays when the new one cannot be drawn.
cp picture.png kept.png
refuses "a failure beside an old picture" "missing.obj" missing.obj -o kept.png
check "an old picture is as it was" cmp -s picture.png kept.png
refuses "a failure of the statistics beside an old picture" "nowhere" cube -o kept.png $small --style wire --stats nowhere/x.json
check "an old picture is as it was when the statistics cannot be written" cmp -s picture.png kept.png

refuses "one file for both" "both.png" cube $small -o both.png --stats both.png
refuses "one file for both by another name" "both.png" cube $small -o both.png --stats ./both.png
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n' >self.ppm
cp self.ppm self.kept
refuses "a picture over its model" "overwritten" self.ppm -o ./self.ppm
check "the model is as it was" cmp -s self.ppm self.kept
# The size of a model does not matter, to the ends of the range: these are 2^1000, 2^-1000, 2^-1070 times the first.
sized() {
  printf 'v 0 0 0\nv %s 0 0\nv 0 %s 0\nv 0 0 %s\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n' "$1" "$1" "$1" >sized.obj
  run "" sized.obj $small -o "$2"
}
sized 4 plain.ppm
for size in 4.2860344287450693e301 3.7330544740128755e-301 3.16202013338398e-322; do
  sized $size scaled.ppm
  check "a model of size $size: the same picture" cmp -s plain.ppm scaled.ppm
done
run "" sized.obj $small -o scaled.ppm --eye 1e-321,2e-321,1e-321
check "an eye near a tiny model is drawn" is "$status" 0
sized 1e-310 x.ppm
refuses "an eye out of reach of a tiny model" "too far" sized.obj -o x.png --eye 1,1,1
refuses "a size that is no plain number" "--size" cube -o x.png --size 1e2x50
refuses "a folder that does not exist" "folder" cube -o nowhere/x.png
# Where the system grants no threads, the calling one does the work. (Sanitizers need more room than that.)
if (ulimit -v 400000 && "$program" --help) >/dev/null 2>&1; then
  run "" cube $small --threads 200 -o many.ppm
  few=$( (ulimit -v 400000; "$program" cube $small --threads 200 -o few.ppm 2>&1); echo $?)
  check "few threads for many: exit 0" is "$few" 0
  check "few threads for many: the same picture" cmp -s many.ppm few.ppm
fi

check "no temporary file is left" is "$(find . -name '*.part' | wc -l)" 0
conclude
