// SPDX-License-Identifier: MIT
#include <irg/raster/screen_pieces.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include "support/check_both.hpp"
#include "support/exact.hpp"
#include "support/random.hpp"

namespace {

using irg::clip_to_screen;
using irg::screen_pieces;
template <class T>
using corner = irg::hpoint<T, 3>;

static_assert(noexcept(clip_to_screen({corner<float>{}, {}, {}}, irg::map_to_screen<float>({8, 8}), 0)));

constexpr screen_pieces pieces_of(const corner<double>& a, const corner<double>& b, const corner<double>& c) {
  return clip_to_screen({a, b, c}, irg::map_to_screen<double>({64, 64}), 7);
}
constexpr bool is_at(const irg::screen_vertex& v, int x, int y, float depth) {
  return v.position == irg::subpixel{256 * x, 256 * y} && v.depth == depth;
}

TEST_CASE("clip_to_screen: by hand") {
  // Not cut: the corners themselves, in their order.
  constexpr auto whole = pieces_of({-1, -1, 0.5, 1}, {1, -1, 0.25, 1}, {-1, 1, 0, 1});
  CHECK_BOTH((whole.size() == 1 && !whole.outside && whole[0].face.number == 7));
  CHECK_BOTH((is_at(whole[0].face.v[0], 0, 64, 0.5f) && is_at(whole[0].face.v[1], 64, 64, 0.25f)));
  CHECK_BOTH(is_at(whole[0].face.v[2], 0, 0, 0.0f));
  CHECK_BOTH(
      (whole.double_area == -whole[0].face.coverage.double_area && facing_of(whole[0].face) == irg::facing::front));
  CHECK_BOTH((whole[0].weights.corner[1].second == 1.0f && whole[0].weights.corner[2].third == 1.0f));
  // One corner behind the near plane, w - z = -1 against 1: halves of two edges, two pieces about the first corner.
  constexpr auto cut = pieces_of({0, 0, 0, 1}, {1, 0, 0, 1}, {0, 2, 3, 2});
  CHECK_BOTH((cut.size() == 2 && !cut.outside && cut[1].face.number == 7));
  CHECK_BOTH((is_at(cut[0].face.v[0], 32, 32, 0.0f) && is_at(cut[0].face.v[1], 64, 32, 0.0f)));
  CHECK_BOTH((cut[0].weights.corner[2].third == 0.5f && cut[0].weights.corner[2].second == 0.5f));
  CHECK_BOTH((cut[1].weights.corner[2].third == 0.5f && cut[1].weights.corner[2].second == 0.0f));
  CHECK_BOTH((cut[0].face.v[2].depth == 1.0f && cut[1].face.v[2].depth == 1.0f));
  // Two corners behind it: one piece.
  CHECK_BOTH(pieces_of({0, 0, 0, 1}, {1, 0, 3, 2}, {0, 2, 3, 2}).size() == 1);
}

TEST_CASE("clip_to_screen: nothing left, nothing to see, no triangle") {
  constexpr double huge = std::numeric_limits<double>::max(), inf = std::numeric_limits<double>::infinity();
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr auto gone = [](const corner<double>& a, const corner<double>& b, const corner<double>& c) {
    const screen_pieces p = pieces_of(a, b, c);
    return p.outside && p.size() == 0 && p.double_area == 0;
  };
  CHECK_BOTH(gone({0, 0, -1, 1}, {1, 0, -1, 1}, {0, 1, -2, 1}));      // beyond the far plane
  CHECK_BOTH(gone({0, 0, 0, -1}, {1, 0, 0, -1}, {0, 1, 0, -1}));      // behind the eye
  CHECK_BOTH(gone({0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}));         // nowhere
  CHECK_BOTH(gone({1e5, 0, 0, 1}, {2e5, 0, 0, 1}, {1e5, 1, 0, 1}));   // beside the guard band
  CHECK_BOTH(gone({nan, 0, 0, 1}, {1, 0, 0, 1}, {0, 1, 0, 1}));
  CHECK_BOTH(gone({0, 0, 0, 1}, {1, 0, 0, inf}, {0, 1, 0, 1}));
  CHECK_BOTH(gone({0, 0, 0, 1}, {1, 0, 0, 1}, {0, -huge, 0, 1}));
  // Left, but seen edge on or too small: no piece.
  constexpr auto flat = pieces_of({0, 0, 0, 1}, {1, 1, 0, 1}, {0.5, 0.5, 0, 1});
  CHECK_BOTH((!flat.outside && flat.size() == 0 && flat.double_area == 0));
  CHECK_BOTH(pieces_of({0, 0, 0, 1}, {1e-9, 0, 0, 1}, {0, 1e-9, 0, 1}).size() == 0);
  // Corners exactly on planes are inside: nothing is cut.
  CHECK_BOTH(pieces_of({0, 0, 1, 1}, {1, 0, 0, 1}, {0, 1, 0, 1}).size() == 1);
  CHECK_BOTH(pieces_of({1024, 0, 1, 1}, {-1024, -1024, 0, 1}, {0, 1024, 0, 1}).size() == 1);
  // The whole plane w = z, and w from the least to the greatest number.
  CHECK_BOTH(pieces_of({0, 0, 2, 2}, {1, 0, 1, 1}, {0, 1, 3, 3}).size() == 1);
  CHECK_BOTH(pieces_of({0, 0, 0, 1e-300}, {1e300, 0, 0, 1e300}, {0, 1e-300, 0, 1e-300}).size() == 1);
}

TEST_CASE("piece_weights: a whole triangle is a piece of itself") {
  constexpr irg::piece_weights whole{};
  CHECK_BOTH((whole.corner[0].second == 0 && whole.corner[0].third == 0));
  CHECK_BOTH((whole.corner[1].second == 1 && whole.corner[1].third == 0));
  CHECK_BOTH((whole.corner[2].second == 0 && whole.corner[2].third == 1));
}

// ---- against the clipped triangle itself, in integers

// The values at a pixel of functions that are linear on the screen and nowhere negative on what is left of a triangle:
// its three barycentric weights (the adjugate of the matrix of its x, y and w, Olano and Greer 1997), and the distances
// from the depth planes. And how much each changes within a pixel's 1/256.
struct exact_triangle {
  std::int64_t a[5][3], determinant;
  int size;

  exact_triangle(const std::int64_t (&c)[3][4], int picture) : size(picture) {
    for (int i = 0; i < 3; ++i) {
      const auto &p = c[(i + 1) % 3], &q = c[(i + 2) % 3];  // b_i = (p x q) . (x, y, 1), over x, y, w
      a[i][0] = p[1] * q[3] - p[3] * q[1];
      a[i][1] = p[3] * q[0] - p[0] * q[3];
      a[i][2] = p[0] * q[1] - p[1] * q[0];
    }
    determinant = a[0][0] * c[0][0] + a[0][1] * c[0][1] + a[0][2] * c[0][3];
    for (auto& row : a)
      for (std::int64_t& v : row)
        if (&row - a < 3 && determinant < 0) v = -v;
    for (int k = 0; k < 3; ++k) {
      a[3][k] = a[4][k] = 0;
      for (int i = 0; i < 3; ++i) {
        a[3][k] += a[i][k] * (c[i][3] - c[i][2]);
        a[4][k] += a[i][k] * c[i][2];
      }
    }
  }
  // Times the size of the picture; x and y from -1 to 1.
  std::int64_t value(int f, int px, int py) const {
    return a[f][0] * (2 * px + 1 - size) - a[f][1] * (2 * py + 1 - size) + a[f][2] * size;
  }
  // 1: within by more than `steps` of 1/256 pixel, -1: outside by more, 0: between.
  int side(int px, int py, std::int64_t steps) const {
    int all = 1;
    for (int f = 0; f < 5; ++f) {
      const std::int64_t v = value(f, px, py) * 128,
                         reach = steps * ((a[f][0] < 0 ? -a[f][0] : a[f][0]) + (a[f][1] < 0 ? -a[f][1] : a[f][1]));
      if (v < -reach) return -1;
      if (v <= reach) all = 0;
    }
    return all;
  }
  double depth(int px, int py) const {
    const double w = static_cast<double>(determinant < 0 ? -determinant : determinant) * size;
    return static_cast<double>(value(4, px, py)) / w;
  }
};

struct tally {
  int cut = 0, inside = 0, doubled = 0, wrong = 0;
};

// Corners up to 2^far, of which no w is less; what clipping them in T loses is below 1/128 pixel, and so much of the
// depth.
struct extent {
  int far, least_w;
  double depth;
};
template <class T>
tally try_triangles(std::uint64_t seed, int count, const extent& e) {
  constexpr int size = 32;
  const auto mapping = irg::map_to_screen<T>({size, size});  // a guard factor of 2048
  test::random r(seed);
  tally t;
  for (int n = 0; n < count; ++n) {
    // Near the eye, far beyond the sides, with a few corners on planes.
    const int far_bits = static_cast<int>(r.integer(2, e.far));
    std::int64_t c[3][4];
    for (auto& v : c) {
      const auto any = [&](std::int64_t most) { return r.integer(-most, most); };
      v[0] = any(std::int64_t{1} << far_bits), v[1] = any(std::int64_t{1} << far_bits);
      v[3] = r.integer(e.least_w, 8), v[2] = any(8);
      const auto place = r.integer(0, 9);
      if (place == 0) v[2] = v[3];  // on the near plane
      if (place == 1) v[2] = 0;  // on the far one
      if (place == 2 && e.least_w < 0) v[0] = 2048 * v[3];  // on a side of the guard band
      if (place == 3 && e.least_w < 0) v[3] = 0;
    }
    corner<T> p[3];
    for (int i = 0; i < 3; ++i)
      p[i] = {static_cast<T>(c[i][0]), static_cast<T>(c[i][1]), static_cast<T>(c[i][2]), static_cast<T>(c[i][3])};
    const screen_pieces pieces = clip_to_screen(p, mapping, 3);
    const exact_triangle exact(c, size);
    t.cut += pieces.size() > 1;
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x) {
        int covered = 0;
        float depth = 0;
        for (const auto& [face, weights] : pieces)
          if (covers(face, x, y)) {
            ++covered;
            depth = depth_at(set_up_face(face), x, y);
          }
        t.doubled += covered > 1;
        const int side = exact.determinant == 0 ? 0 : exact.side(x, y, 2);
        t.wrong += side > 0 && covered == 0;
        t.wrong += side < 0 && covered != 0;
        if (side <= 0 || covered == 0) continue;
        ++t.inside;
        // Where the corners moved, so did the depth, by as much as it changes on the way.
        const double right = exact.depth(x + 1, y) - exact.depth(x, y),
                     down = exact.depth(x, y + 1) - exact.depth(x, y);
        const double due = exact.depth(x, y);
        t.wrong +=
            std::fabs(static_cast<double>(depth) - due) > (std::fabs(right) + std::fabs(down)) * 0x1p-7 + e.depth;
      }
  }
  return t;
}

TEST_CASE("clip_to_screen: what is left covers the pixels and has the depths of the exact triangle, in integers") {
  const auto check = [](const tally& t) {
    MESSAGE(t.cut, " triangles in several pieces, ", t.inside, " pixels inside, ", t.doubled, " in two pieces");
    CHECK(t.wrong == 0);
    CHECK(t.cut > test::trials(500));
    CHECK(t.inside > test::trials(100'000));
    CHECK(t.doubled * 1000 < t.inside);
  };
  check(try_triangles<double>(1, test::trials(4000), {13, -8, 1e-6}));
  // In floats triangles that pass the eye's plane lose up to 2^-10 of the way to the guard band.
  check(try_triangles<float>(2, test::trials(4000), {3, 1, 1e-5}));
}

// ---- hostile

// Whatever comes, comes out as faces that can be drawn.
template <class T>
void try_hostile(std::uint64_t seed) {
  const auto mapping = irg::map_to_screen<T>({640, 480});
  test::random r(seed);
  constexpr int most = std::numeric_limits<T>::max_exponent;
  int some = 0, many = 0, wrong = 0;
  for (int n = 0; n < test::trials(200'000); ++n) {
    corner<T> p[3];
    const int low = r.integer(0, 1) == 0 ? -most : -4, high = r.integer(0, 1) == 0 ? most : 4;
    for (auto& v : p) {
      for (int k = 0; k < 4; ++k) {
        const double significand = r.unit() - (k < 2 ? 0.5 : 0.25);
        v[k] = static_cast<T>(std::ldexp(significand, static_cast<int>(r.integer(low, high))));
      }
      const auto odd = r.integer(0, 30);
      if (odd == 0) v.w = v.z;
      if (odd == 1) v.z = 0;
      if (odd == 2) v.x = mapping.guard.guard_x * v.w;
      if (odd == 3) v = {};
      if (odd == 4) v.w = T(0);
      if (odd == 5) v[static_cast<int>(r.integer(0, 3))] = std::numeric_limits<T>::infinity();
      if (odd == 6) v[static_cast<int>(r.integer(0, 3))] = std::numeric_limits<T>::quiet_NaN();
      if (odd == 7) v[static_cast<int>(r.integer(0, 3))] = std::numeric_limits<T>::denorm_min();
    }
    const screen_pieces pieces = clip_to_screen(p, mapping, 9);
    some += pieces.size() > 0;
    many += pieces.size() > 1;
    std::int64_t area = 0;
    for (const auto& [face, weights] : pieces) {
      area += face.coverage.flipped ? -face.coverage.double_area : face.coverage.double_area;
      wrong += face.number != 9 || face.coverage.double_area < 0;
      wrong += face.coverage.double_area != 0 && face.coverage.flipped != (pieces.double_area < 0);
      for (const irg::screen_vertex& v : face.v) {
        // 2^15 pixels from the middle; subnormal coordinates are rounded too coarsely to keep to that.
        const auto beyond = [](std::int32_t s, int size) { return std::abs(s - 128 * size) > 256 << 16; };
        wrong += beyond(v.position.x, 640) || beyond(v.position.y, 480);
        wrong += !(0 <= v.depth && v.depth <= 1) || !(0 <= v.inverse_w && v.inverse_w <= 0x1p126f);
      }
      for (const auto& w : weights.corner) wrong += !(w.second >= 0 && w.third >= 0 && w.second + w.third <= 1.00001f);
    }
    wrong += pieces.size() > 7 || (pieces.outside && pieces.size() != 0);
    wrong += std::abs(area) < std::abs(pieces.double_area);  // pieces that were turned round are left out
    // Turned round, the triangle comes to the same area the other way round.
    const screen_pieces back = clip_to_screen({p[0], p[2], p[1]}, mapping, 9);
    wrong += back.outside != pieces.outside || back.double_area != -pieces.double_area;
  }
  MESSAGE(some, " triangles seen, ", many, " in several pieces");
  CHECK(wrong == 0);
  CHECK(some > test::trials(5'000));
  CHECK(many > test::trials(1'000));
}

TEST_CASE("clip_to_screen: hostile corners, behind the eye, on planes, of all sizes, infinite and NaN") {
  try_hostile<double>(3);
  try_hostile<float>(4);
}

}  // namespace
