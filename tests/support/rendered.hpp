// SPDX-License-Identifier: MIT
// Pictures of scenes. The renderer is compiled once for all tests, in tests/render/rendered.cpp.
#pragma once

#include <cstddef>
#include <functional>
#include <utility>

#include <irg/raster/image.hpp>
#include <irg/render/render.hpp>
#include <irg/scene/scene.hpp>

namespace test {

/// A picture and its depth buffer, filled with what no renderer leaves behind.
struct canvas {
  irg::image<irg::rgba8> colour;
  irg::image<float> depth;
  constexpr canvas(int width, int height) : colour(width, height, irg::rgba8{1, 2, 3, 4}), depth(width, height, 0.5f) {}
  constexpr bool operator==(const canvas&) const = default;
};

/// What is in a canvas after rendering, with the numbers that belong to it.
struct rendered {
  canvas picture;
  irg::render_counts stats;
};

/// Runs the tasks from the last to the first: an executor of a user's own.
struct backwards {
  template <class Task>
  constexpr void operator()(std::size_t count, Task&& task) const {
    while (count > 0) task(--count);
  }
};

/// Any executor, under one type.
class any_executor {
public:
  any_executor() : any_executor(irg::sequential{}) {}
  template <class E>
    requires(!std::same_as<E, any_executor>)
  any_executor(E executor) : run_([executor](std::size_t count, const task& t) { executor(count, t); }) {}

  template <class Task>
  void operator()(std::size_t count, Task&& t) const {
    run_(count, [&t](std::size_t i) { t(i); });
  }

private:
  using task = std::function<void(std::size_t)>;
  std::function<void(std::size_t, const task&)> run_;
};

/// Hears of the stages, if it is anything.
using any_observer = std::function<void(irg::render_stage)>;

/// irg::render, compiled elsewhere.
rendered render(const irg::scene<double>& world, int width, int height, const irg::render_options& options = {},
                const any_executor& executor = {}, const any_observer& observer = {});
rendered render(const irg::scene<float>& world, int width, int height, const irg::render_options& options = {},
                const any_executor& executor = {}, const any_observer& observer = {});
rendered render(irg::prepared_scene<double>& world, int width, int height, const irg::render_options& options = {},
                const any_executor& executor = {}, const any_observer& observer = {});
irg::render_counts render_into(irg::image_view<irg::rgba8> colour, irg::image<float>& depth,
                               const irg::scene<double>& world, const irg::render_options& options = {});

/// For constant expressions.
template <class T>
constexpr rendered render_constant(const irg::scene<T>& world, int width, int height,
                                   const irg::render_options& options = {}) {
  rendered r{canvas(width, height), {}};
  r.stats = irg::render(world, {r.picture.colour, r.picture.depth}, options);
  return r;
}

}  // namespace test
