// SPDX-License-Identifier: MIT
// Which of two faces is nearer at a pixel's centre, told another way than the library does: the upright line through the
// centre is cut with the plane by its normal, in long double, and in rationals where that leaves a doubt. And pairs of
// faces of every difficulty.
#pragma once

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include <irg/raster/screen_face.hpp>

#include "big_rational.hpp"
#include "exact.hpp"
#include "random.hpp"

namespace test {

/// How deep the plane of a face is above the centre of a pixel: z0 - (nx (x - x0) + ny (y - y0)) / nz.
/// needs   a face with area
template <class T>
struct plane_depth_by_normal {
  T depth, size;  // size: the same with all terms positive
  plane_depth_by_normal(const irg::screen_face& f, int px, int py) {
    const auto number = [](auto v) { return T(static_cast<double>(v)); };
    const irg::screen_vertex &o = f.v[0], &p = f.v[1], &q = f.v[2];
    const T x = number(px * 256.0 + 128) - number(o.position.x), y = number(py * 256.0 + 128) - number(o.position.y);
    const T px1 = number(p.position.x) - number(o.position.x), py1 = number(p.position.y) - number(o.position.y);
    const T qx1 = number(q.position.x) - number(o.position.x), qy1 = number(q.position.y) - number(o.position.y);
    const T z = number(o.depth), pz = number(p.depth) - z, qz = number(q.depth) - z;
    const T nz = px1 * qy1 - py1 * qx1;
    depth = z - ((py1 * qz - pz * qy1) * x + (pz * qx1 - px1 * qz) * y) / nz;
    const auto a = [](const T& v) { return v < T(0) ? T(-v) : v; };
    size = a(z) + ((a(py1) * a(qz) + a(pz) * a(qy1)) * a(x) + (a(pz) * a(qx1) + a(px1) * a(qz)) * a(y)) / a(nz);
  }
};

struct depth_verdict {
  int sign = 0;  // 1 where a is the deeper number
  bool known = true;  // false where only rationals would tell, and there are none
  bool close = false;  // long double could not tell
};

/// needs   faces with area
inline depth_verdict compare_by_normals(const irg::screen_face& a, const irg::screen_face& b, int x, int y) {
  // nz is made of products of integers below 2^62, exact in 64 bits and within 2^-51 of some part of it in 53: then
  // nothing is decided here. All else is off by at most 12 roundings of each size.
  if constexpr (std::numeric_limits<long double>::digits >= 64) {
    const plane_depth_by_normal<long double> da(a, x, y), db(b, x, y);
    const long double difference = da.depth - db.depth, doubt = 0x1p-59L * (da.size + db.size);
    if (difference > doubt) return {1};
    if (difference < -doubt) return {-1};
  }
#ifdef IRG_HAVE_MPFR
  const plane_depth_by_normal<big_rational> da(a, x, y), db(b, x, y);
  return {da.depth < db.depth ? -1 : db.depth < da.depth ? 1 : 0, true, true};
#else
  return {0, false, true};
#endif
}

/// Two faces and a pixel.
struct face_pair {
  irg::screen_face a, b;
  int x, y;
};

enum class face_pairs {
  apart,  // nothing in common
  edge,  // two corners in common
  corner,  // one
  coplanar,  // in one plane, exactly
  nearly_coplanar,  // one depth is off by a unit in its last place
  same,  // the same triangle, from another corner or the other way round
  edge_on  // one has no area
};
inline constexpr int face_pair_kinds = 7;

/// Pairs of faces of all kinds, with depths of all kinds, from small ones to the limit of positions.
class face_pair_maker {
public:
  explicit face_pair_maker(std::uint64_t seed) : random_(seed) {}

  face_pair next(face_pairs kind) {
    const int reach_bits = pick(extents), reach = 1 << reach_bits;
    depths_ = all_spreads[random_.integer(0, 6)];
    irg::screen_vertex p[3], q[3];
    for (int i = 0; i < 3; ++i) p[i] = corner(reach), q[i] = corner(reach);
    if (kind == face_pairs::edge) q[0] = p[1], q[1] = p[0];
    if (kind == face_pairs::corner) q[0] = p[0];
    if (kind == face_pairs::coplanar || kind == face_pairs::nearly_coplanar) into_one_plane(p, q);
    if (kind == face_pairs::nearly_coplanar)
      p[0].depth = std::nextafter(p[0].depth, random_.integer(0, 1) == 0 ? -1e30f : 1e30f);
    if (kind == face_pairs::same) {
      const auto first = static_cast<std::size_t>(random_.integer(0, 2));
      const std::size_t step = random_.integer(0, 1) == 0 ? 1 : 2;
      for (std::size_t i = 0; i < 3; ++i) q[i] = p[(first + i * step) % 3];
    }
    if (kind == face_pairs::edge_on) q[2].position = q[random_.integer(0, 1)].position;
    const auto numbers = static_cast<std::uint32_t>(random_.integer(0, 1));
    face_pair pair{irg::make_screen_face(p[0], p[1], p[2], numbers),
                   irg::make_screen_face(q[0], q[1], q[2], 1 - numbers), 0, 0};
    const std::int64_t last = reach_bits >= 29 ? irg::snap_limit : (reach >> 7) + 2;
    pair.x = static_cast<int>(random_.integer(-last, last - 1));
    pair.y = static_cast<int>(random_.integer(-last, last - 1));
    return pair;
  }

private:
  static constexpr int extents[] = {4, 8, 12, 16, 20, 24, 29};
  template <std::size_t N>
  int pick(const int (&of)[N]) {
    return of[static_cast<std::size_t>(random_.integer(0, static_cast<std::int64_t>(N) - 1))];
  }
  irg::screen_vertex corner(int reach) {
    return {{static_cast<std::int32_t>(random_.integer(-reach, reach)),
             static_cast<std::int32_t>(random_.integer(-reach, reach))},
            any_coordinate<float>(random_, depths_)};
  }
  // Depths are integers below 2^24 times a power of two.
  void into_one_plane(irg::screen_vertex (&p)[3], irg::screen_vertex (&q)[3]) {
    const std::int64_t right = random_.integer(-100, 100), down = random_.integer(-100, 100),
                       origin = random_.integer(-(1 << 22), 1 << 22);
    const int scale = static_cast<int>(random_.integer(-149, 100));
    for (irg::screen_vertex* v : {p, p + 1, p + 2, q, q + 1, q + 2}) {
      v->position.x %= 1 << 16;
      v->position.y %= 1 << 16;
      v->depth = static_cast<float>(
          std::ldexp(static_cast<double>(right * v->position.x + down * v->position.y + origin), scale));
    }
  }

  random random_;
  spread depths_ = spread::unit;
};

}  // namespace test
