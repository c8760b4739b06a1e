// SPDX-License-Identifier: MIT
// Houses of cells and portals: which rooms can be seen from which, what an eye sees, and pictures with the rooms that
// no portal shows left out and drawn. Wrong are pairs that a line walked through the house sees and the sets lack, and
// pixels that differ.
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <irg/mesh/shapes.hpp>
#include <irg/raster/image.hpp>
#include <irg/render/render_rooms.hpp>
#include <irg/scene/room_mesh.hpp>
#include <irg/visibility/potentially_visible.hpp>

#include "support/measure.hpp"
#include "../tests/support/house_plans.hpp"

namespace {

using namespace bench;
using place = irg::point<double, 2>;

struct house {
  irg::cell_plan<double> plan;
  irg::portal_graph<double> doors;
  irg::visible_sets sets{};
  std::int64_t seen = 0;
};

house make_house(int levels) {
  test::random r(7);
  auto plan = test::with_thick_walls(test::random_house<double>(r, 60 << (levels / 2), levels));
  irg::portal_graph<double> doors(plan);
  return {std::move(plan), std::move(doors)};
}

place middle_of(const irg::plan_cell<double>& c) {
  return {(c.corners[0].x + c.corners[2].x) / 2, (c.corners[0].y + c.corners[2].y) / 2};
}

errors judge_sets(const house& h) {
  test::random r(8);
  errors out;
  out.wrong = 0;
  for (int i = 0; i < 20000; ++i) {
    const auto cell = static_cast<std::uint32_t>(r.integer(0, static_cast<std::int64_t>(h.doors.cell_count()) - 1));
    const auto& door =
        h.plan.portals[static_cast<std::size_t>(r.integer(0, static_cast<std::int64_t>(h.plan.portals.size()) - 1))];
    const place from = middle_of(h.plan.cells[cell]);
    const double t = r.unit();
    const place to{door.a.x + t * (door.b.x - door.a.x), door.a.y + t * (door.b.y - door.a.y)};
    for (const std::uint32_t other : test::walked_cells(h.doors, cell, from, to))
      out.wrong += !h.sets.seen.is_full({static_cast<int>(other), static_cast<int>(cell), 0});
  }
  if (out.wrong != 0) out.broken = "a cell is seen that the sets lack";
  return out;
}

void enter_sets(int levels) {
  house& h = keep(make_house(levels));
  const std::string name = std::to_string(h.plan.cells.size()) + " cells";
  const auto cells = static_cast<std::int64_t>(h.plan.cells.size());
  contender sets{"irg", [&h] { h.sets = irg::potentially_visible(h.doors); }};
  sets.judge = [&h] { return judge_sets(h); };
  enter({"potentially_visible", name + build_suffix(), "cell", cells, "", ""}, std::move(sets));
  contender views{"irg", [&h] {
                    for (std::uint32_t c = 0; c < h.doors.cell_count(); ++c)
                      irg::view_through_portals(h.doors, c,
                                                {middle_of(h.plan.cells[c]), irg::view_reach::all_round, {}, {}},
                                                [&](std::uint32_t, const auto&) { ++h.seen; });
                  }};
  enter({"view_through_portals", name + build_suffix(), "eye", cells, "", ""}, std::move(views));
}

struct frame {
  irg::prepared_rooms<double> rooms;
  irg::image<irg::rgba8> picture, other;
  irg::image<float> depth;
  double percent = 0;  // of the cells that may be seen
};

// A room with rows of balls on its floor, so many a side.
void furnish(irg::mesh<double>& room, const irg::plan_cell<double>& c, int side) {
  const irg::mesh<double> ball = irg::shape_sphere<double>({48, 24});
  const place low = c.corners[0], high = c.corners[2];
  for (int i = 0; i < side * side; ++i) {
    const irg::vec<double, 3> at{low.x + (high.x - low.x) * (i % side + 0.5) / side,
                                 low.y + (high.y - low.y) * (i / side + 0.5) / side, 0.5};
    const auto first = static_cast<std::uint32_t>(room.positions.size());
    for (const auto& p : ball.positions)
      room.positions.push_back({at.x + 0.4 * p.x, at.y + 0.4 * p.y, at.z + 0.4 * p.z});
    for (std::size_t f = 0; f < ball.face_count(); ++f) {
      std::vector<std::uint32_t> face;
      for (std::size_t k = 0; k < ball.face_size(f); ++k) face.push_back(first + ball.corner(f, k).position);
      irg::add_face(room, face);
    }
  }
}

constexpr int picture_width = 640, picture_height = 480;

// The percentage of the cells of which something may be seen.
double percent_seen(const house& h, const irg::camera<double>& view) {
  std::size_t seen = 0;
  for (const auto& w : irg::visible_rooms(h.plan, h.doors, view, {picture_width, picture_height})) seen += !w.empty();
  return 100.0 * static_cast<double>(seen) / static_cast<double>(h.plan.cells.size());
}

// Of the eyes in the middles of all cells that look in one of sixteen directions, the one that sees nearest to so many
// percent of the cells.
irg::camera<double> view_that_sees(const house& h, double percent) {
  irg::camera<double> best{};
  double off = 100;
  for (const auto& c : h.plan.cells)
    for (int i = 0; i < 16; ++i) {
      const place at = middle_of(c);
      irg::camera<double> view;
      view.eye = {at.x, at.y, 1.7};
      view.target = {at.x + std::cos(i * 0.39269908), at.y + std::sin(i * 0.39269908), 1.65};
      view.up = {0, 0, 1};
      const double by = std::fabs(percent_seen(h, view) - percent);
      if (by < off) off = by, best = view;
    }
  return best;
}

frame make_frame(int levels, int side) {
  house h = make_house(levels);
  irg::scene<double> world;
  for (std::uint32_t c = 0; c < h.plan.cells.size(); ++c) {
    irg::mesh<double> room = irg::room_mesh(h.plan, h.doors, c);
    const auto& corners = h.plan.cells[c].corners;
    if (corners[2].x - corners[0].x > 4 && corners[2].y - corners[0].y > 4) furnish(room, h.plan.cells[c], side);
    world.objects.push_back({std::move(room)});
  }
  world.view = view_that_sees(h, 5);
  world.ambient = {0.5, 0.5, 0.5};
  const double percent = percent_seen(h, world.view);
  return {{h.plan, std::move(h.doors), irg::prepare_scene(world)},
          irg::image<irg::rgba8>(picture_width, picture_height, {}),
          irg::image<irg::rgba8>(picture_width, picture_height, {}),
          irg::image<float>(picture_width, picture_height, 0.0f),
          percent};
}

void enter_frame(int levels, int side) {
  frame& f = keep(make_frame(levels, side));
  std::size_t triangles = 0;
  for (const auto& o : f.rooms.world.objects) triangles += o.body.triangles.size();
  const contest what{"render of rooms",
                     std::to_string(f.rooms.plan.cells.size()) + " cells of " + std::to_string(triangles) +
                         " triangles" + build_suffix(),
                     "picture",
                     1,
                     "",
                     ""};
  const auto draw = [&f](irg::skipping rooms, irg::skipping others, irg::image<irg::rgba8>& into) {
    irg::render_options o;
    o.skip = {others, others, others, rooms};
    irg::render(f.rooms, {into, f.depth}, o);
  };
  contender skipped{"irg", [&f, draw] { draw(irg::skipping::on, irg::skipping::on, f.picture); }};
  skipped.judge = [&f, draw] {
    draw(irg::skipping::off, irg::skipping::off, f.other);
    errors out;
    out.wrong = 0;
    out.note = std::to_string(f.percent).substr(0, 4) + " % of the cells may be seen";
    for (int y = 0; y < picture_height; ++y)
      for (int x = 0; x < picture_width; ++x) out.wrong += !(f.picture(x, y) == f.other(x, y));
    if (out.wrong != 0) out.broken = "a pixel differs";
    return out;
  };
  enter(what, std::move(skipped));
  enter(what, {"irg:all rooms", [&f, draw] { draw(irg::skipping::off, irg::skipping::on, f.picture); }});
  enter(what, {"irg:all rooms and nothing else skipped",
               [&f, draw] { draw(irg::skipping::off, irg::skipping::off, f.picture); }});
}

}  // namespace

int main(int argc, char** argv) {
  for (const int levels : smoke() ? std::vector<int>{4} : std::vector<int>{4, 6, 8, 10}) enter_sets(levels);
  for (const int side : smoke() ? std::vector<int>{1} : std::vector<int>{1, 2, 3}) enter_frame(smoke() ? 3 : 7, side);
  return run_benchmarks(argc, argv);
}
