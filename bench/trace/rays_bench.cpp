// SPDX-License-Identifier: MIT
// Rays against a model's triangles: building the tree, first crossings of a camera's rays, single and in packets, and
// shadow rays from what they meet to a lamp. Beside it Embree, in a process of its own: it sets flags of the processor that
// irg's results must not depend on.
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <ctime>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <irg/io/mesh_file.hpp>
#include <irg/mesh/shapes.hpp>
#include <irg/mesh/triangulate.hpp>
#include <irg/spatial/triangle_bvh.hpp>

#include "support/measure.hpp"
#include "trace/peer_embree.hpp"

namespace {

using namespace bench;
using place = irg::point<float, 3>;
using triangle = std::array<place, 3>;
using tree = irg::triangle_bvh<float>;

double now() {
  timespec t;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + static_cast<double>(t.tv_nsec) * 1e-9;
}

// The seconds of the processor that work() takes: what runs beside it does not count, neither for irg nor for its peer.
template <class Work>
contender timed(const std::string& name, const Work& work) {
  return {name, {}, {}, "", true, [work] {
            const double start = now();
            work();
            return now() - start;
          }};
}

// Runs work() in a process of its own, which gives the seconds that it took.
template <class Work>
double in_own_process(const Work& work) {
  int ends[2];
  if (pipe(ends) != 0) return not_said;
  const pid_t child = fork();
  if (child == 0) {
    const double seconds = work();
    const bool told = write(ends[1], &seconds, sizeof seconds) == sizeof seconds;
    _exit(told ? 0 : 1);
  }
  close(ends[1]);
  double seconds = not_said;
  if (child < 0 || read(ends[0], &seconds, sizeof seconds) != sizeof seconds) seconds = not_said;
  close(ends[0]);
  if (child > 0) waitpid(child, nullptr, 0);
  return seconds;
}

struct model {
  std::vector<triangle> triangles;
  std::vector<camera_ray> camera, shadow;  // the rays of a picture, in squares of 4 by 4; from what they meet to a lamp
};

model make_model(const irg::mesh<float>& body, int width, int height) {
  model m;
  const auto cut = irg::triangulated(body);
  for (std::size_t f = 0; f < cut.face_count(); ++f)
    m.triangles.push_back({cut.positions[cut.corner(f, 0).position], cut.positions[cut.corner(f, 1).position],
                           cut.positions[cut.corner(f, 2).position]});
  const auto ball = irg::bounding_sphere_of(body);
  const float away = 2.5f * ball.radius, reach = 1.1f * ball.radius / away;
  const place eye = ball.centre + irg::vec<float, 3>{0, 0, away};
  for (int y = 0; y + 4 <= height; y += 4)
    for (int x = 0; x + 4 <= width; x += 4)
      for (int k = 0; k < 16; ++k) {
        const float u = (static_cast<float>(2 * (x + k % 4) + 1) / static_cast<float>(width) - 1) *
                        static_cast<float>(width) / static_cast<float>(height);
        const float v = 1 - static_cast<float>(2 * (y + k / 4) + 1) / static_cast<float>(height);
        m.camera.push_back({{eye.x, eye.y, eye.z}, {u * reach, v * reach, -1}, 0, INFINITY});
      }
  const tree t(std::span<const triangle>(m.triangles));
  const place lamp = ball.centre + irg::vec<float, 3>{2 * ball.radius, 2 * ball.radius, 2 * ball.radius};
  for (const camera_ray& r : m.camera) {
    const auto hit = irg::closest_hit(t, irg::ray<float, 3>{{r.origin[0], r.origin[1], r.origin[2]},
                                                            {r.direction[0], r.direction[1], r.direction[2]}});
    if (!hit) continue;
    camera_ray s{};
    s.low = 1e-4f;
    s.high = 1;
    for (int i = 0; i < 3; ++i) {
      s.origin[i] = r.origin[i] + r.direction[i] * static_cast<float>(hit->at.t);
      s.direction[i] = lamp[i] - s.origin[i];
    }
    m.shadow.push_back(s);
  }
  return m;
}

irg::ray<float, 3> ray_of(const camera_ray& r) {
  return {{r.origin[0], r.origin[1], r.origin[2]}, {r.direction[0], r.direction[1], r.direction[2]}, r.low, r.high};
}

void enter_model(const std::string& name, const irg::mesh<float>& body) {
  const int width = smoke() ? 16 : 1920, height = smoke() ? 8 : 1080;
  auto& made = keep_lazy([body, width, height] { return make_model(body, width, height); });
  const auto count = static_cast<std::int64_t>(width) * height;
  const auto triangles = static_cast<std::int64_t>(body.corners.size() - 2 * body.face_count());
  struct way {
    irg::bvh_method method;
    embree_quality of_embree;
    std::string name;
  };
  for (const way& w : {way{irg::bvh_method::surface_area, embree_quality::medium, "by area"},
                       way{irg::bvh_method::morton, embree_quality::low, "by place"},
                       way{irg::bvh_method::spatial_splits, embree_quality::high, "in parts"}}) {
    const irg::bvh_options config{w.method};
    const std::string& quality = w.name;
    const embree_quality chosen = w.of_embree;
    const contest building{"bvh build " + quality, name, "triangle", triangles, "", ""};
    enter(building, timed("irg", [&made, config] { tree(std::span<const triangle>(made->triangles), config); }));
    enter(building, {"embree", {}, {}, "", true, [&made, chosen] {
                       return in_own_process([&] { return embree_build_seconds(made->triangles, chosen, now); });
                     }});
    auto& built = keep_lazy([&made, config] { return tree(std::span<const triangle>(made->triangles), config); });
    auto& met = keep(std::int64_t{0});
    const contest first{"closest hit " + quality, name, "ray", count, "", ""};
    enter(first, timed("irg", [&made, &built, &met] {
            met = 0;
            for (const camera_ray& r : made->camera) met += irg::closest_hit(*built, ray_of(r)).has_value();
          }));
    enter(first, timed("irg:packet16", [&made, &built, &met] {
            constexpr std::size_t portion = 256;
            std::array<irg::ray<float, 3>, portion> rays;
            std::array<std::optional<irg::triangle_hit>, portion> hits;
            met = 0;
            for (std::size_t i = 0; i < made->camera.size(); i += portion) {
              const std::size_t n = made->camera.size() - i < portion ? made->camera.size() - i : portion;
              for (std::size_t k = 0; k < n; ++k) rays[k] = ray_of(made->camera[i + k]);
              irg::closest_hits(*built, std::span<const irg::ray<float, 3>>(rays.data(), n), std::span(hits.data(), n));
              for (std::size_t k = 0; k < n; ++k) met += hits[k].has_value();
            }
          }));
    for (const bool packets : {false, true})
      enter(first, {packets ? "embree:packet16" : "embree", {}, {}, "", true, [&made, chosen, packets] {
                      return in_own_process([&] {
                        return embree_ray_seconds(made->triangles, made->camera, chosen,
                                                  packets ? embree_task::packets : embree_task::closest, now);
                      });
                    }});
    if (w.method == irg::bvh_method::morton) continue;
    auto& lit = keep(std::int64_t{0});
    const contest shadow{"shadow ray " + quality, name, "ray", smoke() ? 16 : 750000, "", ""};
    const auto some = [&made](const auto& use) {  // as many as the contest says, from the beginning again if need be
      const auto& rays = made->shadow;
      const std::size_t n = smoke() ? 16 : 750000;
      for (std::size_t i = 0; i < n && !rays.empty(); ++i) use(rays[i % rays.size()]);
    };
    enter(shadow, timed("irg", [&built, &lit, some] {
            lit = 0;
            some([&](const camera_ray& r) { lit += irg::any_hit(*built, ray_of(r)); });
          }));
    enter(shadow, {"embree", {}, {}, "", true, [&made, some, chosen] {
                     std::vector<camera_ray> rays;
                     some([&](const camera_ray& r) { rays.push_back(r); });
                     return in_own_process(
                         [&] { return embree_ray_seconds(made->triangles, rays, chosen, embree_task::any, now); });
                   }});
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (smoke()) {
    enter_model("sphere 960", irg::shape_sphere<float>({.slices = 32, .stacks = 16}));
    return run_benchmarks(argc, argv);
  }
  enter_model("torus 2M", irg::shape_torus<float>({.major_segments = 1448, .minor_segments = 724}));
#ifdef IRG_MODELS_DIR
  if (const auto ogre = irg::load_mesh<float>(IRG_MODELS_DIR "/ogre.obj")) enter_model("ogre 124k", *ogre);
#endif
  return run_benchmarks(argc, argv);
}
