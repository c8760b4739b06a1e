// SPDX-License-Identifier: MIT
// What irg::compiled has of math, for float and double.
#include <irg/math/decimal.hpp>
#include <irg/math/inverse.hpp>

namespace irg {

#define IRG_FOR_SIZES(T, N)                                                                \
  template std::optional<mat<T, N, N>> detail::hard_inverse(const mat<T, N, N>&) noexcept; \
  template std::optional<mat<T, N, N>> detail::accurate_inverse(const mat<T, N, N>&) noexcept;
#define IRG_FOR_NUMBERS(T)                                                     \
  template decimal_result<T> parse_decimal(const char*, const char*) noexcept; \
  template std::optional<char*> print_decimal(char*, char*, T) noexcept;       \
  template T detail::unsigned_value(const detail::decimal_text&) noexcept;     \
  IRG_FOR_SIZES(T, 2)                                                          \
  IRG_FOR_SIZES(T, 3)                                                          \
  IRG_FOR_SIZES(T, 4)
IRG_FOR_NUMBERS(float)
IRG_FOR_NUMBERS(double)
#undef IRG_FOR_NUMBERS
#undef IRG_FOR_SIZES

}  // namespace irg
