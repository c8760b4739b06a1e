// SPDX-License-Identifier: MIT
// The cells of lines in space as a thesis walks them: a third coordinate advances with the other two, or with the steps
// of a line in the plane. sight_3d.hpp asks what blocks them.
#pragma once

#include <cstdint>
#include <vector>

#include <irg/math/sqrt.hpp>
#include <irg/spatial/grid_concept.hpp>

namespace irg::textbook::inline IRG_ABI {

/// Calls sink(cell3) for the cells of a line in space from a to b, all coordinates advanced in one pass.
/// shape   as many steps as along the longest axis; the same cells both ways
/// exact   for int coordinates
/// source  Fabris 2012, 5.1.1, with z advanced by |dz| over the number of steps
template <Cell3Sink Sink>
constexpr void sight_cells_one_pass(const cell3& a, const cell3& b, Sink&& sink) {
  std::int64_t d[3], error[3];
  bool falling[3];
  for (int k = 0; k < 3; ++k) {
    d[k] = std::int64_t{b[k]} - a[k];
    falling[k] = d[k] < 0;
    if (falling[k]) d[k] = -d[k];
  }
  const int main = d[2] > d[0] && d[2] > d[1] ? 2 : d[0] > d[1] ? 0 : 1;
  // Ties are those of the canonical direction: the start's side there is the end's side of a line that is walked back.
  const int tie = falling[main] ? 1 : 0;
  const std::int64_t n = d[main];
  for (int k = 0; k < 3; ++k) error[k] = 2 * d[k] - n + tie;
  cell3 c = a;
  int* const at[] = {&c.x, &c.y, &c.z};
  sink(static_cast<const cell3&>(c));
  for (std::int64_t i = 0; i < n; ++i) {
    for (int k = 0; k < 3; ++k) {
      if (k == main || error[k] > 0) {
        *at[k] += falling[k] ? -1 : 1;
        error[k] -= 2 * n;
      }
      error[k] += 2 * d[k];
    }
    sink(static_cast<const cell3&>(c));
  }
}

/// The cells of a line in space from a to b by two lines in the plane: p' of x and y, then of the steps of p' and z.
/// shape   as sight_cells_one_pass, and the same cells unless |dz| is the greatest: then p' is rounded twice
/// source  Fabris 2012, 5
[[nodiscard]] constexpr std::vector<cell3> sight_cells_nested(const cell3& a, const cell3& b) {
  std::vector<cell3> projected;
  sight_cells_one_pass({a.x, a.y, 0}, {b.x, b.y, 0}, [&](const cell3& c) { projected.push_back(c); });
  const bool flat = (a.x < b.x ? std::int64_t{b.x} - a.x : std::int64_t{a.x} - b.x) >
                    (a.y < b.y ? std::int64_t{b.y} - a.y : std::int64_t{a.y} - b.y);
  const std::int64_t n = static_cast<std::int64_t>(projected.size()) - 1;
  const bool reverse = n > 0 ? (flat ? b.x < a.x : b.y < a.y) : b.z < a.z;
  const std::int64_t rise = std::int64_t{b.z} - a.z, m = rise < 0 ? -rise : rise, tie = reverse ? 1 : 0;
  // The whole number nearest to i * part / whole, ties downwards seen in canonical direction.
  const auto nearest = [&](std::int64_t i, std::int64_t part, std::int64_t whole) {
    return whole == 0 ? 0 : (2 * i * part + whole - 1 + tie) / (2 * whole);
  };
  std::vector<cell3> out;
  for (std::int64_t i = 0; i <= (n >= m ? n : m); ++i) {
    const std::int64_t along = n >= m ? i : nearest(i, n, m), up = n >= m ? nearest(i, m, n) : i;
    cell3 c = projected[static_cast<std::size_t>(along)];
    c.z = static_cast<int>(a.z + (rise < 0 ? -up : up));
    out.push_back(c);
  }
  return out;
}

/// Calls sink(z) for the heights that the printed procedure reaches after each of its steps, which is not always b's.
/// exact   to the roundings of doubles: the slope is |dz| over the distance of the projections
/// source  Fabris 2012, 5.3 as printed
template <class Emit>
constexpr void sight_heights_as_printed(const cell3& a, const cell3& b, Emit&& sink) {
  const double width = magnitude(double(b.x) - a.x), height = magnitude(double(b.y) - a.y);
  const double up = magnitude(double(b.z) - a.z), sign = b.z < a.z ? -1 : 1;
  const double distance = irg::sqrt(product(width, width) + product(height, height));
  double z = a.z;
  sink(z);
  if (!(distance > 0)) return;  // the printed slope is 0/0 or x/0
  const double slope = up / distance;
  double d = slope - 0.5;
  for (double i = 0; i < maximum(width, height); i += 1) {
    if (distance > up) {
      if (d > 0) {
        z += sign;
        d -= 1;
      }
      d += slope;
    } else {
      z += sign * slope;
    }
    sink(z);
  }
}

}  // namespace irg::textbook::inline IRG_ABI
