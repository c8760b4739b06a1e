// SPDX-License-Identifier: MIT
#include <irg/scene/scene.hpp>

#include <concepts>
#include <type_traits>

#include "support/check_both.hpp"

namespace {

TEST_CASE("scene: types") {
  static_assert(std::equality_comparable<irg::scene<float>> && std::equality_comparable<irg::camera<double>>);
  static_assert(std::is_aggregate_v<irg::object<double>>);
  static_assert(std::is_aggregate_v<irg::scene<float>>);
  static_assert(std::is_same_v<decltype(irg::scene<double>::lights), std::vector<irg::light<double>>>);
}

TEST_CASE("scene: an object stands where it was modelled, white and without highlight, unless told otherwise") {
  CHECK_BOTH(irg::object<double>{}.placement == irg::identity_matrix<double, 4>());
  CHECK_BOTH(irg::object<double>{}.surface.diffuse == irg::rgb<double>{1, 1, 1});
  CHECK_BOTH(irg::object<double>{}.surface.ambient == irg::rgb<double>{1, 1, 1});
  CHECK_BOTH(irg::object<float>{}.surface.specular == irg::rgb<float>{0, 0, 0});
  CHECK_BOTH(irg::object<double>{}.surface.shininess == 1.0);  // in the reflection model's domain
}

TEST_CASE("scene: the empty scene has a camera in its domain and no light") {
  CHECK_BOTH(irg::scene<double>{}.objects.empty());
  CHECK_BOTH(irg::scene<double>{}.lights.empty());
  CHECK_BOTH(irg::scene<double>{}.ambient == irg::rgb<double>{0, 0, 0});
  CHECK_BOTH(irg::scene<double>{}.view.near_distance > 0);
}

TEST_CASE("scene: built in a constant expression") {
  constexpr auto objects = [] {
    irg::scene<double> s;
    s.objects.push_back({{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {}, {}, {{0}, {1}, {2}}, {0, 3}, {}}});
    s.lights.push_back({{0, 0, 1, 0}, {1, 1, 1}});
    return s.objects.size() * 10 + s.objects[0].shape.face_count();
  };
  CHECK_BOTH(objects() == 11);
}

}  // namespace
