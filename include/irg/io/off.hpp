// SPDX-License-Identifier: MIT
// OFF, Geomview's object file format: text or binary bytes to mesh<T>, and back. Works on memory only. Normals and
// texture coordinates of vertices are read (NOFF, STOFF), colours are read past (COFF, or unannounced). docs/io/off.md
// lists the rest.
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string_view>
#include <utility>
#include <vector>

#include <irg/core/result.hpp>
#include <irg/io/mesh_options.hpp>
#include <irg/mesh/mesh.hpp>
#if IRG_BODIES
#include <irg/core/conversion.hpp>
#include <irg/core/is_finite.hpp>
#include <irg/io/detail/byte_cursor.hpp>
#include <irg/io/detail/text_cursor.hpp>
#include <irg/io/detail/text_writer.hpp>
#include <irg/io/detail/vertex_layout.hpp>
#include <irg/math/decimal_digit.hpp>
#endif

namespace irg::inline IRG_COMPILED_ABI {

/// The mesh that an OFF file describes.
/// shape   its vertices' positions in order, with their normals and texture coordinates where the first word promises
///         them, and its polygons; corners name the normal and the texture coordinate of their own vertex
/// needs   the bytes in memory; they are not kept
/// gives   the first error with line and column, in a binary body line 0 and the byte, in place of a half-read mesh.
///         The mesh passes validate()
/// exact   decimal numbers are correctly rounded to T, binary ones kept
/// cost    linear; memory at most 64 times the file and 1 MiB, whatever its counts claim
/// source  Geomview
template <Floating T = double>
[[nodiscard]] IRG_API result<mesh<T>> read_off(std::string_view bytes);

/// The bytes of an OFF file that describes the mesh, as text: OFF, NOFF, STOFF or STNOFF.
/// shape   a vertex for each position, more where its corners differ in normal or texture coordinate; an attribute that
///         some corner lacks is left out, and so are the names of parts, for which OFF has no place. Without faces,
///         normals are those of the positions if they are as many, and so are texture coordinates
/// gives   an error when the mesh does not pass validate()
/// exact   read_off<T> of the bytes gives the same mesh again, if there are no parts, and as many normals as positions,
///         each corner naming that of its position's number, or none, and so texture coordinates
/// cost    linear; O(n log n) where there are normals or texture coordinates
/// source  Geomview
template <Floating T>
[[nodiscard]] IRG_API result<std::vector<std::uint8_t>, encode_error> encode_off(const mesh<T>& m);

}  // namespace irg::inline IRG_COMPILED_ABI

#if IRG_BODIES
namespace irg::detail {

// OFF's header, and its two forms: words, and big-endian numbers.

/// What an OFF file's first word says: which numbers a vertex has.
struct off_header {
  bool texcoords = false, colours = false, normals = false;
  bool normals_first = false;  // N stands before C, which is not the format's order
  bool four = false, any_dimension = false;  // coordinates that irg does not read
  bool binary = false;
  std::size_t length = 0;  // of the first word; 0: the file is no OFF
};

inline namespace IRG_ABI {

/// The header at the head of a text: [ST][C][N][4][n]OFF, and the same in any other order.
constexpr off_header off_header_of(std::string_view text) noexcept {
  off_header h;
  std::size_t at = 0;
  const auto take = [&](bool& has, std::string_view word) {
    if (has || !text.substr(at).starts_with(word)) return false;
    at += word.size();
    return has = true;
  };
  while (take(h.texcoords, "ST") || take(h.colours, "C") || take(h.normals, "N") || take(h.four, "4") ||
         take(h.any_dimension, "n"))
    h.normals_first = h.normals_first || (h.normals && !h.colours);
  h.length = text.substr(at).starts_with("OFF") ? at + 3 : 0;
  return h;
}

/// Reads OFF, or stops at the cursor's place with its message.
template <Floating T>
struct off_reader {
  text_cursor cursor;
  off_header header{};
  mesh<T> read{};
  std::int64_t vertex_count = 0, face_count = 0;
  int line_numbers = 0;  // of each vertex behind position and normal, where a colour stands there unannounced; else 0
  bool in_text = true;  // where the last error stands

  constexpr explicit off_reader(std::string_view bytes) noexcept : cursor(bytes, '#') {}

  constexpr bool file() {
    const char* const start = cursor.skip_space() ? cursor.at : cursor.last;
    header = off_header_of({start, static_cast<std::size_t>(cursor.last - start)});
    if (header.length == 0) return cursor.fail(start, "file does not begin with the word OFF");
    if (header.four || header.any_dimension) return cursor.fail(start, "points are not of three dimensions");
    cursor.at += header.length;
    // Some writers leave out the white space between OFF and the first count.
    if (!cursor.at_word_end() && !is_decimal_digit(*cursor.at))
      return cursor.fail(start, "file does not begin with the word OFF");
    const char* const behind = cursor.at;
    if (cursor.word_in_line() == "BINARY") {
      cursor.skip_line();
      in_text = false;
      return binary();
    }
    cursor.at = behind;
    return text();
  }

  constexpr bool count(std::int64_t& into) noexcept {
    if (!cursor.skip_space()) return cursor.fail(cursor.at, "text ends where a count is expected");
    const char* const start = cursor.at;
    if (!cursor.integer(into)) return false;
    return into >= 0 || cursor.fail(start, "count is negative");
  }

  constexpr bool text() {
    if (!count(vertex_count) || !count(face_count)) return false;
    // The number of edges, which nobody counts, is not always there.
    std::int64_t edges = 0;
    if (cursor.skip_blanks() && !cursor.integer(edges)) return false;
    const text_cursor behind_counts = cursor;
    line_numbers = header.colours || cursor.skip_blanks() ? 0 : numbers_of_a_colour();
    if (line_numbers == 0) return vertices_and_faces();
    // The first line may have a vertex and its colour, or two vertices: what can be read is meant. Where neither can,
    // it is colours if there are lines enough for them, or if they lead farther.
    header.colours = true;
    if (vertices_and_faces()) return true;
    const text_cursor with_colours = cursor;
    cursor = behind_counts;
    header.colours = false;
    read = {};
    if (vertices_and_faces()) return true;
    if (cursor.place <= with_colours.place || has_line_for_each(behind_counts))
      cursor.fail(with_colours.place, with_colours.message);
    return false;
  }

  /// Whether as many lines follow as there are vertices and faces.
  constexpr bool has_line_for_each(text_cursor from) const noexcept {
    std::uint64_t lines = 0;
    for (; from.skip_space(); from.skip_to_line_end()) ++lines;
    return lines >= static_cast<std::uint64_t>(vertex_count) + static_cast<std::uint64_t>(face_count);
  }

  constexpr bool vertices_and_faces() {
    for (std::int64_t v = 0; v < vertex_count; ++v)
      if (!text_vertex()) return false;
    for (std::int64_t f = 0; f < face_count; ++f)
      if (!text_face()) return false;
    return !cursor.skip_space() || cursor.fail(cursor.at, "text goes on after the last face");
  }

  /// How many numbers the first vertex's line has behind position and normal, if that makes a colour (and a texture
  /// coordinate); else 0.
  constexpr int numbers_of_a_colour() const noexcept {
    text_cursor line = cursor;
    int count = header.normals ? -6 : -3;
    if (vertex_count == 0 || !line.skip_space()) return 0;
    while (count < 7 && !line.word_in_line().empty()) ++count;
    const int of_colour = header.texcoords ? count - 2 : count;
    return of_colour == 3 || of_colour == 4 ? count : 0;
  }

  template <class Vector>
  constexpr bool numbers(Vector& into, int count_of_them) noexcept {
    for (int i = 0; i < count_of_them; ++i)
      if (!cursor.number(into[i])) return false;
    return true;
  }

  constexpr bool text_vertex() {
    point<T, 3> p;
    vec<T, 3> n;
    vec<T, 2> t;
    const char* const start = cursor.skip_space() ? cursor.at : cursor.last;
    if (!numbers(p, 3) || (header.normals && !numbers(n, 3))) return false;
    if (header.colours && !text_colour(start, n, t)) return false;
    if (header.texcoords && !header.colours && !numbers(t, 2)) return false;
    add_vertex(p, n, t);
    return true;
  }

  /// A colour has as many numbers as its writer liked: it goes on to the end of the line, but for the two last numbers
  /// where those are a texture coordinate. Where N stands before C, some write the colour before the normal, in four
  /// numbers up to 255: then the fourth behind the position is more than 1, and the last is not, which ends a normal.
  constexpr bool text_colour(const char* start, vec<T, 3>& n, vec<T, 2>& t) noexcept {
    constexpr int most = 6;
    T rest[most] = {};
    int found = 0;
    for (; found < most && cursor.skip_blanks(); ++found)
      if (!cursor.number_here(rest[found])) return false;
    if (line_numbers != 0 && (found != line_numbers || cursor.skip_blanks()))
      return cursor.fail(start, "vertex has more or fewer numbers than the first one");
    if (cursor.skip_blanks())
      return cursor.fail(cursor.at, "vertex has more numbers than a colour and a texture coordinate");
    if (header.texcoords && found < 2) return cursor.fail(cursor.at, "vertex has no texture coordinate");
    const int of_colour = header.texcoords ? found - 2 : found;
    if (header.texcoords) t = {rest[of_colour], rest[of_colour + 1]};
    if (header.normals_first && of_colour == 4 && rest[0] > 1 && rest[3] <= 1) n = {rest[1], rest[2], rest[3]};
    return true;
  }

  constexpr void add_vertex(const point<T, 3>& p, const vec<T, 3>& n, const vec<T, 2>& t) {
    read.positions.push_back(p);
    if (header.normals) read.normals.push_back(n);
    if (header.texcoords) read.texcoords.push_back(t);
  }

  constexpr bool add_corner(std::int64_t index, const char* place) {
    if (index < 0) return cursor.fail(place, "index of a vertex is negative");
    if (index >= vertex_count) return cursor.fail(place, "face index is not smaller than the number of vertices");
    const auto v = static_cast<std::uint32_t>(index);
    read.corners.push_back({v, header.normals ? v : no_index, header.texcoords ? v : no_index});
    return true;
  }
  constexpr void end_face() { read.face_starts.push_back(static_cast<std::uint32_t>(read.corners.size())); }

  constexpr bool text_face() {
    if (!cursor.skip_space()) return cursor.fail(cursor.at, "text ends where a face is expected");
    const char* const start = cursor.at;
    std::int64_t corners = 0;
    if (!cursor.integer(corners)) return false;
    if (corners < 3) return cursor.fail(start, "face has fewer than three corners");
    for (std::int64_t k = 0; k < corners; ++k) {
      if (!cursor.skip_space()) return cursor.fail(cursor.at, "text ends where a whole number is expected");
      const char* const place = cursor.at;
      std::int64_t index = 0;
      if (!cursor.integer(index) || !add_corner(index, place)) return false;
    }
    T unread{};
    while (cursor.skip_blanks())  // a colour
      if (!cursor.number_here(unread)) return false;
    end_face();
    return true;
  }

  constexpr bool whole(std::int64_t& into) noexcept {
    if (cursor.last - cursor.at < 4) return cursor.fail(cursor.last, "file ends where a number is expected");
    into = static_cast<std::int32_t>(ordered_bits<4>(cursor.at, byte_order::big));
    cursor.at += 4;
    return true;
  }
  template <class Vector>
  constexpr bool floats(Vector& into, int count_of_them) noexcept {
    for (int i = 0; i < count_of_them; ++i, cursor.at += 4) {
      if (cursor.last - cursor.at < 4) return cursor.fail(cursor.last, "file ends where a number is expected");
      const float x = load_float(cursor.at, byte_order::big);
      if (!is_finite(x)) return cursor.fail(cursor.at, "number is not finite");
      into[i] = converted<T>(x);
    }
    return true;
  }

  constexpr bool binary() {
    const char* const start = cursor.at;
    std::int64_t edges = 0;
    if (!whole(vertex_count) || !whole(face_count) || !whole(edges)) return false;
    if (vertex_count < 0 || face_count < 0) return cursor.fail(start, "count is negative");
    for (std::int64_t v = 0; v < vertex_count; ++v) {
      point<T, 3> p;
      vec<T, 3> n;
      vec<T, 2> t;
      vec<T, 4> colour;
      if (!floats(p, 3) || (header.normals && !floats(n, 3)) || (header.colours && !floats(colour, 4)) ||
          (header.texcoords && !floats(t, 2)))
        return false;
      add_vertex(p, n, t);
    }
    for (std::int64_t f = 0; f < face_count; ++f)
      if (!binary_face()) return false;
    return cursor.at_end() || cursor.fail(cursor.at, "file goes on after the last face");
  }

  constexpr bool binary_face() {
    const char* const start = cursor.at;
    std::int64_t corners = 0, colours = 0, index = 0;
    if (!whole(corners)) return false;
    if (corners < 3) return cursor.fail(start, "face has fewer than three corners");
    for (std::int64_t k = 0; k < corners; ++k) {
      const char* const place = cursor.at;
      if (!whole(index) || !add_corner(index, place)) return false;
    }
    const char* const place = cursor.at;
    if (!whole(colours)) return false;
    if (colours < 0 || colours > 4) return cursor.fail(place, "colour has fewer than no or more than four numbers");
    if (cursor.last - cursor.at < 4 * colours) return cursor.fail(cursor.last, "file ends within a colour");
    cursor.at += 4 * colours;
    end_face();
    return true;
  }
};

}  // namespace IRG_ABI
}  // namespace irg::detail

namespace irg::inline IRG_COMPILED_ABI {

template <Floating T>
[[nodiscard]] IRG_API result<mesh<T>> read_off(std::string_view bytes) {
  if (const auto too_long = detail::refuse_long_file(bytes)) return *too_long;
  const std::string_view text = detail::without_byte_order_mark(bytes);
  detail::off_reader<T> reader(text);
  if (reader.file()) return std::move(reader.read);
  if (!reader.in_text) return detail::error_at_byte(bytes, reader.cursor.place, reader.cursor.message);
  return detail::error_at(text, reader.cursor.place, reader.cursor.message);
}

template <Floating T>
[[nodiscard]] IRG_API result<std::vector<std::uint8_t>, encode_error> encode_off(const mesh<T>& m) {
  if (const auto refused = detail::refuse_mesh(m)) return *refused;
  const auto v = detail::vertices_to_write(m);
  std::vector<std::uint8_t> out;
  if (v.texcoords) detail::append_text(out, "ST");
  detail::append_all(out, v.normals ? "NOFF\n" : "OFF\n", v.vertices.size(), " ", m.face_count(), " 0\n");
  for (const mesh_corner& c : v.vertices) {
    detail::append_numbers(out, m.positions[c.position], 3);
    if (v.normals) detail::append_numbers(out, detail::normal_to_write(m, c), 3);
    if (v.texcoords) detail::append_numbers(out, detail::texcoord_to_write(m, c), 2);
    detail::append_text(out, "\n");
  }
  for (std::size_t f = 0; f < m.face_count(); ++f) {
    detail::append_number(out, m.face_size(f));
    detail::append_numbers(out, v.of_corner.data() + m.face_starts[f], static_cast<int>(m.face_size(f)));
    detail::append_text(out, "\n");
  }
  return out;
}

}  // namespace irg::inline IRG_COMPILED_ABI
#endif
