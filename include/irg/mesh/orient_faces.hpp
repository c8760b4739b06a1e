// SPDX-License-Identifier: MIT
// Faces that were listed in any direction come to run alike, and closed shells to look outward.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <irg/mesh/edge_ends.hpp>
#include <irg/mesh/mesh.hpp>

namespace irg {

/// What orient_faces made of a mesh.
enum class [[nodiscard]] orient_status {
  ok,
  one_sided,  ///< a piece of the surface has one side only, as a Moebius strip: its faces are as they were
  done [[deprecated("irg: done is now ok")]] = ok
};

inline namespace IRG_ABI {

/// Turns a face round: its corners run the other way, from the same first one.
/// needs   f < m.face_count()
template <Scalar T>
constexpr void turn_face(mesh<T>& m, std::size_t f) {
  const auto first = m.corners.begin() + static_cast<std::ptrdiff_t>(m.face_starts[f]);
  std::reverse(first + 1, first + static_cast<std::ptrdiff_t>(m.face_size(f)));
}

}  // namespace IRG_ABI

namespace detail::inline IRG_COMPILED_ABI {

template <Floating T>
IRG_API orient_status orient_mesh(mesh<T>& m);

}  // namespace detail::inline IRG_COMPILED_ABI

namespace detail::inline IRG_ABI {

template <Scalar T>
constexpr orient_status turn_faces_alike(mesh<T>& m) {
  struct neighbour {
    std::uint32_t face;
    bool runs_alike;
  };
  std::vector<std::uint32_t> face_of(m.corners.size(), 0);
  for (std::uint32_t f = 0; f < m.face_count(); ++f)
    for (std::size_t k = 0; k < m.face_size(f); ++k) face_of[m.face_starts[f] + k] = f;
  std::vector<std::size_t> start(m.face_count() + 1, 0);
  std::vector<neighbour> neighbours;
  const auto each_pair = [&, ends = edge_ends(m)](const auto& use) {
    for (std::size_t i = 0, next = 0; i < ends.size(); i = next) {
      while (next < ends.size() && ends[next].from == ends[i].from && ends[next].to == ends[i].to) ++next;
      if (next - i != 2 || ends[i].from > ends[i].to) continue;
      const std::uint32_t a = face_of[ends[i].corner], b = face_of[ends[i + 1].corner];
      use(a, b, ends[i].leaves == ends[i + 1].leaves);
      use(b, a, ends[i].leaves == ends[i + 1].leaves);
    }
  };
  each_pair([&](std::uint32_t a, std::uint32_t, bool) { ++start[a + std::size_t{1}]; });
  for (std::size_t f = 1; f < start.size(); ++f) start[f] += start[f - 1];
  neighbours.assign(start.back(), neighbour{});
  each_pair([&](std::uint32_t a, std::uint32_t b, bool alike) { neighbours[start[a]++] = {b, alike}; });

  enum : std::uint8_t { unseen, kept, reversed };
  std::vector<std::uint8_t> state(m.face_count(), unseen);
  std::vector<std::uint32_t> piece;
  orient_status status = orient_status::ok;
  for (std::uint32_t f = 0; f < m.face_count(); ++f) {
    if (state[f] != unseen) continue;
    piece.assign(1, f);
    state[f] = kept;
    bool two_sided = true;
    for (std::size_t i = 0; i < piece.size(); ++i) {
      const std::uint32_t at = piece[i];
      for (std::size_t k = at == 0 ? 0 : start[at - 1]; k < start[at]; ++k) {  // start tells the ends now
        const bool turn = (state[at] == reversed) != neighbours[k].runs_alike;
        const std::uint32_t beside = neighbours[k].face;
        if (state[beside] == unseen) {
          state[beside] = turn ? reversed : kept;
          piece.push_back(beside);
        } else if (state[beside] != (turn ? reversed : kept)) {
          two_sided = false;
        }
      }
    }
    if (!two_sided) status = orient_status::one_sided;
    for (const std::uint32_t at : piece)
      if (two_sided && state[at] == reversed) turn_face(m, at);
  }
  return status;
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// Turns faces until those that share an edge run along it in opposite directions.
/// shape   in each piece that edges of two faces hold together, the lowest face stays as it is; normals of corners stay
/// gives   edges of three or more faces join nothing. solid's orient_outward() then tells in from out
/// needs   a mesh in which validate() finds no defect
/// exact   always
/// cost    O(n log n); allocates
template <Scalar T>
constexpr orient_status orient_faces(mesh<T>& m) {
  if constexpr (Floating<T>)
    return detail::orient_mesh(m);
  else
    return detail::turn_faces_alike(m);
}

}  // namespace IRG_ABI
}  // namespace irg

#if IRG_BODIES
namespace irg::detail::inline IRG_COMPILED_ABI {

template <Floating T>
IRG_API orient_status orient_mesh(mesh<T>& m) {
  return turn_faces_alike(m);
}

}  // namespace irg::detail::inline IRG_COMPILED_ABI
#endif
