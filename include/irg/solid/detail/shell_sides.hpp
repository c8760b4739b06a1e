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
#include <irg/solid/detail/box_pairs.hpp>
#include <irg/solid/detail/upward_crossings.hpp>

namespace irg::detail::inline IRG_ABI {

template <class Bodies>
class shell_sides {
public:
  constexpr explicit shell_sides(const Bodies& b) : b_(b) { find_shells(); }

  /// The first body that has a shell turned inside out, or no_index.
  constexpr std::uint32_t find_inside_out() {
    for (std::uint32_t s = 0; s + 1 < starts_.size(); ++s)
      if (sign_of_volume(s) < 0 && !is_cavity(s)) return b_.body[order_[starts_[s]]];
    return no_index;
  }

private:
  struct rim_side {
    std::uint32_t low, high, triangle;
  };

  // Triangles by shells, those of a body one after another: joined along sides, also those of four faces.
  constexpr void find_shells() {
    constexpr std::uint32_t open = no_index;
    std::vector<rim_side> rims;
    for (std::uint32_t t = 0; t < b_.triangles.size(); ++t)
      for (std::uint32_t k = 0; k < 3; ++k)
        if (b_.twin[3 * std::size_t{t} + k] == no_index) {
          const std::uint32_t v = b_.triangles[t].v[k], w = b_.triangles[t].v[(k + 1) % 3];
          rims.push_back({lesser(v, w), greater(v, w), t});
        }
    const auto comes_before = [&](const rim_side& r, const rim_side& s) {
      if (r.low != s.low) return r.low < s.low;
      if (r.high != s.high) return r.high < s.high;
      return b_.body[r.triangle] != b_.body[s.triangle] ? b_.body[r.triangle] < b_.body[s.triangle]
                                                        : r.triangle < s.triangle;
    };
    std::sort(rims.begin(), rims.end(), comes_before);
    std::vector<unsigned char> is_met(rims.size(), 0);  // of the first of each edge, whether its faces were taken
    shell_.assign(b_.triangles.size(), open);
    order_.assign(b_.triangles.size(), 0);
    std::uint32_t count = 0;
    for (std::uint32_t first = 0; first < b_.triangles.size(); ++first) {
      if (shell_[first] != open) continue;
      const auto shell = static_cast<std::uint32_t>(starts_.size());
      starts_.push_back(count);
      const auto take = [&](std::uint32_t t) {
        if (shell_[t] == open) shell_[t] = shell, order_[count++] = t;
      };
      take(first);
      for (std::uint32_t i = starts_.back(); i < count; ++i) {
        const std::uint32_t t = order_[i];
        for (std::uint32_t k = 0; k < 3; ++k) {
          const std::uint32_t twin = b_.twin[3 * std::size_t{t} + k];
          if (twin != no_index) {
            take(twin / 3);
            continue;
          }
          const std::uint32_t v = b_.triangles[t].v[k], w = b_.triangles[t].v[(k + 1) % 3];
          const rim_side side{lesser(v, w), greater(v, w), b_.first_of(b_.body[t])};
          auto r = std::lower_bound(rims.begin(), rims.end(), side, comes_before);
          if (unsigned char& met = is_met[static_cast<std::size_t>(r - rims.begin())]; met != 0)
            continue;
          else
            met = 1;
          for (; r != rims.end() && r->low == side.low && r->high == side.high && b_.body[r->triangle] == b_.body[t];
               ++r)
            take(r->triangle);
        }
      }
    }
    starts_.push_back(count);
  }

  // In rounded numbers, where these are sure: with u = 2^-53, each determinant of differences is off by less than 16u
  // of `size`, the product of its rows' sums, and n of them summed by less than n u of the sum of sizes more.
  constexpr int sign_of_volume(std::uint32_t shell) const {
    const point<double, 3>& from = b_.positions[b_.triangles[order_[starts_[shell]]].v[0]];
    double volume = 0, size = 0;
    const auto sum_of = [](const vec<double, 3>& v) { return magnitude(v[0]) + magnitude(v[1]) + magnitude(v[2]); };
    for (std::uint32_t i = starts_[shell]; i < starts_[shell + 1]; ++i) {
      const triangle_indices& t = b_.triangles[order_[i]];
      const point<double, 3>& a = b_.positions[t.v[0]];
      const vec<double, 3> x = a - from, y = b_.positions[t.v[1]] - a, z = b_.positions[t.v[2]] - a;
      volume += dot(x, cross(y, z));
      size += product(product(sum_of(x), sum_of(y)), sum_of(z));
    }
    const double error = product(size, (static_cast<double>(starts_[shell + 1] - starts_[shell]) + 32) * 0x1p-52);
    if (size < 0x1p1000 && error > 0x1p-900 && magnitude(volume) > error) return volume < 0 ? -1 : 1;
    exact_accumulator<3> sum;
    for (std::uint32_t i = starts_[shell]; i < starts_[shell + 1]; ++i) {
      const triangle_indices& t = b_.triangles[order_[i]];
      const point<double, 3>&a = b_.positions[t.v[0]], &b = b_.positions[t.v[1]], &c = b_.positions[t.v[2]];
      for (int k = 0; k < 3; ++k) {
        sum.add(a[k], b[(k + 1) % 3], c[(k + 2) % 3]);
        sum.subtract(a[k], b[(k + 2) % 3], c[(k + 1) % 3]);
      }
    }
    return sum.sign();
  }

  // Whether the other shells of its body run round a shell, as its first corner tells that is not on one of them; they
  // do where none tells.
  constexpr bool is_cavity(std::uint32_t shell) {
    const std::uint32_t body = b_.body[order_[starts_[shell]]];
    if (trees_.empty()) make_trees();
    for (std::uint32_t i = starts_[shell]; i < starts_[shell + 1]; ++i) {
      const point<double, 3>& p = b_.positions[b_.triangles[order_[i]].v[0]];
      upward_crossings count;
      const auto is_off = [&](const space_box& box) {
        return p.x < box.low[0] || box.high[0] < p.x || p.y < box.low[1] || box.high[1] < p.y || box.high[2] < p.z;
      };
      trees_[body].each(boxes_, is_off, [&](std::uint32_t t) {
        const triangle_indices& n = b_.triangles[t];
        if (shell_[t] != shell)
          count_upward_crossing(b_.positions[n.v[0]], b_.positions[n.v[1]], b_.positions[n.v[2]], p, count);
      });
      if (!count.on_surface) return count.winding > 0;
    }
    return true;
  }
  constexpr void make_trees() {
    std::vector<std::vector<std::uint32_t>> lots(b_.ends.size());
    for (std::uint32_t t = 0; t < b_.triangles.size(); ++t) {
      space_box box = no_box();
      for (const std::uint32_t v : b_.triangles[t].v) box.add(b_.positions[v]);
      boxes_.push_back(box);
      lots[b_.body[t]].push_back(t);
    }
    for (const std::vector<std::uint32_t>& lot : lots) trees_.emplace_back(lot, 2);
  }

  const Bodies& b_;
  std::vector<std::uint32_t> shell_{}, order_{}, starts_{};
  std::vector<space_box> boxes_{};
  std::vector<box_tree> trees_{};  // of the bodies, seen from above
};

}  // namespace irg::detail::inline IRG_ABI
