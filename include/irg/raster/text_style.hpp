// SPDX-License-Identifier: MIT
// How text is placed, and how much room it takes.
#pragma once

namespace irg {

/// Which part of the text lies at the position given, along the line.
enum class text_along { left, centre, right };

/// Which part lies there across the line; middle is that of the capitals and digits.
enum class text_across { baseline, middle, top, bottom };

/// The choices together.
/// units   size and weight in pixels, turn in degrees, clockwise on the screen
struct text_style {
  double size = 20;  // of a line; capitals are 7/10 of it
  double turn = 0;  // about the position
  double weight = 0;  // of the strokes; when it is not positive, a twelfth of the size, but one pixel at least
  text_along along = text_along::left;
  text_across across = text_across::baseline;
  constexpr bool operator==(const text_style&) const = default;
};

/// The room that a text takes.
struct text_extent {
  double width = 0, ascent = 0, descent = 0;
  constexpr bool operator==(const text_extent&) const = default;
};

}  // namespace irg
