// SPDX-License-Identifier: MIT
#include "render/frames.hpp"

#include <cstdio>
#include <cstdlib>
#include <memory>

#include <irg/io/image_file.hpp>

#ifdef IRG_HAVE_OSMESA
#include "render/llvmpipe_process.hpp"
#endif

namespace bench {

std::function<double()> timed(int threads, std::function<void()> call) {
  return [threads, call = std::move(call)] {
    if (threads > 1)
      use_all_processors();
    else
      stay_on_this_processor();
    const clocks started;
    call();
    const elapsed e = started.since();
    return threads > 1 ? e.wall : e.processor;
  };
}

frame_memory& frame_memory::of(const scene& s) {
  static frame_memory all{irg::image<irg::rgba8>(s.width, s.height), irg::image<float>(s.width, s.height),
                          irg::image<std::uint32_t>(s.width, s.height)};
  return all;
}

verdict stage::judge_own() {
  renderer.draw_ids(to.ids, to.depth);
  verdict v = judge(what, snapped, *exact, to.ids.data(), to.picture.data());
  if (first_.empty()) first_.assign(to.picture.data(), to.picture.data() + what.pixel_count());
  for (std::size_t i = 0; i < first_.size(); ++i) v.wrong += !(first_[i] == to.picture.data()[i]);
  return v;
}

std::string stage::statistics() {
  const auto n = static_cast<double>(what.triangles.size());
  const double covered = static_cast<double>(exact->covered), pixels = static_cast<double>(what.pixel_count());
  char text[300];
  std::snprintf(text, sizeof text, "%.0f triangles of %.4g px; depth complexity %.3g; %lld px drawn (meant: %s)", n,
                covered / n, covered / pixels, static_cast<long long>(exact->drawn),
                smoke() ? "a smaller scene" : what.meant.c_str());
  std::string all = text;
  if (exact->not_judged) all += "; " + std::to_string(exact->not_judged) + " would be clipped and judge nobody";
  return all;
}

stage_access stage_of(const scene_plan& plan) {
  auto& all = keep_lazy([plan] { return std::make_unique<stage>(plan.make()); });
  return [&all]() -> stage& { return **all; };
}

void frame_contest::enter(int threads, contender who) const {
  contest c{kernel, scene, "frame", 1, error_unit, limit};
  if (threads > 1) c.test_case += " " + std::to_string(threads) + " threads", c.limit.clear();
  bench::enter(c, std::move(who));
}

void frame_contest::enter_judged(int threads, contender who, std::function<verdict()> judge,
                                 std::function<std::string()> note) const {
  const bool own = who.name.starts_with("irg");
  who.judge = [judge = std::move(judge), note = std::move(note), own, most = allowed] {
    const verdict v = judge();
    errors e{v.max, v.mean, static_cast<double>(v.wrong)};
    e.note = std::to_string(v.close) + " px too close to tell" + (note ? "; " + note() : "");
    if (own && v.wrong != 0) e.broken = "no pixel may be wrong, nor differ from irg's other ways to draw";
    if (own && v.max > most) e.broken = "the error is larger than " + std::to_string(most);
    return e;
  };
  enter(threads, std::move(who));
}

static void save_picture(const scene& s, const std::string& who, const irg::rgba8* pixels) {
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
  if (const auto saved = irg::save_image(path, picture); !saved)
    std::fprintf(stderr, "%s: %s\n", saved.error().message, path.c_str());
}

void enter_own(const frame_contest& c, const stage_access& on, const std::string& name, int threads,
               const irg::skip_options& skip) {
  contender who{name, {}};
  who.seconds = timed(threads, [on, threads, skip] { on().draw(threads, skip); });
  const auto judge = [on, name, draw = who.seconds] {
    draw();
    save_picture(on().what, name, on().to.picture.data());
    return on().judge_own();
  };
  c.enter_judged(threads, who, judge, [on] { return own::skips_of(on().stats); });
}

void enter_limit(const frame_contest& c, const std::string& name, std::function<void()> call,
                 std::function<std::string()> note) {
  contender who{name, {}};
  who.seconds = timed(1, std::move(call));
  if (note) who.judge = [note] { return errors{not_said, not_said, not_said, note()}; };
  c.enter(1, std::move(who));
}

#ifdef IRG_HAVE_OSMESA
void enter_llvmpipe(const frame_contest& c, const stage_access& on, int threads, drawn what) {
  auto& process = keep_lazy([on, threads] { return std::make_unique<llvmpipe_process>(on().what, threads); });
  const auto seconds = [&process, threads](peer_task task) {
    llvmpipe_process& peer = **process;
    const elapsed e = peer(task);
    return !peer.ok() ? not_said : threads > 1 ? e.wall : e.processor;
  };
  contender who{"llvmpipe", {}};
  who.note = "transforms and snaps by itself; 24-bit depth";
  who.seconds = [seconds, what] { return seconds(what == drawn::depths ? peer_task::draw_depth : peer_task::draw); };
  c.enter_judged(threads, who, [on, &process, what] {
    llvmpipe_process& peer = **process;
    if (what == drawn::depths) {
      peer(peer_task::show_depth);
      return judge_depth(on().what, *on().exact, peer.depth());
    }
    std::vector<std::uint32_t> ids;
    peer(peer_task::show_ids);
    for (std::size_t i = 0; i < on().what.pixel_count(); ++i) {
      const irg::rgba8 p = peer.picture()[i];
      ids.push_back(p.r | static_cast<std::uint32_t>(p.g) << 8 | static_cast<std::uint32_t>(p.b) << 16);
    }
    peer(peer_task::show_picture);
    save_picture(on().what, "llvmpipe", peer.picture());
    return judge(on().what, on().snapped, *on().exact, ids.data(), peer.picture());
  });
  if (threads > 1 || what == drawn::depths) return;
  contender clear{"limit:llvmpipe clear", {}};
  clear.note = "part of llvmpipe's time: clear and copy out";
  clear.seconds = [seconds] { return seconds(peer_task::clear); };
  c.enter(1, std::move(clear));
}
#else
void enter_llvmpipe(const frame_contest&, const stage_access&, int, drawn) {}
#endif

}  // namespace bench
