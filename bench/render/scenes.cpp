// SPDX-License-Identifier: MIT
#include "render/scenes.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <unordered_map>
#include <utility>

#include <irg/io/file.hpp>
#include <irg/io/obj.hpp>
#include <irg/mesh/fit.hpp>
#include <irg/mesh/shapes.hpp>
#include <irg/render/drawable.hpp>
#include <irg/shade/light.hpp>
#include <irg/shade/shading.hpp>

namespace bench {

// ---------------------------------------------------------------------------------------------------- bodies

using body = irg::drawable<float>;

/// A sphere with dents and bumps: as uneven as a model, of 2 * slices * (stacks - 1) triangles.
static body dented_sphere(int slices, int stacks) {
  irg::mesh<float> m = irg::shape_sphere<float>({.slices = slices, .stacks = stacks});
  for (irg::point<float, 3>& p : m.positions) {
    const float bump = 1 + 0.12f * std::sin(7 * p.x + 2) * std::sin(5 * p.y) + 0.05f * std::sin(23 * p.z + 9 * p.x);
    p = irg::to_point(irg::to_vec(p) * bump);
  }
  m.normals.clear();
  for (irg::mesh_corner& c : m.corners) c.normal = irg::no_index;
  return irg::make_drawable(std::move(m));
}

struct body_plan {
  std::string name;
  std::function<body()> make;
};

/// The model, or a sphere of about as many triangles in its place.
static body_plan model_or_sphere(const std::string& name, const char* file, int stand_in_stacks) {
#ifdef IRG_MODELS_DIR
  const std::string path = std::string(IRG_MODELS_DIR "/") + file;
  if (std::ifstream(path))
    return {name, [path] {
              const auto text = irg::load_file(path.c_str());
              if (text)
                if (auto mesh = irg::read_obj<float>({text->data(), text->size()}))
                  return irg::make_drawable(*std::move(mesh));
              std::fprintf(stderr, "%s cannot be read\n", path.c_str());
              std::abort();
            }};
#endif
  static_cast<void>(file);
  return {name + " stand-in", [stand_in_stacks] { return dented_sphere(2 * stand_in_stacks, stand_in_stacks); }};
}

static body_plan bunny() { return model_or_sphere("bunny", "stanford-bunny.obj", 132); }

/// Each triangle cut into four at the middles of its edges, which neighbours share.
static body subdivided(const body& from) {
  body to{from.positions, from.normals, {}, {}};
  std::unordered_map<std::uint64_t, std::uint32_t> middles;
  middles.reserve(2 * from.triangles.size());
  const auto middle = [&](std::uint32_t a, std::uint32_t b) {
    const std::uint64_t edge = std::uint64_t{a < b ? a : b} << 32 | (a < b ? b : a);
    const auto [place, is_new] = middles.try_emplace(edge, static_cast<std::uint32_t>(to.positions.size()));
    if (is_new) {
      to.positions.push_back(from.positions[a] + (from.positions[b] - from.positions[a]) * 0.5f);
      to.normals.push_back(irg::normalized(from.normals[a] + from.normals[b]));
    }
    return place->second;
  };
  for (std::size_t i = 0; i < from.triangles.size(); ++i) {
    const auto [a, b, c] = from.triangles[i].v;
    const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    for (const irg::triangle_indices& t :
         {irg::triangle_indices{{a, ab, ca}}, {{ab, b, bc}}, {{ca, bc, c}}, {{ab, bc, ca}}}) {
      to.triangles.push_back(t);
      to.face_of.push_back(from.face_of[i]);
    }
  }
  return to;
}

/// Puts a body into the scene as one object: scaled, then moved; lit from the upper left and in front.
static void add_body(scene& s, const body& b, float scale, const irg::vec<float, 3>& offset, irg::rgb<float> tint) {
  const irg::light<float> lamp{{-0.5f, 0.7f, 1, 0}, {1, 1, 1}};
  const irg::gouraud_shader<float> shader{{{0.2f, 0.2f, 0.2f}, tint, {}, 1}, {{0.3f, 0.3f, 0.3f}, {&lamp, 1}}, {}};
  scene_object o{static_cast<std::uint32_t>(s.positions.size()), static_cast<std::uint32_t>(b.positions.size()),
                 static_cast<std::uint32_t>(s.triangles.size()), static_cast<std::uint32_t>(b.triangles.size()),
                 irg::box<float, 3>{}};
  for (std::size_t i = 0; i < b.positions.size(); ++i) {
    const irg::point<float, 3> p = irg::to_point(irg::to_vec(b.positions[i]) * scale + offset);
    s.positions.push_back(p);
    s.normals.push_back(b.normals[i]);
    s.colours.push_back(shader(p, b.normals[i]));
    o.bounds = irg::bounding_box(o.bounds, p);
  }
  for (const irg::triangle_indices& t : b.triangles)
    s.triangles.push_back({{t.v[0] + o.first_vertex, t.v[1] + o.first_vertex, t.v[2] + o.first_vertex}});
  s.objects.push_back(o);
}

/// The body moved and scaled so that its box reaches from -1 to 1 along its longest side.
body fitted_body(body b) {
  irg::box<float, 3> extents;
  for (const auto& p : b.positions) extents = irg::bounding_box(extents, p);
  const irg::fit<float> f = irg::fit_of(extents);
  for (auto& p : b.positions) p = irg::fitted(p, f);
  return b;
}

// ---------------------------------------------------------------------------------------------------- cameras

/// Scales and moves the picture of everything until it is `share` of the picture high, or wide where that is less.
static void fill_picture(scene& s, double share) {
  double low[2] = {1e30, 1e30}, high[2] = {-1e30, -1e30};
  for (const auto& p : s.positions) {
    const irg::hpoint<float, 3> h = s.to_clip * p;
    for (int i = 0; i < 2; ++i) {
      low[i] = std::min(low[i], static_cast<double>(h[i]) / static_cast<double>(h.w));
      high[i] = std::max(high[i], static_cast<double>(h[i]) / static_cast<double>(h.w));
    }
  }
  const double scale = 2 * share / std::max(high[0] - low[0], high[1] - low[1]);
  for (int i = 0; i < 2; ++i)
    for (int c = 0; c < 4; ++c)
      s.to_clip(i, c) = static_cast<float>(scale * (static_cast<double>(s.to_clip(i, c)) -
                                                    (low[i] + high[i]) / 2 * static_cast<double>(s.to_clip(3, c))));
}

// ---------------------------------------------------------------------------------------------------- scenes

/// One body that fills most of the picture, back faces culled.
static scene body_scene(const std::string& name, const body& b, double share, const std::string& meant) {
  scene s = empty_scene(name, irg::face_culling::back);
  add_body(s, fitted_body(b), 1, {}, {0.7f, 0.5f, 0.3f});
  const irg::box<float, 3>& extents = s.objects[0].bounds;
  const auto view = irg::camera_around(irg::centre(extents), irg::length(irg::extent(extents)) / 2,
                                       irg::vec<float, 3>{0, 0.2f, 1}, irg::radians(40.0f), aspect_of(s));
  s.to_clip = irg::view_projection(view, aspect_of(s));
  fill_picture(s, share);
  s.meant = meant;
  return s;
}

inline constexpr double bunny_share = 0.91709;

/// a0: a scanned body of 69,451 triangles.
scene_plan scene_a0() {
  const body_plan b = bunny();
  const std::string name = "a0 " + b.name;
  return {name, [=] { return body_scene(name, b.make(), bunny_share, "69451 triangles of 16 px; 553870 px drawn"); }};
}

/// a: the same, each triangle cut into 16.
scene_plan scene_a() {
  const body_plan b = bunny();
  const std::string name = "a " + b.name + " x16";
  return {name, [=] {
            const body once = subdivided(b.make());
            return body_scene(name, smoke() ? once : subdivided(once), bunny_share,
                              "1111216 triangles of 1.01 px; 553868 px drawn");
          }};
}

/// a1: a sculpted body of 124,008 triangles.
scene_plan scene_a1() {
  const body_plan b = model_or_sphere("ogre", "ogre.obj", 176);
  const std::string name = "a1 " + b.name;
  return {name, [=] { return body_scene(name, b.make(), 0.9, "about 100000 triangles of 7 px; 280000 px drawn"); }};
}

// Triangles in circles of one radius about random places, at random distances, tilted a little.
scene random_triangles(const std::string& name, int count, const triangle_shape& shape, drawing order,
                       const std::string& meant) {
  scene s = empty_scene(name, irg::face_culling::none);
  const eye_in_origin eye{0.5f, 1, s.width, s.height};
  s.to_clip = eye.to_clip();
  random_numbers r(20240607);
  const double scale = s.width / 1920.0, margin = scale * shape.margin, radius = scale * shape.radius;
  std::vector<double> distances;
  for (int i = 0; i < count; ++i) distances.push_back(r.between(2, 10));
  if (order == drawing::front_to_back) std::sort(distances.begin(), distances.end());
  const auto channel = [&r] { return static_cast<float>(r.between(0, 1)); };
  scene_object all;
  for (const double distance : distances) {
    const double x = r.between(margin, s.width - margin), y = r.between(margin, s.height - margin),
                 start = r.between(0, turn);
    const auto first = static_cast<std::uint32_t>(s.positions.size());
    for (int k = 0; k < 3; ++k) {
      const double angle = start + turn * (k / 3.0 + shape.spread * r.between(-0.5, 0.5));
      const double away = distance * r.between(0.99, 1.01);
      s.positions.push_back(eye.at(x + radius * std::cos(angle), y + radius * std::sin(angle), away));
      s.normals.push_back({0, 0, 1});
      s.colours.push_back({channel(), channel(), channel()});
      all.bounds = irg::bounding_box(all.bounds, s.positions.back());
    }
    s.triangles.push_back({{first, first + 1, first + 2}});
  }
  all.vertices = static_cast<std::uint32_t>(s.positions.size());
  all.triangles = static_cast<std::uint32_t>(s.triangles.size());
  s.objects.push_back(all);
  s.meant = meant;
  return s;
}

/// b: 20,000 triangles of 830 px, one over the other eight times.
scene_plan scene_b(drawing order) {
  const std::string name = order == drawing::front_to_back ? "b' 20k front to back" : "b 20k random order";
  return {name, [=] {
            return random_triangles(name, smoke() ? 1000 : 20000, {41.64, 41.7, 1}, order,
                                    "20000 triangles of 830 px; depth complexity 8.0; 1974908 px drawn");
          }};
}

/// c: 200 triangles of a third of the picture.
scene_plan scene_c() {
  return {"c 200 large", [] {
            return random_triangles("c 200 large", smoke() ? 20 : 200, {845, 300, 0.1}, drawing::random_order,
                                    "200 triangles of 766000 px; depth complexity 74; 2070255 px drawn");
          }};
}

/// Twenty bodies in a ring about the eye, of which two, a tenth, are in view and whole.
static scene make_scene_frustum(const std::string& name, const body& b) {
  const body shape = fitted_body(b);
  scene s = empty_scene(name, irg::face_culling::back);
  const eye_in_origin eye{0.18f, 0.1f, s.width, s.height};  // 36 degrees wide: a tenth of the ring
  s.to_clip = eye.to_clip();
  constexpr int count = 20;
  for (int i = 0; i < count; ++i) {
    const double angle = turn * (i + 0.5) / count;
    add_body(s, shape, 0.8f, {static_cast<float>(10 * std::sin(angle)), 0, static_cast<float>(-10 * std::cos(angle))},
             {0.3f + 0.4f * static_cast<float>(i % 3) / 2, 0.5f, 0.7f});
  }
  s.meant = "a tenth of the triangles in view";
  return s;
}
scene_plan scene_frustum() {
  const body_plan b = bunny();
  const std::string name = "frustum 20 x " + b.name;
  return {name, [=] { return make_scene_frustum(name, b.make()); }};
}

/// A hundred bodies in ten columns of ten, `percent` of them visible: 100, 50, 10, 1 or 0. The others stand behind a
/// wall, which is drawn first, or outside of the picture.
static scene make_scene_visible(const std::string& name, int percent, hidden_by what) {
  const bool wall = what == hidden_by::wall;
  const body shape = fitted_body(model_or_sphere("spot", "spot.obj", 39).make());
  scene s = empty_scene(name, irg::face_culling::back);
  const eye_in_origin eye{0.15f, 1, s.width, s.height};
  s.to_clip = eye.to_clip();
  constexpr double distance = 10;
  const double column = s.width / 10.0, row = s.height / 10.0;
  const int columns = percent == 100 ? 0 : percent == 50 ? 5 : percent == 0 ? 10 : 9, rows = percent == 1 ? 9 : 0;
  const auto rectangle = [&](double left, double top, double right, double bottom) {
    const auto v = static_cast<std::uint32_t>(s.positions.size());
    const auto t = static_cast<std::uint32_t>(s.triangles.size());
    scene_object o{v, 4, t, 2, irg::box<float, 3>{}};
    for (const auto& [x, y] : {std::pair{left, top}, {left, bottom}, {right, bottom}, {right, top}}) {
      s.positions.push_back(eye.at(x, y, distance * 0.9));
      s.normals.push_back({0, 0, 1});
      s.colours.push_back({0.2f, 0.25f, 0.3f});
      o.bounds = irg::bounding_box(o.bounds, s.positions.back());
    }
    s.triangles.push_back({{v, v + 1, v + 2}});
    s.triangles.push_back({{v, v + 2, v + 3}});
    s.objects.push_back(o);
  };
  constexpr double beyond = 8;
  if (wall && columns > 0)
    rectangle(-beyond, -beyond, columns == 10 ? s.width + beyond : columns * column, s.height + beyond);
  if (wall && rows > 0) rectangle(columns * column, -beyond, s.width + beyond, rows * row);
  const float scale = 0.32f * 2 * eye.half_height * static_cast<float>(distance) / 10;
  for (int y = 0; y < 10; ++y)
    for (int x = 0; x < 10; ++x)
      add_body(s, shape, scale, irg::to_vec(eye.at((x + 0.5) * column, (y + 0.5) * row, distance)),
               {0.4f + 0.05f * static_cast<float>(x), 0.9f - 0.06f * static_cast<float>(y), 0.4f});
  if (!wall)  // the picture moves to the right and down
    for (int c = 0; c < 4; ++c) {
      s.to_clip(0, c) -= 0.2f * static_cast<float>(columns) * s.to_clip(3, c);
      s.to_clip(1, c) += 0.2f * static_cast<float>(rows) * s.to_clip(3, c);
    }
  s.meant = std::to_string(percent) + " of 100 bodies visible";
  return s;
}
scene_plan scene_visible(int percent, hidden_by what) {
  const std::string name = "visible " + std::to_string(percent) + " % " + (what == hidden_by::wall ? "wall" : "border");
  return {name, [=] { return make_scene_visible(name, percent, what); }};
}

}  // namespace bench
