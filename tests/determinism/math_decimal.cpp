// SPDX-License-Identifier: MIT
// Numbers printed and read.
#include <irg/math/decimal.hpp>

#include "hashes.hpp"

namespace {

using determinism::hasher;

/// The text of any bit pattern, and what it and its first half read as.
template <class T>
constexpr void add_text(hasher& h, T value) {
  char text[irg::longest_decimal<T>] = {};
  char* const end = *irg::print_decimal(text, text + irg::longest_decimal<T>, value);
  for (const char* p = text; p != end; ++p) h.add(static_cast<int>(*p));
  h.add(irg::parse_decimal<T>(text, end).value);
  h.add(irg::parse_decimal<float>(text, text + (end - text) / 2).value);
}

constexpr std::uint64_t math_decimal_text(int rounds) {
  test::random r(60);
  hasher h;
  for (int i = 0; i < rounds; ++i) {
    add_text(h, std::bit_cast<double>(r.next()));
    add_text(h, std::bit_cast<float>(static_cast<std::uint32_t>(r.next())));
    add_text(h, static_cast<double>(r.integer(-1'000'000, 1'000'000)) / 1000);
  }
  return h.value();
}

HASHED(math_decimal_text, 20, 20'000);

}  // namespace
