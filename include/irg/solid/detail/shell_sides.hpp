// SPDX-License-Identifier: MIT
// Which bodies have a shell that is turned inside out: one of negative volume, by an exact sign, that is no cavity.
// What cutting bodies at each other shows of that only where they meet is found here for all shells.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <irg/math/exact_sum.hpp>
#include <irg/solid/detail/body_triangles.hpp>
#include <irg/solid/detail/upward_crossings.hpp>

namespace irg::detail::inline IRG_ABI {

// Triangles by shells, those of a body one after another: joined along sides, also those of four faces.
struct body_shells {
  std::vector<std::uint32_t> shell{};  // of each triangle
  std::vector<std::uint32_t> order{}, starts{};  // the triangles of shell s: order[i] for i from starts[s] to the next
};

template <class Bodies>
constexpr body_shells find_shells(const Bodies& b) {
  const auto side_of = [&](std::uint32_t t, std::uint32_t k, std::uint32_t triangle) {
    const std::uint32_t v = b.triangles[t].v[k], w = b.triangles[t].v[(k + 1) % 3];
    return triangle_side{lesser(v, w), greater(v, w), triangle};
  };
  std::vector<triangle_side> rims;
  for (std::uint32_t t = 0; t < b.triangles.size(); ++t)
    for (std::uint32_t k = 0; k < 3; ++k)
      if (b.twin[3 * std::size_t{t} + k] == no_index) rims.push_back(side_of(t, k, t));
  std::sort(rims.begin(), rims.end());
  std::vector<unsigned char> is_met(rims.size(),
                                    0);  // of the first of an edge and a body, whether its faces were taken
  body_shells s;
  s.shell.assign(b.triangles.size(), no_index);
  s.order.reserve(b.triangles.size());
  const auto take = [&s](std::uint32_t t) {
    if (s.shell[t] != no_index) return;
    s.shell[t] = static_cast<std::uint32_t>(s.starts.size() - 1);
    s.order.push_back(t);
  };
  for (std::uint32_t first = 0; first < b.triangles.size(); ++first) {
    if (s.shell[first] != no_index) continue;
    s.starts.push_back(static_cast<std::uint32_t>(s.order.size()));
    take(first);
    for (std::size_t i = s.starts.back(); i < s.order.size(); ++i) {
      const std::uint32_t t = s.order[i];
      for (std::uint32_t k = 0; k < 3; ++k) {
        if (const std::uint32_t twin = b.twin[3 * std::size_t{t} + k]; twin != no_index) {
          take(twin / 3);
          continue;
        }
        const triangle_side side = side_of(t, k, b.first_of(b.body[t]));
        auto r = std::lower_bound(rims.begin(), rims.end(), side);
        unsigned char& met = is_met[static_cast<std::size_t>(r - rims.begin())];
        if (met != 0) continue;
        met = 1;
        for (; r != rims.end() && r->low == side.low && r->high == side.high && b.body[r->triangle] == b.body[t]; ++r)
          take(r->triangle);
      }
    }
  }
  s.starts.push_back(static_cast<std::uint32_t>(s.order.size()));
  return s;
}

// In rounded numbers, where these are sure: with u = 2^-53, each determinant of differences is off by less than 16u
// of `size`, the product of its rows' sums, and n of them summed by less than n u of the sum of sizes more.
template <class Bodies>
constexpr int sign_of_volume(const Bodies& b, const body_shells& s, std::uint32_t shell) {
  const point<double, 3>& from = b.positions[b.triangles[s.order[s.starts[shell]]].v[0]];
  double volume = 0, size = 0;
  const auto sum_of = [](const vec<double, 3>& v) { return magnitude(v[0]) + magnitude(v[1]) + magnitude(v[2]); };
  for (std::uint32_t i = s.starts[shell]; i < s.starts[shell + 1]; ++i) {
    const triangle_indices& t = b.triangles[s.order[i]];
    const point<double, 3>& a = b.positions[t.v[0]];
    const vec<double, 3> x = a - from, y = b.positions[t.v[1]] - a, z = b.positions[t.v[2]] - a;
    volume += dot(x, cross(y, z));
    size += product(product(sum_of(x), sum_of(y)), sum_of(z));
  }
  const double error = product(size, (static_cast<double>(s.starts[shell + 1] - s.starts[shell]) + 32) * 0x1p-52);
  if (size < 0x1p1000 && error > 0x1p-900 && magnitude(volume) > error) return volume < 0 ? -1 : 1;
  exact_accumulator<3> sum;
  for (std::uint32_t i = s.starts[shell]; i < s.starts[shell + 1]; ++i) {
    const triangle_indices& t = b.triangles[s.order[i]];
    const point<double, 3>&p = b.positions[t.v[0]], &q = b.positions[t.v[1]], &r = b.positions[t.v[2]];
    for (int k = 0; k < 3; ++k) {
      sum.add(p[k], q[(k + 1) % 3], r[(k + 2) % 3]);
      sum.subtract(p[k], q[(k + 2) % 3], r[(k + 1) % 3]);
    }
  }
  return sum.sign();
}

// Whether the other shells of its body run round a shell, as its first corner tells that is not on one of them; they
// do where none tells.
template <class Bodies>
constexpr bool is_cavity(const Bodies& b, const body_shells& s, body_boxes& boxes, std::uint32_t shell) {
  const std::uint32_t body = b.body[s.order[s.starts[shell]]];
  if (boxes.trees.empty()) boxes = boxes_of_bodies(b);
  for (std::uint32_t i = s.starts[shell]; i < s.starts[shell + 1]; ++i) {
    const point<double, 3>& p = b.positions[b.triangles[s.order[i]].v[0]];
    upward_crossings count;
    each_above(boxes, body, p, 0.0, [&](std::uint32_t t) {
      const triangle_indices& n = b.triangles[t];
      if (s.shell[t] != shell)
        count_upward_crossing(b.positions[n.v[0]], b.positions[n.v[1]], b.positions[n.v[2]], p, count);
    });
    if (!count.on_surface) return count.winding > 0;
  }
  return true;
}

/// The first body that has a shell turned inside out, or no_index.
template <class Bodies>
constexpr std::uint32_t find_inside_out(const Bodies& b) {
  const body_shells s = find_shells(b);
  body_boxes boxes;  // made where they are asked for
  for (std::uint32_t i = 0; i + 1 < s.starts.size(); ++i)
    if (sign_of_volume(b, s, i) < 0 && !is_cavity(b, s, boxes, i)) return b.body[s.order[s.starts[i]]];
  return no_index;
}

}  // namespace irg::detail::inline IRG_ABI
