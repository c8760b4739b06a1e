// SPDX-License-Identifier: MIT
// Which triangle is seen in each pixel, decided exactly from snapped positions and the floats of the vertices' depths:
// of the triangles that cover the pixel's centre the one whose plane is nearest there, of equal depths the lowest id.
//
// Coverage is written another way than raster/triangle_coverage.hpp: the top-left rule says that a centre c stands for
// c + (e, e^2) with e infinitely small, and that point lies on no edge, so that three equal signs decide.
//
// A depth is a fraction of integers: weights that add up to twice the area, and depths scaled by 2^149. Where long
// double leaves no doubt it decides, elsewhere the fractions do.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <utility>
#include <vector>

#include <irg/math/int128.hpp>
#include <irg/raster/draw_triangle.hpp>

namespace test {

using irg::uint128;

/// A non-negative integer below 2^384; what outgrows it ends the test.
class natural {
public:
  /// Adds v * 2^shift.
  void add(uint128 v, int shift) {
    std::size_t i = static_cast<std::size_t>(shift) / 32;
    std::uint64_t carry = 0;
    const int rest = shift % 32;
    std::uint64_t high = static_cast<std::uint64_t>(rest == 0 ? 0 : v >> (128 - rest));
    for (v <<= rest; v != 0 || high != 0 || carry != 0; ++i) {
      if (i >= limbs) std::abort();
      const std::uint64_t sum = std::uint64_t{limb_[i]} + static_cast<std::uint32_t>(v) + carry;
      limb_[i] = static_cast<std::uint32_t>(sum);
      carry = sum >> 32;
      v = v >> 32 | uint128{high & 0xffffffffu} << 96;
      high >>= 32;
    }
  }
  /// This number times m.
  natural times(std::uint64_t m) const {
    natural product;
    for (std::size_t i = 0; i < limbs; ++i)
      if (limb_[i] != 0) product.add(uint128{limb_[i]} * m, static_cast<int>(32 * i));
    return product;
  }
  /// -1, 0 or 1.
  int compare(const natural& o) const {
    for (std::size_t i = limbs; i-- > 0;)
      if (limb_[i] != o.limb_[i]) return limb_[i] < o.limb_[i] ? -1 : 1;
    return 0;
  }

private:
  static constexpr std::size_t limbs = 12;
  std::uint32_t limb_[limbs]{};
};

/// A triangle on the screen. Several may have one id: the pieces that clipping left of one source.
struct snapped_triangle {
  irg::screen_vertex v[3];
  std::uint32_t id;  // 1 and more
};

/// A triangle's depth at a pixel's centre: sum of weight[i] * depth[i], over the sum of the weights.
class exact_depth {
public:
  exact_depth() = default;
  explicit exact_depth(float depth) : exact_depth({1, 0, 0}, {{{}, depth}, {}, {}}) {}
  /// needs   weights that are not negative and not all 0; 0 <= depth <= 2^16
  exact_depth(const std::int64_t (&weight)[3], const irg::screen_vertex (&v)[3]) {
    for (int i = 0; i < 3; ++i) {
      if (!(v[i].depth >= 0.0f && v[i].depth <= 65536.0f)) std::abort();
      weight_[i] = static_cast<std::uint64_t>(weight[i]), depth_[i] = v[i].depth, total_ += weight_[i];
    }
    approximate_ = 0;
    for (int i = 0; i < 3; ++i)
      approximate_ += static_cast<long double>(weight_[i]) * static_cast<long double>(depth_[i]);
    approximate_ /= static_cast<long double>(total_);
  }

  /// Within a few units in the last place of a long double.
  long double approximate() const { return approximate_; }

  /// -1 where a is less than b, 0 where they are equal, 1 where a is greater.
  static int compare(const exact_depth& a, const exact_depth& b) {
    // The error is some 2^-60 where long double has 64 bits, and 2^-49 where it is a double.
    const long double difference = a.approximate_ - b.approximate_,
                      doubt = 0x1p-44L * (a.approximate_ + b.approximate_);
    if (difference > doubt) return 1;
    if (difference < -doubt) return -1;
    return a.numerator().times(b.total_).compare(b.numerator().times(a.total_));
  }

  /// The distance between two depths in units in the last place of the greater one's float; 0 only if they are equal.
  static double ulps_between(const exact_depth& a, const exact_depth& b) {
    if (compare(a, b) == 0) return 0;
    const long double difference = std::fabs(a.approximate_ - b.approximate_),
                      greater = std::fmax(a.approximate_, b.approximate_);
    const long double ulp = std::fmax(0x1p-149L, std::ldexp(1.0L, std::ilogb(greater) - 23));
    return std::fmax(static_cast<double>(difference / ulp), 1e-30);
  }

private:
  natural numerator() const {
    natural sum;
    for (int i = 0; i < 3; ++i) {
      if (depth_[i] == 0.0f || weight_[i] == 0) continue;
      int exponent;
      const auto mantissa = static_cast<std::uint64_t>(std::ldexp(std::frexp(depth_[i], &exponent), 24));
      const int shift = exponent - 24 + 149;  // negative where a subnormal's last bits are 0
      sum.add(uint128{weight_[i]} * (shift < 0 ? mantissa >> -shift : mantissa), shift < 0 ? 0 : shift);
    }
    return sum;
  }

  std::uint64_t weight_[3]{}, total_ = 0;
  float depth_[3]{};
  long double approximate_ = 0;
};

/// What is seen in a pixel.
struct visible {
  std::uint32_t nearest = 0;  // 0: nothing
  std::uint32_t runner_up = 0;  // the nearest of the others
  double ulps = 0;  // between these two; 0 where they are equally far
};

/// All pixels of a picture. `Order` says which depths are nearer; what is exactly as far as a cleared buffer is unseen.
template <irg::DepthOrder Order>
class visibility_oracle {
public:
  visibility_oracle(std::vector<snapped_triangle> triangles, int width, int height)
      : triangles_(std::move(triangles)), width_(width),
        pixels_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {
    for (const snapped_triangle& t : triangles_) {
      const auto low = [&](auto member) {
        return irg::minimum(irg::minimum(t.v[0].position.*member, t.v[1].position.*member), t.v[2].position.*member);
      };
      const auto high = [&](auto member) {
        return irg::maximum(irg::maximum(t.v[0].position.*member, t.v[1].position.*member), t.v[2].position.*member);
      };
      const int right = irg::minimum(width, high(&irg::subpixel::x) / 256 + 2),
                bottom = irg::minimum(height, high(&irg::subpixel::y) / 256 + 2);
      for (int y = irg::maximum(0, low(&irg::subpixel::y) / 256 - 2); y < bottom; ++y)
        for (int x = irg::maximum(0, low(&irg::subpixel::x) / 256 - 2); x < right; ++x) add(t, x, y);
    }
  }

  visible at(int x, int y) const {
    const candidates& c = pixels_[index(x, y)];
    return {c.nearest.id, c.second.id,
            c.second.id == 0 ? 0 : exact_depth::ulps_between(c.nearest.depth, c.second.depth)};
  }

  /// How far behind the nearest a triangle lies, in ulp; infinite where it does not cover the pixel at all. 0 stands for
  /// the cleared buffer: what is seen just before the far plane may be rounded to it, and not be drawn.
  double ulps_behind(std::uint32_t id, int x, int y) const {
    if (pixels_[index(x, y)].nearest.id == 0) return std::numeric_limits<double>::infinity();
    if (id == 0) return exact_depth::ulps_between(exact_depth(Order::farthest), pixels_[index(x, y)].nearest.depth);
    double least = std::numeric_limits<double>::infinity();
    std::int64_t weight[3];
    for (const snapped_triangle& t : triangles_)
      if (t.id == id && covers(t, x, y, weight))
        least =
            std::fmin(least, exact_depth::ulps_between(exact_depth(weight, t.v), pixels_[index(x, y)].nearest.depth));
    return least;
  }

  /// How far a depth is from that of a triangle at a pixel, in ulp; infinite where the triangle does not cover it.
  double ulps_off(float depth, std::uint32_t id, int x, int y) const {
    double least = std::numeric_limits<double>::infinity();
    std::int64_t weight[3];
    for (const snapped_triangle& t : triangles_)
      if (t.id == id && covers(t, x, y, weight))
        least = std::fmin(least, exact_depth::ulps_between(exact_depth(weight, t.v), exact_depth(depth)));
    return least;
  }

  /// Whether a triangle covers a pixel's centre; and if, its weights there, which add up to twice its area.
  static bool covers(const snapped_triangle& t, int x, int y, std::int64_t (&weight)[3]) {
    const irg::subpixel centre{x * 256 + 128, y * 256 + 128};
    int sign[3];
    for (int i = 0; i < 3; ++i) {
      const irg::subpixel &a = t.v[(i + 1) % 3].position, &b = t.v[(i + 2) % 3].position;
      const std::int64_t dx = std::int64_t{b.x} - a.x, dy = std::int64_t{b.y} - a.y;
      const std::int64_t side = dx * (std::int64_t{centre.y} - a.y) - dy * (std::int64_t{centre.x} - a.x);
      const std::int64_t moved = side != 0 ? side : dy != 0 ? -dy : dx;  // at c + (e, e^2)
      sign[i] = moved > 0 ? 1 : moved < 0 ? -1 : 0;
      weight[i] = side < 0 ? -side : side;
    }
    return sign[0] != 0 && sign[0] == sign[1] && sign[1] == sign[2];
  }

private:
  struct candidate {
    std::uint32_t id = 0;
    exact_depth depth;
  };
  struct candidates {
    candidate nearest, second;
  };

  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
  }
  // Whether a is seen before b.
  static bool comes_first(const candidate& a, const candidate& b) {
    if (b.id == 0) return true;
    const int order = exact_depth::compare(a.depth, b.depth) * (Order::nearer(1.0f, 0.0f) ? -1 : 1);
    return order < 0 || (order == 0 && a.id < b.id);
  }
  void add(const snapped_triangle& t, int x, int y) {
    std::int64_t weight[3];
    if (!covers(t, x, y, weight)) return;
    const candidate now{t.id, exact_depth(weight, t.v)};
    if (exact_depth::compare(now.depth, exact_depth(Order::farthest)) == 0) return;
    candidates& c = pixels_[index(x, y)];
    if (comes_first(now, c.nearest)) {
      if (c.nearest.id != t.id) c.second = c.nearest;
      c.nearest = now;
    } else if (c.nearest.id != t.id && comes_first(now, c.second)) {
      c.second = now;
    }
  }

  std::vector<snapped_triangle> triangles_;
  int width_;
  std::vector<candidates> pixels_;
};

}  // namespace test
