// SPDX-License-Identifier: MIT
// Hashes of results that must have the same bits with every compiler and all flags. A chapter's file defines functions
//   constexpr std::uint64_t name(int rounds)
// over seeded input and registers each with HASHED; tests/determinism/run compares what the program prints.
#pragma once

#include <bit>
#include <concepts>
#include <cstdint>
#include <type_traits>

#include "support/random.hpp"

namespace determinism {

/// FNV-1a over 64-bit words.
class hasher {
public:
  template <std::integral T>
  constexpr void add(T value) {
    word(static_cast<std::uint64_t>(value));
  }
  /// All NaNs count as one: their signs and payloads are the processor's business.
  template <std::floating_point T>
  constexpr void add(T value) {
    word(value != value ? ~std::uint64_t{0} : std::bit_cast<std::uint64_t>(static_cast<double>(value)));
  }
  /// A pixel of four bytes, the same for either order of bytes in memory.
  template <class Pixel>
    requires requires(const Pixel& p) { p.r, p.g, p.b, p.a; }
  constexpr void add(const Pixel& p) {
    add(static_cast<std::uint32_t>(p.r) | static_cast<std::uint32_t>(p.g) << 8 | static_cast<std::uint32_t>(p.b) << 16 |
        static_cast<std::uint32_t>(p.a) << 24);
  }
  constexpr std::uint64_t value() const { return hash_; }

private:
  constexpr void word(std::uint64_t w) {
    for (int shift = 0; shift < 64; shift += 8) hash_ = (hash_ ^ ((w >> shift) & 255u)) * 1099511628211u;
  }
  std::uint64_t hash_ = 14695981039346656037u;
};

/// One function: its hash as the compiler computed it for a few rounds, and how to compute it now.
struct section {
  const char* name;
  std::uint64_t (*compute)(int rounds);
  int constant_rounds;
  std::uint64_t constant;
  int rounds;
  section* next;

  section(const char* its_name, std::uint64_t (*function)(int), int few, std::uint64_t in_advance, int many);
};

}  // namespace determinism

/// Registers `function`: `few` rounds in constant evaluation and again at run time, `many` rounds at run time.
#define HASHED(function, few, many)                                       \
  const determinism::section function##_section(#function, function, few, \
                                                std::integral_constant<std::uint64_t, function(few)>::value, many)
