// SPDX-License-Identifier: MIT
// The classical hidden-surface methods by name, for render_with(method, scene, ...). They stand apart from render.hpp,
// so that only programs that want them compile them.
#pragma once

#include <irg/hidden/bsp_faces.hpp>
#include <irg/hidden/painter.hpp>
#include <irg/hidden/painter_newell.hpp>
#include <irg/hidden/ray_casting.hpp>
#include <irg/hidden/warnock.hpp>

namespace irg {

/// The methods of textbooks. All but the last draw the same picture, which is render's.
enum class classical_method { ray_casting, warnock, painter_newell, bsp, painter_by_centroid };

/// A hidden-surface method that is chosen when the program runs.
/// shape   render_with(hidden_surfaces_by{classical_method::warnock}, scene, {colour, depth})
/// exact   as the method that is named
struct hidden_surfaces_by {
  classical_method method = classical_method::ray_casting;

  /// Whether the picture is the exact one.
  [[nodiscard]] IRG_APART constexpr bool finds_nearest() const noexcept {
    return method != classical_method::painter_by_centroid;
  }

  template <class Faces>
  IRG_APART constexpr void operator()(const Faces& faces, const cell_window& window, image<std::uint32_t>& ids,
                                      draw_counts& counts) const {
    switch (method) {
      case classical_method::warnock: return warnock<>{}(faces, window, ids, counts);
      case classical_method::painter_newell: return painter_newell<>{}(faces, window, ids, counts);
      case classical_method::bsp: return bsp_painter<>{}(faces, window, ids, counts);
      case classical_method::painter_by_centroid: return painter_by_centroid_rounded<>{}(faces, window, ids, counts);
      default: return ray_casting<>{}(faces, window, ids, counts);
    }
  }
  bool operator==(const hidden_surfaces_by&) const = default;
};

}  // namespace irg
