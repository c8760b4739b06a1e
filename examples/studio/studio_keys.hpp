// SPDX-License-Identifier: MIT
// What keys and the mouse do in the studio's window, as --help and F1 tell it.
#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

namespace program {

/// A key, or what the mouse does, and what comes of it.
struct studio_key {
  std::string_view key, what;
};

inline constexpr std::array<studio_key, 38> studio_keys{{
    {"Tab, Shift+Tab", "choose the next body, the one before"},
    {"Delete", "drop the body"},
    {"1 2 3 4", "its points, edges, faces, backs shown or not"},
    {"s", "its shading: none, flat, Gouraud, Phong"},
    {"t", "transparent or not"},
    {"c", "another colour"},
    {"w", "transformations go before or after the camera"},
    {"arrows, Page Up, Page Down", "move the body"},
    {"x y z, with Shift back", "turn it about an axis"},
    {"r", "turn it as y does"},
    {"a", "turn it about z after the camera"},
    {"+ -", "make it larger, smaller"},
    {"[ ]", "choose the transformation before, behind"},
    {"u d", "move the chosen one up, down in its list"},
    {"b", "make it the first one"},
    {"Backspace", "remove it"},
    {"v", "choose the other view"},
    {"p", "the view's next projection"},
    {"h", "axes and pyramid in it"},
    {"i j k l", "go round its target"},
    {"n m", "go nearer, away"},
    {"g", "a new lamp at its eye"},
    {"Shift+g", "drop the last lamp"},
    {"F5, F8", "save studio.xml, restore it"},
    {"F6", "picture studio.png, of both views"},
    {"F7", "studio_window.png, of the whole window"},
    {"F4", "panels shown or not"},
    {"F2", "keys go to the upper panel, to the lower one, to none"},
    {"arrows in a panel", "choose a cell"},
    {"Return in a panel", "press it; open a number as a line"},
    {"+ - in a panel", "change its number"},
    {"Return", "type any line of the script; Return does it, Escape leaves it"},
    {"F1", "these keys"},
    {"Escape", "end"},
    {"drag in a view", "go round its target; with the right button, sideways"},
    {"wheel in a view", "go nearer, away"},
    {"press in a panel", "press a cell; wheel: change its number, or scroll"},
    {"drop a file", "load it"},
}};

/// The keys as lines of text.
inline std::string studio_keys_text() {
  std::string text;
  for (const studio_key& k : studio_keys)
    text += "  " + std::string(k.key) + std::string(std::max<std::size_t>(28 - k.key.size(), 1), ' ') +
            std::string(k.what) + "\n";
  return text;
}

}  // namespace program
