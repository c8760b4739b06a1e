// SPDX-License-Identifier: MIT
// Reads the statements of Wavefront OBJ, one after another: lines as nearly all are in one go, all others with care.
//
// Positions are found by pointer alone; line and column are counted when an error is reported, so that reading does not
// pay for them. A face may name vertices that follow it: such indices are checked at the end of the text, and when one
// is bad the text is read a second time, with the counts known, to find its place. Nothing is kept for it meanwhile.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <utility>

#include <irg/core/result.hpp>
#include <irg/io/detail/text_place.hpp>
#include <irg/math/decimal.hpp>
#include <irg/mesh/mesh.hpp>

namespace irg {

/// What to do with statements that the mesh has no place for: points, lines, curves, smoothing groups and the like.
enum class obj_unused { skip, refuse };

namespace detail {
inline namespace IRG_ABI {

/// How many of each kind of vertex data there are; until the end of the text is reached, as many as indices can name.
struct obj_counts {
  std::size_t positions = mesh_corner::none, texcoords = mesh_corner::none, normals = mesh_corner::none;
};

/// The sentences for a bad index of one kind.
struct obj_index_messages {
  const char *missing, *zero, *before, *beyond;
};
inline constexpr obj_index_messages obj_position_messages{
    "expected the index of a vertex", "vertex index is 0, but indices count from 1",
    "negative vertex index reaches back beyond the first vertex", "face index is larger than the number of vertices"};
inline constexpr obj_index_messages obj_texcoord_messages{
    "expected the index of a texture coordinate", "texture coordinate index is 0, but indices count from 1",
    "negative texture coordinate index reaches back beyond the first one",
    "texture coordinate index is larger than the number of texture coordinates"};
inline constexpr obj_index_messages obj_normal_messages{
    "expected the index of a normal", "normal index is 0, but indices count from 1",
    "negative normal index reaches back beyond the first normal", "normal index is larger than the number of normals"};

/// The names that the next faces belong to, as they stand in the text.
struct obj_names {
  std::string_view object, group, material;
  constexpr bool operator==(const obj_names&) const = default;
  constexpr std::size_t bytes() const noexcept { return object.size() + group.size() + material.size(); }
};

/// Reads one text into `read`, or stops at `place` with `message`.
template <Floating T>
struct obj_reader {
  const char* at;
  const char* last;
  obj_unused unused;
  obj_counts counts;
  std::size_t name_budget;
  mesh<T> read{};
  const char* place = nullptr;
  const char* message = nullptr;
  obj_names names{};  // as the statements so far say
  obj_names part_names{};  // of the part that grows
  bool names_changed = false;
  const char* plain_end;  // the last line feed; the beginning when no line is to be read the quick way

  constexpr obj_reader(std::string_view text, obj_unused how, obj_counts known)
      : at(text.data()), last(text.data() + text.size()), unused(how), counts(known),
        name_budget(16 * text.size() + 65536),
        plain_end(known.positions == mesh_corner::none ? last_line_feed(text) : text.data()) {}

  constexpr bool fail(const char* where, const char* why) noexcept {
    place = where;
    message = why;
    return false;
  }

  /// The length of a continuation, a backslash at the end of a line, that stands at p; 0 when none does.
  constexpr int continuation(const char* p) const noexcept {
    if (*p != '\\') return 0;
    if (p + 1 == last) return 1;
    if (p[1] == '\n') return 2;
    return p[1] != '\r' ? 0 : p + 2 != last && p[2] == '\n' ? 3 : 2;
  }

  constexpr void skip_blanks() noexcept {
    for (; at != last; ++at)
      if (!is_blank(*at)) {
        const int length = continuation(at);
        if (length == 0) return;
        at += length - 1;
      }
  }

  constexpr bool at_token_end() const noexcept {
    return at == last || is_blank(*at) || is_line_break(*at) || continuation(at) != 0;
  }
  constexpr bool at_statement_end() const noexcept { return at == last || is_line_break(*at) || *at == '#'; }

  constexpr bool text() {
    while (at != last) {
      if (at < plain_end && plain_line()) continue;
      skip_blanks();
      if (!at_statement_end() && !statement()) return false;
      while (at != last && !is_line_break(*at)) ++at;  // a comment, which no backslash continues
      if (at != last) ++at;  // CR LF: the line between the two is empty
    }
    return true;
  }

  static constexpr const char* last_line_feed(std::string_view text) noexcept {
    const std::size_t place = text.rfind('\n');
    return text.data() + (place == std::string_view::npos ? 0 : place);
  }

  /// Asks for the memory that a long text will need, as far as samples of its lines tell: growing it bit by bit takes
  /// as long as reading. A wrong guess costs memory within the reader's bound, or time.
  constexpr void reserve(std::string_view text) {
    constexpr std::size_t samples = 64, sample_bytes = 512;
    if (text.size() < 8 * samples * sample_bytes) return;
    std::size_t vertices = 0, normals = 0, texcoords = 0, faces = 0, quads = 0;
    for (std::size_t s = 0; s < samples; ++s) {
      const std::size_t first = text.size() / samples * s;
      for (std::size_t i = first + 1; i < first + sample_bytes; ++i) {
        if (text[i - 1] != '\n') continue;
        if (text[i] == 'v') ++(text[i + 1] == 'n' ? normals : text[i + 1] == 't' ? texcoords : vertices);
        if (text[i] != 'f') continue;
        std::size_t blanks = 0;
        for (std::size_t k = i; k < i + 40 && text[k] != '\n'; ++k) blanks += text[k] == ' ' ? 1u : 0u;
        ++faces;
        quads += blanks > 3 ? 1u : 0u;
      }
    }
    // A sixteenth more than was seen, so that an even text needs no second piece.
    const std::size_t scale = text.size() / (samples * sample_bytes) + text.size() / (16 * samples * sample_bytes) + 1;
    read.positions.reserve(vertices * scale);
    read.normals.reserve(normals * scale);
    read.texcoords.reserve(texcoords * scale);
    read.corners.reserve((3 * faces + quads) * scale);
    read.face_starts.reserve(faces * scale + 1);
  }

  /// Reads a line as nearly all are, in one go: a vertex, a normal, a texture coordinate or a face, numbers without an
  /// exponent, indices from 1 on, blanks between them. Says whether it did; otherwise nothing has happened.
  /// needs   at < plain_end: the line feed there ends every loop
  constexpr bool plain_line() {
    if (*at == 'f' && at[1] == ' ') return plain_face(at + 2);
    if (*at != 'v') return false;
    T n[3]{};
    if (at[1] == ' ') return plain_numbers<3>(at + 2, n) && (read.positions.push_back({n[0], n[1], n[2]}), true);
    if (at[1] == 'n' && at[2] == ' ')
      return plain_numbers<3>(at + 3, n) && (read.normals.push_back({n[0], n[1], n[2]}), true);
    if (at[1] == 't' && at[2] == ' ')
      return plain_numbers<2>(at + 3, n) && (read.texcoords.push_back({n[0], n[1]}), true);
    return false;
  }

  static constexpr const char* behind_blanks(const char* p) noexcept {
    while (*p == ' ') ++p;
    return p;
  }

  template <int Count>
  constexpr bool plain_numbers(const char* p, T* into) noexcept {
    for (int i = 0; i < Count; ++i) {
      p = behind_blanks(p);
      if (!parse_short_decimal(p, into[i]) || (*p != ' ' && !is_line_break(*p))) return false;
    }
    p = behind_blanks(p);
    if (!is_line_break(*p)) return false;
    at = p + 1;
    return true;
  }

  /// An index of up to nine digits, at least 1.
  static constexpr bool plain_index(const char*& p, std::uint32_t& into) noexcept {
    const char* const first = p;
    std::uint32_t n = 0;
    for (; is_digit(*p); ++p) n = n * 10 + digit_value(*p);
    into = n - 1;
    return n != 0 && p - first <= 9;
  }

  constexpr bool plain_face(const char* p) {
    constexpr std::size_t most = 8;
    mesh_corner corners[most];
    std::size_t count = 0;
    for (p = behind_blanks(p); !is_line_break(*p); p = behind_blanks(p)) {
      if (count == most) return false;
      mesh_corner& c = corners[count++];
      if (!plain_index(p, c.position)) return false;
      if (*p == '/') {
        ++p;
        if (*p != '/' && !plain_index(p, c.texcoord)) return false;
      }
      if (*p == '/') {
        ++p;
        if (!plain_index(p, c.normal)) return false;
      }
      if (*p != ' ' && !is_line_break(*p)) return false;
    }
    if (count < 3 || names_changed) return false;
    read.corners.insert(read.corners.end(), corners, corners + count);
    read.face_starts.push_back(static_cast<std::uint32_t>(read.corners.size()));
    if (!read.parts.empty()) ++read.parts.back().face_count;
    at = p + 1;
    return true;
  }

  /// Whether the word stands at `at`; if so, moves behind it.
  constexpr bool keyword(std::string_view word) noexcept {
    if (static_cast<std::size_t>(last - at) < word.size()) return false;
    for (std::size_t i = 0; i < word.size(); ++i)
      if (at[i] != word[i]) return false;
    at += word.size();
    if (at_token_end()) return true;
    at -= word.size();
    return false;
  }

  constexpr bool statement() {
    const char* const start = at;
    if (keyword("v")) return vertex();
    if (keyword("f")) return face(start);
    if (keyword("vn")) return normal();
    if (keyword("vt")) return texcoord();
    if (keyword("g")) return name(names.group);
    if (keyword("o")) return name(names.object);
    if (keyword("usemtl")) return name(names.material);
    return unused_statement();
  }

  /// Reads numbers until the statement ends; says how many, or -1 after an error.
  constexpr int numbers(T* into, int least, int most, const char* too_few, const char* too_many) noexcept {
    int count = 0;
    for (skip_blanks(); !at_statement_end(); skip_blanks(), ++count) {
      if (count == most) return fail(at, too_many), -1;
      const char* const token = at;
      const decimal_result<T> number = parse_decimal<T>(at, last);
      at = number.end;
      if (number.status == decimal_status::none || !at_token_end()) return fail(token, number_error(token, last)), -1;
      if (number.status == decimal_status::overflow) return fail(token, "number is too large"), -1;
      into[count] = number.value;
    }
    if (count < least) return fail(at, too_few), -1;
    return count;
  }

  constexpr bool vertex() {
    T n[7]{};
    if (numbers(n, 3, 7, "vertex has fewer than three coordinates", "vertex has more than seven numbers") < 0)
      return false;
    read.positions.push_back({n[0], n[1], n[2]});
    return true;
  }

  constexpr bool normal() {
    T n[3]{};
    if (numbers(n, 3, 3, "normal has fewer than three coordinates", "normal has more than three coordinates") < 0)
      return false;
    read.normals.push_back({n[0], n[1], n[2]});
    return true;
  }

  constexpr bool texcoord() {
    T n[3]{};
    if (numbers(n, 1, 3, "texture coordinate has no number", "texture coordinate has more than three numbers") < 0)
      return false;
    read.texcoords.push_back({n[0], n[1]});
    return true;
  }

  constexpr bool face(const char* start) {
    std::size_t corners = 0;
    for (skip_blanks(); !at_statement_end(); skip_blanks(), ++corners)
      if (!corner()) return false;
    if (corners < 3) return fail(start, "face has fewer than three corners");
    if (names_changed && !begin_part(start)) return false;
    read.face_starts.push_back(static_cast<std::uint32_t>(read.corners.size()));
    if (!read.parts.empty()) ++read.parts.back().face_count;
    return true;
  }

  /// Reads i, i/t, i//n or i/t/n; t and n may be left out behind their slash, too.
  constexpr bool corner() {
    const char* const token = at;
    mesh_corner c;
    if (!index(c.position, read.positions.size(), counts.positions, obj_position_messages)) return false;
    if (slash() && !at_token_end() && *at != '/' &&
        !index(c.texcoord, read.texcoords.size(), counts.texcoords, obj_texcoord_messages))
      return false;
    if (slash() && !at_token_end() && !index(c.normal, read.normals.size(), counts.normals, obj_normal_messages))
      return false;
    if (!at_token_end()) return fail(token, "face corner is none of the forms 1, 1/2, 1//3 and 1/2/3");
    read.corners.push_back(c);
    return true;
  }

  constexpr bool slash() noexcept {
    if (at == last || *at != '/') return false;
    ++at;
    return true;
  }

  constexpr bool index(std::uint32_t& into, std::size_t so_far, std::size_t limit,
                       const obj_index_messages& messages) noexcept {
    const char* const token = at;
    const decimal_result<std::int64_t> number = parse_integer<std::int64_t>(at, last);
    if (number.status == decimal_status::none) return fail(token, messages.missing);
    if (number.value == 0) return fail(token, messages.zero);
    if (number.value < -static_cast<std::int64_t>(so_far)) return fail(token, messages.before);
    if (number.value > static_cast<std::int64_t>(limit)) return fail(token, messages.beyond);
    at = number.end;
    const std::int64_t from = number.value < 0 ? static_cast<std::int64_t>(so_far) : -1;
    into = static_cast<std::uint32_t>(from + number.value);
    return true;
  }

  /// Moves to the end of the line, over its continuations, and returns where the last word ends. Behind a `#` where a
  /// word could begin may stand a comment, which no backslash continues.
  constexpr const char* rest_of_line() noexcept {
    const char* end = at;
    bool between_words = true, is_comment = false;
    while (at != last && !is_line_break(*at)) {
      is_comment = is_comment || (between_words && *at == '#');
      const int length = is_comment ? 0 : continuation(at);
      between_words = length != 0 || is_blank(*at);
      at += length != 0 ? length : 1;
      if (!between_words) end = at;
    }
    return end;
  }

  /// Takes the rest of the line, without the blanks around it, as a name.
  constexpr bool name(std::string_view& into) noexcept {
    skip_blanks();
    const char* const start = at;
    into = {start, static_cast<std::size_t>(rest_of_line() - start)};
    names_changed = true;
    return true;
  }

  /// The name with blanks for its continuations.
  constexpr part_name spelled(std::string_view name) const {
    part_name s;
    const char* const end = name.data() + name.size();
    for (const char* p = name.data(); p != end;) {
      const int length = continuation(p) < end - p ? continuation(p) : 0;  // the last word is none
      s.push_back(length != 0 ? ' ' : *p);
      p += length != 0 ? length : 1;
    }
    return s;
  }

  /// Opens a part for the next face unless the last one has the same names. Every part holds its names, so a long name
  /// over many parts could take memory and time that grow with the square of the text: a budget prevents it.
  constexpr bool begin_part(const char* start) {
    if (names.bytes() > name_budget) return fail(start, "long names are repeated over too many parts");
    name_budget -= names.bytes();
    names_changed = false;
    if (names == part_names) return true;
    const std::size_t faces = read.face_starts.size() - 1;
    if (read.parts.empty() && faces != 0) read.parts.push_back({{}, {}, {}, 0, faces});
    read.parts.push_back({spelled(names.object), spelled(names.group), spelled(names.material), faces, 0});
    part_names = names;
    return true;
  }

  constexpr bool unused_statement() noexcept {
    const char* const start = at;
    if (!is_letter(*at)) return fail(start, "expected a statement");
    for (; !at_token_end(); ++at)
      if (!is_letter(*at) && !is_digit(*at) && *at != '_') return fail(start, "expected a statement");
    if (unused == obj_unused::refuse) return fail(start, "statement has no place in a mesh");
    rest_of_line();
    return true;
  }

  /// Whether every index of the corners names something that was read.
  constexpr bool indices_hold() const noexcept {
    for (const mesh_corner& c : read.corners)
      if (c.position >= read.positions.size() ||
          (c.texcoord != mesh_corner::none && c.texcoord >= read.texcoords.size()) ||
          (c.normal != mesh_corner::none && c.normal >= read.normals.size()))
        return false;
    return true;
  }
};

}  // namespace IRG_ABI
}  // namespace detail

}  // namespace irg
