// SPDX-License-Identifier: MIT
// Numbers 0, 1, 2, ... in an order that changes: a treap, to search in, and a list, to find neighbours. What the order
// means is the user's business: the searcher descends from root() by his own comparisons.
#pragma once

#include <cstdint>
#include <vector>

#include <irg/core/config.hpp>

namespace irg::detail::inline IRG_ABI {

template <class Index>
class sweep_order {
public:
  static constexpr Index none = static_cast<Index>(-1);

  constexpr Index root() const noexcept { return root_; }
  constexpr Index left(Index i) const noexcept { return nodes_[i].child[0]; }
  constexpr Index right(Index i) const noexcept { return nodes_[i].child[1]; }
  constexpr Index previous(Index i) const noexcept { return nodes_[i].previous; }
  constexpr Index next(Index i) const noexcept { return nodes_[i].next; }

  /// Puts i behind `where`, or first when that is none.
  constexpr void insert_after(Index where, Index i) {
    if (i >= nodes_.size()) nodes_.resize(i + 1, node{});
    const Index follower = where == none ? first_ : nodes_[where].next;
    nodes_[i] = {{none, none}, none, where, follower, priority(i)};
    (where == none ? first_ : nodes_[where].next) = i;
    if (follower != none) nodes_[follower].previous = i;
    if (where != none && nodes_[where].child[1] == none) {
      hang(where, 1, i);
    } else if (follower != none) {  // the leftmost of the right subtree of `where`, or of all: it has no left child
      hang(follower, 0, i);
    } else {
      root_ = i;
    }
    while (nodes_[i].parent != none && nodes_[nodes_[i].parent].priority < nodes_[i].priority) raise(i);
  }

  constexpr void erase(Index i) noexcept {
    for (;;) {
      const Index l = nodes_[i].child[0], r = nodes_[i].child[1];
      if (l == none || r == none) break;
      raise(nodes_[l].priority < nodes_[r].priority ? r : l);
    }
    const node& n = nodes_[i];
    const Index only = n.child[0] != none ? n.child[0] : n.child[1];
    if (only != none) nodes_[only].parent = n.parent;
    replace_child(n.parent, i, only);
    (n.previous == none ? first_ : nodes_[n.previous].next) = n.next;
    if (n.next != none) nodes_[n.next].previous = n.previous;
  }

private:
  struct node {
    Index child[2]{none, none};
    Index parent = none, previous = none, next = none;
    std::uint32_t priority = 0;
  };
  std::vector<node> nodes_;
  Index root_ = none, first_ = none;

  IRG_INLINE static constexpr std::uint32_t priority(Index i) noexcept {
    std::uint64_t z = (i + 1) * 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    return static_cast<std::uint32_t>(z >> 32);
  }
  constexpr void hang(Index parent, int side, Index i) noexcept {
    nodes_[parent].child[side] = i;
    nodes_[i].parent = parent;
  }
  constexpr void replace_child(Index parent, Index old, Index fresh) noexcept {
    if (parent == none)
      root_ = fresh;
    else
      nodes_[parent].child[nodes_[parent].child[1] == old ? 1 : 0] = fresh;
  }
  // Rotates i above its parent.
  constexpr void raise(Index i) noexcept {
    const Index p = nodes_[i].parent, above = nodes_[p].parent;
    const int side = nodes_[p].child[1] == i ? 1 : 0;
    const Index inner = nodes_[i].child[1 - side];
    nodes_[p].child[side] = inner;
    if (inner != none) nodes_[inner].parent = p;
    replace_child(above, p, i);
    nodes_[i].parent = above;
    hang(i, 1 - side, p);
  }
};

}  // namespace irg::detail::inline IRG_ABI
