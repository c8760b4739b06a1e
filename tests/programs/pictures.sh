#!/usr/bin/env bash
# The documentation's pictures are what the code draws today, byte for byte.
# Usage: pictures.sh FOLDER_OF_PROGRAMS
set -euo pipefail
cd "$(dirname "$0")/../.."
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
"$1/../docs/pictures" "$scratch"
passed=0 failed=0
for picture in docs/pictures/*.png docs/pictures/*.svg; do
  name=$(basename "$picture")
  if cmp -s "$picture" "$scratch/$name"; then
    passed=$((passed + 1))
  else
    echo "$picture is not what the code draws; scripts/pictures draws it anew"
    failed=$((failed + 1))
  fi
  rm -f "$scratch/$name"
done
for picture in "$scratch"/*.png "$scratch"/*.svg; do
  [ -e "$picture" ] || continue
  echo "$(basename "$picture") is drawn but not in docs/pictures"
  failed=$((failed + 1))
done
echo "$passed passed, $failed failed"
[ $failed = 0 ]
