// SPDX-License-Identifier: MIT
// The triangles of one polygon of a mesh, by corner numbers. Decisions are exact; see triangulate.hpp for the contract.
#pragma once

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

#include <irg/mesh/detail/product_sum.hpp>
#include <irg/mesh/mesh.hpp>

namespace irg::detail {
inline namespace IRG_ABI {

/// Scratch memory for triangulating one face after another. `emit(i, j, k)` takes each triangle, as numbers of corners
/// in the face's own direction.
template <Scalar T>
class ear_clipper {
public:
  constexpr explicit ear_clipper(std::size_t tests_per_corner) : tests_per_corner_(tests_per_corner) {}

  template <class Emit>
  constexpr void operator()(const mesh<T>& m, std::size_t face, const Emit& emit) {
    size_ = static_cast<std::uint32_t>(m.face_size(face));
    if (size_ == 3) return emit(0u, 1u, 2u);
    flatten(m, face);
    if (turns_one_way() || !find_direction(m, face)) {
      for (std::uint32_t i = 2; i < size_; ++i) emit(0u, i - 1, i);
      return;
    }
    clip(emit);
  }

private:
  using number = std::conditional_t<Floating<T>, double, T>;  // holds every T
  using flat_point = point<number, 2>;

  // Folds, which simple rings do not have, go before ears are looked for: beside them turns say nothing of the inside.
  enum class tip_rule { fold, fold_or_ear };

  std::size_t tests_per_corner_;
  std::uint32_t size_ = 0;
  int direction_ = 1;  // 1 counter-clockwise, -1 clockwise, in the plane of points_
  std::vector<flat_point> points_;  // the face's corners without their coordinate along axis
  std::vector<std::uint32_t> next_, previous_;
  std::vector<char> reflex_, gone_;
  std::vector<std::uint32_t> reflex_by_x_;  // the corners that were reflex at first, by rising x
  std::vector<std::uint32_t> queue_;
  std::size_t tests_left_ = 0;

  static constexpr number coordinate(const mesh<T>& m, std::size_t face, std::size_t i, int k) noexcept {
    return static_cast<number>(m.positions[m.corner(face, i).position][k]);
  }

  constexpr void project(const mesh<T>& m, std::size_t face, int axis) {
    points_.clear();
    for (std::size_t i = 0; i < size_; ++i)
      points_.push_back({coordinate(m, face, i, (axis + 1) % 3), coordinate(m, face, i, (axis + 2) % 3)});
  }

  /// Projects along the axis in which the Newell normal is longest.
  constexpr void flatten(const mesh<T>& m, std::size_t face) {
    constexpr number zero = static_cast<number>(0);
    number normal[3] = {zero, zero, zero};
    const number scale = scale_for(m, face);
    const auto from_first = [&](std::size_t i, int k) {
      return product(coordinate(m, face, i, k), scale) - product(coordinate(m, face, 0, k), scale);
    };
    for (std::size_t i = 1; i + 1 < size_; ++i)
      for (int k = 0; k < 3; ++k) {
        const int u = (k + 1) % 3, v = (k + 2) % 3;
        normal[k] = normal[k] +
                    (product(from_first(i, u), from_first(i + 1, v)) - product(from_first(i, v), from_first(i + 1, u)));
      }
    for (number& n : normal) n = n < zero ? -n : n;
    const int x_or_y = normal[0] < normal[1] ? 1 : 0;
    project(m, face, normal[2] < normal[x_or_y] ? x_or_y : 2);
  }

  /// A power of two that keeps products of the face's coordinates from overflow and underflow.
  constexpr number scale_for(const mesh<T>& m, std::size_t face) const noexcept {
    if constexpr (std::same_as<T, double>) {
      double largest = 0;
      for (std::size_t i = 0; i < size_; ++i)
        for (int k = 0; k < 3; ++k) {
          const double x = coordinate(m, face, i, k);
          largest = greater(largest, x < 0 ? -x : x);
        }
      return largest > 0x1p450 ? 0x1p-600 : largest < 0x1p-450 ? 0x1p600 : 1.0;
    } else {
      return static_cast<number>(1);
    }
  }

  constexpr int turn_at(std::uint32_t before, std::uint32_t tip, std::uint32_t after) const noexcept {
    return turn(points_[before], points_[tip], points_[after]);
  }

  /// Whether all turns go one way: the ring is convex, or goes round more than once, and then any fan will do.
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

  constexpr int area_sign() const noexcept {
    const auto each = [&](auto&& take) {
      for (std::size_t i = 0; i < size_; ++i) take(points_[i], points_[i + 1 < size_ ? i + 1 : 0]);
    };
    if constexpr (Floating<T>) {
      product_sum twice;
      each([&](const auto& p, const auto& q) { twice.add(p.x, q.y), twice.subtract(p.y, q.x); });
      return twice.sign();
    } else {
      number twice = static_cast<number>(0);
      each([&](const auto& p, const auto& q) { twice = twice + (p.x * q.y - p.y * q.x); });
      return sign_of(twice);
    }
  }

  /// Says which way round the face goes, looking along another axis where it has no area along the first.
  constexpr bool find_direction(const mesh<T>& m, std::size_t face) {
    direction_ = area_sign();
    for (int axis = 0; axis < 3 && direction_ == 0; ++axis) {
      project(m, face, axis);
      direction_ = area_sign();
    }
    return direction_ != 0;
  }

  constexpr void link() {
    next_.assign(size_, 0u);
    previous_.assign(size_, 0u);
    for (std::uint32_t i = 0; i < size_; ++i) {
      next_[i] = i + 1 < size_ ? i + 1 : 0;
      previous_[next_[i]] = i;
    }
    gone_.assign(size_, char{0});
    reflex_.assign(size_, char{0});
    reflex_by_x_.clear();
    for (std::uint32_t i = 0; i < size_; ++i) {
      reflex_[i] = turn_at(previous_[i], i, next_[i]) != direction_;
      if (reflex_[i]) reflex_by_x_.push_back(i);
    }
    std::sort(reflex_by_x_.begin(), reflex_by_x_.end(), [&](std::uint32_t i, std::uint32_t j) {
      return points_[i].x < points_[j].x || (!(points_[j].x < points_[i].x) && i < j);
    });
    tests_left_ = tests_per_corner_ * size_;
  }

  /// Cuts off tips until a triangle is left; what no rule lets go is a fan.
  template <class Emit>
  constexpr void clip(const Emit& emit) {
    link();
    std::uint32_t left = size_, any = 0;
    for (const tip_rule rule : {tip_rule::fold, tip_rule::fold_or_ear}) {
      queue_.clear();
      for (std::uint32_t i = any, n = 0; n < left; ++n, i = next_[i]) queue_.push_back(i);
      for (std::size_t head = 0; head < queue_.size() && left > 3; ++head) {
        const std::uint32_t tip = queue_[head];
        if (gone_[tip] || !may_go(tip, rule)) continue;
        const std::uint32_t before = previous_[tip], after = next_[tip];
        emit(before, tip, after);
        remove(tip);
        --left;
        any = after;
        queue_.push_back(before);
        queue_.push_back(after);
      }
    }
    for (std::uint32_t i = next_[any]; left > 2; --left, i = next_[i]) emit(any, i, next_[i]);
  }

  constexpr void remove(std::uint32_t tip) {
    const std::uint32_t before = previous_[tip], after = next_[tip];
    next_[before] = after;
    previous_[after] = before;
    gone_[tip] = 1;
    for (const std::uint32_t i : {before, after}) reflex_[i] = turn_at(previous_[i], i, next_[i]) != direction_;
  }

  constexpr bool may_go(std::uint32_t tip, tip_rule rule) noexcept {
    if (reflex_[tip]) return is_fold(tip);
    return rule == tip_rule::fold_or_ear && is_ear(tip);
  }

  /// Whether the ring turns back on itself at the tip, or stands still.
  constexpr bool is_fold(std::uint32_t tip) const noexcept {
    const flat_point &a = points_[previous_[tip]], &b = points_[tip], &c = points_[next_[tip]];
    if (turn(a, b, c) != 0) return false;
    const bool x_between = (a.x < b.x && b.x < c.x) || (c.x < b.x && b.x < a.x);
    const bool y_between = (a.y < b.y && b.y < c.y) || (c.y < b.y && b.y < a.y);
    return !x_between && !y_between;
  }

  /// Whether the closed triangle of a left turn holds no other reflex corner. Corners that stand where its own do are
  /// not counted: a ring that is joined to a hole by a bridge passes there twice, each time with an angle of its own.
  constexpr bool is_ear(std::uint32_t tip) noexcept {
    const std::uint32_t before = previous_[tip], after = next_[tip];
    const flat_point &a = points_[before], &b = points_[tip], &c = points_[after];
    const number x_low = lesser(lesser(a.x, b.x), c.x), x_high = greater(greater(a.x, b.x), c.x);
    const number y_low = lesser(lesser(a.y, b.y), c.y), y_high = greater(greater(a.y, b.y), c.y);
    auto r = std::lower_bound(reflex_by_x_.begin(), reflex_by_x_.end(), x_low,
                              [&](std::uint32_t i, const number& x) { return points_[i].x < x; });
    for (; r != reflex_by_x_.end() && !(x_high < points_[*r].x); ++r) {
      if (tests_left_ == 0) return false;
      --tests_left_;
      if (gone_[*r] || !reflex_[*r] || *r == before || *r == after) continue;
      const flat_point& p = points_[*r];
      if (p.y < y_low || y_high < p.y) continue;
      if (p == a || p == b || p == c) continue;
      if (turn(a, b, p) != -direction_ && turn(b, c, p) != -direction_ && turn(c, a, p) != -direction_) return false;
    }
    return true;
  }
};

}  // namespace IRG_ABI
}  // namespace irg::detail
