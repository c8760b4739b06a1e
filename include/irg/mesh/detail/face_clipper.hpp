// SPDX-License-Identifier: MIT
// The triangles of one face of a mesh, by corner numbers: of the face without the coordinate along which it looks
// largest. See triangulate.hpp for the contract.
#pragma once

#include <cstddef>
#include <cstdint>

#include <irg/geometry/flat_ring.hpp>
#include <irg/geometry/triangulate_ear_clipping.hpp>
#include <irg/mesh/mesh.hpp>

namespace irg::detail {
inline namespace IRG_ABI {

/// The positions of a face's corners, as a ring.
template <Scalar T>
struct face_ring {
  const mesh<T>* m;
  std::size_t face;
  constexpr std::size_t size() const noexcept { return m->face_size(face); }
  constexpr point<T, 3> operator[](std::size_t i) const noexcept { return m->positions[m->corner(face, i).position]; }
};

/// Works on one face after another. `sink(i, j, k)` takes each triangle, as numbers of corners in the face's own
/// direction.
template <Scalar T>
class face_clipper {
public:
  constexpr explicit face_clipper(std::size_t tests_per_corner) : options_{tests_per_corner} {}

  template <class Emit>
  constexpr void operator()(const mesh<T>& m, std::size_t face, const Emit& sink) {
    const face_ring<T> ring{&m, face};
    const auto n = static_cast<std::uint32_t>(ring.size());
    if (n == 3) return sink(0u, 1u, 2u);
    // A face whose area along the first axis is lost in rounding is looked at along the others.
    if (clip(ring, flattening_axis(ring), sink) || clip(ring, 0, sink) || clip(ring, 1, sink) || clip(ring, 2, sink))
      return;
    for (std::uint32_t i = 2; i < n; ++i) sink(0u, i - 1, i);
  }

private:
  ear_clipping_options options_;
  ear_clipping_memory<T> memory_;

  template <class Emit>
  constexpr bool clip(const face_ring<T>& ring, int axis, const Emit& sink) {
    // A position that is NaN or infinite leaves nothing to decide: such faces are cut into a fan.
    const flat_ring<face_ring<T>> flat(ring, axis);
    return is_finite(flat) && triangulate_ear_clipping(flat, sink, memory_, options_);
  }
};

}  // namespace IRG_ABI
}  // namespace irg::detail
