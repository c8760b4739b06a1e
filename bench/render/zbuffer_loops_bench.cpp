// SPDX-License-Identifier: MIT
// The z-buffer's inner loops one by one, each beside its limit, on memory that stays in the caches: vertices to the
// screen, triangles made ready, the pixels of one tile with their depth test.
#include <cmath>
#include <cstring>

#include <irg/raster/draw_triangle.hpp>
#include <irg/raster/projected_vertices.hpp>

#include "render/frames.hpp"

namespace {

using namespace bench;

// ---- vertices to the screen

struct vertices {
  scene s;
  irg::screen_mapping<float> mapping;
  irg::projected_vertices<float> out{};
  std::vector<irg::screen_vertex> plain, copy;

  explicit vertices(scene made)
      : s(std::move(made)), mapping(irg::map_to_screen<float>({s.width, s.height})), plain(s.positions.size()),
        copy(plain) {}
};

// In floats as it is usually written, without classifying.
void project_plainly(vertices& v) {
  const auto& m = v.s.to_clip.m;
  const float half_width = static_cast<float>(v.s.width) / 2, half_height = static_cast<float>(v.s.height) / 2;
  for (std::size_t i = 0; i < v.plain.size(); ++i) {
    const irg::point<float, 3>& p = v.s.positions[i];
    float h[4];
    for (int r = 0; r < 4; ++r) h[r] = m[r][0] * p.x + m[r][1] * p.y + m[r][2] * p.z + m[r][3];
    const float inverse = 1 / h[3];
    v.plain[i] = {{static_cast<std::int32_t>(std::lrint((h[0] * inverse * half_width + half_width) * 256)),
                   static_cast<std::int32_t>(std::lrint((half_height - h[1] * inverse * half_height) * 256))},
                  h[2] * inverse,
                  inverse};
  }
}

// From the place that doubles give, along x or y, in 1/256 pixel.
errors judge_places(const vertices& v, const std::vector<irg::screen_vertex>& found) {
  errors e{0, 0, 0};
  for (std::size_t i = 0; i < found.size(); ++i) {
    const auto h = exact_clip(v.s, static_cast<std::uint32_t>(i));
    const double x = (h[0] / h[3] + 1) * v.s.width * 128, y = (1 - h[1] / h[3]) * v.s.height * 128;
    const double off = std::max(std::abs(x - found[i].position.x), std::abs(y - found[i].position.y));
    e.max = std::max(e.max, off);
    e.mean += off / static_cast<double>(found.size());
    e.wrong += off > 1;
  }
  return e;
}

void enter_vertices() {
  constexpr int triangles = 1366;
  const contest c{"vertex_transform", "4098 vertices", "vertex", 3 * triangles, "1/256 px", "limit:memcpy"};
  vertices& v = keep(vertices(random_triangles(c.test_case, triangles, {40, 40, 1}, drawing::random_order, "")));
  const auto project = [&v] {
    irg::project_vertices<float>(v.s.positions, v.s.to_clip, v.mapping, v.out);
    asm volatile("" : : "r"(v.out.screen.data()) : "memory");
  };
  enter(c, {"irg", project, [&v] {
              errors e = judge_places(v, v.out.screen);
              if (e.wrong != 0) e.broken = "a vertex is off by more than 1/256 pixel";
              return e;
            }});
  const auto plainly = [&v] {
    project_plainly(v);
    asm volatile("" : : "r"(v.plain.data()) : "memory");
  };
  enter(c, {"plain loop", plainly, [&v] { return judge_places(v, v.plain); }, "does not classify"});
  const auto copy = [&v] {
    std::memcpy(v.copy.data(), v.plain.data(), v.plain.size() * sizeof v.plain[0]);
    asm volatile("" : : "r"(v.copy.data()) : "memory");
  };
  enter(c, {"limit:memcpy", copy, {}, "as many bytes as vertices on the screen have"});
}

// ---- triangles made ready

struct triangles_on_screen {
  std::vector<std::array<irg::subpixel, 3>> corners{};
  std::vector<irg::triangle_coverage> ready, copy;
};

// Wrong: pixels of the triangles' boxes that the edge functions of the oracle decide otherwise.
errors judge_coverage(const triangles_on_screen& t) {
  errors e;
  e.wrong = 0;
  for (std::size_t i = 0; i < t.corners.size(); ++i) {
    const auto& [a, b, c] = t.corners[i];
    irg::image<std::uint8_t> due(64, 64, std::uint8_t{0});
    each_covered(exact_cover({a, b, c}, 64, 64), [&](int x, int y, const auto&) { due(x, y) = 1; });
    for (int y = 0; y < 64; ++y)
      for (int x = 0; x < 64; ++x) {
        const irg::cell_window& w = t.ready[i].bounds;
        const bool inside = w.x_first <= x && x < w.x_last && w.y_first <= y && y < w.y_last;
        e.wrong += (inside && irg::covers(t.ready[i], x, y)) != (due(x, y) != 0);
      }
  }
  if (e.wrong != 0) e.broken = "a pixel is decided otherwise than by its definition";
  return e;
}

void enter_set_up() {
  constexpr std::size_t count = 256;
  const contest c{"triangle_setup", "16 px", "triangle", count, "", "limit:memcpy"};
  auto& t = keep(triangles_on_screen{{}, std::vector<irg::triangle_coverage>(count), {}});
  t.copy = t.ready;
  random_numbers r(16);
  for (std::size_t i = 0; i < count; ++i) {
    const int x = r.integer(0, 48 * 256), y = r.integer(0, 48 * 256);
    const auto any = [&] { return irg::subpixel{x + r.integer(0, 16 * 256), y + r.integer(0, 16 * 256)}; };
    const irg::subpixel p = any(), q = any();
    t.corners.push_back({p, q, any()});
  }
  const auto set_up = [&t] {
    for (std::size_t i = 0; i < count; ++i)
      t.ready[i] = irg::cover_triangle(t.corners[i][0], t.corners[i][1], t.corners[i][2]);
    asm volatile("" : : "r"(t.ready.data()) : "memory");
  };
  enter(c, {"irg", set_up, [&t] { return judge_coverage(t); }});
  const auto copy = [&t] {
    std::memcpy(t.copy.data(), t.ready.data(), count * sizeof t.ready[0]);
    asm volatile("" : : "r"(t.copy.data()) : "memory");
  };
  enter(c, {"limit:memcpy", copy, {}, "as many bytes as triangles made ready have"});
}

// ---- the pixels of a tile with their depth test

// Squares as large as the picture, one behind the other, each of two triangles.
scene layers(const std::string& name, int count, drawing order) {
  scene s{.name = name, .width = 64, .height = 64};
  const eye_in_origin eye{0.5f, 1, s.width, s.height};
  s.to_clip = eye.to_clip();
  scene_object all;
  for (int i = 0; i < count; ++i) {
    const double distance = 2 + (order == drawing::front_to_back ? i : count - i);
    const auto first = static_cast<std::uint32_t>(s.positions.size());
    for (const auto& [x, y] : {std::pair{0, 0}, {0, s.height}, {s.width, s.height}, {s.width, 0}}) {
      s.positions.push_back(eye.at(x, y, distance * (x == 0 ? 1 : 1.05)));
      all.bounds = irg::bounding_box(all.bounds, s.positions.back());
    }
    s.triangles.push_back({{first, first + 1, first + 2}});
    s.triangles.push_back({{first, first + 2, first + 3}});
  }
  s.colours.resize(s.positions.size(), {1, 1, 1});
  all.vertices = static_cast<std::uint32_t>(s.positions.size());
  all.triangles = static_cast<std::uint32_t>(s.triangles.size());
  s.objects.push_back(all);
  return s;
}

struct tile_on_stage {
  scene what;
  own::renderer renderer;
  irg::projected_vertices<float> vertices;
  std::vector<irg::subpixel> snapped;
  irg::image<float> depth{64, 64};
  irg::image<irg::rgba8> picture{64, 64};

  explicit tile_on_stage(scene s)
      : what(std::move(s)), renderer(what),
        vertices(irg::project_vertices<float>(std::span<const irg::point<float, 3>>(what.positions), what.to_clip,
                                              irg::map_to_screen<float>({64, 64}))),
        snapped(renderer.snapped()) {}

  // Triangle by triangle into the picture, without tiles.
  void draw_one_by_one() {
    irg::clear(depth, 0.0f);
    for (const irg::triangle_indices& t : what.triangles)
      irg::shade_triangle(picture, depth, {vertices.screen[t.v[0]], vertices.screen[t.v[1]], vertices.screen[t.v[2]]},
                          irg::solid_shader<irg::rgba8>{{255, 255, 255, 255}});
  }
  errors judge() const {
    const verdict v = judge_depth(what, find_exact_picture(what, snapped), depth.data());
    errors e{v.max, v.mean, static_cast<double>(v.wrong)};
    if (v.wrong != 0 || v.max > 4) e.broken = "a depth is wrong or off by more than 4 * 2^-24";
    return e;
  }
};

void enter_tile(const std::string& name, drawing order) {
  constexpr int count = 8;
  const contest c{"tile_depth_test", name, "test", count * 64 * 64, "2^-24", "limit:depth tests"};
  auto& on = keep_lazy([name, order] { return std::make_unique<tile_on_stage>(layers(name, count, order)); });
  enter(c, {"irg", [&on] { (*on)->renderer.draw_depth((*on)->depth, 1); }, [&on] { return (*on)->judge(); },
            "draw_depth: with the vertices and the list of the tile"});
  enter(c, {"irg:shade_triangle", [&on] { (*on)->draw_one_by_one(); }, [&on] { return (*on)->judge(); },
            "writes colours; too"});
  enter(c, {"limit:depth tests",
            [&on] { stream_depth_tests((*on)->picture, (*on)->depth, count * 64 * 64); },
            {},
            "writes colours; too"});
}

}  // namespace

int main(int argc, char** argv) {
  enter_vertices();
  enter_set_up();
  enter_tile("8 layers back to front", drawing::random_order);
  enter_tile("8 layers front to back", drawing::front_to_back);
  return run_benchmarks(argc, argv);
}
