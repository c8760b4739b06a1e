// SPDX-License-Identifier: MIT
#include <irg/render/options.hpp>

#include <type_traits>

#include "support/check_both.hpp"

namespace {

TEST_CASE("render_options: a hidden-surface Gouraud picture, culled and skipping, unless told otherwise") {
  static_assert(std::is_aggregate_v<irg::render_options>);
  CHECK_BOTH(irg::render_options{}.style == irg::picture_style::gouraud);
  CHECK_BOTH(irg::render_options{}.hidden == irg::hidden_surface_method::zbuffer);
  CHECK_BOTH(irg::render_options{}.culling == irg::face_culling::back);
  CHECK_BOTH(irg::render_options{}.skip == irg::skip_options{});
}

}  // namespace
