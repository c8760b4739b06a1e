// SPDX-License-Identifier: MIT
#include <irg/io/mesh_options.hpp>

#include <limits>
#include <set>
#include <string>

#include <irg/io/off.hpp>
#include <irg/mesh/shapes.hpp>

#include "support/check_both.hpp"

namespace {

/// The sentence with which a mesh is refused after `spoil` has been at it; empty when it is written.
template <class Spoil>
std::string refusal(Spoil spoil) {
  irg::mesh<double> m = irg::shape_tetrahedron<double>();
  spoil(m);
  const auto bytes = irg::encode_off(m);
  return bytes ? "" : bytes.error().message;
}

}  // namespace

TEST_CASE("mesh options: every defect has a sentence of its own") {
  using mesh = irg::mesh<double>;
  const double inf = std::numeric_limits<double>::infinity();
  CHECK(refusal([](mesh&) {}) == "");
  std::set<std::string> sentences = {
      refusal([](mesh& m) { m.face_starts.clear(); }),
      refusal([](mesh& m) { m.face_starts[1] = 2; }),
      refusal([](mesh& m) { m.corners[0].position = 4; }),
      refusal([](mesh& m) { m.corners[0].normal = 1000; }),
      refusal([](mesh& m) { m.corners[0].texcoord = 1000; }),
      refusal([&](mesh& m) { m.positions[0][0] = inf; }),
      refusal([&](mesh& m) { m.normals.push_back({0, 0, inf}); }),
      refusal([&](mesh& m) { m.texcoords.push_back({0, -inf}); }),
      refusal([](mesh& m) { m.parts = {{{}, {}, {}, 0, 1}}; }),
  };
  CHECK(sentences.size() == 9);
  CHECK(sentences.count("") == 0);
}

TEST_CASE("mesh options: the limit of files leaves 32 bits for every corner") {
  CHECK_BOTH(irg::max_mesh_file_bytes <= 0xffffffffu);
}
