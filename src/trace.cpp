// SPDX-License-Identifier: MIT
// What irg::compiled has of trace, for float and double, and of what draws with them.
#include <irg/render/render_traced.hpp>
#include <irg/trace/along_ray.hpp>
#include <irg/trace/path_tracer.hpp>
#include <irg/trace/ray_tracing.hpp>
#include <irg/trace/soft_light.hpp>
#include <irg/trace/trace_ray.hpp>

namespace irg {

#define IRG_FOR_RAYS(T, U)                                                                        \
  template std::vector<triangle_hit> sorted_hits(const triangle_bvh<T>&, const ray<U, 3>&);       \
  template std::int64_t visible_steps(const triangle_bvh<T>&, const ray<U, 3>&, double) noexcept; \
  template free_run longest_free_run(const triangle_bvh<T>&, const ray<U, 3>&, double);
#define IRG_FOR_NUMBERS(T)                                                                                      \
  template rgb<T> light_through(const ray_world<T>&, const point<T, 3>&, const vec<T, 3>&, T) noexcept;         \
  template rgb<T> light_of_surface(const ray_world<T>&, const surface_point<T>&, const point<T, 3>&,            \
                                   shadow_rays) noexcept;                                                       \
  template rgb<T> trace_from(const ray_world<T>&, const surface_point<T>&, const point<T, 3>&,                  \
                             const trace_options<T>&) noexcept;                                                 \
  template rgb<T> trace_ray(const ray_world<T>&, const ray<T, 3>&, const trace_options<T>&) noexcept;           \
  template T lit_share_of_rod(const ray_world<T>&, const point<T, 3>&, const point<T, 3>&, const point<T, 3>&); \
  template rgb<T> soft_light_of_surface(const ray_world<T>&, const surface_point<T>&, const point<T, 3>&,       \
                                        std::span<const area_light<T>>, int);                                   \
  template detail::path_emitters<T> detail::find_emitters(const ray_world<T>&);                                 \
  template rgb<T> detail::mean_of_paths(const ray_world<T>&, const path_emitters<T>&, const ray<T, 3>&,         \
                                        const path_options&, std::uint64_t) noexcept;                           \
  template render_counts detail::trace_picture(const scene<T>&, image_view<rgba8>&, const traced_options<T>&,   \
                                               const executor_ref&);                                            \
  IRG_FOR_RAYS(T, float)                                                                                        \
  IRG_FOR_RAYS(T, double)
IRG_FOR_NUMBERS(float)
IRG_FOR_NUMBERS(double)
#undef IRG_FOR_NUMBERS
#undef IRG_FOR_RAYS

#define IRG_FOR_ORDER(Order)                                                                                           \
  template void detail::trace_faces<Order>(const std::vector<screen_face>&, const cell_window&, image<std::uint32_t>&, \
                                           draw_counts&);
IRG_FOR_ORDER(nearer_is_greater)
IRG_FOR_ORDER(nearer_is_less)
IRG_FOR_ORDER(drawing_order)
#undef IRG_FOR_ORDER

}  // namespace irg
