// SPDX-License-Identifier: MIT
// Pictures of a scene through its BSP tree in space: the tree is built once, and serves every camera.
#pragma once

#include <cstdint>
#include <vector>

#include <irg/hidden/bsp_scene.hpp>
#include <irg/render/render.hpp>

namespace irg::inline IRG_ABI {

/// The tree of all triangles of a scene, in the world, numbered as pictures of the whole scene number them.
/// needs   a scene as render needs it
/// cost    as bsp_tree_3d
template <Floating T>
[[nodiscard]] constexpr bsp_tree_3d<T> make_scene_bsp(const scene<T>& world, const bsp_options& choice = {}) {
  std::vector<point<T, 3>> vertices;
  std::vector<triangle_indices> triangles;
  for (const object<T>& o : world.objects) {
    const drawable<T> body = prepare_object(o).body;
    const auto base = static_cast<std::uint32_t>(vertices.size());
    vertices.insert(vertices.end(), body.positions.begin(), body.positions.end());
    for (const auto& [v] : body.triangles) triangles.push_back({{v[0] + base, v[1] + base, v[2] + base}});
  }
  return bsp_tree_3d<T>(vertices, triangles, choice);
}

/// Renders a scene, what is seen decided by its tree.
/// needs   the tree that make_scene_bsp made of the same objects; light, camera and surfaces may have changed
/// gives   the picture of `render`, but for the pixels that bsp_scene_painter names. No object is skipped whole
template <Floating T, RowRaster Colour = image_view<rgba8>, RowRaster Depth = image_view<float>,
          Executor E = sequential>
  requires std::same_as<pixel_of<Colour>, rgba8> && std::same_as<pixel_of<Depth>, float>
constexpr render_counts render_with(const bsp_tree_3d<T>& tree, const scene<T>& world,
                                    render_target<Colour, Depth> target, render_options options = {},
                                    const E& executor = {}) {
  const int width = width_of(target.colour), height = height_of(target.colour);
  if (width == 0 || height == 0) return {};
  options.skip.frustum = skipping::off;  // objects that are left out are not counted
  const mat<T, 4, 4> to_clip = view_projection(world.view, static_cast<T>(width) / static_cast<T>(height));
  const bsp_scene_painter<T> method(tree, viewpoint(world.view), to_clip, map_to_screen<T>({width, height}));
  return render_with(method, world, target, options, executor);
}
template <Floating T, RowRaster Colour = image_view<rgba8>, RowRaster Depth = image_view<float>,
          Executor E = sequential>
  requires std::same_as<pixel_of<Colour>, rgba8> && std::same_as<pixel_of<Depth>, float>
[[deprecated("irg: render_with(tree, world, target, ..)")]] constexpr render_counts render(
    const bsp_tree_3d<T>& tree, const scene<T>& world, render_target<Colour, Depth> target,
    const render_options& options = {}, const E& executor = {}) {
  return render_with(tree, world, target, options, executor);
}

}  // namespace irg::inline IRG_ABI
