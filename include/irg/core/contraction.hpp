// SPDX-License-Identifier: MIT
// The contraction guard. Compilers may fuse x*y + z into one instruction that rounds once; whether they do depends on
// flags that belong to the user. `product(x, y)` is x*y rounded on its own under every flag, so a formula written with
// it has the same bits everywhere. Every exact path of irg spells a product that meets a sum this way.
//
// Where the target has no fused instruction, as plain x86-64, there is nothing to guard against. Where it has one and
// the compiler is known to leave it alone, the product is fused with -0, which adds nothing and rounds once: the result
// cannot be fused with anything else, it takes the instruction and the time of a product, and loops of it are
// vectorised. Elsewhere an empty asm statement takes the product out of the optimiser's sight; it emits no instruction,
// but plain loops over products are not vectorised (explicit packs are not affected). Nothing less holds: clang ignores
// its FP_CONTRACT pragma under -ffp-contract=fast, g++ 12 forgets __builtin_assoc_barrier when it vectorises a loop.
#pragma once

#include <type_traits>

#include <irg/core/config.hpp>

// The register class that holds a float, a double or a pack on this target, and its size in bytes.
#if defined(__AVX512F__)
#define IRG_FLOAT_REGISTER "+v"
#define IRG_FLOAT_REGISTER_BYTES 64
#elif defined(__AVX__)
#define IRG_FLOAT_REGISTER "+x"
#define IRG_FLOAT_REGISTER_BYTES 32
#elif defined(__x86_64__) || defined(__i386__)
#define IRG_FLOAT_REGISTER "+x"
#define IRG_FLOAT_REGISTER_BYTES 16
#elif defined(__aarch64__)
#define IRG_FLOAT_REGISTER "+w"
#define IRG_FLOAT_REGISTER_BYTES 16
#elif defined(__riscv)
#define IRG_FLOAT_REGISTER "+f"
#define IRG_FLOAT_REGISTER_BYTES 8
#else
#define IRG_FLOAT_REGISTER "+m"
#define IRG_FLOAT_REGISTER_BYTES 64
#endif

// Whether the target has an instruction that computes x*y + z with one rounding. An emulated one, by a call, is made by
// no compiler on its own.
#if (defined(__x86_64__) || defined(__i386__)) && !defined(__FMA__) && !defined(__FMA4__) && !defined(__AVX512F__)
#define IRG_TARGET_FUSES 0
#elif defined(__wasm__)
#define IRG_TARGET_FUSES 0
#else
#define IRG_TARGET_FUSES 1
#endif

// Whether a product is guarded by being fused with -0: where that is one instruction, and the compiler does not take
// the -0 away again. clang would, and is not told that it is -0; g++ 12 does not, others have not been tried.
#if defined(__FMA__) && (defined(__clang__) || __GNUC__ == 12)
#define IRG_FUSES_WITH_ZERO 1
#else
#define IRG_FUSES_WITH_ZERO 0
#endif

namespace irg::inline IRG_ABI {

/// The value, unchanged, as something the optimiser may not look into: no operation on either side can be fused or
/// regrouped across it.
/// needs   a number or a vector of the compiler's own, not a class around one: clang finds no register for that
/// exact   the identity; in constant evaluation, where nothing is fused, it does nothing
template <class T>
[[nodiscard]] IRG_INLINE constexpr T opaque(T value) noexcept {
#if defined(__GNUC__) && !defined(__wasm__)
  static_assert(!std::is_class_v<T>);
  // In constant evaluation the statement is skipped: it is no constant there.
  if (!std::is_constant_evaluated()) {
    if constexpr (sizeof(T) <= IRG_FLOAT_REGISTER_BYTES)
      asm("" : IRG_FLOAT_REGISTER(value));
    else
      asm("" : "+m"(value));  // a pack of several registers
  }
#endif
  return value;
}

/// x*y, rounded by itself whatever the contraction flags.
/// needs   to be compiled for the processor that the flags name: a function with a target attribute of its own for one
///         that fuses needs those flags for its file
/// exact   the IEEE product, never fused with a sum
/// source  irg's own: the measurements are in docs/numbers.md
template <class T>
// NOLINTNEXTLINE(performance-unnecessary-value-param): most are numbers in registers
[[nodiscard]] IRG_INLINE constexpr T product(T x, T y) noexcept(noexcept(x * y)) {
  if constexpr (IRG_TARGET_FUSES && (std::is_same_v<T, float> || std::is_same_v<T, double>)) {
#if IRG_FUSES_WITH_ZERO
    if (std::is_constant_evaluated()) return x * y;
#ifdef __clang__
    const T nothing = opaque(T(-0.0));
#else
    const T nothing = T(-0.0);  // a statement that hides it would end the loop's vectorisation
#endif
    if constexpr (sizeof(T) == sizeof(float))
      return __builtin_fmaf(x, y, nothing);
    else
      return __builtin_fma(x, y, nothing);
#else
    return opaque<T>(x * y);
#endif
  } else {
    return x * y;  // integers and user-defined scalars; packs guard their own operator*
  }
}

}  // namespace irg::inline IRG_ABI
