// SPDX-License-Identifier: MIT
// A mesh of coloured vertices, 1920 x 1080, one thread: clear, transform, cull, rasterize with depth test and Gouraud
// interpolation, finish. Both sides get the same vertices, colours, indices and matrix. irg also encodes sRGB.
#include <cstdio>
#include <cstring>
#include <memory>

#include <irg/io/file.hpp>
#include <irg/io/image_file.hpp>
#include <irg/io/obj.hpp>
#include <irg/mesh/shapes.hpp>
#include <irg/raster/image.hpp>
#include <irg/render/render.hpp>

#include "support/measure.hpp"
#ifdef IRG_HAVE_OSMESA
#include "support/llvmpipe.hpp"
#endif

namespace {

constexpr int width = 1920, height = 1080;
constexpr irg::rgba8 background{0, 0, 0, 255};

struct prepared {
  std::string name;
  irg::drawable<float> body;
  std::vector<irg::rgb<float>> colours;
  irg::mat<float, 4, 4> to_clip;
};

irg::mesh<float> load(std::string& name) {
#ifdef IRG_MODELS_DIR
  if (const auto text = irg::read_file(IRG_MODELS_DIR "/stanford-bunny.obj"))
    if (auto mesh = irg::read_obj<float>({text->data(), text->size()})) {
      name = "bunny";
      return *std::move(mesh);
    }
#endif
  std::puts("The bunny is not there; a sphere of as many triangles stands in for it.");
  name = "sphere";
  return irg::shape_sphere<float>({.slices = 264, .stacks = 132});
}

prepared prepare() {
  prepared p;
  const irg::mesh<float> shape = load(p.name);
  p.body = irg::make_drawable(shape);
  const auto ball = irg::sphere_around(shape);
  const auto view =
      irg::camera_around(ball.centre, ball.radius, irg::vec<float, 3>{0, 0.2f, 1}, irg::radians(40.0f), 16.0f / 9.0f);
  p.to_clip = irg::view_projection(view, 16.0f / 9.0f);
  const irg::light<float> lamp{{-0.5f, 0.7f, 1, 0}, {1, 1, 1}};
  const irg::gouraud_shader<float> shader{
      {{0.2f, 0.2f, 0.2f}, {0.7f, 0.5f, 0.3f}, {}, 1}, {{0.3f, 0.3f, 0.3f}, {&lamp, 1}}, view.eye};
  for (std::size_t i = 0; i < p.body.positions.size(); ++i)
    p.colours.push_back(shader(p.body.positions[i], p.body.normals[i]));
  return p;
}

std::int64_t not_background(const irg::image<irg::rgba8>& picture) {
  std::int64_t n = 0;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) n += !(picture(x, y) == background);
  return n;
}

}  // namespace

int main() {
  const prepared p = prepare();
  irg::image<irg::rgba8> picture(width, height);
  irg::image<float> depth(width, height);
  const auto mapping = irg::map_to_screen<float>(width, height);
  irg::render_stats stats;

  const auto make_shader = [&](std::uint32_t i, irg::facing) {
    const auto [a, b, c] = p.body.triangles[i].v;
    return irg::vertex_colour_shader<irg::rgba8, irg::detail::encode_srgb>{
        p.colours[a], p.colours[b], p.colours[c], {}};
  };
  const auto draw = [&](irg::face_culling culling) {
    const auto vertices = irg::project_vertices<float>(p.body.positions, p.to_clip, mapping);
    stats = irg::draw_triangles<irg::nearer_is_greater, float>(
        picture, depth, vertices, p.body.triangles, mapping, make_shader,
        irg::draw_settings<irg::rgba8>{culling, irg::skip_options{}, irg::clearing::before_drawing, background});
  };
  std::vector<bench::contender> racers;
  racers.push_back({"irg culled", [&] { draw(irg::face_culling::back); }});
  racers.push_back({"irg not culled", [&] { draw(irg::face_culling::none); }});
  racers.push_back({"limit: clear colour and depth", [&] {
                      std::memset(static_cast<void*>(picture.data()), 0, std::size_t{4} * width * height);
                      std::memset(depth.data(), 0, std::size_t{4} * width * height);
                    }});
#ifdef IRG_HAVE_OSMESA
  auto peer = std::make_unique<bench::llvmpipe>(width, height, 0);
  if (peer->ok()) {
    peer->load(p.body.positions, p.colours, p.body.triangles, p.to_clip);
    racers.push_back({"llvmpipe culled", [&] { peer->draw(true, {0, 0, 0}); }});
    racers.push_back({"llvmpipe not culled", [&] { peer->draw(false, {0, 0, 0}); }});
  }
#else
  std::puts("OSMesa was not found when this was configured: no peer to compare with.");
#endif
  bench::race(racers, 21);

  draw(irg::face_culling::back);
  const std::int64_t pixels = not_background(picture);
  std::int64_t peer_pixels = 0, differing = 0;
#ifdef IRG_HAVE_OSMESA
  if (peer->ok()) {
    std::printf("peer: %s\n", peer->renderer().c_str());
    peer->draw(true, {0, 0, 0});
    peer_pixels = not_background(peer->picture());
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        differing += (peer->picture()(x, y) == background) != (picture(x, y) == background);
  }
#endif
  const auto triangles = static_cast<std::int64_t>(p.body.triangles.size());
  std::printf(
      "%s: %lld triangles, %lld skipped as back faces, %lld as small; pixels drawn: irg %lld, llvmpipe %lld; covered "
      "by one only: %lld\n",
      p.name.c_str(), static_cast<long long>(triangles), static_cast<long long>(stats.skipped.backface),
      static_cast<long long>(stats.skipped.tiny), static_cast<long long>(pixels), static_cast<long long>(peer_pixels),
      static_cast<long long>(differing));
  std::printf("%-32s %9s %9s %9s\n", "milliseconds of processor time", "median", "least", "90 %");
  const double limit = racers[2].median();
  for (const bench::contender& c : racers) {
    std::printf("%-32s %9.3f %9.3f %9.3f\n", c.name.c_str(), c.median() * 1e3, c.percentile(0) * 1e3,
                c.percentile(0.9) * 1e3);
    const bool culled = c.name.find("not culled") == std::string::npos, own = c.name.starts_with("irg");
    bench::row r{.kernel = "render",
                 .test_case = p.name + (culled ? " gouraud 1920x1080 culled" : " gouraud 1920x1080"),
                 .implementation = own                           ? "irg"
                                   : c.name.starts_with("limit") ? "limit:clear"
                                                                 : "llvmpipe"};
    r.ns_per_item = c.median() * 1e9 / static_cast<double>(triangles);
    r.items = triangles;
    r.item = "triangle";
    r.limit_fraction = bench::number(limit / c.median());
    if (culled && own) r.note = std::to_string(pixels) + " pixels drawn; sRGB encoded";
    if (culled && r.implementation == "llvmpipe") {
      r.wrong = std::to_string(differing);
      r.note = std::to_string(peer_pixels) +
               " pixels drawn; wrong: pixels covered by one side only; 24-bit depth; no sRGB encoding";
    }
    bench::report(r);
  }
  if (const char* path = std::getenv("IRG_BENCH_PICTURE"))
    if (const auto error = irg::write_image(path, picture)) std::printf("%s: %s\n", error->message, path);
}
