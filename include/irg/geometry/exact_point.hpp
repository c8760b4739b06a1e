// SPDX-License-Identifier: MIT
// exact_point: a point of space that was constructed, as the crossing of an edge and a plane, without any rounding: its
// coordinates are quotients of whole multiples of powers of two. What decides with such points decides about the points
// themselves, not about doubles near them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <irg/core/contract.hpp>
#include <irg/core/vocabulary.hpp>
#include <irg/math/exact/big_float.hpp>
#include <irg/math/exact/scaled_double_double.hpp>
#include <irg/math/vec.hpp>

namespace irg {

/// A point with three coordinates over one divisor, all exact.
/// cost    one allocation, of some 30 words for ordinary doubles
template <class Word = std::uint64_t>
class basic_exact_point {
  // A meeting of three planes has degrees 6 and 7, a mean of three of them 19, its side of a plane 21.
  using wide = big_float<23>;
  struct part {
    int first = 0, size = 0, place = 0;
    bool negative = false;
  };

  template <class Number>
  [[nodiscard]] IRG_APART static constexpr std::array<Number, 3> vector_of(const point<double, 3>& p) noexcept {
    return {Number(p.x), Number(p.y), Number(p.z)};
  }
  template <class Number>
  [[nodiscard]] IRG_APART static constexpr std::array<Number, 3> minus(const std::array<Number, 3>& a,
                                                                       const std::array<Number, 3>& b) noexcept {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
  }
  // from + way t / divisor
  template <class Number>
  [[nodiscard]] IRG_APART static constexpr basic_exact_point along(const std::array<Number, 3>& from,
                                                                   const std::array<Number, 3>& way, const Number& t,
                                                                   const Number& divisor) {
    basic_exact_point p;
    if (divisor.sign() != 0)
      p.store(std::array{divisor, from[0] * divisor + way[0] * t, from[1] * divisor + way[1] * t,
                         from[2] * divisor + way[2] * t});
    return p;
  }

  template <class Number>
  IRG_APART constexpr void store(const std::array<Number, 4>& v) {
    for (std::size_t i = 0; i < 4; ++i) {
      parts_[i] = {static_cast<int>(words_.size()), v[i].size(), v[i].place(), v[i].sign() < 0};
      words_.insert(words_.end(), v[i].words(), v[i].words() + v[i].size());
    }
  }
  [[nodiscard]] IRG_APART constexpr std::array<wide, 4> load() const noexcept {
    IRG_EXPECTS(is_known());
    const auto at = [this](std::size_t i) {
      return wide(words_.data() + parts_[i].first, parts_[i].size, parts_[i].place, parts_[i].negative);
    };
    return {at(0), at(1), at(2), at(3)};
  }

public:
  /// No point.
  IRG_APART constexpr basic_exact_point() noexcept {}
  /// The point p.
  /// needs   finite coordinates
  IRG_APART constexpr explicit basic_exact_point(const point<double, 3>& p) {
    using number = big_float<1>;
    store(std::array{number(1.0), number(p.x), number(p.y), number(p.z)});
  }

  /// Where the line through a and b crosses the plane through p, q and r.
  /// needs   finite coordinates
  /// gives   no point when they are parallel, or a == b, or the three lie on a line
  [[nodiscard]] IRG_APART static constexpr basic_exact_point on_plane(const point<double, 3>& p,
                                                                      const point<double, 3>& q,
                                                                      const point<double, 3>& r,
                                                                      const point<double, 3>& a,
                                                                      const point<double, 3>& b) {
    using number = big_float<4>;
    const auto base = vector_of<number>(p), u = minus(vector_of<number>(q), base),
               v = minus(vector_of<number>(r), base);
    const auto from = vector_of<number>(a), way = minus(vector_of<number>(b), from), height = minus(base, from);
    const std::array<number, 3> n{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
    const number divisor = n[0] * way[0] + n[1] * way[1] + n[2] * way[2];
    const number t = n[0] * height[0] + n[1] * height[1] + n[2] * height[2];
    return along(from, way, t, divisor);
  }

  /// Where the lines through a and b and through c and d cross, two lines of one plane.
  /// needs   finite coordinates
  /// gives   no point when they are parallel; where they pass each other, a point of the first that is a crossing as
  ///         seen along an axis
  [[nodiscard]] IRG_APART static constexpr basic_exact_point on_lines(const point<double, 3>& a,
                                                                      const point<double, 3>& b,
                                                                      const point<double, 3>& c,
                                                                      const point<double, 3>& d) {
    using number = big_float<4>;
    const auto from = vector_of<number>(a), way = minus(vector_of<number>(b), from);
    const auto start = vector_of<number>(c), other = minus(vector_of<number>(d), start), between = minus(start, from);
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = i < 2 ? i + 1 : 0;
      const number divisor = way[i] * other[j] - way[j] * other[i];
      if (divisor.sign() != 0) return along(from, way, between[i] * other[j] - between[j] * other[i], divisor);
    }
    return {};
  }

  /// Where three planes meet, each through three points.
  /// needs   finite coordinates
  /// gives   no point when they have more or less in common
  [[nodiscard]] IRG_APART static constexpr basic_exact_point on_planes(
      const std::array<std::array<point<double, 3>, 3>, 3>& planes) {
    using number = big_float<9>;
    using three = std::array<number, 3>;
    const auto cross = [](const three& u, const three& v) {
      return three{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
    };
    const auto dot = [](const three& u, const three& v) { return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]; };
    const auto from = vector_of<number>(planes[0][0]);
    three normal[3];
    number height[3];  // of the first plane's point below each plane, in normals
    for (std::size_t i = 0; i < 3; ++i) {
      const auto base = vector_of<number>(planes[i][0]);
      normal[i] = cross(minus(vector_of<number>(planes[i][1]), base), minus(vector_of<number>(planes[i][2]), base));
      height[i] = dot(normal[i], minus(base, from));
    }
    const three second = cross(normal[2], normal[0]), third = cross(normal[0], normal[1]);
    three way;
    for (std::size_t i = 0; i < 3; ++i) way[i] = height[1] * second[i] + height[2] * third[i];
    return along(from, way, number(1.0), dot(normal[2], third));
  }

  /// The mean of three points.
  /// needs   three points
  [[nodiscard]] IRG_APART static constexpr basic_exact_point mean_of(const basic_exact_point& p,
                                                                     const basic_exact_point& q,
                                                                     const basic_exact_point& r) {
    const auto a = p.load(), b = q.load(), c = r.load();
    const wide bc = b[0] * c[0], ca = c[0] * a[0], ab = a[0] * b[0];
    std::array<wide, 4> sum{ab * c[0] * wide(3.0), {}, {}, {}};
    for (std::size_t i = 1; i < 4; ++i) sum[i] = a[i] * bc + b[i] * ca + c[i] * ab;
    basic_exact_point mean;
    mean.store(sum);
    return mean;
  }

  [[nodiscard]] IRG_APART constexpr bool is_known() const noexcept { return parts_[0].size > 0; }

  /// The nearest doubles, nearly.
  /// needs   a point
  /// exact   within 0.501 ulp
  [[nodiscard]] IRG_APART constexpr point<double, 3> rounded() const noexcept {
    const auto v = load();
    point<double, 3> p{};
    for (std::size_t i = 0; i < 3; ++i)
      if (v[i + 1].sign() != 0) p[static_cast<int>(i)] = rounded_to<double>(v[i + 1].rounded() / v[0].rounded());
    return p;
  }

private:
  template <class W>
  friend constexpr int compare_along(int axis, const basic_exact_point<W>& p, const basic_exact_point<W>& q) noexcept;
  template <class W>
  friend constexpr int orientation_along(int axis, const basic_exact_point<W>& p, const basic_exact_point<W>& q,
                                         const basic_exact_point<W>& r) noexcept;
  template <class W>
  friend constexpr side side_of_plane(const point<double, 3>& a, const point<double, 3>& b, const point<double, 3>& c,
                                      const basic_exact_point<W>& p) noexcept;

  std::vector<Word> words_;
  part parts_[4]{};  // the divisor first
};
using exact_point = basic_exact_point<>;

/// -1, 0 or 1, as coordinate `axis` of p is less than that of q, equal or greater.
/// needs   two points
/// exact   always
template <class W>
[[nodiscard]] IRG_APART constexpr int compare_along(int axis, const basic_exact_point<W>& p,
                                                    const basic_exact_point<W>& q) noexcept {
  const auto a = p.load(), b = q.load();
  const auto i = static_cast<std::size_t>(axis) + 1;
  return (a[i] * b[0] - b[i] * a[0]).sign() * a[0].sign() * b[0].sign();
}

/// orient2d of the points without coordinate `axis`, the others in their order.
/// needs   three points
/// exact   always
template <class W>
[[nodiscard]] IRG_APART constexpr int orientation_along(int axis, const basic_exact_point<W>& p,
                                                        const basic_exact_point<W>& q,
                                                        const basic_exact_point<W>& r) noexcept {
  const auto a = p.load(), b = q.load(), c = r.load();
  const std::size_t x = axis == 0 ? 2 : 1, y = axis == 2 ? 2 : 3;
  const auto area =
      (a[x] * b[y] - a[y] * b[x]) * c[0] + (b[x] * c[y] - b[y] * c[x]) * a[0] + (c[x] * a[y] - c[y] * a[x]) * b[0];
  return area.sign() * a[0].sign() * b[0].sign() * c[0].sign();
}

/// The side of plane_through(a, b, c) on which p lies: orient3d(a, b, c, p).
/// needs   finite coordinates, a point
/// exact   always
template <class W>
[[nodiscard]] IRG_APART constexpr side side_of_plane(const point<double, 3>& a, const point<double, 3>& b,
                                                     const point<double, 3>& c,
                                                     const basic_exact_point<W>& p) noexcept {
  using exact = basic_exact_point<W>;
  using number = typename exact::wide;
  const auto base = exact::template vector_of<number>(a);
  const auto u = exact::minus(exact::template vector_of<number>(b), base);
  const auto v = exact::minus(exact::template vector_of<number>(c), base);
  const auto at = p.load();
  const auto from = [&](std::size_t i) { return at[i + 1] - base[i] * at[0]; };
  const number value = (u[1] * v[2] - u[2] * v[1]) * from(0) + (u[2] * v[0] - u[0] * v[2]) * from(1) +
                       (u[0] * v[1] - u[1] * v[0]) * from(2);
  return static_cast<side>(value.sign() * at[0].sign());
}

}  // namespace irg
