// SPDX-License-Identifier: MIT
// The doors of visibility, for float and double.
#include <irg/visibility/guard_cover.hpp>
#include <irg/visibility/prepared_walls.hpp>
#include <irg/visibility/visibility_polygon.hpp>
#include <irg/visibility/weak_visibility.hpp>

namespace irg {

#define IRG_FOR_NUMBERS(T)                                                                                       \
  template guard_cover<T> cover_by_guards(std::span<const std::vector<point<T, 2>>>);                            \
  template source_regions<T> weak_visibility<T>(std::span<const point<T, 2>>, std::span<const segment<T, 2>>,    \
                                                const box<T, 2>&);                                               \
  template source_regions<T> weak_visibility<T>(std::span<const std::vector<point<T, 2>>>,                       \
                                                std::span<const segment<T, 2>>, const box<T, 2>&);               \
  template checked<seen_share, visibility_status> sight_between<T>(                                              \
      std::span<const point<T, 2>>, std::span<const point<T, 2>>, std::span<const segment<T, 2>>);               \
  template visible_region<T> detail::region_within(const point<T, 2>&, std::span<const segment<T, 2>>,           \
                                                   std::span<const segment<T, 2>>, const sight_options&);        \
  template visible_region<T> detail::counted_region_within(const point<T, 2>&, std::span<const segment<T, 2>>,   \
                                                           std::span<const segment<T, 2>>, const sight_options&, \
                                                           sight_counts&);                                       \
  template detail::walls_in_tiles<T> detail::put_in_tiles(std::span<const segment<T, 2>>, const box<T, 2>&);     \
  template visible_region<T> detail::region_among(const detail::walls_in_tiles<T>&, const point<T, 2>&);         \
  template visible_region<T> detail::counted_region_among(const detail::walls_in_tiles<T>&, const point<T, 2>&,  \
                                                          sight_counts&);
IRG_FOR_NUMBERS(float)
IRG_FOR_NUMBERS(double)
#undef IRG_FOR_NUMBERS

}  // namespace irg
