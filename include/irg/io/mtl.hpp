// SPDX-License-Identifier: MIT
// MTL, the materials of Wavefront OBJ: text to a list of them, and the libraries that an OBJ text names, opened by the
// caller alone. Works on memory only.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <irg/core/result.hpp>
#include <irg/io/mesh_options.hpp>
#include <irg/shade/material.hpp>
#if IRG_BODIES
#include <irg/io/detail/text_cursor.hpp>
#endif

namespace irg {

/// A material as OBJ names it.
/// shape   opacity from 0 (clear) to 1; texture is the file that map_Kd names, with its options, as it stands there
template <Floating T>
struct mtl_material {
  part_name name;
  material<T> reflection{{T(1), T(1), T(1)}, {T(1), T(1), T(1)}, {}, T(1)};
  T opacity = T(1);
  part_name texture;
  bool operator==(const mtl_material&) const = default;
};

inline namespace IRG_COMPILED_ABI {

/// The materials that an MTL text describes, in its order.
/// gives   the first error with line and column. Ka, Kd, Ks, Ns, d, Tr, map_Kd and newmtl are read, all else is passed
///         over; a shininess of 0, which many writers put where there is no highlight, becomes 1
/// exact   numbers are correctly rounded to T
/// cost    linear; memory at most 64 times the text and 1 MiB
/// source  Wavefront
template <Floating T = double>
[[nodiscard]] IRG_API result<std::vector<mtl_material<T>>> read_mtl(std::string_view text);

/// What the mtllib statements of an OBJ text name, each the rest of its line; nothing is opened.
/// shape   in the order of the text, which the names are parts of
/// cost    one pass over the text
template <class Text = std::string_view>
[[nodiscard]] IRG_API std::vector<Text> material_libraries(std::type_identity_t<Text> obj);

}  // namespace IRG_COMPILED_ABI

inline namespace IRG_ABI {

/// Whether a name can only be a file in the folder of the file that names it: no slash, no backslash, no colon, no dots
/// that lead upwards, no byte 0.
[[nodiscard]] constexpr bool is_plain_file_name(std::string_view name) noexcept {
  return !name.empty() && name != "." && name != ".." &&
         name.find_first_of(std::string_view("/\\:\0", 4)) == std::string_view::npos;
}

}  // namespace IRG_ABI

namespace detail::inline IRG_ABI {

/// The name without the folder's own name before it, as many writers put it there.
template <class Text>
constexpr Text without_own_folder(Text name) noexcept {
  while (name.starts_with("./") || name.starts_with(".\\")) name.remove_prefix(2);
  return name;
}

}  // namespace detail::inline IRG_ABI

inline namespace IRG_ABI {

/// The materials of all libraries that an OBJ text names, one behind the other, each where it is named first.
/// needs   open(name): a result whose value is the library's text, as load_file gives it; the name is without the ./ or
///         .\ that may stand before it
/// gives   the first error of open or read_mtl; an error, and no call of open, for a name that is then not
///         is_plain_file_name
/// cost    that of open and read_mtl, once for each library, however often the text names it
template <Floating T = double, class Open>
[[nodiscard]] constexpr result<std::vector<mtl_material<T>>> read_materials(std::string_view obj, const Open& open) {
  std::vector<mtl_material<T>> all;
  using name_text = std::conditional_t<Floating<T>, std::string_view, void>;  // depends on T: sorted where it is needed
  std::vector<name_text> names = material_libraries(obj);
  for (name_text& name : names) name = detail::without_own_folder(name);
  auto different = names;
  std::sort(different.begin(), different.end());
  different.erase(std::unique(different.begin(), different.end()), different.end());
  std::vector<unsigned char> is_read(different.size(), 0);
  for (const name_text name : names) {
    const auto place = std::lower_bound(different.begin(), different.end(), name) - different.begin();
    if (std::exchange(is_read[static_cast<std::size_t>(place)], 1) != 0) continue;
    if (!is_plain_file_name(name)) return parse_error{0, 0, "library of materials is not beside the model"};
    const auto text = open(name);
    if (!text) return text.error();
    auto materials = read_mtl<T>(std::string_view(*text));
    if (!materials) return materials.error();
    for (mtl_material<T>& m : *materials) all.push_back(std::move(m));
  }
  return all;
}

}  // namespace IRG_ABI

#if IRG_BODIES
namespace detail::inline IRG_ABI {

template <Floating T>
struct mtl_reader {
  text_cursor cursor;
  std::vector<mtl_material<T>> read{};

  constexpr explicit mtl_reader(std::string_view text) noexcept : cursor(text, '#') {}

  constexpr bool text() {
    for (; cursor.skip_space(); cursor.skip_to_line_end()) {
      const char* const start = cursor.at;
      const std::string_view word = cursor.word();
      if (word == "newmtl") {
        read.emplace_back();
        read.back().name = cursor.rest_of_line();
        if (read.back().name.empty()) return cursor.fail(cursor.at, "material has no name");
      } else if (!statement(word, start)) {
        return false;
      }
    }
    return true;
  }

  constexpr bool statement(std::string_view word, const char* start) {
    const bool known =
        word == "Ka" || word == "Kd" || word == "Ks" || word == "Ns" || word == "d" || word == "Tr" || word == "map_Kd";
    if (!known) return true;
    if (read.empty()) return cursor.fail(start, "statement stands before the first material");
    mtl_material<T>& m = read.back();
    if (word == "Ka") return colour(m.reflection.ambient);
    if (word == "Kd") return colour(m.reflection.diffuse);
    if (word == "Ks") return colour(m.reflection.specular);
    if (word == "map_Kd") return m.texture = cursor.rest_of_line(), true;
    T n{};
    cursor.skip_blanks();
    const char* place = cursor.at;
    if (word == "d" && cursor.word() != "-halo") cursor.at = place;
    if (!cursor.skip_blanks()) return cursor.fail(cursor.at, "statement has no number");
    place = cursor.at;
    if (!cursor.number_here(n)) return false;
    if (n < 0) return cursor.fail(place, "number is negative");
    if (word == "Ns") {
      m.reflection.shininess = n > 0 ? n : T(1);
      return true;
    }
    if (n > 1) return cursor.fail(place, "opacity is more than 1");
    m.opacity = word == "d" ? n : 1 - n;
    return true;
  }

  /// Three shares, or one for all; spectral curves and other systems of colour leave what is there.
  constexpr bool colour(rgb<T>& into) {
    T n[3] = {};
    int count = 0;
    for (; count < 3 && cursor.skip_blanks(); ++count) {
      const char* const place = cursor.at;
      if (count == 0 && (cursor.word() == "spectral" || is_xyz(place))) return true;
      cursor.at = place;
      if (!cursor.number_here(n[count])) return false;
      if (n[count] < 0) return cursor.fail(place, "number is negative");
    }
    if (count == 0 || count == 2) return cursor.fail(cursor.at, "colour has neither one number nor three");
    into = count == 1 ? rgb<T>{n[0], n[0], n[0]} : rgb<T>{n[0], n[1], n[2]};
    return true;
  }
  constexpr bool is_xyz(const char* place) const noexcept {
    return std::string_view(place, static_cast<std::size_t>(cursor.at - place)) == "xyz";
  }
};

}  // namespace detail::inline IRG_ABI

inline namespace IRG_COMPILED_ABI {

template <Floating T>
[[nodiscard]] IRG_API result<std::vector<mtl_material<T>>> read_mtl(std::string_view text) {
  if (const auto too_long = detail::refuse_long_file(text)) return *too_long;
  text = detail::without_byte_order_mark(text);
  detail::mtl_reader<T> reader(text);
  if (!reader.text()) return detail::error_at(text, reader.cursor.place, reader.cursor.message);
  return std::move(reader.read);
}

template <class Text>
[[nodiscard]] IRG_API std::vector<Text> material_libraries(std::type_identity_t<Text> obj) {
  std::vector<Text> names;
  detail::text_cursor text(detail::without_byte_order_mark(obj), '#');
  for (; text.skip_space(); text.skip_to_line_end())
    if (text.word() == "mtllib")
      if (const Text name = text.rest_of_line(); !name.empty()) names.push_back(name);
  return names;
}

}  // namespace IRG_COMPILED_ABI
#endif

}  // namespace irg
