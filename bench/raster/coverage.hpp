// SPDX-License-Identifier: MIT
// The exact area of pixels under a shape, and how far a contender's antialiased pixels are from it.
#pragma once

#include <cmath>
#include <memory>
#include <vector>

#include "raster/lines.hpp"
#include "raster/polygons.hpp"

namespace bench {

struct corner {
  long double x, y;
};
using outline = std::vector<corner>;

/// The areas of the pixels of a window, row after row, each 0 to 1.
struct areas {
  irg::cell_window window;
  std::vector<float> of{};
};

/// The part of a convex outline where (axis == 0 ? x : y) is on one side of a limit.
enum class side { below, above };

inline outline cut(const outline& shape, int axis, long double limit, side keep) {
  const auto inside_by = [&](const corner& p) {
    const long double v = (axis == 0 ? p.x : p.y) - limit;
    return keep == side::above ? v : -v;
  };
  outline out;
  for (std::size_t i = 0; i < shape.size(); ++i) {
    const corner &a = shape[i], &b = shape[i + 1 == shape.size() ? 0 : i + 1];
    const long double ea = inside_by(a), eb = inside_by(b);
    if (ea >= 0) out.push_back(a);
    if ((ea > 0 && eb < 0) || (ea < 0 && eb > 0)) {
      const long double t = ea / (ea - eb);
      out.push_back({a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t});
    }
  }
  return out;
}

inline long double area(const outline& shape) {
  long double twice = 0;
  for (std::size_t i = 1; i + 1 < shape.size(); ++i)
    twice += (shape[i].x - shape[0].x) * (shape[i + 1].y - shape[0].y) -
             (shape[i + 1].x - shape[0].x) * (shape[i].y - shape[0].y);
  return std::abs(twice) / 2;
}

/// Cuts the outline into rows and the rows into pixels.
inline areas exact_areas(const outline& convex, const irg::cell_window& w) {
  areas all{w};
  if (w.empty()) return all;
  all.of.assign(static_cast<std::size_t>(w.x_last - w.x_first) * static_cast<std::size_t>(w.y_last - w.y_first), 0);
  for (int y = w.y_first; y < w.y_last; ++y) {
    outline rest = cut(cut(convex, 1, y, side::above), 1, y + 1, side::below);
    if (rest.size() < 3) continue;
    float* row = all.of.data() + static_cast<std::ptrdiff_t>(y - w.y_first) * (w.x_last - w.x_first);
    long double left = rest[0].x, right = rest[0].x;
    for (const corner& p : rest) {
      left = std::min(left, p.x);
      right = std::max(right, p.x);
    }
    const int first = std::max(w.x_first, static_cast<int>(std::floor(left)));
    const int last = std::min(w.x_last, static_cast<int>(std::ceil(right)));
    rest = cut(rest, 0, first, side::above);
    for (int x = first; x < last && rest.size() >= 3; ++x) {
      row[x - w.x_first] = static_cast<float>(area(cut(rest, 0, x + 1, side::below)));
      rest = cut(rest, 0, x + 1, side::above);
    }
  }
  return all;
}

/// The same for a ring that may cross itself, by the even-odd rule: the mean over 512 lines in each row.
inline areas sampled_areas(std::span<const irg::subpixel> ring, const irg::cell_window& w) {
  constexpr int lines = 512;
  areas all{w};
  if (w.empty()) return all;
  const int width = w.x_last - w.x_first;
  all.of.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(w.y_last - w.y_first), 0);
  std::vector<double> crossings;
  for (int k = 0; k < (w.y_last - w.y_first) * lines; ++k) {
    const double y = w.y_first + (k + 0.5) / lines;
    crossings.clear();
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const irg::subpixel &a = ring[i], &b = ring[(i + 1) % ring.size()];
      if ((a.y / 256.0 <= y) == (b.y / 256.0 <= y)) continue;
      crossings.push_back((a.x + (y * 256 - a.y) * (b.x - a.x) / (b.y - a.y)) / 256 - w.x_first);
    }
    std::sort(crossings.begin(), crossings.end());
    float* row = all.of.data() + static_cast<std::ptrdiff_t>(k / lines) * width;
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
      const double first = std::clamp(crossings[i], 0.0, double(width)),
                   last = std::clamp(crossings[i + 1], 0.0, double(width));
      for (int x = static_cast<int>(first); x < last; ++x)
        row[x] += static_cast<float>((std::min(last, x + 1.0) - std::max(first, double(x))) / lines);
    }
  }
  return all;
}

inline std::vector<areas> exact_areas(const canvas& c, const polygon_set& set, int sample) {
  std::vector<areas> all;
  for (int k = 0; k < sample; ++k) {
    const irg::cell_window w = surroundings(c, set, k, 4);
    if (set.rule() == irg::fill_rule::even_odd) {
      all.push_back(sampled_areas(set.ring(k), w));
      continue;
    }
    outline shape;
    for (const irg::subpixel& v : set.ring(k)) shape.push_back({v.x / 256.0L, v.y / 256.0L});
    all.push_back(exact_areas(shape, w));
  }
  return all;
}

/// Lines one pixel wide from centre to centre, with square ends at the centres.
inline std::vector<areas> exact_areas(const canvas& c, const std::vector<segment>& lines, int sample) {
  std::vector<areas> all;
  for (int k = 0; k < sample; ++k) {
    const auto [a, b] = lines[static_cast<std::size_t>(k)];
    const long double dx = b.x - a.x, dy = b.y - a.y, length = std::sqrt(dx * dx + dy * dy);
    const long double u = -dy / length / 2, v = dx / length / 2;
    const outline shape{{a.x + 0.5L + u, a.y + 0.5L + v},
                        {b.x + 0.5L + u, b.y + 0.5L + v},
                        {b.x + 0.5L - u, b.y + 0.5L - v},
                        {a.x + 0.5L - u, a.y + 0.5L - v}};
    all.push_back(exact_areas(
        length > 0 ? shape : outline{},
        irg::intersect({std::min(a.x, b.x) - 4, std::min(a.y, b.y) - 4, std::max(a.x, b.x) + 5, std::max(a.y, b.y) + 5},
                       {0, 0, c.width(), c.height()})));
  }
  return all;
}

/// White was mixed into black, so a pixel's value is 255 times its coverage. Error: the difference from the exact area,
/// in 1/256 of a pixel, over all pixels that are touched by the shape or drawn. Wrong: differences of more than 1.
inline errors judge_coverage(const canvas& c, const std::vector<areas>& due, const drawer& d) {
  errors e{0, 0, 0};
  double sum = 0;
  std::int64_t pixels = 0;
  for (std::size_t k = 0; k < due.size(); ++k) {
    const irg::cell_window& w = due[k].window;
    if (w.empty()) continue;
    d.draw(static_cast<int>(k), static_cast<int>(k) + 1);
    std::size_t i = 0;
    for (int y = w.y_first; y < w.y_last; ++y)
      for (int x = w.x_first; x < w.x_last; ++x, ++i) {
        const std::uint32_t value = (c.at(x, y) >> 8) & 255;
        c.at(x, y) = 0;
        const double exact = static_cast<double>(due[k].of[i]) * 256;
        if (value == 0 && exact == 0) continue;
        const double error = std::abs(value * 256 / 255.0 - exact);
        ++pixels;
        sum += error;
        e.max = std::max(e.max, error);
        e.wrong += error > 1;
      }
  }
  e.mean = pixels ? sum / static_cast<double>(pixels) : 0;
  e.note = std::to_string(pixels) + " pixels judged";
  return e;
}

/// Mixes white in, `blocks` blocks of 8 pixels; coverage has a byte for each channel.
inline void mix_blocks(std::uint32_t* pixels, const std::uint8_t* coverage, std::size_t blocks) {
  auto* bytes = reinterpret_cast<std::uint8_t*>(pixels);
  for (std::size_t k = 0; k < blocks; ++k, bytes += 32, coverage += 32)
    for (int i = 0; i < 32; ++i) {
      const auto rest = static_cast<std::uint16_t>(255 - coverage[i]);
      const auto u = static_cast<std::uint16_t>(bytes[i] * rest + 255 * coverage[i] + 128);
      bytes[i] = static_cast<std::uint8_t>(static_cast<std::uint16_t>(u + (u >> 8)) >> 8);
    }
}

/// The coverages known beforehand, spread over the channels and filled up with zeros to blocks of 8 pixels, mixed into
/// the canvas; memory is fetched ahead of time. trace(k, sink) gives the spans of item k.
template <class Trace>
drawer limit_coverage_replay(const canvas& c, int items, Trace trace) {
  struct run {
    std::uint32_t offset = 0, count = 1;  // count: pixels where all are covered whole, else blocks
    bool full = true;
  };
  struct record {
    std::vector<run> runs{};
    std::vector<std::uint8_t> coverage{};
    std::vector<std::size_t> ends{0}, coverage_starts{0};
  };
  auto& all = keep_lazy([&c, items, trace] {
    record r;
    for (int k = 0; k < items; ++k) {
      trace(k, [&](irg::coverage_span s) {
        while (s.coverage && s.x_first < s.x_last && s.coverage[0] == 0) ++s.x_first, ++s.coverage;
        while (s.coverage && s.x_first < s.x_last && s.coverage[s.x_last - s.x_first - 1] == 0) --s.x_last;
        if (s.x_first >= s.x_last) return;
        const auto count = static_cast<std::uint32_t>(s.x_last - s.x_first), blocks = (count + 7) / 8;
        r.runs.push_back(
            {static_cast<std::uint32_t>(s.y * c.width() + s.x_first), s.coverage ? blocks : count, !s.coverage});
        if (!s.coverage) return;
        for (std::uint32_t i = 0; i < 32 * blocks; ++i) r.coverage.push_back(i / 4 < count ? s.coverage[i / 4] : 0);
      });
      r.ends.push_back(r.runs.size());
      r.coverage_starts.push_back(r.coverage.size());
    }
    r.runs.resize(r.runs.size() + runs_ahead);
    return r;
  });
  return {"limit:coverage replay", [&all, pixels = c.pixels()](int first, int last) {
            const std::size_t end = all->ends[static_cast<std::size_t>(last)];
            const std::uint8_t* coverage = all->coverage.data() + all->coverage_starts[static_cast<std::size_t>(first)];
            for (std::size_t i = all->ends[static_cast<std::size_t>(first)]; i < end; ++i) {
              const run &r = all->runs[i], &next = all->runs[i + runs_ahead];
              __builtin_prefetch(pixels + next.offset, 1);
              __builtin_prefetch(pixels + next.offset + (next.full ? next.count - 1 : 8 * next.count - 1), 1);
              if (r.full) {
                std::fill_n(pixels + r.offset, r.count, white);
                continue;
              }
              mix_blocks(pixels + r.offset, coverage, r.count);
              coverage += std::size_t{32} * r.count;
            }
          }};
}

}  // namespace bench
