// SPDX-License-Identifier: MIT
#include <irg/spatial/bsp_data_3d.hpp>

#include <limits>

#include "support/check_both.hpp"

namespace {

constexpr irg::bsp_data_3d<double> one_triangle() {
  irg::bsp_data_3d<double> d;
  d.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}};
  d.triangles = {{{0, 1, 2}}, {{0, 1, 3}}};  // the second one is flat, and not used
  d.nodes = {{{0, irg::bsp_plane_3d::of_triangle}, 0, 1, irg::no_index, irg::no_index, irg::no_index}};
  d.pieces = {{0, irg::no_index}};
  return d;
}
template <class Change>
constexpr irg::bsp_fault after(const Change& change) {
  auto d = one_triangle();
  change(d);
  return find_bsp_fault(d);
}
constexpr bool is(const irg::bsp_fault& f, irg::bsp_defect defect, irg::bsp_part part, std::size_t place) {
  return f == irg::bsp_fault{defect, part, place};
}

TEST_CASE("bsp_data_3d: each defect is found where it is") {
  using enum irg::bsp_defect;
  using irg::bsp_part;
  CHECK_BOTH(find_bsp_fault(irg::bsp_data_3d<double>{}) == irg::bsp_fault{});
  CHECK_BOTH(after([](auto&) {}) == irg::bsp_fault{});
  CHECK_BOTH(is(after([](auto& d) { d.triangles[1].v[2] = 4; }), index, bsp_part::triangle, 1));
  CHECK_BOTH(is(after([](auto& d) { d.nodes[0].plane.source = 1; }), flat, bsp_part::node, 0));
  CHECK_BOTH(is(after([](auto& d) { d.nodes[0].plane.source = 2; }), index, bsp_part::node, 0));
  CHECK_BOTH(is(after([](auto& d) { d.nodes[0].plane = {4, 1}; }), index, bsp_part::node, 0));
  CHECK_BOTH(is(after([](auto& d) {
                  d.vertices[3][1] = std::numeric_limits<double>::infinity();
                  d.nodes[0].plane = {3, 1};
                }),
                flat, bsp_part::node, 0));
  CHECK_BOTH(is(after([](auto& d) { d.nodes[0].last = 2; }), index, bsp_part::node, 0));
  CHECK_BOTH(is(after([](auto& d) { d.nodes[0].first = 1; }), shape, bsp_part::node, 0));
  CHECK_BOTH(is(after([](auto& d) { d.nodes[0].back = 0; }), shape, bsp_part::node, 0));
  CHECK_BOTH(is(after([](auto& d) { d.nodes[0].back = 1; }), index, bsp_part::node, 0));
  CHECK_BOTH(is(after([](auto& d) { d.nodes[0].first = d.nodes[0].last = 0; }), shape, bsp_part::piece, 0));
  CHECK_BOTH(is(after([](auto& d) { d.pieces[0].triangle = 1; }), flat, bsp_part::piece, 0));
  CHECK_BOTH(is(after([](auto& d) { d.pieces[0].limits = 0; }), index, bsp_part::piece, 0));
  CHECK_BOTH(is(after([](auto& d) { d.limits = {{1, 1, irg::no_index}}; }), index, bsp_part::limit, 0));
  CHECK_BOTH(is(after([](auto& d) { d.limits = {{0, 2, irg::no_index}}; }), shape, bsp_part::limit, 0));
  CHECK_BOTH(is(after([](auto& d) { d.limits = {{0, 1, 0}}; }), shape, bsp_part::limit, 0));
  // What is beside a node has no cells of its own.
  CHECK_BOTH(is(after([](auto& d) {
                  d.nodes.push_back({{0, 3}, 1, 1, 2, irg::no_index, irg::no_index});
                  d.nodes.push_back({{0, 3}, 1, 1, irg::no_index, irg::no_index, irg::no_index});
                  d.nodes[0].beside = 1;
                }),
                shape, bsp_part::node, 0));
}

}  // namespace
