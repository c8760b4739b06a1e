// SPDX-License-Identifier: MIT
#include <irg/raster/face_order.hpp>

#include <cstdlib>
#include <vector>

#include <irg/geometry/orient3d.hpp>
#include <irg/math/vec.hpp>
#include <irg/raster/draw_triangle.hpp>
#include <irg/raster/image.hpp>

#include "support/check_both.hpp"
#include "support/face_oracle.hpp"
#include "support/flush_mode.hpp"

namespace {

using irg::compare_depths;
using irg::drawing_order;
using irg::is_nearer;
using irg::screen_face;
using irg::side_of_face;
using greater = irg::nearer_is_greater;
using less = irg::nearer_is_less;

constexpr screen_face face(irg::subpixel a, irg::subpixel b, irg::subpixel c, float da, float db, float dc,
                           std::uint32_t number = 0) {
  return irg::make_screen_face({a, da}, {b, db}, {c, dc}, number);
}
constexpr screen_face level(float depth, std::uint32_t number = 0) {
  return face({0, 0}, {4096, 0}, {0, 4096}, depth, depth, depth, number);
}

TEST_CASE("compare_depths: by hand") {
  CHECK_BOTH(compare_depths(level(0.5f), level(0.25f), 3, 3) == 1);
  CHECK_BOTH(compare_depths<less>(level(0.5f), level(0.25f), 3, 3) == -1);
  CHECK_BOTH(compare_depths(level(0.5f), level(0.5f), 3, 3) == 0);
  CHECK_BOTH(compare_depths(level(-0.0f), level(0.0f), 3, 3) == 0);
  // A slope of 1/4096 per 1/256 pixel passes 1/2 + 128/4096 in the middle of pixel 8.
  constexpr screen_face slope = face({0, 0}, {4096, 0}, {0, 4096}, 0.0f, 1.0f, 0.0f);
  constexpr screen_face half = level(0.53125f);
  CHECK_BOTH(compare_depths(slope, half, 7, 2) == -1);
  CHECK_BOTH(compare_depths(slope, half, 8, 2) == 0);
  CHECK_BOTH(compare_depths(slope, half, 9, 2) == 1);
  CHECK_BOTH(compare_depths(slope, half, -100, 2) == -1);  // far outside of both
  // Turned round, a face has the same plane.
  CHECK_BOTH(compare_depths(face({0, 0}, {0, 4096}, {4096, 0}, 0.0f, 0.0f, 1.0f), half, 9, 2) == 1);
}

TEST_CASE("compare_depths: what no rounding decides") {
  // One unit in the last place of one corner, seen from afar; and less than any double tells.
  constexpr float more = 0x1.000002p0f;
  constexpr screen_face flat = level(1.0f), bent = face({0, 0}, {4096, 0}, {0, 4096}, 1.0f, 1.0f, more);
  CHECK_BOTH(compare_depths(bent, flat, 0, 0) == 1);
  CHECK_BOTH(compare_depths(bent, flat, 0, -1) == -1);
  constexpr int far = irg::snap_limit * irg::one_pixel;
  constexpr screen_face wide = face({-far, -far}, {far, -far}, {-far, far}, 1.0f, 1.0f, 1.0f);
  constexpr screen_face hair = face({-far, -far}, {far, -far}, {-far, far}, 1.0f, 1.0f, more);
  CHECK_BOTH(compare_depths(hair, wide, 0, -irg::snap_limit) == 1);
  CHECK_BOTH(compare_depths(hair, wide, irg::snap_limit - 1, irg::snap_limit - 1) == 1);
  // Depths at both ends of the range of floats.
  constexpr float huge = 0x1.fffffep127f, tiny = 0x1p-149f;
  constexpr screen_face span = face({0, 0}, {4096, 0}, {0, 4096}, huge, -huge, tiny);
  CHECK_BOTH(compare_depths(span, level(0.0f), 0, 0) == 1);
  // On the line x = y of this one huge and -huge cancel, and the least float is left.
  constexpr screen_face cancel = face({0, 0}, {4096, 4096}, {4096, 0}, tiny, huge, -huge);
  constexpr screen_face mirror = face({0, 0}, {4096, 0}, {4096, 4096}, tiny, -huge, huge);
  CHECK_BOTH(compare_depths(cancel, mirror, 5, 3) == 0);
  CHECK_BOTH(compare_depths(level(tiny), level(0.0f), 0, 0) == 1);
  CHECK_BOTH(compare_depths<less>(level(-tiny), level(tiny), 0, 0) == 1);
}

TEST_CASE("compare_depths: faces without area and orders without depths") {
  constexpr screen_face line = face({0, 0}, {4096, 4096}, {8192, 8192}, 1.0f, 2.0f, 3.0f);
  CHECK_BOTH(compare_depths(line, level(0.5f), 1, 1) == 0);
  CHECK_BOTH(compare_depths(level(0.5f), line, 1, 1) == 0);
  CHECK_BOTH(compare_depths<drawing_order>(level(0.5f), level(0.25f), 1, 1) == 0);
}

TEST_CASE("is_nearer: equal depths go to the lower number, in drawing order all to the higher one") {
  CHECK_BOTH(is_nearer(level(0.5f, 7), level(0.25f, 3), 1, 1));
  CHECK_BOTH(!is_nearer<less>(level(0.5f, 7), level(0.25f, 3), 1, 1));
  CHECK_BOTH(is_nearer(level(0.5f, 3), level(0.5f, 7), 1, 1));
  CHECK_BOTH(!is_nearer(level(0.5f, 7), level(0.5f, 3), 1, 1));
  CHECK_BOTH(is_nearer<less>(level(0.5f, 3), level(0.5f, 7), 1, 1));
  CHECK_BOTH(!is_nearer(level(0.5f, 3), level(0.5f, 3), 1, 1));
  CHECK_BOTH(is_nearer<drawing_order>(level(0.25f, 7), level(0.5f, 3), 1, 1));
  CHECK_BOTH(!is_nearer<drawing_order>(level(0.5f, 3), level(0.25f, 7), 1, 1));
}

struct tally {
  long long wrong = 0, nearer = 0, farther = 0, equal = 0, close = 0, unknown = 0;
};

tally try_pairs(std::uint64_t seed, int count) {
  test::face_pair_maker make(seed);
  tally t;
  for (int i = 0; i < count; ++i) {
    const test::face_pair p = make.next(static_cast<test::face_pairs>(i % test::face_pair_kinds));
    const int got = compare_depths(p.a, p.b, p.x, p.y);
    test::depth_verdict due;
    if (p.a.coverage.double_area != 0 && p.b.coverage.double_area != 0)
      due = test::compare_by_normals(p.a, p.b, p.x, p.y);
    t.close += due.close;
    if (!due.known) {
      ++t.unknown;
      continue;
    }
    ++(due.sign > 0 ? t.nearer : due.sign < 0 ? t.farther : t.equal);
    const bool first = due.sign != 0 ? due.sign > 0 : p.a.number < p.b.number;
    t.wrong +=
        got != due.sign || is_nearer(p.a, p.b, p.x, p.y) != first ||
        (i % 16 < 2 &&
         (compare_depths<less>(p.a, p.b, p.x, p.y) != -due.sign || compare_depths(p.b, p.a, p.x, p.y) != -due.sign ||
          is_nearer<less>(p.b, p.a, p.x, p.y) != (due.sign != 0 ? due.sign > 0 : p.b.number < p.a.number)));
  }
  return t;
}

TEST_CASE("compare_depths, is_nearer: against rationals") {
  const int count = std::getenv("IRG_RELEASE_TIER") != nullptr ? 100'000'000 : 400'000;
  const tally t = try_pairs(401, count);
  MESSAGE(count, " pairs: ", t.nearer, " nearer, ", t.farther, " farther, ", t.equal, " equal; ", t.close,
          " left to rationals, ", t.unknown, " without answer");
  CHECK(t.wrong == 0);
  CHECK(t.nearer > count / 5);
  CHECK(t.farther > count / 5);
#ifdef IRG_HAVE_MPFR
  CHECK(t.equal > count / 5);
#endif
}

TEST_CASE("compare_depths: each stage by itself") {
  test::face_pair_maker make(409);
  long long wrong = 0, asked = 0, told_in_doubles = 0;
  for (int i = 0; i < test::trials(60'000); ++i) {
    const test::face_pair p = make.next(static_cast<test::face_pairs>(i % test::face_pair_kinds));
    if (p.a.coverage.double_area == 0 || p.b.coverage.double_area == 0) continue;
    const test::depth_verdict due = test::compare_by_normals(p.a, p.b, p.x, p.y);
    if (!due.known) continue;
    const irg::subpixel centre = irg::detail::centre_of(p.x, p.y);
    const auto a = irg::detail::plane_at(p.a, centre), b = irg::detail::plane_at(p.b, centre);
    const int in_doubles = irg::detail::rounded_sign(a, b);
    ++asked;
    told_in_doubles += in_doubles != 0;
    wrong += (in_doubles != 0 && in_doubles != due.sign) || irg::detail::exact_sign(a, b) != due.sign ||
             irg::detail::integer_sign<5>(a, b, 0) != due.sign;
  }
  CHECK(wrong == 0);
  CHECK(told_in_doubles > asked / 3);
}

TEST_CASE("compare_depths: a processor that takes subnormal numbers for zero decides the same") {
  test::face_pair_maker make(402);
  long long wrong = 0, decided = 0;
  for (int i = 0; i < test::trials(50'000); ++i) {
    const test::face_pair p = make.next(static_cast<test::face_pairs>(i % test::face_pair_kinds));
    const auto ask = [&p] {
      return compare_depths(p.a, p.b, p.x, p.y) + 3 * sign_of(side_of_face(p.a, p.b.v[0])) +
             9 * sign_of(side_of_face(p.b, p.a.v[1]));
    };
    const int due = ask();
    decided += due != 0;
    wrong += test::while_flushing(ask) != due;
  }
  CHECK(wrong == 0);
  CHECK(decided > test::trials(20'000));
}

// ---- rounded depths at hand

float rounded_depth(const screen_face& f, int x, int y) { return irg::depth_at(irg::set_up_face(f), x, y); }

TEST_CASE("compare_depths: with rounded depths at hand, the same") {
  test::random r(403);
  test::face_pair_maker make(404);
  long long asked = 0, by_floats = 0, wrong = 0;
  for (int i = 0; i < test::trials(400'000); ++i) {
    test::face_pair p = make.next(static_cast<test::face_pairs>(i % 6));
    for (screen_face* f : {&p.a, &p.b}) {  // with every third as it is, of both signs
      if (i % 3 != 0)
        for (irg::screen_vertex& v : f->v) v.depth = std::fabs(v.depth);
      *f = irg::make_screen_face(f->v[0], f->v[1], f->v[2], f->number);
    }
    // A pixel that both cover, if some place between their corners is one.
    for (int k = 0; k < 4; ++k) {
      const double u = r.unit(), w = r.unit() * (1 - u);
      const auto mix = [&](auto of) {
        return u * of(p.a.v[0].position) + w * of(p.a.v[1].position) + (1 - u - w) * of(p.a.v[2].position);
      };
      const int x = static_cast<int>(std::floor(mix([](irg::subpixel s) { return s.x; }) / 256)),
                y = static_cast<int>(std::floor(mix([](irg::subpixel s) { return s.y; }) / 256));
      if (!covers(p.a, x, y) || !covers(p.b, x, y)) continue;
      ++asked;
      const auto ask = [&] {
        const irg::face_sample a{p.a, rounded_depth(p.a, x, y)}, b{p.b, rounded_depth(p.b, x, y)};
        by_floats += irg::detail::rounded_depths_decide(a, b);
        return 3 * compare_depths<less>(a, b, x, y) + 9 * is_nearer(a, b, x, y);
      };
      const int due = 3 * compare_depths<less>(p.a, p.b, x, y) + 9 * is_nearer(p.a, p.b, x, y);
      wrong += ask() != due || test::while_flushing(ask) != due;
      break;
    }
  }
  MESSAGE(asked, " pairs that cover a pixel, ", by_floats / 2, " decided by floats");
  CHECK(wrong == 0);
  CHECK(asked > test::trials(50'000));
  CHECK(by_floats > asked / 4);
}

TEST_CASE("compare_depths: rounded depths that are close decide nothing") {
  constexpr screen_face a = level(1.0f, 0), b = level(0x1.000002p0f, 1);
  // Off by 4 units in the last place the wrong way, as rounding might have it.
  CHECK_BOTH(is_nearer(irg::face_sample{b, 0x1.fffffap-1f}, irg::face_sample{a, 0x1.000008p0f}, 1, 1));
  CHECK_BOTH(!is_nearer(irg::face_sample{a, 0x1.000008p0f}, irg::face_sample{b, 0x1.fffffap-1f}, 1, 1));
  CHECK_BOTH(is_nearer(irg::face_sample{level(0.5f), 0.5f}, irg::face_sample{level(0.25f), 0.25f}, 1, 1));
  // Depths of both signs may cancel.
  constexpr screen_face steep = face({0, 0}, {4096, 0}, {0, 4096}, -1.0f, 1.0f, 1.0f, 0);
  CHECK_BOTH(!is_nearer(irg::face_sample{steep, 1.0f}, irg::face_sample{level(0.5f, 1), 0.5f}, 1, 1));
}

TEST_CASE("compare_depths: rounded depths that overflowed on their way decide nothing") {
  // An eighth of 2^127 at the centre of pixel (0, 0); the triangle is so small that the kernel's gain is infinite.
  constexpr screen_face small = face({127, 127}, {135, 127}, {127, 135}, 1.0f, 0x1p127f, 1.0f);
  const irg::face_sample a{small, rounded_depth(small, 0, 0)};
  CHECK_BOTH(compare_depths(small, level(0x1p120f), 0, 0) == 1);
  CHECK_BOTH(compare_depths(small, level(0x1p126f), 0, 0) == -1);
  CHECK(compare_depths(a, irg::face_sample{level(0x1p120f), 0x1p120f}, 0, 0) == 1);
  CHECK(compare_depths(a, irg::face_sample{level(0x1p126f), 0x1p126f}, 0, 0) == -1);
}

// ---- sides of planes

TEST_CASE("side_of_face: by hand") {
  CHECK_BOTH(side_of_face(level(0.5f), {{100, 100}, 0.75f}) == irg::side::above);
  CHECK_BOTH(side_of_face<less>(level(0.5f), {{100, 100}, 0.75f}) == irg::side::below);
  CHECK_BOTH(side_of_face<drawing_order>(level(0.5f), {{100, 100}, 0.75f}) == irg::side::on);
  CHECK_BOTH(side_of_face(level(0.5f), {{-90000, 77}, 0.5f}) == irg::side::on);
  constexpr screen_face slope = face({0, 0}, {0, 4096}, {4096, 0}, 0.0f, 0.0f, 1.0f);
  CHECK_BOTH(side_of_face(slope, {{1, 55}, 0x1p-12f}) == irg::side::on);
  CHECK_BOTH(side_of_face(slope, {{1, 55}, 0x1.000002p-12f}) == irg::side::above);
  CHECK_BOTH(side_of_face(slope, {{-1, 55}, -0x1.000002p-12f}) == irg::side::below);
  CHECK_BOTH(side_of_face(face({0, 0}, {9, 9}, {18, 18}, 0.0f, 1.0f, 0.0f), {{1, 5}, 1.0f}) == irg::side::on);
}

TEST_CASE("side_of_face: the sign of orient3d") {
  test::face_pair_maker make(405);
  using point = irg::point<double, 3>;
  const auto at = [](const irg::screen_vertex& v) {
    return point{static_cast<double>(v.position.x), static_cast<double>(v.position.y), static_cast<double>(v.depth)};
  };
  long long wrong = 0, count[3] = {};
  for (int i = 0; i < test::trials(200'000); ++i) {
    const test::face_pair p = make.next(static_cast<test::face_pairs>(i % test::face_pair_kinds));
    for (const irg::screen_vertex& corner : p.b.v) {
      const irg::subpixel &u = p.a.v[0].position, &v = p.a.v[1].position, &w = p.a.v[2].position;
      const irg::orientation seen = irg::orientation_of(u, v, w);
      const int turn = seen == irg::orientation::clockwise ? 1 : seen == irg::orientation::counter_clockwise ? -1 : 0;
      const int due = turn * irg::orient3d(at(p.a.v[0]), at(p.a.v[1]), at(p.a.v[2]), at(corner));
      wrong += sign_of(side_of_face(p.a, corner)) != due;
      ++count[due + 1];
    }
  }
  CHECK(wrong == 0);
  for (const long long n : count) CHECK(n > test::trials(100'000));
}

// ---- the picture

TEST_CASE("picture_face_at: by hand") {
  static constexpr screen_face faces[] = {level(0.25f, 4), face({0, 0}, {2048, 0}, {0, 2048}, 0.5f, 0.5f, 0.5f, 9),
                                          level(0.25f, 2)};
  CHECK_BOTH(irg::picture_face_at(faces, 1, 1) == 9);
  CHECK_BOTH(irg::picture_face_at(faces, 7, 7) == 2);
  CHECK_BOTH(irg::picture_face_at<less>(faces, 1, 1) == 2);
  CHECK_BOTH(irg::picture_face_at<drawing_order>(faces, 7, 7) == 4);
  CHECK_BOTH(!irg::picture_face_at(faces, 15, 15));
  CHECK_BOTH(!irg::picture_face_at({}, 0, 0));
}

template <irg::DepthOrder Order>
void against_drawing(std::uint64_t seed, int scenes) {
  constexpr int size = 24;
  test::random r(seed);
  long long compared = 0, close = 0, wrong = 0;
  for (int scene = 0; scene < scenes; ++scene) {
    std::vector<screen_face> faces;
    irg::image<std::uint32_t> id(size, size, irg::no_index);
    irg::image<float> depth(size, size, Order::farthest);
    for (std::uint32_t i = 0; i < 12; ++i) {
      irg::screen_vertex v[3];
      for (auto& c : v)
        c = {{static_cast<std::int32_t>(r.integer(-1000, size * 256 + 1000)),
              static_cast<std::int32_t>(r.integer(-1000, size * 256 + 1000))},
             static_cast<float>(0.125 + 0.75 * r.unit())};
      faces.push_back(irg::make_screen_face(v[0], v[1], v[2], i));
      irg::shade_triangle<Order>(id, depth, {v[0], v[1], v[2]}, irg::solid_shader<std::uint32_t>{i});
    }
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x) {
        const std::uint32_t seen = irg::picture_face_at<Order>(faces, x, y).value_or(irg::no_index);
        if (seen == id(x, y)) {
          ++compared;
          continue;
        }
        // Allowed only where the float depths of the two lie within 8 units in the last place.
        const bool both = seen != irg::no_index && id(x, y) != irg::no_index;
        const float a = both ? rounded_depth(faces[seen], x, y) : 0,
                    b = both ? rounded_depth(faces[id(x, y)], x, y) : 1;
        ++(std::fabs(a - b) <= 8 * 0x1p-24f ? close : wrong);
      }
  }
  MESSAGE(compared, " pixels as drawn, ", close, " otherwise where depths are close, ", wrong, " wrong");
  CHECK(wrong == 0);
  CHECK(close * 1000 < compared);
}

TEST_CASE("picture_face_at: the picture that shade_triangle draws, but for close depths") {
  against_drawing<greater>(406, test::trials(100));
  against_drawing<less>(407, test::trials(100));
  against_drawing<drawing_order>(408, test::trials(100));
}

TEST_CASE("depth_sense, wins_tie: the order's direction, and who is seen where two faces are equally near") {
  static_assert(irg::depth_sense<greater> == 1 && irg::depth_sense<less> == -1 && irg::depth_sense<drawing_order> == 0);
  CHECK_BOTH(irg::wins_tie(level(0.5f, 3), level(0.5f, 4)));
  CHECK_BOTH(!irg::wins_tie<less>(level(0.5f, 4), level(0.5f, 3)));
  CHECK_BOTH(irg::wins_tie<drawing_order>(level(0.5f, 4), level(0.5f, 3)));
  CHECK_BOTH(!irg::wins_tie(level(0.5f, 3), level(0.5f, 3)));
  CHECK_BOTH(irg::is_nearer(level(0.5f, 3), level(0.5f, 4), 3, 3));
}

TEST_CASE("depth_as_integer: the depth by a power of two, across words") {
  CHECK_BOTH(irg::depth_as_integer<1>(-0x1.8p-100f, 26) == irg::wide_int<1>(-(3 << 22)));
  CHECK_BOTH(irg::depth_as_integer<1>(0x1p-149f, 0) == irg::wide_int<1>(1));
  CHECK_BOTH(irg::depth_as_integer<2>(-0.0f, 99) == irg::wide_int<2>(0));
  // 1 is 2^23 at place 126: beyond the first word from place 62 on.
  CHECK_BOTH(irg::depth_as_integer<2>(1.0f, 85) == irg::wide_int<2>(irg::int128{1} << 64));
  CHECK_BOTH(irg::depth_as_integer<2>(-1.5f, 85) == -irg::wide_int<2>(irg::int128{3} << 63));
}

}  // namespace
