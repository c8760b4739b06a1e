// SPDX-License-Identifier: MIT
// Triangles of one ring by cutting off ears, every decision exact. It takes any ring, also one that crosses itself.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <irg/core/function_ref.hpp>
#include <irg/geometry/detail/shoelace.hpp>
#include <irg/geometry/orient2d.hpp>
#include <irg/geometry/polygon.hpp>
#include <irg/math/vec.hpp>

namespace irg {

struct ear_clipping_options {
  /// How many vertex-in-triangle tests a ring may take, times its vertices, before the rest of it becomes a fan. Bounds
  /// the time that hostile rings can take; ordinary rings of 10^5 vertices need a few dozen.
  std::size_t tests_per_vertex = 1024;
  bool operator==(const ear_clipping_options&) const = default;
};

/// What triangulate_ear_clipping works in, to be used again for the next ring.
template <Scalar T>
struct ear_clipping_memory {
  std::vector<point<T, 2>> points;
  std::vector<std::uint32_t> next, previous;
  std::vector<char> reflex, gone;
  std::vector<std::uint32_t> reflex_by_x;  // the vertices that were reflex at first, by rising x
  std::vector<std::uint32_t> queue;
};

inline namespace IRG_ABI {

/// Calls sink(i, j, k) for each triangle of a ring, as vertex numbers in the ring's own direction.
/// shape   n - 2 triangles for n vertices
/// needs   finite coordinates, fewer than 2^31 vertices
/// gives   for a simple polygon, convex or not: triangles that cover it exactly once, none of them without area.
///         Straight vertices are allowed, and so are holes that bridges join to the ring. For others the signed area is
///         kept: folds go as triangles without area, what crosses itself is cut as far as ears go and finished as a
///         fan. False, and no triangle, for fewer than three vertices and for rings without area
/// exact   decisions are exact for all finite floats and all integers
/// cost    linear for strictly convex rings, else O(n log n) and up to tests_per_vertex * n tests
/// source  Meisters 1975
template <PlaneRing R, class Sink>
constexpr bool triangulate_ear_clipping(const R& ring, Sink&& sink, ear_clipping_memory<ring_scalar<R>>& memory,
                                        ear_clipping_options options = {});

/// The triangles of a ring, as above.
/// gives   n - 2 triangles without area, a fan, for a ring without area; none when a coordinate is NaN or infinite
template <PlaneRing R>
[[nodiscard]] constexpr std::vector<std::array<std::uint32_t, 3>> triangulate_ear_clipping(
    const R& ring, ear_clipping_options options = {});

}  // namespace IRG_ABI
}  // namespace irg

namespace irg::detail::inline IRG_COMPILED_ABI {

// The triangles of the ring in memory.points, which does not turn one way all along.
template <Floating T>
IRG_API bool clip_ears(ear_clipping_memory<T>& memory, std::size_t tests_per_vertex,
                       const function_ref<void(std::uint32_t, std::uint32_t, std::uint32_t)>& sink);

}  // namespace irg::detail::inline IRG_COMPILED_ABI

namespace irg::detail::inline IRG_ABI {

// Whether all turns of a ring go one way: it is convex, or goes round more than once, and then any fan will do.
template <Scalar T>
constexpr bool turns_one_way(const std::vector<point<T, 2>>& ring) noexcept {
  int side = 0;
  for (std::size_t i = 0, n = ring.size(); i < n; ++i) {
    const std::size_t j = i + 1 < n ? i + 1 : 0, k = j + 1 < n ? j + 1 : 0;
    const int t = orient2d(ring[i], ring[j], ring[k]);
    if (t == 0 || t == -side) return false;
    side = t;
  }
  return true;
}

// The triangles of one ring, by vertex numbers, one ear after another.
template <Scalar T>
class ear_clipper {
public:
  constexpr ear_clipper(ear_clipping_memory<T>& memory, std::size_t tests_per_vertex) noexcept
      : m_(&memory), tests_left_(tests_per_vertex * memory.points.size()),
        size_(static_cast<std::uint32_t>(memory.points.size())) {}

  // False, with nothing emitted, for a ring without area.
  // needs   a ring that turns both ways, or somewhere not at all
  template <class Sink>
  constexpr bool operator()(Sink& sink) {
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
  template <class Sink>
  constexpr void clip(Sink& sink) {
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
    const T x_low = minimum(minimum(a.x, b.x), c.x), x_high = maximum(maximum(a.x, b.x), c.x);
    const T y_low = minimum(minimum(a.y, b.y), c.y), y_high = maximum(maximum(a.y, b.y), c.y);
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

}  // namespace irg::detail::inline IRG_ABI

namespace irg::inline IRG_ABI {

template <PlaneRing R, class Sink>
constexpr bool triangulate_ear_clipping(const R& ring, Sink&& sink, ear_clipping_memory<ring_scalar<R>>& memory,
                                        ear_clipping_options options) {
  const std::size_t n = ring_size(ring);
  memory.points.clear();
  if (n < 3) return false;
  for (std::size_t i = 0; i < n; ++i) {
    const auto p = ring_vertex(ring, i);
    memory.points.push_back({coordinate(p, 0), coordinate(p, 1)});
  }
  if (detail::turns_one_way(memory.points)) {
    for (std::uint32_t i = 2; i < n; ++i) sink(0u, i - 1, i);
    return true;
  }
  if constexpr (Floating<ring_scalar<R>>)
    return detail::clip_ears(memory, options.tests_per_vertex,
                             as_function<void(std::uint32_t, std::uint32_t, std::uint32_t)>(sink));
  else
    return detail::ear_clipper<ring_scalar<R>>(memory, options.tests_per_vertex)(sink);
}

template <PlaneRing R>
[[nodiscard]] constexpr std::vector<std::array<std::uint32_t, 3>> triangulate_ear_clipping(
    const R& ring, ear_clipping_options options) {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  const auto n = static_cast<std::uint32_t>(ring_size(ring));
  if (n < 3 || !is_finite(ring)) return triangles;
  triangles.reserve(n - 2);
  const auto sink = [&](std::uint32_t i, std::uint32_t j, std::uint32_t k) { triangles.push_back({i, j, k}); };
  ear_clipping_memory<ring_scalar<R>> memory;
  if (!triangulate_ear_clipping(ring, sink, memory, options))
    for (std::uint32_t i = 2; i < n; ++i) sink(0, i - 1, i);
  return triangles;
}

}  // namespace irg::inline IRG_ABI

#if IRG_BODIES
namespace irg::detail::inline IRG_COMPILED_ABI {

template <Floating T>
IRG_API bool clip_ears(ear_clipping_memory<T>& memory, std::size_t tests_per_vertex,
                       const function_ref<void(std::uint32_t, std::uint32_t, std::uint32_t)>& sink) {
  return ear_clipper<T>(memory, tests_per_vertex)(sink);
}

}  // namespace irg::detail::inline IRG_COMPILED_ABI
#endif
