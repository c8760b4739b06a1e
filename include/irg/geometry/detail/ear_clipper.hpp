// SPDX-License-Identifier: MIT
// The triangles of one ring, by vertex numbers, one ear after another. The contract: triangulate_ear_clipping.hpp.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <irg/geometry/detail/fold.hpp>
#include <irg/geometry/detail/shoelace.hpp>
#include <irg/geometry/orient2d.hpp>
#include <irg/geometry/polygon.hpp>
#include <irg/math/vec.hpp>

namespace irg {

/// What triangulate_ear_clipping works in, to be used again for the next ring.
template <Scalar T>
struct ear_clipping_memory {
  std::vector<point<T, 2>> points;
  std::vector<std::uint32_t> next, previous;
  std::vector<char> reflex, gone;
  std::vector<std::uint32_t> reflex_by_x;  // the vertices that were reflex at first, by rising x
  std::vector<std::uint32_t> queue;
};

namespace detail::inline IRG_ABI {

template <Scalar T>
class ear_clipper {
public:
  constexpr ear_clipper(ear_clipping_memory<T>& memory, std::size_t tests_per_vertex) noexcept
      : m_(&memory), tests_left_(tests_per_vertex * memory.points.size()),
        size_(static_cast<std::uint32_t>(memory.points.size())) {}

  // False, with nothing emitted, for a ring without area that turns both ways.
  template <class Emit>
  constexpr bool operator()(const Emit& sink) {
    if (turns_one_way()) {
      for (std::uint32_t i = 2; i < size_; ++i) sink(0u, i - 1, i);
      return true;
    }
    direction_ = shoelace_sign(m_->points);
    if (direction_ != 0) clip(sink);
    return direction_ != 0;
  }

private:
  // Folds, which simple rings do not have, go before ears are looked for: beside them turns say nothing of the inside.
  enum class tip_rule { fold, fold_or_ear };

  ear_clipping_memory<T>* m_;
  std::size_t tests_left_;
  std::uint32_t size_;
  int direction_ = 1;  // 1 counter-clockwise, -1 clockwise

  constexpr const point<T, 2>& at(std::uint32_t i) const noexcept { return m_->points[i]; }
  constexpr int turn_at(std::uint32_t before, std::uint32_t tip, std::uint32_t after) const noexcept {
    return orient2d(at(before), at(tip), at(after));
  }

  // Whether all turns go one way: the ring is convex, or goes round more than once, and then any fan will do.
  constexpr bool turns_one_way() const noexcept {
    int side = 0;
    for (std::uint32_t i = 0; i < size_; ++i) {
      const std::uint32_t j = i + 1 < size_ ? i + 1 : 0, k = j + 1 < size_ ? j + 1 : 0;
      const int t = turn_at(i, j, k);
      if (t == 0 || t == -side) return false;
      side = t;
    }
    return true;
  }

  constexpr void link() {
    m_->next.assign(size_, 0u);
    m_->previous.assign(size_, 0u);
    for (std::uint32_t i = 0; i < size_; ++i) {
      m_->next[i] = i + 1 < size_ ? i + 1 : 0;
      m_->previous[m_->next[i]] = i;
    }
    m_->gone.assign(size_, char{0});
    m_->reflex.assign(size_, char{0});
    m_->reflex_by_x.clear();
    for (std::uint32_t i = 0; i < size_; ++i) {
      m_->reflex[i] = turn_at(m_->previous[i], i, m_->next[i]) != direction_;
      if (m_->reflex[i]) m_->reflex_by_x.push_back(i);
    }
    std::sort(m_->reflex_by_x.begin(), m_->reflex_by_x.end(),
              [&](std::uint32_t i, std::uint32_t j) { return at(i).x < at(j).x || (!(at(j).x < at(i).x) && i < j); });
  }

  // Cuts off tips until a triangle is left; what no rule lets go is a fan.
  template <class Emit>
  constexpr void clip(const Emit& sink) {
    link();
    std::uint32_t left = size_, any = 0;
    auto& queue = m_->queue;
    for (const tip_rule rule : {tip_rule::fold, tip_rule::fold_or_ear}) {
      queue.clear();
      for (std::uint32_t i = any, n = 0; n < left; ++n, i = m_->next[i]) queue.push_back(i);
      for (std::size_t head = 0; head < queue.size() && left > 3; ++head) {
        const std::uint32_t tip = queue[head];
        if (m_->gone[tip] || !may_go(tip, rule)) continue;
        const std::uint32_t before = m_->previous[tip], after = m_->next[tip];
        sink(before, tip, after);
        remove(tip);
        --left;
        any = after;
        queue.push_back(before);
        queue.push_back(after);
      }
    }
    for (std::uint32_t i = m_->next[any]; left > 2; --left, i = m_->next[i]) sink(any, i, m_->next[i]);
  }

  constexpr void remove(std::uint32_t tip) {
    const std::uint32_t before = m_->previous[tip], after = m_->next[tip];
    m_->next[before] = after;
    m_->previous[after] = before;
    m_->gone[tip] = 1;
    for (const std::uint32_t i : {before, after})
      m_->reflex[i] = turn_at(m_->previous[i], i, m_->next[i]) != direction_;
  }

  constexpr bool may_go(std::uint32_t tip, tip_rule rule) noexcept {
    if (m_->reflex[tip]) return is_fold(at(m_->previous[tip]), at(tip), at(m_->next[tip]));
    return rule == tip_rule::fold_or_ear && is_ear(tip);
  }

  // Whether the closed triangle of a left turn holds no other reflex vertex. Vertices that stand where its own do are
  // not counted: a ring that is joined to a hole by a bridge passes there twice, each time with an angle of its own.
  constexpr bool is_ear(std::uint32_t tip) noexcept {
    const std::uint32_t before = m_->previous[tip], after = m_->next[tip];
    const point<T, 2>&a = at(before), &b = at(tip), &c = at(after);
    const T x_low = lesser(lesser(a.x, b.x), c.x), x_high = greater(greater(a.x, b.x), c.x);
    const T y_low = lesser(lesser(a.y, b.y), c.y), y_high = greater(greater(a.y, b.y), c.y);
    auto r = std::lower_bound(m_->reflex_by_x.begin(), m_->reflex_by_x.end(), x_low,
                              [&](std::uint32_t i, const T& x) { return at(i).x < x; });
    for (; r != m_->reflex_by_x.end() && !(x_high < at(*r).x); ++r) {
      if (tests_left_ == 0) return false;
      --tests_left_;
      if (m_->gone[*r] || !m_->reflex[*r] || *r == before || *r == after) continue;
      const point<T, 2>& p = at(*r);
      if (p.y < y_low || y_high < p.y) continue;
      if (p == a || p == b || p == c) continue;
      if (orient2d(a, b, p) != -direction_ && orient2d(b, c, p) != -direction_ && orient2d(c, a, p) != -direction_)
        return false;
    }
    return true;
  }
};

}  // namespace detail::inline IRG_ABI
}  // namespace irg
