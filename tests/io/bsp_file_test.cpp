// SPDX-License-Identifier: MIT
#include <irg/io/bsp_file.hpp>

#include <string>
#include <string_view>
#include <vector>

#include <irg/spatial/bsp_tree_3d.hpp>

#include "support/check_both.hpp"
#include "support/random.hpp"

namespace {

template <class T>
constexpr irg::bsp_tree_3d<T> floor_and_wall() {
  const irg::point<T, 3> v[] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {T(0.25), T(0.25), -1}, {T(0.25), T(0.25), 1},
                                {5, 5, 0}};
  const irg::triangle_indices t[] = {{{0, 1, 2}}, {{3, 4, 5}}};
  return irg::bsp_tree_3d<T>(v, t, {.candidates = 1});
}
template <class T>
std::string bytes_of(const irg::bsp_data_3d<T>& d) {
  std::string s;
  for (const std::uint8_t b : irg::encode_bsp(d)) s.push_back(static_cast<char>(b));
  return s;
}
template <class T>
constexpr bool comes_back() {
  const auto d = floor_and_wall<T>().data();
  std::vector<char> bytes;
  for (const std::uint8_t b : irg::encode_bsp(d)) bytes.push_back(static_cast<char>(b));
  const auto again = irg::read_bsp<T>({bytes.data(), bytes.size()});
  return again && *again == d;
}
std::string error_of(std::string_view bytes) {
  const auto read = irg::read_bsp<double>(bytes);
  if (read) return "";
  CHECK(read.error().line == 0);
  return std::to_string(read.error().column) + " " + read.error().message;
}
std::string with(std::string bytes, std::size_t at, char byte) {
  bytes[at] = byte;
  return bytes;
}

TEST_CASE("bsp_file: what is written comes back") {
  CHECK_BOTH(comes_back<double>());
  CHECK_BOTH(comes_back<float>());
  const auto nothing = irg::read_bsp<double>(bytes_of(irg::bsp_data_3d<double>{}));
  CHECK((nothing && nothing->nodes.empty()));
}

TEST_CASE("bsp_file: errors name the byte") {
  const std::string bytes = bytes_of(floor_and_wall<double>().data());
  REQUIRE(error_of(bytes) == "");
  CHECK(error_of("") == "1 this is no BSP tree");
  CHECK(error_of(bytes.substr(0, 20)) == "21 the bytes end within the lengths");
  CHECK(error_of(with(bytes, 7, 4)) == "8 coordinates of another size");
  CHECK(error_of(with(bytes, 11, 1)) == "9 more than the bytes hold");
  CHECK(error_of(bytes + "x") == std::to_string(bytes.size() + 1) + " bytes are left over");
  CHECK(error_of(bytes.substr(0, bytes.size() - 1)) == "25 more than the bytes hold");
  const std::size_t triangles = 28 + 6 * 24, nodes = triangles + 2 * 12;
  CHECK(error_of(with(bytes, triangles + 13, 1)) == std::to_string(triangles + 13) + " number beyond what it counts");
  CHECK(error_of(with(bytes, nodes + 16, 0)) == std::to_string(nodes + 1) + " these numbers are no tree");
  CHECK(error_of(with(bytes, triangles, 1)) ==
        std::to_string(nodes + 1) + " triangle without area, or a coordinate that is not finite");
}

TEST_CASE("bsp_file: no damage leads astray: what is read can be visited") {
  const std::string bytes = bytes_of(floor_and_wall<double>().data());
  test::random r(2);
  int read = 0;
  for (int i = 0; i < 4000; ++i) {
    std::string damaged = bytes;
    for (std::int64_t n = r.integer(1, 3); n > 0; --n)
      damaged[static_cast<std::size_t>(r.integer(0, static_cast<std::int64_t>(bytes.size()) - 1))] =
          static_cast<char>(r.integer(0, 5));
    auto d = irg::read_bsp<double>(damaged);
    if (!d) continue;
    ++read;
    const irg::bsp_tree_3d<double> tree(*std::move(d));
    std::size_t visited = 0;
    tree.visit(irg::point<double, 3>{1, 2, 3}, irg::bsp_order::back_to_front,
               [&](const irg::bsp_piece_3d&) { ++visited; });
    CHECK(visited == tree.data().pieces.size());
  }
  CHECK(read > 100);
}

}  // namespace
