// SPDX-License-Identifier: MIT
// street_view_2d - what of a town is seen from a place in its streets, or on the way along a path.
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include <irg/geometry/point_in_polygon.hpp>
#include <irg/geometry/polygon_area.hpp>
#include <irg/io/file.hpp>
#include <irg/io/image_file.hpp>
#include <irg/io/svg_drawing.hpp>
#include <irg/raster/fill_polygon_aa.hpp>
#include <irg/visibility/visibility_polygon.hpp>
#include <irg/visibility/weak_visibility.hpp>

#include "support/command_line.hpp"
#include "support/number_input.hpp"
#include "support/number_output.hpp"
#include "support/picture_options.hpp"
#include "support/run_or_fail.hpp"

namespace {

constexpr std::string_view help =
    R"(street_view_2d - what of a town is seen from a place in its streets, or on the way along a path

usage: street_view_2d [options] <TOWN

Reads the town's borders x0 y0 x1 y1, the number of houses, for each the number of its corners and x y of each corner,
then x y of one place, or of the corners of a path, from standard input. Houses may touch and overlap. All is in the
town or on its borders. Prints per place

  view: x y area houses     how much is seen from there, and of how many houses a wall
  view: x y house N         where the place is in the house number N, counted from 0, or at its wall

then the numbers of the houses that are seen from some place (seen:), and per leg of the path, of the whole town,

  leg: N all some none      the areas from where all of the leg is seen, some of it, and nothing, insides of houses too
  leg: N crosses a wall     where it does

  --input FILE         read the numbers from FILE
  --step S             look from places so far apart on the path, too (S over 0; at most 100000 places)
  --legs on|off        whether legs are looked at as a whole: exact, for towns of some dozens of walls (on; off from 200
                       walls on)
  --list               print the polygons instead: per corner its view's number, x y, and what is seen from there to the
                       next corner: a house's number, `border`, or `-` along a line of sight
  -o OUT               draw the town, what is seen bright: .png, .ppm or .svg
  --size WxH           pixels of the picture (640x480)
)";

using place = irg::point<double, 2>;
using ring = std::vector<place>;
using wall = irg::segment<double, 2>;

struct settings : program::drawing_options {
  double step = 0;
  enum class choice { by_walls, on, off } legs = choice::by_walls;
};

settings read_settings(program::command_line& line) {
  settings s;
  while (!line.done()) {
    const std::string_view word = line.take();
    if (word == "--step") {
      s.step = line.numbers(word, 1)[0];
      if (!(s.step > 0)) line.fail("option --step needs a number over 0");
    } else if (word == "--legs") {
      s.legs = line.choice(word, {"on", "off"}) == 0 ? settings::choice::on : settings::choice::off;
    } else {
      s.read(line, word);
    }
  }
  s.finish(line);
  return s;
}

struct town {
  irg::box<double, 2> border{};
  std::vector<ring> houses{};
  std::vector<wall> walls{};
  std::vector<std::size_t> house_of{};  // each wall
  std::vector<place> path{};
};

place read_place(program::number_input& in, const std::string& what) {
  const double x = in.number("x of " + what);
  return {x, in.number("y of " + what)};
}

// A place in the town or on its border.
place read_place_in(program::number_input& in, const irg::box<double, 2>& border, const std::string& what) {
  const place p = read_place(in, what);
  if (p.x < border.low.x || border.high.x < p.x || p.y < border.low.y || border.high.y < p.y)
    in.fail_at_word(what + " is not in the town");
  return p;
}

town read_town(const program::command_line& line, const settings& s) {
  using program::number_input;
  number_input::prompt_if_terminal("x0 y0 x1 y1, number of houses, for each n and n times x y, then x y of places: ",
                                   s.input);
  number_input in(line, s.input);
  town t;
  t.border.low = read_place(in, "the border's lower left");
  t.border.high = read_place(in, "the border's upper right");
  const double wide = t.border.high.x - t.border.low.x, tall = t.border.high.y - t.border.low.y;
  if (!(wide > 0 && tall > 0)) in.fail_at_word("the town has no area");
  constexpr double least = 1e-150, most = 1e150;  // of sides: areas are numbers
  if (!(wide < most && tall < most && wide > least && tall > least))
    in.fail_at_word("the town's sides are not between 1e-150 and 1e150");
  constexpr int most_corners = 100000;
  int corners = 0;
  for (int count = in.integer("the number of houses", 0, most_corners), h = 0; h < count; ++h) {
    const int n = in.integer("the number of corners", 0, most_corners);
    corners += n;
    if (corners > most_corners) in.fail_at_word("there are more than 100000 corners");
    ring house;
    for (int i = 0; i < n; ++i)
      house.push_back(
          read_place_in(in, t.border, "corner " + std::to_string(i + 1) + " of house " + std::to_string(h)));
    for (std::size_t i = 0; i < house.size(); ++i) {
      t.walls.push_back({house[i], house[(i + 1) % house.size()]});
      t.house_of.push_back(t.houses.size());
    }
    t.houses.push_back(std::move(house));
  }
  do {
    t.path.push_back(read_place_in(in, t.border, "place " + std::to_string(t.path.size() + 1)));
    if (t.path.size() > 100000) in.fail_at_word("there are more than 100000 places");
  } while (!in.at_end());
  return t;
}

// The corners of the path, and places between them that are a step apart.
std::vector<place> places_on(const program::command_line& line, const town& t, double step) {
  constexpr double most = 100000;
  std::vector<place> out{t.path[0]};
  for (std::size_t i = 1; i < t.path.size(); ++i) {
    const place from = t.path[i - 1], to = t.path[i];
    const double length = std::hypot(to.x - from.x, to.y - from.y);
    if (step > 0 && length / step + static_cast<double>(out.size()) > most)
      line.fail("option --step makes more than 100000 places");
    for (double k = 1; step > 0 && k * step < length; ++k) {
      const double part = k * step / length;
      out.push_back({from.x + part * (to.x - from.x), from.y + part * (to.y - from.y)});
    }
    out.push_back(to);
  }
  return out;
}

struct view {
  place from{};
  std::size_t in_house = 0;  // or as many as there are houses
  std::vector<irg::sight_vertex<double>> corners{};
  ring outline() const {
    ring out;
    for (const auto& c : corners) out.push_back(c.at);
    return out;
  }
};

view look(const town& t, const place& from) {
  view v{from};
  for (; v.in_house < t.houses.size(); ++v.in_house)
    if (irg::point_in_polygon(t.houses[v.in_house], from, irg::fill_rule::non_zero) != irg::location::outside) return v;
  v.corners = irg::visibility_polygon(from, t.border, t.walls).ring;
  return v;
}

double area_of(const std::vector<ring>& rings) { return rings.empty() ? 0 : irg::polygon_area(rings); }

struct leg {
  irg::source_regions<double> parts{};
};

std::vector<leg> look_at_legs(const town& t, const settings& s) {
  std::vector<leg> out;
  if (s.legs == settings::choice::off || (s.legs == settings::choice::by_walls && t.walls.size() >= 200)) return out;
  for (std::size_t i = 0; i + 1 < t.path.size(); ++i)
    out.push_back({irg::weak_visibility(wall{t.path[i], t.path[i + 1]}, t.walls, t.border)});
  return out;
}

std::string two(const place& p) { return program::shortest(p.x) + " " + program::shortest(p.y); }

std::string numbers(const town& t, const std::vector<view>& views, const std::vector<leg>& legs) {
  std::string text;
  std::vector<bool> seen(t.houses.size(), false);
  for (const view& v : views) {
    text += "view: " + two(v.from);
    if (v.in_house < t.houses.size()) {
      text += " house " + std::to_string(v.in_house) + "\n";
      continue;
    }
    std::vector<bool> here(t.houses.size(), false);
    for (const auto& c : v.corners)
      if (c.stop == irg::sight_stop::obstacle) seen[t.house_of[c.index]] = here[t.house_of[c.index]] = true;
    std::size_t count = 0;
    for (const bool is_seen : here) count += is_seen;
    text += " " + program::shortest(area_of({v.outline()})) + " " + std::to_string(count) + "\n";
  }
  text += "seen:";
  for (std::size_t h = 0; h < seen.size(); ++h)
    if (seen[h]) text += " " + std::to_string(h);
  text += "\n";
  for (std::size_t i = 0; i < legs.size(); ++i) {
    text += "leg: " + std::to_string(i);
    if (legs[i].parts.status != irg::visibility_status::ok) {
      text += " crosses a wall\n";
      continue;
    }
    for (const auto* part : {&legs[i].parts.all, &legs[i].parts.some, &legs[i].parts.none})
      text += " " + program::shortest(area_of(*part));
    text += "\n";
  }
  return text;
}

std::string list(const town& t, const std::vector<view>& views) {
  std::string text;
  for (std::size_t i = 0; i < views.size(); ++i)
    for (const auto& c : views[i].corners) {
      text += std::to_string(i) + " " + two(c.at);
      text += c.stop == irg::sight_stop::nothing    ? " -"
              : c.stop == irg::sight_stop::boundary ? " border"
                                                    : " " + std::to_string(t.house_of[c.index]);
      text += "\n";
    }
  return text;
}

// The same picture in pixels and in vectors.
class town_painter {
public:
  static constexpr irg::rgba8 dark{86, 92, 104, 255}, half{176, 170, 150, 255}, bright{252, 240, 196, 255},
      house{150, 104, 84, 255}, red{204, 60, 44, 255};
  struct text_sink {
    std::string text{};
    void operator()(std::string_view piece) { text.append(piece); }
  };

  town_painter(const irg::box<double, 2>& border, const program::picture_size& size)
      : low_(border.low), picture(size.width, size.height, {250, 249, 246, 255}),
        svg_(sink, {size.width, size.height}, {250, 249, 246, 255}) {
    const double wide = border.high.x - border.low.x, tall = border.high.y - border.low.y;
    scale_ = 0.95 * std::fmin(size.width / wide, size.height / tall);
    left_ = (size.width - scale_ * wide) / 2;
    bottom_ = (size.height + scale_ * tall) / 2;
  }
  void fill(const std::vector<ring>& rings, irg::rgba8 colour) {
    std::vector<ring> placed;
    for (const ring& r : rings) {
      placed.emplace_back();
      for (const place& p : r) placed.back().push_back(at(p));
    }
    irg::fill_polygon_aa(picture, placed, irg::fill_rule::non_zero, colour);
    svg_.add_region(placed, colour);
  }
  void mark(const place& p) {
    const place c = at(p);
    ring square;
    for (const place& d : {place{-3, 0}, place{0, -3}, place{3, 0}, place{0, 3}})
      square.push_back({c.x + d.x, c.y + d.y});
    irg::fill_polygon_aa(picture, square, irg::fill_rule::non_zero, red);
    svg_.add_region(std::vector<ring>{square}, red);
  }
  std::string finish() {
    svg_.finish();
    return std::move(sink.text);
  }

private:
  place at(const place& p) const { return {left_ + scale_ * (p.x - low_.x), bottom_ - scale_ * (p.y - low_.y)}; }

  place low_;
  double scale_ = 1, left_ = 0, bottom_ = 0;

public:
  irg::image<irg::rgba8> picture;
  text_sink sink{};

private:
  irg::svg_drawing<text_sink> svg_;
};

void draw(const program::command_line& line, const settings& s, const town& t, const std::vector<view>& views,
          const std::vector<leg>& legs) {
  town_painter painter(t.border, s.size);
  const place &low = t.border.low, &high = t.border.high;
  painter.fill({{low, {high.x, low.y}, high, {low.x, high.y}}}, town_painter::dark);
  for (const leg& l : legs) painter.fill(l.parts.some, town_painter::half);
  for (const leg& l : legs) painter.fill(l.parts.all, town_painter::half);
  for (const view& v : views) painter.fill({v.outline()}, town_painter::bright);
  painter.fill(t.houses, town_painter::house);
  for (const view& v : views) painter.mark(v.from);
  if (irg::image_format_of_name(s.out) != irg::image_format::svg)
    program::write_picture(line, s.out, painter.picture);
  else if (const auto saved = irg::save_file(s.out, painter.finish()); !saved)
    line.fail(std::string(saved.error().message) + ": " + s.out);
}

void run(program::command_line& line) {
  const settings s = read_settings(line);
  const town t = read_town(line, s);
  std::vector<view> views;
  for (const place& p : places_on(line, t, s.step)) views.push_back(look(t, p));
  const std::vector<leg> legs = s.list && s.out.empty() ? std::vector<leg>{} : look_at_legs(t, s);
  const std::string text = s.list ? list(t, views) : numbers(t, views, legs);
  if (!s.out.empty()) draw(line, s, t, views, legs);
  std::fwrite(text.data(), 1, text.size(), stdout);
  program::finish_output(line, s.out);
}

}  // namespace

int main(int argc, char** argv) {
  program::run_or_fail(program::command_line(argc, argv, "street_view_2d", help), "the town", run);
}
