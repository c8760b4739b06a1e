# What the scripts share; source it from the project's root folder.
#   need_packages PACKAGE...      installs what is missing from the distribution
#   want_packages PACKAGE...      the same for what one can do without: names what cannot be had, and goes on
#   step TEXT COMMAND...          runs a command as the next of $steps steps, its output going to a log
#   use_compiler_cache            compiles through ccache from here on, where there is one
#   passed_before NAME            whether NAME passed with the very files that are here now
#   note_passed NAME FILE...      keeps that NAME passed, and the sums of the files that it depends on
#   fail SENTENCE                 ends the script with one sentence

script_name=scripts/$(basename "$0")
steps=${steps:-1}
step_number=0

fail() {
  echo "$script_name: $*" >&2
  exit 1
}

# The time since $1 (seconds), as "12 s" or "3 min 05 s".
elapsed_since() {
  local seconds=$((SECONDS - $1))
  if [ $seconds -lt 60 ]; then echo "$seconds s"; else printf '%d min %02d s\n' $((seconds / 60)) $((seconds % 60)); fi
}

step() {
  local text=$1 start=$SECONDS log
  shift
  step_number=$((step_number + 1))
  mkdir -p build/log
  log=build/log/$(basename "$0")-$step_number.log
  printf '[%d/%d] %s ... ' $step_number "$steps" "$text"
  if "$@" </dev/null >"$log" 2>&1; then
    elapsed_since $start
    return
  fi
  echo failed
  tail -n 40 "$log" >&2
  echo >&2
  fail "the step \"$text\" failed; all it said is in $log."
}

# Compilations go through ccache where it is installed: a second run compiles what changed.
use_compiler_cache() {
  command -v ccache >/dev/null || return 0
  export IRG_COMPILER_LAUNCHER=ccache CMAKE_CXX_COMPILER_LAUNCHER=ccache
  # Sound with precompiled headers, whose contents count and whose times do not.
  export CCACHE_SLOPPINESS=pch_defines,time_macros CCACHE_MAXSIZE=${CCACHE_MAXSIZE:-8G}
  # The compiler's list of what it read says what counts, so that nothing is preprocessed a second time.
  export CCACHE_DEPEND=1
}

# What passed need not run again while each file that it reads is the same, programs and compilers included: the sums stand
# in build/passed/NAME. With IRG_RUN_ALL set, everything runs.
passed_before() {
  [ -z "${IRG_RUN_ALL:-}" ] && [ -s "build/passed/$1" ] && sha256sum --check --status "build/passed/$1" 2>/dev/null
}
note_passed() {
  mkdir -p "build/passed/$(dirname "$1")"
  sha256sum "${@:2}" >"build/passed/$1.new" && mv "build/passed/$1.new" "build/passed/$1"
}
export -f passed_before note_passed

# Optimised and quick to compile: the release tier compiles each file apart and inlines as users do; so do the
# determinism runs. The library that the programs link is in between. The parameters of g++'s garbage collection save a
# twentieth of its time.
quick_build=(-DIRG_TEST_OPTIMISATION="-Og;-DIRG_INLINE_AS_USUAL;--param=ggc-min-expand=1000;--param=ggc-min-heapsize=500000"
  -DIRG_PROGRAM_OPTIMISATION="-Og;-DIRG_INLINE_AS_USUAL"
  -DIRG_COMPILED_PROGRAMS=ON -DIRG_COMPILED_OPTIMISATION="-O1;-DIRG_INLINE_AS_USUAL")

as_root() {
  if [ "$(id -u)" = 0 ]; then
    "$@"
  elif command -v sudo >/dev/null; then
    sudo "$@"
  else
    return 1
  fi
}

install_packages() {
  export DEBIAN_FRONTEND=noninteractive
  as_root apt-get update && as_root apt-get install -y --no-install-recommends "$@"
}

# The packages of a list that are not installed, as the array `missing`.
find_missing() {
  local package
  missing=()
  for package; do
    [ "$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null)" = installed ] || missing+=("$package")
  done
}

need_packages() {
  local missing
  if ! command -v dpkg-query >/dev/null; then
    step "Taking for granted, as this is no Debian: $*" true
    return
  fi
  find_missing "$@"
  if [ ${#missing[@]} = 0 ]; then
    step "Nothing to install" true
  elif [ "$(id -u)" != 0 ] && ! command -v sudo >/dev/null; then
    fail "these packages are missing, and installing them needs root: ${missing[*]}."
  else
    if [ "$(id -u)" != 0 ]; then sudo -v || fail "root is needed to install: ${missing[*]}."; fi
    step "Installing ${missing[*]}" install_packages "${missing[@]}"
  fi
}

# All at once, and one at a time where that fails: a package that this distribution lacks keeps out no other.
install_what_there_is() {
  local package
  install_packages "$@" && return
  for package; do as_root apt-get install -y --no-install-recommends "$package" || true; done
}

want_packages() {
  local missing
  if ! command -v dpkg-query >/dev/null; then
    step "Going on with what is there, as this is no Debian, of: $*" true
    return
  fi
  find_missing "$@"
  if [ ${#missing[@]} = 0 ]; then
    step "Nothing more to install" true
    return
  fi
  step "Installing, if they can be had, ${missing[*]}" install_what_there_is "${missing[@]}"
  find_missing "$@"
  [ ${#missing[@]} = 0 ] || echo "      Not to be had: ${missing[*]}"
}
