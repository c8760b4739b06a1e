// SPDX-License-Identifier: MIT
// The Mandelbrot set about one point at widths from 1 to 1e-60: time against error of each way to compute it. Wrong are
// counts that are not those of MPFR with 500 bits, of 1024 pixels; their share is the error.
#include <cmath>
#include <memory>
#include <string>

#include <irg/fractal/deep_mandelbrot.hpp>
#include <irg/fractal/escape_picture.hpp>
#include <irg/fractal/precise_mandelbrot.hpp>
#include <irg/raster/image.hpp>

#include "support/measure.hpp"

#ifdef IRG_HAVE_MPFR
#include <mpfr.h>
#endif

namespace {

using namespace bench;

constexpr int side = 32, most = 3000;
constexpr const char* re_text = "-0.796018035679333599770602762027128618680016120069383332358641";
constexpr const char* im_text = "0.152921489508950739029284976898362805189168098776991868427910";
using counts = irg::image<int>;

// The centre, in 106 bits where pictures are so wide that they do, in all its digits elsewhere.
struct place {
  irg::fixed_point<6> x, y;
  irg::double_double re, im;
  bool is_rounded;
};
place centre_for(double width) {
  place p{*irg::parse_fixed_point<6>(re_text), *irg::parse_fixed_point<6>(im_text), {}, {}, width > 1e-26};
  const auto words = [](const irg::fixed_point<6>& v) {
    const auto high = static_cast<double>(v);
    return irg::double_double(high) + static_cast<double>(v - irg::fixed_point<6>(high));
  };
  const auto exactly = [](const irg::double_double& v) {
    return irg::fixed_point<6>(v.high) + irg::fixed_point<6>(v.low);
  };
  p.re = words(p.x), p.im = words(p.y);
  if (p.is_rounded) p.x = exactly(p.re), p.y = exactly(p.im);
  return p;
}

double offset(int k, double pixel) { return (k - (side - 1) * 0.5) * pixel; }

#ifdef IRG_HAVE_MPFR
counts true_counts(const place& centre, double pixel, double square) {
  counts out(side, side);
  mpfr_t centre_x, centre_y, cx, cy, x, y, xx, yy, size;
  mpfr_ptr all[] = {centre_x, centre_y, cx, cy, x, y, xx, yy, size};
  for (mpfr_ptr v : all) mpfr_init2(v, 500);
  mpfr_set_str(centre_x, re_text, 10, MPFR_RNDN);
  mpfr_set_str(centre_y, im_text, 10, MPFR_RNDN);
  if (centre.is_rounded) {
    mpfr_set_d(centre_x, centre.re.high, MPFR_RNDN);
    mpfr_add_d(centre_x, centre_x, centre.re.low, MPFR_RNDN);
    mpfr_set_d(centre_y, centre.im.high, MPFR_RNDN);
    mpfr_add_d(centre_y, centre_y, centre.im.low, MPFR_RNDN);
  }
  for (int j = 0; j < side; ++j)
    for (int i = 0; i < side; ++i) {
      mpfr_add_d(cx, centre_x, offset(i, pixel), MPFR_RNDN);
      mpfr_sub_d(cy, centre_y, offset(j, pixel), MPFR_RNDN);
      for (mpfr_ptr v : {x, y, xx, yy}) mpfr_set_zero(v, 1);
      int k = 0;
      for (; k < most; ++k) {
        mpfr_mul(y, x, y, MPFR_RNDN);
        mpfr_mul_2ui(y, y, 1, MPFR_RNDN);
        mpfr_add(y, y, cy, MPFR_RNDN);
        mpfr_sub(x, xx, yy, MPFR_RNDN);
        mpfr_add(x, x, cx, MPFR_RNDN);
        mpfr_sqr(xx, x, MPFR_RNDN);
        mpfr_sqr(yy, y, MPFR_RNDN);
        mpfr_add(size, xx, yy, MPFR_RNDN);
        if (mpfr_cmp_d(size, square) >= 0) break;
      }
      out(i, j) = k;
    }
  for (mpfr_ptr v : all) mpfr_clear(v);
  return out;
}
#endif

void enter_width(double width) {
  const double pixel = width / side;
  const auto limit = irg::make_escape_limit(2.0, most);
  const place centre = centre_for(width);
  const irg::deep_escape_job<6> deep{centre.x, centre.y, pixel, limit};
  char name[32];
  std::snprintf(name, sizeof name, "width %.0e", width);
  auto& drawn = keep(counts(side, side));
#ifdef IRG_HAVE_MPFR
  auto& truth = keep_lazy([=] { return std::make_unique<counts>(true_counts(centre, pixel, limit.square)); });
#endif
  const contest what{"deep", name, "pixel", side * side, "share of wrong counts", ""};
  const auto add = [&](const std::string& who, auto draw, bool promises) {
    contender c{who, [draw] { draw(); }};
    static_cast<void>(promises);
#ifdef IRG_HAVE_MPFR
    c.judge = [&drawn, &truth, promises] {
      errors e;
      e.wrong = 0;
      for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) e.wrong += drawn(x, y) != (**truth)(x, y);
      e.mean = e.max = e.wrong / (side * side);
      if (promises && e.wrong != 0) e.broken = "a count is not MPFR's";
      return e;
    };
#endif
    enter(what, std::move(c));
  };
  add(
      "irg:double_doubles about an orbit",
      [&drawn, deep] { irg::draw_deep_mandelbrot<irg::double_double>(drawn, deep); }, true);
  add("irg:doubles about an orbit", [&drawn, deep] { irg::draw_deep_mandelbrot(drawn, deep); }, false);
  if (centre.is_rounded) {
    const irg::precise_escape_job precise{centre.re, centre.im, pixel, limit};
    add("irg:sure counts", [&drawn, precise] { draw_mandelbrot(drawn, precise); }, true);
  }
  const double x = centre.re.high, y = centre.im.high;
  const double reach = pixel * (side - 1) / 2;
  const irg::escape_job<double> plain{{{x - reach, x + reach, y - reach, y + reach}, side, side}, limit, {}};
  add("irg:doubles", [&drawn, plain] { irg::draw_mandelbrot(drawn, plain); }, false);
}

}  // namespace

int main(int argc, char** argv) {
  for (const double width : {1.0, 1e-4, 1e-9, 1e-12, 1e-14, 1e-20, 1e-24, 1e-40, 1e-50})
    if (!smoke() || width == 1e-24) enter_width(width);
  return run_benchmarks(argc, argv);
}
