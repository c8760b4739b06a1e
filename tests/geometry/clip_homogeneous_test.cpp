// SPDX-License-Identifier: MIT
#include <irg/geometry/clip_homogeneous.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <vector>

#include "geometry/mixed_cases.hpp"
#include "support/check_both.hpp"
#include "support/random.hpp"
#include "support/rational.hpp"

using irg::clip_code;
using irg::clip_homogeneous;
using irg::clip_planes;
using irg::clip_segment_homogeneous;
using irg::clip_vertex;
using irg::clip_volume;
using irg::clipped_polygon;
using irg::hpoint;
using test::rational;

namespace {

// The attributes of a test vertex are its barycentric weights: where on the source triangle it came from.
template <class T>
using V = clip_vertex<T, 3>;
using R = rational;

template <class T>
struct triangle {
  V<T> v[3];
};

template <class T>
constexpr triangle<T> triangle_of(const hpoint<T, 3>& a, const hpoint<T, 3>& b, const hpoint<T, 3>& c) {
  return {{{a, {T(1), T(0), T(0)}}, {b, {T(0), T(1), T(0)}}, {c, {T(0), T(0), T(1)}}}};
}

template <class T>
hpoint<T, 3> lattice_point(test::random& r, std::int64_t size, std::int64_t w_low, std::int64_t w_high) {
  const auto c = [&](std::int64_t low, std::int64_t high) { return static_cast<T>(r.integer(low, high)); };
  return {c(-size, size), c(-size, size), c(-size, size), c(w_low, w_high)};
}

// A position of any size between 2^-6 and 2^6, a third of them behind the eye.
template <class T>
hpoint<T, 3> wild_point(test::random& r) {
  const auto c = [&] {
    const double significand = r.unit() - 0.5;
    return static_cast<T>(std::ldexp(significand, static_cast<int>(r.integer(-5, 7))));
  };
  hpoint<T, 3> p{c(), c(), c(), c()};
  if (r.integer(0, 2) != 0 && p.w < 0) p.w = -p.w;
  return p;
}

// Arguments are evaluated in any order, so random vertices are drawn one by one.
template <class T, class F>
triangle<T> drawn(const F& draw) {
  const hpoint<T, 3> a = draw(), b = draw(), c = draw();
  return triangle_of(a, b, c);
}

// Half-spaces by their definition, without the clipper's own code: the six values that must not be negative.
template <class T>
void half_spaces(const hpoint<T, 3>& p, T guard, T (&value)[6]) {
  value[0] = p.w - p.z;
  value[1] = p.z;
  value[2] = guard * p.w + p.x;
  value[3] = guard * p.w - p.x;
  value[4] = guard * p.w + p.y;
  value[5] = guard * p.w - p.y;
}

// Where (b0, b1) lies in the polygon that the attributes of the clipped vertices make: 1 inside, 0 on it, -1 outside.
template <class Polygon, class T>
int side_in_weights(const Polygon& polygon, T b0, T b1) {
  int positive = 0, negative = 0, zero = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const auto& p = polygon[i].attributes;
    const auto& q = polygon[i + 1 < polygon.size() ? i + 1 : 0].attributes;
    const T cross = (q[0] - p[0]) * (b1 - p[1]) - (q[1] - p[1]) * (b0 - p[0]);
    (cross < T(0) ? negative : T(0) < cross ? positive : zero)++;
  }
  if (positive > 0 && negative > 0) return -1;
  if (positive == 0 && negative == 0) return -1;
  return zero > 0 ? 0 : 1;
}

// Whether a side passes through 0, 0, 0, 0, which is no position: its two ends are opposite. What is left of such a
// triangle is the cone's share of the picture, not of the weights.
bool passes_through_no_position(const triangle<R>& t) {
  for (int i = 0; i < 3; ++i) {
    const auto &p = t.v[i].position, &q = t.v[(i + 1) % 3].position;
    bool opposite = true;
    for (int j = 0; j < 4; ++j)
      for (int k = 0; k < j; ++k) opposite = opposite && p[j] * q[k] == p[k] * q[j];
    R along = 0;
    for (int k = 0; k < 4; ++k) along = along + p[k] * q[k];
    if (opposite && along < R(0)) return true;
  }
  return false;
}

// Every sample of a fine grid over the triangle is strictly inside the volume exactly when it is strictly inside what
// is left of the triangle.
template <class Polygon>
bool agrees_with_samples(const triangle<R>& t, const Polygon& polygon, R guard) {
  constexpr int n = 9;
  for (int i = 1; i < n; ++i)
    for (int j = 1; i + j < n; ++j) {
      // Off the grid's symmetry lines, so that few samples fall on boundaries.
      const R b0 = R(64 * i + 3, 64 * n + 17), b1 = R(64 * j + 5, 64 * n + 17), b2 = R(1) - b0 - b1;
      hpoint<R, 3> p;
      for (int k = 0; k < 4; ++k) p[k] = t.v[0].position[k] * b0 + t.v[1].position[k] * b1 + t.v[2].position[k] * b2;
      R value[6];
      half_spaces(p, guard, value);
      const R least = *std::min_element(value, value + 6);
      const int side = side_in_weights(polygon, b0, b1);
      if (R(0) < least && side < 0) return false;
      if (least < R(0) && side > 0) return false;
    }
  return true;
}

template <class Polygon>
bool same_cycle(const std::vector<hpoint<R, 3>>& expected, const Polygon& polygon) {
  if (expected.size() != polygon.size()) return false;
  for (std::size_t shift = 0; shift < expected.size(); ++shift) {
    bool same = true;
    for (std::size_t i = 0; i < expected.size(); ++i)
      same = same && polygon[i].position == expected[(i + shift) % expected.size()];
    if (same) return true;
  }
  return expected.empty();
}

template <class T, int N, int M>
bool same_bits(const clipped_polygon<V<T>, N>& a, const clipped_polygon<V<T>, M>& b) {
  if (a.count != b.count) return false;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (!(a[i] == b[i])) return false;
  return true;
}

int release_or(int ci) { return std::getenv("IRG_RELEASE_TIER") ? 50 * ci : ci; }

}  // namespace

TEST_CASE("clip_homogeneous: polygons are equal by the vertices that they have") {
  clipped_polygon<V<double>> a{{{{1, 2, 3, 4}, {}}, {{5, 6, 7, 8}, {}}}, 1}, b = a;
  b.vertices[1].position.x = 9;
  CHECK(a == b);
  a.count = b.count = 2;
  CHECK(a != b);
}

TEST_CASE("clip_homogeneous: type facts") {
  static_assert(irg::ClipVertex<clip_vertex<float, 0>> && irg::ClipVertex<clip_vertex<double, 7>>);
  static_assert(sizeof(clip_vertex<float, 0>) == 4 * sizeof(float));
  static_assert(!irg::ClipVertex<hpoint<float, 3>>);
  static_assert(noexcept(clip_homogeneous(triangle<float>{}.v)));
  static_assert(sizeof(clip_homogeneous(triangle<float>{}.v).vertices) == 9 * sizeof(V<float>));
  static_assert((clip_planes::depth | clip_planes::sides) == clip_planes::all &&
                ~clip_planes::all == clip_planes::none);
}

TEST_CASE("clip_homogeneous: by hand, in every life") {
  using D = V<double>;
  // Cut off at x = w: the long corner becomes an edge.
  constexpr auto cut = triangle_of<double>({0, 0, 0.5, 1}, {3, 0, 0.5, 1}, {0, 0.5, 0.5, 1});
  constexpr auto left_over = clip_homogeneous(cut.v);
  CHECK_BOTH(left_over.count == 4);
  CHECK_BOTH(left_over[0] == cut.v[0]);
  CHECK_BOTH(left_over[1].position == hpoint<double, 3>{1, 0, 0.5, 1});
  CHECK_BOTH(left_over[3] == cut.v[2]);
  CHECK_BOTH(left_over[1].attributes[1] == 1.0 / 3);
  volatile double one = 1;
  triangle<double> again = cut;
  for (D& v : again.v)
    for (int k = 0; k < 4; ++k) v.position[k] *= one;
  CHECK(same_bits(clip_homogeneous(again.v), left_over));

  // All inside: untouched. All outside: nothing. Degenerate and hostile: see below.
  constexpr auto inside = triangle_of<double>({0, 0, 0.5, 1}, {0.5, 0, 0.5, 1}, {0, 0.5, 0.5, 1});
  CHECK_BOTH(clip_homogeneous(inside.v).count == 3);
  CHECK_BOTH(clip_homogeneous(inside.v)[2] == inside.v[2]);
  constexpr auto outside = triangle_of<double>({3, 0, 0.5, 1}, {4, 0, 0.5, 1}, {3, 0.5, 0.5, 1});
  CHECK_BOTH(clip_homogeneous(outside.v).empty());
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_BOTH(clip_homogeneous(triangle_of<double>({nan, 0, 0.5, 1}, {0.5, 0, 0.5, 1}, {0, 0.5, 0.5, 1}).v).empty());
  CHECK_BOTH(clip_code(hpoint<double, 3>{2, -3, -1, 1}) ==
             (clip_planes::right | clip_planes::bottom | clip_planes::z_far));
  CHECK_BOTH(clip_code(hpoint<double, 3>{1, -1, 1, 1}) == clip_planes::none);
  CHECK_BOTH(clip_code(hpoint<double, 3>{2, -3, 2, 1}, {clip_planes::all, 2, 4}) == clip_planes::z_near);

  // A triangle that meets all six planes leaves nine vertices.
  constexpr auto large =
      triangle_of<R>({R(-9, 5), 0, R(7, 5), 1}, {0, R(9, 5), R(-2, 5), 1}, {R(9, 5), R(-9, 5), R(1, 2), 1});
  constexpr auto nonagon = clip_homogeneous(large.v);
  CHECK(agrees_with_samples(large, nonagon, R(1)));
  CHECK_BOTH(nonagon.count == 9);
}

TEST_CASE("clip_homogeneous: Hank's values, three dimensions") {
  // The frustum 1 <= z <= 10, |x| <= 2z, |y| <= 3z/2 looks along +z; with w = z and depth (10 - z)/9 it is clip space.
  const auto to_clip = [](R x, R y, R z) { return hpoint<R, 3>{x / R(2), y / R(3, 2), (R(10) - z) / R(9), z}; };
  const auto t = triangle_of(to_clip(0, 0, -1), to_clip(0, 0, 5), to_clip(20, 0, 5));
  CHECK(same_cycle({to_clip(0, 0, 5), to_clip(10, 0, 5), to_clip(2, 0, 1), to_clip(0, 0, 1)}, clip_homogeneous(t.v)));

  // The same frustum: points inside and outside.
  struct {
    R x, y, z;
    bool inside;
  } const points[] = {{0, 0, 5, true},   {10, 0, 5, true}, {11, 0, 5, false},      {0, R(15, 2), 5, true},
                      {0, 8, 5, false},  {0, 0, 1, true},  {0, 0, R(1, 2), false}, {0, 0, 10, true},
                      {0, 0, 11, false}, {0, 0, -5, false}};
  for (const auto& p : points) CHECK((clip_code(to_clip(p.x, p.y, p.z)) == clip_planes::none) == p.inside);
}

TEST_CASE("clip_homogeneous: Hank's values, the window [0,4] x [0,3]") {
  const auto to_clip = [](R x, R y) { return hpoint<R, 3>{(x - R(2)) / R(2), (y - R(3, 2)) / R(3, 2), R(1, 2), 1}; };
  const auto clip3 = [&](R ax, R ay, R bx, R by, R cx, R cy) {
    return clip_homogeneous(triangle_of(to_clip(ax, ay), to_clip(bx, by), to_clip(cx, cy)).v);
  };
  CHECK(same_cycle({to_clip(R(7, 2), 3), to_clip(R(1, 2), 3), to_clip(0, R(7, 3)), to_clip(0, 1), to_clip(4, 1),
                    to_clip(4, R(7, 3))},
                   clip3(-1, 1, 5, 1, 2, 5)));
  CHECK(same_cycle({to_clip(2, 1), to_clip(2, 2), to_clip(1, 1)}, clip3(1, 1, 2, 1, 2, 2)));
  CHECK(clip3(5, 1, 6, 1, 5, 2).empty());
  // Touching along x = 4: the source keeps a doubled segment; no area is left, so nothing comes out here.
  CHECK(clip3(4, 1, 5, 1, 4, 2).empty());
  const clip_vertex<R, 0> quad[] = {{to_clip(-1, -1)}, {to_clip(5, -1)}, {to_clip(5, 4)}, {to_clip(-1, 4)}};
  CHECK(same_cycle({to_clip(4, 3), to_clip(0, 3), to_clip(0, 0), to_clip(4, 0)}, clip_homogeneous(quad)));
}

TEST_CASE("clip_homogeneous: all 27 combinations of inside, on and outside, for each plane") {
  // The distance from plane k is set directly; the other coordinates stay well inside, at three places.
  const R place[3][2] = {{R(-1, 4), R(-1, 4)}, {R(1, 4), R(-1, 4)}, {R(0), R(1, 4)}};
  for (int plane = 0; plane < 6; ++plane)
    for (int combination = 0; combination < 27; ++combination) {
      const int state[3] = {combination % 3 - 1, combination / 3 % 3 - 1, combination / 9 - 1};
      hpoint<R, 3> p[3];
      int inside = 0, on = 0;
      for (int i = 0; i < 3; ++i) {
        const R d = R(state[i], 8);
        if (plane == 0) p[i] = {place[i][0], place[i][1], R(1) - d, 1};
        if (plane == 1) p[i] = {place[i][0], place[i][1], d, 1};
        if (plane == 2) p[i] = {R(-1) + d, place[i][0], place[i][1] + R(1, 2), 1};
        if (plane == 3) p[i] = {R(1) - d, place[i][0], place[i][1] + R(1, 2), 1};
        if (plane == 4) p[i] = {place[i][0], R(-1) + d, place[i][1] + R(1, 2), 1};
        if (plane == 5) p[i] = {place[i][0], R(1) - d, place[i][1] + R(1, 2), 1};
        inside += state[i] > 0 ? 1 : 0;
        on += state[i] == 0 ? 1 : 0;
      }
      const auto t = triangle_of(p[0], p[1], p[2]);
      const auto left_over = clip_homogeneous(t.v);
      CHECK(agrees_with_samples(t, left_over, R(1)));
      // Vertices on the plane count as inside and are not doubled.
      const int outside = 3 - inside - on;
      const int expected = outside == 0 ? 3 : inside == 0 ? 0 : inside == 2 ? 4 : 3;
      CHECK(left_over.count == expected);
    }
}

TEST_CASE("clip_homogeneous: samples decide alike, in front of, behind and through the eye") {
  test::random r(1);
  int kept = 0, most = 0;
  for (int i = 0; i < 600; ++i) {
    const auto t = drawn<R>([&] { return lattice_point<R>(r, 4, -2, 4); });
    const R guard = r.integer(0, 1) ? R(1) : R(3, 2);
    const auto left_over = clip_homogeneous(t.v, {clip_planes::all, guard, guard});
    if (!passes_through_no_position(t)) CHECK(agrees_with_samples(t, left_over, guard));
    kept += left_over.empty() ? 0 : 1;
    most = std::max(most, left_over.count);
    for (const auto& v : left_over) {
      R value[6];
      half_spaces(v.position, guard, value);
      for (const R& x : value) CHECK(!(x < R(0)));
      CHECK(R(0) < v.position.w);
      for (int k = 0; k < 4; ++k)  // it is where its weights say
        CHECK(v.position[k] == t.v[0].position[k] * v.attributes[0] + t.v[1].position[k] * v.attributes[1] +
                                   t.v[2].position[k] * v.attributes[2]);
    }
  }
  CHECK(kept > 100);
  CHECK(most >= 6);
}

TEST_CASE("clip_homogeneous: floats stay inside, near the exact result, and do not change when clipped again") {
  test::random r(2);
  int kept = 0;
  for (int i = 0; i < release_or(20000); ++i) {
    const auto t = drawn<float>([&] { return wild_point<float>(r); });
    const clip_volume<float> volume{clip_planes::all, r.integer(0, 1) ? 1.0f : 1.7f, r.integer(0, 1) ? 1.0f : 3.3f};
    const auto left_over = clip_homogeneous(t.v, volume);
    kept += left_over.empty() ? 0 : 1;
    CHECK(left_over.count <= 9);
    CHECK(same_bits(clip_homogeneous(left_over, volume), left_over));
    for (const auto& v : left_over) {
      CHECK(clip_code(v.position, volume) == clip_planes::none);
      CHECK(v.position.w > 0);
      // What the division makes of it: on the screen.
      CHECK(std::abs(v.position.x / v.position.w) <= volume.guard_x * (1 + 0x1p-23f));
      CHECK((v.position.z / v.position.w >= 0 && v.position.z / v.position.w <= 1));
      for (int k = 0; k < 4; ++k) {
        double where = 0, largest = 0;
        for (int j = 0; j < 3; ++j) {
          where += static_cast<double>(t.v[j].position[k]) * static_cast<double>(v.attributes[j]);
          for (int c = 0; c < 4; ++c) largest = std::max(largest, std::abs(static_cast<double>(t.v[j].position[c])));
        }
        const double guard = std::max(static_cast<double>(volume.guard_x), static_cast<double>(volume.guard_y));
        CHECK(std::abs(where - static_cast<double>(v.position[k])) <= 16 * 0x1p-24 * guard * largest);
      }
    }
  }
  CHECK(kept > 1000);
}

TEST_CASE("clip_homogeneous: no crack, the same bits on a shared edge from both sides") {
  test::random r(3);
  int shared = 0;
  for (int i = 0; i < release_or(50000); ++i) {
    const auto a = wild_point<float>(r), b = wild_point<float>(r), c = wild_point<float>(r), d = wild_point<float>(r);
    const clip_volume<float> volume{clip_planes::all, r.integer(0, 1) ? 1.0f : 1.7f, 1.0f};
    const auto one = clip_homogeneous(triangle_of(a, b, c).v, volume);
    const auto other = clip_homogeneous(triangle_of(b, a, d).v, volume);
    if (one.empty() || other.empty()) continue;
    // On the edge the third vertex has no weight.
    const auto on_edge = [](const auto& polygon) {
      std::vector<hpoint<float, 3>> edge;
      for (const auto& v : polygon)
        if (v.attributes[2] == 0) edge.push_back(v.position);
      return edge;
    };
    auto seen = on_edge(one), seen_back = on_edge(other);
    const auto before = [](const hpoint<float, 3>& p, const hpoint<float, 3>& q) {
      return p.x != q.x ? p.x < q.x : p.y != q.y ? p.y < q.y : p.z != q.z ? p.z < q.z : p.w < q.w;
    };
    std::sort(seen.begin(), seen.end(), before);
    std::sort(seen_back.begin(), seen_back.end(), before);
    CHECK(seen == seen_back);
    shared += seen.size() == 2 ? 1 : 0;

    // The wire over the edge meets it exactly.
    const auto wire = clip_segment_homogeneous(clip_vertex<float, 0>{a}, clip_vertex<float, 0>{b}, volume);
    if (seen.size() == 2) {
      CHECK(wire.has_value());
      std::vector<hpoint<float, 3>> ends{wire->first.position, wire->second.position};
      std::sort(ends.begin(), ends.end(), before);
      CHECK(ends == seen);
    }
  }
  CHECK(shared > 1000);
}

TEST_CASE("clip_segment_homogeneous: against the exact interval of parameters; both ways the same") {
  test::random r(4);
  int kept = 0;
  for (int i = 0; i < 3000; ++i) {
    const clip_vertex<R, 1> a{lattice_point<R>(r, 4, -3, 4), {R(0)}}, b{lattice_point<R>(r, 4, -3, 4), {R(1)}};
    // Liang and Barsky's way: every plane narrows an interval of parameters.
    R low = 0, high = 1, at_a[6], at_b[6];
    half_spaces(a.position, R(1), at_a);
    half_spaces(b.position, R(1), at_b);
    bool visible = true;
    for (int k = 0; k < 6; ++k) {
      if (at_a[k] < R(0) && at_b[k] < R(0)) visible = false;
      if (at_a[k] < R(0) && !(at_b[k] < R(0))) low = std::max(low, at_a[k] / (at_a[k] - at_b[k]));
      if (at_b[k] < R(0) && !(at_a[k] < R(0))) high = std::min(high, at_a[k] / (at_a[k] - at_b[k]));
    }
    visible = visible && !(high < low);
    const auto is_apex = [&](R t) {
      for (int k = 0; k < 4; ++k)
        if (a.position[k] + t * (b.position[k] - a.position[k]) != R(0)) return false;
      return true;
    };
    visible = visible && !is_apex(low) && !is_apex(high);
    const auto s = clip_segment_homogeneous(a, b);
    const auto back = clip_segment_homogeneous(b, a);
    CHECK(s.has_value() == visible);
    CHECK(back.has_value() == visible);
    if (!s || !back) continue;
    ++kept;
    CHECK(s->first.attributes[0] == low);
    CHECK(s->second.attributes[0] == high);
    CHECK((back->first == s->second && back->second == s->first));
  }
  CHECK(kept > 300);
}

TEST_CASE("clip_homogeneous: w = 0, denormal w, the eye itself") {
  using D = V<double>;
  const double tiny = std::numeric_limits<double>::denorm_min();
  for (const double w : {0.0, -0.0, tiny, -tiny})
    for (const double z : {0.0, tiny, -tiny, 0.25})
      for (const double x : {0.0, 1.0, -tiny}) {
        const auto t = triangle_of<double>({x, 0, z, w}, {0.5, -0.5, 0.5, 1}, {-0.5, -0.5, 0.5, 1});
        const auto left_over = clip_homogeneous(t.v);
        // Where the first vertex is the eye or next to it, the triangle is seen edge-on and may vanish.
        if (x == 1 || z == 0.25) CHECK(left_over.count >= 3);
        CHECK(same_bits(clip_homogeneous(left_over), left_over));
        for (const D& v : left_over) {
          CHECK(v.position.w > 0);
          CHECK(clip_code(v.position) == clip_planes::none);
          CHECK((std::abs(v.position.x) <= v.position.w && std::abs(v.position.y) <= v.position.w));
        }
      }
  // Through the eye (z_clip = near, w = 0), the other two vertices in front and behind.
  const auto through = triangle_of<double>({0, 0, 0.1, 0}, {0.1, 0.2, 0.09, 1}, {0.3, 0.1, 0.11, -1});
  const auto left_over = clip_homogeneous(through.v);
  CHECK(left_over.count >= 3);
  // Vertices 0, 0, 0, 0 stand for nothing and go; three of them are no polygon.
  CHECK(clip_homogeneous(triangle_of<double>({0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}).v).empty());
  const clip_vertex<double, 0> apex[] = {
      {{0, 0, 0, 0}}, {{0.5, -0.5, 0.5, 1}}, {{0.5, 0.5, 0.5, 1}}, {{-0.5, 0.5, 0.5, 1}}};
  CHECK(clip_homogeneous(apex).count == 3);
  // Wholly behind the camera, even where x and y would pass after the division.
  CHECK(clip_homogeneous(triangle_of<double>({0, 0, -0.5, -1}, {0.5, 0, -0.5, -1}, {0, 0.5, -0.5, -1}).v).empty());
  // Without the sides, points at infinity may stay, and w >= 0 all the same.
  const auto sky =
      clip_homogeneous(triangle_of<double>({1, 0, 0, 0}, {0.5, 0, 0.5, 1}, {0, 0.5, 0.5, 1}).v, {clip_planes::depth});
  CHECK(sky.count == 3);
  CHECK(sky[0].position == hpoint<double, 3>{1, 0, 0, 0});
}

TEST_CASE("clip_homogeneous: hostile input") {
  constexpr float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
  const float most = std::numeric_limits<float>::max();
  const auto plain = triangle_of<float>({0, 0, 0.5f, 1}, {0.5f, 0, 0.5f, 1}, {0, 0.5f, 0.5f, 1});
  for (const float bad : {nan, inf, -inf, most, -most})
    for (int vertex = 0; vertex < 3; ++vertex)
      for (int k = 0; k < 4; ++k) {
        auto t = plain;
        t.v[vertex].position[k] = bad;
        CHECK(clip_homogeneous(t.v).empty());
        CHECK(!clip_segment_homogeneous(t.v[vertex], t.v[(vertex + 1) % 3]));
      }
  // The largest that is clipped gives finite numbers.
  auto huge = plain;
  huge.v[1].position = {most / 8, -most / 8, most / 8, most / 8};
  huge.v[2].position = {-most / 8, most / 8, -most / 8, -most / 8};
  for (const auto& v : clip_homogeneous(huge.v))
    for (int k = 0; k < 4; ++k) CHECK(std::isfinite(v.position[k]));
  for (const float guard : {nan, inf}) CHECK(clip_homogeneous(plain.v, {clip_planes::all, guard, 1}).empty());
  // Not convex: whatever comes out, nothing is written beyond the capacity.
  clip_vertex<float, 0> comb[20];
  for (int i = 0; i < 20; ++i)
    comb[i].position = {i % 2 ? 5.0f : -5.0f, static_cast<float>(i) / 10 - 1, i % 3 ? 3.0f : -3.0f, 1};
  CHECK(clip_homogeneous(comb).count <= 26);
}

namespace {

struct own_vertex {
  hpoint<float, 3> position;
  int label = 0;
};
struct own_rule {
  constexpr own_vertex operator()(const own_vertex& a, const own_vertex& b, float t) const {
    return {irg::lerp_clip_vertex{}(clip_vertex<float, 0>{a.position}, clip_vertex<float, 0>{b.position}, t).position,
            a.label + b.label};
  }
};

}  // namespace

TEST_CASE("clip_homogeneous: a vertex type of the user's own, a guard band, chosen planes") {
  const own_vertex own[] = {{{0, 0, 0.5f, 1}, 1}, {{3, 0, 0.5f, 1}, 10}, {{0, 0.5f, 0.5f, 1}, 100}};
  const auto left_over = clip_homogeneous(own, {}, own_rule{});
  CHECK(left_over.count == 4);
  CHECK(left_over[1].label == 11);
  CHECK(left_over[2].label == 110);
  CHECK(clip_homogeneous(own, {clip_planes::all, 3, 1}, own_rule{}).count == 3);
  CHECK(clip_homogeneous(own, {clip_planes::depth}, own_rule{}).count == 3);
  CHECK(clip_homogeneous(own, {clip_planes::none}, own_rule{}).count == 3);
}

#ifdef IRG_HAVE_MPFR

TEST_CASE_TEMPLATE("clip_homogeneous: numbers of all sizes, of its bound", T, double, float) {
  using namespace test::mixed;
  // Positions against attributes that are the positions: as shares of guard * (16u * the largest coordinate + 2 * the
  // smallest number).
  sweep(
      named<T>("clip_homogeneous, of its bound"), 1,
      [](test::random& r, sizes which) {
        irg::clip_vertex<T, 4> corners[3];
        irg::clip_volume<T> volume;
        volume.guard_x = volume.guard_y = static_cast<T>(1 + 7 * r.unit());
        E largest = 0;
        for (auto& v : corners)
          for (int k = 0; k < 4; ++k) {
            v.position[k] = v.attributes[k] = number<T>(r, which) / 8;
            if (largest < abs(of(v.position[k]))) largest = abs(of(v.position[k]));
          }
        double worst = 0;
        const E guard = of(volume.guard_x), smallest = of(std::numeric_limits<T>::denorm_min());
        const E bound = guard * (largest * of(8 * std::numeric_limits<T>::epsilon()) + smallest * 2);
        for (const auto& v : clip_homogeneous(corners, volume))
          for (int k = 0; k < 4; ++k) {
            const test::quotients::near_number off(of(v.position[k]) - of(v.attributes[k])), unit(bound);
            worst = std::fmax(worst, std::fabs(std::ldexp(off.value / unit.value, off.exponent - unit.exponent)));
          }
        return worst;
      },
      3000);
}

#endif
