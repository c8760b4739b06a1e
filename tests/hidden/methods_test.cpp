// SPDX-License-Identifier: MIT
// All hidden-surface methods on the same scenes, each pixel against the oracle. `IRG_FIRST_SCENE` and `IRG_SCENES` run a
// part of the release tier's scenes.
#include <irg/hidden/bsp_faces.hpp>
#include <irg/hidden/painter_newell.hpp>
#include <irg/hidden/painter_once.hpp>
#include <irg/hidden/ray_casting.hpp>
#include <irg/hidden/textbook/zbuffer.hpp>
#include <irg/hidden/warnock.hpp>

#include <cstdlib>
#include <cstring>

#include "method_scenes.hpp"
#include "support/check_both.hpp"

namespace {

int number_from(const char* variable, int otherwise) {
  const char* text = std::getenv(variable);
  return text == nullptr ? otherwise : std::atoi(text);
}

// The textbook's z-buffer with the depths of shade_triangle, which are compared as they are.
test::id_image zbuffer_ids(const test::face_list& faces, int size) {
  test::id_image ids(size, size, irg::no_index);
  irg::image<float> depth(size, size);
  const irg::textbook::zbuffer buffers{irg::nearer_is_greater{}, ids, depth};
  buffers.clear(irg::no_index, 0.0f);
  std::vector<const irg::screen_face*> in_order(faces.size());
  for (const auto& f : faces) in_order[f.number] = &f;
  for (const auto* f : in_order) irg::textbook::zbuffer_face(buffers, *f, f->number);
  return ids;
}

}  // namespace

TEST_CASE("hidden-surface methods: the same picture, the exact one, on scenes of every kind") {
  const bool release = std::getenv("IRG_RELEASE_TIER") != nullptr;
  const int first = number_from("IRG_FIRST_SCENE", 0), scenes = number_from("IRG_SCENES", release ? 10000 : 500);
  std::int64_t pixels = 0, close = 0;
  for (int s = first; s < first + scenes; ++s) {
    test::random r(static_cast<std::uint64_t>(s) + 16000);
    const int size = release || s % 50 == 0 ? 128 : 24;
    test::face_scene_maker make(r.next(), size);
    const auto kind = static_cast<test::face_scene>(s % test::face_scenes);
    const test::face_list faces = make(kind, static_cast<int>(r.integer(64, release ? 512 : 96)));
    const test::face_oracle oracle = test::oracle_of(faces, size, size);
    const test::id_image exact = test::ids_of(oracle, size, size);
    CAPTURE(s);
    CHECK(test::differing(test::ids_of(irg::warnock<>{}, faces, size, size), exact) == 0);
    CHECK(test::differing(test::ids_of(irg::painter_newell<>{}, faces, size, size), exact) == 0);
    CHECK(test::differing(test::ids_of(irg::bsp_painter<>{}, faces, size, size), exact) == 0);
    CHECK(test::differing(test::ids_of(irg::painter_once<>{}, faces, size, size), exact) == 0);
    if (s % 4 == 0) CHECK(test::differing(test::ids_of(irg::ray_casting<>{}, faces, size, size), exact) == 0);
    const test::id_image buffered = zbuffer_ids(faces, size);
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x, ++pixels)
        if (buffered(x, y) != exact(x, y)) {
          ++close;
          CHECK(oracle.ulps_behind(buffered(x, y) + 1, x, y) <= 8);
        }
  }
  MESSAGE(scenes, " scenes, ", pixels, " pixels; of the textbook's z-buffer ", close,
          " differ, by at most 8 ulp in depth");
}
