// SPDX-License-Identifier: MIT
// Fields of view on grids: by irg's sweeps, by a thesis' search with its savings, and by libtcod where it is installed.
// Wrong are cells that has_line_of_sight() judges otherwise; of large maps 20,000 cells drawn at random are asked for.
#include <algorithm>
#include <span>
#include <vector>

#include <irg/visibility/field_of_view.hpp>
#include <irg/visibility/textbook/sight_search.hpp>

#include "support/measure.hpp"
#include "../tests/support/random.hpp"

#if defined(IRG_HAVE_TCOD)
#include <libtcod/fov.h>
#endif

namespace {

using namespace bench;

struct task {
  irg::walled_grid map;
  std::vector<irg::cell3> viewers;
  irg::cell_grid seen;
  irg::view_memory memory;
};

// A map with so many full cells of 1000, none of them a viewer's.
task make_task(const irg::grid_extent& e, int per_thousand, int viewers) {
  test::random r(5);
  task t{irg::walled_grid(e), {}, irg::cell_grid(e), {}};
  for (int z = 0; z < e.depth; ++z)
    for (int y = 0; y < e.height; ++y)
      for (int x = 0; x < e.width; ++x)
        if (r.integer(0, 999) < per_thousand) t.map.set({x, y, z});
  for (int i = 0; i < viewers; ++i) {
    const auto near_the_middle = [&](int size) { return static_cast<int>(r.integer(size / 4, size - size / 4 - 1)); };
    const irg::cell3 at = i == 0 ? irg::cell3{e.width / 2, e.height / 2, e.depth / 2}
                                 : irg::cell3{near_the_middle(e.width), near_the_middle(e.height), e.depth / 2};
    t.viewers.push_back(at);
    t.map.set(at, false);
  }
  return t;
}

errors judged(const task& t, bool promised) {
  const irg::grid_extent e = t.map.extent();
  const std::int64_t cells = std::int64_t{e.width} * e.height * e.depth;
  const auto differs = [&](const irg::cell3& c) {
    const bool exact =
        std::ranges::any_of(t.viewers, [&](const irg::cell3& u) { return irg::has_line_of_sight(t.map, u, c); });
    return exact != t.seen.is_full(c);
  };
  errors out;
  out.wrong = 0;
  if (cells <= 20000) {
    for (int z = 0; z < e.depth; ++z)
      for (int y = 0; y < e.height; ++y)
        for (int x = 0; x < e.width; ++x) out.wrong += differs({x, y, z});
  } else {
    test::random r(6);
    for (int i = 0; i < 20000; ++i) {
      const auto any = [&](int size) { return static_cast<int>(r.integer(0, size - 1)); };
      const int x = any(e.width), y = any(e.height);
      out.wrong += differs({x, y, any(e.depth)});
    }
    out.note = "wrong ones of 20000 cells";
  }
  if (promised && out.wrong != 0) out.broken = "a cell is seen that has_line_of_sight() hides, or the other way round";
  return out;
}

template <class Run>
void add(const contest& what, const std::string& who, task& t, bool promised, const Run& run) {
  contender c{who, [&t, run] { run(t); }};
  c.judge = [&t, promised] { return judged(t, promised); };
  enter(what, std::move(c));
}

#if defined(IRG_HAVE_TCOD)
// libtcod keeps map and field in one: its cells are copied when they are judged, out of the time.
void add_libtcod(const contest& what, const std::string& who, task& t, TCOD_fov_algorithm_t algorithm) {
  const irg::grid_extent e = t.map.extent();
  auto* const map = TCOD_map_new(e.width, e.height);
  keep_alive(std::shared_ptr<void>(map, [](void* p) { TCOD_map_delete(static_cast<TCOD_Map*>(p)); }));
  for (int y = 0; y < e.height; ++y)
    for (int x = 0; x < e.width; ++x) TCOD_map_set_properties(map, x, y, !t.map.is_full({x, y, 0}), true);
  contender c{who,
              [map, &t, algorithm] { TCOD_map_compute_fov(map, t.viewers[0].x, t.viewers[0].y, 0, true, algorithm); }};
  c.judge = [map, &t, e] {
    t.seen.clear();
    for (int y = 0; y < e.height; ++y)
      for (int x = 0; x < e.width; ++x)
        if (TCOD_map_is_in_fov(map, x, y)) t.seen.set({x, y, 0});
    return judged(t, false);
  };
  enter(what, std::move(c));
}
#endif

void enter_map(const std::string& name, const irg::grid_extent& e, int per_thousand, int viewers = 1) {
  task& t = keep(make_task(e, per_thousand, viewers));
  const contest what{"field_of_view", name + build_suffix(), "field", 1, "", ""};
  add(what, "irg", t, true, [](task& of) {
    of.seen.clear();
    for (const irg::cell3& u : of.viewers) irg::add_field_of_view(of.map, u, of.seen, of.memory);
  });
  if (e.width <= 21) {
    using irg::textbook::sight_saving;
    std::vector<irg::cell> units;
    for (const irg::cell3& u : t.viewers) units.push_back({u.x, u.y});
    for (const auto& [who, saving] :
         {std::pair{"thesis", sight_saving::none}, std::pair{"thesis:auxiliary field", sight_saving::auxiliary_field},
          std::pair{"thesis:list of visible cells", sight_saving::visible_list}})
      add(what, who, t, false,
          [units, saving](task& of) { of.seen = irg::textbook::sight_search(of.map, std::span(units), saving).seen; });
  }
#if defined(IRG_HAVE_TCOD)
  if (e.depth == 1 && viewers == 1) {
    add_libtcod(what, "libtcod shadow", t, FOV_SHADOW);
    add_libtcod(what, "libtcod restrictive", t, FOV_RESTRICTIVE);
    add_libtcod(what, "libtcod symmetric", t, FOV_SYMMETRIC_SHADOWCAST);
    add_libtcod(what, "libtcod permissive 8", t, FOV_PERMISSIVE_8);
  }
#endif
}

}  // namespace

int main(int argc, char** argv) {
  const int side = smoke() ? 100 : 1000;
  const std::string flat = std::to_string(side) + "x" + std::to_string(side);
  enter_map("20x21 open", {20, 21, 1}, 0);
  enter_map("20x21 20 %", {20, 21, 1}, 200);
  for (int n = 2; n <= 7; ++n) enter_map("20x21 20 % " + std::to_string(n) + " units", {20, 21, 1}, 200, n);
  enter_map("20x21 open 7 units", {20, 21, 1}, 0, 7);
  enter_map(flat + " open", {side, side, 1}, 0);
  enter_map(flat + " 0.2 %", {side, side, 1}, 2);
  enter_map(flat + " 5 %", {side, side, 1}, 50);
  enter_map(flat + " 40 %", {side, side, 1}, 400);
  for (const int cube : smoke() ? std::vector<int>{24} : std::vector<int>{128, 256}) {
    const std::string name = std::to_string(cube) + "^3";
    enter_map(name + " open", {cube, cube, cube}, 0);
    enter_map(name + " 0.2 %", {cube, cube, cube}, 2);
    enter_map(name + " 5 %", {cube, cube, cube}, 50);
  }
  return run_benchmarks(argc, argv);
}
