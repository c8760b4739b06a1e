// SPDX-License-Identifier: MIT
// Meshes, rings and planes that lack something. CASE 0 is the control and compiles.
#include <irg/core/mesh_concept.hpp>
#include <irg/core/plane_concept.hpp>
#include <irg/core/ring.hpp>
#include <irg/math/vec.hpp>

#include <array>

struct model {};

template <>
struct irg::mesh_traits<model> {
  using point = irg::point<float, 3>;
  static std::size_t vertex_count(const model&) { return 0; }
  static point position(const model&, std::size_t) { return {}; }
  static std::size_t face_count(const model&) { return 0; }
  static std::size_t face_size(const model&, std::size_t) { return 3; }
#if CASE != 1
  static std::size_t face_vertex(const model&, std::size_t, std::size_t) { return 0; }
#endif
};

[[maybe_unused]] constexpr irg::point<int, 2> triangle[] = {{0, 0}, {1, 0}, {0, 1}};

#if CASE == 0
const std::size_t faces = irg::mesh_face_count(model{});
constexpr std::size_t corners = irg::ring_size(triangle);
constexpr double d = irg::plane_coefficient(std::array<double, 4>{1, 2, 3, 4}, 3);
#elif CASE == 1  // no face_vertex
// expect: face_vertex.*(is invalid|would be invalid)
const std::size_t faces = irg::mesh_face_count(model{});
#elif CASE == 2  // a ring of vectors
// expect: (constraint failure|constraints not satisfied)
constexpr std::size_t corners = irg::ring_size(std::array<irg::vec<int, 2>, 3>{});
#elif CASE == 3  // a plane of three coefficients
// expect: (constraint failure|constraints not satisfied)
constexpr double d = irg::plane_coefficient(std::array<double, 3>{1, 2, 3}, 2);
#elif CASE == 4  // a type that nobody has told irg about
// expect: (constraint failure|constraints not satisfied)
struct stranger {};
const std::size_t faces = irg::mesh_face_count(stranger{});
#endif
