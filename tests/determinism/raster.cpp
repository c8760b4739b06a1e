// SPDX-License-Identifier: MIT
#include <irg/raster/circle_midpoint.hpp>
#include <irg/raster/draw_lines.hpp>
#include <irg/raster/draw_triangle.hpp>
#include <irg/raster/ellipse_midpoint.hpp>
#include <irg/raster/textbook/fill_convex.hpp>
#include <irg/raster/fill_convex.hpp>
#include <irg/raster/fill_convex_aa.hpp>
#include <irg/raster/fill_polygon.hpp>
#include <irg/raster/fill_polygon_aa.hpp>
#include <irg/raster/fill_span.hpp>
#include <irg/raster/image.hpp>
#include <irg/raster/line_aa.hpp>
#include <irg/raster/line_bresenham.hpp>
#include <irg/raster/line_dda.hpp>
#include <irg/raster/line_run_slice.hpp>
#include <irg/raster/line_styled.hpp>
#include <irg/raster/line_subpixel.hpp>
#include <irg/raster/textbook/line_bresenham.hpp>
#include <irg/raster/line_thick.hpp>
#include <irg/raster/line_wu.hpp>
#include <irg/raster/seed_fill.hpp>

#include <irg/colour/srgb.hpp>
#include <irg/geometry/edge_equation.hpp>
#include <irg/geometry/point_in_polygon.hpp>
#include <irg/geometry/polygon_convexity.hpp>
#include <irg/geometry/polygon_orientation.hpp>

#include <vector>

#include "hashes.hpp"

namespace {

struct encode_srgb {
  constexpr irg::rgba8 operator()(const irg::rgb<float>& light) const { return irg::encode(light); }
};

constexpr irg::screen_vertex random_vertex(test::random& r, int width, int height) {
  return {{static_cast<std::int32_t>(r.integer(-width * 64, width * 320)),
           static_cast<std::int32_t>(r.integer(-height * 64, height * 320))},
          static_cast<float>(r.unit()),
          static_cast<float>(0.01 + r.unit())};
}

constexpr void add(determinism::hasher& h, const irg::image<irg::rgba8>& colour, const irg::image<float>& depth) {
  for (int y = 0; y < colour.height(); ++y)
    for (int x = 0; x < colour.width(); ++x) {
      const irg::rgba8 p = colour(x, y);
      h.add(p.r | p.g << 8 | p.b << 16);
      h.add(depth(x, y));
    }
}

// Constant evaluation takes the plain kernel, run time the lanes: one hash says that they agree.
template <class Order>
constexpr std::uint64_t triangles(int rounds) {
  const int width = rounds < 10 ? 19 : 203, height = rounds < 10 ? 7 : 61;
  test::random r(7);
  determinism::hasher h;
  irg::image<irg::rgba8> colour(width, height);
  irg::image<float> depth(width, height, Order::farthest);
  irg::draw_counts counts;
  for (int i = 0; i < rounds; ++i) {
    const auto light = [&] {
      const auto red = static_cast<float>(r.unit()), green = static_cast<float>(r.unit());
      return irg::rgb<float>{red, green, static_cast<float>(r.unit())};
    };
    const auto a = random_vertex(r, width, height), b = random_vertex(r, width, height),
               c = random_vertex(r, width, height);
    const auto at0 = light(), at1 = light(), at2 = light();
    counts += irg::shade_triangle<Order>(colour, depth, {a, b, c},
                                         irg::vertex_colour_shader<irg::rgba8, encode_srgb>{at0, at1, at2, {}});
  }
  add(h, colour, depth);
  h.add(counts.tested);
  h.add(counts.shaded);
  h.add(counts.ties);
  return h.value();
}

constexpr std::uint64_t raster_triangle_tile_reversed(int rounds) { return triangles<irg::nearer_is_greater>(rounds); }
constexpr std::uint64_t raster_triangle_tile_standard(int rounds) { return triangles<irg::nearer_is_less>(rounds); }
HASHED(raster_triangle_tile_reversed, 3, 3000);
HASHED(raster_triangle_tile_standard, 3, 3000);

constexpr std::uint64_t raster_fill_span(int rounds) {
  test::random r(8);
  determinism::hasher h;
  irg::image<irg::rgba8> colour(97, 5);
  const irg::image<float> depth(97, 5, 0.0f);
  for (int i = 0; i < rounds; ++i) {
    const int y = static_cast<int>(r.integer(-1, 5)), first = static_cast<int>(r.integer(-9, 97)),
              last = static_cast<int>(r.integer(-9, 120));
    const auto shade = static_cast<std::uint8_t>(r.integer(0, 255));
    irg::fill_span(colour, {y, first, last}, {shade, 1, 2, 3});
  }
  add(h, colour, depth);
  return h.value();
}
HASHED(raster_fill_span, 9, 10000);

constexpr std::uint64_t raster_lines(int rounds) {
  test::random r(9);
  determinism::hasher h;
  for (int i = 0; i < rounds; ++i) {
    const auto end = [&] {
      const int x = static_cast<int>(r.integer(-90, 90));
      return irg::cell{x, static_cast<int>(r.integer(-90, 90))};
    };
    const irg::cell a = end(), b = end();
    irg::line_bresenham(a, b, {-30, -30, 30, 30}, [&](irg::cell c) { h.add(c.x * 1000 + c.y); });
  }
  return h.value();
}
HASHED(raster_lines, 9, 10000);

// The forms in floating point: sums of rounded slopes must round the same way everywhere.
template <class Number>
constexpr std::uint64_t lines_in(int rounds) {
  test::random r(10);
  determinism::hasher h;
  const auto add = [&](irg::cell c) { h.add(c.x * 1000 + c.y); };
  for (int i = 0; i < rounds; ++i) {
    const int x = static_cast<int>(r.integer(-90, 90));
    const irg::cell b{x, static_cast<int>(r.integer(-90, 90))};
    irg::textbook::line_bresenham<Number>({0, 0}, b, add);
    irg::line_dda<Number>({0, 0}, b, add);
    irg::line_dda_exact({0, 0}, b, add);
    irg::line_run_slice({0, 0}, b, [&](const irg::line_run& run) { add(run.first), add(run.last); });
  }
  return h.value();
}
constexpr std::uint64_t raster_teaching_lines_double(int rounds) { return lines_in<double>(rounds); }
constexpr std::uint64_t raster_teaching_lines_float(int rounds) { return lines_in<float>(rounds); }
HASHED(raster_teaching_lines_double, 5, 3000);
HASHED(raster_teaching_lines_float, 5, 3000);

// Lines with sub-pixel ends, wide ones, dashed ones; circles and ellipses: cells and spans.
constexpr std::uint64_t raster_line_variants(int rounds) {
  test::random r(11);
  determinism::hasher h;
  const irg::cell_window w{-9, -9, 30, 30};
  const auto cell = [&](irg::cell c) { h.add(c.x * 1000 + c.y); };
  const auto span = [&](irg::span_of_cells s) { h.add((s.y * 1000 + s.x_first) * 1000 + s.x_last); };
  const auto number = [&](int low, int high) { return static_cast<int>(r.integer(low, high)); };
  const std::uint32_t runs[] = {3, 2, 1};
  for (int i = 0; i < rounds; ++i) {
    const int ax = number(-9000, 9000), ay = number(-9000, 9000), bx = number(-9000, 9000), by = number(-9000, 9000);
    const irg::subpixel a{ax, ay}, b{bx, by};
    irg::line_subpixel(a, b, w, cell);
    irg::line_subpixel(a, b, w, cell, {.rule = irg::line_rule::diamond_exit});
    irg::line_thick(a, b, {.width = number(0, 2000), .caps = irg::line_caps::round}, w, span);
    irg::line_thick(a, b, {.width = number(0, 2000), .caps = irg::line_caps::square}, w, span);
    h.add(irg::line_styled({ax / 256, ay / 256}, {bx / 256, by / 256}, irg::line_dashes{irg::dash_runs{runs}, r.next()},
                           w, cell));
  }
  return h.value();
}
HASHED(raster_line_variants, 3, 3000);

constexpr std::uint64_t raster_circles_and_ellipses(int rounds) {
  test::random r(12);
  determinism::hasher h;
  const irg::cell_window w{-9, -9, 30, 30};
  const auto cell = [&](irg::cell c) { h.add(c.x * 1000 + c.y); };
  const auto span = [&](irg::span_of_cells s) { h.add((s.y * 1000 + s.x_first) * 1000 + s.x_last); };
  for (int i = 0; i < rounds; ++i) {
    const int top = i % 2 ? 40 : 70000, x = static_cast<int>(r.integer(0, top)),
              y = static_cast<int>(r.integer(0, top));
    const irg::cell centre{-x + 5, static_cast<int>(r.integer(-20, 20))};
    irg::circle_midpoint(centre, x, w, cell);
    irg::circle_spans(centre, x, w, span);
    irg::ellipse_midpoint(centre, x, y, w, cell);
    irg::ellipse_spans(centre, x, y, w, span);
  }
  return h.value();
}
HASHED(raster_circles_and_ellipses, 3, 3000);

constexpr std::uint64_t raster_textbook_fill(int rounds) {
  test::random r(13);
  determinism::hasher h;
  for (int i = 0; i < rounds; ++i) {
    irg::subpixel ring[3];
    for (irg::subpixel& v : ring) {
      v.x = static_cast<std::int32_t>(r.integer(-3000, 3000));
      v.y = static_cast<std::int32_t>(r.integer(-3000, 3000));
    }
    const auto rule = static_cast<irg::textbook::sample_rule>(r.integer(0, 3));
    irg::textbook::convex_spans(ring, rule, {-9, -9, 9, 9},
                                [&](irg::span_of_cells s) { h.add(s.y * 1000000 + s.x_first * 1000 + s.x_last); });
  }
  return h.value();
}
HASHED(raster_textbook_fill, 3, 3000);

constexpr std::uint64_t raster_seed_fill(int rounds) {
  test::random r(14);
  determinism::hasher h;
  for (int i = 0; i < rounds; ++i) {
    irg::image<int> cells(17, 9, 0);
    for (int k = 0; k < 60; ++k) {
      const int x = static_cast<int>(r.integer(0, 16));
      cells(x, static_cast<int>(r.integer(0, 8))) = 1;
    }
    const auto next_to = static_cast<irg::neighbours>(r.integer(0, 1));
    h.add(irg::flood_fill(cells, {8, 4}, 2, next_to));
    for (int y = 0; y < 9; ++y)
      for (int x = 0; x < 17; ++x) h.add(cells(x, y));
  }
  return h.value();
}
HASHED(raster_seed_fill, 2, 3000);

// Nearly collinear doubles: the filter and the exact sum must agree with contraction on and off.
constexpr std::uint64_t geometry_polygon_convexity(int rounds) {
  test::random r(15);
  determinism::hasher h;
  for (int i = 0; i < rounds; ++i) {
    irg::point<double, 2> ring[4];
    for (auto& v : ring) {
      const double at = static_cast<double>(r.integer(-24, 24)) / 2;
      v.x = at + static_cast<double>(r.integer(-2, 2)) * 0x1p-49;
      v.y = at / 3 + static_cast<double>(r.integer(-2, 2)) * 0x1p-51;
    }
    h.add(static_cast<int>(irg::orientation_of(ring)));
    h.add(irg::is_convex(ring) ? 1 : 0);
    h.add(static_cast<int>(irg::locate_point(ring, {ring[0].x / 2, ring[0].y / 2})));
    h.add(irg::edge_through(ring[0], ring[1]).c);
  }
  return h.value();
}
HASHED(geometry_polygon_convexity, 20, 30000);

constexpr std::uint64_t raster_fills(int rounds) {
  test::random r(13);
  determinism::hasher h;
  const irg::cell_window w{-9, -9, 30, 30};
  const auto span = [&](irg::span_of_cells s) { h.add((s.y * 1000 + s.x_first) * 1000 + s.x_last); };
  for (int i = 0; i < rounds; ++i) {
    const std::int64_t size = i % 4 == 3 ? 3000000000 : 9000;  // in 1/256 pixel
    const auto place = [&] {
      const double whole = static_cast<double>(r.integer(-size, size)) / 256;
      return whole + r.unit() / 100;
    };
    irg::point<double, 2> ring[6];
    for (auto& p : ring) {
      p.x = place();
      p.y = place();
    }
    const irg::point<double, 2> triangle[3] = {ring[0], ring[1], ring[2]};
    const irg::subpixel quad[4] = {
        {static_cast<std::int32_t>(r.integer(-9000, 9000)), -2000}, {9000, 300}, {0, 9000}, {-8000, 0}};
    irg::convex_spans(triangle, w, span);
    irg::convex_spans(quad, w, span);
    irg::polygon_spans(ring, i % 2 ? irg::fill_rule::even_odd : irg::fill_rule::non_zero, w, span);
  }
  return h.value();
}
HASHED(raster_fills, 3, 3000);

// Constant evaluation walks in integers, run time in fixed point, many lines sorted by tile.
constexpr std::uint64_t raster_line_kernels(int rounds) {
  const int width = rounds < 100 ? 17 : 700, height = rounds < 100 ? 11 : 500;
  test::random r(17);
  determinism::hasher h;
  irg::image<unsigned> one_by_one(width, height), batch(width, height);
  std::vector<irg::painted_line<unsigned>> lines;
  for (int i = 0; i < rounds; ++i) {
    const auto end = [&](std::int64_t reach) {
      const int x = static_cast<int>(r.integer(-reach, width + reach));
      return irg::cell{x, static_cast<int>(r.integer(-reach, height + reach))};
    };
    const irg::cell a = end(i % 5 == 0 ? 2000000000 : 9);
    lines.push_back({a, end(i % 7 == 0 ? 40000 : 9), static_cast<unsigned>(i + 1)});
    const auto ties = i % 2 ? irg::line_ties::symmetric : irg::line_ties::start_side;
    irg::draw_line(one_by_one, lines.back().from, lines.back().to, lines.back().paint, {.ties = ties});
  }
  irg::draw_painted_lines(batch, lines, {.ends = irg::line_ends::half_open});
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      h.add(static_cast<int>(one_by_one(x, y)));
      h.add(static_cast<int>(batch(x, y)));
    }
  return h.value();
}
HASHED(raster_line_kernels, 9, 3000);

// Constant evaluation takes the plain kernels, run time the lanes.
constexpr std::uint64_t raster_lines_aa(int rounds) {
  test::random r(18);
  determinism::hasher h;
  const irg::cell_window window = rounds < 10 ? irg::cell_window{-5, -5, 6, 6} : irg::cell_window{-60, -60, 60, 60};
  for (int i = 0; i < rounds; ++i) {
    const std::int64_t reach = rounds < 10 ? 1200 : std::int64_t{256} << r.integer(0, 20);
    const auto end = [&] {
      const auto x = static_cast<std::int32_t>(r.integer(-reach, reach));
      return irg::subpixel{x, static_cast<std::int32_t>(r.integer(-reach, reach))};
    };
    const irg::subpixel a = end(), b = end();
    const int width = i % 2 ? irg::one_pixel : static_cast<int>(r.integer(1, 2000));
    const auto spans = [&](const irg::coverage_span& s) {
      for (int x = s.x_first; x < s.x_last; ++x)
        if (s.coverage[x - s.x_first] != 0) h.add((s.y * 256 + x) * 256 + s.coverage[x - s.x_first]);
    };
    irg::line_aa(a, b, window, spans, {width, i % 3 ? irg::line_aa_caps::butt : irg::line_aa_caps::square});
    irg::line_wu(a, b, window, [&](irg::cell c, std::uint8_t v) { h.add((c.y * 256 + c.x) * 256 + v); });
  }
  return h.value();
}
HASHED(raster_lines_aa, 4, 10000);

// Small polygons, large ones, clipped ones: constant evaluation takes the plain kernel, run time the lanes and the fused
// fill.
constexpr std::uint64_t raster_convex_areas(int rounds) {
  test::random r(19);
  determinism::hasher h;
  for (int i = 0; i < rounds; ++i) {
    const std::int64_t reach = rounds < 10 ? 1500 : std::int64_t{2000} << r.integer(0, 8);
    irg::subpixel t[3];
    for (irg::subpixel& v : t) {
      v.x = static_cast<std::int32_t>(r.integer(-300, reach));
      v.y = static_cast<std::int32_t>(r.integer(-300, reach));
    }
    const int size = rounds < 10 ? 5 : 70;
    irg::image<irg::rgba8> four(size, size, {10, 20, 30, 40});
    irg::image<float> one(size, size, 0.5f);
    irg::fill_convex_aa(four, t, {250, 100, 0, 255});
    irg::fill_convex_aa(one, t, 3.0f);
    add(h, four, one);
  }
  return h.value();
}
HASHED(raster_convex_areas, 4, 3000);

constexpr std::uint64_t raster_polygon_areas(int rounds) {
  test::random r(20);
  determinism::hasher h;
  for (int i = 0; i < rounds; ++i) {
    std::vector<irg::subpixel> ring;
    const std::int64_t reach = rounds < 10 ? 900 : 6000, n = rounds < 10 ? 4 : r.integer(3, 20);
    for (std::int64_t k = 0; k < n; ++k) {
      const auto x = static_cast<std::int32_t>(r.integer(-300, reach));
      ring.push_back({x, static_cast<std::int32_t>(r.integer(-300, reach))});
    }
    const int size = rounds < 10 ? 3 : 24;
    irg::image<irg::rgba8> four(size, size, {10, 20, 30, 40});
    irg::image<float> one(size, size, 0.5f);
    irg::fill_polygon_aa(four, ring, irg::fill_rule::even_odd, {250, 100, 0, 255});
    irg::fill_polygon_aa(one, ring, irg::fill_rule::non_zero, 3.0f);
    add(h, four, one);
  }
  return h.value();
}
HASHED(raster_polygon_areas, 2, 2000);

}  // namespace
