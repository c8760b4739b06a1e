// SPDX-License-Identifier: MIT
// What every other header relies on: the version, the name of the functions' namespace, and a check that the
// compiler's floating-point mode keeps the promises (DESIGN: "same bits everywhere").
#pragma once

#define IRG_VERSION_MAJOR 0
#define IRG_VERSION_MINOR 1
#define IRG_VERSION_PATCH 0

#if (defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)) && !defined(IRG_ALLOW_FAST_MATH)
#error "irg: -ffast-math and -ffinite-math-only break exact decisions and reproducible pictures; build without them, or define IRG_ALLOW_FAST_MATH to give up both"
#endif
#if defined(__FLT_EVAL_METHOD__) && __FLT_EVAL_METHOD__ != 0 && !defined(IRG_ALLOW_EXCESS_PRECISION)
#error "irg: this target computes float and double in wider registers (x87); build with -msse2 -mfpmath=sse, or define IRG_ALLOW_EXCESS_PRECISION"
#endif

// Functions stand in an inline namespace that names the major version and the instruction set, so that objects built
// with different -march flags never share a body. Types and concepts stand in `irg` itself, so such objects can still
// hand each other meshes and images. Member functions of types are therefore forced inline.
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
#define IRG_JOIN_EXPANDED(major, isa, fma) v##major##_##isa##_##fma
#define IRG_JOIN(major, isa, fma) IRG_JOIN_EXPANDED(major, isa, fma)
#define IRG_ABI IRG_JOIN(IRG_VERSION_MAJOR, IRG_ISA, IRG_ISA_FMA)

#if defined(__GNUC__)
#define IRG_INLINE [[gnu::always_inline]] inline
#define IRG_NOINLINE [[gnu::noinline]]
#elif defined(_MSC_VER)
#define IRG_INLINE __forceinline
#define IRG_NOINLINE __declspec(noinline)
#else
#define IRG_INLINE inline
#define IRG_NOINLINE
#endif
