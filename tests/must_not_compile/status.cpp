// SPDX-License-Identifier: MIT
// What a function found out may not be dropped: with -Werror=unused-result these do not compile. CASE 0 is the control.
#include <irg/io/image_file.hpp>
#include <irg/math/length.hpp>
#include <irg/mesh/fit.hpp>
#include <irg/raster/image.hpp>

void use(irg::mesh<double>& m, const irg::image<irg::rgba8>& picture) {
#if CASE == 0
  if (irg::fit_mesh(m) != irg::fit_status::ok) return;
  if (!irg::save_image("picture.png", picture)) return;
  static_cast<void>(irg::length(irg::vec<double, 3>{1, 2, 3}));
#elif CASE == 1  // a status
  // expect: (nodiscard|ignoring return)
  irg::fit_mesh(m);
#elif CASE == 2  // an error
  // expect: (nodiscard|ignoring return)
  irg::save_image("picture.jpg", picture);
#elif CASE == 3  // the only thing that a function does
  // expect: (nodiscard|ignoring return)
  irg::length(irg::vec<double, 3>{1, 2, 3});
#endif
}
