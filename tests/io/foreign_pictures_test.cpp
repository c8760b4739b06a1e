// SPDX-License-Identifier: MIT
// Every function of rasters, called with pictures of others: a class that has width(), height() and (x, y) alone, one with
// rows, OpenCV's. Each draws the same as on irg's own image. Every function of meshes with a mesh of others. The names are
// those of the tables in docs/own-types.md.
#include <irg/geometry/box.hpp>
#include <irg/hidden/height_grid.hpp>
#include <irg/io/apng.hpp>
#include <irg/io/image_file.hpp>
#include <irg/mesh/convex_body.hpp>
#include <irg/mesh/fit.hpp>
#include <irg/mesh/to_mesh.hpp>
#include <irg/raster.hpp>
#include <irg/shade/mip_pyramid.hpp>
#include <irg/shade/texture.hpp>
#include <irg/spatial/cell_grid.hpp>
#include <irg/visibility/viewshed.hpp>

#include <array>
#include <cstdint>
#include <fstream>
#include <set>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "support/opencv_raster.hpp"

namespace {

constexpr int width = 24, height = 16;
using grey = std::uint8_t;

class plain_picture {
public:
  [[nodiscard]] int width() const { return ::width; }
  [[nodiscard]] int height() const { return ::height; }
  grey& operator()(int x, int y) { return pixels_[static_cast<std::size_t>(y * ::width + x)]; }
  grey operator()(int x, int y) const { return pixels_[static_cast<std::size_t>(y * ::width + x)]; }

private:
  std::array<grey, static_cast<std::size_t>(::width) * ::height> pixels_{};
};
class picture_in_rows : public plain_picture {
public:
  grey* row(int y) { return &(*this)(0, y); }
};

struct foreign_point {
  double x, y, z;
};
struct foreign_mesh {
  std::vector<foreign_point> vertices;
  std::vector<int> indices;
};

}  // namespace

template <>
struct irg::mesh_traits<foreign_mesh> {
  using point = foreign_point;
  static std::size_t vertex_count(const foreign_mesh& m) { return m.vertices.size(); }
  static const foreign_point& position(const foreign_mesh& m, std::size_t v) { return m.vertices[v]; }
  static std::size_t face_count(const foreign_mesh& m) { return m.indices.size() / 3; }
  static std::size_t face_size(const foreign_mesh&, std::size_t) { return 3; }
  static int face_vertex(const foreign_mesh& m, std::size_t f, std::size_t k) { return m.indices[3 * f + k]; }
};

namespace {

// Draws with each function in turn, and tells after each what it said and what is on the picture.
template <class R>
std::vector<std::string> draw_all(R picture, std::set<std::string>& called) {
  std::vector<std::string> seen;
  const auto note = [&](const char* name) {
    called.insert(name);
    std::string state = name;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) state += static_cast<char>(irg::get_pixel(picture, x, y));
    seen.push_back(state);
  };
  const auto call = [&](const char* name, const auto& draw) {
    irg::clear(picture, grey{10});
    draw();
    note(name);
  };
  using P = irg::point<double, 2>;
  using cells = std::vector<irg::cell>;
  const P a{1.5, 2}, b{20.25, 5}, c{9, 14.5};
  const std::vector<P> ring{a, b, c};
  const std::vector<irg::subpixel> corners{{400, 500}, {5000, 1200}, {2300, 3700}};
  call("clear", [] {});
  call("set_pixel", [&] { irg::set_pixel(picture, 3, 4, grey{200}); });
  call("paint_pixel", [&] { irg::paint_pixel(picture, 5, 6, grey{250}, std::uint8_t{100}); });
  call("fill_span", [&] { irg::fill_span(picture, {3, 9, 4}, grey{200}); });
  call("blend_span", [&] {
    const std::array<std::uint8_t, 3> coverage{50, 100, 200};
    irg::blend_span(picture, irg::coverage_span{.y = 4, .x_first = 3, .coverage = coverage.data()}, grey{200});
  });
  call("draw_line", [&] { irg::draw_line(picture, {-5, 3}, {30, 9}, grey{200}); });
  call("draw_lines", [&] { irg::draw_lines(picture, std::vector<irg::cell_line>{{{1, 1}, {20, 9}}}, grey{200}); });
  call("draw_painted_lines", [&] {
    struct painted {
      irg::cell from, to;
      grey paint;
    };
    irg::draw_painted_lines(picture, std::vector<painted>{{{1, 1}, {20, 9}, 200}, {{2, 9}, {20, 1}, 100}});
  });
  call("draw_line_styled", [&] {
    static_cast<void>(
        irg::draw_line_styled(picture, {1, 1}, {20, 9}, irg::line_dashes<irg::dash_mask>{{0xf0f0}}, grey{200}));
  });
  call("fill_polygons", [&] {
    static_cast<void>(
        irg::fill_polygons(picture, std::vector<std::vector<P>>{ring}, irg::fill_rule::non_zero, grey{200}));
  });
  call("draw_polygon", [&] { irg::draw_polygon(picture, cells{{1, 1}, {20, 3}, {7, 12}}, grey{200}); });
  call("draw_polyline", [&] { irg::draw_polyline(picture, cells{{1, 1}, {20, 3}, {7, 12}}, grey{200}); });
  call("draw_line_aa", [&] { irg::draw_line_aa(picture, a, b, grey{200}); });
  call("draw_line_wu", [&] { irg::draw_line_wu(picture, a, c, grey{200}); });
  call("draw_line_subpixel", [&] { static_cast<void>(irg::draw_line_subpixel(picture, a, c, grey{200})); });
  call("draw_line_thick", [&] { static_cast<void>(irg::draw_line_thick(picture, a, c, irg::line_pen{}, grey{200})); });
  call("draw_polyline_thick", [&] { irg::draw_polyline_thick(picture, corners, irg::line_pen{}, grey{200}); });
  call("draw_circle", [&] { irg::draw_circle(picture, {9, 8}, 6, grey{200}); });
  call("fill_circle", [&] { irg::fill_circle(picture, {9, 8}, 6, grey{200}); });
  call("draw_ellipse", [&] { irg::draw_ellipse(picture, {9, 8}, 8, 5, grey{200}); });
  call("fill_ellipse", [&] { irg::fill_ellipse(picture, {9, 8}, 8, 5, grey{200}); });
  call("fill_convex", [&] { static_cast<void>(irg::fill_convex(picture, ring, grey{200})); });
  call("fill_convex_aa", [&] { static_cast<void>(irg::fill_convex_aa(picture, ring, grey{200})); });
  call("fill_triangle", [&] { static_cast<void>(irg::fill_triangle(picture, a, b, c, grey{200})); });
  call("fill_polygon",
       [&] { static_cast<void>(irg::fill_polygon(picture, ring, irg::fill_rule::non_zero, grey{200})); });
  call("fill_polygon_aa",
       [&] { static_cast<void>(irg::fill_polygon_aa(picture, ring, irg::fill_rule::non_zero, grey{200})); });
  call("flood_fill", [&] { irg::flood_fill(picture, {3, 3}, grey{90}); });
  call("boundary_fill", [&] { irg::boundary_fill(picture, {3, 3}, grey{200}, grey{90}); });
  call("draw_stroke", [&] { static_cast<void>(irg::draw_stroke(picture, ring, irg::stroke_style{}, grey{200})); });
  call("draw_text", [&] { static_cast<void>(irg::draw_text(picture, "irg", {2, 12}, irg::text_style{}, grey{200})); });
  call("within", [&] {
    auto part = irg::within(picture, irg::cell_window{4, 4, 12, 12});
    irg::fill_circle(part, {9, 8}, 6, grey{200});
  });
  call("convert_into", [&] { irg::convert_into(picture, irg::image<grey>(width, height, grey{7})); });

  irg::clear(picture, grey{10});
  irg::fill_circle(picture, {9, 8}, 6, grey{200});
  const auto said = [&](const char* name, const auto& bytes) {
    called.insert(name);
    seen.emplace_back(bytes.begin(), bytes.end());
  };
  said("encode_png", *irg::encode_png(picture));
  said("encode_pgm", *irg::encode_pgm(picture));
  said("encode_ppm", *irg::encode_ppm(picture));
  said("encode_svg", *irg::encode_svg(picture));
  said("encode_image", *irg::encode_image(picture, irg::image_format::ppm));
  const std::vector<R> pictures{picture, picture};
  said("encode_animation", *irg::encode_animation(std::span<const R>(pictures)));
  called.insert("save_image");
  CHECK(!irg::save_image("foreign.jpg", picture).has_value());  // said to be no format of irg's
  const auto told = [&](const char* name, const auto&... number) {
    called.insert(name);
    seen.push_back((name + ... + (" " + std::to_string(number))));
  };
  told("convert_image", irg::convert_image<grey>(picture)(9, 8));
  told("sample_texture", irg::sample_texture(picture, 0.4f, 0.5f).g);
  told("make_mip_pyramid", irg::make_mip_pyramid(picture).levels[1](2, 2).g);
  told("heights_of_image", irg::heights_of_image(picture, [](grey g) { return g / 255.0; }).heights[200]);
  told("grid_from_raster", irg::grid_from_raster(picture, [](grey g) { return g > 100; }).is_full({9, 8, 0}));
  told("viewshed", irg::viewshed(picture, {2, 2}).is_full({3, 3, 0}));
  told("has_line_of_sight", irg::has_line_of_sight(picture, {1, 8}, {20, 8}));
  told("width_of", irg::width_of(picture));
  told("height_of", irg::height_of(picture));
  told("get_pixel", irg::get_pixel(picture, 9, 8));
  told("window_of", irg::window_of(picture).x_last);
  return seen;
}

// The names in the first column of the table that begins with this head.
std::set<std::string> names_of_page(const std::string& head) {
  std::ifstream page(IRG_CONFORMANCE_DIR "/../../docs/own-types.md");
  std::set<std::string> names;
  bool inside = false;
  for (std::string line; std::getline(page, line);) {
    if (line.rfind(head, 0) == 0) inside = true;
    if (line.empty()) inside = false;
    if (inside && line.rfind("| `", 0) == 0) names.insert(line.substr(3, line.find('`', 3) - 3));
  }
  return names;
}

}  // namespace

TEST_CASE("foreign pictures: every function of rasters draws on them what it draws on an image") {
  std::set<std::string> called;
  const auto wanted = draw_all(irg::image<grey>(width, height), called);
  CHECK(draw_all(plain_picture{}, called) == wanted);
  CHECK(draw_all(picture_in_rows{}, called) == wanted);
#ifdef IRG_HAVE_OPENCV
  CHECK(draw_all(cv::Mat_<grey>(height, width), called) == wanted);
#endif
  CHECK(names_of_page("| function of rasters") == called);
}

TEST_CASE("foreign meshes: every function of meshes") {
  const foreign_mesh m{{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}}, {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3}};
  std::set<std::string> called;
  const auto call = [&](const char* name, bool right) {
    INFO(name);
    CHECK(right);
    called.insert(name);
  };
  call("mesh_vertex_count", irg::mesh_vertex_count(m) == 4);
  call("mesh_position", irg::mesh_position(m, 1).x == 2);
  call("mesh_face_count", irg::mesh_face_count(m) == 4);
  call("mesh_face_size", irg::mesh_face_size(m, 0) == 3);
  call("mesh_face_vertex", irg::mesh_face_vertex(m, 0, 1) == 2);
  call("to_mesh", irg::to_mesh<double>(m).face_count() == 4);
  call("is_closed", irg::is_closed(m));
  call("fit_of", irg::fit_of(m).scale > 0);
  call("bounding_box", irg::bounding_box(m).high.x == 2);
  call("bounding_sphere_of", irg::bounding_sphere_of(m).radius > 1);
  CHECK(names_of_page("| function of meshes") == called);
}
