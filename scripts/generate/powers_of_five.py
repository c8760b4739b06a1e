#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Prints include/irg/math/detail/powers_of_five_table.hpp.

usage: scripts/generate/powers_of_five.py > include/irg/math/detail/powers_of_five_table.hpp

Besides, it checks what printing relies on: that 128 bits, rounded up, tell the products of all floats and doubles with
their powers of ten from the integers beside them. None comes nearer to one than 2^-65.4 without being one.
"""
from fractions import Fraction

LOWEST, HIGHEST, PER_LINE = -342, 324, 5


def leading_bits(exponent):
    """The first 128 bits of 5^exponent, what follows them cut off."""
    power = 5 ** abs(exponent)
    if exponent < 0:
        bits = power.bit_length() + 127
        return (1 << bits) // power
    spare = power.bit_length() - 128
    return power >> spare if spare > 0 else power << -spare


def distances_to_integers(ratio, count):
    """The least distances of ratio * x, 1 <= x <= count, from integers below and above that it does not equal."""
    a, m = ratio.numerator % ratio.denominator, ratio.denominator
    if m <= count:
        return Fraction(1, m), Fraction(1, m)
    # The factors with the smallest remainder and with the largest, improved in turn as in Euclid's algorithm.
    low_factor, low, high_factor, high = 1, a, 1, m - a
    while True:
        if low < high:
            times = min((high - 1) // low, (count - high_factor) // low_factor)
            high_factor, high = high_factor + times * low_factor, high - times * low
        else:
            times = min((low - 1) // high, (count - low_factor) // high_factor)
            low_factor, low = low_factor + times * high_factor, low - times * high
        if times == 0:
            return Fraction(low, m), Fraction(high, m)


def check_printing(bits, lowest, highest):
    """For significands of so many bits: the formulas for k and shift of shortest_decimal, and its products."""
    for exponent in range(lowest, highest + 1):
        k, k_of_binade = exponent * 1262611 >> 22, exponent * 1262611 - 524031 >> 22
        for power, width in (k, Fraction(1)), (k_of_binade, Fraction(3, 4)):
            width *= Fraction(2) ** exponent
            assert LOWEST <= -power <= HIGHEST
            assert Fraction(10) ** power <= width < Fraction(10) ** (power + 1)
            shift = exponent + (-power * 217706 >> 16) + 1
            assert shift >= 0
            largest = 4 * 2**bits + 2 << shift
            assert largest < 2**60
            quarter = Fraction(2) ** exponent / Fraction(10) ** power
            below, above = distances_to_integers(2 * quarter, 2 * 2**bits + 1)  # of even multiples of the quarter
            fraction = quarter * (2 ** (bits + 1) - 1) % 1  # and the middle below a power of two
            if fraction != 0:
                below, above = min(below, fraction), min(above, 1 - fraction)
            assert min(below, above) * 2**128 > largest


check_printing(53, -1074, 971)
check_printing(24, -149, 104)

words = []
for exponent in range(LOWEST, HIGHEST + 1):
    bits = leading_bits(exponent)
    assert bits.bit_length() == 128
    floor_log2 = exponent * 152170 >> 16
    assert Fraction(2) ** floor_log2 <= Fraction(5) ** exponent < Fraction(2) ** (floor_log2 + 1)
    assert exponent * 217706 >> 16 == floor_log2 + exponent
    words += [bits >> 64, bits & (1 << 64) - 1]

print(f"""// SPDX-License-Identifier: MIT
// Powers of five to 128 bits.
// Printed by scripts/generate/powers_of_five.py; not edited by hand.
#pragma once

#include <cstdint>

namespace irg::detail {{

inline constexpr int lowest_power_of_five = {LOWEST}, highest_power_of_five = {HIGHEST};

/// The first 128 bits of 5^{LOWEST}, 5^{LOWEST + 1}, ..., 5^{HIGHEST}, the higher word first; what follows them is cut off.
inline constexpr std::uint64_t powers_of_five_to_128_bits[{len(words)}] = {{""")
for i in range(0, len(words), PER_LINE):
    print("    " + " ".join(f"0x{word:016x}," for word in words[i:i + PER_LINE]))
print("""};

}  // namespace irg::detail""")
