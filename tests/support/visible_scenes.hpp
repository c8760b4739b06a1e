// SPDX-License-Identifier: MIT
// Triangles that hide each other, seeded and of every kind; the picture that irg draws of them, as numbers of the
// visible triangles; and the same triangles as the screen sees them, for an oracle.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include <irg/raster/image.hpp>
#include <irg/render/draw_triangles.hpp>
#include <irg/view/projection.hpp>

#include "support/random.hpp"
#include "support/visibility_oracle.hpp"

namespace test {

/// Triangles in the space of a camera (the eye at the origin, the view along -z) and the picture they are drawn into.
struct triangle_scene {
  std::vector<irg::point<double, 3>> positions;
  std::vector<irg::triangle_indices> triangles;
  irg::mat<double, 4, 4> to_clip;
  int width, height;
};

/// Numbers of the visible triangles, counted from 1, or 0, and their depths.
struct id_picture {
  irg::image<std::uint32_t> id;
  irg::image<float> depth;
  irg::render_counts stats;
  constexpr bool same(const id_picture& o) const { return id == o.id && depth == o.depth; }
};

/// A scene's positions and matrix in the numbers that it is drawn with.
template <irg::Floating T>
constexpr std::vector<irg::point<T, 3>> positions_in(const triangle_scene& s) {
  std::vector<irg::point<T, 3>> positions;
  for (const auto& p : s.positions)
    positions.push_back({static_cast<T>(p.x), static_cast<T>(p.y), static_cast<T>(p.z)});
  return positions;
}
template <irg::Floating T>
constexpr irg::mat<T, 4, 4> matrix_in(const triangle_scene& s) {
  irg::mat<T, 4, 4> m{};
  for (int i = 0; i < 16; ++i) m(i / 4, i % 4) = static_cast<T>(s.to_clip(i / 4, i % 4));
  return m;
}

/// What irg draws, with T for vertices.
template <irg::DepthOrder Order = irg::nearer_is_greater, irg::Floating T = double, class E = irg::sequential>
constexpr id_picture visible_ids(const triangle_scene& s, irg::face_culling culling = irg::face_culling::none,
                                 const irg::skip_options& skip = {}, const E& executor = {}) {
  id_picture p{irg::image<std::uint32_t>(s.width, s.height, 9999u), irg::image<float>(s.width, s.height, 0.5f), {}};
  const auto mapping = irg::map_to_screen<T>({s.width, s.height});
  const auto positions = positions_in<T>(s);
  const auto vertices = irg::project_vertices<T>(positions, matrix_in<T>(s), mapping);
  const auto shader = [](std::uint32_t triangle, irg::facing) {
    return irg::solid_shader<std::uint32_t>{triangle + 1};
  };
  const irg::draw_options<std::uint32_t> settings{culling, skip, irg::clearing::before_drawing, 0};
  p.stats = irg::shade_triangles<Order, T>(irg::render_target{p.id, p.depth}, {vertices, s.triangles, mapping}, shader,
                                           settings, executor);
  return p;
}

/// The same triangles on the screen, for the oracle: projected and snapped once; what clipping leaves of one as a fan.
/// Fronts have negative areas there, because y is down.
template <irg::Floating T = double>
std::vector<snapped_triangle> snapped_triangles(const triangle_scene& s, irg::face_culling culling) {
  const auto mapping = irg::map_to_screen<T>({s.width, s.height});
  const auto positions = positions_in<T>(s);
  const auto to_clip = matrix_in<T>(s);
  std::vector<snapped_triangle> list;
  for (std::uint32_t i = 0; i < s.triangles.size(); ++i) {
    irg::clip_vertex<T, 0> corner[3];
    for (std::size_t k = 0; k < 3; ++k) corner[k].position = to_clip * positions[s.triangles[i].v[k]];
    const auto left = irg::clip_homogeneous(corner, mapping.guard);
    std::vector<irg::screen_vertex> on_screen;
    for (const auto& v : left) on_screen.push_back(irg::to_screen(v.position, mapping));
    const auto area_of = [&](std::size_t k) {
      return irg::twice_signed_area(on_screen[0].position, on_screen[k].position, on_screen[k + 1].position);
    };
    std::int64_t area = 0;
    for (std::size_t k = 1; k + 1 < on_screen.size(); ++k) area += area_of(k);
    if (area == 0 || (area > 0 && culling == irg::face_culling::back)) continue;
    // A piece thinner than 1/256 pixel may be turned round by snapping; the pieces beside it cover its place.
    for (std::size_t k = 1; k + 1 < on_screen.size(); ++k)
      if ((area_of(k) > 0) == (area > 0) && area_of(k) != 0)
        list.push_back({{on_screen[0], on_screen[k], on_screen[k + 1]}, i + 1});
  }
  return list;
}

/// The camera of the scenes: 90 degrees wide and high.
template <irg::DepthOrder Order = irg::nearer_is_greater>
constexpr irg::mat<double, 4, 4> square_view(double near, double far = std::numeric_limits<double>::infinity()) {
  const bool reversed = Order::nearer(1.0f, 0.0f);
  return irg::perspective(irg::pi<double> / 2, 1.0, near, far,
                          reversed ? irg::depth_range::reversed : irg::depth_range::standard);
}

/// The point of camera space that is seen at (x, y) / 1024 pixels, `distance` / 4096 in front of the eye.
/// exact   for |x|, |y| < 2^30, distances below 2^20: one rounding for each coordinate, the same on every machine
constexpr irg::point<double, 3> seen_at(std::int64_t x, std::int64_t y, std::int64_t distance, int width, int height) {
  const auto coordinate = [&](std::int64_t v, int size) {
    const std::int64_t from_centre = v - std::int64_t{size} * 512;
    return static_cast<double>(from_centre * distance) / (static_cast<double>(size) * (512.0 * 4096));
  };
  return {coordinate(x, width), -coordinate(y, height), -static_cast<double>(distance) / 4096};
}

/// What a random scene is made of.
enum class scene_kind {
  any,            // of every size, some sharing corners
  slivers,        // thinner than two pixels, longer than the picture
  crossing,       // all large, all through each other
  sheets,         // two landscapes of triangles with shared edges and vertices, through each other
  tiny,           // a few 1/256 pixel wide, about pixel centres
  huge,           // reaching far beyond the picture, and beyond the guard band
  through_the_eye,  // behind the eye with some corners
  lattice,        // corners on half pixels, few different depths: centres on edges, equal depths
  layers          // all nearly in one plane, some ulp of a float's depth apart
};
inline constexpr int scene_kinds = 8;  // without layers, of which most pixels are close

/// A triangle scene of one kind, made from integers, so that all machines get the same bits.
class scene_maker {
public:
  constexpr scene_maker(random& r, scene_kind kind, int width, int height)
      : r_(r), kind_(kind), s_{{}, {}, square_view(0.125), width, height} {}

  constexpr triangle_scene operator()(int triangles) {
    if (kind_ == scene_kind::sheets) {
      for (int k = 0; k < 2; ++k) sheet(triangles);
      return s_;
    }
    while (static_cast<int>(s_.triangles.size()) < triangles) {
      switch (kind_) {
        case scene_kind::slivers: sliver(); break;
        case scene_kind::tiny: tiny(); break;
        case scene_kind::through_the_eye: through_the_eye(); break;
        case scene_kind::lattice: on_lattice(); break;
        case scene_kind::layers: layer(); break;
        default: any_triangle();
      }
      share_corners();
    }
    return s_;
  }

private:
  constexpr std::int64_t x_max() const { return std::int64_t{s_.width} * 1024; }
  constexpr std::int64_t y_max() const { return std::int64_t{s_.height} * 1024; }
  constexpr std::int64_t distance() { return r_.integer(1024, r_.integer(0, 3) == 0 ? 1 << 18 : 1 << 13); }
  constexpr std::int64_t power_of_two(int low, int high) { return std::int64_t{1} << r_.integer(low, high); }
  // Called with braces, which are evaluated from left to right.
  struct place {
    std::int64_t x, y, distance;
  };
  constexpr std::uint32_t corner(const place& p) {
    s_.positions.push_back(seen_at(p.x, p.y, p.distance, s_.width, s_.height));
    return static_cast<std::uint32_t>(s_.positions.size() - 1);
  }
  constexpr void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    if (r_.integer(0, 1) == 0)
      s_.triangles.push_back({{a, b, c}});
    else
      s_.triangles.push_back({{a, c, b}});
  }

  constexpr void any_triangle() {
    const std::int64_t x = r_.integer(-x_max() / 4, x_max() * 5 / 4), y = r_.integer(-y_max() / 4, y_max() * 5 / 4);
    const std::int64_t size = kind_ == scene_kind::crossing ? 2 * (x_max() + y_max())
                              : kind_ == scene_kind::huge   ? power_of_two(20, 27)
                                                            : power_of_two(8, 16);
    const std::int64_t middle = distance();
    const auto any = [&] {
      const std::int64_t own = r_.integer(0, 1) == 0 ? middle + r_.integer(0, middle / 4) : distance();
      return corner({x + r_.integer(-size, size), y + r_.integer(-size, size), own});
    };
    const std::uint32_t a = any(), b = any(), c = any();
    triangle(a, b, c);
  }
  constexpr void sliver() {
    const auto somewhere = [&](std::int64_t most) { return r_.integer(-most / 2, most * 3 / 2); };
    const std::int64_t ax = somewhere(x_max()), ay = somewhere(y_max()), bx = somewhere(x_max()),
                       by = somewhere(y_max());
    const std::int64_t along = r_.integer(0, 64), width = power_of_two(1, 11);
    const std::uint32_t a = corner({ax, ay, distance()}), b = corner({bx, by, distance()}),
                        c = corner({ax + (bx - ax) * along / 64 + r_.integer(-width, width),
                                    ay + (by - ay) * along / 64 + r_.integer(-width, width), distance()});
    triangle(a, b, c);
  }
  constexpr void tiny() {
    const std::int64_t x = r_.integer(0, s_.width - 1), y = r_.integer(0, s_.height - 1), reach = r_.integer(1, 5);
    const auto beside = [&](std::int64_t v) { return v * 1024 + 512 + 4 * r_.integer(-reach, reach); };
    const auto any = [&] { return corner({beside(x), beside(y), distance()}); };
    for (int k = 0; k < 3; ++k) {  // several at one centre
      const std::uint32_t a = any(), b = any(), c = any();
      triangle(a, b, c);
    }
  }
  constexpr void through_the_eye() {
    const std::int64_t size = power_of_two(10, r_.integer(0, 3) == 0 ? 20 : 14);
    const auto any = [&] {
      const auto coordinate = [&] { return static_cast<double>(r_.integer(-size, size)) / 4096; };
      const double x = coordinate(), y = coordinate(), z = coordinate();
      s_.positions.push_back({x, y, z});
      return static_cast<std::uint32_t>(s_.positions.size() - 1);
    };
    const std::uint32_t a = any(), b = any(), c = any();
    triangle(a, b, c);
  }
  constexpr void on_lattice() {
    const std::int64_t away = power_of_two(12, 14), out = r_.integer(0, 2) == 0 ? 600 : 2;
    const bool level = r_.integer(0, 1) == 0;
    std::int64_t x = 0, y = 0;
    const auto any = [&](bool keep_x, bool keep_y) {
      const std::int64_t own = level ? away : power_of_two(12, 14);
      if (!keep_x) x = r_.integer(-out, 2 * s_.width + out) * 512;
      if (!keep_y) y = r_.integer(-out, 2 * s_.height + out) * 512;
      return corner({x, y, own});
    };
    const std::int64_t along = r_.integer(0, 5);  // an edge that is level or plumb, now and then both
    const std::uint32_t a = any(false, false), b = any(false, along < 3), c = any(along % 3 == 0, false);
    triangle(a, b, c);
  }
  // 1 over the distance is linear on the screen, but for steps of 2^-19 of it.
  constexpr void layer() {
    if (s_.triangles.empty()) rise_x_ = r_.integer(-300, 300), rise_y_ = r_.integer(-300, 300);
    const auto any = [&] {
      const std::int64_t x = r_.integer(-x_max(), 2 * x_max()), y = r_.integer(-y_max(), 2 * y_max());
      const std::int64_t slope = 4096 + rise_x_ * x / x_max() + rise_y_ * y / y_max();
      return corner({x, y, (std::int64_t{4096} << 19) / slope + r_.integer(-12, 12)});
    };
    const std::uint32_t a = any(), b = any(), c = any();
    triangle(a, b, c);
  }
  // Some corners are those of earlier triangles.
  constexpr void share_corners() {
    if (kind_ == scene_kind::tiny) return;
    for (std::uint32_t& v : s_.triangles.back().v)
      if (r_.integer(0, 5) == 0)
        v = static_cast<std::uint32_t>(r_.integer(0, static_cast<std::int64_t>(s_.positions.size()) - 1));
  }
  // Squares of two triangles each, their corners moved about; the distance rises or falls over the sheet.
  constexpr void sheet(int triangles) {
    std::int64_t n = 1;
    while (4 * (n + 1) * (n + 1) <= triangles) ++n;
    const auto first = static_cast<std::uint32_t>(s_.positions.size());
    const std::int64_t base = r_.integer(4096, 1 << 14), rise = r_.integer(-2048, 2048), bumps = r_.integer(0, 1024);
    for (std::int64_t i = 0; i <= n; ++i)
      for (std::int64_t k = 0; k <= n; ++k) {
        const auto at = [&](std::int64_t step, std::int64_t most) {
          return (step * most + r_.integer(-most, most) / 4) / n;
        };
        const std::int64_t x = at(i, x_max()), y = at(k, y_max());
        corner({x, y, base + rise * i / n + r_.integer(0, bumps)});
      }
    for (std::int64_t i = 0; i < n; ++i)
      for (std::int64_t k = 0; k < n; ++k) {
        const std::uint32_t a = first + static_cast<std::uint32_t>(i * (n + 1) + k), b = a + 1,
                            c = a + static_cast<std::uint32_t>(n + 1), d = c + 1;
        if (r_.integer(0, 1) == 0) {
          s_.triangles.push_back({{a, b, d}}), s_.triangles.push_back({{a, d, c}});
        } else {
          s_.triangles.push_back({{a, b, c}}), s_.triangles.push_back({{b, d, c}});
        }
      }
  }

  random& r_;
  scene_kind kind_;
  triangle_scene s_;
  std::int64_t rise_x_ = 0, rise_y_ = 0;  // of the plane of all layers, in 4096ths over the picture
};

/// An order of depths that irg has no kernel for: drawn pixel by pixel.
struct plain_order : irg::nearer_is_greater {};

/// Runs test.operator()<Order, T>(seed) for the orders and numbers that irg has kernels for.
template <class Test>
void with_each_order(std::uint64_t seed, Test test) {
  test.template operator()<irg::nearer_is_greater, double>(seed);
  test.template operator()<irg::nearer_is_greater, float>(seed + 1);
  test.template operator()<irg::nearer_is_less, double>(seed + 2);
}

/// Two triangles that reach behind the eye or beyond the picture: few enough for constant evaluation.
constexpr triangle_scene two_to_be_clipped() {
  return {{{-2, -2, -3}, {2, -2, -1}, {0, 2, -2}, {-2, 1, -1}, {1, -1, 2}, {2, 2, -4}},
          {{{0, 1, 2}}, {{3, 4, 5}}},
          square_view(0.125),
          8,
          8};
}

}  // namespace test
