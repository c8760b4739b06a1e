// SPDX-License-Identifier: MIT
// Unit vectors by the block, in loops that compilers turn into lanes: bit for bit what newell_sum of a triangle's edges
// and try_normalize give one by one, but for the signs of zeros, which sums that begin at 0 do not keep.
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

#include <irg/core/instructions.hpp>
#include <irg/math/length.hpp>
#include <irg/mesh/mesh.hpp>

namespace irg::detail {

/// Vectors of doubles, one coordinate after the other.
struct unit_block {
  static constexpr std::size_t size = 64;
  double u[3][size], v[3][size];
  std::uint64_t is_odd[size];  // not 0 where a vector is too long, too short or no number for this
};

inline namespace IRG_ABI {

/// Puts u x v in the place of u, for two edges of a triangle in the unit that edges_of takes.
template <class Block>
void put_crosses(Block& b, std::size_t count) noexcept {
  for (std::size_t i = 0; i < count; ++i) {
    double largest = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double p = magnitude(b.u[k][i]), q = magnitude(b.v[k][i]);
      largest = largest < p ? p : largest;
      largest = largest < q ? q : largest;
    }
    // power_of_two_for, of what is not odd.
    const std::uint64_t exponent = bits_of(largest) & (std::uint64_t{0x7ff} << 52);
    const double unit = from_bits((std::uint64_t{2046} << 52) - exponent);
    const double ux = b.u[0][i] * unit, uy = b.u[1][i] * unit, uz = b.u[2][i] * unit;
    const double vx = b.v[0][i] * unit, vy = b.v[1][i] * unit, vz = b.v[2][i] * unit;
    const double x = product(uy, vz) - product(uz, vy), y = product(uz, vx) - product(ux, vz),
                 z = product(ux, vy) - product(uy, vx);
    b.u[0][i] = x, b.u[1][i] = y, b.u[2][i] = z;
    const double none = (x - x) + (y - y) + (z - z);  // NaN where one is
    b.is_odd[i] = (largest >= 0x1p-900 ? 0u : 1u) | (largest <= 0x1p900 ? 0u : 1u) | (none == 0 ? 0u : 1u);
  }
}

/// Makes u of length 1, as put_direction, but for odd ones.
template <class Block>
void put_units(Block& b, std::size_t count) noexcept {
  for (std::size_t i = 0; i < count; ++i) {
    const double square = sum_of_squares(b.u[0][i], b.u[1][i], b.u[2][i]);
    b.is_odd[i] |= (square >= 0x1p-800 ? 0u : 1u) | (square <= 0x1p1000 ? 0u : 1u);
    b.v[0][i] = square;
  }
  for (std::size_t i = 0; i < count; ++i) b.v[2][i] = square_root_instruction(b.v[0][i]);
  for (std::size_t i = 0; i < count; ++i) {
    const double root = b.v[2][i], grid = grid_below_root(b.v[0][i]);
    const double rest =
        rest_of_squares_one_by_one(root, grid, magnitude(b.u[0][i]), magnitude(b.u[1][i]), magnitude(b.u[2][i]));
    const double length = root + product(rest, 0.5 / root);
    for (std::size_t k = 0; k < 3; ++k) b.u[k][i] = b.u[k][i] / length;
  }
}

/// Whether this is run time.
constexpr bool takes_blocks() noexcept { return !std::is_constant_evaluated(); }

/// Calls add(face, k, unit) for the corners of the next faces, as many triangles as a block has room for, and
/// other(face) for faces that are something else; gives the first face that is left.
template <class M, class Add, class Other>
std::size_t for_block_of_triangles(const M& m, std::size_t face, unit_block& b, const Add& add, const Other& other) {
  const std::size_t faces = mesh_traits<M>::face_count(m);
  std::size_t count = 0;
  for (; count < b.size && face + count < faces && mesh_traits<M>::face_size(m, face + count) == 3; ++count) {
    const auto at = [&](std::size_t k) -> decltype(auto) {
      return mesh_traits<M>::position(m, mesh_traits<M>::face_vertex(m, face + count, k));
    };
    const auto &p = at(0), &q = at(1), &r = at(2);
    for (int i = 0; i < 3; ++i) {
      b.u[i][count] = widened(coordinate(q, i)) - widened(coordinate(p, i));
      b.v[i][count] = widened(coordinate(r, i)) - widened(coordinate(p, i));
    }
  }
  put_crosses(b, count);
  put_units(b, count);
  for (std::size_t i = 0; i < count; ++i)
    if (b.is_odd[i] != 0)
      other(face + i);
    else
      for (std::size_t k = 0; k < 3; ++k) add(face + i, k, vec<double, 3>{b.u[0][i], b.u[1][i], b.u[2][i]});
  face += count;
  if (count < b.size && face < faces) other(face++);
  return face;
}

/// normalized, one after the other.
template <class V>
constexpr void normalize_all(std::vector<V>& all) {
  std::size_t i = 0;
  if constexpr (std::is_same_v<scalar_of<V>, double>) {
    unit_block b;
    for (; takes_blocks() && i + b.size <= all.size(); i += b.size) {
      for (std::size_t j = 0; j < b.size; ++j)
        for (int k = 0; k < 3; ++k) b.u[k][j] = coordinate(all[i + j], k), b.is_odd[j] = 0;
      put_units(b, b.size);
      for (std::size_t j = 0; j < b.size; ++j)
        all[i + j] =
            b.is_odd[j] != 0 ? normalized(all[i + j]) : generate_coordinates<V>([&](int k) { return b.u[k][j]; });
    }
  }
  for (; i < all.size(); ++i) all[i] = normalized(all[i]);
}

}  // namespace IRG_ABI
}  // namespace irg::detail
