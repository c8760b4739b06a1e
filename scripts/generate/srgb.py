#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Prints include/irg/colour/detail/srgb_tables.hpp: the sRGB curve of IEC 61966-2-1 as correctly rounded floats.

The curve is evaluated with 60 decimal digits, and every value is checked to be further than 1e-20 of itself from the
number where its rounding would change. Needs Python alone:

  scripts/generate/srgb.py > include/irg/colour/detail/srgb_tables.hpp
"""
import struct
from decimal import Decimal, getcontext
from fractions import Fraction

getcontext().prec = 60
MARGIN = Fraction(1, 10**20)  # relative; far above the error of 60 digits


def decoded(s):
    """The light of the encoded value s."""
    return s / Decimal("12.92") if s <= Decimal("0.04045") else ((s + Decimal("0.055")) / Decimal("1.055")) ** Decimal("2.4")


def neighbours(x):
    """The two adjacent floats around the positive real number x, which is no float itself."""
    bits = struct.unpack("<I", struct.pack("<f", float(x)))[0]
    value = lambda b: Fraction(struct.unpack("<f", struct.pack("<I", b))[0])
    while value(bits) > x:
        bits -= 1
    while value(bits + 1) <= x:
        bits += 1
    low, high = value(bits), value(bits + 1)
    assert x - low > MARGIN * x and high - x > MARGIN * x, "more digits needed"
    return low, high


def nearest(x):
    if x in (0, 1):
        return x
    low, high = neighbours(x)
    assert abs((low + high) / 2 - x) > MARGIN * x, "more digits needed"
    return low if x - low < high - x else high


def literal(x):
    mantissa, exponent = float(x).hex().split("p")
    digits = mantissa.rstrip("0").rstrip(".") if "." in mantissa else mantissa
    return f"{digits}p{int(exponent)}f" if x else "0"


def rows(values):
    line, lines = "   ", []
    for v in map(literal, values):
        if len(line) + len(v) + 2 > 120:
            lines.append(line)
            line = "   "
        line += f" {v},"
    return "\n".join(lines + [line])


light = [nearest(Fraction(decoded(Decimal(k) / 255))) for k in range(256)]
threshold = [neighbours(Fraction(decoded((Decimal(k) - Decimal("0.5")) / 255)))[1] for k in range(1, 256)]
print(f"""// SPDX-License-Identifier: MIT
// The sRGB curve as exact floats. Written by scripts/generate/srgb.py; change that, not this.
#pragma once

// clang-format off
namespace irg::detail {{

/// The light of each 8-bit code, rounded to the nearest float.
inline constexpr float srgb_light[256] = {{
{rows(light)}
}};

/// Entry k: the smallest float whose code is k or more. Entry 0 is 0; the last, past every code, is 1.
inline constexpr float srgb_threshold[257] = {{
{rows([Fraction(0)] + threshold + [Fraction(1)])}
}};

}}  // namespace irg::detail
// clang-format on""")
