// SPDX-License-Identifier: MIT
// The classical hidden-surface methods on the same faces: from 100 to a million triangles, at depth complexities from 1
// to 64, apart, crossing, coplanar, or over each other in turn, all or a tenth of them. Wrong are the pixels that do not
// show what is nearest, exactly; `growth` is the exponent of the number of triangles in the time, between this size and
// the next one that was measured. Then the bunny in 1920 x 1080, and the painter beside plain sorts of as many faces.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <irg/geometry/box.hpp>
#include <irg/hidden/bsp_faces.hpp>
#include <irg/hidden/painter.hpp>
#include <irg/hidden/painter_newell.hpp>
#include <irg/hidden/ray_casting.hpp>
#include <irg/hidden/warnock.hpp>
#include <irg/io/file.hpp>
#include <irg/io/obj.hpp>
#include <irg/mesh/shapes.hpp>
#include <irg/render/drawable.hpp>

#include "support/measure.hpp"
#include "../tests/support/random.hpp"

namespace {

using namespace bench;
using id_image = irg::image<std::uint32_t>;

// How triangles lie to each other in depth.
enum class layout { apart, crossing, coplanar, cycles };

struct scene_of_faces {
  int width, height;
  std::vector<irg::screen_face> faces;
  id_image exact, drawn;
  irg::draw_counts counts{};
  irg::cell_window window() const { return {0, 0, width, height}; }
};

// Of the faces that cover a pixel the one that is nearest: each is asked once.
id_image exact_picture(const std::vector<irg::screen_face>& faces, int width, int height) {
  id_image ids(width, height, irg::no_index);
  for (const irg::screen_face& f : faces)
    irg::covered_spans(f.coverage, {0, 0, width, height}, [&](const irg::span_of_cells& s) {
      for (int x = s.x_first; x < s.x_last; ++x)
        if (ids(x, s.y) == irg::no_index || irg::is_nearer(f, faces[ids(x, s.y)], x, s.y)) ids(x, s.y) = f.number;
    });
  return ids;
}

// Three corners about (x, y), `radius` away.
struct three_corners {
  irg::screen_vertex v[3];
};
three_corners triangle_about(int x, int y, int radius, double turn) {
  three_corners t{};
  for (int k = 0; k < 3; ++k)
    t.v[k].position = {x + static_cast<int>(radius * std::cos(turn + 2.0944 * k)),
                       y + static_cast<int>(radius * std::sin(turn + 2.0944 * k))};
  return t;
}

// One of three that lie over each other in turn: along a side of a triangle and beyond, rising.
three_corners rod_about(int x, int y, int radius, int which, double depth) {
  const three_corners t = triangle_about(x, y, radius, 0);
  const irg::subpixel a = t.v[which].position, b = t.v[(which + 1) % 3].position;
  const int dx = b.x - a.x, dy = b.y - a.y;
  const auto low = static_cast<float>(depth), high = static_cast<float>(depth + 0.01);
  return {{{{a.x - dx / 4 - dy / 8, a.y - dy / 4 + dx / 8}, low},
           {{a.x - dx / 4 + dy / 8, a.y - dy / 4 - dx / 8}, low},
           {{b.x + dx / 2, b.y + dy / 2}, high}}};
}

// Of ten triples of triangles `tenths` are laid out so, the others apart.
struct mixture {
  layout how = layout::apart;
  int tenths = 10;
};

// n triangles that cover `complexity` times the picture's area, about; of rods, half as often. Numbers say nothing of
// depths.
scene_of_faces make_scene(int side, int n, int complexity, const mixture& of) {
  test::random r(11);
  scene_of_faces s{side, side, {}, {}, id_image(side, side, irg::no_index)};
  const int all = side * irg::one_pixel;
  const int radius = static_cast<int>(std::sqrt(complexity / (1.299 * n)) * all) + 64;
  std::vector<three_corners> corners;
  int x = 0, y = 0;
  double depth = 0;
  for (int i = 0; i < n; ++i) {
    const layout how = i / 3 % 10 < of.tenths ? of.how : layout::apart;
    if (how != layout::cycles || i % 3 == 0) {
      x = static_cast<int>(r.integer(0, all)), y = static_cast<int>(r.integer(0, all));
      depth = 0.1 + 0.8 * (how == layout::apart ? (i + 0.1) / n : r.unit());
    }
    if (how == layout::cycles) {
      corners.push_back(rod_about(x, y, radius, i % 3, depth));
      continue;
    }
    three_corners t = triangle_about(x, y, radius, 6.2832 * r.unit());
    for (irg::screen_vertex& v : t.v)
      if (how == layout::coplanar)  // exactly in one of four planes: a whole number of 2^-22 for each 1/256 pixel
        v.depth = static_cast<float>((1 << 21) + (i % 4 - 2) * v.position.x + v.position.y) * 0x1p-22f;
      else
        v.depth = static_cast<float>(depth + (how == layout::apart ? 0.4 / n : 0.1) * r.unit());
    corners.push_back(t);
  }
  for (std::size_t i = corners.size(); i > 1; --i)
    std::swap(corners[i - 1], corners[static_cast<std::size_t>(r.integer(0, static_cast<std::int64_t>(i) - 1))]);
  for (const auto& [v] : corners)
    s.faces.push_back(irg::make_screen_face(v[0], v[1], v[2], static_cast<std::uint32_t>(s.faces.size())));
  s.exact = exact_picture(s.faces, side, side);
  return s;
}

irg::drawable<double> bunny_or_sphere() {
#ifdef IRG_MODELS_DIR
  const char* path = IRG_MODELS_DIR "/stanford-bunny.obj";
  if (std::ifstream(path))
    if (const auto text = irg::load_file(path))
      if (auto mesh = irg::read_obj<double>({text->data(), text->size()})) return irg::make_drawable(*std::move(mesh));
#endif
  return irg::make_drawable(irg::shape_sphere<double>({.slices = 264, .stacks = 132}));
}

// The bunny as high as the picture, in parallel projection.
scene_of_faces bunny_scene(int width, int height, irg::face_culling culling) {
  const auto body = bunny_or_sphere();
  irg::box<double, 3> around;
  for (const auto& p : body.positions) around = irg::bounding_box(around, p);
  const double scale = 0.95 * height / (around.high.y - around.low.y);
  scene_of_faces s{width, height, {}, {}, id_image(width, height, irg::no_index)};
  for (const irg::triangle_indices& t : body.triangles) {
    irg::screen_vertex v[3];
    for (int k = 0; k < 3; ++k) {
      const auto& p = body.positions[t.v[k]];
      const double x = width / 2.0 + scale * (p.x - (around.low.x + around.high.x) / 2),
                   y = height / 2.0 - scale * (p.y - (around.low.y + around.high.y) / 2);
      v[k] = {{static_cast<int>(std::lround(x * irg::one_pixel)), static_cast<int>(std::lround(y * irg::one_pixel))},
              static_cast<float>(0.2 + 0.6 * (p.z - around.low.z) / (around.high.z - around.low.z))};
    }
    const auto number = static_cast<std::uint32_t>(s.faces.size());
    const irg::screen_face f = irg::make_screen_face(v[0], v[1], v[2], number);
    if (culling == irg::face_culling::none || irg::facing_of(f) == irg::facing::front) s.faces.push_back(f);
  }
  s.exact = exact_picture(s.faces, width, height);
  return s;
}

// The z-buffer as textbooks have it, on the same faces.
struct plain_zbuffer {
  void operator()(const std::vector<irg::screen_face>& faces, const irg::cell_window& w, id_image& ids,
                  irg::draw_counts& counts) const {
    irg::image<float> nearest(w.x_last, w.y_last, 0.0f);
    for (const irg::screen_face& f : faces) {
      const irg::triangle_setup setup = irg::set_up_face(f);
      irg::covered_spans(f.coverage, w, [&](const irg::span_of_cells& s) {
        for (int x = s.x_first; x < s.x_last; ++x, ++counts.tested)
          if (const float z = irg::depth_at(setup, x, s.y); nearest(x, s.y) < z)
            nearest(x, s.y) = z, ids(x, s.y) = f.number;
      });
    }
  }
};

// A method's times by the number of triangles; rounds come in any order, so that the size before may be still to come.
using times = std::map<int, double>;

double growth(const times& of, int n) {
  const auto here = of.find(n);
  if (here == of.end() || of.size() < 2) return not_said;
  const auto other = here == of.begin() ? std::next(here) : std::prev(here);
  return std::log(here->second / other->second) / std::log(static_cast<double>(n) / other->first);
}

struct series {
  std::string kernel;
  std::map<std::string, times>& of;
  std::string of_what = " triangles";
  bool draws = true;  // sorts do not
};

std::vector<series>& all_series() {
  static std::vector<series> all;
  return all;
}

// The exponents between each size that was measured and the next.
void print_growth(const std::vector<series>& all) {
  std::printf("\nThe time grows with the number of triangles to the power of, from each size to ten times that:\n");
  for (const series& s : all)
    for (const auto& [who, of] : s.of) {
      if (of.size() < 2) continue;
      std::printf("  %-36s %-20s", s.kernel.c_str(), who.c_str());
      for (auto here = of.begin(), next = std::next(here); next != of.end(); here = next++)
        std::printf("  %d to %d: %.2f", here->first, next->first,
                    std::log(next->second / here->second) / std::log(static_cast<double>(next->first) / here->first));
      std::printf("\n");
    }
}

template <class Method>
void add(const series& in, const std::string& who, int n, lazy<scene_of_faces>& scene, const Method& method,
         bool promised) {
  times& t = in.of[who];
  const contest what{in.kernel, std::to_string(n) + in.of_what, "picture", 1, "", ""};
  contender c{who, [&scene, &t, n, method] {
                scene_of_faces& s = *scene;
                s.drawn = id_image(s.width, s.height, irg::no_index);
                s.counts = {};
                const auto start = std::chrono::steady_clock::now();
                method(s.faces, s.window(), s.drawn, s.counts);
                const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
                t[n] = t.contains(n) ? std::min(t[n], seconds) : seconds;
              }};
  c.judge = [&scene, &t, n, promised, draws = in.draws] {
    const scene_of_faces& s = *scene;
    errors e;
    if (!draws) return e;
    e.wrong = 0;
    for (int y = 0; y < s.height; ++y)
      for (int x = 0; x < s.width; ++x) e.wrong += s.drawn(x, y) != s.exact(x, y);
    e.more = {{"tested", static_cast<double>(s.counts.tested)}};
    if (const double g = growth(t, n); g == g) e.more.push_back({"growth", g});
    if (promised && e.wrong != 0) e.broken = "a pixel does not show the nearest face";
    return e;
  };
  enter(what, std::move(c));
}

// Each method where it ends in seconds.
void enter_series(const std::string& name, const mixture& how, int complexity, int most) {
  all_series().push_back({name, keep(std::map<std::string, times>())});
  const series in = all_series().back();
  const int side = smoke() ? 48 : 512;
  for (int n = 100; n <= (smoke() ? 1000 : most); n *= 10) {
    auto& scene = keep_lazy([=] { return make_scene(side, n, complexity, how); });
    add(in, "zbuffer", n, scene, plain_zbuffer{}, false);
    if (n <= 1000) add(in, "ray casting", n, scene, irg::ray_casting<>{}, true);
    add(in, "warnock", n, scene, irg::warnock<>{}, true);
    add(in, "painter newell", n, scene, irg::painter_newell<>{}, true);
    add(in, "bsp", n, scene, irg::bsp_painter<>{}, true);
    add(in, "painter by centroid", n, scene, irg::painter_by_centroid_rounded<>{}, false);
  }
}

void enter_bunny() {
  for (const irg::face_culling culling : {irg::face_culling::back, irg::face_culling::none}) {
    const int height = smoke() ? 54 : 1080;
    const std::string name = culling == irg::face_culling::back ? "bunny; front faces" : "bunny; both sides";
    const series in{name, keep(std::map<std::string, times>()), " rows"};
    auto& scene = keep_lazy([=] { return bunny_scene(height * 16 / 9, height, culling); });
    add(in, "zbuffer", height, scene, plain_zbuffer{}, false);
    add(in, "warnock", height, scene, irg::warnock<>{}, true);
    add(in, "painter newell", height, scene, irg::painter_newell<>{}, true);
  }
}

// The painter, its picture and all, beside sorts by the farthest depth of as many faces: of the faces themselves, of
// pointers to them, of pairs of depth and number, and of nothing but the depths.
void enter_sorts() {
  const int n = smoke() ? 100 : 100000, side = smoke() ? 48 : 512;
  auto& scene = keep_lazy([=] { return make_scene(side, n, 1, {}); });
  const series in{"painter beside sorts", keep(std::map<std::string, times>())};
  add(in, "painter newell", n, scene, irg::painter_newell<>{}, true);
  const series sorts{in.kernel, in.of, in.of_what, false};
  const auto add_sort = [&](const std::string& who, const auto& value_of) {
    const auto sort = [value_of](const std::vector<irg::screen_face>& faces, const irg::cell_window&, id_image& ids,
                                 irg::draw_counts&) {
      std::vector<decltype(value_of(faces[0]))> list;
      list.reserve(faces.size());
      for (const irg::screen_face& f : faces) list.push_back(value_of(f));
      const auto depth = [](const auto& v) {
        if constexpr (requires { v->depth_low; })
          return v->depth_low;
        else if constexpr (requires { v.depth_low; })
          return v.depth_low;
        else if constexpr (requires { v.first; })
          return v.first;
        else
          return v;
      };
      std::sort(list.begin(), list.end(), [&](const auto& a, const auto& b) { return depth(a) < depth(b); });
      ids(0, 0) = depth(list.front()) < depth(list.back()) ? 0 : 1;  // the sort has to be done
    };
    add(sorts, who, n, scene, sort, false);
  };
  add_sort("sort of faces", [](const irg::screen_face& f) { return f; });
  add_sort("sort of pointers", [](const irg::screen_face& f) { return &f; });
  add_sort("sort of pairs", [](const irg::screen_face& f) { return std::pair(f.depth_low, f.number); });
  add_sort("sort of depths", [](const irg::screen_face& f) { return f.depth_low; });
}

}  // namespace

int main(int argc, char** argv) {
  for (const int complexity : {1, 4, 16, 64})
    enter_series("apart; complexity " + std::to_string(complexity), {}, complexity, 1000000);
  for (const int tenths : {1, 10}) {
    const std::string share = tenths == 10 ? "; complexity 4" : "; a tenth; complexity 4";
    enter_series("crossing" + share, {layout::crossing, tenths}, 4, 100000);
    enter_series("coplanar" + share, {layout::coplanar, tenths}, 4, 100000);
    enter_series("cycles" + share, {layout::cycles, tenths}, 4, 100000);
  }
  const std::vector<series> sizes = all_series();
  enter_bunny();
  enter_sorts();
  // Three rounds, unless a switch says otherwise: all of them take three minutes of a processor.
  std::vector<char*> words(argv, argv + argc);
  std::string rounds = "--benchmark_repetitions=3";
  if (!smoke()) words.insert(words.begin() + 1, rounds.data());
  const int status = run_benchmarks(static_cast<int>(words.size()), words.data());
  print_growth(sizes);
  return status;
}
