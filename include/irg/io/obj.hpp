// SPDX-License-Identifier: MIT
// Wavefront OBJ text to mesh<T>. Reads memory only: no file that the text names (mtllib, call) is ever opened. What is
// accepted, skipped and refused is listed in docs/io/obj.md.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <irg/core/executor.hpp>
#include <irg/core/result.hpp>
#include <irg/io/detail/text_place.hpp>
#include <irg/io/mesh_options.hpp>
#include <irg/mesh/mesh.hpp>
#if IRG_BODIES
#include <irg/io/detail/obj_reader.hpp>
#endif

namespace irg {

/// How an OBJ text is read.
struct obj_options {
  obj_unused unused = obj_unused::skip;
  bool operator==(const obj_options&) const = default;
};

inline namespace IRG_ABI {

/// The mesh that an OBJ text describes; its faces are the text's polygons.
/// shape   parts cover the faces in order, those before the first g, o or usemtl without names; a text that names
///         nothing has no parts
/// needs   the text in memory; it is not kept
/// gives   the first error with its line and column, in place of a half-read mesh; a text without faces is a mesh
///         without faces. The mesh passes validate(): finite numbers, three corners or more per face, every index in
///         range
/// exact   numbers are correctly rounded to T. The same mesh and the same error for every executor
/// cost    linear in the text; memory at most 64 times the text and 1 MiB. An executor reads pieces of 64 KiB, each by
///         itself
template <Floating T = double, Executor E = sequential>
[[nodiscard]] constexpr result<mesh<T>> read_obj(std::string_view text, obj_options options = {},
                                                 const E& executor = {});

}  // namespace IRG_ABI
}  // namespace irg

namespace irg::detail::inline IRG_COMPILED_ABI {

/// The mesh of a text, or the first error, by one reader after another.
template <Floating T>
IRG_API result<mesh<T>> read_obj_in_one_go(std::string_view text, obj_unused unused);

/// What read_obj_in_one_go gives, for every executor and any pieces.
/// needs   bytes > 0
template <Floating T>
IRG_API result<mesh<T>> read_obj_in_pieces(std::string_view text, obj_unused unused, std::size_t bytes,
                                           const executor_ref& executor);

}  // namespace irg::detail::inline IRG_COMPILED_ABI

#if IRG_BODIES
namespace irg::detail::inline IRG_ABI {

// An OBJ text cut at ends of lines into pieces that an executor's tasks read, each as if it began the text, and laid
// together in the text's order. What depends on the lines before a piece is settled when it is joined: negative
// indices, and the names of parts.
//
// Pieces are read by the wave; while one is read, other tasks append what the wave before it gave. So no more than two
// waves stand in memory beside the mesh, and little is left for one thread alone. Whatever is wrong, where it stands
// and what comes first, is for the reading in one go to say.

/// How much of a text a piece takes: `least` bytes and what follows up to the end of a line that no backslash
/// continues.
/// needs   least > 0
constexpr std::size_t length_of_piece(std::string_view text, std::size_t least) noexcept {
  const auto byte = [&](std::size_t i) { return i < text.size() ? text[i] : '\n'; };  // also for i = -1
  for (std::size_t i = least - 1; i < text.size(); ++i) {
    if (!is_line_break(text[i]) || byte(i - 1) == '\\') continue;
    if (text[i] == '\n' && byte(i - 1) == '\r' && byte(i - 2) == '\\') continue;
    return i + 1;
  }
  return text.size();
}

template <Floating T>
struct obj_pieces {
  struct piece {
    obj_reader<T> reader;
    bool is_sound = false;
    obj_counts before{0, 0, 0};  // what the text gives before it
    std::uint32_t corners_before = 0;
  };
  /// Pieces that are read at a time; their memory is used again.
  struct wave {
    std::vector<piece> pieces{};
    std::size_t count = 0;
  };
  static constexpr std::size_t most_in_wave = 32;
  static constexpr std::size_t arrays = 5;

  obj_reader<T> whole;
  std::string_view rest;  // of the text
  std::size_t piece_bytes;
  std::size_t corners = 0;

  constexpr obj_pieces(std::string_view text, obj_unused unused, std::size_t bytes)
      : whole(text, unused), rest(text), piece_bytes(bytes) {}

  /// Whether the text could be read; then `whole` has its mesh.
  template <class E>
  constexpr bool read(const E& executor) {
    const obj_samples seen = samples_of_obj(rest);
    whole.content.reserve(seen, rest.size());
    wave waves[2];
    for (std::size_t turn = 0;; turn ^= 1) {
      wave &now = waves[turn], &joined = waves[turn ^ 1];
      cut(now, seen);
      if (now.count == 0 && joined.count == 0) break;
      make_room();
      executor(arrays + now.count, [&](std::size_t i) {
        if (i < arrays)
          append(joined, i);
        else
          read_piece(now.pieces[i - arrays]);
      });
      for (std::size_t i = 0; i < now.count; ++i)
        if (!settle(now.pieces[i])) return false;
    }
    if (!whole.content.every_index_exists()) return false;
    whole.end_part();
    return true;
  }

  constexpr void cut(wave& w, const obj_samples& seen) {
    w.count = 0;
    for (; w.count < most_in_wave && !rest.empty(); ++w.count) {
      const std::size_t length = length_of_piece(rest, piece_bytes);
      obj_reader<T> reader(rest.substr(0, length), whole.unused,
                           {obj_most_in_piece, obj_most_in_piece, obj_most_in_piece}, true);
      if (w.count == w.pieces.size()) {
        w.pieces.push_back({std::move(reader)});
        w.pieces.back().reader.content.reserve(seen, length);
      } else {
        reader.content = std::move(w.pieces[w.count].reader.content);
        reader.content.clear();
        w.pieces[w.count].reader = std::move(reader);
      }
      rest.remove_prefix(length);
    }
  }

  /// A task must not throw: what fails for want of memory is tried in one go.
  static constexpr void read_piece(piece& p) {
#ifdef __cpp_exceptions
    try {
      p.is_sound = p.reader.text() && !p.reader.has_zero;
    } catch (...) {
      p.is_sound = false;
    }
#else
    p.is_sound = p.reader.text() && !p.reader.has_zero;
#endif
  }

  /// Counts what a piece gives, and takes up its names; says whether it stands where it can.
  constexpr bool settle(piece& p) {
    const obj_reader<T>& r = p.reader;
    if (!p.is_sound || !whole.content.filled.reach(r.behind)) return false;
    p.before = whole.content.filled;
    p.corners_before = static_cast<std::uint32_t>(corners);
    if (!take_names(r)) return false;
    whole.content.filled.add(r.content.filled);
    whole.content.named.raise_to(r.content.named);
    corners += r.content.corners;
    return true;
  }

  /// Begins the parts of a piece, as if its statements were read here.
  constexpr bool take_names(const obj_reader<T>& r) {
    std::size_t& faces = whole.content.faces;
    const std::size_t before = faces, first = r.namings.empty() ? r.content.faces : r.namings[0].face;
    if (whole.names_changed && first > 0 && !whole.begin_part(nullptr)) return false;
    for (const auto& n : r.namings) {
      take(n.given);
      faces = before + n.face;
      if (!whole.begin_part(nullptr)) return false;
    }
    if (r.names_changed) take(r.names);
    faces = before + r.content.faces;
    return true;
  }
  constexpr void take(const obj_names& given) noexcept {
    if (given.object.data() != nullptr) whole.names.object = given.object;
    if (given.group.data() != nullptr) whole.names.group = given.group;
    if (given.material.data() != nullptr) whole.names.material = given.material;
    whole.names_changed = true;
  }

  /// Memory for what has been settled, which tasks may then fill.
  constexpr void make_room() {
    mesh<T>& made = whole.content.made;
    const auto grow = [](auto& all, std::size_t count) {
      const std::size_t more = all.capacity() + all.capacity() / 2;
      if (count > all.capacity()) all.reserve(count < more ? more : count);
    };
    grow(made.positions, whole.content.filled.positions);
    grow(made.normals, whole.content.filled.normals);
    grow(made.texcoords, whole.content.filled.texcoords);
    grow(made.corners, corners);
    grow(made.face_starts, whole.content.faces + 1);
  }

  /// Appends one of the arrays of a wave.
  constexpr void append(const wave& w, std::size_t array) {
    mesh<T>& made = whole.content.made;
    for (std::size_t i = 0; i < w.count; ++i) {
      const obj_content<T>& c = w.pieces[i].reader.content;
      const auto put = [](auto& all, const auto& more, std::size_t count) {
        all.insert(all.end(), more.data(), more.data() + count);
      };
      switch (array) {
        case 0:
          put(made.corners, c.made.corners, c.corners);
          settle_corners(w.pieces[i]);
          break;
        case 1: put(made.positions, c.made.positions, c.filled.positions); break;
        case 2: put(made.normals, c.made.normals, c.filled.normals); break;
        case 3: put(made.texcoords, c.made.texcoords, c.filled.texcoords); break;
        default:
          for (std::size_t f = 1; f <= c.faces; ++f)
            made.face_starts.push_back(w.pieces[i].corners_before + c.made.face_starts[f]);
      }
    }
  }

  /// Makes indices out of what a piece has counted back from its beginning.
  constexpr void settle_corners(const piece& p) {
    if (!p.reader.looks_back) return;
    const auto settled = [](std::uint32_t index, std::size_t before) {
      const std::int64_t back = std::int64_t{index} - obj_back_from + static_cast<std::int64_t>(before);
      return index == no_index || index < obj_most_in_piece ? index : static_cast<std::uint32_t>(back);
    };
    std::vector<mesh_corner>& all = whole.content.made.corners;
    for (std::size_t i = all.size() - p.reader.content.corners; i < all.size(); ++i)
      all[i] = {settled(all[i].position, p.before.positions), settled(all[i].normal, p.before.normals),
                settled(all[i].texcoord, p.before.texcoords)};
  }
};

}  // namespace irg::detail::inline IRG_ABI

namespace irg::detail::inline IRG_COMPILED_ABI {

template <Floating T>
IRG_API result<mesh<T>> read_obj_in_one_go(std::string_view text, obj_unused unused) {
  obj_counts counts;
  {
    obj_reader<T> reader(text, unused);
    reader.content.reserve(samples_of_obj(text), text.size());
    const bool sound = reader.text();
    if (const std::size_t zero = sound && !reader.has_zero ? text.npos : text.find('\0'); zero != text.npos)
      return error_at(text, text.data() + zero, "byte 0 stands in the text");
    if (!sound) return error_at(text, reader.place, reader.message);
    if (reader.content.every_index_exists()) {
      reader.end_part();
      return std::move(reader.content.made);
    }
    counts = reader.content.filled;
  }
  obj_reader<T> reader(text, unused, counts);
  reader.text();
  return error_at(text, reader.place, reader.message);
}

template <Floating T>
IRG_API result<mesh<T>> read_obj_in_pieces(std::string_view text, obj_unused unused, std::size_t bytes,
                                           const executor_ref& executor) {
  {
    obj_pieces<T> pieces(text, unused, bytes);
    if (pieces.read(executor)) return std::move(pieces.whole.content.made);
  }
  return read_obj_in_one_go<T>(text, unused);
}

}  // namespace irg::detail::inline IRG_COMPILED_ABI
#endif

namespace irg::inline IRG_ABI {

template <Floating T, Executor E>
[[nodiscard]] constexpr result<mesh<T>> read_obj(std::string_view text, obj_options options, const E& executor) {
  if (static_cast<std::uint64_t>(text.size()) >> 32 != 0) return parse_error{0, 0, "text is longer than 4 GiB"};
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF"))
    return parse_error{0, 0, "text is UTF-16, but OBJ must be ASCII or UTF-8"};
  text = detail::without_byte_order_mark(text);
  if constexpr (!std::is_same_v<E, sequential>) {
    constexpr std::size_t piece_bytes = std::size_t{1} << 16;
    if (text.size() > 2 * piece_bytes)
      return detail::read_obj_in_pieces<T>(text, options.unused, piece_bytes, as_executor(executor));
  }
  return detail::read_obj_in_one_go<T>(text, options.unused);
}

}  // namespace irg::inline IRG_ABI
