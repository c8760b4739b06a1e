// SPDX-License-Identifier: MIT
// irg's vectors and matrices beside GLM, Eigen and a plain struct: time and error of the same work in one table.
// Errors are measured against 113-bit arithmetic.
#include <irg/math/inverse.hpp>
#include <irg/math/length.hpp>
#include <irg/math/transform_points.hpp>
#include <irg/math/vector_batch.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "../tests/support/random.hpp"
#include "math/vec_mat.hpp"
#include "support/measure.hpp"

namespace bench {
namespace {

__extension__ typedef __float128 wide;

/// What people write themselves.
template <class T>
struct plain_library {
  struct v3 {
    T x, y, z;
  };
  struct v4 {
    T c[4];
  };
  struct m4 {
    T c[4][4];  // columns
  };
  static v3 make3(const std::array<T, 3>& c) { return {c[0], c[1], c[2]}; }
  static v4 make4(const std::array<T, 4>& c) { return {{c[0], c[1], c[2], c[3]}}; }
  static m4 make16(const std::array<T, 16>& c) {
    m4 m{};
    for (std::size_t i = 0; i < 16; ++i) m.c[i % 4][i / 4] = c[i];
    return m;
  }
  static T get3(const v3& v, int i) { return i == 0 ? v.x : i == 1 ? v.y : v.z; }
  static T get4(const v4& v, int i) { return v.c[i]; }
  static T get16(const m4& m, int i) { return m.c[i % 4][i / 4]; }
  static T dot(const v3& a, const v3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
  static v3 cross(const v3& a, const v3& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  }
  static T length(const v3& a) { return std::sqrt(dot(a, a)); }
  static v3 normalize(const v3& a) {
    const T f = T(1) / std::sqrt(dot(a, a));
    return {a.x * f, a.y * f, a.z * f};
  }
  static v4 apply(const m4& m, const v4& v) {
    v4 r;
    for (int i = 0; i < 4; ++i)
      r.c[i] = m.c[0][i] * v.c[0] + m.c[1][i] * v.c[1] + m.c[2][i] * v.c[2] + m.c[3][i] * v.c[3];
    return r;
  }
  static m4 multiply(const m4& a, const m4& b) {
    m4 r;
    for (int c = 0; c < 4; ++c)
      for (int i = 0; i < 4; ++i)
        r.c[c][i] = a.c[0][i] * b.c[c][0] + a.c[1][i] * b.c[c][1] + a.c[2][i] * b.c[c][2] + a.c[3][i] * b.c[c][3];
    return r;
  }
  // By twelve 2x2 minors (Laplace).
  static m4 inverse(const m4& m) {
    const auto& a = m.c;
    const T s0 = a[0][0] * a[1][1] - a[1][0] * a[0][1], s1 = a[0][0] * a[1][2] - a[1][0] * a[0][2],
            s2 = a[0][0] * a[1][3] - a[1][0] * a[0][3], s3 = a[0][1] * a[1][2] - a[1][1] * a[0][2],
            s4 = a[0][1] * a[1][3] - a[1][1] * a[0][3], s5 = a[0][2] * a[1][3] - a[1][2] * a[0][3],
            c5 = a[2][2] * a[3][3] - a[3][2] * a[2][3], c4 = a[2][1] * a[3][3] - a[3][1] * a[2][3],
            c3 = a[2][1] * a[3][2] - a[3][1] * a[2][2], c2 = a[2][0] * a[3][3] - a[3][0] * a[2][3],
            c1 = a[2][0] * a[3][2] - a[3][0] * a[2][2], c0 = a[2][0] * a[3][1] - a[3][0] * a[2][1];
    const T f = T(1) / (s0 * c5 - s1 * c4 + s2 * c3 + s3 * c2 - s4 * c1 + s5 * c0);
    return {{{(a[1][1] * c5 - a[1][2] * c4 + a[1][3] * c3) * f, (-a[0][1] * c5 + a[0][2] * c4 - a[0][3] * c3) * f,
              (a[3][1] * s5 - a[3][2] * s4 + a[3][3] * s3) * f, (-a[2][1] * s5 + a[2][2] * s4 - a[2][3] * s3) * f},
             {(-a[1][0] * c5 + a[1][2] * c2 - a[1][3] * c1) * f, (a[0][0] * c5 - a[0][2] * c2 + a[0][3] * c1) * f,
              (-a[3][0] * s5 + a[3][2] * s2 - a[3][3] * s1) * f, (a[2][0] * s5 - a[2][2] * s2 + a[2][3] * s1) * f},
             {(a[1][0] * c4 - a[1][1] * c2 + a[1][3] * c0) * f, (-a[0][0] * c4 + a[0][1] * c2 - a[0][3] * c0) * f,
              (a[3][0] * s4 - a[3][1] * s2 + a[3][3] * s0) * f, (-a[2][0] * s4 + a[2][1] * s2 - a[2][3] * s0) * f},
             {(-a[1][0] * c3 + a[1][1] * c1 - a[1][2] * c0) * f, (a[0][0] * c3 - a[0][1] * c1 + a[0][2] * c0) * f,
              (-a[3][0] * s3 + a[3][1] * s1 - a[3][2] * s0) * f, (a[2][0] * s3 - a[2][1] * s1 + a[2][2] * s0) * f}}};
  }
  static v3 transform(const m4& m, const v3& p) {
    return {m.c[0][0] * p.x + m.c[1][0] * p.y + m.c[2][0] * p.z + m.c[3][0],
            m.c[0][1] * p.x + m.c[1][1] * p.y + m.c[2][1] * p.z + m.c[3][1],
            m.c[0][2] * p.x + m.c[1][2] * p.y + m.c[2][2] * p.z + m.c[3][2]};
  }
};

template <class T>
struct irg_library {
  using v3 = irg::vec<T, 3>;
  using v4 = irg::vec<T, 4>;
  using m4 = irg::mat<T, 4, 4>;
  static v3 make3(const std::array<T, 3>& c) { return {c[0], c[1], c[2]}; }
  static v4 make4(const std::array<T, 4>& c) { return {c[0], c[1], c[2], c[3]}; }
  static m4 make16(const std::array<T, 16>& c) {
    m4 m;
    for (std::size_t i = 0; i < 16; ++i) m.m[i / 4][i % 4] = c[i];
    return m;
  }
  static T get3(const v3& v, int i) { return v[i]; }
  static T get4(const v4& v, int i) { return v[i]; }
  static T get16(const m4& m, int i) { return m(i / 4, i % 4); }
  static T dot(const v3& a, const v3& b) { return irg::dot(a, b); }
  static v3 cross(const v3& a, const v3& b) { return irg::cross(a, b); }
  static T length(const v3& a) { return irg::length(a); }
  static v3 normalize(const v3& a) { return irg::normalized(a); }
  static v4 apply(const m4& m, const v4& v) { return m * v; }
  static m4 multiply(const m4& a, const m4& b) { return a * b; }
  static m4 inverse(const m4& m) {
    const auto i = irg::inverse(m);
    return i ? *i : m4{};
  }
  static v3 transform(const m4& m, const v3& p) { return to_vec(transform_point(m, to_point(p))); }
};

/// irg's variants, and its forms for arrays.
template <class T>
void enter_irg_variants(vec_mat_entries& to, const vec_mat_input<T>& in) {
  using lib = irg_library<T>;
  using v3 = typename lib::v3;
  const auto a = converted<v3>(in.a, lib::make3), b = converted<v3>(in.b, lib::make3);
  const auto m = converted<typename lib::m4>(in.m, lib::make16);
  const std::size_t items = in.a.size();
  const auto number = [](T x, int) { return x; };
  enter<T>(to, "dot3", "irg:fast", items, 1, [=](std::size_t i) { return irg::dot_fast((*a)[i], (*b)[i]); }, number);
  enter<v3>(
      to, "cross", "irg:fast", items, 3, [=](std::size_t i) { return irg::cross_fast((*a)[i], (*b)[i]); }, lib::get3);
  enter_batch<T>(to, "dot3", "irg:batch", items, 1, [=](auto& out) { irg::dot_products(*a, *b, out); }, number);
  enter_batch<v3>(to, "cross", "irg:batch", items, 3, [=](auto& out) { irg::cross_products(*a, *b, out); }, lib::get3);
  enter<T>(to, "length", "irg:fast", items, 1, [=](std::size_t i) { return irg::length_fast((*a)[i]); }, number);
  enter<v3>(
      to, "normalize", "irg:fast", items, 3, [=](std::size_t i) { return irg::normalized_fast((*a)[i]); }, lib::get3);
  enter_batch<v3>(
      to, "normalize", "irg:batch", items, 3, [=](auto& out) { irg::normalize_vectors(*a, out); }, lib::get3);
  enter_batch<v3>(
      to, "normalize", "irg:batch fast", items, 3, [=](auto& out) { irg::normalize_vectors_fast(*a, out); }, lib::get3);
  enter<typename lib::m4, loop::one_at_a_time>(
      to, "inverse4", "irg:fast", items, 16, [=](std::size_t i) { return irg::inverse_fast((*m)[i]); }, lib::get16);
  enter<typename lib::m4, loop::one_at_a_time>(
      to, "inverse4", "irg:accurate", items, 16,
      [=](std::size_t i) {
        const auto inverse = irg::inverse_accurate((*m)[i]);
        return inverse ? *inverse : typename lib::m4{};
      },
      lib::get16);
  const auto affine = lib::make16(in.affine);
  const auto transform = [&](const std::string& kernel, const auto& points) {
    using p3 = irg::point<T, 3>;
    const auto p = converted<p3>(points, [](const std::array<T, 3>& c) { return p3{c[0], c[1], c[2]}; });
    enter_batch<p3>(
        to, kernel, "irg:batch", p->size(), 3, [=](auto& out) { irg::transform_points(affine, *p, out); },
        [](const p3& c, int i) { return c[i]; });
    const auto stream = [&](std::size_t k) {
      return converted<T>(points, [k](const std::array<T, 3>& c) { return c[k]; });
    };
    const auto x = stream(0), y = stream(1), z = stream(2);
    using streams = std::array<line_vector<T>, 3>;
    auto out = std::make_shared<streams>();
    for (auto& s : *out) s.resize(p->size());
    const auto results = [=] {
      std::vector<double> all;
      for (std::size_t i = 0; i < x->size(); ++i)
        for (const auto& s : *out) all.push_back(static_cast<double>(s[i]));
      return all;
    };
    to.push_back({kernel, "irg:streams", p->size(),
                  [=] {
                    irg::transform_points(affine, irg::point_streams<const T>{*x, *y, *z},
                                          irg::point_streams<T>{(*out)[0], (*out)[1], (*out)[2]});
                    clobber();
                  },
                  results});
    auto copy = std::make_shared<streams>(*out);
    to.push_back({kernel,
                  "limit:memcpy",
                  p->size(),
                  [=] {
                    for (std::size_t k = 0; k < 3; ++k)
                      std::memcpy((*copy)[k].data(), (k == 0 ? *x : k == 1 ? *y : *z).data(), x->size() * sizeof(T));
                    clobber();
                  },
                  {},
                  false});
  };
  transform("transform 4096", in.points_4096);
  transform("transform 1000000", in.points_million);
}

template <class T>
vec_mat_input<T> make_input() {
  test::random r(2026);
  const auto number = [&] { return static_cast<T>(2 * r.unit() - 1); };
  const auto fill = [&](auto& all, std::size_t n) {
    all.resize(n);
    for (auto& c : all)
      for (T& x : c) x = number();
  };
  vec_mat_input<T> in;
  fill(in.a, 256);
  fill(in.b, 256);
  fill(in.v, 256);
  fill(in.m, 256);
  fill(in.n, 256);
  for (auto& m : in.m)
    for (std::size_t i = 0; i < 4; ++i) m[5 * i] += m[5 * i] < 0 ? T(-2) : T(2);
  fill(in.points_4096, smoke() ? 100 : 4096);
  fill(in.points_million, smoke() ? 1000 : 1000000);
  for (std::size_t i = 0; i < 12; ++i) in.affine[i] = number();
  in.affine[15] = 1;
  return in;
}

/// The true results, and the size that an error is measured by: u times it, or the ulp at it.
struct truth {
  std::vector<wide> values, sizes;
  bool in_ulps = false;
};

std::string unit_of(const std::string& kernel) {
  return kernel == "normalize" || kernel == "length" ? "ulp"
         : kernel == "inverse4"                      ? "u x largest entry"
                                                     : "u x sum of |terms|";
}

wide magnitude(wide x) { return x < 0 ? -x : x; }

wide square_root(wide x) {
  wide s = static_cast<wide>(std::sqrt(static_cast<long double>(x)));
  s = (s + x / s) / 2;
  return s;
}

void add(truth& t, wide value, wide size) {
  t.values.push_back(value);
  t.sizes.push_back(size);
}

// The sum of x(k) * y(k), and of their absolute values.
template <class X, class Y>
void add_sum(truth& t, int terms, X x, Y y) {
  wide sum = 0, size = 0;
  for (int k = 0; k < terms; ++k) {
    const wide p =
        static_cast<wide>(x(static_cast<std::size_t>(k))) * static_cast<wide>(y(static_cast<std::size_t>(k)));
    sum += p;
    size += magnitude(p);
  }
  add(t, sum, size);
}

template <class T>
void add_inverse(truth& t, const std::array<T, 16>& m) {
  wide a[4][8] = {};
  for (std::size_t r = 0; r < 4; ++r) {
    for (std::size_t c = 0; c < 4; ++c) a[r][c] = static_cast<wide>(m[4 * r + c]);
    a[r][4 + r] = 1;
  }
  for (int k = 0; k < 4; ++k) {
    int pivot = k;
    for (int r = k; r < 4; ++r)
      if (magnitude(a[r][k]) > magnitude(a[pivot][k])) pivot = r;
    std::swap(a[k], a[pivot]);
    const wide p = a[k][k];
    for (wide& x : a[k]) x /= p;
    for (int r = 0; r < 4; ++r) {
      if (r == k) continue;
      const wide f = a[r][k];
      for (int c = 0; c < 8; ++c) a[r][c] -= f * a[k][c];
    }
  }
  wide largest = 0;
  for (int i = 0; i < 16; ++i) largest = std::max(largest, magnitude(a[i / 4][4 + i % 4]));
  for (int i = 0; i < 16; ++i) add(t, a[i / 4][4 + i % 4], largest);
}

template <class T>
truth true_results(const std::string& kernel, const vec_mat_input<T>& in) {
  truth t;
  const std::size_t items = in.a.size();
  if (kernel.starts_with("transform")) {
    for (const auto& p : kernel == "transform 4096" ? in.points_4096 : in.points_million)
      for (std::size_t r = 0; r < 3; ++r)
        add_sum(
            t, 4, [&](std::size_t k) { return in.affine[4 * r + k]; },
            [&](std::size_t k) { return k < 3 ? p[k] : T(1); });
    return t;
  }
  for (std::size_t i = 0; i < items; ++i) {
    const auto &a = in.a[i], &b = in.b[i];
    const auto &m = in.m[i], &n = in.n[i];
    if (kernel == "dot3") {
      add_sum(t, 3, [&](std::size_t k) { return a[k]; }, [&](std::size_t k) { return b[k]; });
    } else if (kernel == "cross") {
      for (std::size_t c = 0; c < 3; ++c) {
        const std::size_t d = (c + 1) % 3, e = (c + 2) % 3;
        add_sum(
            t, 2, [&](std::size_t k) { return k == 0 ? a[d] : -a[e]; },
            [&](std::size_t k) { return k == 0 ? b[e] : b[d]; });
      }
    } else if (kernel == "normalize" || kernel == "length") {
      t.in_ulps = true;
      wide square = 0;
      for (const T x : a) square += static_cast<wide>(x) * static_cast<wide>(x);
      if (kernel == "length") {
        add(t, square_root(square), 1);
        continue;
      }
      for (const T x : a) add(t, static_cast<wide>(x) / square_root(square), magnitude(static_cast<wide>(x)));
    } else if (kernel == "mat4*vec4") {
      for (std::size_t r = 0; r < 4; ++r)
        add_sum(t, 4, [&](std::size_t k) { return m[4 * r + k]; }, [&](std::size_t k) { return in.v[i][k]; });
    } else if (kernel == "mat4*mat4") {
      for (std::size_t r = 0; r < 16; ++r)
        add_sum(t, 4, [&](std::size_t k) { return m[r / 4 * 4 + k]; }, [&](std::size_t k) { return n[4 * k + r % 4]; });
    } else {
      add_inverse(t, m);
    }
  }
  return t;
}

template <class T>
errors errors_of(const std::vector<double>& results, const truth& t) {
  const double u = sizeof(T) == 4 ? 0x1p-24 : 0x1p-53;
  errors e{0, 0};
  for (std::size_t i = 0; i < results.size(); ++i) {
    const double error = static_cast<double>(magnitude(static_cast<wide>(results[i]) - t.values[i]));
    const double size = static_cast<double>(t.in_ulps ? magnitude(t.values[i]) : t.sizes[i]);
    const double unit = t.in_ulps ? std::ldexp(2 * u, std::ilogb(size)) : u * size;
    if (!(unit > 0)) continue;
    e.max = std::max(e.max, error / unit);
    e.mean += error / unit;
  }
  e.mean /= static_cast<double>(results.size());
  return e;
}

template <class T>
void enter_all() {
  const vec_mat_input<T>& in = keep(make_input<T>());
  vec_mat_entries all;
  enter_library<irg_library<T>>(all, in, "irg");
  enter_irg_variants(all, in);
  enter_glm(all, in);
  if constexpr (sizeof(T) == 4) enter_glm_simd(all, in);
  enter_eigen(all, in);
  enter_library<plain_library<T>>(all, in, "plain struct");
  for (const char* kernel : {"dot3", "cross", "length", "normalize", "mat4*vec4", "mat4*mat4", "inverse4",
                             "transform 4096", "transform 1000000"}) {
    auto& exact = keep_lazy([kernel, &in] { return true_results(kernel, in); });
    const bool points = std::string(kernel).starts_with("transform");
    contest c{kernel,
              std::string(sizeof(T) == 4 ? "float" : "double") + build_suffix(),
              points ? "point" : "operation",
              0,
              unit_of(kernel),
              points ? "limit:memcpy" : ""};
    for (const vec_mat_entry& e : all) {
      if (e.kernel != kernel) continue;
      c.items = static_cast<std::int64_t>(e.items);
      contender who{e.name, e.run};
      who.same_work = e.same_work;
      if (e.results) who.judge = [results = e.results, &exact] { return errors_of<T>(results(), *exact); };
      enter(c, std::move(who));
    }
  }
}

}  // namespace
}  // namespace bench

int main(int argc, char** argv) {
  bench::enter_all<float>();
  bench::enter_all<double>();
  return bench::run_benchmarks(argc, argv);
}
