// SPDX-License-Identifier: MIT
// Run time against error of sums of products, cross products, polynomials, roots and areas, on input whose difficulty
// is set: every implementation computes the same numbers, and MPFR tells how far off they are.
#include <irg/geometry/triangle_area.hpp>
#include <irg/math/compensated.hpp>
#include <irg/math/constants.hpp>
#include <irg/math/double_double.hpp>
#include <irg/math/polynomial.hpp>
#include <irg/math/roots.hpp>
#include <irg/math/vec.hpp>

#include <array>
#include <cmath>

#include "../tests/support/random.hpp"
#include "support/measure.hpp"

#ifdef IRG_HAVE_MPFR
#include <mpfr.h>
#endif

namespace bench {
namespace {

/// What one call gives: up to three numbers, and how many.
struct answer {
  std::array<double, 3> value{};
  int count = 0;
};

/// One implementation, run over all of the input.
template <class Input>
struct variant {
  std::string name;
  std::function<void(const std::vector<Input>&, std::vector<answer>&)> run;
};
template <class Input, class F>
variant<Input> variant_of(const char* name, F f) {
  return {name, [f](const std::vector<Input>& in, std::vector<answer>& out) {
            for (std::size_t i = 0; i < in.size(); ++i) out[i] = f(in[i]);
          }};
}
answer of(double x) { return {{x, 0, 0}, 1}; }
template <class V>
answer of_vector(const V& v) {
  return {{v.x, v.y, v.z}, 3};
}
template <class Roots>
answer of_roots(const Roots& r) {
  answer a;
  for (int i = 0; i < r.count; ++i) a.value[static_cast<std::size_t>(i)] = r.root[i];
  a.count = r.count;
  return a;
}

/// An exact answer as two doubles a number, good for ulps.
struct exact_answer {
  std::array<double, 3> high{}, low{};
  int count = 0;
};

struct errors {
  double largest = 0, sum = 0;
  int numbers = 0, wrong = 0;
};

void count_errors(errors& e, const answer& got, const exact_answer& exact) {
  if (got.count != exact.count) {
    ++e.wrong;
    return;
  }
  for (std::size_t i = 0; i < static_cast<std::size_t>(got.count); ++i) {
    int exponent = 0;
    std::frexp(exact.high[i], &exponent);
    const double error = std::fabs((got.value[i] - exact.high[i]) - exact.low[i]) * std::ldexp(1.0, 53 - exponent);
    if (!(error < 1e300)) {
      ++e.wrong;
      continue;
    }
    e.largest = std::max(e.largest, error);
    e.sum += error;
    ++e.numbers;
  }
}

template <class Input, class Oracle>
void compare(const char* kernel, const std::string& test_case, const std::vector<Input>& in, const Oracle& oracle,
             const std::vector<variant<Input>>& variants) {
  std::vector<answer> out(in.size());
  std::vector<contender> contenders;
  for (const auto& v : variants) contenders.push_back({v.name, [&] { v.run(in, out); }});
  race(contenders, 31, 2e-4);
  std::vector<exact_answer> exact;
  for (const Input& i : in) exact.push_back(oracle(i));
  std::printf("%s, %s\n", kernel, test_case.c_str());
  for (std::size_t k = 0; k < variants.size(); ++k) {
    errors e;
    variants[k].run(in, out);
    for (std::size_t i = 0; i < in.size(); ++i) count_errors(e, out[i], exact[i]);
    const double ns = contenders[k].median() * 1e9 / static_cast<double>(in.size());
    const double mean = e.numbers > 0 ? e.sum / e.numbers : 0;
    std::printf("  %-28s %8.1f ns  max %9.3g ulp  mean %9.3g  wrong %d\n", variants[k].name.c_str(), ns, e.largest,
                mean, e.wrong);
    row r;
    r.kernel = kernel;
    r.test_case = test_case;
    r.implementation = variants[k].name;
    r.ns_per_item = ns;
    r.items = static_cast<std::int64_t>(in.size());
    r.item = "call";
#ifdef IRG_HAVE_MPFR
    r.max_error = number(e.largest);
    r.mean_error = number(mean);
    r.error_unit = "ulp";
    r.wrong = number(e.wrong);
#endif
    report(r);
  }
}

std::size_t input_size() { return smoke() ? 20 : 500; }

template <class Input, class Make>
std::vector<Input> inputs(std::uint64_t seed, Make make) {
  test::random r(seed);
  std::vector<Input> in;
  while (in.size() < input_size()) in.push_back(make(r));
  return in;
}

/// A number from 1/4 to 4 with any sign, and one from 1/2 to 1.
double some(test::random& r) {
  const double x = std::ldexp(1 + r.unit(), static_cast<int>(r.integer(-2, 1)));
  return (r.next() & 1u) != 0 ? x : -x;
}
double step(test::random& r, int exponent) { return std::ldexp(r.unit() - 0.5, exponent); }

#ifdef IRG_HAVE_MPFR
/// A number of 4000 bits.
struct real {
  mpfr_t v;
  real() { mpfr_init2(v, 4000), mpfr_set_zero(v, 1); }
  real(const real&) = delete;
  real& operator=(const real&) = delete;
  ~real() { mpfr_clear(v); }
  void add_product(double x, double y) {
    static real term;
    mpfr_set_d(term.v, x, MPFR_RNDN), mpfr_mul_d(term.v, term.v, y, MPFR_RNDN), mpfr_add(v, v, term.v, MPFR_RNDN);
  }
  void horner(std::initializer_list<double> descending, double x) {
    for (const double c : descending) mpfr_mul_d(v, v, x, MPFR_RNDN), mpfr_add_d(v, v, c, MPFR_RNDN);
  }
};
void put(exact_answer& a, const real& x) {
  static real rest;
  const auto i = static_cast<std::size_t>(a.count++);
  a.high[i] = mpfr_get_d(x.v, MPFR_RNDN);
  mpfr_sub_d(rest.v, x.v, a.high[i], MPFR_RNDN);
  a.low[i] = mpfr_get_d(rest.v, MPFR_RNDN);
}
#endif

using v3 = irg::vec<double, 3>;
struct two_vectors {
  v3 a, b;
};

exact_answer exact_dot(const two_vectors& in) {
  exact_answer a;
#ifdef IRG_HAVE_MPFR
  real sum;
  for (int i = 0; i < 3; ++i) sum.add_product(in.a[i], in.b[i]);
  put(a, sum);
#else
  a.count = 1, a.high[0] = irg::dot_exact(in.a, in.b);
#endif
  return a;
}

irg::double_double dot_in_double_double(const two_vectors& in) {
  irg::double_double sum = irg::double_double(in.a.x) * in.b.x;
  sum += irg::double_double(in.a.y) * in.b.y;
  return sum + irg::double_double(in.a.z) * in.b.z;
}

void dots() {
  for (const int cancelled : {0, 27, 44, 80}) {
    const auto in = inputs<two_vectors>(1, [&](test::random& r) {
      v3 a{some(r), some(r), some(r)}, b{some(r), some(r), 0};
      const double rest = irg::dot_exact(a, b) / a.z;
      b.z = cancelled == 0 ? some(r) : -rest * (1 + step(r, -cancelled));
      return two_vectors{a, b};
    });
    compare<two_vectors>(
        "dot", cancelled == 0 ? "random" : "cancels 2^" + std::to_string(cancelled), in, exact_dot,
        {variant_of<two_vectors>("irg", [](const auto& i) { return of(irg::dot(i.a, i.b)); }),
         variant_of<two_vectors>("irg:accurate", [](const auto& i) { return of(irg::dot_accurate(i.a, i.b)); }),
         variant_of<two_vectors>("irg:exact", [](const auto& i) { return of(irg::dot_exact(i.a, i.b)); }),
         variant_of<two_vectors>("double_double",
                                 [](const auto& i) { return of(static_cast<double>(dot_in_double_double(i))); })});
  }
}

exact_answer exact_cross(const two_vectors& in) {
  exact_answer a;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
#ifdef IRG_HAVE_MPFR
    real sum;
    sum.add_product(in.a[j], in.b[k]), sum.add_product(-in.a[k], in.b[j]);
    put(a, sum);
#else
    a.high[static_cast<std::size_t>(a.count++)] = irg::difference_of_products(in.a[j], in.b[k], in.a[k], in.b[j]);
#endif
  }
  return a;
}

void crosses() {
  for (const int apart : {0, 26, 52}) {
    const auto in = inputs<two_vectors>(2, [&](test::random& r) {
      const v3 a{some(r), some(r), some(r)};
      const auto near = [&](double x) { return apart == 0 ? some(r) : x * 0.75 + step(r, -apart); };
      const double x = near(a.x), y = near(a.y), z = near(a.z);
      return two_vectors{a, {x, y, z}};
    });
    compare<two_vectors>(
        "cross", apart == 0 ? "random" : "parallel to 2^-" + std::to_string(apart), in, exact_cross,
        {variant_of<two_vectors>("irg", [](const auto& i) { return of_vector(irg::cross(i.a, i.b)); }),
         variant_of<two_vectors>("irg:accurate",
                                 [](const auto& i) { return of_vector(irg::cross_accurate(i.a, i.b)); }),
         variant_of<two_vectors>("irg:exact", [](const auto& i) { return of_vector(irg::cross_exact(i.a, i.b)); })});
  }
}

struct polynomial_at {
  std::array<double, 6> c;
  double x;
};

void polynomials() {
  for (const int near : {0, 20, 50}) {
    const auto in = inputs<polynomial_at>(3, [&](test::random& r) {
      polynomial_at p{{1, 5, 10, 10, 5, 1}, -1 + step(r, -near)};  // (x + 1)^5
      if (near == 0) {
        for (double& c : p.c) c = some(r);
        p.x = some(r);
      }
      return p;
    });
    const auto oracle = [](const polynomial_at& p) {
      exact_answer a;
#ifdef IRG_HAVE_MPFR
      real value;
      value.horner({p.c[5], p.c[4], p.c[3], p.c[2], p.c[1], p.c[0]}, p.x);
      put(a, value);
#else
      a.count = 1, a.high[0] = irg::evaluate_polynomial_exact(p.c, p.x);
#endif
      return a;
    };
    compare<polynomial_at>(
        "polynomial", near == 0 ? "random, degree 5" : "2^-" + std::to_string(near) + " from a fivefold root", in,
        oracle,
        {variant_of<polynomial_at>("irg", [](const auto& p) { return of(irg::evaluate_polynomial(p.c, p.x)); }),
         variant_of<polynomial_at>("irg:accurate",
                                   [](const auto& p) { return of(irg::evaluate_polynomial_accurate(p.c, p.x)); }),
         variant_of<polynomial_at>("irg:exact",
                                   [](const auto& p) { return of(irg::evaluate_polynomial_exact(p.c, p.x)); }),
         variant_of<polynomial_at>("double_double", [](const auto& p) {
           irg::double_double v(0.0);
           for (std::size_t i = 6; i-- > 0;) v = v * p.x + p.c[i];
           return of(static_cast<double>(v));
         })});
  }
}

using three = std::array<double, 3>;
using four = std::array<double, 4>;

exact_answer exact_quadratic(const three& p) {
  exact_answer a;
#ifdef IRG_HAVE_MPFR
  const auto [c, b, lead] = p;
  real d, x;
  d.add_product(b, b), d.add_product(-4 * lead, c);
  if (mpfr_sgn(d.v) < 0) return a;
  mpfr_sqrt(d.v, d.v, MPFR_RNDN);
  for (const int sign : {lead > 0 ? -1 : 1, lead > 0 ? 1 : -1}) {
    mpfr_mul_si(x.v, d.v, sign, MPFR_RNDN), mpfr_sub_d(x.v, x.v, b, MPFR_RNDN);
    mpfr_div_d(x.v, x.v, 2 * lead, MPFR_RNDN);
    put(a, x);
    if (mpfr_zero_p(d.v)) break;
  }
#else
  const auto r = irg::quadratic_roots(p[2], p[1], p[0]);
  a.count = r.count;
  for (int i = 0; i < r.count; ++i) a.high[static_cast<std::size_t>(i)] = r.root[i];
#endif
  return a;
}

/// The form of pbrt-v4's Quadratic, with a fused multiply-add.
answer quadratic_as_pbrt(const three& p) {
  const auto [c, b, a] = p;
  const double cd = 4 * a * c;
  const double discriminant = std::fma(b, b, -cd) + std::fma(-4 * a, c, cd);
  if (discriminant < 0) return {};
  const double root = std::sqrt(discriminant), q = -0.5 * (b + std::copysign(root, b));
  const double x = q / a, y = c / q;
  return {{std::min(x, y), std::max(x, y), 0}, discriminant == 0 ? 1 : 2};
}

void quadratics() {
  const auto run = [](const std::string& name, const std::vector<three>& in) {
    compare<three>(
        "quadratic", name, in, exact_quadratic,
        {variant_of<three>("irg", [](const auto& p) { return of_roots(irg::quadratic_roots(p[2], p[1], p[0])); }),
         variant_of<three>("irg:fast",
                           [](const auto& p) { return of_roots(irg::quadratic_roots_fast(p[2], p[1], p[0])); }),
         variant_of<three>("irg:textbook",
                           [](const auto& p) { return of_roots(irg::quadratic_roots_textbook(p[2], p[1], p[0])); }),
         variant_of<three>("pbrt's form", quadratic_as_pbrt)});
  };
  for (const int ratio : {0, 13, 26, 50})
    run("roots 2^" + std::to_string(ratio) + " apart", inputs<three>(4, [&](test::random& r) {
          const double a = some(r), x = some(r), y = std::ldexp(some(r), ratio);
          return three{a * x * y, -a * (x + y), a};
        }));
  for (const int near : {20, 50})
    run("double to 2^-" + std::to_string(near), inputs<three>(5, [&](test::random& r) {
          const double a = some(r), x = some(r);
          return three{a * x * x * (1 + step(r, -near)), -2 * a * x, a};
        }));
}

exact_answer exact_cubic(const four& p) {
  exact_answer a;
  const auto found = irg::cubic_roots(p[3], p[2], p[1], p[0]);  // its number of roots is exact, as the tests show
#ifdef IRG_HAVE_MPFR
  for (int i = 0; i < found.count; ++i) {  // Newton's iteration in 4000 bits, twelve times
    real x, value, slope;
    mpfr_set_d(x.v, found.root[i], MPFR_RNDN);
    for (int k = 0; k < 12; ++k) {
      mpfr_set_zero(value.v, 1), mpfr_set_zero(slope.v, 1);
      for (std::size_t j = 4; j-- > 0;) {
        mpfr_mul(slope.v, slope.v, x.v, MPFR_RNDN), mpfr_add(slope.v, slope.v, value.v, MPFR_RNDN);
        mpfr_mul(value.v, value.v, x.v, MPFR_RNDN), mpfr_add_d(value.v, value.v, p[j], MPFR_RNDN);
      }
      if (mpfr_zero_p(slope.v)) break;
      mpfr_div(value.v, value.v, slope.v, MPFR_RNDN), mpfr_sub(x.v, x.v, value.v, MPFR_RNDN);
    }
    put(a, x);
  }
#else
  a.count = found.count;
  for (int i = 0; i < found.count; ++i) a.high[static_cast<std::size_t>(i)] = found.root[i];
#endif
  return a;
}

/// Cardano's formula, with cosines where there are three roots.
answer cubic_as_cardano(const four& p) {
  const double b = p[2] / p[3], c = p[1] / p[3], d = p[0] / p[3];
  const double q = (b * b - 3 * c) / 9, r = (2 * b * b * b - 9 * b * c + 27 * d) / 54, middle = b / 3;
  if (r * r < q * q * q) {
    const double angle = std::acos(r / std::sqrt(q * q * q)), size = -2 * std::sqrt(q);
    answer a{{size * std::cos(angle / 3) - middle, size * std::cos((angle + 2 * irg::pi<double>) / 3) - middle,
              size * std::cos((angle - 2 * irg::pi<double>) / 3) - middle},
             3};
    std::sort(a.value.begin(), a.value.end());
    return a;
  }
  const double s = -std::copysign(std::cbrt(std::fabs(r) + std::sqrt(r * r - q * q * q)), r);
  return of((s + (s == 0 ? 0 : q / s)) - middle);
}

void cubics() {
  const auto run = [](const std::string& name, const std::vector<four>& in) {
    compare<four>(
        "cubic", name, in, exact_cubic,
        {variant_of<four>("irg", [](const auto& p) { return of_roots(irg::cubic_roots(p[3], p[2], p[1], p[0])); }),
         variant_of<four>("Cardano's formula", cubic_as_cardano)});
  };
  run("random", inputs<four>(6, [](test::random& r) { return four{some(r), some(r), some(r), some(r)}; }));
  for (const int near : {0, 20, 40})
    run(near == 0 ? "three roots" : "two roots 2^-" + std::to_string(near) + " apart",
        inputs<four>(7, [&](test::random& r) {
          const double x = some(r), y = near == 0 ? some(r) : x * (1 + step(r, -near)), z = some(r);
          return four{-x * y * z, x * y + y * z + z * x, -(x + y + z), 1};
        }));
}

struct triangle {
  irg::point<double, 2> a, b, c;
};

void areas() {
  for (const int offset : {0, 20, 40}) {
    const auto in = inputs<triangle>(8, [&](test::random& r) {
      const double far = offset == 0 ? 0 : std::ldexp(1.0, offset);
      const auto at = [&] { return far + step(r, 1); };
      const irg::point<double, 2> a{at(), at()}, b{at(), at()}, c{at(), at()};
      return triangle{a, b, c};
    });
    const auto oracle = [](const triangle& t) {
      exact_answer a;
#ifdef IRG_HAVE_MPFR
      real sum;
      sum.add_product(0.5 * t.a.x, t.b.y), sum.add_product(-0.5 * t.a.y, t.b.x), sum.add_product(0.5 * t.b.x, t.c.y);
      sum.add_product(-0.5 * t.b.y, t.c.x), sum.add_product(0.5 * t.c.x, t.a.y), sum.add_product(-0.5 * t.c.y, t.a.x);
      put(a, sum);
#else
      a.count = 1, a.high[0] = irg::signed_triangle_area(t.a, t.b, t.c);
#endif
      return a;
    };
    compare<triangle>(
        "triangle area", offset == 0 ? "at the origin" : "2^" + std::to_string(offset) + " away", in, oracle,
        {variant_of<triangle>("irg", [](const auto& t) { return of(irg::signed_triangle_area(t.a, t.b, t.c)); }),
         variant_of<triangle>("irg:fast",
                              [](const auto& t) { return of(irg::signed_triangle_area_fast(t.a, t.b, t.c)); }),
         variant_of<triangle>("shoelace", [](const auto& t) {
           return of(0.5 * ((t.a.x * t.b.y - t.a.y * t.b.x) + (t.b.x * t.c.y - t.b.y * t.c.x) +
                            (t.c.x * t.a.y - t.c.y * t.a.x)));
         })});
  }
}

}  // namespace
}  // namespace bench

int main() {
  bench::stay_on_this_processor();
  bench::dots();
  bench::crosses();
  bench::polynomials();
  bench::quadratics();
  bench::cubics();
  bench::areas();
}
