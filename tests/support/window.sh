# shellcheck shell=bash
# SPDX-License-Identifier: MIT
# Programs with a window, tried with real keys and a real mouse in a screen of memory. Sourced behind programs.sh.

# has_window: whether there are such things; if not, says so aloud.
has_window() {
  if "$program" --window --no-such-option </dev/null 2>&1 | grep -q 'without SDL2'; then
    echo "window skipped: the program was built without SDL2"
  elif ! command -v Xvfb >/dev/null || ! command -v xdotool >/dev/null; then
    echo "window skipped: Xvfb or xdotool not found"
  else
    return 0
  fi
  return 1
}

# open_window TITLE arguments...: starts the program in the background; its output is in window.out, `id` is its window.
open_window() {
  local title=$1 display=90
  shift
  while [ -e "/tmp/.X$display-lock" ]; do display=$((display + 1)); done
  Xvfb ":$display" -screen 0 1024x768x24 -nolisten tcp >/dev/null 2>&1 &
  server=$!
  for _ in $(seq 100); do [ -e "/tmp/.X11-unix/X$display" ] && break || sleep 0.1; done
  export DISPLAY=":$display" SDL_VIDEODRIVER=x11
  # What SDL's own libraries keep to the end, some of them unloaded by then, is no leak of the program's.
  printf 'leak:%s\n' libdbus '<unknown module>' >leaks.txt
  export LSAN_OPTIONS="suppressions=$PWD/leaks.txt:print_suppressions=0"
  "$program" --window "$@" >window.out 2>window.err &
  window=$!
  check "the window opens: $(cat window.err)" said '^window: ready$'
  id=$(xdotool search --sync --name "$title" | head -n 1)
  xdotool windowfocus --sync "$id"
}

# said REGEX: whether the program says so within ten seconds.
said() { for _ in $(seq 100); do grep -q -- "$1" window.out && return 0 || sleep 0.1; done; return 1; }

# end_window: Escape, and the program has to end with 0.
end_window() {
  xdotool key Escape
  wait "$window"
  check "Escape ends it with 0" is "$?" 0
  kill "$server"
  wait "$server" 2>/dev/null
}
