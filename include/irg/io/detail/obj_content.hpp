// SPDX-License-Identifier: MIT
// What the statements of an OBJ text have given so far, and lines as nearly all are, read in one go.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include <irg/io/detail/text_place.hpp>
#include <irg/math/decimal.hpp>
#include <irg/mesh/mesh.hpp>

namespace irg::detail {
inline namespace IRG_ABI {

// A line of an OBJ text taken apart at a go: where its digits end is found for all bytes together, so that no number
// waits for the end of the one before it.

/// The words of one line: numbers with one blank or more between them.
struct obj_line {
  static constexpr int window = 64;  // longer lines are read with care
  static constexpr std::ptrdiff_t readable = window + 16;  // so many bytes from its beginning on

  const char* text;
  std::uint64_t others;  // where no digits stand, from `at` on, one bit a byte
  int at;                // how much has been read

  /// needs   `readable` bytes
  IRG_INLINE constexpr explicit obj_line(const char* line) noexcept : text(line), others(~digit_bits(line)), at(0) {}

  /// Moves over a byte that is no digit.
  IRG_INLINE constexpr void pass() noexcept {
    ++at;
    others &= others - 1;
  }
  IRG_INLINE constexpr void skip_blanks() noexcept {
    while (text[at] == ' ' && at < window) pass();  // more of them are read with care
  }
  IRG_INLINE constexpr bool at_word_end() const noexcept { return text[at] == ' ' || is_line_break(text[at]); }

  /// Moves over digits; says how many, a negative number or too many for one where the window ends.
  IRG_INLINE constexpr int digits() noexcept {
    const int end = std::countr_zero(others), count = end - at;
    at = end;
    return count;
  }

  /// The line's end, of which CR LF is one, or null when something else stands here.
  IRG_INLINE constexpr const char* end() const noexcept {
    const char* const p = text + at;
    return *p == '\n' ? p + 1 : *p != '\r' ? nullptr : p[1] == '\n' ? p + 2 : p + 1;
  }

  template <Floating T>
  IRG_INLINE constexpr bool number(T& into) noexcept {
    const bool negative = text[at] == '-';
    others &= negative ? others - 1 : ~std::uint64_t{0};
    at += negative ? 1 : 0;
    const char* const first = text + at;
    const int whole = digits();
    if (static_cast<unsigned>(whole) > 8) return false;
    std::uint64_t mantissa = value_of_digits(first, whole);
    int fraction = 0;
    if (text[at] == '.') {
      pass();
      const char* const rest = text + at;
      fraction = digits();
      if (static_cast<unsigned>(fraction) > 16) return false;
      const int first_digits = fraction < 8 ? fraction : 8;
      mantissa = value_of_digits(rest, first_digits, mantissa);
      if (fraction > 8) mantissa = value_of_digits(rest + 8, fraction - 8, mantissa);
    }
    if (static_cast<unsigned>(whole + fraction - 1) > 18 || !at_word_end()) return false;
    const T magnitude = decimal_fraction<T>(mantissa, fraction);
    into = negative ? -magnitude : magnitude;
    return true;
  }

  /// An index from 1 on, less 1; `most` is the largest so far.
  IRG_INLINE constexpr bool index(std::uint32_t& into, std::uint32_t& most) noexcept {
    const char* const first = text + at;
    const int count = digits();
    if (static_cast<unsigned>(count - 1) > 7) return false;
    const auto n = static_cast<std::uint32_t>(value_of_digits(first, count));
    into = n - 1;
    most = most < n ? n : most;
    return n != 0;
  }
};

}  // namespace IRG_ABI

/// How many of each kind of vertex data there are; until the end of the text is reached, as many as indices can name.
struct IRG_APART obj_counts {
  std::size_t positions = no_index, texcoords = no_index, normals = no_index;
  bool operator==(const obj_counts&) const = default;

  constexpr bool reach(const obj_counts& o) const noexcept {
    return positions >= o.positions && texcoords >= o.texcoords && normals >= o.normals;
  }
  constexpr void add(const obj_counts& o) noexcept {
    positions += o.positions;
    texcoords += o.texcoords;
    normals += o.normals;
  }
  constexpr void raise_to(const obj_counts& o) noexcept {
    positions = positions < o.positions ? o.positions : positions;
    texcoords = texcoords < o.texcoords ? o.texcoords : texcoords;
    normals = normals < o.normals ? o.normals : normals;
  }
};

/// What some lines of a text give.
struct obj_samples {
  std::size_t bytes = 0, positions = 0, normals = 0, texcoords = 0, faces = 0, corners = 0;
};

inline namespace IRG_ABI {

/// The lines at many places of a long text; nothing of a short one.
constexpr obj_samples samples_of_obj(std::string_view text) noexcept {
  constexpr std::size_t samples = 64, sample_bytes = 512;
  obj_samples seen;
  if (text.size() < 4 * samples * sample_bytes) return seen;
  seen.bytes = samples * sample_bytes;
  for (std::size_t s = 0; s < samples; ++s) {
    const std::size_t first = text.size() / samples * s;
    for (std::size_t i = first + 1; i < first + sample_bytes; ++i) {
      if (text[i - 1] != '\n') continue;
      if (text[i] == 'v') ++(text[i + 1] == 'n' ? seen.normals : text[i + 1] == 't' ? seen.texcoords : seen.positions);
      if (text[i] != 'f') continue;
      std::size_t blanks = 0;
      for (std::size_t k = i; k < i + 40 && text[k] != '\n'; ++k) blanks += text[k] == ' ' ? 1u : 0u;
      ++seen.faces;
      seen.corners += blanks > 3 ? 4u : 3u;
    }
  }
  return seen;
}

/// What is about to be appended to a vector: asking one for every item would take as long as reading it.
template <class V>
struct obj_gathered {
  static constexpr std::size_t room = 64;
  V items[room]{};
  std::size_t count = 0;

  constexpr V& next(std::vector<V>& all) {
    if (count == room) flush(all);
    return items[count++];
  }
  constexpr void flush(std::vector<V>& all) {
    all.insert(all.end(), items, items + count);
    count = 0;
  }
};

/// A mesh that grows.
template <Floating T>
struct obj_content {
  mesh<T> made{};
  obj_counts filled{0, 0, 0};
  std::size_t corners = 0, faces = 0;
  obj_counts named{0, 0, 0};  // the largest index of each kind that a corner has, counted from 1
  obj_gathered<point<T, 3>> new_positions{};
  obj_gathered<vec<T, 3>> new_normals{};
  obj_gathered<vec<T, 2>> new_texcoords{};
  obj_gathered<mesh_corner> new_corners{};
  obj_gathered<std::uint32_t> new_starts{};

  constexpr void add_position(const T* n) {
    new_positions.next(made.positions) = {n[0], n[1], n[2]};
    ++filled.positions;
  }
  constexpr void add_normal(const T* n) {
    new_normals.next(made.normals) = {n[0], n[1], n[2]};
    ++filled.normals;
  }
  constexpr void add_texcoord(const T* n) {
    new_texcoords.next(made.texcoords) = {n[0], n[1]};
    ++filled.texcoords;
  }
  constexpr void add_corner(const mesh_corner& c) {
    new_corners.next(made.corners) = c;
    ++corners;
  }
  constexpr void end_face() {
    new_starts.next(made.face_starts) = static_cast<std::uint32_t>(corners);
    ++faces;
  }
  /// Puts what has been gathered into the mesh.
  constexpr void flush() {
    new_positions.flush(made.positions);
    new_normals.flush(made.normals);
    new_texcoords.flush(made.texcoords);
    new_corners.flush(made.corners);
    new_starts.flush(made.face_starts);
  }

  constexpr bool every_index_exists() const noexcept { return filled.reach(named); }

  /// Forgets what was read, not its memory.
  constexpr void clear() noexcept {
    filled = named = {0, 0, 0};
    corners = faces = 0;
    made.positions.clear();
    made.normals.clear();
    made.texcoords.clear();
    made.corners.clear();
    made.face_starts.resize(1, 0);
  }

  /// Asks for the memory that so many bytes of the text of which samples were taken will need: growing it bit by bit
  /// takes as long as reading. A wrong guess costs memory within the reader's bound, or time.
  constexpr void reserve(const obj_samples& seen, std::size_t bytes) {
    if (seen.bytes == 0) return;
    // A sixteenth more than was seen, so that an even text needs no second piece.
    const std::size_t scale = bytes / seen.bytes + bytes / (16 * seen.bytes) + 1;
    made.positions.reserve(seen.positions * scale);
    made.normals.reserve(seen.normals * scale);
    made.texcoords.reserve(seen.texcoords * scale);
    made.corners.reserve(seen.corners * scale);
    made.face_starts.reserve(seen.faces * scale + 1);
  }

  /// Reads a line as nearly all are, in one go: a vertex, a normal, a texture coordinate or a face, numbers without an
  /// exponent, indices from 1 on, blanks between them. Says whether it did; otherwise nothing has happened.
  /// needs   obj_line::readable bytes from `at` on
  constexpr bool plain_line(const char*& at) {
    if (*at == 'f' && at[1] == ' ') return plain_face(at);
    if (*at != 'v') return false;
    T n[3]{};
    if (at[1] == ' ') return plain_numbers<3>(at, 1, n) && (add_position(n), true);
    if (at[2] != ' ') return false;
    if (at[1] == 'n') return plain_numbers<3>(at, 2, n) && (add_normal(n), true);
    return at[1] == 't' && plain_numbers<2>(at, 2, n) && (add_texcoord(n), true);
  }

  template <int Count>
  IRG_INLINE static constexpr bool plain_numbers(const char*& at, int letters, T* into) noexcept {
    obj_line line(at);
    for (int i = 0; i < letters; ++i) line.pass();
    for (int i = 0; i < Count; ++i) {
      line.skip_blanks();
      if (!line.number(into[i])) return false;
    }
    line.skip_blanks();
    const char* const end = line.end();
    if (end != nullptr) at = end;
    return end != nullptr;
  }

  constexpr bool plain_face(const char*& at) {
    constexpr std::size_t most = 8;
    if (new_corners.count + most > new_corners.room) new_corners.flush(made.corners);
    mesh_corner* const first = new_corners.items + new_corners.count;
    std::size_t count = 0;
    std::uint32_t position = 0, texcoord = 0, normal = 0;
    obj_line line(at);
    line.pass();
    const char* end = nullptr;
    for (;; ++count) {
      line.skip_blanks();
      end = line.end();
      if (end != nullptr) break;
      if (count == most) return false;
      mesh_corner& c = first[count];
      if (!line.index(c.position, position)) return false;
      c.normal = c.texcoord = no_index;
      if (line.text[line.at] == '/') {
        line.pass();
        if (line.text[line.at] != '/' && !line.index(c.texcoord, texcoord)) return false;
        if (line.text[line.at] == '/') {
          line.pass();
          if (!line.index(c.normal, normal)) return false;
        }
      }
      if (!line.at_word_end()) return false;
    }
    if (count < 3) return false;
    named.raise_to({position, texcoord, normal});
    new_corners.count += count;
    corners += count;
    end_face();
    at = end;
    return true;
  }
};

}  // namespace IRG_ABI
}  // namespace irg::detail
