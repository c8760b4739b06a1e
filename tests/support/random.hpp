// SPDX-License-Identifier: MIT
// Seeded random input made from integers alone, so that every compiler and flag set sees the same numbers.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <type_traits>

namespace test {

/// What the round of a soak (scripts/soak; IRG_SEED in the environment) adds to every seed at run time: 0 in the first.
inline std::uint64_t seed_of_round() {
  static const char* const round = std::getenv("IRG_SEED");
  return round == nullptr ? 0 : (std::strtoull(round, nullptr, 10) - 1) * 0xd1342543de82ef95u;
}

/// That the input showed enough of what a test is about: asked of the first round's, on which it was measured. Other
/// rounds of a soak ask for right results alone.
inline bool enough(bool shown) { return shown || seed_of_round() != 0; }

/// Marks input that is the same in every round of a soak: what constant evaluation made too, or what a share was
/// measured on.
struct in_every_round {};

/// SplitMix64 (Steele, Lea, Flood 2014).
struct random {
  std::uint64_t state;
  constexpr explicit random(std::uint64_t seed) : state(seed) {
    if (!std::is_constant_evaluated()) state += seed_of_round();
  }
  constexpr random(std::uint64_t seed, in_every_round) : state(seed) {}
  constexpr std::uint64_t next() {
    std::uint64_t z = (state += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }
  /// An integer in [low, high].
  constexpr std::int64_t integer(std::int64_t low, std::int64_t high) {
    const std::uint64_t range = static_cast<std::uint64_t>(high) - static_cast<std::uint64_t>(low) + 1;
    return static_cast<std::int64_t>(static_cast<std::uint64_t>(low) + (range == 0 ? next() : next() % range));
  }
  /// A double in [0, 1), a multiple of 2^-53.
  constexpr double unit() { return static_cast<double>(next() >> 11) * 0x1p-53; }
};

}  // namespace test
