// SPDX-License-Identifier: MIT
// irg as a C++20 module: `import irg;` in place of #include <irg/irg.hpp>. Macros stay in irg/core/config.hpp and
// irg/core/contract.hpp, threads in irg/core/threads.hpp, to be included. With the standard library of g++ 12, clang asks
// that a program which imports it includes what it uses of <vector>, <span>, <string> and <algorithm> itself.
module;
// What irg takes from the standard library stays outside of the module.
#include <algorithm>
#include <array>
#include <bit>
#include <cerrno>
#include <compare>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <initializer_list>
#include <limits>
#include <new>
#include <numeric>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <typeindex>
#include <utility>
#include <vector>
#include <stdlib.h>
#include <sys/stat.h>
export module irg;

#ifdef __clang__
#pragma clang diagnostic ignored "-Winclude-angled-in-module-purview"
#endif
// Of the language's linkage, so that a program may import irg in one file and include it in another.
export extern "C++" {
#include <irg/irg.hpp>
}
