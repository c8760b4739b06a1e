// SPDX-License-Identifier: MIT
// A world of cubes with units in it, as one state that lines of text change: what grid_world's script and its window
// have in common.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <irg/colour/srgb.hpp>
#include <irg/io/grid_text.hpp>
#include <irg/io/image_file.hpp>
#include <irg/math/constants.hpp>
#include <irg/math/decimal.hpp>
#include <irg/math/trigonometry.hpp>
#include <irg/render/pick.hpp>
#include <irg/render/render.hpp>
#include <irg/visibility/field_of_view.hpp>
#include <irg/visibility/unit_sight.hpp>

#include "cell_sight.hpp"
#include "picture_options.hpp"

namespace program {

/// A map, the units that look about in it, and a camera. Row y of layer z stands at (x, z, y): y points up in pictures.
class grid_world {
public:
  grid_world(irg::grid_text map, int width, int height) : map_(std::move(map)) {
    resize(width, height);
    const irg::grid_extent e = map_.grid.extent();
    const double size = std::max({e.width, e.height, e.depth});
    eye_ = {e.width * 0.5, e.depth + size, e.height + size * 0.4};
    elevation_ =
        -irg::atan2(eye_.y, eye_.z - e.height * 0.5) * 180 / irg::pi<double>;  // the map's middle in the middle
    look();
  }

  const std::vector<irg::cell3>& units() const { return map_.units; }
  std::int64_t seen() const { return sight_.seen.count(); }
  std::int64_t seen_in_part() const { return sight_.partial.count(); }
  bool by_thesis() const { return by_thesis_; }
  int test() const { return in_space_ ? 3 : 2; }
  /// What no picture is written over; empty where nothing was read from a file.
  void keep_files(std::string map, std::string script) {
    map_file_ = std::move(map);
    script_file_ = std::move(script);
  }
  const std::string& failed_to_write() const { return failed_; }
  /// Removes the pictures that were written.
  void remove_files() const {
    for (const std::string& file : written_) remove_written(file);
  }
  void resize(int width, int height) {
    picture_ = irg::image<irg::rgba8>(width, height);
    depth_ = irg::image<float>(width, height);
  }

  /// Does what a line asks for; empty, or why it cannot be, and then the world is as it was.
  std::string run(std::string_view line) {
    const std::vector<std::string_view> words = words_of(line);
    if (words.empty()) return "";
    const std::vector<double> numbers = numbers_of(words);
    const auto is = [&](std::string_view name, std::size_t count) {
      return words[0] == name && words.size() == count + 1 && numbers.size() == count;
    };
    if (is("click", 2)) return click(numbers[0], numbers[1]);
    if (is("turn", 2)) return turn(numbers[0], numbers[1]);
    if (is("walk", 2)) return walk(numbers[0], numbers[1]);
    if (is("test", 1) && (numbers[0] == 2 || numbers[0] == 3)) {
      in_space_ = numbers[0] == 3;
      look();
      return "";
    }
    if (words[0] == "method" && words.size() == 2 && (words[1] == "exact" || words[1] == "thesis")) {
      by_thesis_ = words[1] == "thesis";
      look();
      return "";
    }
    if (words[0] == "picture" && words.size() == 2) return save(std::string(words[1]));
    return "no such line: click X Y, walk FORWARD RIGHT, turn RIGHT UP, test 2, test 3, method exact, method thesis, "
           "picture FILE";
  }

  irg::image<irg::rgba8>& draw() {
    irg::render(with_camera(), {picture_, depth_},
                {.style = irg::picture_style::flat,
                 .culling = irg::face_culling::none,
                 .colours = {.background = {214, 226, 238, 255}}});
    return picture_;
  }

private:
  // Walls stand by the number of their kind behind no_wall.
  enum part : std::size_t {
    dark_floor,
    lit_floor,
    partly_lit_floor,
    dark_cube,
    lit_cube,
    partly_lit_cube,
    unit,
    no_wall,
    parts = no_wall + wall_colours.size()
  };

  // One layer of a map, as a map in the plane.
  struct layer {
    const irg::walled_grid& map;
    int z;
    irg::grid_extent extent() const { return {map.extent().width, map.extent().height, 1}; }
    bool is_full(const irg::cell3& c) const { return map.is_full({c.x, c.y, z}); }
    bool has_wall(const irg::cell3& c, int axis) const { return map.has_wall({c.x, c.y, z}, axis); }
  };

  static std::vector<std::string_view> words_of(std::string_view line) {
    std::vector<std::string_view> words;
    line = line.substr(0, line.find('#'));
    for (std::size_t i = 0; (i = line.find_first_not_of(" \t\r", i)) != line.npos;) {
      const std::size_t end = std::min(line.find_first_of(" \t\r", i), line.size());
      words.push_back(line.substr(i, end - i));
      i = end;
    }
    return words;
  }
  static std::vector<double> numbers_of(const std::vector<std::string_view>& words) {
    std::vector<double> numbers;
    for (std::size_t i = 1; i < words.size(); ++i) {
      const char* const end = words[i].data() + words[i].size();
      const auto n = irg::parse_decimal<double>(words[i].data(), end);
      const bool fits = n.status != irg::decimal_status::none && n.status != irg::decimal_status::overflow;
      if (fits && n.end == end && n.value >= -1e6 && n.value <= 1e6) numbers.push_back(n.value);
    }
    return numbers;
  }

  std::string click(double x, double y) {
    const irg::extent2 size{picture_.width(), picture_.height()};
    const auto hit =
        irg::pick(with_camera(), size, {static_cast<int>(x), static_cast<int>(y)}, irg::face_culling::none);
    if (!hit) return "there is nothing under the cursor";
    const std::optional<irg::cell3> at = beside_[hit->object][hit->face];
    if (!at) return "no cell under the cursor is free";
    map_.units.push_back(*at);
    look();
    return "";
  }
  std::string turn(double right, double up) {
    azimuth_ = std::remainder(azimuth_ + right, 360.0);
    elevation_ = irg::clamped(elevation_ + up, -89.0, 89.0);
    return "";
  }
  std::string walk(double forward, double right) {
    const double c = irg::cos_degrees(azimuth_), s = irg::sin_degrees(azimuth_);
    eye_ = eye_ + irg::vec<double, 3>{s * forward + c * right, 0, s * right - c * forward};
    return "";
  }
  std::string save(const std::string& file) {
    if (!irg::image_format_of_name(file)) return "the picture's name must end in .png, .ppm or .svg: " + file;
    if (one_file(file, map_file_)) return "the map would be overwritten: " + file;
    if (one_file(file, script_file_)) return "the script would be overwritten: " + file;
    if (const auto saved = irg::save_image(file, draw()); !saved)
      return failed_ = std::string(saved.error().message) + ": " + file;
    written_.push_back(file);
    return "";
  }

  // What the units see: in space everything, in the plane what lies in their own layers.
  void look() {
    using irg::textbook::sight;
    const irg::grid_extent e = map_.grid.extent();
    const std::span<const irg::cell3> units(map_.units);
    if (in_space_ && !by_thesis_) {
      sight_ = {irg::field_of_view(map_.grid, units), irg::cell_grid(e)};
    } else if (in_space_) {
      sight_ = sight_by(e, units, [&](const irg::cell3& u, const irg::cell3& c) {
        return thesis_sight(map_.grid, u, c, irg::textbook::three_axis_rule::thesis);
      });
    } else {
      sight_ = sight_by(e, units, [&](const irg::cell3& u, const irg::cell3& c) {
        if (u.z != c.z) return sight::blocked;
        if (by_thesis_) return irg::textbook::sight_2d(layer{map_.grid, c.z}, {u.x, u.y}, {c.x, c.y});
        return irg::has_line_of_sight(map_.grid, u, c) ? sight::full : sight::blocked;
      });
    }
    build();
  }

  // A quadrangle of a part, and the free cell beside it.
  void add(part kind, const std::array<irg::point<double, 3>, 4>& corners, const std::optional<irg::cell3>& beside) {
    auto& shape = scene_.objects[kind].shape;
    std::array<std::uint32_t, 4> face;
    for (std::size_t i = 0; i < 4; ++i) {
      face[i] = static_cast<std::uint32_t>(shape.positions.size());
      shape.positions.push_back(corners[i]);
    }
    irg::add_face(shape, face);
    beside_[kind].push_back(beside);
  }
  // The side of a box that lies towards `axis` of the map, at its lower or its upper end.
  void add_side(part kind, const irg::point<double, 3>& low, const irg::point<double, 3>& high, int axis, bool upper,
                const std::optional<irg::cell3>& beside) {
    std::array<irg::point<double, 3>, 4> corners;
    for (int i = 0; i < 4; ++i) {
      const bool first = (i == 1 || i == 2) != upper, second = i >= 2;
      const auto side = [&](int k) { return k == axis ? upper : k == (axis + 1) % 3 ? first : second; };
      const auto at = [&](int k) { return irg::coordinate(side(k) ? high : low, k); };
      corners[static_cast<std::size_t>(i)] = {at(0), at(2), at(1)};
    }
    add(kind, corners, beside);
  }

  // The wall between c and the next cell along an axis: whole where it blocks and half as high for a half wall, the two
  // posts of an open door, three beams of a laser field.
  void add_wall(const irg::cell3& c, int axis) {
    const irg::wall_kind kind = map_.grid.wall(c, axis);
    const auto strip = [&](int across, double from, double to) {
      irg::point<double, 3> low{double(c.x), double(c.y), double(c.z)}, high{c.x + 1.0, c.y + 1.0, c.z + 1.0};
      const double base = irg::coordinate(low, across);
      (across == 0 ? low.x : across == 1 ? low.y : low.z) = base + from;
      (across == 0 ? high.x : across == 1 ? high.y : high.z) = base + to;
      add_side(static_cast<part>(no_wall + static_cast<std::size_t>(kind)), low, high, axis, true, std::nullopt);
    };
    const int along = axis == 0 ? 1 : 0, up = axis == 2 ? 1 : 2;
    switch (kind) {
      case irg::wall_kind::none: break;
      case irg::wall_kind::wall:
      case irg::wall_kind::closed_door: strip(up, 0, 1); break;
      case irg::wall_kind::half_wall: strip(up, 0, 0.5); break;
      case irg::wall_kind::open_door:
        strip(along, 0, 0.15);
        strip(along, 0.85, 1);
        break;
      case irg::wall_kind::laser_field:
        for (const double at : {0.2, 0.5, 0.8}) strip(up, at - 0.03, at + 0.03);
    }
  }

  void build() {
    std::array<irg::rgb<double>, parts> colours{};
    colours[dark_floor] = {0.25, 0.25, 0.24}, colours[dark_cube] = {0.14, 0.17, 0.25};
    colours[lit_floor] = {0.95, 0.78, 0.3}, colours[lit_cube] = {0.45, 0.3, 0.14};
    colours[partly_lit_floor] = {0.5, 0.6, 0.25}, colours[partly_lit_cube] = {0.22, 0.28, 0.12};
    colours[unit] = {0.7, 0.2, 0.12};
    for (std::size_t kind = 1; kind < wall_colours.size(); ++kind) {
      const irg::rgb<float> light = irg::decode(wall_colours[kind]);
      colours[no_wall + kind] = {double(light.r), double(light.g), double(light.b)};
    }
    scene_.objects.assign(parts, {});
    beside_.assign(parts, {});
    for (std::size_t i = 0; i < parts; ++i) scene_.objects[i].surface = {colours[i], colours[i], {}, 1};
    scene_.lights = {{{0.4, 1, 0.7, 0}, {0.7, 0.7, 0.7}}};
    scene_.ambient = {0.4, 0.4, 0.4};
    const irg::grid_extent e = map_.grid.extent();
    const auto free = [&](const irg::cell3& c) -> std::optional<irg::cell3> {
      if (!e.holds(c) || map_.grid.is_full(c)) return std::nullopt;
      return c;
    };
    for (int z = 0; z < e.depth; ++z)
      for (int y = 0; y < e.height; ++y)
        for (int x = 0; x < e.width; ++x) {
          const irg::cell3 c{x, y, z};
          const irg::point<double, 3> low{double(x), double(y), double(z)}, high{x + 1.0, y + 1.0, z + 1.0};
          const bool full = map_.grid.is_full(c), lit = sight_.seen.is_full(c), partly = sight_.partial.is_full(c);
          if (!full && z == 0)
            add_side(partly ? partly_lit_floor : lit ? lit_floor : dark_floor, low, high, 2, false, c);
          for (int axis = 0; axis < 3; ++axis) {
            for (const bool upper : {false, true}) {
              irg::cell3 next = c;
              (axis == 0 ? next.x : axis == 1 ? next.y : next.z) += upper ? 1 : -1;
              if (full && next.z >= 0 && !(e.holds(next) && map_.grid.is_full(next)))
                add_side(partly ? partly_lit_cube : lit ? lit_cube : dark_cube, low, high, axis, upper, free(next));
            }
            add_wall(c, axis);
          }
        }
    for (const irg::cell3& u : map_.units) {
      const irg::point<double, 3> low{u.x + 0.3, u.y + 0.3, u.z + 0.0}, high{u.x + 0.7, u.y + 0.7, u.z + 0.6};
      for (int axis = 0; axis < 3; ++axis)
        for (const bool upper : {false, true}) add_side(unit, low, high, axis, upper, std::nullopt);
    }
  }

  const irg::scene<double>& with_camera() {
    const double level = irg::cos_degrees(elevation_);
    scene_.view.eye = eye_;
    scene_.view.target = eye_ + irg::vec<double, 3>{level * irg::sin_degrees(azimuth_), irg::sin_degrees(elevation_),
                                                    -level * irg::cos_degrees(azimuth_)};
    return scene_;
  }

  irg::grid_text map_;
  cell_sight sight_{};
  bool in_space_ = true, by_thesis_ = false;
  irg::point<double, 3> eye_{};
  double azimuth_ = 0, elevation_ = 0;  // degrees: to the right from the rows' y downwards, and up
  irg::scene<double> scene_{};
  std::vector<std::vector<std::optional<irg::cell3>>> beside_{};
  irg::image<irg::rgba8> picture_{};
  irg::image<float> depth_{};
  std::string failed_{}, map_file_{}, script_file_{};
  std::vector<std::string> written_{};
};

}  // namespace program
