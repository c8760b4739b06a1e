// SPDX-License-Identifier: MIT
// Contenders that draw whole frames and time themselves: on one processor by its time, on several by the wall's.
#pragma once

#include <cstdio>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <irg/core/threads.hpp>
#include <irg/io/image_file.hpp>

#include "render/clocks.hpp"
#include "render/irg_draw.hpp"
#include "render/limits.hpp"
#include "render/oracle.hpp"
#ifdef IRG_HAVE_OSMESA
#include "render/llvmpipe_process.hpp"
#endif

namespace bench {

/// One contender. What it draws is judged after the race, unless it is a limit.
struct frame_contender {
  std::string name;  // as in results.csv
  int threads = 1;
  std::function<elapsed()> draw{};
  std::function<verdict()> judge{};
  std::string note{};
  std::vector<double> seconds{};
  double allowed = 0;  // how large its error may be, if that is not what the contest says

  double percentile(double p) const {
    std::vector<double> sorted = seconds;
    std::sort(sorted.begin(), sorted.end());
    return sorted[static_cast<std::size_t>(p * static_cast<double>(sorted.size() - 1))];
  }
  double median() const { return percentile(0.5); }
};

/// A contender that is a call within this process. One thread stays on its processor.
inline std::function<elapsed()> timed(int threads, std::function<void()> call) {
  return [threads, call = std::move(call)] {
    if (threads > 1)
      use_all_processors();
    else
      stay_on_this_processor();
    const clocks started;
    call();
    return started.since();
  };
}

/// Says what was going on while it was measured.
inline void print_conditions() {
  std::printf(
      "On average %.2f programs wanted to run during the last minute. One thread: processor time; several: the "
      "wall's.\n",
      load());
}

/// How often everything is drawn; IRG_BENCH_ROUNDS says otherwise.
inline int frame_rounds() {
  if (smoke()) return 1;
  const char* rounds = std::getenv("IRG_BENCH_ROUNDS");
  return rounds ? std::max(1, std::atoi(rounds)) : 11;
}

/// Draws everything in turn, again and again.
inline void race(std::vector<frame_contender>& contenders, int rounds) {
  for (int round = smoke() ? 0 : -1; round < rounds; ++round)
    for (frame_contender& c : contenders) {
      const elapsed e = c.draw();
      if (round >= 0) c.seconds.push_back(c.threads > 1 ? e.wall : e.processor);
    }
}

/// What the rows of a scene have in common, and how large irg's error may be.
struct frame_contest {
  std::string kernel, test_case, limit, error_unit;
  double allowed = 0;
};

/// Prints the table of a scene and adds its rows to results.csv: several threads are a case of their own. Gives how
/// many times irg was wrong.
inline int publish(const frame_contest& contest, const std::vector<frame_contender>& contenders) {
  double limit = 0;
  for (const frame_contender& c : contenders)
    if (c.name == contest.limit) limit = c.median();
  std::printf("  %-30s %9s %9s %9s %8s %9s %9s %8s\n", "", "ms", "least", "90 %", "x limit", "max error", "mean err.",
              "wrong");
  int broken = 0;
  for (const frame_contender& c : contenders) {
    row r{.kernel = contest.kernel, .test_case = contest.test_case, .implementation = c.name};
    if (c.threads > 1) r.test_case += " " + std::to_string(c.threads) + " threads";
    r.ns_per_item = c.median() * 1e9;
    r.items = 1;
    r.item = "frame";
    r.note = c.note;
    std::printf("  %-30s %9.3f %9.3f %9.3f",
                (c.name + (c.threads > 1 ? " " + std::to_string(c.threads) + " threads" : "")).c_str(),
                c.median() * 1e3, c.percentile(0) * 1e3, c.percentile(0.9) * 1e3);
    if (limit > 0 && c.threads == 1) {
      r.limit_fraction = number(limit / c.median());
      std::printf(" %8.2f", c.median() / limit);
    } else {
      std::printf(" %8s", "-");
    }
    if (c.judge) {
      const verdict v = c.judge();
      r.max_error = number(v.max);
      r.mean_error = number(v.mean);
      r.error_unit = contest.error_unit;
      r.wrong = std::to_string(v.wrong);
      r.note += (r.note.empty() ? "" : "; ") + std::to_string(v.close) + " px too close to tell";
      std::printf(" %9.3g %9.3g %8lld", v.max, v.mean, static_cast<long long>(v.wrong));
      if (c.name.starts_with("irg") && (v.wrong != 0 || v.max > std::max(c.allowed, contest.allowed))) ++broken;
    }
    std::printf("%s%s\n", r.note.empty() ? "" : "  ", r.note.c_str());
    report(r);
  }
  std::fflush(stdout);
  return broken;
}

/// A scene, what its picture has to be, and irg with the memory that it draws into.
struct stage {
  const scene& what;
  own::renderer renderer;
  std::vector<irg::subpixel> snapped;
  exact_picture exact;
  irg::image<irg::rgba8> picture;
  irg::image<float> depth;
  irg::image<std::uint32_t> ids;
  irg::render_stats stats{};  // of the last frame

  explicit stage(const scene& s)
      : what(s), renderer(s), snapped(renderer.snapped()), exact(find_exact_picture(s, snapped)),
        picture(s.width, s.height), depth(s.width, s.height), ids(s.width, s.height) {}

  void draw(int threads, const irg::skip_options& skip = {}) {
    if (threads == 1)
      stats = renderer.draw(picture, depth, skip);
    else
      stats = renderer.draw(picture, depth, skip, irg::parallel{threads});
  }
  void draw_depth(int threads) {
    if (threads == 1)
      stats = renderer.draw_depth(depth);
    else
      stats = renderer.draw_depth(depth, irg::parallel{threads});
  }

  /// Judges what stands in `picture`. Every way of drawing has to leave the same bytes as the first that was judged.
  verdict judge_own() {
    renderer.draw_ids(ids, depth);
    verdict v = judge(what, snapped, exact, ids.data(), picture.data());
    if (first_.empty()) first_.assign(picture.data(), picture.data() + what.pixel_count());
    for (std::size_t i = 0; i < first_.size(); ++i) v.wrong += !(first_[i] == picture.data()[i]);
    return v;
  }

private:
  std::vector<irg::rgba8> first_{};
};

/// irg drawing whole frames in colour.
inline frame_contender own_contender(stage& on, std::string name, int threads, const irg::skip_options& skip = {}) {
  frame_contender c{std::move(name), threads};
  c.draw = timed(threads, [&on, threads, skip] { on.draw(threads, skip); });
  c.judge = [&on, draw = c.draw] {
    draw();
    return on.judge_own();
  };
  return c;
}

/// What the scene is, and what it was meant to be.
inline void print_statistics(const stage& on) {
  const auto n = static_cast<double>(on.what.triangles.size());
  const double covered = static_cast<double>(on.exact.covered), pixels = static_cast<double>(on.what.pixel_count());
  std::printf("\n%s: %.0f triangles of %.4g px, depth complexity %.3g, %lld px drawn (meant: %s)\n",
              on.what.name.c_str(), n, covered / n, covered / pixels, static_cast<long long>(on.exact.drawn),
              smoke() ? "a smaller scene" : on.what.meant.c_str());
  if (on.exact.not_judged)
    std::printf("  %lld triangles would have to be clipped: nobody is judged by them\n",
                static_cast<long long>(on.exact.not_judged));
}

#ifdef IRG_HAVE_OSMESA
/// llvmpipe as a contender, for as long as `peer` lives.
inline frame_contender llvmpipe_contender(stage& on, llvmpipe_process& peer, int threads, peer_task task) {
  frame_contender c{"llvmpipe", threads, [&peer, task] { return peer(task); }};
  c.judge = [&on, &peer, task] {
    if (task == peer_task::draw_depth) {
      peer(peer_task::show_depth);
      return judge_depth(on.what, on.exact, peer.depth());
    }
    std::vector<std::uint32_t> ids;
    peer(peer_task::show_ids);
    for (std::size_t i = 0; i < on.what.pixel_count(); ++i) {
      const irg::rgba8 p = peer.picture()[i];
      ids.push_back(p.r | static_cast<std::uint32_t>(p.g) << 8 | static_cast<std::uint32_t>(p.b) << 16);
    }
    peer(peer_task::show_picture);
    return judge(on.what, on.snapped, on.exact, ids.data(), peer.picture());
  };
  c.note = "transforms and snaps by itself; 24-bit depth";
  return c;
}
#endif

/// IRG_BENCH_PICTURES names a folder that gets the pictures.
inline void save_picture(const scene& s, const char* who, const irg::rgba8* pixels) {
  const char* folder = std::getenv("IRG_BENCH_PICTURES");
  if (!folder) return;
  std::string name = s.name + "-" + who;
  for (char& letter : name)
    if (letter == ' ' || letter == ':' || letter == '/' || letter == '%' || letter == '\'') letter = '_';
  irg::image<irg::rgb8> picture(s.width, s.height);
  for (int y = 0; y < s.height; ++y)
    for (int x = 0; x < s.width; ++x) {
      const irg::rgba8 p = pixels[std::ptrdiff_t{y} * s.width + x];
      picture(x, y) = {p.r, p.g, p.b};
    }
  const std::string path = std::string(folder) + "/" + name + ".png";
  if (const auto error = irg::write_image(path, picture)) std::printf("%s: %s\n", error->message, path.c_str());
}

}  // namespace bench
