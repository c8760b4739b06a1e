// SPDX-License-Identifier: MIT
#include <irg/math/transform_points.hpp>

#include <array>
#include <cstdlib>
#include <vector>

#include "support/check_both.hpp"
#include "support/random.hpp"
#include "support/same_bits.hpp"

using irg::hpoint;
using irg::mat;
using irg::point;
using irg::transform_points;
using irg::transform_vectors;
using irg::vec;
using test::same_bits;

namespace {

template <class T>
T number(test::random& r) {
  if (r.integer(0, 200) == 0) return std::numeric_limits<T>::infinity();
  if (r.integer(0, 200) == 0) return std::numeric_limits<T>::quiet_NaN();
  if (r.integer(0, 100) == 0) return -T(0);
  return static_cast<T>(2 * r.unit() - 1);
}
template <class T>
mat<T, 4, 4> matrix(test::random& r) {
  mat<T, 4, 4> a;
  for (auto& row : a.m)
    for (T& entry : row) entry = static_cast<T>(2 * r.unit() - 1);
  return a;
}
template <class V>
std::vector<V> many(test::random& r, std::size_t n) {
  std::vector<V> all(n, V{});
  for (V& v : all)
    for (int i = 0; i < irg::size_of<V>; ++i) v[i] = number<irg::scalar_of<V>>(r);
  return all;
}

// n results at an odd address, between guards that stay as they are; each compared with one(i).
template <class Out, class Run, class One>
int wrong_of(std::size_t n, std::size_t offset, Run run, One one) {
  const Out guard = irg::generate_coordinates<Out>([](int i) { return i + 77; });
  std::vector<Out> out(n + 2 + offset, guard);
  run(std::span<Out>(out).subspan(1 + offset, n));
  int wrong = 0;
  for (std::size_t i = 0; i <= offset; ++i) wrong += !same_bits(out[i], guard);
  wrong += !same_bits(out[n + 1 + offset], guard);
  for (std::size_t i = 0; i < n; ++i) wrong += !same_bits(out[i + 1 + offset], one(i));
  return wrong;
}

template <class T>
int wrong_results(std::size_t n, std::size_t offset, test::random& r) {
  const mat<T, 4, 4> a = matrix<T>(r);
  const auto p = many<point<T, 3>>(r, n);
  const auto v = many<vec<T, 3>>(r, n);
  const auto h = many<hpoint<T, 3>>(r, n);
  const auto at = [&](std::size_t i) { return transform_point(a, p[i]); };
  int wrong = 0;
  wrong += wrong_of<point<T, 3>>(n, offset, [&](auto out) { transform_points(a, p, out); }, at);
  wrong += wrong_of<vec<T, 3>>(
      n, offset, [&](auto out) { transform_vectors(a, v, out); },
      [&](std::size_t i) { return transform_vector(a, v[i]); });
  wrong += wrong_of<hpoint<T, 3>>(
      n, offset, [&](auto out) { transform_points(a, p, out); }, [&](std::size_t i) { return a * p[i]; });
  wrong += wrong_of<hpoint<T, 3>>(
      n, offset, [&](auto out) { transform_points(a, h, out); }, [&](std::size_t i) { return a * h[i]; });
  // In place.
  auto q = p;
  transform_points(a, q, q);
  auto w = v;
  transform_vectors(a, w, w);
  auto g = h;
  transform_points(a, g, g);
  for (std::size_t i = 0; i < n; ++i)
    wrong += !same_bits(q[i], at(i)) + !same_bits(w[i], transform_vector(a, v[i])) + !same_bits(g[i], a * h[i]);
  // Streams that begin anywhere, with guards; then in place.
  std::vector<T> s[6];
  for (auto& stream : s) stream.assign(n + offset + 3, T(-5));
  for (std::size_t i = 0; i < n; ++i)
    for (int k = 0; k < 3; ++k) s[k][i + static_cast<std::size_t>(k)] = p[i][k];
  const auto part = [&](int k, std::size_t first) { return std::span<T>(s[k]).subspan(first, n); };
  const irg::point_streams<const T> from{part(0, 0), part(1, 1), part(2, 2)};
  const irg::point_streams<T> to{part(3, offset), part(4, offset + 1), part(5, offset + 2)};
  transform_points(a, from, to);
  for (std::size_t i = 0; i < n; ++i) wrong += !same_bits(point<T, 3>{to.x[i], to.y[i], to.z[i]}, at(i));
  wrong += s[3][n + offset] != T(-5) || s[4][n + offset + 1] != T(-5) || s[4][0] != T(-5) || s[5][1] != T(-5);
  transform_points(a, from, {part(0, 0), part(1, 1), part(2, 2)});
  for (std::size_t i = 0; i < n; ++i) wrong += !same_bits(point<T, 3>{from.x[i], from.y[i], from.z[i]}, at(i));
  return wrong;
}

template <class T>
constexpr bool in_constant_evaluation() {
  constexpr mat<T, 4, 4> a{{{T(0.1), T(0.7), T(-0.3), 1}, {T(1.3), T(0.2), T(0.9), 2}, {T(-0.4), T(0.6), 1, 3}}};
  std::array<point<T, 3>, 20> p{}, out{};
  std::array<hpoint<T, 3>, 20> h{};
  for (std::size_t i = 0; i < 20; ++i) p[i] = {T(i) / 3, T(i) / 7, T(1) / T(i + 1)};
  transform_points(a, p, out);
  transform_points(a, p, h);
  for (std::size_t i = 0; i < 20; ++i)
    if (out[i] != transform_point(a, p[i]) || h[i] != a * p[i]) return false;
  return true;
}

}  // namespace

TEST_CASE("transform_points: the bits of transform_point, for every size and address") {
  test::random r(1);
  for (std::size_t n = 0; n <= 70; ++n) {
    CHECK(wrong_results<float>(n, n % 5, r) == 0);
    CHECK(wrong_results<double>(n, n % 3, r) == 0);
  }
  for (const std::size_t n : {255u, 256u, 300u, 1000u, 1001u})
    for (std::size_t offset = 0; offset < 17; offset += 3) {
      CHECK(wrong_results<float>(n, offset, r) == 0);
      CHECK(wrong_results<double>(n, offset, r) == 0);
    }
}

TEST_CASE("transform_points: arrays that are written past the caches") {
  test::random r(2);
  CHECK(wrong_results<float>(750'003, 3, r) == 0);
  CHECK(wrong_results<double>(360'001, 1, r) == 0);
}

TEST_CASE("transform_points: constant evaluation") {
  CHECK_BOTH(in_constant_evaluation<float>());
  CHECK_BOTH(in_constant_evaluation<double>());
}

TEST_CASE("transform_points: by hand") {
  const mat<float, 4, 4> move{{{1, 0, 0, 5}, {0, 2, 0, 6}, {0, 0, 3, 7}, {9, 9, 9, 9}}};  // the last row is not read
  std::vector<point<float, 3>> p(100, point<float, 3>{1, 2, 3});
  transform_points(move, p, p);
  CHECK(p[99] == point<float, 3>{6, 10, 16});
  std::vector<vec<float, 3>> v(100, vec<float, 3>{1, 2, 3});
  transform_vectors(move, v, v);
  CHECK(v[57] == vec<float, 3>{1, 4, 9});
  transform_points(move, std::span<const point<float, 3>>{}, std::span<point<float, 3>>{});
}
