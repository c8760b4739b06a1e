// SPDX-License-Identifier: MIT
// libFuzzer target: any bytes give a sound mesh or an error with a place in the text.
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <string_view>

#include <irg/io/obj.hpp>
#include <irg/mesh/triangulate.hpp>
#include <irg/mesh/validate.hpp>

namespace {

void require(bool fact) {
  if (!fact) std::abort();
}

/// The place of an error is a byte of the text, or the end of it, and counted as a reader of the text would count it.
void check_place(std::string_view text, const irg::parse_error& error) {
  require(std::strlen(error.message) > 10);
  std::size_t line = 1, column = 1;
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  for (std::size_t i = 0;; ++i) {
    if (line == error.line && column == error.column) return;
    require(i < text.size());
    const bool ends_line = text[i] == '\n' || (text[i] == '\r' && (i + 1 == text.size() || text[i + 1] != '\n'));
    line += ends_line;
    column = ends_line ? 1 : column + 1;
  }
}

template <class T>
bool check(std::string_view text, irg::obj_options options) {
  const auto read = irg::read_obj<T>(text, options);
  if (!read) {
    check_place(text, read.error());
    return false;
  }
  require(irg::validate(*read).defect == irg::mesh_defect::none);
  const irg::mesh<T> triangles = irg::triangulate(*read);
  require(irg::validate(triangles).defect == irg::mesh_defect::none);
  require(triangles.face_count() == read->corners.size() - 2 * read->face_count());
  require(triangles.positions == read->positions);
  require(triangles.parts.size() == read->parts.size());
  return true;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const bool sound = check<double>(text, {});
  const bool sound_as_float = check<float>(text, {});
  require(sound || !sound_as_float);  // a float overflows earlier, and nothing else differs
  if (check<double>(text, {irg::obj_unused::refuse})) require(sound);
  return 0;
}
