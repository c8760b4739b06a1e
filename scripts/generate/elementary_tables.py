#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Prints the private tables of irg/math: trigonometry_tables.hpp, polynomial_tables.hpp or exponential_tables.hpp.

usage: scripts/generate/elementary_tables.py trigonometry|polynomial|exponential > include/irg/math/detail/..._tables.hpp
needs: python3-mpmath
"""
import re
import sys
from mpmath import (mp, mpf, asin, atan, cos, exp, floor, frexp, ldexp, log, lu_solve, matrix, nint, pi, sin, tan)

mp.prec = 1400


def rounded(x):
    """x rounded to double, as mpf."""
    return mpf(float(x))


def literal(x):
    return float(x).hex().replace("0x1.0000000000000p", "0x1p")


def pair(x):
    high = rounded(x)
    return literal(high), literal(x - high)


def on_grid(x, step):
    """x rounded to a multiple of step: a number short enough for exact products and sums."""
    return nint(x / step) * step


def fitted(function, degree, low, high):
    """Coefficients, low order first, of the polynomial through function at the Chebyshev nodes of [low, high]."""
    n = degree + 1
    nodes = [(low + high) / 2 + (high - low) / 2 * cos(pi * (2 * i + 1) / (2 * n)) for i in range(n)]
    with mp.workprec(400):
        solution = lu_solve(matrix([[x**j for j in range(n)] for x in nodes]), matrix([function(x) for x in nodes]))
    return [solution[i] for i in range(n)]


def rows(name, members, values, per_line, comment):
    """A constexpr array of structs or numbers."""
    print(f"/// {comment}")
    print(f"inline constexpr {members} {name}[{len(values)}] = {{")
    for i in range(0, len(values), per_line):
        print("    " + " ".join(v + "," for v in values[i:i + per_line]))
    print("};\n")


def polynomial(name, coefficients, comment):
    print(f"/// {comment}")
    print(f"inline constexpr double {name}[{len(coefficients)}] = {{")
    for i in range(0, len(coefficients), 4):
        print("    " + " ".join(literal(c) + "," for c in coefficients[i:i + 4]))
    print("};\n")


def constant(name, value, comment):
    print(f"/// {comment}\ninline constexpr double {name} = {literal(value)};\n")


def head(about, needed=None):
    print("// SPDX-License-Identifier: MIT")
    print(f"// {about}")
    print("// Printed by scripts/generate/elementary_tables.py; not edited by hand.")
    include = f"<irg/{needed}>" if needed else "<cstdint>"
    print(f"#pragma once\n\n#include {include}\n\nnamespace irg::detail {{\n")


def parts_of(name, x, bits, count, comment):
    """x as `count` numbers of at most `bits` bits and a rest: each times a short integer is exact."""
    values = []
    for _ in range(count):
        significand, exponent = frexp(x)
        part = ldexp(floor(ldexp(significand, bits)), exponent - bits)
        values.append(part)
        x -= part
    values.append(x)
    polynomial(name, values, comment)


def trigonometry():
    head("What sine, cosine and arctangent are made from.")
    parts_of("half_pi_parts", pi / 2, 33, 3, "pi/2 in three numbers of 33 bits and a rest.")
    high, low = pair(pi / 2)
    print("/// pi/2 as a double and its rounding error.")
    print(f"inline constexpr double half_pi_high = {high}, half_pi_low = {low};\n")
    high, low = pair(pi / 180)
    print("/// pi/180 as a double and its rounding error.")
    print(f"inline constexpr double degree_high = {high}, degree_low = {low};\n")
    high, low = pair(180 / pi)
    print("/// 180/pi as a double and its rounding error.")
    print(f"inline constexpr double radian_high = {high}, radian_low = {low};\n")
    constant("two_over_pi", 2 / pi, "2/pi.")

    words = [0, 0] + [int(floor(ldexp(2 / pi, 32 * (i + 1)))) % 2**32 for i in range(38)]
    rows("two_over_pi_words", "std::uint32_t", [f"0x{w:08x}u" for w in words], 8,
         "2/pi in base 2^32; the first two words, of weight 2^32 and 1, are zero.")

    def sine_tail(t):
        x = t**mpf("0.5")
        return (sin(x) - x) / x**3

    polynomial("sine_coefficients", fitted(sine_tail, 3, mpf("1e-60"), mpf("0.127")**2),
               "(sin x - x) / x^3 in powers of x^2 for |x| < 0.127.")

    reach = mpf("0.7856")**2
    polynomial("sine_wide_coefficients", fitted(sine_tail, 5, mpf("1e-60"), reach),
               "(sin x - x) / x^3 in powers of x^2 for |x| < 0.7856.")

    def cosine_tail(t):
        return (cos(t**mpf("0.5")) - 1 + t / 2) / t**2

    polynomial("cosine_wide_coefficients", fitted(cosine_tail, 5, mpf("1e-60"), reach),
               "(cos x - 1 + x^2/2) / x^4 in powers of x^2 for |x| < 0.7856.")

    def arctangent_tail(t):
        x = t**mpf("0.5")
        return (atan(x) - x) / x**3

    polynomial("arctangent_wide_coefficients", fitted(arctangent_tail, 11, mpf("1e-60"), mpf(1)),
               "(atan x - x) / x^3 in powers of x^2 for |x| <= 1, within 2^-34.")

    def arcsine_tail(t):
        x = t**mpf("0.5")
        return (asin(x) - x) / x**3

    polynomial("arcsine_wide_coefficients", fitted(arcsine_tail, 7, mpf("1e-60"), mpf("0.25")),
               "(asin x - x) / x^3 in powers of x^2 for |x| <= 1/2, within 2^-37.")

    print("struct sine_cosine_row {\n  double sine, sine_low, cosine, cosine_low;\n};")
    values = ["{" + ", ".join(pair(sin(mpf(i) / 128)) + pair(cos(mpf(i) / 128))) + "}" for i in range(102)]
    rows("sine_cosine_table", "sine_cosine_row", values, 1, "Sine and cosine of i/128, each with its rounding error.")

    print("struct number_pair {\n  double high, low;\n};")
    values = ["{" + ", ".join(pair(atan(mpf(i) / 64))) + "}" for i in range(65)]
    rows("arctangent_table", "number_pair", values, 2, "The arctangent of i/64 with its rounding error.")
    print("}  // namespace irg::detail")


STEP = mpf(1) / 64
# Of the coefficient of x^(k+2) this many bits count where |x| <= 1/128.
COEFFICIENT_BITS = (53, 53, 49, 41, 33, 29, 21)


def shortened(x, bits):
    """x rounded to so many bits."""
    return mpf(0) if x == 0 else on_grid(x, ldexp(mpf(1), frexp(x)[1] - bits))


def local_coefficients(function, i):
    """(f(c + x) - f(c) - x) / x in powers of x for |x| <= 1/128 about c = i/64."""
    c, reach = i * STEP, STEP / 2
    if i > 0:
        return fitted(lambda x: (function(c + x) - function(c) - x) / x, 6, -reach, reach + mpf("1e-60"))
    # An odd function, fitted relative to its size.
    odd = fitted(lambda t: (function(t**mpf("0.5")) / t**mpf("0.5") - 1) / t, 2, mpf("1e-60"), reach**2)
    return [mpf(0), mpf(0), odd[0], mpf(0), odd[1], mpf(0), odd[2]]


def local_polynomials(name, function, count, title):
    print(f"/// ({title}(c + x) - {title} c - x) / x in powers of x for |x| <= 1/128 about c = i/64.")
    print(f"inline constexpr local_polynomial {name}_polynomials[{count}] = {{")
    for i in range(count):
        texts = [literal(shortened(c, bits)) if c else "0"
                 for c, bits in zip(local_coefficients(function, i), COEFFICIENT_BITS)]
        texts = [re.sub(r"0+p", "p", t).replace(".p", "p") if "." in t else t for t in texts]
        print("    {{" + ", ".join(texts) + "}},")
    print("};\n")


def polynomial_tables():
    head("The tangent, the arctangent and the arcsine beside the multiples of 1/64.", "math/detail/trigonometry_tables.hpp")
    print("/// Seven coefficients, low order first. Of the later ones fewer bits count.")
    print("struct local_polynomial {\n  double c[7];\n};\n")
    for name, function, count, title in (("tangent", tan, 51, "tan"), ("arcsine", asin, 33, "asin")):
        values = ["{" + ", ".join(pair(function(mpf(i) / 64))) + "}" for i in range(count)]
        rows(f"{name}_table", "number_pair", values, 2, f"The {name} of i/64 with its rounding error.")
    for name, function, count, title in (("tangent", tan, 51, "tan"), ("arctangent", atan, 65, "atan"),
                                         ("arcsine", asin, 33, "asin")):
        local_polynomials(name, function, count, title)
    print("}  // namespace irg::detail")


LOG_FIRST = 0x3FE6100000000000  # the bits where the logarithm's table begins: 1 is in the middle of an interval


def interval(i):
    """The bounds of table interval i, whose significands stand in [0.69, 1.38)."""
    def value(bits):
        fraction = mpf((bits & (2**52 - 1)) + 2**52) / 2**52
        return ldexp(fraction, (bits >> 52) - 1023)
    first = LOG_FIRST + (i << 45)
    return value(first), value(first + (1 << 45))


def exponential():
    head("What powers and logarithms are made from.")
    grid = ldexp(mpf(1), -42)
    step = on_grid(log(2) / 128, ldexp(mpf(1), -42))
    print("/// ln(2)/128 as a number of 35 bits, short enough for exact products with 18-bit integers, and its error.")
    print(f"inline constexpr double exp_step_high = {literal(step)}, exp_step_low = {literal(log(2) / 128 - step)};\n")
    constant("exp_steps_per_unit", 128 / log(2), "128/ln(2).")
    constant("natural_log_of_two", log(2), "ln(2).")
    ln2 = on_grid(log(2), grid)
    print("/// ln(2) as a multiple of 2^-42 and the error.")
    print(f"inline constexpr double log_two_high = {literal(ln2)}, log_two_low = {literal(log(2) - ln2)};\n")
    for name, base in (("two", 2), ("ten", 10)):
        high, low = pair(1 / log(base))
        print(f"/// 1/ln({base}) as a double and its rounding error.")
        print(f"inline constexpr double inverse_log_{name}_high = {high}, inverse_log_{name}_low = {low};\n")

    reach = log(2) / 256 * mpf("1.01")

    def exp_tail(x):
        return (exp(x) - 1 - x) / x**2

    polynomial("exp_coefficients", fitted(exp_tail, 3, -reach, reach + mpf("1e-60")),
               "(e^x - 1 - x) / x^2 for |x| <= ln(2)/256.")

    print("struct exp_row {\n  double power, power_low;\n};")
    values = ["{" + ", ".join(pair(mpf(2)**(mpf(i) / 128))) + "}" for i in range(128)]
    rows("exp_table", "exp_row", values, 2, "2^(i/128) with its rounding error.")

    log_rows, worst = [], mpf(0)
    for i in range(128):
        low, high = interval(i)
        # Around 1 the logarithm must be r itself, so that it stays accurate relative to its size.
        c = mpf(1) if low <= 1 < high else on_grid(2 / (low + high), ldexp(mpf(1), -10))
        worst = max(worst, abs(low * c - 1), abs(high * c - 1))
        logarithm = -log(c)
        short = on_grid(logarithm, grid)
        log_rows.append("{" + ", ".join((literal(c), literal(short), literal(logarithm - short))) + "}")
    reach = worst * mpf("1.01")

    def log_tail(x):
        return (log(1 + x) - x + x**2 / 2) / x**3

    polynomial("log_coefficients", fitted(log_tail, 5, -reach, reach + mpf("1e-60")),
               f"(ln(1 + x) - x + x^2/2) / x^3 for |x| <= {float(worst):.5f}.")
    for name, degree in (("three", 2), ("four", 3)):
        polynomial(f"log_{name}_coefficients",
                   fitted(lambda x: (log(1 + x) - x) / x**2, degree, -reach, reach + mpf("1e-40")),
                   f"(ln(1 + x) - x) / x^2 for |x| <= {float(worst):.5f}.")
    print("/// The bits of the double, and of the float, where the first interval of log_table begins.")
    print(f"inline constexpr std::uint64_t log_table_first = 0x{LOG_FIRST:016x}u;")
    single = (LOG_FIRST >> 29) - ((1023 - 127) << 23)
    print(f"inline constexpr std::uint32_t log_table_first_single = 0x{single:08x}u;\n")
    print("struct log_row {\n  double inverse, log, log_low;\n};")
    rows("log_table", "log_row", log_rows, 1,
         "For each interval: about 1/its middle, in 10 bits; minus its logarithm, on a grid of 2^-42; the error.")

    polynomial("cbrt_coefficients", fitted(lambda x: x**(mpf(1) / 3), 3, mpf(1), mpf(2)),
               "x^(1/3) for 1 <= x <= 2, within 2^-11.")
    print("/// 2^(i/3).")
    powers = ", ".join(literal(mpf(2)**(mpf(i) / 3)) for i in range(3))
    print("inline constexpr double cbrt_of_power[3] = {" + powers + "};\n")
    print("}  // namespace irg::detail")


if __name__ == "__main__":
    tables = {"trigonometry": trigonometry, "polynomial": polynomial_tables, "exponential": exponential}
    if len(sys.argv) != 2 or sys.argv[1] not in tables:
        sys.exit(__doc__)
    tables[sys.argv[1]]()
