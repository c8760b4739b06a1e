// SPDX-License-Identifier: MIT
#include <irg/math/error_free.hpp>
#include <irg/math/exponential.hpp>
#include <irg/math/hypot.hpp>
#include <irg/math/angle_between.hpp>
#include <irg/math/length.hpp>
#include <irg/math/sqrt.hpp>
#include <irg/math/trigonometry.hpp>

#include "hashes.hpp"

namespace {

/// By turns any bit pattern, NaN and infinity among them, a number below 16 and one beside 1.
template <class T>
constexpr T argument(test::random& r, int i) {
  if (i % 3 == 1) return static_cast<T>(32 * r.unit() - 16);
  if (i % 3 == 2)
    return static_cast<T>(1 + (r.unit() - 0.5) / static_cast<double>(std::int64_t{1} << r.integer(0, 40)));
  if constexpr (sizeof(T) == 8)
    return std::bit_cast<double>(r.next());
  else
    return std::bit_cast<float>(static_cast<std::uint32_t>(r.next() >> 32));
}

template <class T, class F>
constexpr std::uint64_t hash_of(int rounds, F add) {
  test::random r(2026);
  determinism::hasher h;
  for (int i = 0; i < rounds; ++i) {
    const T x = argument<T>(r, i), y = argument<T>(r, i);
    add(h, x, y);
  }
  return h.value();
}

template <class T>
constexpr std::uint64_t circular(int rounds) {
  return hash_of<T>(rounds, [](determinism::hasher& h, T x, T) {
    h.add(irg::sin(x));
    h.add(irg::cos(x));
    h.add(irg::tan(x));
    const irg::sine_and_cosine<T> both = irg::sin_cos_degrees(x);
    h.add(both.sine);
    h.add(both.cosine);
    h.add(irg::radians(x));
    h.add(irg::degrees(x));
  });
}

template <class T>
constexpr std::uint64_t inverse_circular(int rounds) {
  return hash_of<T>(rounds, [](determinism::hasher& h, T x, T y) {
    h.add(irg::asin(x));
    h.add(irg::acos(x));
    h.add(irg::asin(x / 16));
    h.add(irg::atan(x));
    h.add(irg::atan2(y, x));
  });
}

template <class T>
constexpr std::uint64_t powers(int rounds) {
  return hash_of<T>(rounds, [](determinism::hasher& h, T x, T y) {
    h.add(irg::exp(x));
    h.add(irg::exp2(x));
    h.add(irg::log(x));
    h.add(irg::log2(x));
    h.add(irg::log10(x));
    h.add(irg::cbrt(x));
    h.add(irg::pow(x, y));
  });
}

template <class T>
constexpr std::uint64_t lengths(int rounds) {
  return hash_of<T>(rounds, [](determinism::hasher& h, T x, T y) {
    h.add(irg::sqrt(x));
    h.add(irg::hypot(x, y));
    h.add(irg::hypot(x, T(1.5), y));
  });
}

template <class T>
constexpr std::uint64_t angles(int rounds) {
  test::random r(2026);
  determinism::hasher h;
  for (int i = 0; i < rounds; ++i) {
    irg::vec<T, 3> a{}, b{};
    for (int k = 0; k < 3; ++k) {
      a[k] = argument<T>(r, i % 11 == 0 ? 3 * i : 3 * i + 1 + i % 2);
      b[k] = i % 5 == 0 ? argument<T>(r, 3 * i + 2) * a[k] : argument<T>(r, 3 * i + 1);  // a fifth almost parallel
    }
    h.add(irg::angle_between(a, b));
    h.add(irg::angle_between(irg::vec<T, 2>{a.x, a.y}, irg::vec<T, 2>{b.x, b.y}));
  }
  return h.value();
}

template <class T>
constexpr std::uint64_t exact_products(int rounds) {
  test::random r(2026);
  determinism::hasher h;
  for (int i = 0; i < rounds; ++i) {
    // Products from the subnormal numbers up; too large ones are no constants.
    const T x = argument<T>(r, 3 * i + 1), y = argument<T>(r, 3 * i + 2);
    T scale = 1;
    for (std::int64_t k = r.integer(0, sizeof(T) == 8 ? 36 : 5); k > 0; --k) scale = scale * T(0x1p-30);
    const irg::exact_sum<T> product = irg::two_product(x * scale, y);
    h.add(product.value);
    h.add(product.error);
    h.add(irg::two_sum(x * scale, y).error);
    h.add(irg::difference_of_products(x * scale, y, x, y * scale));
  }
  return h.value();
}

#define HASHED_BOTH(function, few, many)                                                            \
  constexpr std::uint64_t math_##function##_float(int rounds) { return function<float>(rounds); }   \
  constexpr std::uint64_t math_##function##_double(int rounds) { return function<double>(rounds); } \
  HASHED(math_##function##_float, few, many);                                                       \
  HASHED(math_##function##_double, few, many)

HASHED_BOTH(circular, 60, 300'000);
HASHED_BOTH(inverse_circular, 60, 300'000);
HASHED_BOTH(powers, 60, 300'000);
HASHED_BOTH(lengths, 60, 300'000);
HASHED_BOTH(angles, 60, 300'000);
HASHED_BOTH(exact_products, 60, 300'000);

}  // namespace
