// SPDX-License-Identifier: MIT
// Phong shading of a register of points at once: the light that phong_shader gives one by one, bit for bit. Lengths
// that are not of moderate size are left to it.
#pragma once

#include <vector>

#include <irg/core/interleaved_lanes.hpp>
#include <irg/core/lanes.hpp>
#include <irg/math/hypot.hpp>
#include <irg/math/length.hpp>
#include <irg/shade/per_channel.hpp>
#include <irg/shade/shading.hpp>

namespace irg {

namespace detail::inline IRG_ABI {

// Lengths and dot products of registers of vectors, rounded as length and dot round those of one.

template <int N>
IRG_INLINE pack<double, N> dot_of(const triple_lanes<double, N>& a, const triple_lanes<double, N>& b) noexcept {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <int N>
IRG_INLINE triple_lanes<double, N> divided(const triple_lanes<double, N>& a, const pack<double, N>& by) noexcept {
  return {a.x / by, a.y / by, a.z / by};
}

/// Where length_of is right: the greatest coordinate is from 2^-100 to 2^100.
template <int N>
IRG_INLINE mask_of_lanes<double, N> is_moderate(const triple_lanes<double, N>& v) noexcept {
  using F = pack<double, N>;
  using f = lanes<F>;
  const F x = magnitude(v.x), y = magnitude(v.y), z = magnitude(v.z), most = f::broadcast(0x1p100);
  return (x <= most) & (y <= most) & (z <= most) & (f::broadcast(0x1p-100) <= maximum(x, maximum(y, z)));
}

/// The lengths of vectors of moderate size, as hypot of three.
template <int N>
IRG_INLINE pack<double, N> length_of(const triple_lanes<double, N>& v) noexcept {
  using F = pack<double, N>;
  const F x = magnitude(v.x), y = magnitude(v.y), z = magnitude(v.z), square = sum_of_squares(x, y, z);
  return hypot_from_root(square, square_root_instruction(square), x, y, z);
}

}  // namespace detail::inline IRG_ABI

/// phong_shader made ready for registers: what is the same at all points is worked out once.
/// needs   a shader of doubles, whose lights outlive it and do not change
template <Floating T>
class phong_lanes {
public:
  IRG_APART constexpr explicit phong_lanes(const phong_shader<T>& shader) : shader_(shader) {
    const auto share = [](const rgb<T>& ii, const rgb<T>& k) {
      return per_channel([](T i, T reflected) { return product(i, reflected); }, ii, k);
    };
    exponent_ = detail::small_integer(shader.surface.shininess);
    ambient_ = ambient_term(shader.light.ambient, shader.surface.ambient);
    for (const light<T>& source : shader.light.lights) {
      const rgb<T> specular = share(source.intensity, shader.surface.specular);
      const bool at_infinity = source.position.w == 0;
      const vec<T, 3> direction = normalized(direction_to_light(source, point<T, 3>{0, 0, 0}));
      for (const rgb<T>* c : {&source.intensity, &shader.surface.diffuse, &shader.surface.specular})
        is_bounded_ = is_bounded_ && is_bounded(c->r) && is_bounded(c->g) && is_bounded(c->b);
      lights_.push_back({source, direction, share(source.intensity, shader.surface.diffuse), specular, at_infinity,
                         specular == rgb<T>{0, 0, 0} && !(shader.light.distance == distance_term::viewer)});
    }
  }

  /// The light at N points with normals of any length. Of points that are not needed, by a bit each, anything.
  /// exact   the shader's own for each of them
  /// cost    two roots and eight divisions a register for one light at infinity, and a few dozen products; N calls of
  ///         the shader where a vector's greatest coordinate is not from 2^-100 to 2^100, and where an intensity or a
  ///         share that is reflected is more than 2^200
  template <int N>
    requires std::same_as<T, double>
  IRG_INLINE rgb<pack<double, N>> operator()(const triple_lanes<double, N>& p, const triple_lanes<double, N>& normal,
                                             unsigned needed = ~0u) const {
    using F = pack<double, N>;
    using f = lanes<F>;
    const point<T, 3>& eye = shader_.eye;
    const triple_lanes<double, N> to_eye{f::broadcast(eye.x) - p.x, f::broadcast(eye.y) - p.y,
                                         f::broadcast(eye.z) - p.z};
    typename f::mask moderate = detail::is_moderate(to_eye) & detail::is_moderate(normal);
    const F r = detail::length_of(to_eye);
    const triple_lanes<double, N> n = detail::divided(normal, detail::length_of(normal)),
                                  v = detail::divided(to_eye, r);
    const view_of<N> seen{n, v, r};
    rgb<F> sum{f::broadcast(ambient_.r), f::broadcast(ambient_.g), f::broadcast(ambient_.b)};
    for (const prepared_light& l : lights_) {
      triple_lanes<double, N> to_light{f::broadcast(l.direction.x), f::broadcast(l.direction.y),
                                       f::broadcast(l.direction.z)};
      if (!l.at_infinity) {
        const triple_lanes<double, N> d = direction_from(l.source.position, p);
        moderate = moderate & detail::is_moderate(d);
        to_light = detail::divided(d, detail::length_of(d));
      }
      add_light(sum, l, to_light, seen);
    }
    return is_bounded_ && (~mask_bits(moderate) & needed & ((1u << N) - 1)) == 0 ? sum : one_by_one<N>(p, normal);
  }

private:
  // Of a number that is, no product with others becomes infinite, which 0 would not take out again.
  IRG_INLINE static constexpr bool is_bounded(T x) noexcept { return T(-0x1p200) <= x && x <= T(0x1p200); }

  struct prepared_light {
    light<T> source;
    vec<T, 3> direction;  // of length 1, where it is at infinity
    rgb<T> diffuse, specular;  // the light that is reflected in full
    bool at_infinity, dull;  // dull: no highlight
  };

  template <int N>
  IRG_INLINE static triple_lanes<double, N> direction_from(const hpoint<T, 3>& s,
                                                           const triple_lanes<double, N>& p) noexcept {
    using f = lanes<pack<double, N>>;
    const auto w = f::broadcast(s.w);
    const triple_lanes<double, N> d{f::broadcast(s.x) - w * p.x, f::broadcast(s.y) - w * p.y,
                                    f::broadcast(s.z) - w * p.z};
    return s.w < 0 ? triple_lanes<double, N>{-d.x, -d.y, -d.z} : d;
  }

  // The normal, the direction to the viewer, and how far away that is.
  template <int N>
  struct view_of {
    triple_lanes<double, N> n, v;
    pack<double, N> r;
  };

  // The bracket of reflected_light, times the light.
  template <int N>
  IRG_APART IRG_INLINE void add_light(rgb<pack<double, N>>& sum, const prepared_light& l,
                                      const triple_lanes<double, N>& to_light, const view_of<N>& seen) const {
    const auto& [n, v, r] = seen;
    using F = pack<double, N>;
    using f = lanes<F>;
    const F zero = f::broadcast(0), ln = detail::dot_of(to_light, n);
    const auto lit = zero < ln;
    if (no_lane(lit)) return;  // zeros would be added
    const F cosine = select(lit, ln, zero);
    F factor = zero;
    if (!l.dull) {
      const F twice = ln + ln;
      const triple_lanes<double, N> mirrored{n.x * twice - to_light.x, n.y * twice - to_light.y,
                                             n.z * twice - to_light.z};
      const F rv = detail::dot_of(mirrored, v);
      factor = select(both(lit, zero < rv), power_of(rv), zero);
    }
    const bool weakened = shader_.light.distance == distance_term::viewer;
    const F away = weakened ? r + f::broadcast(shader_.light.k) : zero;
    const auto channel = [&](F& to, double ii, double kd, double ks, double diffuse, double specular) {
      if (weakened) {
        const F arriving = f::broadcast(ii) / away;
        to = to + ((arriving * f::broadcast(kd)) * cosine + (arriving * f::broadcast(ks)) * factor);
      } else if (l.dull) {
        to = to + f::broadcast(diffuse) * cosine;
      } else {
        to = to + (f::broadcast(diffuse) * cosine + f::broadcast(specular) * factor);
      }
    };
    const rgb<T>&ii = l.source.intensity, &kd = shader_.surface.diffuse, &ks = shader_.surface.specular;
    channel(sum.r, ii.r, kd.r, ks.r, l.diffuse.r, l.specular.r);
    channel(sum.g, ii.g, kd.g, ks.g, l.diffuse.g, l.specular.g);
    channel(sum.b, ii.b, kd.b, ks.b, l.diffuse.b, l.specular.b);
  }

  // As specular_factor's: squared again and again for whole numbers.
  template <class F>
  [[nodiscard]] IRG_APART IRG_INLINE F power_of(F x) const {
    using f = lanes<F>;
    if (exponent_ < 0)
      return f::generate([&](int i) { return 0 < x[i] ? pow(minimum(x[i], 1.0), shader_.surface.shininess) : 0.0; });
    F power = f::broadcast(1);
    for (int n = exponent_; n > 0; n /= 2) {
      if (n % 2 != 0) power = power * x;
      if (n > 1) x = x * x;
    }
    return power;
  }

  template <int N>
  IRG_APART IRG_NOINLINE rgb<pack<double, N>> one_by_one(const triple_lanes<double, N>& p,
                                                         const triple_lanes<double, N>& normal) const {
    rgb<pack<double, N>> light;
    for (int i = 0; i < N; ++i) {
      const rgb<T> one = shader_({p.x[i], p.y[i], p.z[i]}, {normal.x[i], normal.y[i], normal.z[i]});
      set_lane(light.r, i, one.r);
      set_lane(light.g, i, one.g);
      set_lane(light.b, i, one.b);
    }
    return light;
  }

  phong_shader<T> shader_;
  rgb<T> ambient_{};
  std::vector<prepared_light> lights_{};
  int exponent_ = 0;
  bool is_bounded_ = true;  // intensities and what is reflected of them
};

}  // namespace irg
