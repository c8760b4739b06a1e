// SPDX-License-Identifier: MIT
#include <irg/render/render_rooms.hpp>

#include <cmath>
#include <cstdlib>

#include <irg/core/threads.hpp>
#include <irg/mesh/shapes.hpp>
#include <irg/raster/image.hpp>
#include <irg/scene/room_mesh.hpp>

#include "support/check_both.hpp"
#include "support/house_plans.hpp"

namespace {

// A house with a ball in each room, and the camera in one of them.
enum class walls { thick, thin };

template <class T>
irg::prepared_rooms<T> random_rooms(test::random& r, int levels, walls kind = walls::thick) {
  irg::cell_plan<T> p = test::random_house<T>(r, 100, levels);
  if (kind == walls::thick) p = test::with_thick_walls(std::move(p));
  for (auto& c : p.cells) {
    c.floor = static_cast<T>(r.integer(0, 2));
    c.ceiling = c.floor + static_cast<T>(r.integer(2, 5));
  }
  REQUIRE(irg::validate(p) == irg::plan_finding{});
  irg::portal_graph<T> doors(p);
  irg::scene<T> world;
  for (std::uint32_t c = 0; c < p.cells.size(); ++c) {
    irg::object<T> room;
    room.shape = irg::room_mesh(p, doors, c);
    const auto shade = [&] { return static_cast<T>(r.unit()); };
    const T red = shade(), green = shade(), blue = shade();
    room.surface.ambient = room.surface.diffuse = {red, green, blue};
    world.objects.push_back(room);
  }
  world.ambient = {T(0.5), T(0.5), T(0.5)};
  return {p, std::move(doors), irg::prepare_scene(world)};
}

template <class T>
void look_around(test::random& r, irg::prepared_rooms<T>& rooms) {
  const auto c = static_cast<std::size_t>(r.integer(0, static_cast<std::int64_t>(rooms.plan.cells.size()) - 1));
  const auto& cell = rooms.plan.cells[c];
  const auto between = [&](T low, T high) { return low + (high - low) * static_cast<T>(r.unit()); };
  irg::camera<T>& view = rooms.world.view;
  const T x = between(cell.corners[0].x, cell.corners[2].x), y = between(cell.corners[0].y, cell.corners[2].y);
  view.eye = {x, y, between(cell.floor, cell.ceiling)};
  if (r.integer(0, 3) == 0 && !rooms.plan.portals.empty()) {  // in a portal, on its end, or in the line of one
    const auto& d =
        rooms.plan
            .portals[static_cast<std::size_t>(r.integer(0, static_cast<std::int64_t>(rooms.plan.portals.size()) - 1))];
    const T t = static_cast<T>(r.integer(-1, 3)) / T(2);
    view.eye = {d.a.x + t * (d.b.x - d.a.x), d.a.y + t * (d.b.y - d.a.y), view.eye.z};
  }
  const double a = r.unit() * 7;
  const T height = between(T(-1), T(1)) / T(3);
  view.target = {view.eye.x + static_cast<T>(std::cos(a)), view.eye.y + static_cast<T>(std::sin(a)),
                 view.eye.z + height};
  view.up = {T(0), T(0), T(1)};
  view.vertical_angle = between(T(0.3), T(2));
  view.near_distance = T(0.01);
  view.projection = irg::projection_kind::perspective;
}

// Whether the near plane is within rooms, by the corners of a box around the eye that holds it.
template <class T>
bool is_inside(const irg::prepared_rooms<T>& rooms) {
  const irg::camera<T>& view = rooms.world.view;
  const T half = view.near_distance * T(4);
  bool inside = true;
  for (int i = 0; i < 8; ++i) {
    const irg::point<T, 3> p{view.eye.x + ((i & 1) != 0 ? half : -half), view.eye.y + ((i & 2) != 0 ? half : -half),
                             view.eye.z + ((i & 4) != 0 ? half : -half)};
    bool held = false;
    for (const auto& c : rooms.plan.cells)
      held = held || (c.corners[0].x <= p.x && p.x <= c.corners[2].x && c.corners[0].y <= p.y &&
                      p.y <= c.corners[2].y && c.floor <= p.z && p.z <= c.ceiling);
    inside = inside && held;
  }
  return inside;
}

template <class T>
int differing_pixels(std::uint64_t seed, int houses, walls kind) {
  test::random r(seed);
  int differ = 0;
  std::int64_t triangles = 0, skipped = 0;
  for (int i = 0; i < houses; ++i) {
    auto rooms = random_rooms<T>(r, 1 + i % 5, kind);
    for (int k = 0; k < 5; ++k) {
      do look_around(r, rooms);
      while (!is_inside(rooms));
      irg::render_options options;
      options.style = irg::picture_style::flat;
      irg::image<irg::rgba8> with(80, 60, {}), without(80, 60, {});
      irg::image<float> depth(80, 60, 0.0f), all(80, 60, 0.0f);
      const auto stats = irg::render(rooms, {with, depth}, options, irg::parallel{2});
      options.skip = irg::skip_nothing;
      const auto whole = irg::render(rooms, {without, all}, options);
      for (int y = 0; y < 60; ++y)
        for (int x = 0; x < 80; ++x) differ += !(with(x, y) == without(x, y)) || depth(x, y) != all(x, y);
      CHECK(stats.triangles == whole.triangles);
      CHECK(whole.skipped.rooms == 0);
      triangles += stats.triangles;
      skipped += stats.skipped.rooms;
    }
  }
  MESSAGE("triangles in rooms that are skipped: " << skipped << " of " << triangles);
  CHECK(skipped > triangles / 3);
  return differ;
}

int houses_to_try() { return std::getenv("IRG_RELEASE_TIER") != nullptr ? 2000 : 30; }

TEST_CASE("render of rooms: the same bytes with skipping on and off") {
  CHECK(differing_pixels<double>(41, houses_to_try(), walls::thick) == 0);
  CHECK(differing_pixels<float>(42, houses_to_try() / 2, walls::thick) == 0);
}

// Where two rooms share a wall without thickness, a triangle of the one beyond that is thinner than a 256th of a pixel
// may turn its front in the picture, as near as the wall that hides it.
TEST_CASE("render of rooms: walls without thickness, a pixel in millions may differ") {
  CHECK(differing_pixels<double>(43, houses_to_try(), walls::thin) <= 1 + houses_to_try() / 50);
}

TEST_CASE("visible_rooms: an eye in no room, parallel rays, and no rooms at all") {
  test::random r(43);
  auto rooms = random_rooms<double>(r, 3);
  const irg::cell_window picture{0, 0, 80, 60};
  const auto all_are_seen = [&] {
    const auto windows = irg::visible_rooms(rooms.plan, rooms.doors, rooms.world.view, {80, 60});
    bool all = windows.size() == rooms.plan.cells.size();
    for (const auto& w : windows) all = all && w == picture;
    return all;
  };
  look_around(r, rooms);
  rooms.world.view.eye.z = -9;
  CHECK(all_are_seen());
  rooms.world.view.eye = {-5, 3, 1};
  CHECK(all_are_seen());
  look_around(r, rooms);
  rooms.world.view.far_distance = 1000;
  rooms.world.view.projection = irg::projection_kind::orthographic;
  CHECK(all_are_seen());
  irg::prepared_rooms<double> none{{}, irg::portal_graph(irg::cell_plan<double>{}), {}};
  irg::image<irg::rgba8> picture_of_none(8, 6, {});
  irg::image<float> depth(8, 6, 0.0f);
  CHECK(irg::render(none, {picture_of_none, depth}).triangles == 0);
}

}  // namespace
