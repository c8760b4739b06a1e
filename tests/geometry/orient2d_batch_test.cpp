// SPDX-License-Identifier: MIT
#include <irg/geometry/orient2d_batch.hpp>

#include <algorithm>
#include <array>
#include <vector>

#include <irg/math/vec.hpp>

#include "support/check_both.hpp"
#include "support/flush_mode.hpp"
#include "support/sign_trials.hpp"

using irg::orient2d;
using irg::orient2d_all;

namespace {

using P = irg::point<double, 2>;

struct columns {
  std::vector<double> x, y;
  irg::point_columns from(std::size_t first, std::size_t n) const {
    return {std::span(x).subspan(first, n), std::span(y).subspan(first, n)};
  }
};

columns random_columns(test::random& r, int kind, std::size_t n) {
  columns c;
  for (std::size_t i = 0; i < n; ++i) {
    c.x.push_back(test::hard_number<double>(r, kind));
    c.y.push_back(test::hard_number<double>(r, kind));
  }
  return c;
}

// What constant evaluation makes of 19 points: signs, the count of open ones, and that of the triples (p, a, b).
struct outcome {
  std::array<std::int8_t, 19> signs{}, triple_signs{};
  std::size_t open = 0, triples_open = 0;
  bool operator==(const outcome&) const = default;
};
constexpr outcome outcome_of(const P& a, const P& b, double step) {
  std::array<double, 19> x{}, y{}, ax{}, ay{}, bx{}, by{};
  for (std::size_t i = 0; i < 19; ++i) {
    x[i] = static_cast<double>(i % 5) * step, y[i] = static_cast<double>(i / 4) * step;
    ax[i] = a.x, ay[i] = a.y, bx[i] = b.x, by[i] = b.y;
  }
  outcome o;
  o.open = orient2d_all(a, b, irg::point_columns{x, y}, o.signs);
  o.triples_open = orient2d_all({x, y}, {ax, ay}, {bx, by}, o.triple_signs);
  return o;
}
constexpr int wrong(const outcome& o, const P& a, const P& b, double step) {
  int count = 0;
  for (std::size_t i = 0; i < 19; ++i) {
    const int due = orient2d(a, b, P{static_cast<double>(i % 5) * step, static_cast<double>(i / 4) * step});
    count += (o.signs[i] != due) + (o.triple_signs[i] != due);
  }
  return count;
}
template <int Step>
void check_lives() {
  constexpr double step = Step == 0 ? 1 : Step == 1 ? 0x1p-1074 : Step == 2 ? 0x1p505 : 0x1p1021;
  constexpr P a{0, step}, b{step * 3, step * 2};
  constexpr outcome constant = outcome_of(a, b, step);
  static_assert(wrong(constant, a, b, step) == 0);
  volatile double hidden = step;
  CHECK(outcome_of(P{0, hidden}, b, hidden) == constant);
}

}  // namespace

TEST_CASE("orient2d_all: one outcome in every life") {
  check_lives<0>();
  check_lives<1>();
  check_lives<2>();
  check_lives<3>();
  static_assert(outcome_of(P{0, 1}, P{3, 2}, 1).open == 2);
}

TEST_CASE("orient2d_all: as orient2d one by one, on hard numbers, any count, from anywhere") {
  test::random r(1);
  test::sign_counts seen;
  for (int i = 0; i < test::trials(600); ++i) {
    const int kind = test::hard_kind(r);
    const auto n = static_cast<std::size_t>(r.integer(0, 60)), first = static_cast<std::size_t>(r.integer(0, 3));
    const columns a = random_columns(r, kind, n + 4), b = random_columns(r, kind, n + 4),
                  c = random_columns(r, kind, n + 4);
    std::vector<std::int8_t> signs(n + 2, std::int8_t{77});
    const std::span<std::int8_t> inner = std::span(signs).subspan(1, n);
    const auto point = [](const columns& s, std::size_t k) { return P{s.x[k], s.y[k]}; };

    CHECK(orient2d_all(point(a, 0), point(b, 0), c.from(first, n), inner) <= n);
    std::size_t errors = 0;
    for (std::size_t k = 0; k < n; ++k) errors += inner[k] != orient2d(point(a, 0), point(b, 0), point(c, first + k));
    CHECK(orient2d_all(a.from(first, n), b.from(first, n), c.from(first, n), inner) <= n);
    for (std::size_t k = 0; k < n; ++k) {
      const int due = orient2d(point(a, first + k), point(b, first + k), point(c, first + k));
      errors += inner[k] != due;
      seen.add(due);
    }
    CHECK(errors == 0);
    CHECK((signs.front() == 77 && signs.back() == 77));
  }
  seen.check();
}

TEST_CASE("orient2d_all: next to the line few are left open, and these are right") {
  // Points on both sides of y = x/3 and as near to it as doubles are.
  columns c;
  for (int i = 0; i < 4000; ++i) {
    const double x = 1 + i * 0x1p-20, y = x / 3;
    c.x.push_back(x), c.y.push_back(y + (i % 3 - 1) * 0x1p-50 * (i % 7));
  }
  std::vector<std::int8_t> signs(4000);
  const std::size_t open = orient2d_all(P{0, 0}, P{3, 1}, c.from(0, 4000), signs);
  CHECK((open > 1000 && open < 3000));
  std::size_t errors = 0;
  for (std::size_t i = 0; i < 4000; ++i) errors += signs[i] != orient2d(P{0, 0}, P{3, 1}, P{c.x[i], c.y[i]});
  CHECK(errors == 0);

  test::random r(2);
  const columns easy = random_columns(r, 0, 4000), easy_b = random_columns(r, 0, 4000);
  CHECK(orient2d_all(P{0.1, 0.2}, P{0.7, 0.9}, easy.from(0, 4000), signs) == 0);
  CHECK(orient2d_all(easy_b.from(0, 3998), easy.from(0, 3998), easy.from(1, 3998), std::span(signs).first(3998)) == 0);
}

TEST_CASE("orient2d_all: collinear but for roundings") {
  test::random r(6);
  columns a, b, c, on_line;
  for (int i = 0; i < 4000; ++i) {
    const double x = r.unit(), y = r.unit(), dx = r.unit(), dy = r.unit(), t = r.unit();
    a.x.push_back(x), a.y.push_back(y), b.x.push_back(x + dx), b.y.push_back(y + dy);
    c.x.push_back(x + irg::product(t, dx)), c.y.push_back(y + irg::product(t, dy));
    on_line.x.push_back(0.1 + irg::product(t, 0.6)), on_line.y.push_back(0.2 + irg::product(t, 0.7));
  }
  std::vector<std::int8_t> signs(4000), line_signs(4000);
  CHECK(orient2d_all(a.from(0, 4000), b.from(0, 4000), c.from(0, 4000), signs) > 2000);
  CHECK(orient2d_all(P{0.1, 0.2}, P{0.7, 0.9}, on_line.from(0, 4000), line_signs) > 3000);
  std::size_t errors = 0;
  for (std::size_t i = 0; i < 4000; ++i) {
    errors += signs[i] != orient2d(P{a.x[i], a.y[i]}, P{b.x[i], b.y[i]}, P{c.x[i], c.y[i]});
    errors += line_signs[i] != orient2d(P{0.1, 0.2}, P{0.7, 0.9}, P{on_line.x[i], on_line.y[i]});
  }
  CHECK(errors == 0);
}

TEST_CASE("orient2d_all: lines without length or far from 1") {
  test::random r(3);
  const columns c = random_columns(r, 1, 50);
  std::vector<std::int8_t> signs(50);
  CHECK(orient2d_all(P{2, 3}, P{2, 3}, c.from(0, 50), signs) == 50);
  CHECK(std::count(signs.begin(), signs.end(), std::int8_t{0}) == 50);
  CHECK(orient2d_all(P{0, 0}, P{1, 0}, c.from(0, 0), {}) == 0);
  for (const double size : {0x1p-1074, 0x1p-600, 0x1p600, 0x1p1023}) {
    orient2d_all(P{-size, -size}, P{size, size}, c.from(0, 50), signs);
    std::size_t errors = 0;
    for (std::size_t i = 0; i < 50; ++i) errors += signs[i] != (c.y[i] > c.x[i]) - (c.y[i] < c.x[i]);
    CHECK(errors == 0);
  }
}

TEST_CASE("orient2d_all: right where the processor takes subnormal numbers for zero") {
  // (0.95*2^-1022, 2^-1022) x (2^399, 2^400): without its first number the sign is the other.
  const std::vector<double> zero(8, 0.0), ax(8, 0x1.e666666666666p-1023), ay(8, 0x1p-1022), bx(8, 0x1p399),
      by(8, 0x1p400);
  std::array<std::int8_t, 8> left{};
  test::while_flushing([&] { return orient2d_all({ax, ay}, {bx, by}, {zero, zero}, left); });
  for (const std::int8_t sign : left) CHECK(sign == 1);

  test::random r(4);
  std::size_t errors = 0;
  for (int i = 0; i < test::trials(1000); ++i) {
    const int kind = test::hard_kind(r);
    const columns a = random_columns(r, kind, 40), b = random_columns(r, kind, 40), c = random_columns(r, kind, 40);
    const auto signs = [&] {
      std::array<std::int8_t, 80> all{};
      const std::span<std::int8_t> s(all);
      orient2d_all(a.from(0, 40), b.from(0, 40), c.from(0, 40), s.first(40));
      orient2d_all(P{a.x[0], a.y[0]}, P{b.x[0], b.y[0]}, c.from(0, 40), s.last(40));
      return all;
    };
    errors += test::while_flushing(signs) != signs();
  }
  CHECK(errors == 0);
}
