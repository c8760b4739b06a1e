// SPDX-License-Identifier: MIT
// Arrays of points through one matrix: the results of transform_point and of the operator *, bit for bit, in a fraction
// of their time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include <irg/core/contract.hpp>
#include <irg/core/interleaved_lanes.hpp>
#include <irg/math/detail/coordinate_rows_kernel.hpp>
#include <irg/math/mat.hpp>

namespace irg {

/// Points whose coordinates stand in arrays of their own: point i is (x[i], y[i], z[i]).
/// shape   three spans of one size
template <class T>
struct point_streams {
  std::span<T> x, y, z;
  [[nodiscard]] IRG_INLINE constexpr std::size_t size() const noexcept { return x.size(); }
};

inline namespace IRG_ABI {

/// The images of positions under an affine matrix, whose last row is not read: out[i] = transform_point(a, points[i]).
/// shape   arrays of irg's points or of other types that are three floats or doubles in a row
/// needs   arrays of one size; `out` begins where `points` does or does not overlap them
/// exact   the bits of transform_point
/// cost    9 products and 9 sums a point in the widest registers; from about 10^5 points on, memory decides
template <class T, class A, class B>
  requires(Point<detail::element_of<const A>> && detail::Triple<detail::element_of<const A>> &&
           std::same_as<detail::element_of<const A>, detail::element_of<B>>)
constexpr void transform_points(const mat<T, 4, 4>& a, const A& points, B&& out) noexcept;

/// The images of displacements under an affine matrix: out[i] = transform_vector(a, vectors[i]).
/// needs   as transform_points
/// exact   the bits of transform_vector
template <class T, class A, class B>
  requires(Vector<detail::element_of<const A>> && detail::Triple<detail::element_of<const A>> &&
           std::same_as<detail::element_of<const A>, detail::element_of<B>>)
constexpr void transform_vectors(const mat<T, 4, 4>& a, const A& vectors, B&& out) noexcept;

/// The images of positions in streams under an affine matrix.
/// needs   six spans of one size; each of `out` begins where its like of `points` does or overlaps none of them
/// exact   the bits of transform_point
template <Floating T>
constexpr void transform_points(const mat<T, 4, 4>& a, std::type_identity_t<point_streams<const T>> points,
                                std::type_identity_t<point_streams<T>> out) noexcept;

/// The images of positions under a matrix that may be projective: out[i] = a * points[i].
/// needs   spans of one size that do not overlap
/// exact   the bits of the operator *
template <Floating T>
constexpr void transform_points(const mat<T, 4, 4>& a, std::type_identity_t<std::span<const point<T, 3>>> points,
                                std::type_identity_t<std::span<hpoint<T, 3>>> out) noexcept;

/// The images of homogeneous points: out[i] = a * points[i].
/// needs   spans of one size; `out` begins where `points` does or does not overlap them
/// exact   the bits of the operator *
template <Floating T>
constexpr void transform_points(const mat<T, 4, 4>& a, std::type_identity_t<std::span<const hpoint<T, 3>>> points,
                                std::type_identity_t<std::span<hpoint<T, 3>>> out) noexcept;

}  // namespace IRG_ABI

namespace detail::inline IRG_ABI {

// Arrays of positions through one matrix, a register of them at a time. Bit for bit what transform_point and the
// operators * give one by one.

// The upper three rows of a matrix, each entry in all lanes.
template <class T, int N>
struct affine_lanes {
  pack<T, N> m[3][4];
  IRG_INLINE explicit affine_lanes(const mat<T, 4, 4>& a) noexcept {
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 4; ++c) m[r][c] = lanes<pack<T, N>>::broadcast(a(r, c));
  }
  // The image of N positions, or of N displacements (three columns).
  template <int Columns>
  IRG_INLINE triple_lanes<T, N> image(const triple_lanes<T, N>& p) const noexcept {
    const auto row = [&](int r) {
      const auto sum = (m[r][0] * p.x + m[r][1] * p.y) + m[r][2] * p.z;
      if constexpr (Columns == 4)
        return sum + m[r][3];
      else
        return sum;
    };
    return {row(0), row(1), row(2)};
  }
};

// Sixteen triples of floats that stay interleaved: lane i of register g is coordinate (16 g + i) % 3 of a point, so the
// entries of the matrix are laid out like that, and x, y and z of the point are brought to each of its lanes. That
// takes nine shuffles where sorting and putting back take twelve.
struct interleaved_affine {
  using F = pack<float, 16>;
  F m[3][4];
  IRG_INLINE explicit interleaved_affine(const mat<float, 4, 4>& a) noexcept {
    for (int g = 0; g < 3; ++g)
      for (int c = 0; c < 4; ++c)
        for (int i = 0; i < 16; ++i) set_lane(m[g][c], i, a((16 * g + i) % 3, c));
  }
  // Coordinate k of the point that each lane of register g belongs to; it stands in registers r[g - 1] to r[g + 1].
  template <int Register, int Coordinate>
  IRG_INLINE static F coordinate_of_lanes(const F (&r)[3]) noexcept {
    constexpr int g = Register, k = Coordinate, low = (16 * g / 3 * 3 + k) / 16;
    constexpr int high = (16 * g + 15) / 3 * 3 + k < 16 * (low + 1) ? low : low + 1;
    return shuffled_by<16>(r[low], r[high], [](int i) { return (16 * g + i) / 3 * 3 + k - 16 * low; });
  }
  template <int Columns, int Register>
  IRG_INLINE F image(const F (&r)[3]) const noexcept {
    constexpr int g = Register;
    const F sum = (m[g][0] * coordinate_of_lanes<g, 0>(r) + m[g][1] * coordinate_of_lanes<g, 1>(r)) +
                  m[g][2] * coordinate_of_lanes<g, 2>(r);
    if constexpr (Columns == 4)
      return sum + m[g][3];
    else
      return sum;
  }
  template <int Columns, class Store>
  IRG_INLINE void transform(const float* p, float* out, const Store& store) const noexcept {
    const F r[3] = {lanes<F>::load(p), lanes<F>::load(p + 16), lanes<F>::load(p + 32)};
    const F image0 = image<Columns, 0>(r), image1 = image<Columns, 1>(r), image2 = image<Columns, 2>(r);
    store(out, image0);
    store(out + 16, image1);
    store(out + 32, image2);
  }
};

// How many numbers to deal with one by one until `out` stands at a multiple of a register, in steps of Stride numbers:
// stores that straddle two cache lines take twice their time. None for short arrays, where it does not pay.
template <int Stride, class T>
IRG_INLINE std::size_t steps_to_aligned(const T* out, std::size_t n) noexcept {
  constexpr std::size_t step = Stride * sizeof(T), bytes = static_cast<std::size_t>(widest_bytes);
  if (n < 256) return 0;
  const std::size_t at = reinterpret_cast<std::uintptr_t>(out) % bytes;
  std::size_t steps = 0;
  while (steps < bytes / sizeof(T) && (at + steps * step) % bytes != 0) ++steps;
  return steps == bytes / sizeof(T) ? 0 : steps;
}

// How a register gets into memory: through the caches, or past them.
struct store_as_usual {
  template <class T, int N>
  IRG_INLINE void operator()(T* p, const pack<T, N>& f) const noexcept {
    lanes<pack<T, N>>::store(p, f);
  }
  IRG_INLINE static void ask_for(const void*) noexcept {}
};
// needs   p at a multiple of the register's size; end_of_streams() before anybody else may look
struct store_past_caches {
  template <class T, int N>
  IRG_INLINE void operator()(T* p, const pack<T, N>& f) const noexcept {
    stream(p, f);
  }
  // What is read soon.
  IRG_INLINE static void ask_for(const void* p) noexcept { prefetch(p, 1536); }
};

// From this size of the result on it does not stay in a core's own cache anyway: writing past the caches spares reading
// what is written over.
inline constexpr std::size_t bytes_past_caches = std::size_t{8} << 20;

// Calls one(i) for each i below n; in between, all(i, store) for `Count` of them from i on.
// shape   out, out1, out2 are where the results go, Stride numbers each
template <int Count, int Stride, class T, class One, class All>
IRG_INLINE void in_registers(const T* from, const T* out, const T* out1, const T* out2, std::size_t n, const One& one,
                             const All& all) noexcept {
  constexpr std::size_t count = static_cast<std::size_t>(Count);
  const std::size_t first = steps_to_aligned<Stride>(out, n);
  std::size_t i = 0;
  for (; i < first; ++i) one(i);
  const auto is_aligned = [&](const T* p) {
    return reinterpret_cast<std::uintptr_t>(p + Stride * first) % static_cast<std::uintptr_t>(widest_bytes) == 0;
  };
  if (has_streaming_stores && 3 * n * sizeof(T) >= bytes_past_caches && from != out && is_aligned(out) &&
      is_aligned(out1) && is_aligned(out2)) {
    for (; i + count <= n; i += count) all(i, store_past_caches{});
    end_of_streams();
  }
  for (; i + count <= n; i += count) all(i, store_as_usual{});
  for (std::size_t rest = (n - i) % count; rest != 0; --rest, ++i) one(i);
}

// n triples from p to out: positions (Columns 4) or displacements (3), one(i) where a register is not full.
template <int Columns, class T, class One>
void transform_triples_in_lanes(const mat<T, 4, 4>& a, const T* p, T* out, std::size_t n, const One& one) noexcept {
  constexpr int count = widest_lanes<T>;
  if constexpr (std::is_same_v<T, float> && count == 16) {
    const interleaved_affine image(a);
    in_registers<count, 3>(p, out, out, out, n, one, [&](std::size_t i, auto store) IRG_INLINE_LAMBDA {
      for (int k = 0; k < 3; ++k) store.ask_for(p + 3 * i + 16 * k);
      image.transform<Columns>(p + 3 * i, out + 3 * i, store);
    });
  } else {
    const affine_lanes<T, count> m(a);
    in_registers<count, 3>(p, out, out, out, n, one, [&](std::size_t i, auto store) IRG_INLINE_LAMBDA {
      for (int k = 0; k < 3; ++k) store.ask_for(p + 3 * i + count * k);
      store_triples(out + 3 * i, m.template image<Columns>(load_triples<count>(p + 3 * i)), store);
    });
  }
}

template <class T, class One>
void transform_streams_in_lanes(const mat<T, 4, 4>& a, const T* const (&p)[3], T* const (&out)[3], std::size_t n,
                                const One& one) noexcept {
  constexpr int count = widest_lanes<T>;
  using F = lanes<pack<T, count>>;
  const affine_lanes<T, count> m(a);
  in_registers<count, 1>(p[0], out[0], out[1], out[2], n, one, [&](std::size_t i, auto store) IRG_INLINE_LAMBDA {
    for (int k = 0; k < 3; ++k) store.ask_for(p[k] + i);
    const auto image = m.template image<4>({F::load(p[0] + i), F::load(p[1] + i), F::load(p[2] + i)});
    store(out[0] + i, image.x);
    store(out[1] + i, image.y);
    store(out[2] + i, image.z);
  });
}

// n positions of Stride coordinates, 3 that stand for weight 1 or 4, to four coordinates each.
template <int Stride, class T, class One>
void project_points_in_lanes(const mat<T, 4, 4>& a, const T* p, T* out, std::size_t n, const One& one) noexcept {
  constexpr int count = 4 * rows_per_register<T>;
  constexpr std::size_t stride = Stride, rows = static_cast<std::size_t>(rows_per_register<T>);
  using F = lanes<pack<T, count>>;
  const mat<T, 4, 4> columns = transpose(a);
  pack<T, count> column[4];
  for (int k = 0; k < 4; ++k) column[k] = repeat_row<count>(columns.m[k]);
  const std::size_t first = steps_to_aligned<4>(out, n);
  std::size_t i = 0;
  for (; i < first; ++i) one(i);
  // The register that the coordinates come in may hold more than the last point.
  for (; stride * i + static_cast<std::size_t>(count) <= stride * n; i += rows) {
    const auto from = F::load(p + stride * i);
    const auto times = [&]<int K>(std::integral_constant<int, K>) {
      return column[K] * shuffled_by<count>(from, [](int lane) { return lane / 4 * Stride + K; });
    };
    const auto sum = (times(std::integral_constant<int, 0>{}) + times(std::integral_constant<int, 1>{})) +
                     times(std::integral_constant<int, 2>{});
    if constexpr (Stride == 4)
      F::store(out + 4 * i, sum + times(std::integral_constant<int, 3>{}));
    else
      F::store(out + 4 * i, sum + column[3]);
  }
  for (; i < n; ++i) one(i);
}

// What constant evaluation and machines without lanes do: one(i) for each.
template <class T, class One>
constexpr void transform_streams(const mat<T, 4, 4>& a, const T* const (&p)[3], T* const (&out)[3], std::size_t n,
                                 const One& one) noexcept {
  if (has_lanes && !std::is_constant_evaluated()) return transform_streams_in_lanes(a, p, out, n, one);
  for (std::size_t i = 0; i < n; ++i) one(i);
}
template <int Stride, class T, class One>
constexpr void project_points(const mat<T, 4, 4>& a, const T* p, T* out, std::size_t n, const One& one) noexcept {
  if constexpr (has_row_lanes<T>)
    if (!std::is_constant_evaluated()) return project_points_in_lanes<Stride>(a, p, out, n, one);
  for (std::size_t i = 0; i < n; ++i) one(i);
}

// to[i] = one(from[i]) for positions (Coordinates = 4) or displacements (3).
template <int Coordinates, class T, class From, class To, class One>
constexpr void transform_rows(const mat<T, 4, 4>& a, From from, To to, const One& one) noexcept {
  IRG_EXPECTS(from.size() == to.size());
  if (from.empty()) return;
  const auto each = [&](std::size_t i) { to[i] = one(from[i]); };
  by_rows(
      from.size(), each, [&](auto* p, auto* q) { transform_triples_in_lanes<Coordinates>(a, p, q, from.size(), each); },
      from[0], to[0]);
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

template <class T, class A, class B>
  requires(Point<detail::element_of<const A>> && detail::Triple<detail::element_of<const A>> &&
           std::same_as<detail::element_of<const A>, detail::element_of<B>>)
constexpr void transform_points(const mat<T, 4, 4>& a, const A& points, B&& out) noexcept {
  detail::transform_rows<4>(a, std::span(points), std::span(out), [&](const auto& p) { return transform_point(a, p); });
}

template <class T, class A, class B>
  requires(Vector<detail::element_of<const A>> && detail::Triple<detail::element_of<const A>> &&
           std::same_as<detail::element_of<const A>, detail::element_of<B>>)
constexpr void transform_vectors(const mat<T, 4, 4>& a, const A& vectors, B&& out) noexcept {
  detail::transform_rows<3>(a, std::span(vectors), std::span(out),
                            [&](const auto& v) { return transform_vector(a, v); });
}

template <Floating T>
constexpr void transform_points(const mat<T, 4, 4>& a, std::type_identity_t<point_streams<const T>> points,
                                std::type_identity_t<point_streams<T>> out) noexcept {
  IRG_EXPECTS(points.y.size() == points.size() && points.z.size() == points.size());
  IRG_EXPECTS(out.x.size() == points.size() && out.y.size() == points.size() && out.z.size() == points.size());
  const T* const from[] = {points.x.data(), points.y.data(), points.z.data()};
  T* const to[] = {out.x.data(), out.y.data(), out.z.data()};
  detail::transform_streams(a, from, to, points.size(), [&](std::size_t i) {
    const point<T, 3> image = transform_point(a, point<T, 3>{from[0][i], from[1][i], from[2][i]});
    for (int k = 0; k < 3; ++k) to[k][i] = image[k];
  });
}

template <Floating T>
constexpr void transform_points(const mat<T, 4, 4>& a, std::type_identity_t<std::span<const point<T, 3>>> points,
                                std::type_identity_t<std::span<hpoint<T, 3>>> out) noexcept {
  IRG_EXPECTS(points.size() == out.size());
  if (points.empty()) return;
  detail::project_points<3>(a, &points[0].x, &out[0].x, points.size(), [&](std::size_t i) { out[i] = a * points[i]; });
}

template <Floating T>
constexpr void transform_points(const mat<T, 4, 4>& a, std::type_identity_t<std::span<const hpoint<T, 3>>> points,
                                std::type_identity_t<std::span<hpoint<T, 3>>> out) noexcept {
  IRG_EXPECTS(points.size() == out.size());
  if (points.empty()) return;
  detail::project_points<4>(a, &points[0].x, &out[0].x, points.size(), [&](std::size_t i) { out[i] = a * points[i]; });
}

}  // namespace IRG_ABI
}  // namespace irg
