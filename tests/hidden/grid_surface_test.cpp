// SPDX-License-Identifier: MIT
#include <irg/hidden/grid_surface.hpp>

#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>
#include <tuple>
#include <vector>

#include "grid_surface_oracle.hpp"
#include "support/check_both.hpp"
#include "support/random.hpp"

using irg::grid_edge_part;

namespace {

constexpr std::array<double, 4> four{0, 1, 2, 3};
constexpr std::array<double, 5> five{0, 1, 2, 3, 4};

template <std::size_t Count>
constexpr std::array<double, Count> towers(std::initializer_list<std::array<int, 3>> list) {
  std::array<double, Count> h{};
  const int side = Count == 16 ? 4 : 5;
  for (const auto& t : list) h[static_cast<std::size_t>(t[0] * side + t[1])] = t[2];
  return h;
}

// Edges seen whole, hidden, and seen in part, which `partly` checks.
struct seen_edges {
  int whole = 0, hidden = 0, partly = 0;
  double sum = 0;  // of from + 2 to of the parts that are not whole
  constexpr bool operator==(const seen_edges&) const = default;
};
constexpr seen_edges seen_of(const irg::grid_surface& s, const irg::point<double, 3>& eye) {
  seen_edges e;
  const auto done = irg::visible_grid_edges(s, eye, [&](const grid_edge_part& p) {
    const bool whole = p.from == 0 && p.to == 1;
    (whole ? e.whole : e.partly) += 1;
    if (!whole) e.sum += p.from + 2 * p.to;
  });
  e.hidden = static_cast<int>(done.value.hidden);
  return done.status == irg::grid_surface_status::ok ? e : seen_edges{-1};
}

bool part_before(const grid_edge_part& a, const grid_edge_part& b) {
  return std::tie(a.i1, a.j1, a.i2, a.j2, a.from) < std::tie(b.i1, b.j1, b.i2, b.j2, b.from);
}
[[maybe_unused]] std::string text_of(std::vector<grid_edge_part> parts) {
  std::sort(parts.begin(), parts.end(), part_before);
  std::string text;
  for (const grid_edge_part& p : parts) {
    char line[128];
    std::snprintf(line, sizeof line, "%d %d %d %d %.17g %.17g\n", p.i1, p.j1, p.i2, p.j2, p.from, p.to);
    text += line;
  }
  return text;
}

struct random_surface {
  std::vector<double> x{}, z{}, heights{};
  irg::point<double, 3> eye{};
  irg::grid_surface surface() const { return {x, z, heights}; }
};

// All views: `kind` 0 to 2 over the grid, beside it, at its corner; ties by small integers, or numbers of all sizes.
random_surface surface_of(test::random& r, int kind, bool mixed) {
  random_surface s;
  const auto wild = [&] {
    const double size = std::pow(10.0, static_cast<double>(r.integer(-300, 300)));
    return r.integer(0, 1) == 0 ? -size * r.unit() : size * r.unit();
  };
  const auto places = [&](std::vector<double>& v, std::int64_t count) {
    double at = static_cast<double>(r.integer(-2, 2));
    for (std::int64_t k = 0; k < count; ++k) {
      v.push_back(at);
      at += static_cast<double>(r.integer(1, 2)) * (r.integer(0, 3) == 0 ? 0.3 : 1.0);
    }
  };
  places(s.x, r.integer(2, 4));
  places(s.z, r.integer(2, 4));
  const std::int64_t highest = r.integer(0, 5);
  for (std::size_t k = 0; k < s.x.size() * s.z.size(); ++k) {
    const auto level = static_cast<double>(r.integer(-1, highest));
    s.heights.push_back(mixed && r.integer(0, 1) == 0 ? wild() : level);
  }
  const auto within = [&](const std::vector<double>& v) {
    if (r.integer(0, 2) == 0) return v[static_cast<std::size_t>(r.integer(0, static_cast<std::int64_t>(v.size()) - 1))];
    return v.front() + (v.back() - v.front()) * static_cast<double>(r.integer(0, 8)) / 8;
  };
  const auto beside = [&](const std::vector<double>& v) {
    const double off = static_cast<double>(r.integer(1, 12)) / 4;
    return r.integer(0, 1) == 0 ? v.front() - off : v.back() + off;
  };
  s.eye.x = kind == 2 ? beside(s.x) : within(s.x);
  s.eye.z = kind == 0 ? within(s.z) : beside(s.z);
  s.eye.y = static_cast<double>(r.integer(-16, 28)) / 4;
  if (r.integer(0, 5) == 0) s.eye.y = 0;
  if (mixed && r.integer(0, 3) == 0) s.eye.y = wild();
  return s;
}

}  // namespace

TEST_CASE("visible_grid_edges: towers and ridges on small grids") {
  static constexpr auto flat = towers<16>({}), middle = towers<16>({{2, 2, 2}}),
                        ridge = towers<16>({{1, 1, 2}, {2, 1, 2}}), corner = towers<16>({{1, 1, 2}});
  static constexpr auto tall = towers<25>({{3, 2, 3}});
  CHECK_BOTH(seen_of({four, four, flat}, {1.5, 4, 1.5}) == seen_edges{24, 0, 0, 0});
  CHECK_BOTH(seen_of({four, four, middle}, {1.5, 4, 1.5}) == seen_edges{24, 0, 0, 0});
  CHECK_BOTH(seen_of({five, five, tall}, {1.5, 5, 1.75}) == seen_edges{37, 1, 2, 2 * (11.0 / 18) + 13.0 / 18 + 2});
  CHECK_BOTH(seen_of({four, four, ridge}, {1.5, 3, -2}) == seen_edges{14, 10, 0, 0});
  CHECK_BOTH(seen_of({four, four, corner}, {-1, 3, -2}) ==
             seen_edges{15, 5, 4, 2 * (5.0 / 6) + 0.2 + 2 + 2 * (2.0 / 3) + 0.5 + 2});
}

TEST_CASE("visible_grid_edges: what is no grid, an eye on the surface, hostile numbers") {
  static constexpr std::array<double, 2> two{0, 1}, equal{1, 1};
  static constexpr std::array<double, 4> level{}, huge{1e300, -1e300, 1e-300, -1e300};
  static constexpr std::array<double, 1> one{0};
  constexpr double infinite = std::numeric_limits<double>::infinity();
  constexpr auto status = [](const irg::grid_surface& s, const irg::point<double, 3>& eye) {
    return irg::visible_grid_edges(s, eye, [](const grid_edge_part&) {}).status;
  };
  using enum irg::grid_surface_status;
  CHECK_BOTH(status({two, two, level}, {0.5, 0, 0.5}) == eye_on_surface);
  CHECK_BOTH(status({two, two, level}, {1, 0, 1}) == eye_on_surface);
  CHECK_BOTH(status({two, two, level}, {1.5, 0, 1}) == ok);
  CHECK_BOTH(status({two, equal, level}, {0.5, 1, 0.5}) == not_a_grid);
  CHECK_BOTH(status({one, two, {}}, {0.5, 1, 0.5}) == not_a_grid);
  CHECK_BOTH(status({two, two, one}, {0.5, 1, 0.5}) == not_a_grid);
  CHECK_BOTH(status({}, {0.5, 1, 0.5}) == not_a_grid);
  CHECK_BOTH(status({two, two, level}, {0.5, infinite, 0.5}) == not_a_grid);
  CHECK_BOTH(status({two, two, level}, {0.5, std::numeric_limits<double>::quiet_NaN(), 0.5}) == not_a_grid);
  CHECK_BOTH(seen_of({two, two, level}, {0.5, 1, 0.5}) == seen_edges{4, 0, 0, 0});
  CHECK_BOTH(seen_of({two, two, level}, {-1, 0, 0.5}) == seen_edges{4, 0, 0, 0});
  CHECK(status({two, two, huge}, {-1e300, 5e-324, 1e300}) == ok);
}

TEST_CASE("visible_grid_edges: grid points in one direction, of which the perimeter has one") {
  static constexpr std::array<double, 4> x{2, 3, 5, 7};
  static constexpr std::array<double, 16> heights{4, 1, -1, 1, -1, 3, -1, 4, 2, 0, 3, 1, 0, 1, 4, 0};
  CHECK_BOTH(seen_of({x, four, heights}, {0.75, 3, -2.25}).hidden == 2);
  CHECK_BOTH(seen_of({x, four, heights}, {0.75, 3, -2.25}).whole == 15);
}

#ifdef IRG_HAVE_MPFR
TEST_CASE("visible_grid_edges: against the definition, all views") {
  test::random r(20);
  double hidden = 0, length = 0;
  int drawn = 0, wrong = 0, refused = 0, mixed_sizes = 0;
  const int trials = std::getenv("IRG_RELEASE_TIER") != nullptr ? 3000 : 90;
  for (int k = 0; k < trials; ++k) {
    const bool mixed = k % 5 == 4;
    const random_surface s = surface_of(r, k % 3, mixed);
    test::grid_surface_oracle oracle(s.surface(), s.eye);
    std::vector<grid_edge_part> parts;
    const auto done = irg::visible_grid_edges(s.surface(), s.eye, [&](const grid_edge_part& p) { parts.push_back(p); });
    if (oracle.on_surface() != (done.status == irg::grid_surface_status::eye_on_surface)) ++wrong;
    if (done.status != irg::grid_surface_status::ok) {
      ++refused;
      continue;
    }
    const std::string expected = text_of(oracle.parts()), found = text_of(parts);
    if (expected != found && wrong++ < 3) {
      MESSAGE("surface " << k << ", eye " << s.eye.x << " " << s.eye.y << " " << s.eye.z << "\n"
                         << expected << "but\n"
                         << found);
    }
    ++drawn;
    mixed_sizes += mixed ? 1 : 0;
    hidden += oracle.hidden_length, length += oracle.length;
  }
  CHECK(wrong == 0);
  CHECK(drawn > trials * 3 / 4);
  CHECK(mixed_sizes > trials / 8);
  CHECK(hidden > 0.1 * length);
  MESSAGE(drawn << " surfaces, " << refused << " eyes on them, " << 100 * hidden / length << " % hidden");
}
#endif
