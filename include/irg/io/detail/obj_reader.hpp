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
#include <vector>

#include <irg/core/result.hpp>
#include <irg/io/detail/obj_content.hpp>
#include <irg/io/mesh_options.hpp>
#include <irg/math/decimal_digit.hpp>

namespace irg::detail::inline IRG_ABI {

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
  bool operator==(const obj_names&) const = default;
  constexpr std::size_t bytes() const noexcept { return object.size() + group.size() + material.size(); }
};

/// In a piece of a text it is not known what stands before it. Its negative indices are kept as what they would be if
/// it began the text, and this; no text of 4 GiB has so much vertex data that another index could be taken for one.
inline constexpr std::int64_t obj_back_from = std::int64_t{1} << 31;

/// Larger indices are not taken in a piece of a text.
inline constexpr std::size_t obj_most_in_piece = std::size_t{1} << 30;

/// Reads one text, or a piece of it from the beginning of a line to the end of another, or stops at `place` with
/// `message`. The parts of a piece are made by whoever knows what names stand before it.
template <Floating T>
struct obj_reader {
  /// Names that statements of a piece give before one of its faces; without data where they say nothing.
  struct naming {
    obj_names given;
    std::size_t face;
  };

  const char* at;
  const char* last;
  obj_unused unused;
  obj_counts counts;  // as many as indices may name
  bool is_piece;
  std::uint64_t name_budget;
  obj_content<T> content{};
  const char* place = nullptr;
  const char* message = nullptr;
  obj_names names{};  // as the statements so far say
  obj_names part_names{};  // of the part that grows
  bool names_changed = false;
  bool has_zero = false;  // a byte 0 stands in what has been passed over
  bool looks_back = false;
  std::vector<naming> namings{};
  obj_counts behind{0, 0, 0};  // how far negative indices reach beyond the beginning of the piece
  std::ptrdiff_t plain_bytes;  // where so many are left lines are read in one go

  constexpr obj_reader(std::string_view text, obj_unused how, obj_counts known = {}, bool piece = false)
      : at(text.data()), last(text.data() + text.size()), unused(how), counts(known), is_piece(piece),
        name_budget(std::uint64_t{16} * text.size() + 65536),
        plain_bytes(piece || known == obj_counts{} ? obj_line::readable
                                                   : static_cast<std::ptrdiff_t>(text.size()) + 1) {}

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
      if (last - at >= plain_bytes && !(names_changed && *at == 'f') && content.plain_line(at)) continue;
      skip_blanks();
      if (!at_statement_end() && !statement()) return false;
      for (; at != last && !is_line_break(*at); ++at)  // a comment, which no backslash continues
        has_zero = has_zero || *at == '\0';
      if (at != last) ++at;  // CR LF: the line between the two is empty
    }
    content.flush();
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
    content.add_position(n);
    return true;
  }

  constexpr bool normal() {
    T n[3]{};
    if (numbers(n, 3, 3, "normal has fewer than three coordinates", "normal has more than three coordinates") < 0)
      return false;
    content.add_normal(n);
    return true;
  }

  constexpr bool texcoord() {
    T n[3]{};
    if (numbers(n, 1, 3, "texture coordinate has no number", "texture coordinate has more than three numbers") < 0)
      return false;
    content.add_texcoord(n);
    return true;
  }

  constexpr bool face(const char* start) {
    std::size_t corners = 0;
    for (skip_blanks(); !at_statement_end(); skip_blanks(), ++corners)
      if (!corner()) return false;
    if (corners < 3) return fail(start, "face has fewer than three corners");
    if (names_changed && !begin_part(start)) return false;
    content.end_face();
    return true;
  }

  /// Reads i, i/t, i//n or i/t/n; t and n may be left out behind their slash, too.
  constexpr bool corner() {
    const char* const token = at;
    mesh_corner c;
    if (!index(c.position, &obj_counts::positions, obj_position_messages)) return false;
    if (slash() && !at_token_end() && *at != '/' && !index(c.texcoord, &obj_counts::texcoords, obj_texcoord_messages))
      return false;
    if (slash() && !at_token_end() && !index(c.normal, &obj_counts::normals, obj_normal_messages)) return false;
    if (!at_token_end()) return fail(token, "face corner is none of the forms 1, 1/2, 1//3 and 1/2/3");
    content.add_corner(c);
    return true;
  }

  constexpr bool slash() noexcept {
    if (at == last || *at != '/') return false;
    ++at;
    return true;
  }

  constexpr bool index(std::uint32_t& into, std::size_t obj_counts::* kind,
                       const obj_index_messages& messages) noexcept {
    const char* const token = at;
    const decimal_result<std::int64_t> number = parse_integer<std::int64_t>(at, last);
    const std::int64_t n = number.value, so_far = static_cast<std::int64_t>(content.filled.*kind);
    if (number.status == decimal_status::none) return fail(token, messages.missing);
    if (n == 0) return fail(token, messages.zero);
    if (n < -(is_piece ? static_cast<std::int64_t>(obj_most_in_piece) : so_far)) return fail(token, messages.before);
    if (n > static_cast<std::int64_t>(counts.*kind)) return fail(token, messages.beyond);
    at = number.end;
    into = static_cast<std::uint32_t>(n < 0 ? so_far + n + (is_piece ? obj_back_from : 0) : n - 1);
    looks_back = looks_back || n < 0;
    std::size_t& most = n < 0 ? behind.*kind : content.named.*kind;
    const std::int64_t reach = n < 0 ? -n - so_far : n;
    if (reach > static_cast<std::int64_t>(most)) most = static_cast<std::size_t>(reach);
    return true;
  }

  /// Moves to the end of the line, over its continuations, and returns where the last word ends. Behind a `#` where a
  /// word could begin may stand a comment, which no backslash continues.
  constexpr const char* rest_of_line() noexcept {
    const char* end = at;
    bool between_words = true, is_comment = false;
    while (at != last && !is_line_break(*at)) {
      is_comment = is_comment || (between_words && *at == '#');
      has_zero = has_zero || *at == '\0';
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
    return part_name(std::string_view(s.data(), s.size()));  // with no room to spare: budgets count what is kept
  }

  /// Opens a part for the next face unless the last one has the same names. Every part holds its names, so a long name
  /// over many parts could take memory and time that grow with the square of the text: a budget prevents it.
  constexpr bool begin_part(const char* start) {
    names_changed = false;
    if (is_piece) {
      namings.push_back({names, content.faces});
      names = {};
      return true;
    }
    if (names.bytes() > name_budget) return fail(start, "long names are repeated over too many parts");
    name_budget -= names.bytes();
    if (names == part_names) return true;
    std::vector<mesh_part>& parts = content.made.parts;
    if (parts.empty() && content.faces != 0) parts.push_back({});
    end_part();
    parts.push_back({spelled(names.object), spelled(names.group), spelled(names.material), content.faces, 0});
    part_names = names;
    return true;
  }

  constexpr void end_part() noexcept {
    if (content.made.parts.empty()) return;
    mesh_part& part = content.made.parts.back();
    part.face_count = content.faces - part.first_face;
  }

  constexpr bool unused_statement() noexcept {
    const char* const start = at;
    if (!is_letter(*at)) return fail(start, "expected a statement");
    for (; !at_token_end(); ++at)
      if (!is_letter(*at) && !is_decimal_digit(*at) && *at != '_') return fail(start, "expected a statement");
    if (unused == obj_unused::refuse) return fail(start, "statement has no place in a mesh");
    rest_of_line();
    return true;
  }
};

}  // namespace irg::detail::inline IRG_ABI
