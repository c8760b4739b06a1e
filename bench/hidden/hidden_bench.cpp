// SPDX-License-Identifier: MIT
// The classical hidden-surface methods on the same faces: from 100 to a million triangles, at depth complexities from 1
// to 64, apart, crossing, coplanar, or over each other in turn. Wrong are the pixels that do not show what is nearest,
// exactly; `growth` is the exponent of the number of triangles in the time, between this size and the next one that was
// measured.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <irg/hidden/bsp_faces.hpp>
#include <irg/hidden/painter.hpp>
#include <irg/hidden/painter_newell.hpp>
#include <irg/hidden/ray_casting.hpp>
#include <irg/hidden/warnock.hpp>

#include "support/measure.hpp"
#include "../tests/support/random.hpp"

namespace {

using namespace bench;
using id_image = irg::image<std::uint32_t>;

// How triangles lie to each other in depth.
enum class layout { apart, crossing, coplanar, cycles };

struct scene_of_faces {
  int side;
  std::vector<irg::screen_face> faces;
  id_image exact, drawn;
  irg::draw_counts counts{};
  irg::cell_window window() const { return {0, 0, side, side}; }
};

// Of the faces that cover a pixel the one that is nearest: each is asked once.
id_image exact_picture(const std::vector<irg::screen_face>& faces, int side) {
  id_image ids(side, side, irg::no_face);
  for (const irg::screen_face& f : faces)
    irg::covered_spans(f.coverage, {0, 0, side, side}, [&](const irg::span_of_cells& s) {
      for (int x = s.x_first; x < s.x_last; ++x)
        if (ids(x, s.y) == irg::no_face || irg::is_nearer(f, faces[ids(x, s.y)], x, s.y)) ids(x, s.y) = f.number;
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

// n triangles that cover `complexity` times the picture's area, about; of rods, half as often. Numbers say nothing of
// depths.
scene_of_faces make_scene(int side, int n, int complexity, layout how) {
  test::random r(11);
  scene_of_faces s{side, {}, {}, id_image(side, side, irg::no_face)};
  const int all = side * irg::one_pixel;
  const int radius = static_cast<int>(std::sqrt(complexity / (1.299 * n)) * all) + 64;
  std::vector<three_corners> corners;
  int x = 0, y = 0;
  double depth = 0;
  for (int i = 0; i < n; ++i) {
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
  s.exact = exact_picture(s.faces, side);
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
};

template <class Method>
void add(const series& in, const std::string& who, int n, lazy<scene_of_faces>& scene, const Method& method,
         bool promised) {
  times& t = in.of[who];
  const contest what{in.kernel, std::to_string(n) + " triangles", "picture", 1, "", ""};
  contender c{who, [&scene, &t, n, method] {
                scene_of_faces& s = *scene;
                s.drawn = id_image(s.side, s.side, irg::no_face);
                s.counts = {};
                const auto start = std::chrono::steady_clock::now();
                method(s.faces, s.window(), s.drawn, s.counts);
                const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
                t[n] = t.contains(n) ? std::min(t[n], seconds) : seconds;
              }};
  c.judge = [&scene, &t, n, promised] {
    const scene_of_faces& s = *scene;
    errors e;
    e.wrong = 0;
    for (int y = 0; y < s.side; ++y)
      for (int x = 0; x < s.side; ++x) e.wrong += s.drawn(x, y) != s.exact(x, y);
    e.more = {{"tested", static_cast<double>(s.counts.tested)}};
    if (const double g = growth(t, n); g == g) e.more.push_back({"growth", g});
    if (promised && e.wrong != 0) e.broken = "a pixel does not show the nearest face";
    return e;
  };
  enter(what, std::move(c));
}

// Each method where it ends in seconds.
void enter_series(const std::string& name, layout how, int complexity, int most) {
  const series in{name, keep(std::map<std::string, times>())};
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

}  // namespace

int main(int argc, char** argv) {
  for (const int complexity : {1, 4, 16, 64})
    enter_series("apart; complexity " + std::to_string(complexity), layout::apart, complexity, 1000000);
  enter_series("crossing; complexity 4", layout::crossing, 4, 100000);
  enter_series("coplanar; complexity 4", layout::coplanar, 4, 100000);
  enter_series("cycles; complexity 4", layout::cycles, 4, 100000);
  return run_benchmarks(argc, argv);
}
