// SPDX-License-Identifier: MIT
// Motion along a curve at constant speed, for eyes, targets and bodies: the curve's point and derivative at a share of
// its length.
#pragma once

#include <cstddef>
#include <span>
#include <type_traits>

#include <irg/curve/arc_length.hpp>
#include <irg/math/length.hpp>

namespace irg {

/// A curve that is run along at constant speed. `sample` tells what the curve is: sample(t) gives a curve_sample, as
/// bezier_sample and bspline_sample do.
template <Floating T, class Sample>
class constant_speed {
public:
  /// The motion from t = first to last; `lengths` is its table, as arc_lengths fills it, and stays yours.
  /// needs   two lengths or more, first < last
  IRG_APART constexpr constant_speed(const Sample& sample, std::type_identity_t<T> first, std::type_identity_t<T> last,
                                     std::span<T> lengths)
      : sample_(sample), table_(arc_lengths<T>(speed(), first, last, lengths)) {}

  [[nodiscard]] IRG_APART constexpr T length() const noexcept { return table_.length(); }

  /// The parameter where this share of the length has been run.
  /// gives   the curve's beginning for shares up to 0 and NaN, its end for those from 1 on
  /// exact   as parameter_at_length: within some 30 u of the whole length where the speed is smooth, however few pieces
  ///         the table has
  [[nodiscard]] IRG_APART constexpr T parameter(std::type_identity_t<T> share) const {
    if (!(share > T(0))) return table_.first;
    if (!(share < T(1))) return table_.last;
    return parameter_at_length(speed(), table_, product(share, length()));
  }

  /// The point and the derivative there.
  [[nodiscard]] IRG_APART constexpr auto at(std::type_identity_t<T> share) const { return sample_(parameter(share)); }

private:
  [[nodiscard]] IRG_APART constexpr auto speed() const {
    return [this](T t) { return irg::length(sample_(t).derivative); };
  }
  Sample sample_;
  arc_length_table<T> table_;
};

template <class Sample, class T, class U, class V>
constant_speed(const Sample&, T, U, std::span<V>) -> constant_speed<V, Sample>;

}  // namespace irg
