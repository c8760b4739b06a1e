// SPDX-License-Identifier: MIT
#include <irg/render/draw_triangles.hpp>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <utility>
#include <vector>

#include <irg/raster/image.hpp>
#include <irg/view/projection.hpp>

#include "support/check_both.hpp"
#include "support/random.hpp"
#include "support/rendered.hpp"
#include "support/scenes.hpp"

namespace {

using irg::subpixel;
using point = irg::point<double, 3>;
using matrix = irg::mat<double, 4, 4>;
__extension__ typedef __int128 wide;

constexpr float float_ulp = 0x1p-23f;

// What drawing leaves in a pixel: which triangle (0: none), which side of it, and the weights of its second and third
// corner.
struct mark {
  std::uint32_t triangle = 0;
  irg::facing side = irg::facing::front;
  float s = 0, t = 0;
  constexpr bool operator==(const mark&) const = default;
};

struct mark_shader {
  std::uint32_t triangle;
  irg::facing side;
  constexpr mark operator()(const irg::pixel_weights<float>& at) const {
    return {triangle, side, at.weight1, at.weight2};
  }
};

struct marks {
  irg::image<mark> colour;
  irg::image<float> depth;
  irg::render_counts stats;
  constexpr marks(int width, int height) : colour(width, height, mark{}), depth(width, height, 0.0f) {}
};

// Triangles in world space and how they are looked at.
struct soup {
  std::vector<point> positions;
  std::vector<irg::triangle_indices> triangles;
  matrix to_clip;
  int width, height;
};

// Counter-clockwise fronts are seen from outside; `marks` holds triangle i as i + 1.
template <class Order = irg::nearer_is_greater, class E = irg::sequential>
constexpr marks draw(const soup& s, irg::face_culling culling = irg::face_culling::none,
                     const irg::skip_options& skip = {}, const E& executor = {}) {
  marks m(s.width, s.height);
  const auto mapping = irg::map_to_screen<double>({s.width, s.height});
  const auto vertices = irg::project_vertices<double>(s.positions, s.to_clip, mapping);
  const auto shader = [](std::uint32_t i, irg::facing side) { return mark_shader{i + 1, side}; };
  m.stats =
      irg::shade_triangles<Order, double>(irg::render_target{m.colour, m.depth}, {vertices, s.triangles, mapping},
                                          shader, {culling, skip, irg::clearing::before_drawing, mark{}}, executor);
  return m;
}

constexpr bool same(const marks& a, const marks& b) { return a.colour == b.colour && a.depth == b.depth; }

constexpr matrix eye_at_origin(double near = 0.125) {
  return irg::perspective(irg::pi<double> / 2, 1.0, near, std::numeric_limits<double>::infinity());
}

constexpr soup two_crossing_triangles() {
  // They pass through each other; the second one reaches behind the eye.
  return {{{-2, -2, -3}, {2, -2, -1}, {0, 2, -2}, {-2, 1, -1}, {1, -1, 2}, {2, 2, -4}},
          {{{0, 1, 2}}, {{3, 4, 5}}},
          eye_at_origin(),
          16,
          16};
}

TEST_CASE("shade_triangles: types") {
  static_assert(std::is_aggregate_v<irg::triangle_indices>);
  static_assert(irg::draw_options<irg::rgba8>{}.clear == irg::clearing::none);
  static_assert(irg::PixelShader<mark_shader, mark>);
}

TEST_CASE("shade_triangles: constant evaluation gives the bytes and counts of run time, clipping included") {
  static constexpr auto at_compile_time = [] {
    const marks m = draw(two_crossing_triangles());
    struct bytes {
      mark colour[16][16];
      std::uint32_t depth[16][16]{};
      irg::render_counts stats;
    } b{};
    for (int y = 0; y < 16; ++y)
      for (int x = 0; x < 16; ++x)
        b.colour[y][x] = m.colour(x, y), b.depth[y][x] = std::bit_cast<std::uint32_t>(m.depth(x, y));
    b.stats = m.stats;
    return b;
  }();
  const marks m = draw(two_crossing_triangles());
  CHECK(at_compile_time.stats.skipped == m.stats.skipped);
  CHECK(at_compile_time.stats.triangles == m.stats.triangles);
  CHECK(at_compile_time.stats.pixels.tested == m.stats.pixels.tested);
  CHECK(m.stats.pixels.shaded > 50);
  bool both_seen[3] = {};
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 16; ++x) {
      REQUIRE(at_compile_time.colour[y][x] == m.colour(x, y));
      REQUIRE(at_compile_time.depth[y][x] == std::bit_cast<std::uint32_t>(m.depth(x, y)));
      both_seen[m.colour(x, y).triangle] = true;
    }
  CHECK(both_seen[1]);
  CHECK(both_seen[2]);
}

// ---- the picture as promise 5 defines it, by brute force over pixels and triangles

// A scan line of exact fractions, as in raster/triangle_coverage_test.cpp: top <= y < bottom and left <= x < right.
bool oracle_covers(const subpixel (&v)[3], int px, int py) {
  const std::int64_t x = std::int64_t{px} * 256 + 128, y = std::int64_t{py} * 256 + 128;
  int crossings_at_or_left = 0;
  for (int i = 0; i < 3; ++i) {
    subpixel p = v[i], q = v[(i + 1) % 3];
    if (p.y > q.y) std::swap(p, q);
    if (!(p.y <= y && y < q.y)) continue;
    if (wide{p.x} * (q.y - p.y) + wide{y - p.y} * (q.x - p.x) <= wide{x} * (q.y - p.y)) ++crossings_at_or_left;
  }
  return crossings_at_or_left == 1;
}

struct agreement {
  long long pixels = 0, covered = 0, rounding = 0, wrong = 0;
};

// Compares a drawn scene, none of whose vertices was clipped, with the definition: nearest of the covering triangles,
// depths from the plane through the snapped vertices in long double, the first of equals. Where another triangle was
// drawn, their depths must lie within 8 ulp of a float, 4 for each.
void compare_with_definition(const soup& s, irg::face_culling culling, agreement& sum) {
  const marks m = draw(s, culling);
  const auto mapping = irg::map_to_screen<double>({s.width, s.height});
  const auto vertices = irg::project_vertices<double>(s.positions, s.to_clip, mapping);
  const std::size_t pixels = static_cast<std::size_t>(s.width) * static_cast<std::size_t>(s.height);
  std::vector<long double> best(pixels, 0);
  std::vector<std::uint32_t> first(pixels, 0);
  std::vector<std::vector<long double>> depth_of(s.triangles.size(), std::vector<long double>(pixels, -1));
  for (std::uint32_t i = 0; i < s.triangles.size(); ++i) {
    subpixel v[3];
    long double z[3];
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t index = s.triangles[i].v[k];
      REQUIRE(vertices.codes[index].cut == 0);
      v[k] = vertices.screen[index].position;
      z[k] = static_cast<long double>(irg::clip_position(vertices, index).z) /
             static_cast<long double>(irg::clip_position(vertices, index).w);
    }
    const auto at = [](const subpixel& p, const subpixel& q, const subpixel& r) {
      return static_cast<long double>(wide{q.x - p.x} * (r.y - p.y) - wide{q.y - p.y} * (r.x - p.x));
    };
    const long double area = at(v[0], v[1], v[2]);
    if (culling == irg::face_culling::back && area > 0) continue;
    const auto low = [&](auto member) { return std::min({v[0].*member, v[1].*member, v[2].*member}) / 256 - 2; };
    const auto high = [&](auto member) { return std::max({v[0].*member, v[1].*member, v[2].*member}) / 256 + 2; };
    for (int y = std::max(0, low(&subpixel::y)); y < std::min(s.height, high(&subpixel::y)); ++y)
      for (int x = std::max(0, low(&subpixel::x)); x < std::min(s.width, high(&subpixel::x)); ++x) {
        if (!oracle_covers(v, x, y)) continue;
        const subpixel p{x * 256 + 128, y * 256 + 128};
        // Exact where the three depths are equal.
        const long double d = z[0] + ((z[1] - z[0]) * at(v[2], v[0], p) + (z[2] - z[0]) * at(v[0], v[1], p)) / area;
        const auto pixel = static_cast<std::size_t>(y * s.width + x);
        depth_of[i][pixel] = d;
        if (first[pixel] == 0 || d > best[pixel]) best[pixel] = d, first[pixel] = i + 1;
      }
  }
  for (int y = 0; y < s.height; ++y)
    for (int x = 0; x < s.width; ++x) {
      const auto pixel = static_cast<std::size_t>(y * s.width + x);
      const std::uint32_t drawn = m.colour(x, y).triangle;
      ++sum.pixels;
      sum.covered += first[pixel] != 0;
      if (drawn == first[pixel]) continue;
      const long double d = drawn == 0 || first[pixel] == 0 ? -1 : depth_of[drawn - 1][pixel];
      const bool close = d > 0 && std::fabs(best[pixel] - d) <= 8 * static_cast<long double>(float_ulp) * best[pixel];
      ++(close ? sum.rounding : sum.wrong);
    }
}

soup random_visible_soup(test::random& r, int width, int height, double reach = 1.0) {
  soup s{{}, {}, eye_at_origin(), width, height};
  const int triangles = static_cast<int>(r.integer(1, 24));
  const bool flat = r.integer(0, 3) == 0;     // all at one depth: ties
  const bool lattice = r.integer(0, 3) == 0;  // corners on a lattice of half pixels: edges through centres
  for (int i = 0; i < triangles; ++i) {
    const double size = std::ldexp(1.0, static_cast<int>(r.integer(-4, 2)));
    const double cx = reach * (2 * r.unit() - 1), cy = reach * (2 * r.unit() - 1),
                 depth = flat ? 3.0 : 0.5 + 6 * r.unit();
    for (int k = 0; k < 3; ++k) {
      if (!s.positions.empty() && r.integer(0, 4) == 0) continue;  // shares a corner with an earlier one
      const double z = flat ? depth : std::fmax(0.25, depth + size * (r.unit() - 0.5));
      if (lattice) {
        const auto coordinate = [&] { return static_cast<double>(r.integer(-64, 64)) / 64 * reach; };
        const double power_of_two = std::ldexp(1.0, flat ? 1 : static_cast<int>(r.integer(0, 2)));
        s.positions.push_back({coordinate() * power_of_two, coordinate() * power_of_two, -power_of_two});
        continue;
      }
      s.positions.push_back(
          {(cx + reach * size * (r.unit() - 0.5)) * z, (cy + reach * size * (r.unit() - 0.5)) * z, -z});
    }
    const auto any = [&](int back) {
      const auto n = static_cast<std::int64_t>(s.positions.size());
      return static_cast<std::uint32_t>(back < n && r.integer(0, 9) != 0 ? n - 1 - back : r.integer(0, n - 1));
    };
    s.triangles.push_back({{any(0), any(1), any(2)}});
  }
  return s;
}

TEST_CASE("shade_triangles: the nearest of the covering triangles in every pixel, on random scenes") {
  test::random r(101);
  const int scenes = std::getenv("IRG_RELEASE_TIER") ? 10000 : 1000;
  agreement sum;
  for (int i = 0; i < scenes; ++i) {
    const soup s = random_visible_soup(r, 64, 64);
    compare_with_definition(s, i % 3 == 0 ? irg::face_culling::back : irg::face_culling::none, sum);
  }
  MESSAGE(scenes, " scenes, ", sum.covered, " of ", sum.pixels, " pixels covered, ", sum.rounding,
          " with two depths within 8 ulp, ", sum.wrong, " wrong");
  CHECK(sum.covered > sum.pixels / 4);
  CHECK(sum.rounding < sum.covered / 1000);
  CHECK(sum.wrong == 0);
}

TEST_CASE("shade_triangles: pictures of every shape, narrower than the lanes and higher than a band") {
  test::random r(102);
  agreement sum;
  for (int width = 1; width <= 20; ++width)
    for (const int height : {1, 2, 31, 32, 33, 65})
      compare_with_definition(random_visible_soup(r, width, height), irg::face_culling::none, sum);
  CHECK(sum.covered > 0);
  CHECK(sum.wrong == 0);
}

TEST_CASE("shade_triangles: 1 x 1, 65535 x 1 and 1 x 65535") {
  test::random r(103);
  agreement sum;
  for (int i = 0; i < 8; ++i) {
    compare_with_definition(random_visible_soup(r, 1, 1), irg::face_culling::none, sum);
    soup s = random_visible_soup(r, 65535, 1, 0.3);
    s.triangles.resize(1);
    compare_with_definition(s, irg::face_culling::none, sum);
    std::swap(s.width, s.height);
    compare_with_definition(s, irg::face_culling::none, sum);
  }
  CHECK(test::enough(sum.covered > 1000));
  CHECK(sum.wrong == 0);
}

// ---- clipping: the ray through the pixel's centre against the triangle in space

struct ray_hit {
  bool unsure = false;  // the centre is so near to an edge or a depth plane that snapping may decide
  bool hit = false, front = false;
  long double depth = 0, slope = 0;  // change of depth over a pixel, at most
  long double s = 0, t = 0;          // weights of the second and third corner
};

// With C the matrix of the corners' x, y, w, the point of the triangle under (nx, ny) has weights in proportion to
// adj(C) (nx, ny, 1), and these divided by det(C) are weights over w: linear over the picture. Depth is their sum
// weighed by z.
struct ray_oracle {
  long double l[3][3];  // weight i over w is l[i] . (px, py, 1) in pixels
  long double z[3];
  long double det;

  ray_oracle(const soup& scene, const irg::triangle_indices& triangle) {
    long double c[3][3];
    for (int k = 0; k < 3; ++k) {
      const irg::hpoint<double, 3> p = scene.to_clip * scene.positions[triangle.v[k]];
      const auto exact = [](double v) { return static_cast<long double>(v); };
      c[0][k] = exact(p.x), c[1][k] = exact(p.y), c[2][k] = exact(p.w), z[k] = exact(p.z);
    }
    for (int i = 0; i < 3; ++i) {
      const int a = (i + 1) % 3, b = (i + 2) % 3;
      const long double x = c[1][a] * c[2][b] - c[2][a] * c[1][b], y = c[2][a] * c[0][b] - c[0][a] * c[2][b],
                        w = c[0][a] * c[1][b] - c[1][a] * c[0][b];
      // nx = 2 px / width - 1, ny = 1 - 2 py / height
      l[i][0] = x * 2 / scene.width, l[i][1] = -y * 2 / scene.height, l[i][2] = w - x + y;
    }
    det = c[0][0] * (c[1][1] * c[2][2] - c[2][1] * c[1][2]) - c[0][1] * (c[1][0] * c[2][2] - c[2][0] * c[1][2]) +
          c[0][2] * (c[1][0] * c[2][1] - c[2][0] * c[1][1]);
  }

  ray_hit operator()(int x, int y) const {
    const long double px = x + 0.5L, py = y + 0.5L, margin = 0.02L;
    ray_hit h;
    bool outside = false;
    long double v[3];
    for (int i = 0; i < 3; ++i) {
      v[i] = l[i][0] * px + l[i][1] * py + l[i][2];
      const long double reach = margin * std::hypot(l[i][0], l[i][1]);
      if (det < 0) v[i] = -v[i];
      h.unsure = h.unsure || std::fabs(v[i]) <= reach;
      outside = outside || v[i] < -reach;
    }
    if (outside || h.unsure) return h.unsure = h.unsure && !outside, h;
    if (det == 0) return h;
    const long double scale = std::fabs(det), inverse_w = (v[0] + v[1] + v[2]) / scale;
    h.depth = (v[0] * z[0] + v[1] * z[1] + v[2] * z[2]) / scale;
    const auto gradient = [&](int k) { return (l[0][k] * z[0] + l[1][k] * z[1] + l[2][k] * z[2]) / scale; };
    h.slope = std::hypot(gradient(0), gradient(1));
    if (std::fabs(h.depth - 1) <= margin * h.slope + 1e-6L || h.depth <= margin * h.slope) return h.unsure = true, h;
    h.hit = h.depth < 1;
    h.front = det > 0;
    h.s = v[1] / scale / inverse_w, h.t = v[2] / scale / inverse_w;
    return h;
  }
};

struct ray_agreement {
  long long pixels = 0, compared = 0, covered = 0, wrong = 0;
  long double worst_weight = 0;
};

void compare_with_rays(const soup& s, irg::face_culling culling, ray_agreement& sum) {
  const marks m = draw(s, culling);
  std::vector<ray_oracle> oracles;
  for (const auto& t : s.triangles) oracles.emplace_back(s, t);
  for (int y = 0; y < s.height; ++y)
    for (int x = 0; x < s.width; ++x) {
      ++sum.pixels;
      bool unsure = false;
      ray_hit best;
      std::uint32_t first = 0;
      long double uncertainty = 0;
      for (std::uint32_t i = 0; i < oracles.size(); ++i) {
        const ray_hit h = oracles[i](x, y);
        unsure = unsure || h.unsure;
        if (!h.hit || (culling == irg::face_culling::back && !h.front)) continue;
        // Snapping moves corners by less than 0.003 pixels.
        const long double own = 0.02L * h.slope + 1e-6L * h.depth;
        if (first != 0 && std::fabs(h.depth - best.depth) <= own + uncertainty) unsure = true;
        if (first == 0 || h.depth > best.depth) best = h, first = i + 1, uncertainty = own;
      }
      if (unsure) continue;
      ++sum.compared;
      sum.covered += first != 0;
      const mark& drawn = m.colour(x, y);
      const bool right =
          drawn.triangle == first &&
          (first == 0 || (drawn.side == (best.front ? irg::facing::front : irg::facing::back) &&
                          std::fabs(static_cast<long double>(m.depth(x, y)) - best.depth) <= uncertainty));
      if (!right) ++sum.wrong;
      if (right && first != 0 && s.triangles.size() == 1) {
        // The weights, where they do not change fast enough for snapping to matter.
        const ray_hit beside = oracles[0](x + 1, y), below = oracles[0](x, y + 1);
        const auto change = [&](auto weight) {
          return std::fabs(beside.*weight - best.*weight) + std::fabs(below.*weight - best.*weight);
        };
        if (!beside.hit || !below.hit || change(&ray_hit::s) + change(&ray_hit::t) > 0.1L) continue;
        sum.worst_weight = std::fmax(sum.worst_weight, std::fabs(static_cast<long double>(drawn.s) - best.s));
        sum.worst_weight = std::fmax(sum.worst_weight, std::fabs(static_cast<long double>(drawn.t) - best.t));
      }
    }
}

TEST_CASE("shade_triangles: vertices behind the eye, beside it and beyond the guard band, against rays") {
  test::random r(104);
  const int scenes = std::getenv("IRG_RELEASE_TIER") ? 10000 : 600;
  ray_agreement sum;
  for (int i = 0; i < scenes; ++i) {
    soup s{{}, {}, eye_at_origin(), 48, 32};
    const int triangles = i % 2 ? 1 : static_cast<int>(r.integer(2, 10));
    for (int k = 0; k < triangles; ++k) {
      const auto n = static_cast<std::uint32_t>(s.positions.size());
      const double size = std::ldexp(1.0, static_cast<int>(r.integer(-1, i % 5 == 0 ? 12 : 3)));
      for (int v = 0; v < 3; ++v) {
        // Sixteenths: many have w = 0 exactly or lie on a clip plane, and some triangles pass through the eye.
        const auto coordinate = [&] { return static_cast<double>(r.integer(-32, 32)) / 16 * size; };
        point p{coordinate(), coordinate(), coordinate()};
        if (r.integer(0, 7) == 0) p.z = 0;
        if (r.integer(0, 31) == 0) p = {0, 0, 0};
        s.positions.push_back(p);
      }
      if (r.integer(0, 15) == 0)  // in a plane with the eye
        s.positions[n + 2] = point{} + ((point{} - s.positions[n]) + (point{} - s.positions[n + 1])) * 0.5;
      s.triangles.push_back({{n, n + 1, n + 2}});
    }
    compare_with_rays(s, i % 3 == 0 ? irg::face_culling::back : irg::face_culling::none, sum);
  }
  MESSAGE(sum.compared, " of ", sum.pixels, " pixels compared, ", sum.covered, " covered, ", sum.wrong,
          " wrong; weights off by ", static_cast<double>(sum.worst_weight), " at most");
  CHECK(sum.compared > sum.pixels / 100 * 80);
  CHECK(sum.covered > sum.pixels / 20);
  CHECK(sum.wrong == 0);
  CHECK(sum.worst_weight < 0.01L);
}

TEST_CASE("shade_triangles: each corner in each of the 27 cells that the clip planes cut") {
  test::random r(105);
  ray_agreement sum;
  const matrix finite = irg::perspective(irg::pi<double> / 2, 1.0, 1.0, 4.0);
  const auto cell = [&](int number) {
    const auto in = [&](int which) { return which + r.unit() * 0.8 + 0.1; };  // 0: below, 1: within, 2: above
    const double w = in(number / 9) * 3 - 2;                                  // -2..1..4..7
    const double x = (in(number % 3) * 2 - 3) * std::fabs(w), y = (in(number / 3 % 3) * 2 - 3) * std::fabs(w);
    return point{x, y, -w};
  };
  for (int a = 0; a < 27; ++a)
    for (int b = a; b < 27; ++b)
      for (int c = b; c < 27; ++c) {
        const soup s{{cell(a), cell(b), cell(c)}, {{{0, 1, 2}}}, finite, 12, 12};
        compare_with_rays(s, irg::face_culling::none, sum);
      }
  MESSAGE(sum.compared, " of ", sum.pixels, " pixels compared, ", sum.covered, " covered, ", sum.wrong, " wrong");
  CHECK(sum.covered > sum.pixels / 20);
  CHECK(sum.wrong == 0);
}

TEST_CASE("shade_triangles: weights in a triangle whose corners' distances differ 100,000 times") {
  ray_agreement sum;
  const soup s{
      {{-0.3, -0.3, -0.3}, {20000, -5000, -30000}, {-5000, 20000, -30000}}, {{{0, 1, 2}}}, eye_at_origin(), 200, 200};
  compare_with_rays(s, irg::face_culling::none, sum);
  CHECK(sum.covered > 5000);
  CHECK(sum.wrong == 0);
  CHECK(sum.worst_weight < 0.002L);
}

// ---- no cracks

// A cube around the eye, each side cut into n x n squares, each of these into two triangles, turned at random.
soup cube_around(test::random& r, int n, int width, int height) {
  soup s{{}, {}, {}, width, height};
  for (int side = 0; side < 6; ++side) {
    const auto first = static_cast<std::uint32_t>(s.positions.size());
    for (int i = 0; i <= n; ++i)
      for (int k = 0; k <= n; ++k) {
        const double a = 2.0 * i / n - 1, b = 2.0 * k / n - 1, c = side % 2 ? 1 : -1;
        s.positions.push_back(side / 2 == 0 ? point{c, a, b} : side / 2 == 1 ? point{a, c, b} : point{a, b, c});
      }
    for (int i = 0; i < n; ++i)
      for (int k = 0; k < n; ++k) {
        const std::uint32_t p = first + static_cast<std::uint32_t>(i * (n + 1) + k), q = p + 1,
                            u = p + static_cast<std::uint32_t>(n + 1), v = u + 1;
        if (r.integer(0, 1)) {
          s.triangles.push_back({{p, q, v}}), s.triangles.push_back({{p, v, u}});
        } else {
          s.triangles.push_back({{p, q, u}}), s.triangles.push_back({{q, v, u}});
        }
      }
  }
  return s;
}

TEST_CASE("shade_triangles: inside a cube of triangles every pixel is covered exactly once") {
  test::random r(106);
  const int trials = std::getenv("IRG_RELEASE_TIER") ? 20000 : 600;
  long long holes = 0, doubled = 0;
  for (int i = 0; i < trials; ++i) {
    soup s = cube_around(r, static_cast<int>(r.integer(1, 5)), 64, 48);
    const double margin = i % 3 == 0 ? 0.9999 : 0.7;  // near the walls, where most is clipped
    const point eye{margin * (2 * r.unit() - 1), margin * (2 * r.unit() - 1), margin * (2 * r.unit() - 1)};
    const irg::camera<double> c{eye, {2 * r.unit() - 1, 2 * r.unit() - 1, 2 * r.unit() - 1}, {0, 1, 0},
                                {},  irg::radians(static_cast<double>(r.integer(10, 140))),  1e-6};
    s.to_clip = irg::view_projection(c, 64.0 / 48);
    const marks m = draw(s);
    for (int y = 0; y < s.height; ++y)
      for (int x = 0; x < s.width; ++x) holes += m.colour(x, y).triangle == 0;
    doubled += m.stats.pixels.tested - 64 * 48;
  }
  MESSAGE(trials, " views, ", holes, " holes, ", doubled, " pixels covered twice");
  CHECK(holes == 0);
  CHECK(doubled == 0);
}

TEST_CASE("shade_triangles: a corner exactly on a clip plane") {
  // The near plane is at distance 1, and the corner is on it; its neighbour beyond the edge is behind the eye.
  const soup s{
      {{-1, -1, -1}, {1, -1, -1}, {0, 1, -1}, {0, -3, 2}}, {{{0, 1, 2}}, {{1, 0, 3}}}, eye_at_origin(1), 32, 32};
  const marks whole = draw(s);
  soup one = s;
  one.triangles.pop_back();
  const marks alone = draw(one);
  CHECK(same(whole, alone));  // the neighbour touches the plane with an edge, no more
  CHECK(alone.stats.pixels.shaded == 32 * 32 / 2);
}

// ---- order

TEST_CASE("shade_triangles: of equal depths the lowest index wins, in either direction") {
  soup s{{{-1, -1, -2}, {1, -1, -2}, {0, 1, -3}}, {{{0, 1, 2}}, {{0, 1, 2}}, {{0, 2, 1}}}, eye_at_origin(), 32, 32};
  const marks m = draw(s);
  CHECK(m.stats.pixels.shaded > 50);
  CHECK(m.stats.pixels.ties == 2 * m.stats.pixels.shaded);
  CHECK(m.stats.pixels.tested == 3 * m.stats.pixels.shaded);
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 32; ++x) REQUIRE(m.colour(x, y).triangle <= 1);
}

TEST_CASE("shade_triangles: in drawing order the last one wins, whatever its depth") {
  const soup s{{{-1, -1, -2}, {1, -1, -2}, {0, 1, -2}, {-2, -2, -5}, {2, -2, -5}, {0, 2, -5}},
               {{{0, 1, 2}}, {{3, 4, 5}}},
               eye_at_origin(),
               32,
               32};
  const marks m = draw<irg::drawing_order>(s);
  soup far = s;
  far.triangles = {{{3, 4, 5}}};
  const marks alone = draw<irg::drawing_order>(far);
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 32; ++x) {
      if (alone.colour(x, y).triangle == 0) continue;
      REQUIRE(m.colour(x, y).triangle == 2);
      REQUIRE(m.depth(x, y) == alone.depth(x, y));
    }
  CHECK(m.stats.pixels.shaded < m.stats.pixels.tested);  // what is covered later is not shaded
}

TEST_CASE("shade_triangles: in drawing order nothing is kept because it is as near, so nothing ties") {
  const auto ties_of_copies = [] {
    soup s{{{-1, -1, -2}, {1, -1, -2}, {0, 1, -2}}, {{{0, 1, 2}}, {{0, 1, 2}}}, eye_at_origin(), 8, 8};
    return draw<irg::drawing_order>(s).stats.pixels.ties;
  };
  CHECK_BOTH(ties_of_copies() == 0);
}

TEST_CASE("shade_triangles: any order of triangles gives the same picture where no depths are equal") {
  test::random r(107);
  int compared = 0;
  for (int scene = 0; scene < 40; ++scene) {
    const soup s = random_visible_soup(r, 48, 48);
    const marks expected = draw(s);
    if (expected.stats.pixels.ties != 0) continue;
    for (int shuffle = 0; shuffle < 10; ++shuffle) {
      std::vector<std::uint32_t> order(s.triangles.size());
      for (std::uint32_t i = 0; i < order.size(); ++i) {
        order[i] = i;
        std::swap(order[i], order[static_cast<std::size_t>(r.integer(0, i))]);
      }
      soup t = s;
      for (std::size_t i = 0; i < order.size(); ++i) t.triangles[i] = s.triangles[order[i]];
      marks m = draw(t);
      if (m.stats.pixels.ties != 0) continue;
      for (int y = 0; y < 48; ++y)
        for (int x = 0; x < 48; ++x)
          if (m.colour(x, y).triangle != 0) m.colour(x, y).triangle = order[m.colour(x, y).triangle - 1] + 1;
      REQUIRE(same(m, expected));
      ++compared;
    }
  }
  CHECK(compared >= 100);
}

// ---- skipping, executors, counters

TEST_CASE("shade_triangles: counters by hand") {
  // One seen, one facing away, one beside the picture, one behind the eye, one smaller than a pixel, one edge-on, one
  // that is clipped and seen.
  const soup s{{{-1, -1, -2},
                {1, -1, -2},
                {0, 1, -2},
                {50, 0, -2},
                {51, 0, -2},
                {50, 1, -2},
                {0, 0, 2},
                {1, 0, 2},
                {0, 1, 2},
                {0.51, 0.51, -8},
                {0.511, 0.51, -8},
                {0.51, 0.511, -8},
                {-0.5, -0.5, -1},
                {0.5, -0.5, 1},
                {0.2, -0.6, -1}},
               {{{0, 1, 2}}, {{0, 2, 1}}, {{3, 4, 5}}, {{6, 7, 8}}, {{9, 10, 11}}, {{0, 1, 1}}, {{12, 13, 14}}},
               eye_at_origin(),
               32,
               32};
  const auto on = draw(s, irg::face_culling::back).stats,
             off = draw(s, irg::face_culling::back, irg::skip_nothing).stats;
  CHECK(on.triangles == 7);
  CHECK(on.skipped.backface == 1);
  CHECK(on.skipped.frustum == 2);
  CHECK(on.skipped.tiny == 2);
  CHECK(on.skipped.occluded == 0);
  CHECK(on.clipped == 1);  // the last one
  CHECK(off.clipped == 1);
  CHECK(off.skipped == irg::skip_counts{0, 1, 0, 0});
  CHECK(off.pixels.shaded == on.pixels.shaded);
  CHECK(draw(s, irg::face_culling::none, irg::skip_nothing).stats.skipped == irg::skip_counts{});
  CHECK(draw(s, irg::face_culling::none).stats.skipped.backface == 0);
}

TEST_CASE("shade_triangles: skipping changes no byte, on triangles anywhere") {
  test::random r(108);
  for (int i = 0; i < 1500; ++i) {
    soup s{{},
           {},
           eye_at_origin(i % 2 ? 0.125 : 1e-6),
           static_cast<int>(r.integer(1, 40)),
           static_cast<int>(r.integer(1, 70))};
    for (int k = 0; k < 60; ++k)
      s.positions.push_back(
          test::random_position<double>(r, i % 3 == 0 ? test::positions::hostile : test::positions::everywhere));
    for (int k = 0; k < 40; ++k) {
      const auto any = [&] { return static_cast<std::uint32_t>(r.integer(0, 59)); };
      s.triangles.push_back({{any(), any(), any()}});
    }
    const auto culling = r.integer(0, 1) ? irg::face_culling::back : irg::face_culling::none;
    const marks on = draw(s, culling), off = draw(s, culling, irg::skip_nothing);
    REQUIRE(same(on, off));
    REQUIRE(on.stats.pixels.shaded == off.stats.pixels.shaded);
    REQUIRE(on.stats.pixels.tested <= off.stats.pixels.tested);
    REQUIRE(off.stats.skipped.frustum + off.stats.skipped.tiny + off.stats.skipped.occluded == 0);
    if (culling == irg::face_culling::none) REQUIRE(on.stats.skipped.backface + off.stats.skipped.backface == 0);
    REQUIRE(on.stats.skipped.backface <= off.stats.skipped.backface);  // out of sight comes first
  }
}

TEST_CASE("shade_triangles: skipping changes no byte so far away that depths are hardly numbers") {
  test::random r(7);
  int drawn = 0;
  for (int i = 0; i < 100; ++i) {
    soup s{{}, {}, eye_at_origin(0.125), 100, 80};
    const int size = static_cast<int>(r.integer(115, 146));
    for (std::uint32_t k = 0; k < 180; k += 3) {
      for (int corner = 0; corner < 3; ++corner) {
        const double away = std::ldexp(1 + r.unit(), size);
        s.positions.push_back({(3 * r.unit() - 1.5) * away, (3 * r.unit() - 1.5) * away, -away});
      }
      s.triangles.push_back({{k, k + 1, k + 2}});
    }
    const marks on = draw(s), off = draw(s, irg::face_culling::none, irg::skip_nothing);
    REQUIRE(same(on, off));
    drawn += off.stats.drawn > 0 ? 1 : 0;
  }
  CHECK(drawn > 90);
}

TEST_CASE("shade_triangles: skipping beyond a border does not depend on how clipping is rounded") {
  // All corners are beyond the right border, and some so far out that clipping them rounds by whole pictures.
  test::random r(111);
  int rounded_into_sight = 0;
  for (int i = 0; i < 3000; ++i) {
    soup s{{}, {{{0, 1, 2}}}, irg::orthographic(irg::view_window<double>{-1, 1, -1, 1}, -2, 2), 32, 32};
    for (int k = 0; k < 3; ++k) {
      const bool far = r.integer(0, 2) == 0;
      const auto coordinate = [&] { return test::number_of_any_size(r, far ? 40 : 0, far ? 100 : 4); };
      s.positions.push_back({1.001 + std::fabs(coordinate()), coordinate(), coordinate()});
    }
    const marks on = draw(s), off = draw(s, irg::face_culling::none, irg::skip_nothing);
    REQUIRE(same(on, off));
    REQUIRE(on.stats.pixels.shaded == off.stats.pixels.shaded);
    REQUIRE(on.stats.pixels.tested <= off.stats.pixels.tested);
    rounded_into_sight += on.stats.pixels.shaded > 0;
  }
  CHECK(rounded_into_sight > 10);
}

TEST_CASE("shade_triangles: triangles that are not finite are left out, and the rest is as it was") {
  test::random r(109);
  constexpr double infinite = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 100; ++i) {
    const soup s = random_visible_soup(r, 40, 40);
    soup t = s;
    const auto n = static_cast<std::uint32_t>(s.positions.size());
    t.positions.push_back({-1, -1, -0.2}), t.positions.push_back({1, -1, -0.2}), t.positions.push_back({0, 1, -0.2});
    t.positions[n + static_cast<std::uint32_t>(i % 3)][i / 3 % 3] = i % 4 == 0
                                                                        ? std::numeric_limits<double>::quiet_NaN()
                                                                    : i % 4 == 1 ? infinite
                                                                    : i % 4 == 2 ? -infinite
                                                                                 : 1.7e308;
    t.triangles.push_back({{n, n + 1, n + 2}});
    for (const auto skip : {irg::skip_options{}, irg::skip_nothing}) {
      const marks m = draw(t, irg::face_culling::none, skip);
      REQUIRE(same(m, draw(s)));
    }
  }
}

TEST_CASE("shade_triangles: every executor gives the same bytes and counts") {
  test::random r(110);
  for (int i = 0; i < 60; ++i) {
    soup s = random_visible_soup(r, 50, 150);
    s.positions.push_back({0, -1, 5});
    s.triangles.push_back({{0, static_cast<std::uint32_t>(s.positions.size() - 1), 0}});
    s.triangles.back().v[2] = static_cast<std::uint32_t>(s.positions.size() / 2);
    const marks one = draw(s), other = draw(s, irg::face_culling::none, irg::skip_options{}, test::backwards{});
    REQUIRE(same(one, other));
    REQUIRE(one.stats == other.stats);
  }
}

TEST_CASE("shade_triangles: without a background it adds to what is there") {
  const soup s{{{-1, -1, -2}, {1, -1, -2}, {0, 1, -2}}, {{{0, 1, 2}}}, eye_at_origin(), 16, 16};
  const auto mapping = irg::map_to_screen<double>({16, 16});
  const auto vertices = irg::project_vertices<double>(s.positions, s.to_clip, mapping);
  irg::image<int> colour(16, 16, 7);
  irg::image<float> depth(16, 16, 0.0f);
  depth(8, 10) = 1.0f;  // something very near
  const auto shader = [](std::uint32_t, irg::facing) { return irg::solid_shader<int>{9}; };
  irg::shade_triangles(irg::render_target{colour, depth}, {vertices, s.triangles, mapping}, shader);
  CHECK(colour(8, 8) == 9);
  CHECK(colour(8, 10) == 7);
  CHECK(colour(0, 0) == 7);
}

TEST_CASE("shade_triangles: in drawing order a dot over a large triangle stays where it was put") {
  // Side by side in the list: large, dot, large, dot...; the last dot and the last large triangle are seen.
  soup s{{{-2, -2, -2}, {2, -2, -2}, {0, 3, -2}}, {}, eye_at_origin(), 32, 32};
  for (int i = 0; i < 12; ++i) {
    const double x = -0.9 + 0.15 * i;
    const auto v = static_cast<std::uint32_t>(s.positions.size());
    for (const point& p : {point{x, -0.5, -2}, point{x + 0.25, -0.5, -2}, point{x, -0.25, -2}})
      s.positions.push_back(p);
    s.triangles.push_back({{0, 1, 2}});
    s.triangles.push_back({{v, v + 1, v + 2}});
  }
  for (std::size_t last = 1; last <= s.triangles.size(); ++last) {
    soup part = s;
    part.triangles.resize(last);
    const marks fast = draw<irg::drawing_order>(part);
    std::vector<std::uint32_t> seen(32 * 32, 0);  // one after the other
    for (std::uint32_t i = 0; i < last; ++i) {
      soup one = s;
      one.triangles = {s.triangles[i]};
      const marks m = draw<irg::drawing_order>(one);
      for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 32; ++x)
          if (m.colour(x, y).triangle != 0) seen[static_cast<std::size_t>(y * 32 + x)] = i + 1;
    }
    bool equal = true;
    for (int y = 0; y < 32; ++y)
      for (int x = 0; x < 32; ++x)
        equal = equal && fast.colour(x, y).triangle == seen[static_cast<std::size_t>(y * 32 + x)];
    REQUIRE(equal);
  }
}

TEST_CASE("shade_triangles: no triangles, and pictures without pixels") {
  const soup nothing{{}, {}, eye_at_origin(), 8, 8};
  CHECK(draw(nothing).stats == irg::render_counts{});
  CHECK(draw(nothing).colour(3, 3) == mark{});
  const soup flat{{}, {}, eye_at_origin(), 8, 0};
  CHECK(draw(flat).stats == irg::render_counts{});
}

}  // namespace
