// SPDX-License-Identifier: MIT
// What the tests of readers and writers of meshes share: outcomes as text, damage to files, random meshes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include <doctest/doctest.h>

#include <irg/core/result.hpp>
#include <irg/mesh/mesh.hpp>
#include <irg/mesh/validate.hpp>

#include "support/random.hpp"

namespace test {

inline std::string as_text(const std::vector<std::uint8_t>& data) { return {data.begin(), data.end()}; }

/// The error as "line:column message", or "" for a mesh, which must be sound.
template <class T>
std::string outcome_of(const irg::result<irg::mesh<T>>& r) {
  if (r) {
    REQUIRE(irg::validate(*r) == irg::mesh_finding{});
    return "";
  }
  REQUIRE(std::strlen(r.error().message) > 10);
  return std::to_string(r.error().line) + ":" + std::to_string(r.error().column) + " " + r.error().message;
}

/// Whether the place of an error lies in the data or right behind them.
inline bool place_exists(std::string_view data, const irg::parse_error& e) {
  if (e.line == 0) return e.column <= data.size() + 1;
  std::size_t line = 1, column = 1;
  if (data.starts_with("\xEF\xBB\xBF")) data.remove_prefix(3);
  for (std::size_t i = 0;; ++i) {
    if (line == e.line && column == e.column) return true;
    if (i == data.size()) return false;
    const bool ends = data[i] == '\n' || (data[i] == '\r' && (i + 1 == data.size() || data[i + 1] != '\n'));
    line += ends ? 1 : 0;
    column = ends ? 1 : column + 1;
  }
}

/// Reads the data cut off everywhere, and with random data changed, doubled and taken away: always a sound mesh or an
/// error with a place. Returns how many of the cut ones were errors.
template <class Read>
int damage(const std::string& data, const Read& read, int changes, std::uint64_t seed) {
  int errors = 0;
  const auto check = [&](std::string_view damaged) {
    const auto r = read(damaged);
    outcome_of(r);
    if (!r) REQUIRE(place_exists(damaged, r.error()));
    return !r;
  };
  for (std::size_t length = 0; length < data.size(); ++length)
    errors += check(std::string_view(data).substr(0, length)) ? 1 : 0;
  random r(seed);
  for (int i = 0; i < changes; ++i) {
    std::string damaged = data;
    for (std::int64_t k = r.integer(1, 3); k > 0; --k) {
      const auto at = static_cast<std::size_t>(r.integer(0, static_cast<std::int64_t>(damaged.size()) - 1));
      const std::int64_t how = r.integer(0, 3);
      const auto byte = static_cast<char>(r.integer(-128, 127));
      if (how == 0) damaged[at] = byte;
      if (how == 1) damaged.erase(at, 1);
      if (how == 2) damaged.insert(at, 1, byte);
      if (how == 3) damaged.insert(at, damaged.substr(at, 12));
      if (damaged.empty()) break;
    }
    check(damaged);
  }
  return errors;
}

/// A finite number of any bits.
template <class T>
T any_finite(random& r) {
  for (;;) {
    using bits_type = std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>;
    const auto bits = static_cast<bits_type>(r.next());
    T x;
    std::memcpy(&x, &bits, sizeof x);
    if (x - x == 0) return x;
  }
}

enum class attributes { none, of_vertices };

/// A mesh of random polygons with distinct positions of all sizes; with attributes every corner names those of its
/// position's number.
template <class T>
irg::mesh<T> random_mesh(random& r, int most_corners, attributes which) {
  irg::mesh<T> m;
  const std::int64_t vertices = r.integer(3, 40), faces = r.integer(1, 40);
  for (std::int64_t v = 0; v < vertices; ++v) {
    const T x = any_finite<T>(r), y = any_finite<T>(r), z = any_finite<T>(r);
    m.positions.push_back({x, y, z});
    if (which == attributes::none) continue;
    const T a = any_finite<T>(r), b = any_finite<T>(r), c = any_finite<T>(r);
    m.normals.push_back({a, b, c});
    m.texcoords.push_back({c, b});
  }
  for (std::int64_t f = 0; f < faces; ++f) {
    const std::int64_t corners = r.integer(3, most_corners);
    for (std::int64_t k = 0; k < corners; ++k) {
      const auto v = static_cast<std::uint32_t>(r.integer(0, vertices - 1));
      const std::uint32_t other = which == attributes::none ? irg::no_index : v;
      m.corners.push_back({v, other, other});
    }
    m.face_starts.push_back(static_cast<std::uint32_t>(m.corners.size()));
  }
  return m;
}

/// The mesh with its positions in the order in which corners name them first, and no others.
template <class T>
irg::mesh<T> in_order_of_use(const irg::mesh<T>& m) {
  irg::mesh<T> out = m;
  out.positions.clear();
  std::vector<std::uint32_t> to(m.positions.size(), 0xffffffffu);
  for (irg::mesh_corner& c : out.corners) {
    std::uint32_t& place = to[c.position];
    if (place == 0xffffffffu) {
      place = static_cast<std::uint32_t>(out.positions.size());
      out.positions.push_back(m.positions[c.position]);
    }
    c.position = place;
  }
  return out;
}

/// The positions and faces alone.
template <class T>
irg::mesh<T> without_attributes(irg::mesh<T> m) {
  m.normals.clear();
  m.texcoords.clear();
  m.parts.clear();
  for (irg::mesh_corner& c : m.corners) c = irg::mesh_corner{c.position};
  return m;
}

/// A file put together number by number, in the machine's own way of writing them turned round where asked.
struct byte_file {
  std::string bytes;
  bool reversed = false;

  template <class N>
  byte_file& put(N n) {
    char raw[sizeof n];
    std::memcpy(raw, &n, sizeof n);
    for (std::size_t i = 0; i < sizeof n; ++i) bytes.push_back(raw[reversed ? sizeof n - 1 - i : i]);
    return *this;
  }
};

}  // namespace test
