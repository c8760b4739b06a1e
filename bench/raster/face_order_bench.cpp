// SPDX-License-Identifier: MIT
// Which of two faces is nearer at a pixel: what exactness costs beside the comparison of two floats.
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include <irg/raster/draw_triangle.hpp>
#include <irg/raster/face_order.hpp>
#include <irg/raster/image.hpp>

#include "support/measure.hpp"
#include "support/random_numbers.hpp"

namespace {

using namespace bench;

float rounded_depth(const irg::screen_face& f, int x, int y) {
  irg::image<char> colour(1, 1);
  irg::image<float> depth(1, 1, 0.0f);
  irg::screen_vertex v[3] = {f.v[0], f.v[1], f.v[2]};
  for (irg::screen_vertex& c : v) c.position.x -= x * irg::one_pixel, c.position.y -= y * irg::one_pixel;
  irg::shade_triangle(colour, depth, {v[0], v[1], v[2]}, irg::solid_shader<char>{1});
  return depth(0, 0);
}

enum class depths { apart, close, one_plane, wide };

// A face around pixel (x, y) of a picture: with depths that differ by a fifth and more from those of the next face, or
// in the last places only; in one plane with all others, or with the face before it, corners of very different depths.
irg::screen_face make_face(random_numbers& r, depths kind, int x, int y, std::uint32_t number) {
  irg::screen_vertex v[3];
  for (int i = 0; i < 3; ++i) {
    const int dx = (i == 0 ? 0 : i == 1 ? -1 : 1) * r.integer(90, 300), dy = (i == 0 ? -1 : 1) * r.integer(90, 300);
    const irg::subpixel p{(x + dx) * irg::one_pixel + r.integer(0, 255), (y + dy) * irg::one_pixel + r.integer(0, 255)};
    double depth = (number % 2 == 0 ? 0.2 : 0.6) + 0.1 * r.unit();
    if (kind == depths::close) depth = 0.5 + std::ldexp(r.integer(0, 2), -24);
    if (kind == depths::one_plane) depth = std::ldexp(p.x + 3 * p.y, -21);
    if (kind == depths::wide) depth = i == 0 ? 1.0 : std::ldexp(1.0, -60);
    v[i] = {p, static_cast<float>(depth)};
  }
  return irg::make_screen_face(v[0], v[1], v[2], number);
}

// Two faces that cover a pixel, and their depths there as the triangle kernel rounds them.
struct question {
  std::uint32_t a, b;
  int x, y;
  float depth_a, depth_b;
};

void enter_case(const std::string& name, depths kind) {
  // Few faces, which stay in the first cache, and many pixels.
  random_numbers r(static_cast<std::uint64_t>(kind) + 1);
  auto& faces = keep(std::vector<irg::screen_face>());
  for (std::uint32_t i = 0; i < 32; ++i)
    if (kind == depths::wide && i % 2 == 1)
      faces.push_back(irg::make_screen_face(faces.back().v[1], faces.back().v[0], faces.back().v[2], i));
    else
      faces.push_back(make_face(r, kind, 600, 450, i));
  auto& questions = keep(std::vector<question>());
  while (questions.size() < 1024) {
    const auto a = static_cast<std::uint32_t>(r.integer(0, 31)), b = a ^ 1u;
    const int x = r.integer(550, 650), y = r.integer(400, 500);
    if (covers(faces[a], x, y) && covers(faces[b], x, y))
      questions.push_back({a, b, x, y, rounded_depth(faces[a], x, y), rounded_depth(faces[b], x, y)});
  }
  auto& answers = keep(std::vector<std::uint8_t>(questions.size()));
  auto& truth = keep(std::vector<std::uint8_t>());
  for (const question& q : questions) {
    const irg::subpixel centre = irg::detail::centre_of(q.x, q.y);
    const int sign =
        irg::detail::exact_sign(irg::detail::plane_at(faces[q.a], centre), irg::detail::plane_at(faces[q.b], centre));
    truth.push_back(sign != 0 ? sign > 0 : q.a < q.b);
  }
  const contest what{"face_order", name + build_suffix(),     "decision", static_cast<std::int64_t>(questions.size()),
                     "",           "limit:compare two floats"};
  const auto add = [&](const std::string& who, auto first) {
    contender c{who, [&questions, &answers, first] {
                  const question* const all = questions.data();
                  std::uint8_t* const into = answers.data();
                  for (std::size_t i = 0, count = questions.size(); i < count; ++i) into[i] = first(all[i]);
                  asm volatile("" : : "r"(into) : "memory");
                }};
    c.same_work = who != what.limit;
    c.judge = [&answers, &truth, exact = c.same_work] {
      errors e;
      e.wrong = 0;
      for (std::size_t i = 0; i < truth.size(); ++i) e.wrong += answers[i] != truth[i];
      if (exact && e.wrong != 0) e.broken = "a decision is wrong";
      return e;
    };
    enter(what, std::move(c));
  };
  add("irg", [f = faces.data()](const question& q) { return irg::is_nearer(f[q.a], f[q.b], q.x, q.y); });
  add("irg:rounded depths at hand", [f = faces.data()](const question& q) {
    return irg::is_nearer(irg::face_sample{f[q.a], q.depth_a}, irg::face_sample{f[q.b], q.depth_b}, q.x, q.y);
  });
  add("limit:compare two floats", [](const question& q) { return q.depth_a > q.depth_b; });
}

}  // namespace

int main(int argc, char** argv) {
  enter_case("depths apart", depths::apart);
  enter_case("depths close", depths::close);
  enter_case("one plane", depths::one_plane);
  enter_case("one plane of wide depths", depths::wide);
  return run_benchmarks(argc, argv);
}
