# What the guards share. Each guard is a script that runs from the project's root, prints what is wrong (or a table that
# is always shown) and ends with 1 when anything is.
set -euo pipefail
export LC_ALL=C
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

compilers=(g++-12 clang++-19)
strict=(-std=c++20 -Iinclude -Wall -Wextra -Wpedantic -Wconversion -Wsign-conversion -Wshadow -Wold-style-cast
  -Wdouble-promotion -Werror)

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
status=0

# Says what is wrong and goes on.
wrong() {
  echo "$*"
  status=1
}

all_headers() { find include/irg -mindepth 2 -name '*.hpp' | sort; }
public_headers() { find include/irg -mindepth 2 -name '*.hpp' ! -path '*/detail/*' | sort; }

# `include/irg/math/vec.hpp` as `#include <irg/math/vec.hpp>`.
as_includes() { sed 's|^include/\(.*\)$|#include <\1>|'; }
