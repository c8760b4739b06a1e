// SPDX-License-Identifier: MIT
// Everything that keeps a mesh from being the closed, oriented surface of a body, each fault with its place and as a
// sentence. validate() comes first and asks whether the mesh may be looked at at all.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <irg/mesh/mesh.hpp>
#if IRG_BODIES
#include <algorithm>

#include <irg/geometry/point_on_triangle.hpp>
#include <irg/mesh/detail/corner_groups.hpp>
#include <irg/mesh/edge_ends.hpp>
#endif

namespace irg {

/// What may be wrong with a surface.
enum class mesh_fault_kind {
  corner_repeated,  ///< a = face, b = position: the face has it as a corner more than once
  face_without_area,  ///< a = face: all its corners lie on a line
  open_edge,  ///< a, b = positions, c = the one face there
  edge_of_many_faces,  ///< a, b = positions, c = how many faces have that edge: three or more
  faces_turned_apart,  ///< a, b = positions, c, d = the two faces, which run along the edge in the same direction
  vertex_of_many_fans,  ///< a = position, b = the number of fans that its faces make
  position_unused,  ///< a = position: no face has it
  positions_equal,  ///< a, b = positions in the same place: with_merged_positions() makes one of them
};

/// One fault and its place.
struct mesh_fault {
  mesh_fault_kind kind{};
  std::uint32_t a = 0, b = 0, c = 0, d = 0;  // see mesh_fault_kind
  bool operator==(const mesh_fault&) const = default;
};

/// A sentence without a full stop.
class fault_sentence {
public:
  [[nodiscard]] IRG_APART constexpr const char* data() const noexcept { return characters_; }
  [[nodiscard]] IRG_APART constexpr std::size_t size() const noexcept { return size_; }
  IRG_APART constexpr void append(const char* text) noexcept {
    while (*text != '\0' && size_ < sizeof(characters_)) characters_[size_++] = *text++;
  }
  IRG_APART constexpr void append(std::uint32_t number) noexcept {
    char digits[11]{};
    int at = 10;
    do digits[--at] = static_cast<char>('0' + number % 10);
    while ((number /= 10) != 0);
    append(digits + at);
  }

  /// std::string_view, std::string, or what else is made of a pointer and a size.
  template <class String>
    requires std::constructible_from<String, const char*, std::size_t>
  IRG_APART constexpr operator String() const {
    return String(data(), size());
  }

private:
  char characters_[120]{};
  std::size_t size_ = 0;
};

inline namespace IRG_ABI {

/// A fault in words, with the numbers of its faces and positions, counted from 0.
[[nodiscard]] constexpr fault_sentence sentence_of(const mesh_fault& f) noexcept {
  fault_sentence s;
  const auto say = [&s](const auto&... parts) { (s.append(parts), ...); };
  switch (f.kind) {
    case mesh_fault_kind::corner_repeated:
      say("face ", f.a, " has position ", f.b, " as a corner more than once");
      break;
    case mesh_fault_kind::face_without_area: say("face ", f.a, " has no area"); break;
    case mesh_fault_kind::open_edge:
      say("the edge from position ", f.a, " to ", f.b, " has only one face, ", f.c);
      break;
    case mesh_fault_kind::edge_of_many_faces:
      say("the edge from position ", f.a, " to ", f.b, " has ", f.c, " faces");
      break;
    case mesh_fault_kind::faces_turned_apart:
      say("faces ", f.c, " and ", f.d, " run along the edge from position ", f.a, " to ", f.b,
          " in the same direction");
      break;
    case mesh_fault_kind::vertex_of_many_fans:
      say("the faces at position ", f.a, " are ", f.b, " fans that have only this position in common");
      break;
    case mesh_fault_kind::position_unused: say("no face has position ", f.a); break;
    case mesh_fault_kind::positions_equal: say("positions ", f.a, " and ", f.b, " are in the same place"); break;
  }
  return s;
}

}  // namespace IRG_ABI

inline namespace IRG_COMPILED_ABI {

/// Every fault of a surface: none where it is closed, oriented and a manifold, of faces with area.
/// shape   faults of positions, of faces, of edges, of vertices, each by their numbers
/// needs   a mesh in which validate() finds no defect
/// gives   where faces run apart, orient_faces() turns them; what is open or shared by many has to be mended by hand
/// exact   always
/// cost    O(n log n)
template <Floating T>
[[nodiscard]] IRG_API std::vector<mesh_fault> list_faults(const mesh<T>& m);

}  // namespace IRG_COMPILED_ABI

}  // namespace irg

#if IRG_BODIES
namespace irg::detail::inline IRG_ABI {

template <Floating T>
struct fault_finder {
  const mesh<T>& m;
  std::vector<mesh_fault>& found;
  std::vector<std::uint32_t> names{}, face_of{};

  constexpr void find() {
    find_in_positions();
    for (std::uint32_t f = 0; f < m.face_count(); ++f) find_in_face(f);
    face_of.assign(m.corners.size(), 0);
    for (std::uint32_t f = 0; f < m.face_count(); ++f)
      for (std::size_t k = 0; k < m.face_size(f); ++k) face_of[m.face_starts[f] + k] = f;
    find_at_edges();
  }

  constexpr void find_in_positions() {
    std::vector<unsigned char> used(m.positions.size(), 0);
    for (const mesh_corner& c : m.corners) used[c.position] = 1;
    const auto first = first_equal_vectors<T, 3>(m.positions);
    for (std::uint32_t v = 0; v < m.positions.size(); ++v) {
      if (used[v] == 0) found.push_back({mesh_fault_kind::position_unused, v});
      if (first[v] != v) found.push_back({mesh_fault_kind::positions_equal, first[v], v});
    }
  }

  constexpr void find_in_face(std::uint32_t f) {
    const std::size_t n = m.face_size(f);
    names.clear();
    for (std::size_t k = 0; k < n; ++k) names.push_back(m.corner(f, k).position);
    std::sort(names.begin(), names.end());
    for (std::size_t k = 1; k < n; ++k)
      if (names[k] == names[k - 1] && (k == 1 || names[k] != names[k - 2]))
        found.push_back({mesh_fault_kind::corner_repeated, f, names[k]});
    const auto at = [&](std::size_t k) { return m.positions[m.corner(f, k).position]; };
    std::size_t distant = 1;  // the first corner in another place than corner 0
    while (distant < n && at(distant) == at(0)) ++distant;
    for (std::size_t k = distant + 1; k < n; ++k)
      if (!are_collinear(at(0), at(distant), at(k))) return;
    found.push_back({mesh_fault_kind::face_without_area, f});
  }

  // Runs through the ends of edges, those at one position after the other, and of one edge side by side.
  constexpr void find_at_edges() {
    const auto ends = edge_ends(m);
    corner_groups groups(m.corners.size());
    for (std::size_t i = 0, next = 0; i < ends.size(); i = next) {
      while (next < ends.size() && ends[next].from == ends[i].from && ends[next].to == ends[i].to) ++next;
      // Where a face only touches its own edge's other end twice, both ends are of one corner.
      for (std::size_t k = i + 1; k < next; ++k) groups.join(ends[i].corner, ends[k].corner);
      if (ends[i].from < ends[i].to) judge_edge(ends.data() + i, next - i);
    }
    std::vector<std::uint32_t> fans(m.positions.size(), 0);
    for (std::uint32_t c = 0; c < m.corners.size(); ++c)
      if (groups.of(c) == c) ++fans[m.corners[c].position];
    for (std::uint32_t v = 0; v < fans.size(); ++v)
      if (fans[v] > 1) found.push_back({mesh_fault_kind::vertex_of_many_fans, v, fans[v]});
  }

  constexpr void judge_edge(const edge_end* ends, std::size_t n) {
    const std::uint32_t a = ends[0].from, b = ends[0].to;
    if (n == 1)
      found.push_back({mesh_fault_kind::open_edge, a, b, face_of[ends[0].corner]});
    else if (n > 2)
      found.push_back({mesh_fault_kind::edge_of_many_faces, a, b, static_cast<std::uint32_t>(n)});
    else if (ends[0].leaves == ends[1].leaves)
      found.push_back({mesh_fault_kind::faces_turned_apart, a, b, face_of[ends[0].corner], face_of[ends[1].corner]});
  }
};

}  // namespace irg::detail::inline IRG_ABI

namespace irg::inline IRG_COMPILED_ABI {

template <Floating T>
[[nodiscard]] IRG_API std::vector<mesh_fault> list_faults(const mesh<T>& m) {
  std::vector<mesh_fault> found;
  detail::fault_finder<T>{m, found}.find();
  return found;
}

}  // namespace irg::inline IRG_COMPILED_ABI
#endif
