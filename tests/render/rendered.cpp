// SPDX-License-Identifier: MIT
// test::render: the one place where the tests compile the whole renderer for run time.
#include "support/rendered.hpp"

namespace test {
namespace {

template <class World>
irg::render_counts draw(irg::image_view<irg::rgba8> colour, irg::image<float>& depth, World& world,
                        const irg::render_options& options, const any_executor& executor,
                        const any_observer& observer) {
  return irg::render(world, {colour, depth}, options, executor, [&](irg::render_stage stage) {
    if (observer) observer(stage);
  });
}

template <class World>
rendered draw_canvas(World& world, int width, int height, const irg::render_options& options,
                     const any_executor& executor, const any_observer& observer) {
  rendered r{canvas(width, height), {}};
  r.stats = draw(r.picture.colour.view(), r.picture.depth, world, options, executor, observer);
  return r;
}

}  // namespace

rendered render(const irg::scene<double>& world, int width, int height, const irg::render_options& options,
                const any_executor& executor, const any_observer& observer) {
  return draw_canvas(world, width, height, options, executor, observer);
}
rendered render(const irg::scene<float>& world, int width, int height, const irg::render_options& options,
                const any_executor& executor, const any_observer& observer) {
  return draw_canvas(world, width, height, options, executor, observer);
}
rendered render(irg::prepared_scene<double>& world, int width, int height, const irg::render_options& options,
                const any_executor& executor, const any_observer& observer) {
  return draw_canvas(world, width, height, options, executor, observer);
}
irg::render_counts render_into(irg::image_view<irg::rgba8> colour, irg::image<float>& depth,
                               const irg::scene<double>& world, const irg::render_options& options) {
  return draw(colour, depth, world, options, any_executor{}, any_observer{});
}

}  // namespace test
