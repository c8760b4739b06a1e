// SPDX-License-Identifier: MIT
// A contest: everybody draws the same items on the same canvas; time, errors and limits come out in one table, and as
// rows of results.csv.
#pragma once

#include <algorithm>
#include <cstdio>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <irg/io/image_file.hpp>

#include "raster/canvas.hpp"
#include "support/measure.hpp"

namespace bench {

/// How far a contender's pixels are from the exact ones, over a sample of the items.
struct errors {
  double max = 0, mean = 0;
  std::int64_t wrong = 0;
  std::string note{};
};

/// What has to be so for the benchmark to end well.
enum class promise { none, nothing_wrong };

/// One contender. A limit writes to memory what a perfect algorithm would have to, and is not judged.
struct drawer {
  std::string name;  // as in results.csv
  std::function<void(int first, int last)> draw;  // draws the items [first, last)
  bool same_work = true;
  std::string note{};
  promise promised = promise::none;

  bool is_limit() const { return name.starts_with("limit:"); }
};

/// One line of the tables.
struct contest {
  std::string kernel, test_case, item;
  int items = 0;
  std::int64_t cells = 0;  // of all items together, for the time per cell
  const bench::canvas* on = nullptr;
  std::vector<drawer> drawers{};
  std::string limit{};  // the contender that the limit fraction refers to
  std::function<errors(const drawer&)> judge{};
  std::string error_unit{};
};

/// As many bytes in one piece.
inline drawer limit_memset(const canvas& c, std::int64_t pixels) {
  return {"limit:memset", [&c, pixels](int, int) {
            for (std::int64_t left = pixels * 4; left > 0; left -= static_cast<std::int64_t>(c.bytes())) {
              std::memset(c.pixels(), 255, std::min(static_cast<std::size_t>(left), c.bytes()));
              asm volatile("" : : "r"(c.pixels()) : "memory");
            }
          }};
}

/// Whether a case is to be held: IRG_BENCH_CASE names a part of the names of those that are, all without it.
inline bool wanted(const std::string& test_case) {
  const char* part = std::getenv("IRG_BENCH_CASE");
  return !part || test_case.find(part) != std::string::npos;
}

/// "plain x86-64" is what a compiler makes of irg when nobody names a processor.
inline std::string build_suffix() {
#if defined(__x86_64__) && !defined(__SSE3__)
  return " (plain x86-64)";
#else
  return "";
#endif
}

// IRG_BENCH_PICTURES names a folder that gets a picture of what each contender draws.
inline void save_picture(const contest& c, const drawer& d) {
  const char* folder = std::getenv("IRG_BENCH_PICTURES");
  if (!folder) return;
  std::string name = c.kernel + "-" + c.test_case + "-" + d.name;
  for (char& letter : name)
    if (letter == ' ' || letter == ':' || letter == '/' || letter == '%') letter = '_';
  irg::image<irg::rgb8> picture(c.on->width(), c.on->height());
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x) {
      const irg::rgba8 p = c.on->view()(x, y);
      picture(x, y) = {p.r, p.g, p.b};
    }
  const std::string path = std::string(folder) + "/" + name + ".png";
  if (const auto error = irg::write_image(path, picture)) std::printf("%s: %s\n", error->message, path.c_str());
}

// Draws all items on an empty canvas: how many pixels are set, and a sum over their values.
struct drawn {
  std::int64_t pixels = 0;
  std::uint32_t checksum = 2166136261u;
};

inline drawn draw_all(const contest& c, const drawer& d) {
  c.on->clear();
  d.draw(0, c.items);
  drawn all;
  for (std::size_t i = 0; i < c.on->pixel_count(); ++i) {
    const std::uint32_t p = c.on->pixels()[i] & 0x00ffffff;
    all.pixels += p != 0;
    all.checksum = (all.checksum ^ p) * 16777619u;
  }
  save_picture(c, d);
  c.on->clear();
  return all;
}

/// Holds the contest. Gives how many promises were broken.
inline int hold(const contest& c) {
  std::vector<contender> racers;
  for (const drawer& d : c.drawers) racers.push_back({d.name, [&d, &c] { d.draw(0, c.items); }});
  race(racers, 7, 3e-3, warming::one_run);

  double limit = 0;
  for (const contender& r : racers)
    if (r.name == c.limit) limit = r.median();
  const std::string test_case = c.test_case + build_suffix();
  const double cells_each = static_cast<double>(c.cells) / c.items;
  std::printf("\n%s / %s: %d times, %.1f cells each; errors in %s\n", c.kernel.c_str(), test_case.c_str(), c.items,
              cells_each, c.error_unit.c_str());
  std::printf("  %-26s %10s %8s %7s %9s %9s %7s %9s %8s\n", "", ("ns/" + c.item).c_str(), "ns/cell", "x limit",
              "max error", "mean err.", "wrong", "pixels", "checksum");
  int broken = 0;
  std::optional<drawn> promised;  // all that promise exactness draw the same picture
  for (std::size_t i = 0; i < racers.size(); ++i) {
    const drawer& d = c.drawers[i];
    const double ns = racers[i].median() * 1e9 / c.items;
    row r{.kernel = c.kernel, .test_case = test_case, .implementation = d.name};
    r.same_work = d.same_work ? "yes" : "no";
    r.ns_per_item = ns;
    r.items = c.items;
    r.item = c.item;
    r.note = d.note;
    std::printf("  %-26s %10.4g", d.name.c_str(), ns);
    if (c.cells > 0)
      std::printf(" %8.3g", ns / cells_each);
    else
      std::printf(" %8s", "-");
    if (limit > 0) {
      r.limit_fraction = number(limit / racers[i].median());
      std::printf(" %7.2f", racers[i].median() / limit);
    } else {
      std::printf(" %7s", "-");
    }
    if (!d.is_limit()) {
      const drawn all = draw_all(c, d);
      const errors e = c.judge(d);
      r.max_error = number(e.max);
      r.mean_error = number(e.mean);
      r.error_unit = c.error_unit;
      r.wrong = std::to_string(e.wrong);
      if (!e.note.empty()) r.note += (r.note.empty() ? "" : "; ") + e.note;
      std::printf(" %9.3g %9.3g %7lld %9lld %08x", e.max, e.mean, static_cast<long long>(e.wrong),
                  static_cast<long long>(all.pixels), all.checksum);
      if (d.promised == promise::nothing_wrong) {
        if (!promised) promised = all;
        if (e.wrong != 0 || all.checksum != promised->checksum) {
          ++broken;
          std::printf("  BROKEN PROMISE: %s", e.wrong ? "nothing may be wrong" : "the pictures differ");
        }
      }
    }
    std::printf("%s%s\n", r.note.empty() ? "" : "  ", r.note.c_str());
    report(r);
  }
  std::fflush(stdout);
  return broken;
}

/// The exit status of a program whose contests broke so many promises.
inline int exit_status(int broken) {
  if (broken) std::printf("%d promises broken\n", broken);
  return broken != 0;
}

}  // namespace bench
