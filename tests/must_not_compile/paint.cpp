// SPDX-License-Identifier: MIT
// Paints of the wrong kind. CASE 0 is the control and compiles.
#include <irg/raster/draw_line.hpp>
#include <irg/raster/image.hpp>

void use(irg::image<int>& ids, irg::image<irg::rgba8>& picture) {
#if CASE == 0
  irg::draw_line(ids, {0, 0}, {3, 2}, 7);
  irg::draw_line(ids, {0, 0}, {3, 2}, [](int there) { return there + 1; });
  irg::draw_line(picture, {0, 0}, {3, 2}, {255, 0, 0, 255});
  irg::paint_pixel(picture, 0, 0, {255, 0, 0, 255}, 128);
#elif CASE == 1  // a colour into a raster of numbers
  // expect: no matching function for call to .*draw_line
  irg::draw_line(ids, {0, 0}, {3, 2}, irg::rgba8{255, 0, 0, 255});
#elif CASE == 2  // a function that returns no pixel
  // expect: no matching function for call to .*draw_line
  irg::draw_line(picture, {0, 0}, {3, 2}, [](irg::rgba8) { return 1; });
#elif CASE == 3  // identities cannot be mixed
  // expect: no matching function for call to .*paint_pixel
  irg::paint_pixel(ids, 0, 0, 7, 128);
#elif CASE == 4  // a blend of whole pixels where coverage counts
  // expect: no matching function for call to .*paint_pixel
  irg::paint_pixel(ids, 0, 0, [](int there) { return there + 1; }, 128);
#endif
}
