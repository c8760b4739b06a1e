// SPDX-License-Identifier: MIT
// What every other header relies on: the version, the name of the functions' namespace, and a check that the
// compiler's floating-point mode keeps the promises ("same bits everywhere").
#pragma once

#define IRG_VERSION_MAJOR 0
#define IRG_VERSION_MINOR 2
#define IRG_VERSION_PATCH 0

#if !defined(IRG_ALLOW_ANY_COMPILER) && \
    (defined(__clang__) ? __clang_major__ < 14 : (!defined(__GNUC__) || __GNUC__ < 12))
#error "irg: needs g++ 12 or clang 14, or newer (define IRG_ALLOW_ANY_COMPILER to try another)"
#include <The error above ends it here.>  // which does not exist, so that no flood of errors follows
#endif
#if __cplusplus < 202002L && !(defined(_MSVC_LANG) && _MSVC_LANG >= 202002L)
#error "irg: needs C++20 or newer: -std=c++20"
#include <The error above ends it here.>
#endif
#if defined(__SIZEOF_INT__) && \
    (__SIZEOF_INT__ < 4 || __CHAR_BIT__ != 8 || __FLT_MANT_DIG__ != 24 || __DBL_MANT_DIG__ != 53)
#error "irg: needs bytes of 8 bits, ints of 32 and the floats and doubles of IEEE 754"
#include <The error above ends it here.>
#endif
#if (defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__) ||              \
     defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) || defined(__NO_SIGNED_ZEROS__)) && \
    !defined(IRG_ALLOW_FAST_MATH)
#error "irg: -ffast-math and its parts break exact decisions (define IRG_ALLOW_FAST_MATH to give them up)"
#endif
#if defined(__FLT_EVAL_METHOD__) && __FLT_EVAL_METHOD__ != 0 && !defined(IRG_ALLOW_EXCESS_PRECISION)
#error "irg: x87 computes in wider registers: -msse2 -mfpmath=sse, or define IRG_ALLOW_EXCESS_PRECISION"
#endif

// Functions stand in an inline namespace that names the major version, the instruction set, whether preconditions are
// checked and whether exact decisions are given up, so that objects built with different -march flags, or with and
// without NDEBUG, never share a body, as long as those flags differ in what is named here: x86-64-v2 to -v4 do, two
// processors with AVX2 do not. Types and concepts stand in `irg` itself, so such objects can still hand each other
// meshes and images. Member functions of types are therefore forced inline.
#if defined(__AVX512F__) && defined(__AVX512BW__) && defined(__AVX512DQ__) && defined(__AVX512VL__)
#define IRG_ISA avx512
#elif defined(__AVX2__)
#define IRG_ISA avx2
#elif defined(__AVX__)
#define IRG_ISA avx
#elif defined(__SSE4_1__)
#define IRG_ISA sse4
#else
#define IRG_ISA baseline
#endif
#ifdef __FMA__
#define IRG_ISA_FMA fma
#else
#define IRG_ISA_FMA plain
#endif
#if defined(NDEBUG) && defined(IRG_ALLOW_FAST_MATH)
#define IRG_CHECKS release_fast
#elif defined(NDEBUG)
#define IRG_CHECKS release
#elif defined(IRG_ALLOW_FAST_MATH)
#define IRG_CHECKS checked_fast
#else
#define IRG_CHECKS checked
#endif

// The functions of the heavy half are compiled once for a program that links irg::compiled. There IRG_COMPILED is
// defined, these functions are declared and their bodies not read: IRG_BODIES is 0. Constant evaluation needs bodies: a
// file that defines IRG_HEADER_ONLY before its first header of irg has them, as if there were no library. The library's
// own files define IRG_COMPILING.
//   IRG_API           stands where constexpr would, in the declaration of such a function and in its definition
//   IRG_COMPILED_ABI  names their inline namespace: one for all instruction sets where they are compiled apart
// They are templates, whose instances src/*.cpp lists. Whatever calls them differs between the three, and so does the
// name of its namespace.
#if defined(IRG_COMPILING)
#define IRG_BODIES 1
#define IRG_LINKAGE library
#elif defined(IRG_COMPILED) && !defined(IRG_HEADER_ONLY)
#define IRG_BODIES 0
#define IRG_LINKAGE compiled
#else
#define IRG_BODIES 1
#define IRG_LINKAGE header
#endif
#define IRG_JOIN_EXPANDED(major, isa, fma, checks, linkage) v##major##_##isa##_##fma##_##checks##_##linkage
#define IRG_JOIN(major, isa, fma, checks, linkage) IRG_JOIN_EXPANDED(major, isa, fma, checks, linkage)
#define IRG_ABI IRG_JOIN(IRG_VERSION_MAJOR, IRG_ISA, IRG_ISA_FMA, IRG_CHECKS, IRG_LINKAGE)
#if defined(IRG_COMPILING) || !IRG_BODIES
#ifdef __GNUC__
#define IRG_API [[gnu::visibility("default")]]
#else
#define IRG_API
#endif
#define IRG_JOIN_COMPILED_EXPANDED(major, minor, decisions) compiled_v##major##_##minor##_##decisions
#define IRG_JOIN_COMPILED(major, minor, decisions) IRG_JOIN_COMPILED_EXPANDED(major, minor, decisions)
#ifdef IRG_ALLOW_FAST_MATH
#define IRG_COMPILED_ABI IRG_JOIN_COMPILED(IRG_VERSION_MAJOR, IRG_VERSION_MINOR, fast)
#else
#define IRG_COMPILED_ABI IRG_JOIN_COMPILED(IRG_VERSION_MAJOR, IRG_VERSION_MINOR, exact)
#endif
#else
#define IRG_API constexpr
#define IRG_COMPILED_ABI IRG_ABI
#endif

// Where a program is built for one instruction set, IRG_INLINE_AS_USUAL leaves it to the compiler what it inlines: for
// stepping through with a debugger and for builds with sanitizers, which it makes several times quicker. Without
// optimisation nothing is forced inline, either, which would only take time to compile: functions of types then carry
// the instruction set and the checks in names of their own, but for one choice, the usual one, that needs no mark. So
// do, always, functions of types that are too large to be forced inline, by IRG_APART, and types that no two objects
// hand each other.
#define IRG_TEXT_EXPANDED(...) #__VA_ARGS__
#define IRG_TEXT(...) IRG_TEXT_EXPANDED(__VA_ARGS__)
#if defined(__GNUC__) && (!defined(IRG_INLINE_AS_USUAL) || defined(IRG_COMPILING)) && \
    (defined(__SSE4_1__) || defined(__FMA__) || defined(NDEBUG) || defined(IRG_ALLOW_FAST_MATH))
#define IRG_APART [[gnu::abi_tag(IRG_TEXT(IRG_ABI))]]
#else
#define IRG_APART
#endif
#if defined(__GNUC__) && !defined(__OPTIMIZE__) && !defined(IRG_INLINE_AS_USUAL)
#define IRG_INLINE IRG_APART inline
#define IRG_INLINE_LAMBDA
#define IRG_NOINLINE [[gnu::noinline]]
#define IRG_NOINLINE_LAMBDA __attribute__((noinline))
#elif defined(__GNUC__) && defined(IRG_INLINE_AS_USUAL)
#define IRG_INLINE inline
#define IRG_INLINE_LAMBDA
#define IRG_NOINLINE [[gnu::noinline]]
#define IRG_NOINLINE_LAMBDA __attribute__((noinline))
#elif defined(__GNUC__)
#define IRG_INLINE [[gnu::always_inline]] inline
#define IRG_INLINE_LAMBDA __attribute__((always_inline))  // behind the parameters; C++20 has no place for [[ ]]
#define IRG_NOINLINE [[gnu::noinline]]
#define IRG_NOINLINE_LAMBDA __attribute__((noinline))
#elif defined(_MSC_VER)
#define IRG_INLINE __forceinline
#define IRG_INLINE_LAMBDA
#define IRG_NOINLINE __declspec(noinline)
#define IRG_NOINLINE_LAMBDA
#else
#define IRG_INLINE inline
#define IRG_INLINE_LAMBDA
#define IRG_NOINLINE
#define IRG_NOINLINE_LAMBDA
#endif

// The old name of a function that has a new one. It stays until 1.0, says so where it is called, and takes whatever the
// new name takes, but for arguments in bare braces.
#define IRG_RENAMED(old_name, new_name)                                   \
  template <class... A>                                                   \
  [[deprecated("irg: now " #new_name)]] constexpr auto old_name(A&&... a) \
      -> decltype(new_name(static_cast<A&&>(a)...)) {                     \
    return new_name(static_cast<A&&>(a)...);                              \
  }
