// SPDX-License-Identifier: MIT
// What irg::compiled has of render, for float and double, into views.
#include <irg/raster/projected_vertices.hpp>
#include <irg/render/draw_transparent.hpp>
#include <irg/render/occlusion_culling.hpp>
#include <irg/render/occlusion_mask.hpp>
#include <irg/render/pick.hpp>
#include <irg/render/render.hpp>
#include <irg/render/render_rooms.hpp>
#include <irg/render/shade_visible.hpp>
#include <irg/render/visibility_buffer.hpp>

namespace irg {

#define IRG_FOR_NUMBERS(T)                                                                                       \
  template drawable<T> make_drawable(mesh<T>);                                                                   \
  template object_extent<T> extent_of(const object<T>&) noexcept;                                                \
  template prepared_object<T> prepare_object(const object<T>&);                                                  \
  template prepared_scene<T> prepare_scene(const scene<T>&);                                                     \
  template std::vector<cell_window> visible_rooms(const cell_plan<T>&, const portal_graph<T>&, const camera<T>&, \
                                                  const extent2&);                                               \
  template std::optional<picked_point<T>> pick(prepared_scene<T>&, const extent2&, cell, face_culling);          \
  template std::optional<picked_point<T>> pick(const scene<T>&, const extent2&, cell, face_culling);
IRG_FOR_NUMBERS(float)
IRG_FOR_NUMBERS(double)
#undef IRG_FOR_NUMBERS

namespace detail {

using views = picture_run<image_view<rgba8>, image_view<float>>;
using numbers = std::vector<std::uint32_t>;

#define IRG_FOR_NUMBERS(T)                                                                                        \
  template void project_positions(std::span<const point<T, 3>>, const mat<T, 4, 4>&, const screen_mapping<T>&,    \
                                  projected_vertices<T>&, const executor_ref&);                                   \
  template std::vector<line_on_screen> lines_of_faces(const projected_mesh<T>&, face_culling, const cell_window&, \
                                                      render_counts&);                                            \
  template bool has_valid_faces(const scene<T>&) noexcept;                                                        \
  template render_counts render_scene(const scene<T>&, const render_options&, const views&);                      \
  template render_counts render_by(const window_method<T>&, const scene<T>&, render_options, const views&);       \
  template render_counts render_prepared(prepared_scene<T>&, const render_options&, const views&);                \
  template render_counts render_building(prepared_rooms<T>&, const render_options&, const views&);                \
  template numbers choose_occluders(const occlusion_view<T>&, std::span<const object_extent<T>>);                 \
  template void add_occluder(occlusion_view<T>&, std::span<const point<T, 3>>, std::span<const triangle_indices>, \
                             face_culling);                                                                       \
  template bool hides_box(const occlusion_view<T>&, const box<T, 3>&) noexcept;                                   \
  template numbers visible_objects(occlusion_view<T>&, std::span<const occludable_object<T>>, face_culling);
IRG_FOR_NUMBERS(float)
IRG_FOR_NUMBERS(double)
#undef IRG_FOR_NUMBERS

#define IRG_FOR_ORDERS(T, Order)                                                                             \
  template render_counts draw_zbuffer<Order, test_of<Order>, T>(image_view<float>&, const tile_job<T>&,      \
                                                                const tile_finish<T>&, const executor_ref&); \
  template render_counts draw_by_ids<Order>(const method_ref<T>&, image<std::uint32_t>&, image_view<float>&, \
                                            const tile_job<T>&, const tile_finish<T>&, const executor_ref&); \
  template numbers bin_back_to_front<Order>(triangle_bins&, std::span<const triangle_batch<T>>,              \
                                            const listing_rules<T>&, const executor_ref&);                   \
  template std::optional<pixel_weights<float>> weights_in_batch<Order>(                                      \
      const triangle_batch<T>&, const screen_mapping<T>&, std::uint32_t, const cell&);
#define IRG_FOR_DEPTHS(T, Order)                                                                                       \
  IRG_FOR_ORDERS(T, Order)                                                                                             \
  template render_counts draw_zbuffer<Order, tile_test::depth_only, T>(image_view<float>&, const tile_job<T>&,         \
                                                                       const tile_finish<T>&, const executor_ref&);    \
  template void draw_occluders<Order>(occluder_depths&, std::span<const triangle_batch<T>>, const screen_mapping<T>&,  \
                                      face_culling, const executor_ref&);                                              \
  template occlusion test_box<Order>(const occluder_depths&, const box<T, 3>&, const mat<T, 4, 4>&,                    \
                                     occlusion_counts&) noexcept;                                                      \
  template occlusion test_triangles<Order>(const occluder_depths&, const triangle_batch<T>&, const screen_mapping<T>&, \
                                           face_culling, occlusion_counts&);
IRG_FOR_DEPTHS(float, nearer_is_greater)
IRG_FOR_DEPTHS(float, nearer_is_less)
IRG_FOR_ORDERS(float, drawing_order)
IRG_FOR_DEPTHS(double, nearer_is_greater)
IRG_FOR_DEPTHS(double, nearer_is_less)
IRG_FOR_ORDERS(double, drawing_order)
#undef IRG_FOR_DEPTHS
#undef IRG_FOR_ORDERS

template occlusion test_rectangle<nearer_is_greater>(const occluder_depths&, const cell_window&, float,
                                                     occlusion_counts&) noexcept;
template occlusion test_rectangle<nearer_is_less>(const occluder_depths&, const cell_window&, float,
                                                  occlusion_counts&) noexcept;

}  // namespace detail
}  // namespace irg
