// SPDX-License-Identifier: MIT
// Rasters: what may not be written, and what is none. CASE 0 is the control and compiles.
#include <irg/colour/pixel.hpp>
#include <irg/raster/fill_span.hpp>
#include <irg/raster/image.hpp>

struct flat {  // no height
  int width() const { return 4; }
  int operator()(int, int) const { return 0; }
#if CASE != 3
  int height() const { return 4; }
#endif
};

void use() {
  irg::image<int> pixels(4, 4);
  [[maybe_unused]] const irg::image<int>& fixed = pixels;
#if CASE == 0
  irg::image_view<int> view = pixels.view();
  irg::set_pixel(view, 0, 0, 1);
  view(1, 1) = 2;
  irg::fill_span(view, {0, 0, 4}, 3);
  (void)irg::width_of(flat{});
  (void)irg::get_pixel(fixed.view(), 0, 0);
#elif CASE == 1  // set through a view of const pixels
  // expect: no matching function for call to .*set_pixel
  irg::image_view<const int> view = fixed.view();
  irg::set_pixel(view, 0, 0, 1);
#elif CASE == 2  // assign through a view of const pixels
  // expect: (assignment of read-only location|const-qualified)
  irg::image_view<const int> view = fixed.view();
  view(1, 1) = 2;
#elif CASE == 3  // no height
  // expect: (constraint failure|constraints not satisfied)
  (void)irg::width_of(flat{});
#elif CASE == 4  // fill a const image
  // expect: no matching function for call to .*fill_span
  irg::fill_span(fixed, {0, 0, 4}, 3);
#elif CASE == 5  // write to a raster that is computed
  // expect: no matching function for call to .*set_pixel
  flat computed;
  irg::set_pixel(computed, 0, 0, 1);
#elif CASE == 6  // a pixel of another type
  // expect: (no matching function|invalid initialization)
  irg::fill_span(pixels, {0, 0, 4}, irg::rgba8{});
#elif CASE == 7  // constness cast away by a view
  // expect: (no matching function|could not convert|cannot convert|no viable conversion|conversion from)
  irg::image_view<int> view = fixed.view();
#endif
}
