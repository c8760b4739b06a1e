// SPDX-License-Identifier: MIT
// see: whether one cell is seen from another, by the exact definition.
//
// The straight segment between the centres crosses the planes between the cells one after the other; those that it
// crosses at one point are one step, over a face, an edge or a vertex. Which comes next is the sign of an integer. Seen
// from the other end the segment makes the same steps, and each is judged alike both ways: sight is symmetric.
#pragma once

#include <cstdint>

#include <irg/visibility/corner_rule.hpp>

namespace irg {

/// Whether the two end cells may be full.
enum class end_cells {
  untested,  // what is in them does not matter: a full cell can be seen
  tested,  // nothing is seen from or in a full cell
};

/// What sight is.
struct line_of_sight_options {
  corner_rule corners = corner_rule::pinch;
  end_cells ends = end_cells::untested;
  bool operator==(const line_of_sight_options&) const = default;
};

namespace detail::inline IRG_ABI {

// The steps of a segment between two centres. The plane i of axis k is crossed at (2 i + 1) / (2 n_k) of the way;
// ahead(k, l), of 2 i_k + 1 over n_k against 2 i_l + 1 over n_l, stays below four times the greatest n.
class sight_steps {
public:
  constexpr sight_steps(const cell3& a, const cell3& b) noexcept : at_(a) {
    for (int k = 0; k < 3; ++k) {
      const std::int64_t d = std::int64_t{b[k]} - a[k];
      n_[k] = d < 0 ? -d : d;
      sign_[k] = d < 0 ? -1 : 1;
    }
    xy_ = n_[1] - n_[0];
    xz_ = n_[2] - n_[0];
    yz_ = n_[2] - n_[1];
  }

  constexpr cell3 at() const noexcept { return at_; }
  constexpr const int* signs() const noexcept { return sign_; }
  // The axes of the planes that are crossed next, as bits.
  constexpr unsigned next() const noexcept {
    const bool x = n_[0] > 0 && xy_ <= 0 && xz_ <= 0, y = n_[1] > 0 && xy_ >= 0 && yz_ <= 0;
    const bool z = n_[2] > 0 && xz_ >= 0 && yz_ >= 0;
    return (x ? 1u : 0u) | (y ? 2u : 0u) | (z ? 4u : 0u);
  }
  constexpr void go(unsigned axes) noexcept {
    if ((axes & 1) != 0) {
      at_.x += sign_[0];
      xy_ += 2 * n_[1];
      xz_ += 2 * n_[2];
    }
    if ((axes & 2) != 0) {
      at_.y += sign_[1];
      xy_ -= 2 * n_[0];
      yz_ += 2 * n_[2];
    }
    if ((axes & 4) != 0) {
      at_.z += sign_[2];
      xz_ -= 2 * n_[0];
      yz_ -= 2 * n_[1];
    }
  }

private:
  cell3 at_;
  int sign_[3]{};
  std::int64_t n_[3]{};
  std::int64_t xy_ = 0, xz_ = 0, yz_ = 0;  // negative: the plane of the first axis comes before that of the second
};

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// Whether b is seen from a: the segment between their centres crosses no full cell and no wall.
/// gives   false when a or b is no cell of the grid; a cell sees itself, unless it is full and full ends are tested
/// exact   for all int coordinates; has_line_of_sight(g, a, b) == has_line_of_sight(g, b, a)
/// cost    a few additions and one look at the grid per cell on the way; no memory
/// source  Amanatides and Woo 1987 for the steps; Fabris 2012 for the definition
template <CellGrid G>
[[nodiscard]] constexpr bool has_line_of_sight(const G& g, const cell3& a, const cell3& b,
                                               const line_of_sight_options& rules = {}) {
  const grid_extent e = extent_of(g);
  if (!e.holds(a) || !e.holds(b)) return false;
  if (rules.ends == end_cells::tested && (is_full(g, a) || is_full(g, b))) return false;
  detail::sight_steps steps(a, b);
  while (!(steps.at() == b)) {
    const unsigned axes = steps.next();
    const cell3 from = steps.at();
    if ((axes & (axes - 1)) == 0) {
      const int axis = axes == 1 ? 0 : axes == 2 ? 1 : 2;
      if (detail::wall_ahead(g, from, axis, steps.signs()[axis])) return false;
    } else {
      const int* const s = steps.signs();
      if (detail::stops_at_corner(g, {from, {s[0], s[1], s[2]}, axes}, rules.corners)) return false;
    }
    steps.go(axes);
    if (!(steps.at() == b) && is_full(g, steps.at())) return false;
  }
  return true;
}

// The old name, spelled out for calls with braces.
template <CellGrid G>
[[nodiscard, deprecated("irg: now has_line_of_sight")]] constexpr bool see(const G& g, const cell3& a, const cell3& b,
                                                                           const line_of_sight_options& rules = {}) {
  return has_line_of_sight(g, a, b, rules);
}

}  // namespace IRG_ABI
}  // namespace irg
