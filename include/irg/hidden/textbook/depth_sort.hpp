// SPDX-License-Identifier: MIT
// Depth sort, the painter's algorithm of Newell, Newell and Sancha, as it is taught: a list of polygons, the farthest
// first, five tests by which the first of them, P, hides no other, Q; where all five fail Q is drawn before P, or, if
// that was tried already, one of the two is split. z points to the viewer. painter_newell makes no new points.
//
// The slides leave three things open that would end in a wrong picture or never. A polygon that was moved to the front
// leaves the list unsorted, so all others are asked, not only those up to the first whose depths are apart. The plane
// of P may leave Q whole: then P is split by that of Q, and where that does not cut, either, one of those that were
// moved by another's: of polygons that hide each other in turn some plane cuts another. And a part remembers what cut
// it.
#pragma once

#include <irg/core/function_ref.hpp>
#include <irg/hidden/textbook/depth_sort_parts.hpp>
#if IRG_BODIES
#include <irg/core/is_finite.hpp>
#endif

namespace irg::detail::inline IRG_COMPILED_ABI {

template <Floating T>
IRG_API std::vector<textbook::depth_sorted_polygon<T>> sorted_by_tests(
    const std::vector<std::vector<point<T, 3>>>& polygons,
    const function_ref<void(newell_step, std::uint32_t, std::uint32_t)>& observer);

}  // namespace irg::detail::inline IRG_COMPILED_ABI

namespace irg::textbook::inline IRG_ABI {

/// Polygons, and parts of those that had to be split, in an order in which the painter may draw them: none hides one
/// that is drawn after it.
/// shape   z towards the viewer; observer(step, number of P, number of Q)
/// needs   convex flat polygons
/// gives   each polygon once, or its parts; those with a number that is not finite are left out
/// exact   as the tests are, of parts for their rounded points; where polygons lie within roundings of each other the
///         order may be wrong there
/// cost    n^2 tests where all overlap in depth, a sort where none do; those that hide each other make parts. Allocates
/// source  Hidden-surface slides, after Newell, Newell and Sancha 1972
template <Floating T, class Observer = no_newell_observer>
[[nodiscard]] constexpr std::vector<depth_sorted_polygon<T>> depth_sort(
    const std::vector<std::vector<point<T, 3>>>& polygons, Observer&& observer = {}) {
  return detail::sorted_by_tests<T>(polygons, as_function<void(newell_step, std::uint32_t, std::uint32_t)>(observer));
}

}  // namespace irg::textbook::inline IRG_ABI

#if IRG_BODIES
namespace irg::detail::inline IRG_ABI {

// The last of the list, P, may hide part q, which was moved: q is split by the plane of P, or P by that of q, or any of
// those that were moved by another's. Where no plane cuts, only rounded points say that one of them hides the next: of
// what might, the least is let pass.
template <Floating T, class Observer>
constexpr void break_cycle(textbook::depth_sort_list<T>& list, std::size_t q, Observer& observer) {
  auto& parts = list.parts;
  const std::size_t last = parts.size() - 1;
  std::vector<std::size_t> in_turn;
  for (std::size_t k = 0; k <= last; ++k)
    if (k == last || parts[k].moved) in_turn.push_back(k);
  const auto split = [&](std::size_t cut, std::size_t by) {
    const std::uint32_t p_number = parts[by].polygon.number, q_number = parts[cut].polygon.number;
    if (!split_part(list, cut, by)) return false;
    observer(newell_step::split_by_plane, p_number, q_number);
    return true;
  };
  bool done = split(q, last) || split(last, q);
  for (const std::size_t cut : in_turn)
    for (const std::size_t by : in_turn) done = done || split(cut, by);
  const auto shared = [&](std::size_t k, std::size_t j) {
    return textbook::area_in_common(parts[k].polygon.corners, parts[j].polygon.corners);
  };
  if (!done) {
    std::pair least{last, q};
    for (const std::size_t k : in_turn)
      for (const std::size_t j : in_turn)
        if (!does_not_hide(parts[k], parts[j]) && shared(k, j) < shared(least.first, least.second)) least = {k, j};
    parts[least.first].let_pass.push_back(parts[least.second].made);
  }
  for (textbook::depth_sort_part<T>& p : parts) p.moved = false;
}

}  // namespace irg::detail::inline IRG_ABI

namespace irg::detail::inline IRG_COMPILED_ABI {

template <Floating T>
IRG_API std::vector<textbook::depth_sorted_polygon<T>> sorted_by_tests(
    const std::vector<std::vector<point<T, 3>>>& polygons,
    const function_ref<void(newell_step, std::uint32_t, std::uint32_t)>& observer) {
  textbook::depth_sort_list<T> list;
  auto& parts = list.parts;
  for (const auto& p : polygons) {
    const std::uint32_t number = list.made++;
    if (!p.empty() && is_finite(p))
      parts.push_back(textbook::make_part(p, number, textbook::visible_plane_of(p), number));
  }
  std::sort(parts.begin(), parts.end(), [](const auto& a, const auto& b) {
    return a.farthest != b.farthest ? a.farthest > b.farthest : a.polygon.number > b.polygon.number;
  });
  std::vector<textbook::depth_sorted_polygon<T>> order;
  while (!parts.empty()) {
    textbook::depth_sort_part<T>& p = parts.back();
    std::size_t q = parts.size() - 1;  // of those before P, the last that P may hide, or P itself
    while (q > 0 && does_not_hide(p, parts[q - 1])) --q;
    if (q == 0) {
      observer(newell_step::drawn, p.polygon.number, p.polygon.number);
      order.push_back(std::move(p.polygon));
      parts.pop_back();
    } else if (parts[--q].moved) {
      break_cycle(list, q, observer);
    } else {
      observer(newell_step::moved, p.polygon.number, parts[q].polygon.number);
      parts[q].moved = true;
      std::rotate(parts.begin() + static_cast<std::ptrdiff_t>(q), parts.begin() + static_cast<std::ptrdiff_t>(q) + 1,
                  parts.end());
    }
  }
  return order;
}

}  // namespace irg::detail::inline IRG_COMPILED_ABI
#endif
