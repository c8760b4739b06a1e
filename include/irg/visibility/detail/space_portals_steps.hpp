// SPDX-License-Identifier: MIT
// Ways through the doors of a plan in space, for potentially_visible and view_through_portals.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <irg/visibility/detail/space_blockers.hpp>
#include <irg/visibility/space_plan.hpp>

namespace irg {
namespace detail {
inline namespace IRG_ABI {

// A portal as one passes it.
template <Floating T>
struct space_doorway {
  std::uint32_t to = 0;
  std::vector<point<T, 3>> ring{};
};

// Ways through doors that some straight line may pass.
template <Floating T>
class space_walk {
public:
  constexpr explicit space_walk(const space_plan<T>& plan)
      : doors_(plan.cells.size(), std::vector<space_doorway<T>>{}) {
    for (const auto& p : plan.portals) {
      std::vector<point<T, 3>> ring;
      for (const auto& v : p.ring)
        if (ring.empty() || (!(v == ring.back()) && !(v == ring[0]))) ring.push_back(v);
      if (ring.size() < 3) continue;
      doors_[p.first].push_back({p.second, ring});
      std::reverse(ring.begin(), ring.begin() + 3);  // its first three corners tell its plane, the last may not
      std::reverse(ring.begin() + 3, ring.end());
      doors_[p.second].push_back({p.first, static_cast<std::vector<point<T, 3>>&&>(ring)});
    }
  }

  // Calls sink(cell) for each cell on a way; may_pass(passed, door) says whether it goes on. False when more than
  // most_doors were looked at.
  template <class MayPass, class Sink>
  constexpr bool from(std::uint32_t cell, std::uint64_t most_doors, const MayPass& may_pass, const Sink& sink) const {
    std::vector<way_step> way(1, way_step{cell, 0});
    std::vector<const space_doorway<T>*> passed;
    sink(cell);
    for (std::uint64_t count = 0; !way.empty();) {
      const std::uint32_t at = way.back().cell;
      if (way.back().next_door == doors_[at].size()) {
        way.pop_back();
        if (!way.empty()) passed.pop_back();
        continue;
      }
      if (count++ == most_doors) return false;
      const space_doorway<T>& d = doors_[at][way.back().next_door++];
      if (!may_pass(passed, d)) continue;
      passed.push_back(&d);
      way.push_back({d.to, 0});
      sink(d.to);
    }
    return true;
  }

  // Whether each two of some doors and one more may be passed by a line.
  static constexpr bool face_each_other(const std::vector<const space_doorway<T>*>& passed,
                                        const space_doorway<T>& d) noexcept {
    for (const auto* before : passed)
      if (are_beside<T>(before->ring, d.ring, 1) || are_beside<T>(d.ring, before->ring, -1)) return false;
    return true;
  }
  // Whether no door misses the hull of one before it and one after them all.
  static constexpr bool meet_hulls(const std::vector<const space_doorway<T>*>& passed, const space_doorway<T>& d) {
    for (std::size_t i = 0; i + 1 < passed.size(); ++i) {
      std::vector<point<T, 3>> both = passed[i]->ring;
      both.insert(both.end(), d.ring.begin(), d.ring.end());
      for (std::size_t k = i + 1; k < passed.size(); ++k)
        if (are_parted<T>(both, passed[k]->ring)) return false;
    }
    return true;
  }

  constexpr const std::vector<space_doorway<T>>& doors(std::uint32_t cell) const noexcept { return doors_[cell]; }

private:
  struct way_step {
    std::uint32_t cell;
    std::size_t next_door;
  };

  std::vector<std::vector<space_doorway<T>>> doors_;
};

}  // namespace IRG_ABI
}  // namespace detail

}  // namespace irg
