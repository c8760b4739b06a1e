// SPDX-License-Identifier: MIT
// What a floating horizon draws, as text: U and L for the horizon, then the two ends.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include <irg/hidden/floating_horizon.hpp>

namespace test {

struct line_text {
  std::string text{};
  void operator()(const irg::cell& a, const irg::cell& b, irg::horizon_side side) {
    const auto place = [](const irg::cell& c) { return std::to_string(c.x) + "," + std::to_string(c.y); };
    text += (side == irg::horizon_side::upper ? "U" : "L") + place(a) + "-" + place(b) + " ";
  }
};

template <class Horizon>
std::string drawn(Horizon& horizon, const std::vector<irg::cell>& curve) {
  line_text lines;
  horizon.begin_curve();
  for (const irg::cell& c : curve) horizon.add(c, lines);
  return lines.text;
}

}  // namespace test
