// SPDX-License-Identifier: MIT
// The modified Bresenham line of a thesis on lines of sight: cells are walked in one canonical direction, and the third
// cell of a diagonal step is found by comparing the distance D with half the slope. sight_2d.hpp asks what blocks them.
#pragma once

#include <cstdint>

#include <irg/core/sinks.hpp>

namespace irg::textbook {

/// Where the line runs between two cells of a diagonal step.
enum class passage {
  none,  // the step is not diagonal
  ahead,  // D < m/2: through the cell one step along the main axis
  aside,  // D > m/2: through the cell one step along the other axis
  corner  // D = m/2: through neither
};

/// One step of the line, in canonical direction: D = distance / (2 n) for the main axis' n steps.
struct sight_step {
  cell at, next, ahead, aside;
  std::int64_t distance = 0;
  passage through = passage::none;
  bool operator==(const sight_step&) const = default;
};

inline namespace IRG_ABI {

/// Calls sink(step) for the steps between the cells of a line, in canonical direction: x rising where |dx| > |dy|, y
/// rising otherwise. Ends when sink returns false, and returns whether it never did.
/// exact   for int coordinates; D and half the slope are compared in whole numbers
/// source  Fabris 2012, 4.3.1 and 4.3.2
template <class Emit>
constexpr bool sight_steps(cell a, cell b, Emit&& sink) {
  const auto apart = [](int p, int q) { return p < q ? std::int64_t{q} - p : std::int64_t{p} - q; };
  const std::int64_t dx = apart(a.x, b.x), dy = apart(a.y, b.y);
  const bool flat = dx > dy;
  const bool reverse = flat ? b.x < a.x : b.y < a.y;
  const cell first = reverse ? b : a, last = reverse ? a : b;
  const std::int64_t n = flat ? dx : dy, m = flat ? dy : dx;
  const int sign = flat ? (last.y < first.y ? -1 : 1) : (last.x < first.x ? -1 : 1);
  std::int64_t d = 2 * m - n;  // 2 n D
  cell at = first;
  for (std::int64_t i = 0; i < n; ++i) {
    const cell ahead = flat ? cell{at.x + 1, at.y} : cell{at.x, at.y + 1};
    sight_step step{at, ahead, ahead, ahead, d, passage::none};
    if (d > 0) {
      step.aside = flat ? cell{at.x, at.y + sign} : cell{at.x + sign, at.y};
      step.next = flat ? cell{at.x + 1, at.y + sign} : cell{at.x + sign, at.y + 1};
      step.through = d < m ? passage::ahead : d > m ? passage::aside : passage::corner;
      d -= 2 * n;
    }
    d += 2 * m;
    at = step.next;
    if (!sink(static_cast<const sight_step&>(step))) return false;
  }
  return true;
}

}  // namespace IRG_ABI
}  // namespace irg::textbook
