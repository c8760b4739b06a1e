// SPDX-License-Identifier: MIT
// Lanes: pack<T, N> is N numbers that are computed with at once. A kernel is written once, for a type F that is either
// a scalar or a pack; this header gives both the few operations whose spelling differs (lanes<F>, select, any, load).
// Packs are run-time only: compilers cannot read vector lanes in constant evaluation, where the scalar form serves.
//
// On compilers with vector extensions a pack is a vector register, elsewhere (or with IRG_LANES_ARRAY) a plain array.
// Packs live in the functions' namespace because their layout follows the instruction set; they never cross a
// function that is not inlined.
#pragma once

#include <cstdint>
#include <cstring>

#include <irg/core/contraction.hpp>
#include <irg/core/scalar.hpp>

#if defined(__GNUC__) && !defined(IRG_LANES_ARRAY)
#define IRG_LANES_VECTOR 1
#endif

namespace irg {
inline namespace IRG_ABI {

/// The number of bytes that one instruction of this target works on, 32 at most: the small triangles that pictures are
/// made of would leave most of a wider pack idle.
#if defined(__AVX2__)
inline constexpr int native_bytes = 32;
#else
inline constexpr int native_bytes = 16;
#endif

/// The number of lanes of T in one register.
template <class T>
inline constexpr int native_lanes = native_bytes / static_cast<int>(sizeof(T));

/// N numbers computed with at once.
template <class T, int N>
struct pack {
  static_assert(std::is_arithmetic_v<T> && N >= 1 && (N & (N - 1)) == 0);
#ifdef IRG_LANES_VECTOR
  typedef T storage __attribute__((vector_size(sizeof(T) * static_cast<unsigned>(N))));
#else
  struct storage {
    T lane[static_cast<unsigned>(N)];
    T& operator[](int i) { return lane[i]; }
    const T& operator[](int i) const { return lane[i]; }
  };
#endif
  storage v;
  IRG_INLINE T operator[](int i) const noexcept { return v[i]; }
};

namespace lanes_detail {

// op(a, b) lane by lane: on whole registers where there are some.
template <class T, int N, class Op>
IRG_INLINE pack<T, N> lanewise(const pack<T, N>& a, const pack<T, N>& b, Op op) noexcept {
#ifdef IRG_LANES_VECTOR
  return {op(a.v, b.v)};
#else
  pack<T, N> r{};
  for (int i = 0; i < N; ++i) r.v[i] = static_cast<T>(op(a.v[i], b.v[i]));
  return r;
#endif
}

// A comparison lane by lane: all bits set where it holds. T and the mask's int32 have the same size.
template <class T, int N, class Op>
IRG_INLINE pack<std::int32_t, N> compare(const pack<T, N>& a, const pack<T, N>& b, Op op) noexcept {
  static_assert(sizeof(T) == sizeof(std::int32_t));
#ifdef IRG_LANES_VECTOR
  return {op(a.v, b.v)};
#else
  pack<std::int32_t, N> r{};
  for (int i = 0; i < N; ++i) r.v[i] = op(a.v[i], b.v[i]) ? -1 : 0;
  return r;
#endif
}

}  // namespace lanes_detail

template <class T, int N>
IRG_INLINE pack<T, N> operator+(const pack<T, N>& a, const pack<T, N>& b) noexcept {
  return lanes_detail::lanewise(a, b, [](auto x, auto y) { return x + y; });
}
template <class T, int N>
IRG_INLINE pack<T, N> operator-(const pack<T, N>& a, const pack<T, N>& b) noexcept {
  return lanes_detail::lanewise(a, b, [](auto x, auto y) { return x - y; });
}
/// The product of each lane, rounded on its own: packs are never contracted.
template <class T, int N>
IRG_INLINE pack<T, N> operator*(const pack<T, N>& a, const pack<T, N>& b) noexcept {
  return lanes_detail::lanewise(a, b, [](auto x, auto y) {
    if constexpr (std::is_floating_point_v<T>)
      return opaque(x * y);
    else
      return x * y;
  });
}
template <class T, int N>
IRG_INLINE pack<T, N> operator/(const pack<T, N>& a, const pack<T, N>& b) noexcept {
  return lanes_detail::lanewise(a, b, [](auto x, auto y) { return x / y; });
}
template <int N>
IRG_INLINE pack<std::int32_t, N> operator|(const pack<std::int32_t, N>& a, const pack<std::int32_t, N>& b) noexcept {
  return lanes_detail::lanewise(a, b, [](auto x, auto y) { return x | y; });
}
template <class T, int N>
IRG_INLINE pack<std::int32_t, N> operator<(const pack<T, N>& a, const pack<T, N>& b) noexcept {
  return lanes_detail::compare(a, b, [](auto x, auto y) { return x < y; });
}
template <class T, int N>
IRG_INLINE pack<std::int32_t, N> operator>=(const pack<T, N>& a, const pack<T, N>& b) noexcept {
  return lanes_detail::compare(a, b, [](auto x, auto y) { return x >= y; });
}
template <class T, int N>
IRG_INLINE pack<std::int32_t, N> operator==(const pack<T, N>& a, const pack<T, N>& b) noexcept {
  return lanes_detail::compare(a, b, [](auto x, auto y) { return x == y; });
}

/// How a kernel's number type F, scalar or pack, is made and moved.
///   count            how many numbers F holds
///   broadcast(x)     x in every lane              ramp()          0, 1, 2, ... in the lanes
///   load(p)          count numbers from p on      store(p, f)     the reverse
template <class F>
struct lanes {
  using scalar = F;
  static constexpr int count = 1;
  template <class T>
  using rebind = T;
  using mask = bool;
  IRG_INLINE static constexpr F broadcast(F x) noexcept { return x; }
  IRG_INLINE static constexpr F ramp() noexcept { return F(0); }
  IRG_INLINE static constexpr F load(const F* p) noexcept { return *p; }
  IRG_INLINE static constexpr void store(F* p, F f) noexcept { *p = f; }
};

template <class T, int N>
struct lanes<pack<T, N>> {
  using scalar = T;
  static constexpr int count = N;
  template <class U>
  using rebind = pack<U, N>;
  using mask = pack<std::int32_t, N>;
  IRG_INLINE static pack<T, N> broadcast(T x) noexcept {
#ifdef IRG_LANES_VECTOR
    return {x - typename pack<T, N>::storage {}};
#else
    pack<T, N> r{};
    for (int i = 0; i < N; ++i) r.v[i] = x;
    return r;
#endif
  }
  IRG_INLINE static pack<T, N> ramp() noexcept {
    pack<T, N> r{};
    for (int i = 0; i < N; ++i) r.v[i] = static_cast<T>(i);
    return r;
  }
  IRG_INLINE static pack<T, N> load(const T* p) noexcept {
    pack<T, N> r;
    std::memcpy(&r.v, p, sizeof r.v);
    return r;
  }
  IRG_INLINE static void store(T* p, const pack<T, N>& f) noexcept { std::memcpy(p, &f.v, sizeof f.v); }
};

/// The T that stands index[i] * 4 bytes behind base, in lane i.
/// needs   a T of four bytes
template <class T, int N>
IRG_INLINE pack<T, N> gather(const void* base, const pack<std::int32_t, N>& index) noexcept {
  static_assert(sizeof(T) == 4);
#if defined(IRG_LANES_VECTOR) && defined(__AVX2__)
  if constexpr (N == 8) {
    typedef int ints __attribute__((vector_size(32)));
#ifdef __clang__
    const ints words = __builtin_ia32_gatherd_d256(ints{}, static_cast<const int*>(base), index.v, ints{} - 1, 4);
#else
    const ints words = __builtin_ia32_gathersiv8si(ints{}, static_cast<const int*>(base), index.v, ints{} - 1, 4);
#endif
    return {reinterpret_cast<typename pack<T, N>::storage>(words)};
  }
#endif
  const auto at = [&](int i) {
    T value;
    std::memcpy(&value, static_cast<const char*>(base) + std::int64_t{index.v[i]} * 4, 4);
    return value;
  };
#ifdef IRG_LANES_VECTOR
  if constexpr (N == 4) return {typename pack<T, N>::storage{at(0), at(1), at(2), at(3)}};  // no way through memory
#endif
  pack<T, N> r{};
  for (int i = 0; i < N; ++i) r.v[i] = at(i);
  return r;
}

/// a where the mask holds, b elsewhere.
template <class T>
IRG_INLINE constexpr T select(bool mask, T a, T b) noexcept {
  return mask ? a : b;
}
template <class T, int N>
IRG_INLINE pack<T, N> select(const pack<std::int32_t, N>& mask, const pack<T, N>& a, const pack<T, N>& b) noexcept {
#ifdef IRG_LANES_VECTOR
  return {mask.v ? a.v : b.v};
#else
  pack<T, N> r{};
  for (int i = 0; i < N; ++i) r.v[i] = mask.v[i] ? a.v[i] : b.v[i];
  return r;
#endif
}

/// The lesser and the greater of two numbers, lane by lane in packs; b when they are unordered.
IRG_INLINE constexpr float low_of(float a, float b) noexcept { return a < b ? a : b; }
IRG_INLINE constexpr float high_of(float a, float b) noexcept { return b < a ? a : b; }
IRG_INLINE constexpr double low_of(double a, double b) noexcept { return a < b ? a : b; }
IRG_INLINE constexpr double high_of(double a, double b) noexcept { return b < a ? a : b; }
// In one instruction where there is one; g++ does not find the second.
template <class T, int N>
IRG_INLINE pack<T, N> low_of(const pack<T, N>& a, const pack<T, N>& b) noexcept {
#if defined(IRG_LANES_VECTOR) && defined(__SSE__)
  if constexpr (std::is_same_v<T, float> && N == 4) return {__builtin_ia32_minps(a.v, b.v)};
#ifdef __AVX__
  if constexpr (std::is_same_v<T, float> && N == 8) return {__builtin_ia32_minps256(a.v, b.v)};
#endif
#endif
  return select(a < b, a, b);
}
template <class T, int N>
IRG_INLINE pack<T, N> high_of(const pack<T, N>& a, const pack<T, N>& b) noexcept {
#if defined(IRG_LANES_VECTOR) && defined(__SSE__)
  if constexpr (std::is_same_v<T, float> && N == 4) return {__builtin_ia32_maxps(a.v, b.v)};
#ifdef __AVX__
  if constexpr (std::is_same_v<T, float> && N == 8) return {__builtin_ia32_maxps256(a.v, b.v)};
#endif
#endif
  return select(b < a, a, b);
}

/// Where both masks hold.
IRG_INLINE constexpr bool both(bool a, bool b) noexcept { return a && b; }
template <int N>
IRG_INLINE pack<std::int32_t, N> both(const pack<std::int32_t, N>& a, const pack<std::int32_t, N>& b) noexcept {
  return lanes_detail::lanewise(a, b, [](auto x, auto y) { return x & y; });
}

/// One bit per lane, lane 0 the lowest, set where the mask holds.
IRG_INLINE constexpr unsigned mask_bits(bool mask) noexcept { return mask ? 1u : 0u; }
template <int N>
IRG_INLINE unsigned mask_bits(const pack<std::int32_t, N>& mask) noexcept {
#if defined(IRG_LANES_VECTOR) && defined(__SSE2__)
  if constexpr (N == 4) {
    typedef float floats __attribute__((vector_size(16)));
    return static_cast<unsigned>(__builtin_ia32_movmskps(reinterpret_cast<floats>(mask.v)));
  }
#ifdef __AVX__
  if constexpr (N == 8) {
    typedef float floats __attribute__((vector_size(32)));
    return static_cast<unsigned>(__builtin_ia32_movmskps256(reinterpret_cast<floats>(mask.v)));
  }
#endif
#endif
  unsigned bits = 0;
  for (int i = 0; i < N; ++i) bits |= mask.v[i] != 0 ? 1u << i : 0u;
  return bits;
}

/// The integer, rounded to the nearest float, ties to even.
template <class I>
IRG_INLINE constexpr float to_float(I i) noexcept {
  return static_cast<float>(i);
}
template <int N>
IRG_INLINE pack<float, N> to_float(const pack<std::int32_t, N>& i) noexcept {
#ifdef IRG_LANES_VECTOR
  return {__builtin_convertvector(i.v, typename pack<float, N>::storage)};
#else
  pack<float, N> r{};
  for (int k = 0; k < N; ++k) r.v[k] = static_cast<float>(i.v[k]);
  return r;
#endif
}

/// The bits of every lane, read as numbers of another type of the same size.
template <class T, class U, int N>
IRG_INLINE pack<T, N> bits_as(const pack<U, N>& x) noexcept {
  static_assert(sizeof(T) == sizeof(U));
  pack<T, N> r;
  std::memcpy(&r.v, &x.v, sizeof r.v);
  return r;
}

/// Lane i of a number or a pack.
template <class T>
IRG_INLINE constexpr T lane(T x, int) noexcept {
  return x;
}
template <class T, int N>
IRG_INLINE T lane(const pack<T, N>& x, int i) noexcept {
  return x[i];
}

#ifdef IRG_LANES_VECTOR

/// N integers below 2^53, held exactly by doubles in two registers: for what leaves 32 bits. Nothing is rounded, so
/// nothing has to be guarded against contraction.
template <int N>
struct wide_pack {
  static constexpr int half_count = N / 2;
  pack<double, N / 2> half[2];
};

template <int N>
IRG_INLINE wide_pack<N> operator+(const wide_pack<N>& a, const wide_pack<N>& b) noexcept {
  return {{{a.half[0].v + b.half[0].v}, {a.half[1].v + b.half[1].v}}};
}
template <int N>
IRG_INLINE wide_pack<N> operator*(const wide_pack<N>& a, const wide_pack<N>& b) noexcept {
  return {{{a.half[0].v * b.half[0].v}, {a.half[1].v * b.half[1].v}}};
}
template <int N>
IRG_INLINE double lane(const wide_pack<N>& a, int i) noexcept {
  return a.half[i / (N / 2)].v[i % (N / 2)];
}

// Two halves of a register, put together.
template <class T, int N>
IRG_INLINE pack<T, N> join_halves(const pack<T, N / 2>& low, const pack<T, N / 2>& high) noexcept {
  pack<T, N> both_halves;
  std::memcpy(&both_halves.v, &low.v, sizeof low.v);
  std::memcpy(reinterpret_cast<char*>(&both_halves.v) + sizeof low.v, &high.v, sizeof high.v);
  return both_halves;
}

template <int N>
IRG_INLINE pack<float, N> to_float(const wide_pack<N>& a) noexcept {
  using half = typename pack<float, N / 2>::storage;
  return join_halves<float, N>({__builtin_convertvector(a.half[0].v, half)},
                               {__builtin_convertvector(a.half[1].v, half)});
}

/// Where none of three numbers is negative.
template <int N>
IRG_INLINE pack<std::int32_t, N> none_negative(const pack<std::int32_t, N>& a, const pack<std::int32_t, N>& b,
                                               const pack<std::int32_t, N>& c) noexcept {
  return {(a.v | b.v | c.v) >= 0};
}
template <int N>
IRG_INLINE pack<std::int32_t, N> none_negative(const wide_pack<N>& a, const wide_pack<N>& b,
                                               const wide_pack<N>& c) noexcept {
  using half = typename pack<std::int32_t, N / 2>::storage;
  const auto mask = [&](int i) {
    return pack<std::int32_t, N / 2>{
        __builtin_convertvector((a.half[i].v >= 0) & (b.half[i].v >= 0) & (c.half[i].v >= 0), half)};
  };
  return join_halves<std::int32_t, N>(mask(0), mask(1));
}

template <int N>
struct lanes<wide_pack<N>> {
  using scalar = double;
  static constexpr int count = N;
  IRG_INLINE static wide_pack<N> broadcast(double x) noexcept {
    using half = typename pack<double, N / 2>::storage;
    return {{{x - half{}}, {x - half{}}}};
  }
  IRG_INLINE static wide_pack<N> ramp() noexcept {
    wide_pack<N> r{};
    for (int i = 0; i < N; ++i) r.half[i / (N / 2)].v[i % (N / 2)] = i;
    return r;
  }
};

#endif

}  // namespace IRG_ABI
}  // namespace irg
