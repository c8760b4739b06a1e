// SPDX-License-Identifier: MIT
#include <irg/hidden/hidden_lines.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "support/big_rational.hpp"
#include "support/check_both.hpp"
#include "support/random.hpp"

namespace {

using irg::edge_part;
using irg::face_search;
using irg::line_visibility;
using irg::screen_edge;
using irg::screen_face;
using irg::screen_vertex;

constexpr screen_vertex at(int x, int y, float depth) { return {{x * 256, y * 256}, depth}; }

struct scene {
  std::vector<screen_face> faces{};
  std::vector<screen_edge> edges{};

  constexpr void add(const screen_vertex& a, const screen_vertex& b, const screen_vertex& c) {
    faces.push_back(irg::make_screen_face(a, b, c, static_cast<std::uint32_t>(faces.size())));
    for (const screen_edge& e : {screen_edge{{a, b}}, screen_edge{{b, c}}, screen_edge{{c, a}}}) edges.push_back(e);
  }
};

template <class Order = irg::nearer_is_greater>
constexpr std::vector<edge_part> parts_of(const scene& s, face_search search = face_search::nearby) {
  std::vector<edge_part> parts;
  irg::hidden_lines<Order>(s.faces, s.edges, [&](const edge_part& p) { parts.push_back(p); }, search);
  return parts;
}
constexpr bool same(const std::vector<edge_part>& a, const std::vector<edge_part>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const edge_part& p, const edge_part& q) {
    return p.edge == q.edge && p.visibility == q.visibility && p.from == q.from && p.to == q.to;
  });
}

// The parts of one edge behind some faces, as letters, and the places between them.
struct outcome {
  int count = 0;
  line_visibility first = line_visibility::visible;
  double place[4]{};
  constexpr bool operator==(const outcome&) const = default;
};
constexpr outcome seen(const screen_edge& e, const std::vector<screen_face>& faces) {
  outcome o;
  irg::hidden_lines(faces, std::vector<screen_edge>{e}, [&](const edge_part& p) {
    if (o.count == 0) o.first = p.visibility;
    if (o.count < 4) o.place[o.count] = p.to;
    ++o.count;
  });
  return o;
}
constexpr auto visible = line_visibility::visible, hidden = line_visibility::hidden;
constexpr screen_face face(const screen_vertex& a, const screen_vertex& b, const screen_vertex& c) {
  return irg::make_screen_face(a, b, c, 0);
}
constexpr screen_edge level{{at(0, 0, 0.5f), at(8, 0, 0.5f)}};

TEST_CASE("hidden_lines: an edge behind, before, through and beside a face") {
  CHECK_BOTH(seen(level, {}) == outcome{1, visible, {1}});
  // From 2 to 6 of 8 behind a face, whichever way its corners run.
  CHECK_BOTH(seen(level, {face(at(2, -4, 1), at(6, -4, 1), at(4, 4, 1))}) == outcome{3, visible, {0.375, 0.625, 1}});
  CHECK_BOTH(seen(level, {face(at(4, 4, 1), at(6, -4, 1), at(2, -4, 1))}) == outcome{3, visible, {0.375, 0.625, 1}});
  CHECK_BOTH(seen(level, {face(at(2, -4, 0), at(6, -4, 0), at(4, 4, 0))}) == outcome{1, visible, {1}});
  // A face that is nearer on its right half only.
  CHECK_BOTH(seen(level, {face(at(0, -8, 0), at(8, -8, 1), at(0, 8, 0))}).count == 1);
  CHECK_BOTH(seen(level, {face(at(-8, -8, 0.25f), at(24, -8, 0.75f), at(4, 16, 0.5f))}).count >= 1);
  CHECK_BOTH(seen({{at(0, 0, 1), at(8, 0, 0)}}, {face(at(-9, -9, 0.5f), at(30, -9, 0.5f), at(4, 30, 0.5f))}) ==
             outcome{2, visible, {0.5, 1}});
  // Beyond either end; all of it; touched in a corner only.
  CHECK_BOTH(seen(level, {face(at(9, -4, 1), at(12, 4, 1), at(15, -4, 1))}) == outcome{1, visible, {1}});
  CHECK_BOTH(seen(level, {face(at(-9, -9, 1), at(30, -9, 1), at(4, 30, 1))}) == outcome{1, hidden, {1}});
  CHECK_BOTH(seen(level, {face(at(4, 0, 1), at(2, 4, 1), at(6, 4, 1))}) == outcome{1, visible, {1}});
}

TEST_CASE("hidden_lines: sides belong to a face, its plane does not hide, faces that meet leave nothing between them") {
  // Along a side, from 2 to 6.
  CHECK_BOTH(seen(level, {face(at(2, 0, 1), at(6, 0, 1), at(4, 4, 1))}) == outcome{3, visible, {0.25, 0.75, 1}});
  // In the plane, as a side, as a diagonal, and from a corner.
  CHECK_BOTH(seen(level, {face(at(0, 0, 0.5f), at(8, 0, 0.5f), at(4, 4, 1))}) == outcome{1, visible, {1}});
  CHECK_BOTH(seen(level, {face(at(-9, -9, 0.5f), at(30, -9, 0.5f), at(4, 30, 0.5f))}) == outcome{1, visible, {1}});
  CHECK_BOTH(seen(level, {face(at(0, 0, 0.5f), at(9, -1, 1), at(9, 1, 1))}) == outcome{1, hidden, {1}});
  // Two faces that share a side across the edge, and a T-junction of three.
  const auto a = face(at(1, -4, 1), at(4, -4, 1), at(3, 4, 1)), b = face(at(4, -4, 1), at(7, 4, 1), at(3, 4, 1));
  CHECK(seen(level, {a, b}).count == 3);
  // Seen edge on, twice the same, without length.
  CHECK_BOTH(seen(level, {face(at(2, 0, 1), at(4, 0, 1), at(6, 0, 2))}) == outcome{1, visible, {1}});
  const auto f = face(at(2, -4, 1), at(6, -4, 1), at(4, 4, 1)),
             same_face = face(at(4, 4, 1), at(2, -4, 1), at(6, -4, 1));
  CHECK(seen(level, {f, same_face, f}) == outcome{3, visible, {0.375, 0.625, 1}});
  CHECK_BOTH(seen({{at(4, 0, 0), at(4, 0, 1)}}, {face(at(2, -4, 1), at(6, -4, 1), at(4, 4, 1))}).count == 0);
}

TEST_CASE("hidden_lines: what was done is counted, and the points of an edge are its ends where they are ends") {
  scene s;
  s.add(at(2, -4, 1), at(6, -4, 1), at(4, 4, 1));
  s.faces.push_back(s.faces[0]);
  s.edges.assign({level, {{at(4, 0, 0), at(4, 0, 1)}}});
  const auto n = irg::hidden_lines(s.faces, s.edges, [](const edge_part&) {});
  CHECK(n.edges == 1);
  CHECK(n.faces == 2);  // of which one is not tried again
  CHECK(n.tried == 1);
  CHECK(n.hiding == 1);
  CHECK(n.visible == 2);
  CHECK(n.hidden == 1);
  CHECK_BOTH(irg::point_on(level, 0.375) == irg::point<double, 2>{3, 0});
  CHECK_BOTH(irg::point_on(screen_edge{{{{-1, 3}, 0}, {{536870911, 7}, 0}}}, 1.0) ==
             irg::point<double, 2>{536870911 / 256.0, 7 / 256.0});
}

// Scenes of every difficulty: positions on a lattice, so that corners meet, edges coincide and T-junctions come by
// themselves; depths from a plane, from few values, or of all sizes.
class scene_maker {
public:
  explicit scene_maker(std::uint64_t seed) : random_(seed) {}

  scene next(int faces) {
    kind_ = random_.integer(0, 3);
    reach_ = std::int64_t{1} << random_.integer(2, kind_ == 0 ? 29 : 12);
    scene s;
    std::vector<screen_vertex> corners;
    for (int i = 0; i < faces; ++i) {
      screen_vertex v[3];
      for (screen_vertex& c : v) {
        const bool shared = !corners.empty() && random_.integer(0, 1) == 0;
        c = shared ? corners[static_cast<std::size_t>(random_.integer(0, std::int64_t(corners.size()) - 1))] : corner();
        corners.push_back(c);
      }
      s.add(v[0], v[1], v[2]);
      if (random_.integer(0, 7) == 0) s.add(v[1], v[0], v[2]);
      if (random_.integer(0, 7) == 0) s.add(v[0], v[1], v[2]);  // the same face and edges once more
    }
    return s;
  }

private:
  screen_vertex corner() {
    const auto x = static_cast<std::int32_t>(random_.integer(-reach_, reach_));
    const auto y = static_cast<std::int32_t>(random_.integer(-reach_, reach_));
    if (kind_ == 1) return {{x, y}, static_cast<float>(x + 2 * y) / 32768};  // many in one plane, exactly
    if (kind_ == 2) return {{x, y}, static_cast<float>(random_.integer(0, 3))};
    const float depth = static_cast<float>(random_.integer(0, 1 << 24)) * 0x1p-24f;
    return {{x, y}, kind_ == 3 ? depth : std::ldexp(depth - 0.5f, static_cast<int>(random_.integer(-100, 100)))};
  }
  test::random random_;
  std::int64_t kind_ = 0, reach_ = 0;
};

TEST_CASE("hidden_lines: no skipping, no order of the faces and no direction of depths changes a byte") {
  scene_maker make(16);
  test::random random(7);
  for (int trial = 0; trial < 60; ++trial) {
    scene s = make.next(20);
    const auto parts = parts_of(s);
    CHECK(same(parts, parts_of(s, face_search::every)));
    for (std::size_t i = s.faces.size(); i > 1; --i)
      std::swap(s.faces[i - 1], s.faces[static_cast<std::size_t>(random.integer(0, std::int64_t(i) - 1))]);
    CHECK(same(parts, parts_of(s)));
    for (screen_edge& e : s.edges)
      for (screen_vertex& v : e.v) v.depth = -v.depth;
    for (screen_face& f : s.faces) {
      for (screen_vertex& v : f.v) v.depth = -v.depth;
      f = irg::make_screen_face(f.v[0], f.v[1], f.v[2], f.number);
    }
    CHECK(same(parts, parts_of<irg::nearer_is_less>(s)));
  }
}

TEST_CASE("hidden_lines: of few edges the depths are noted first, and change no byte") {
  scene_maker make(18);
  for (int trial = 0; trial < 200; ++trial) {
    scene s = make.next(40);
    s.edges.resize(static_cast<std::size_t>(1 + trial % 7));
    CHECK(same(parts_of(s), parts_of(s, face_search::every)));
  }
}

#ifdef IRG_HAVE_MPFR
using real = test::big_rational;

struct exact_part {
  bool hidden;
  real from, to;
};

// The same told another way, in rationals and without intervals: an edge is cut where the lines through the sides of
// any face and the plane of any face meet it, and between two cuts the middle is asked of every face, by barycentric
// coordinates from Cramer's rule and the plane's normal.
class exact_edge {
public:
  exact_edge(const screen_edge& e, const std::vector<screen_face>& faces) : edge_(e) {
    std::vector<real> cuts{real(0), real(1)};
    for (const screen_face& f : faces) {
      if (f.coverage.double_area == 0) continue;
      planes_.emplace_back(f);
      for (int i = 0; i < 3; ++i) {
        const irg::subpixel &p = f.v[i].position, &q = f.v[(i + 1) % 3].position;
        const real nx = number(q.y) - number(p.y), ny = number(p.x) - number(q.x);
        cut_at(cuts, nx * (number(p.x) - x(0)) + ny * (number(p.y) - y(0)), nx * (x(1) - x(0)) + ny * (y(1) - y(0)));
      }
      const real start = planes_.back().above(x(0), y(0), z(0)), end = planes_.back().above(x(1), y(1), z(1));
      cut_at(cuts, start, start - end);
    }
    std::sort(cuts.begin(), cuts.end());
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
      if (cuts[i] == cuts[i + 1]) continue;
      const real t = (cuts[i] + cuts[i + 1]) / 2;
      const real px = x(0) + t * (x(1) - x(0)), py = y(0) + t * (y(1) - y(0)), pz = z(0) + t * (z(1) - z(0));
      const bool hides = std::any_of(planes_.begin(), planes_.end(), [&](const plane& p) {
        return p.covers(px, py) && p.above(px, py, pz).sign() > 0;
      });
      if (!parts.empty() && parts.back().hidden == hides)
        parts.back().to = cuts[i + 1];
      else
        parts.push_back({hides, cuts[i], cuts[i + 1]});
    }
  }
  std::vector<exact_part> parts{};

private:
  static real number(double v) { return real(v); }
  real x(int end) const { return number(edge_.v[end].position.x); }
  real y(int end) const { return number(edge_.v[end].position.y); }
  real z(int end) const { return number(static_cast<double>(edge_.v[end].depth)); }
  static void cut_at(std::vector<real>& cuts, const real& dividend, const real& divisor) {
    if (divisor.sign() == 0) return;
    const real t = dividend / divisor;
    if (t.sign() > 0 && t < real(1)) cuts.push_back(t);
  }
  struct plane {
    real ox, oy, oz, ux, uy, uz, vx, vy, vz, det;
    explicit plane(const screen_face& f)
        : ox(number(f.v[0].position.x)), oy(number(f.v[0].position.y)), oz(number(double(f.v[0].depth))),
          ux(number(f.v[1].position.x) - ox), uy(number(f.v[1].position.y) - oy), uz(number(double(f.v[1].depth)) - oz),
          vx(number(f.v[2].position.x) - ox), vy(number(f.v[2].position.y) - oy), vz(number(double(f.v[2].depth)) - oz),
          det(ux * vy - uy * vx) {}
    real above(const real& px, const real& py, const real& pz) const {
      return oz - ((uy * vz - uz * vy) * (px - ox) + (uz * vx - ux * vz) * (py - oy)) / det - pz;
    }
    bool covers(const real& px, const real& py) const {
      const real a = ((px - ox) * vy - (py - oy) * vx) / det, b = ((py - oy) * ux - (px - ox) * uy) / det;
      return a.sign() >= 0 && b.sign() >= 0 && !(real(1) < a + b);
    }
  };
  const screen_edge& edge_;
  std::vector<plane> planes_{};
};

// Whether `place` is the multiple of 2^-53 nearest to the exact one.
bool is_rounded(double place, const real& exact) {
  const real off = real(place) - exact, half = real(0x1p-54);
  return !(half < off) && -half < off;
}

void check_against_rationals(const scene& s, std::int64_t& changes) {
  std::size_t next = 0;
  const auto parts = parts_of(s);
  for (std::size_t i = 0; i < s.edges.size(); ++i) {
    if (s.edges[i].v[0].position == s.edges[i].v[1].position) continue;
    for (const exact_part& want : exact_edge(s.edges[i], s.faces).parts) {
      if (next < parts.size() && parts[next].edge == i && is_rounded(parts[next].from, want.from) &&
          is_rounded(parts[next].to, want.to) && (parts[next].visibility == line_visibility::hidden) == want.hidden) {
        ++next;
        ++changes;
      } else {
        // A part shorter than half of 2^-53 may have no length when it is rounded.
        REQUIRE(want.to - want.from < real(0x1p-53));
      }
    }
  }
  CHECK(next == parts.size());
}

TEST_CASE("hidden_lines: every change of visibility against rationals, by the middles of all pieces of all edges") {
  const bool large = std::getenv("IRG_RELEASE_TIER") != nullptr;
  scene_maker make(2026);
  std::int64_t changes = 0;
  for (int trial = 0; trial < (large ? 20000 : 40); ++trial) check_against_rationals(make.next(4 + trial % 9), changes);
  CHECK(changes > 1000);
}
#endif

}  // namespace
