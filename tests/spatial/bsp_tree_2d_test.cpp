// SPDX-License-Identifier: MIT
#include <irg/spatial/bsp_tree_2d.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <random>
#include <utility>
#include <vector>

#include "support/big_rational.hpp"
#include "support/check_both.hpp"
#include "support/random.hpp"

namespace {

using S = irg::segment<double, 2>;
using P = irg::point<double, 2>;
using tree = irg::bsp_tree_2d<double>;

constexpr std::size_t figure_pieces() {
  const S s[] = {{{0, 0}, {4, 0}}, {{1, 2}, {3, 2}}, {{1, -1}, {3, -1}}, {{2, -3}, {2, 3}}};
  const tree t(s, {.candidates = 1});
  return t.pieces().size() * 10 + t.splits();
}
static_assert(figure_pieces() == 73);

TEST_CASE("bsp_tree_2d: the thesis' figure, from three eyes") {
  const S s[] = {{{0, 0}, {4, 0}}, {{1, 2}, {3, 2}}, {{1, -1}, {3, -1}}, {{2, -3}, {2, 3}}};
  const tree t(s, {.candidates = 1});
  constexpr auto none = irg::no_index;
  const irg::bsp_piece_2d a{0, none, none}, b{1, none, none}, c{2, none, none};
  const irg::bsp_piece_2d lowest{3, none, 2}, low{3, 2, 0}, high{3, 0, 1}, highest{3, 1, none};
  const auto order = [&](const P& eye, irg::bsp_order which) {
    std::vector<irg::bsp_piece_2d> seen;
    t.visit(eye, which, [&](const irg::bsp_piece_2d& p) { seen.push_back(p); });
    return seen;
  };
  using pieces = std::vector<irg::bsp_piece_2d>;
  const pieces from_above{lowest, c, low, a, high, b, highest}, from_below{highest, b, high, a, low, c, lowest};
  const pieces from_right{lowest, c, low, a, highest, b, high};
  using irg::bsp_order;
  CHECK(order({0, 5}, bsp_order::back_to_front) == from_above);
  CHECK(order({0, -5}, bsp_order::back_to_front) == from_below);
  CHECK(order({4, 1}, bsp_order::back_to_front) == from_right);
  CHECK(order({4, 1}, bsp_order::front_to_back) == pieces(from_right.rbegin(), from_right.rend()));
  const S drawn = t.rounded(high);
  CHECK((drawn.a == P{2, 0} && drawn.b == P{2, 2} && t.rounded(a).a == s[0].a && t.rounded(a).b == s[0].b));
  // On the line of a: nothing of it hides, or is hidden, but along itself; it is the last or the first.
  CHECK(order({9, 0}, bsp_order::back_to_front).back() == a);
  CHECK(order({9, 0}, bsp_order::front_to_back).front() == a);
}

TEST_CASE("bsp_tree_2d: 10^5 parallel segments stay in few levels") {
  std::vector<S> rungs;
  for (int i = 0; i < 100000; ++i) rungs.push_back({{0, static_cast<double>(i)}, {1, static_cast<double>(i)}});
  const tree t(rungs);
  std::vector<int> depth(t.nodes().size(), 1);
  int deepest = 0;
  for (std::size_t i = 0; i < t.nodes().size(); ++i) {  // children stand behind their parents
    for (const std::uint32_t child : {t.nodes()[i].left, t.nodes()[i].right})
      if (child != irg::no_index) depth[child] = depth[i] + 1;
    deepest = std::max(deepest, depth[i]);
  }
  CHECK(t.nodes().size() == 100000);
  CHECK(deepest <= 60);
  CHECK(t.splits() == 0);
}

TEST_CASE("bsp_tree_2d: degenerate input") {
  const double inf = std::numeric_limits<double>::infinity();
  const S bad[] = {{{1, 1}, {1, 1}}, {{0, 0}, {inf, 0}}};
  CHECK(tree(bad).left_out() == 2);
  CHECK(tree(bad).locate({0, 0}) == irg::bsp_place{});
  const std::vector<S> same(100000, S{{0, 0}, {1, 3}});
  CHECK(tree(same).nodes().size() == 1);
  std::vector<S> rungs;
  for (int i = 0; i < 1000; ++i) rungs.push_back({{0, static_cast<double>(i)}, {1, static_cast<double>(i)}});
  CHECK(tree(rungs).nodes().size() == 1000);
  CHECK(tree(rungs, {.candidates = 1}).locate({5, 7}) == irg::bsp_place{7, 0});
  CHECK(tree(rungs, {.candidates = 1}).locate({5, 999.5}) == irg::bsp_place{999, 1});
}

std::vector<S> ring(int walls, double radius) {
  std::vector<S> all;
  const auto at = [&](int i) {
    const double angle = 6.283185307179586 * i / walls;
    return P{radius * std::cos(angle), radius * std::sin(angle)};
  };
  for (int i = 0; i < walls; ++i) all.push_back({at(i), at(i + 1 < walls ? i + 1 : 0)});
  return all;
}

TEST_CASE("bsp_tree_2d: walls round convex rooms are not cut") {
  const int walls = std::getenv("IRG_RELEASE_TIER") ? 1'000'000 : 20'000;
  const tree t(ring(walls, 1));
  CHECK(t.splits() == 0);
  CHECK(t.nodes().size() == static_cast<std::size_t>(walls));
  std::size_t visited = 0;
  t.visit({0.3, 0.2}, irg::bsp_order::back_to_front, [&](const irg::bsp_piece_2d&) { ++visited; });
  CHECK(visited == static_cast<std::size_t>(walls));
}

TEST_CASE("bsp_open_cells: growth, the line of a wall in a ring meets few of the others") {
  using cells = irg::bsp_open_cells<int, 2>;
  const int most = std::getenv("IRG_RELEASE_TIER") ? 1'000'000 : 10'000;
  for (int n = 1000; n <= most; n *= 10) {
    const auto walls = ring(n, 5);
    std::vector<cells::entry> items;
    for (int i = 0; i < n; ++i) {
      const S& s = walls[static_cast<std::size_t>(i)];
      const bool turned = i % 3 == 0;  // which way a wall is given does not matter
      const irg::vec<double, 2> normal{s.a[1] - s.b[1], s.b[0] - s.a[0]};
      items.push_back(
          {i, irg::bounds_of<2>(std::array{s.a, s.b}, turned ? -normal : normal), static_cast<std::uint32_t>(i)});
    }
    cells all;
    std::uint32_t cell = all.make_cell(std::move(items));
    CHECK(all.size(cell) == static_cast<std::size_t>(n));
    CHECK(all.first(cell) == 0);
    std::size_t looks = 0;
    int wrong = 0;
    for (int left = n; left > 0; --left) {
      const int i = all.at(cell, static_cast<std::size_t>(left) / 2);
      const S& by = walls[static_cast<std::size_t>(i)];
      const irg::vec<double, 2> normal{by.a[1] - by.b[1], by.b[0] - by.a[0]};
      const irg::linear_form<2> line{normal, {std::abs(normal[0]), std::abs(normal[1])}, by.a};
      const auto side_of = [&](const irg::bsp_bounds<2>& b) {
        ++looks;
        return irg::rounded_side_of(b, line);
      };
      const auto halves = all.divide(cell, side_of, [&](cells::entry&& e, const auto& front, const auto&) {
        ++looks;
        if (e.item != i) front(std::move(e));
      });
      wrong += halves.back != irg::no_index;  // walls run counter-clockwise: all others are left of each
      wrong += all.size(halves.front) != static_cast<std::size_t>(left) - 1;
      cell = halves.front;
    }
    CHECK(wrong == 0);
    INFO(n, " walls, looks a wall: ", static_cast<double>(looks) / n);
    CHECK(static_cast<double>(looks) <= 3 * n * std::log2(n));
  }
}

#ifdef IRG_HAVE_MPFR
using Q = test::big_rational;

// Where the line of `l` cuts `s`, as a share of s.
Q share(const S& s, const S& l) {
  const Q dx = Q(l.b[0]) - Q(l.a[0]), dy = Q(l.b[1]) - Q(l.a[1]);
  return (dx * (Q(l.a[1]) - Q(s.a[1])) - dy * (Q(l.a[0]) - Q(s.a[0]))) /
         (dx * (Q(s.b[1]) - Q(s.a[1])) - dy * (Q(s.b[0]) - Q(s.a[0])));
}
bool parallel(const S& s, const S& l) {
  return ((Q(s.b[0]) - Q(s.a[0])) * (Q(l.b[1]) - Q(l.a[1])) - (Q(s.b[1]) - Q(s.a[1])) * (Q(l.b[0]) - Q(l.a[0])))
             .sign() == 0;
}

TEST_CASE("bsp_tree_2d: pieces tile their segments, and lie on every ray in the order of the traversal") {
  std::mt19937_64 random(20261124);
  int compared = 0, split = 0;
  for (int scene = 0; scene < 60; ++scene) {
    const auto number = [&] {
      const double whole = static_cast<double>(static_cast<int>(random() % 17) - 8);
      return scene % 3 == 0 ? std::ldexp(whole, static_cast<int>(random() % 1980) - 990) : whole;
    };
    const auto drawn = [&] {
      double v[4];
      for (double& x : v) x = number();
      return S{{v[0], v[1]}, {v[2], v[3]}};
    };
    std::vector<S> s;
    for (int i = 0; i < 12; ++i) s.push_back(drawn());
    const tree t(s, {.candidates = scene % 2 == 0 ? std::size_t{1} : std::size_t{8}});
    split += static_cast<int>(t.splits());
    std::vector<Q> length(s.size(), Q(0));
    const auto start = [&](const irg::bsp_piece_2d& p) {
      return p.from == irg::no_index ? Q(0) : share(s[p.segment], s[p.from]);
    };
    const auto stop = [&](const irg::bsp_piece_2d& p) {
      return p.to == irg::no_index ? Q(1) : share(s[p.segment], s[p.to]);
    };
    for (const auto& p : t.pieces()) {
      REQUIRE(start(p) < stop(p));
      length[p.segment] = length[p.segment] + (stop(p) - start(p));
    }
    for (std::size_t i = 0; i < s.size(); ++i) REQUIRE(length[i] == Q(s[i].a == s[i].b ? 0 : 1));
    for (int trial = 0; trial < 10; ++trial) {
      const S ray = drawn();
      for (const auto order : {irg::bsp_order::back_to_front, irg::bsp_order::front_to_back}) {
        Q last(0);
        bool any = false;
        std::size_t visited = 0;
        t.visit(ray.a, order, [&](const irg::bsp_piece_2d& p) {
          ++visited;
          if (ray.a == ray.b || parallel(s[p.segment], ray)) return;
          const Q at = share(s[p.segment], ray), depth = share(ray, s[p.segment]);
          if (!(start(p) < at) || !(at < stop(p)) || depth.sign() <= 0) return;  // not on what the eye is on
          if (any && order == irg::bsp_order::back_to_front) REQUIRE(!(last < depth));
          if (any && order == irg::bsp_order::front_to_back) REQUIRE(!(depth < last));
          compared += any;
          last = depth;
          any = true;
        });
        REQUIRE(visited == t.pieces().size());
      }
    }
  }
  CHECK(compared > 500);
  CHECK(split > 200);
}
#endif

TEST_CASE("bsp_tree_2d: of seven parallel segments the middle one divides, wherever it stands in the list") {
  for (std::size_t turned = 0; turned < 7; ++turned) {
    std::vector<S> rungs;
    for (std::size_t i = 0; i < 7; ++i) {
      const auto y = static_cast<double>((3 * i + turned) % 7);
      rungs.push_back(i % 2 == 0 ? S{{0, y}, {1, y}} : S{{1, y}, {0, y}});
    }
    const tree t(rungs);
    REQUIRE(t.nodes().size() == 7);
    CHECK(rungs[t.nodes()[0].segment].a.y == 3);
    std::vector<int> depth(7, 1);
    for (std::size_t i = 0; i < 7; ++i)
      for (const std::uint32_t child : {t.nodes()[i].left, t.nodes()[i].right})
        if (child != irg::no_index) depth[child] = depth[i] + 1;
    CHECK(std::ranges::max(depth) == 3);
  }
}

TEST_CASE(
    "bsp_tree_2d: of up to eight segments the one divides whose sides differ least, cuts counted as bsp_options says") {
  test::random r(23);
  for (int trial = 0; trial < 400; ++trial) {
    std::vector<S> few;
    const auto coordinate = [&] { return static_cast<double>(r.integer(0, 4)); };
    const auto count = static_cast<std::size_t>(r.integer(2, 8));
    while (few.size() < count) {
      const double ax = coordinate(), ay = coordinate(), bx = coordinate(), by = coordinate();
      if (ax != bx || ay != by) few.push_back({{ax, ay}, {bx, by}});
    }
    const irg::bsp_options choice{8, 32, static_cast<std::size_t>(r.integer(0, 5))};
    const auto cost_of = [&](const S& line) {
      int left = 0, right = 0, cut = 0;
      for (const S& s : few) {
        const int a = irg::orient2d(line.a, line.b, s.a), b = irg::orient2d(line.a, line.b, s.b);
        if (a != 0 && a == -b)
          ++cut;
        else if (a + b != 0)
          ++(a + b > 0 ? left : right);
      }
      return std::abs(left - right) + cut * static_cast<int>(choice.cut_costs);
    };
    int least = cost_of(few[0]);
    for (const S& line : few) least = std::min(least, cost_of(line));
    CHECK(cost_of(few[tree(few, choice).nodes()[0].segment]) == least);
  }
}

}  // namespace
