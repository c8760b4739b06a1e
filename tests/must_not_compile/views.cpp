// SPDX-License-Identifier: MIT
// Views of foreign images: what is refused before run time. CASE 0 is the control and compiles.
#include <irg/raster/view_opencv.hpp>
#include <irg/raster/view_sdl.hpp>

struct matrix {
  int rows, cols, dims;
  unsigned char* data;
  std::size_t step;
  int depth() const { return 0; }
  int channels() const { return 4; }
};
[[maybe_unused]] matrix make_matrix() { return {}; }

void use() {
  matrix m{};
  [[maybe_unused]] const matrix& fixed = m;
#if CASE == 0
  irg::foreign_view<irg::rgba8> view = irg::view_opencv<irg::rgba8>(m);
  irg::foreign_view<const irg::rgba8> reading = irg::view_opencv<irg::rgba8>(fixed);
#elif CASE == 1  // OpenCV has no unsigned 32-bit numbers
  // expect: no matching function for call to .*view_opencv
  (void)irg::view_opencv<std::uint32_t>(m);
#elif CASE == 2  // a view that would outlive its pixels
  // expect: (no matching function for call to .*view_opencv|cannot bind)
  (void)irg::view_opencv<irg::rgba8>(make_matrix());
#elif CASE == 3  // writing to a const matrix
  // expect: (no viable conversion|could not convert|conversion from)
  irg::foreign_view<irg::rgba8> view = irg::view_opencv<irg::rgba8>(fixed);
#elif CASE == 4  // a matrix is no surface
  // expect: no matching function for call to .*view_sdl
  (void)irg::view_sdl<irg::rgba8>(&m);
#elif CASE == 5  // SDL has no surfaces of floats
  // expect: no matching function for call to .*view_sdl
  (void)irg::view_sdl<float>(&m);
#endif
}
