// SPDX-License-Identifier: MIT
// Faces that hide each other in every way, for tests of hidden-surface methods; and the picture of them, by an oracle that
// shares no code with the methods.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <utility>
#include <vector>

#include <irg/raster/draw_counts.hpp>
#include <irg/raster/image.hpp>
#include <irg/raster/screen_face.hpp>

#include "support/random.hpp"
#include "support/visibility_oracle.hpp"

namespace test {

using face_list = std::vector<irg::screen_face>;
using id_image = irg::image<std::uint32_t>;

/// What the faces of a scene are like.
enum class face_scene {
  any,  // of all sizes and depths
  crossing,  // large, through each other
  cycles,  // three rods each, over each other in turn
  coplanar,  // in a few planes, exactly
  slivers,  // long, thinner than two pixels
  repeated,  // the same ones again, some edge on, some with common edges
  tiny,  // about a pixel
  huge,  // far beyond the picture
  pencil  // all through one line
};
inline constexpr int face_scenes = 9;

class face_scene_maker {
public:
  face_scene_maker(std::uint64_t seed, int size) : r_(seed), size_(size) {}

  /// n faces or a few more, their numbers shuffled.
  face_list operator()(face_scene kind, int n) {
    list_.clear();
    while (static_cast<int>(list_.size()) < n) add(kind);
    std::vector<std::uint32_t> numbers;
    for (std::size_t i = 0; i < list_.size(); ++i) numbers.push_back(static_cast<std::uint32_t>(i));
    for (std::size_t i = numbers.size(); i > 1; --i)
      std::swap(numbers[i - 1], numbers[static_cast<std::size_t>(r_.integer(0, static_cast<std::int64_t>(i) - 1))]);
    face_list faces;
    for (std::size_t i = 0; i < list_.size(); ++i)
      faces.push_back(irg::make_screen_face(list_[i].v[0], list_[i].v[1], list_[i].v[2], numbers[i]));
    return faces;
  }

private:
  struct corners {
    irg::screen_vertex v[3];
  };
  int position(int reach) { return static_cast<int>(r_.integer(-reach, reach)); }
  float depth() { return static_cast<float>(r_.integer(1 << 10, 1 << 20)) * 0x1p-20f; }
  irg::screen_vertex vertex(int x, int y, float z) const { return {{x, y}, z}; }

  void add(face_scene kind) {
    const int pixel = 256, all = size_ * pixel;
    const auto around = [&](int reach) {
      const int x = position(all) / 2 + all / 2, y = position(all) / 2 + all / 2;
      const auto v = [&] {  // one by one: arguments are evaluated in any order
        const int dx = position(reach), dy = position(reach);
        return vertex(x + dx, y + dy, depth());
      };
      const irg::screen_vertex a = v(), b = v(), c = v();
      list_.push_back({{a, b, c}});
    };
    switch (kind) {
      case face_scene::any: return around(1 << r_.integer(8, 15));
      case face_scene::crossing: return around(all);
      case face_scene::cycles: return cycle();
      case face_scene::coplanar: return in_a_plane();
      case face_scene::slivers: return sliver();
      case face_scene::tiny: return around(300);
      case face_scene::huge: return around(1 << 24);
      case face_scene::pencil: {
        const int far_away = all * 4;
        const auto v = [&](int x) {
          const int y = position(all * 2);
          return vertex(x, y, depth());
        };
        const irg::screen_vertex a = v(all / 2 + position(far_away)), b = v(all / 2 - position(far_away));
        list_.push_back({{vertex(all / 2, all / 2, 0.5f), a, b}});
        return;
      }
      default:
        if (list_.empty() || r_.integer(0, 2) == 0) return around(1 << 13);
        corners c = list_[static_cast<std::size_t>(r_.integer(0, static_cast<std::int64_t>(list_.size()) - 1))];
        const int how = static_cast<int>(r_.integer(0, 3));
        if (how == 1) std::swap(c.v[0], c.v[2]);
        if (how == 2) {
          const int x = position(all), y = position(all);
          const float z = depth();
          c.v[r_.integer(0, 2)] = vertex(x, y, z);
        }
        if (how == 3) c.v[2].position = c.v[1].position;
        list_.push_back(c);
    }
  }

  // Three rods, each over the next at one end and under the one before at the other.
  void cycle() {
    const int reach = 256 * static_cast<int>(r_.integer(6, size_ / 2)), wide = reach / 8;
    const int x = static_cast<int>(r_.integer(0, size_ * 256)), y = static_cast<int>(r_.integer(0, size_ * 256));
    const float low = depth() / 2, high = low + depth() / 4;
    const bool turned = r_.integer(0, 1) == 0;
    const int px[] = {0, 866, -866}, py[] = {-1000, 500, 500};
    for (int i = 0; i < 3; ++i) {
      const int ax = px[i] * reach / 1000, ay = py[i] * reach / 1000, bx = px[(i + 1) % 3] * reach / 1000,
                by = py[(i + 1) % 3] * reach / 1000;
      // Beyond both ends, so that rods cross near the corners.
      const int dx = (bx - ax) / 4, dy = (by - ay) / 4, nx = dy * wide / reach, ny = -dx * wide / reach;
      const float at_a = turned ? high : low, at_b = turned ? low : high;
      const auto a1 = vertex(x + ax - dx - nx, y + ay - dy - ny, at_a),
                 a2 = vertex(x + ax - dx + nx, y + ay - dy + ny, at_a);
      const auto b1 = vertex(x + bx + dx - nx, y + by + dy - ny, at_b),
                 b2 = vertex(x + bx + dx + nx, y + by + dy + ny, at_b);
      list_.push_back({{a1, a2, b1}});
      list_.push_back({{a2, b2, b1}});
    }
  }

  // Depths that are exact: a whole number of 2^-22 for each 1/256 pixel.
  void in_a_plane() {
    const std::int64_t plane = r_.integer(0, 3), right = plane * 3 - 4, down = 2 - plane;
    const auto v = [&] {
      const int x = static_cast<int>(r_.integer(0, size_ * 2)) * 128,
                y = static_cast<int>(r_.integer(0, size_ * 2)) * 128;
      return vertex(x, y, static_cast<float>((1 << 21) + right * x + down * y) * 0x1p-22f);
    };
    const irg::screen_vertex a = v(), b = v(), c = v();
    list_.push_back({{a, b, c}});
  }

  void sliver() {
    const int all = size_ * 256;
    const int ax = position(all), ay = position(all), bx = all + position(all), by = all + position(all);
    const int along = static_cast<int>(r_.integer(0, 64));
    const int cx = ax + (bx - ax) / 64 * along + position(500), cy = ay + (by - ay) / 64 * along + position(500);
    const irg::screen_vertex a = vertex(ax, ay, depth()), b = vertex(bx, by, depth()), c = vertex(cx, cy, depth());
    list_.push_back({{a, b, c}});
  }

  random r_;
  int size_;
  std::vector<corners> list_{};
};

/// What is seen: by the oracle.
using face_oracle = visibility_oracle<irg::nearer_is_greater>;
inline face_oracle oracle_of(const face_list& faces, int width, int height) {
  std::vector<snapped_triangle> triangles;
  for (const irg::screen_face& f : faces)
    if (f.coverage.double_area != 0) triangles.push_back({{f.v[0], f.v[1], f.v[2]}, f.number + 1});
  return {std::move(triangles), width, height};
}
inline id_image ids_of(const face_oracle& oracle, int width, int height) {
  id_image ids(width, height, irg::no_index);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      if (const std::uint32_t id = oracle.at(x, y).nearest; id != 0) ids(x, y) = id - 1;
  return ids;
}
inline id_image exact_ids(const face_list& faces, int width, int height) {
  return ids_of(oracle_of(faces, width, height), width, height);
}

/// What a method finds.
template <class Method>
constexpr id_image ids_of(const Method& method, const face_list& faces, int width, int height) {
  id_image ids(width, height, irg::no_index);
  irg::draw_counts counts;
  method(faces, irg::cell_window{0, 0, width, height}, ids, counts);
  return ids;
}

inline int differing(const id_image& a, const id_image& b) {
  int n = 0;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x) n += a(x, y) != b(x, y);
  return n;
}

/// Pixels in which the method's picture differs from the oracle's, over some scenes of every kind. methods_test.cpp has
/// more of them.
template <class Method>
int differing_pixels(const Method& method, std::uint64_t seed, int scenes) {
  constexpr int size = 40;
  int wrong = 0;
  random r(seed);
  for (int s = 0; s < scenes; ++s) {
    face_scene_maker make(r.next(), size);
    const face_list faces = make(static_cast<face_scene>(s % face_scenes), static_cast<int>(r.integer(32, 96)));
    wrong += differing(ids_of(method, faces, size, size), exact_ids(faces, size, size));
  }
  return wrong;
}

}  // namespace test
