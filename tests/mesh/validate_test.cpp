// SPDX-License-Identifier: MIT
#include <irg/mesh/validate.hpp>

#include <limits>

#include "support/check_both.hpp"
#include "support/random.hpp"

namespace {

using irg::mesh_corner;
using irg::mesh_defect;
using irg::mesh_finding;

/// Two triangles with normals and texture coordinates.
template <class T>
constexpr irg::mesh<T> sample() {
  irg::mesh<T> m;
  for (int i = 0; i < 4; ++i) m.positions.push_back({static_cast<T>(i % 2), static_cast<T>(i / 2), static_cast<T>(i)});
  m.normals.push_back({T{0}, T{0}, T{1}});
  m.texcoords.push_back({T{1}, T{1}});
  for (const std::uint32_t i : {0u, 1u, 2u, 2u, 1u, 3u})
    m.corners.push_back({i, i == 1 ? 0 : irg::no_index, irg::no_index});
  m.corners[5].texcoord = 0;
  m.face_starts.push_back(3);
  m.face_starts.push_back(6);
  return m;
}

/// What validate says when the sample has been changed so.
template <class Change>
constexpr mesh_finding after(const Change& change) {
  irg::mesh<double> m = sample<double>();
  change(m);
  return irg::validate(m);
}

constexpr double infinity = std::numeric_limits<double>::infinity(),
                 not_a_number = std::numeric_limits<double>::quiet_NaN();

}  // namespace

TEST_CASE("validate: sound meshes") {
  CHECK_BOTH(irg::validate(sample<double>()) == mesh_finding{});
  CHECK_BOTH(irg::validate(sample<float>()) == mesh_finding{});
  CHECK_BOTH(irg::validate(sample<int>()) == mesh_finding{});
  CHECK_BOTH(irg::validate(irg::mesh<double>{}) == mesh_finding{});
  CHECK_BOTH(after([](auto& m) { m.positions[0].x = std::numeric_limits<double>::lowest(); }) == mesh_finding{});
  CHECK_BOTH(after([](auto& m) { m.corners[0].position = 3; }) == mesh_finding{});  // any index in range will do
}

TEST_CASE("validate: face starts") {
  using enum mesh_defect;
  CHECK_BOTH(after([](auto& m) { m.face_starts.clear(); }) == mesh_finding{bad_face_start, 0, 0});
  CHECK_BOTH(after([](auto& m) { m.face_starts[0] = 1; }) == mesh_finding{bad_face_start, 0, 0});
  CHECK_BOTH(after([](auto& m) { m.face_starts[2] = 7; }) == mesh_finding{bad_face_start, 1, 0});
  CHECK_BOTH(after([](auto& m) { m.face_starts[2] = 2; }) == mesh_finding{bad_face_start, 1, 0});
  CHECK_BOTH(after([](auto& m) { m.face_starts[1] = 0xffffffffu; }) == mesh_finding{bad_face_start, 0, 0});
  CHECK_BOTH(after([](auto& m) { m.corners.push_back({}); }) == mesh_finding{bad_face_start, 2, 0});
  CHECK_BOTH(after([](auto& m) { m.face_starts.pop_back(); }) == mesh_finding{bad_face_start, 1, 0});
  CHECK_BOTH(after([](auto& m) { m.face_starts[1] = 2; }) == mesh_finding{short_face, 0, 0});
  CHECK_BOTH(after([](auto& m) { m.face_starts[1] = 4; }) == mesh_finding{short_face, 1, 0});
  CHECK_BOTH(after([](auto& m) { m.face_starts.push_back(6); }) == mesh_finding{short_face, 2, 0});
}

TEST_CASE("validate: indices") {
  using enum mesh_defect;
  CHECK_BOTH(after([](auto& m) { m.corners[4].position = 4; }) == mesh_finding{position_out_of_range, 1, 1});
  CHECK_BOTH(after([](auto& m) { m.corners[2].position = irg::no_index; }) ==
             mesh_finding{position_out_of_range, 0, 2});
  CHECK_BOTH(after([](auto& m) { m.corners[5].normal = 1; }) == mesh_finding{normal_out_of_range, 1, 2});
  CHECK_BOTH(after([](auto& m) { m.corners[3].texcoord = 1; }) == mesh_finding{texcoord_out_of_range, 1, 0});
  CHECK_BOTH(after([](auto& m) { m.positions.clear(); }) == mesh_finding{position_out_of_range, 0, 0});
}

TEST_CASE("validate: numbers") {
  using enum mesh_defect;
  CHECK_BOTH(after([](auto& m) { m.positions[2].y = not_a_number; }) == mesh_finding{position_not_finite, 2, 0});
  CHECK_BOTH(after([](auto& m) { m.positions[3].z = -infinity; }) == mesh_finding{position_not_finite, 3, 0});
  CHECK_BOTH(after([](auto& m) { m.normals[0].x = infinity; }) == mesh_finding{normal_not_finite, 0, 0});
  CHECK_BOTH(after([](auto& m) { m.texcoords[0].y = not_a_number; }) == mesh_finding{texcoord_not_finite, 0, 0});
}

TEST_CASE("validate: parts") {
  using enum mesh_defect;
  const auto with = [](std::vector<std::pair<std::size_t, std::size_t>> runs) {
    irg::mesh<double> m = sample<double>();
    for (const auto& [first, count] : runs) m.parts.push_back({"", "", "", first, count});
    return irg::validate(m);
  };
  CHECK(with({{0, 2}}) == mesh_finding{});
  CHECK(with({{0, 1}, {1, 1}}) == mesh_finding{});
  CHECK(with({{0, 0}, {0, 2}, {2, 0}}) == mesh_finding{});
  CHECK(with({{0, 1}}) == mesh_finding{parts_do_not_cover_faces, 1, 0});
  CHECK(with({{1, 1}}) == mesh_finding{parts_do_not_cover_faces, 0, 0});
  CHECK(with({{0, 3}}) == mesh_finding{parts_do_not_cover_faces, 0, 0});
  CHECK(with({{0, 2}, {1, 1}}) == mesh_finding{parts_do_not_cover_faces, 1, 0});
  CHECK(with({{0, 1}, {1, 2}}) ==
        mesh_finding{parts_do_not_cover_faces, 1, 0});  // as many as the mesh, not as are left
  CHECK(with({{0, 1}, {1, 0}, {1, 2}, {3, 0}}) == mesh_finding{parts_do_not_cover_faces, 2, 0});
  CHECK(with({{0, 1}, {1, std::numeric_limits<std::size_t>::max()}}) == mesh_finding{parts_do_not_cover_faces, 1, 0});
}

TEST_CASE("validate: whatever stands in a mesh, the check itself stays in bounds, and what passes is usable") {
  test::random random(3);
  int sound = 0;
  for (int i = 0; i < 100'000; ++i) {
    irg::mesh<float> m;
    m.positions.assign(static_cast<std::size_t>(random.integer(0, 3)), {});
    m.corners.assign(static_cast<std::size_t>(random.integer(0, 7)), {});
    m.face_starts.clear();
    for (auto n = random.integer(0, 3); n > 0; --n)
      m.face_starts.push_back(static_cast<std::uint32_t>(random.integer(0, 8)));
    if (i % 2 == 0 && !m.face_starts.empty()) m.face_starts[0] = 0;
    for (auto& c : m.corners) c.position = static_cast<std::uint32_t>(random.integer(0, 3));
    if (irg::validate(m).defect != mesh_defect::none) continue;
    ++sound;
    std::size_t corners = 0;
    for (std::size_t f = 0; f < m.face_count(); ++f)
      for (std::size_t k = 0; k < m.face_size(f); ++k, ++corners) REQUIRE(m.corner(f, k).position < m.positions.size());
    REQUIRE(corners == m.corners.size());
  }
  CHECK(sound > 100);
}

TEST_CASE("validate_faces: what validate says of faces, and nothing of numbers or parts") {
  CHECK_BOTH(irg::validate_faces(sample<double>()) == mesh_finding{});
  constexpr auto faces_after = [](const auto& change) {
    irg::mesh<double> m = sample<double>();
    change(m);
    return irg::validate_faces(m);
  };
  constexpr auto far_position = [](auto& m) { m.corners[4].position = 4; };
  constexpr auto odd_number = [](auto& m) { m.positions[0].x = not_a_number; };
  constexpr auto part_short = [](auto& m) { m.parts.push_back({"", "", "", 0, 1}); };
  CHECK_BOTH(faces_after(far_position) == mesh_finding{mesh_defect::position_out_of_range, 1, 1});
  CHECK_BOTH(faces_after(far_position) == after(far_position));
  CHECK_BOTH(faces_after(odd_number) == mesh_finding{});
  CHECK_BOTH(after(odd_number).defect == mesh_defect::position_not_finite);
  CHECK_BOTH(faces_after(part_short) == mesh_finding{});
}
