// SPDX-License-Identifier: MIT
// The triangles between two edges of an upward sweep: what is open there is a chain of vertices that no triangle could
// be cut off from yet; each new vertex, on the left or on the right, cuts off what it can.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <irg/geometry/orient2d.hpp>
#include <irg/geometry/polygon.hpp>
#include <irg/math/vec.hpp>

namespace irg::detail::inline IRG_ABI {

// A chain from its newest vertex down. All but the lowest lie on one side, where the newest begins an edge; on the
// other the lowest does. Seen from inside, it turns nowhere towards the inside.
struct open_chain {
  std::uint32_t top = 0xffffffffu;  // a link
  bool on_right = false;
};

// What is open between an edge and its right neighbour: one chain, or two that met at a vertex which ended the outside
// between them and awaits the next vertex to be joined to.
struct open_gap {
  open_chain first, second;
};

template <Scalar T>
class monotone_chains {
public:
  using triangle = std::array<std::uint32_t, 3>;

  constexpr monotone_chains(const std::vector<point<T, 2>>& points, std::vector<triangle>& out)
      : points_(&points), out_(&out) {}

  constexpr open_gap begin(std::uint32_t v) { return {{push(v, none), false}, {}}; }

  /// v is on the gap's left edge.
  constexpr void add_left(open_gap& gap, std::uint32_t v) {
    if (gap.second.top != none) {
      fan(gap.first, v);
      gap.first = gap.second;
      gap.second = {};
    }
    extend(gap.first, v, false);
  }
  constexpr void add_right(open_gap& gap, std::uint32_t v) {
    if (gap.second.top != none) {
      fan(gap.second, v);
      gap.second = {};
    }
    extend(gap.first, v, true);
  }
  /// Both edges of the gap end at v.
  constexpr void finish(open_gap& gap, std::uint32_t v) {
    fan(gap.first, v);
    if (gap.second.top != none) fan(gap.second, v);
  }
  /// The outside begins at v, within the gap: returns the gap to its right and keeps the one to its left.
  constexpr open_gap split(open_gap& gap, std::uint32_t v) {
    open_gap right;
    if (gap.second.top != none) {
      right.first = gap.second;
      gap.second = {};
    } else {
      const open_chain fresh{push(links_[gap.first.top].vertex, none), false};
      right.first = gap.first.on_right ? fresh : gap.first;
      if (!gap.first.on_right) gap.first = fresh;
    }
    extend(gap.first, v, true);
    extend(right.first, v, false);
    return right;
  }
  /// The outside between two gaps ends at v.
  constexpr void merge(open_gap& left, open_gap& right, std::uint32_t v) {
    add_right(left, v);
    add_left(right, v);
    left.second = right.first;
  }

private:
  static constexpr std::uint32_t none = 0xffffffffu;
  struct link {
    std::uint32_t vertex, below;
  };
  const std::vector<point<T, 2>>* points_;
  std::vector<triangle>* out_;
  std::vector<link> links_;

  constexpr std::uint32_t push(std::uint32_t v, std::uint32_t below) {
    links_.push_back({v, below});
    return static_cast<std::uint32_t>(links_.size() - 1);
  }
  constexpr void give(bool chain_on_right, std::uint32_t lower, std::uint32_t upper, std::uint32_t v) {
    if (chain_on_right)
      out_->push_back({lower, upper, v});
    else
      out_->push_back({upper, lower, v});
  }
  // The triangles of v with every edge of the chain.
  constexpr void fan(const open_chain& chain, std::uint32_t v) {
    for (std::uint32_t upper = chain.top; links_[upper].below != none; upper = links_[upper].below)
      give(chain.on_right, links_[links_[upper].below].vertex, links_[upper].vertex, v);
  }
  // Whether the chain turns towards the inside at `upper`, so that a triangle can be cut off there. Vertices at one
  // place turn nowhere; they go at once, lest a corner that is made of several be taken for none.
  constexpr bool can_cut(std::uint32_t lower, std::uint32_t upper, std::uint32_t v, bool on_right) const noexcept {
    const point<T, 2>&a = (*points_)[lower], &b = (*points_)[upper], &c = (*points_)[v];
    const int turn = orient2d(a, b, c);
    return turn == 0 ? same_place(a, b) || same_place(b, c) : (turn > 0) == on_right;
  }
  // Adds v on the left or on the right.
  constexpr void extend(open_chain& chain, std::uint32_t v, bool on_right) {
    std::uint32_t top = chain.top;
    if (chain.on_right != on_right && links_[top].below != none) {
      fan(chain, v);
      chain = {push(v, push(links_[top].vertex, none)), on_right};
      return;
    }
    for (std::uint32_t below = links_[top].below; below != none; top = below, below = links_[top].below) {
      const std::uint32_t lower = links_[below].vertex, upper = links_[top].vertex;
      if (!can_cut(lower, upper, v, on_right)) break;
      give(on_right, lower, upper, v);
    }
    chain = {push(v, top), on_right};
  }
};

}  // namespace irg::detail::inline IRG_ABI
