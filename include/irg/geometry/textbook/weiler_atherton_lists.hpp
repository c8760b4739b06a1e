// SPDX-License-Identifier: MIT
// The first half of Weiler and Atherton's clipping: rings as lists of their vertices, with the crossings in between.
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include <irg/geometry/intersect_lines.hpp>
#include <irg/geometry/orient2d.hpp>
#include <irg/geometry/polygon.hpp>

namespace irg::textbook {

/// What Weiler and Atherton's clipping comes to. `touching`: a vertex lies on the other polygon's boundary, or entering
/// and leaving points do not take turns: crossings are too near to each other, or rings are not as they should be.
enum class [[nodiscard]] weiler_atherton_status { ok, touching, not_finite, done [[deprecated("irg: ok")]] = ok };

/// A vertex, at the start of its edge, or a crossing along that edge, with its number among the crossings.
template <Floating T>
struct listed_vertex {
  point<T, 2> at;
  std::size_t edge = 0;
  T along = 0;  // from 0 at the edge's start to 1
  std::optional<std::size_t> crossing{};
  bool operator==(const listed_vertex&) const = default;
};

/// A point where the subject (0) enters or leaves the clip polygon (1), and its places in the lists of both.
template <Floating T>
struct listed_crossing {
  point<T, 2> at;
  bool enters = false;
  std::size_t ring[2] = {}, place[2] = {};
  bool operator==(const listed_crossing&) const = default;
};

/// The lists of the subject (0) and of the clip polygon (1), one for each ring, and all crossings, if status is `ok`.
template <Floating T>
struct weiler_atherton_lists {
  weiler_atherton_status status = weiler_atherton_status::ok;
  std::vector<std::vector<listed_vertex<T>>> subject{}, clip{};
  std::vector<listed_crossing<T>> crossings{};
  bool operator==(const weiler_atherton_lists&) const = default;
};

inline namespace IRG_ABI {

/// The lists of two polygons with their crossings.
/// needs   rings that neither cross themselves nor another ring of the same polygon
/// exact   which edges cross, and what enters, is decided exactly; crossings within 0.501 ulp
/// cost    each edge against each edge of the other polygon; allocates
/// source  Weiler and Atherton 1977
template <Floating T>
[[nodiscard]] constexpr weiler_atherton_lists<T> list_crossings(const std::vector<std::vector<point<T, 2>>>& subject,
                                                                const std::vector<std::vector<point<T, 2>>>& clip) {
  weiler_atherton_lists<T> out;
  out.subject.resize(subject.size());
  out.clip.resize(clip.size());
  for (std::size_t r = 0; r < subject.size(); ++r)
    for (std::size_t i = 0; i < subject[r].size(); ++i) out.subject[r].push_back({subject[r][i], i});
  for (std::size_t q = 0; q < clip.size(); ++q)
    for (std::size_t k = 0; k < clip[q].size(); ++k) out.clip[q].push_back({clip[q][k], k});
  for (std::size_t r = 0; r < subject.size(); ++r)  // every edge ab of the subject, every edge cd of the clip polygon
    for (std::size_t i = 0; i < subject[r].size(); ++i)
      for (std::size_t q = 0; q < clip.size(); ++q)
        for (std::size_t k = 0; k < clip[q].size(); ++k) {
          const point<T, 2> a = subject[r][i], b = ring_vertex(subject[r], i + 1);
          const point<T, 2> c = clip[q][k], d = ring_vertex(clip[q], k + 1);
          const int at_a = orient2d(c, d, a), at_b = orient2d(c, d, b);
          const int at_c = orient2d(a, b, c), at_d = orient2d(a, b, d);
          if ((at_a == 0 && detail::is_between(c, d, a)) || (at_c == 0 && detail::is_between(a, b, c)))
            out.status = weiler_atherton_status::touching;
          if (at_a * at_b >= 0 || at_c * at_d >= 0) continue;
          const auto m = intersect_lines(a, b, c, d);
          out.subject[r].push_back({m.at, i, m.t, out.crossings.size()});
          out.clip[q].push_back({m.at, k, m.s, out.crossings.size()});
          out.crossings.push_back({m.at, at_a < 0, {r, q}});
        }
  for (const int which : {0, 1})  // the crossings in between the vertices
    for (std::vector<listed_vertex<T>>& list : which == 0 ? out.subject : out.clip) {
      std::sort(list.begin(), list.end(),
                [](const auto& p, const auto& q) { return p.edge != q.edge ? p.edge < q.edge : p.along < q.along; });
      std::vector<std::size_t> met;
      for (std::size_t i = 0; i < list.size(); ++i) {
        const bool apart = i == 0 || list[i - 1].edge != list[i].edge || list[i - 1].along < list[i].along;
        if (!apart) out.status = weiler_atherton_status::touching;
        if (!list[i].crossing) continue;
        out.crossings[*list[i].crossing].place[which] = i;
        met.push_back(*list[i].crossing);
      }
      for (std::size_t k = 0; k < met.size(); ++k)  // entering and leaving take turns
        if (out.crossings[met[k]].enters == out.crossings[met[k + 1 < met.size() ? k + 1 : 0]].enters)
          out.status = weiler_atherton_status::touching;
    }
  return out;
}

}  // namespace IRG_ABI
}  // namespace irg::textbook
