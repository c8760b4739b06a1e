// SPDX-License-Identifier: MIT
// pack<T, N>: N numbers that are computed with at once. On compilers with vector extensions a pack is a vector
// register, elsewhere (or with IRG_LANES_ARRAY) a plain array: the same text, the same bits.
//
// Packs live in the functions' namespace because their layout follows the instruction set; they never cross a function
// that is not inlined. Whatever may be wider than a register is passed by reference: by value it would have an ABI.
#pragma once

#include <cstdint>
#include <cstring>
#include <type_traits>

#include <irg/core/contraction.hpp>
#include <irg/core/scalar.hpp>

#if defined(__GNUC__) && !defined(IRG_LANES_ARRAY)
#define IRG_LANES_VECTOR 1
#endif

namespace irg::inline IRG_ABI {

/// Whether packs are registers. Where they are arrays, kernels run all the same, but one that has a plain form, too,
/// may be slower than that.
#ifdef IRG_LANES_VECTOR
inline constexpr bool has_lanes = true;
#else
inline constexpr bool has_lanes = false;
#endif

/// The number of bytes that one instruction of this target works on, 32 at most: the small triangles that pictures are
/// made of would leave most of a wider pack idle.
#if defined(__AVX2__)
inline constexpr int native_bytes = 32;
#else
inline constexpr int native_bytes = 16;
#endif

/// The bytes of the widest register: for long arrays and for what fills it.
#if defined(__AVX512F__)
inline constexpr int widest_bytes = 64;
#else
inline constexpr int widest_bytes = native_bytes;
#endif

/// The number of lanes of T in one register, and in the widest.
template <class T>
inline constexpr int native_lanes = native_bytes / static_cast<int>(sizeof(T));
template <class T>
inline constexpr int widest_lanes = widest_bytes / static_cast<int>(sizeof(T));

/// N numbers computed with at once. In memory they are an array: lane 0 first. It is `v` that is copied to and from
/// memory, not the pack: g++ would copy halves of that by way of memory.
template <class T, int N>
struct pack {
  static_assert(std::is_arithmetic_v<T> && N >= 1 && (N & (N - 1)) == 0);
#ifdef IRG_LANES_VECTOR
  typedef T storage __attribute__((vector_size(sizeof(T) * static_cast<unsigned>(N))));
  storage v;  // for core alone: arrays have no such member
#else
  T v[static_cast<unsigned>(N)];
#endif
  IRG_INLINE T operator[](int i) const noexcept { return v[i]; }
};

/// Lane i of a number or a pack.
template <class T>
[[nodiscard]] IRG_INLINE constexpr T lane(T x, int) noexcept {
  return x;
}
template <class T, int N>
[[nodiscard]] IRG_INLINE T lane(const pack<T, N>& x, int i) noexcept {
  return x[i];
}

/// Writes x to lane i of a number or a pack.
template <class T>
IRG_INLINE constexpr void set_lane(T& p, int, std::type_identity_t<T> x) noexcept {
  p = x;
}
template <class T, int N>
IRG_INLINE void set_lane(pack<T, N>& p, int i, std::type_identity_t<T> x) noexcept {
  p.v[i] = x;
}

/// The pack of these numbers, the first in lane 0.
template <class T, std::same_as<T>... Ts>
[[nodiscard]] IRG_INLINE pack<T, 1 + static_cast<int>(sizeof...(Ts))> pack_of(T first, Ts... others) noexcept {
#ifdef IRG_LANES_VECTOR
  return {typename pack<T, 1 + static_cast<int>(sizeof...(Ts))>::storage{first, others...}};
#else
  return {{first, others...}};
#endif
}

/// How a kernel's number type F, scalar or pack, is made and moved.
///   count            how many numbers F holds
///   broadcast(x)     x in every lane              ramp()          0, 1, 2, ... in the lanes
///   load(p)          count numbers from p on      store(p, f)     the reverse
///   load_bytes(p)    their bytes from p on        store_bytes(p, f)
///   generate(f)      f(i) in lane i
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
  IRG_INLINE static F load_bytes(const void* p) noexcept {
    F f;
    std::memcpy(&f, p, sizeof f);
    return f;
  }
  IRG_INLINE static void store_bytes(void* p, F f) noexcept { std::memcpy(p, &f, sizeof f); }
  template <class Make>
  IRG_INLINE static constexpr F generate(const Make& make) {
    return make(0);
  }
};

namespace lanes_detail {

// The signed integer of so many bytes: one lane of a mask.
template <int Bytes>
using signed_integer = std::conditional_t<
    Bytes == 1, std::int8_t,
    std::conditional_t<Bytes == 2, std::int16_t, std::conditional_t<Bytes == 4, std::int32_t, std::int64_t>>>;

}  // namespace lanes_detail

/// Of each lane of T, whether something holds: all bits set, or none.
template <class T, int N>
using mask_of_lanes = pack<lanes_detail::signed_integer<static_cast<int>(sizeof(T))>, N>;

template <class T, int N>
struct lanes<pack<T, N>> {
  using scalar = T;
  static constexpr int count = N;
  template <class U>
  using rebind = pack<U, N>;
  using mask = mask_of_lanes<T, N>;
  IRG_INLINE static pack<T, N> broadcast(T x) noexcept {
#ifdef IRG_LANES_VECTOR
    return {x - typename pack<T, N>::storage {}};
#else
    return generate([&](int) { return x; });
#endif
  }
  IRG_INLINE static pack<T, N> ramp() noexcept {
    return generate([](int i) { return static_cast<T>(i); });
  }
  IRG_INLINE static pack<T, N> load(const T* p) noexcept { return load_bytes(p); }
  IRG_INLINE static void store(T* p, const pack<T, N>& f) noexcept { store_bytes(p, f); }
  IRG_INLINE static pack<T, N> load_bytes(const void* p) noexcept {
    pack<T, N> f;
    std::memcpy(&f.v, p, sizeof f);
    return f;
  }
  IRG_INLINE static void store_bytes(void* p, const pack<T, N>& f) noexcept { std::memcpy(p, &f.v, sizeof f); }
  template <class Make>
  IRG_INLINE static pack<T, N> generate(const Make& make) {
    pack<T, N> r;
    for (int i = 0; i < N; ++i) set_lane(r, i, make(i));
    return r;
  }
};

/// The pack, unchanged, as something the optimiser may not look into, as opaque() of a number.
template <class T, int N>
[[nodiscard]] IRG_INLINE pack<T, N> opaque(const pack<T, N>& p) noexcept {
#if defined(IRG_LANES_VECTOR) && defined(__wasm__)
  return p;
#elif defined(IRG_LANES_VECTOR)
  pack<T, N> r = p;
  if constexpr (sizeof r == sizeof(double)) {  // clang has no register for a vector of this size
    double bits;
    std::memcpy(&bits, &p, sizeof r);
    bits = opaque(bits);
    std::memcpy(&r, &bits, sizeof r);
  } else if constexpr (sizeof r < sizeof(double)) {
    r = lanes<pack<T, N>>::generate([&](int i) { return opaque(p[i]); });
  } else if constexpr (sizeof r <= IRG_FLOAT_REGISTER_BYTES) {
    asm("" : IRG_FLOAT_REGISTER(r.v));
  } else {
    asm("" : "+m"(r.v));  // a pack of several registers
  }
  return r;
#else
  return lanes<pack<T, N>>::generate([&](int i) { return opaque(p[i]); });
#endif
}

namespace lanes_detail {

// op(r, numbers...) gives r lane by lane: on whole registers where there are some. Of arrays, integers are computed in
// at least 32 bits, with or without sign as they are.
template <class T, int N, class Op, std::same_as<pack<T, N>>... Packs>
[[nodiscard]] IRG_INLINE pack<T, N> lanewise(const Op& op, const Packs&... numbers) noexcept {
  pack<T, N> r;
#ifdef IRG_LANES_VECTOR
  op(r.v, numbers.v...);
#else
  using wide = std::common_type_t<T, std::conditional_t<std::is_unsigned_v<T>, unsigned, int>>;
  for (int i = 0; i < N; ++i) {
    wide one;
    op(one, static_cast<wide>(numbers.v[i])...);
    r.v[i] = static_cast<T>(one);
  }
#endif
  return r;
}

}  // namespace lanes_detail

template <class T, int N>
[[nodiscard]] IRG_INLINE pack<T, N> operator+(const pack<T, N>& a, const pack<T, N>& b) noexcept {
  return lanes_detail::lanewise<T, N>([](auto& r, const auto& x, const auto& y) { r = x + y; }, a, b);
}
template <class T, int N>
[[nodiscard]] IRG_INLINE pack<T, N> operator-(const pack<T, N>& a, const pack<T, N>& b) noexcept {
  return lanes_detail::lanewise<T, N>([](auto& r, const auto& x, const auto& y) { r = x - y; }, a, b);
}
/// The product of each lane, rounded on its own: packs are never contracted.
template <class T, int N>
[[nodiscard]] IRG_INLINE pack<T, N> operator*(const pack<T, N>& a, const pack<T, N>& b) noexcept {
  const auto p = lanes_detail::lanewise<T, N>([](auto& r, const auto& x, const auto& y) { r = x * y; }, a, b);
  if constexpr (IRG_TARGET_FUSES && std::is_floating_point_v<T>)
    return opaque(p);
  else
    return p;
}
template <class T, int N>
[[nodiscard]] IRG_INLINE pack<T, N> operator/(const pack<T, N>& a, const pack<T, N>& b) noexcept {
  return lanes_detail::lanewise<T, N>([](auto& r, const auto& x, const auto& y) { r = x / y; }, a, b);
}

/// The same with one number for all lanes.
template <class T, int N>
[[nodiscard]] IRG_INLINE pack<T, N> operator+(const pack<T, N>& a, std::type_identity_t<T> b) noexcept {
  return a + lanes<pack<T, N>>::broadcast(b);
}
template <class T, int N>
[[nodiscard]] IRG_INLINE pack<T, N> operator-(const pack<T, N>& a, std::type_identity_t<T> b) noexcept {
  return a - lanes<pack<T, N>>::broadcast(b);
}
template <class T, int N>
[[nodiscard]] IRG_INLINE pack<T, N> operator*(const pack<T, N>& a, std::type_identity_t<T> b) noexcept {
  return a * lanes<pack<T, N>>::broadcast(b);
}

/// The negative of each lane: of floating numbers the sign is turned, also that of zero and NaN.
template <class T, int N>
[[nodiscard]] IRG_INLINE pack<T, N> operator-(const pack<T, N>& a) noexcept {
  return lanes_detail::lanewise<T, N>([](auto& r, const auto& x) { r = -x; }, a);
}

}  // namespace irg::inline IRG_ABI
