// SPDX-License-Identifier: MIT
// 09_shader - pixels by a function of one's own: a torus whose chequers are computed, not painted: shader.png, or the
// file named on the command line.
// previous: 08_teapot, next: 10_renderer
#include <array>
#include <cstdio>
#include <vector>

#include <irg/colour/srgb.hpp>
#include <irg/io/image_file.hpp>
#include <irg/math/trigonometry.hpp>
#include <irg/raster/image.hpp>
#include <irg/render/draw_triangles.hpp>
#include <irg/scene/camera.hpp>

#include "support/step.hpp"

using batch = irg::triangle_batch<double>;

// The shader. A vertex has two angles and a brightness; a pixel is light or dark by the angles at it.
struct chequers {
  static constexpr int attribute_count = 3;
  const std::vector<std::array<float, 3>>& vertices;

  const float* attributes(const batch&, std::uint32_t vertex, irg::facing) const { return vertices[vertex].data(); }

  irg::rgba8 pixel(const std::array<float, 3>& at) const {
    const bool dark = (static_cast<int>(at[0] * 24) + static_cast<int>(at[1] * 8)) % 2 != 0;
    const float light = irg::clamped(at[2], 0.05f, 1.0f);
    return dark ? irg::encode({0.05f * light, 0.1f * light, 0.25f * light})
                : irg::encode({0.9f * light, 0.8f * light, 0.6f * light});
  }
};

int main(int argc, char** argv) {
  const std::string file = program::step(
      argc, argv, "09_shader", "pixels by a function of one's own: a torus whose chequers are computed, not painted",
      "shader.png");
  constexpr int around = 96, across = 32;  // the last row and column repeat the first: angle 1, not 0
  std::vector<irg::point<double, 3>> positions;
  std::vector<std::array<float, 3>> vertices;
  std::vector<irg::triangle_indices> triangles;
  for (int i = 0; i <= around; ++i)
    for (int k = 0; k <= across; ++k) {
      const double s = 1.0 * i / around, t = 1.0 * k / across, a = s * 2 * irg::pi<double>, b = t * 2 * irg::pi<double>;
      const irg::vec<double, 3> out{irg::cos(a) * irg::cos(b), irg::sin(b), irg::sin(a) * irg::cos(b)};
      positions.push_back({irg::cos(a) + 0.45 * out.x, 0.45 * out.y, irg::sin(a) + 0.45 * out.z});
      const double light = 0.3 * out.x + 0.8 * out.y + 0.5 * out.z;
      vertices.push_back({static_cast<float>(s), static_cast<float>(t), static_cast<float>(0.15 + 0.85 * light)});
      const auto v = static_cast<std::uint32_t>(i * (across + 1) + k), next = v + across + 1;
      if (i == around || k == across) continue;
      triangles.push_back({{v, v + 1, next}});
      triangles.push_back({{v + 1, next + 1, next}});
    }

  irg::camera<double> camera;
  camera.eye = {0, 2.6, 3.4};
  camera.target = {0, -0.1, 0};
  const auto mapping = irg::map_to_screen<double>({480, 360});
  const auto projected = irg::project_vertices<double>(positions, irg::view_projection(camera, 480.0 / 360), mapping);
  irg::image<irg::rgba8> picture(480, 360, {250, 249, 246, 255});
  irg::image<float> depth(480, 360, irg::nearer_is_greater::farthest);
  const batch torus[1] = {{&projected, triangles}};
  const auto stats = irg::shade_batches({picture, depth}, {torus, mapping}, chequers{vertices});

  if (const auto saved = irg::save_image(file, picture); !saved)
    program::fail("09_shader", saved.error().message + (": " + file));
  int dark = 0;
  for (int y = 0; y < 360; ++y)
    for (int x = 0; x < 480; ++x) dark += picture(x, y).b > picture(x, y).r ? 1 : 0;
  std::printf("%lld pixels shaded, %d of them dark; %s\n", static_cast<long long>(stats.pixels.shaded), dark,
              file.c_str());
  const long long third = stats.pixels.shaded / 3;
  return stats.pixels.shaded > 40000 && dark > third && dark < 2 * third ? 0 : 1;
}
