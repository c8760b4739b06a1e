// SPDX-License-Identifier: MIT
// Contenders that draw whole frames and time themselves: on one processor by its time, on several by the wall's.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "render/clocks.hpp"
#include "render/irg_draw.hpp"
#include "render/limits.hpp"
#include "render/oracle.hpp"

namespace bench {

/// One frame by the clock that counts. A single thread stays on its processor.
std::function<double()> timed(int threads, std::function<void()> call);

/// The memory that everybody in this process draws into.
struct frame_memory {
  irg::image<irg::rgba8> picture;
  irg::image<float> depth;
  irg::image<std::uint32_t> ids;

  static frame_memory& of(const scene& s);
};

/// A scene, what its picture has to be, and irg with the memory that it draws into.
struct stage {
  const scene what;
  own::renderer renderer;
  std::vector<irg::subpixel> snapped;
  lazy<exact_picture> exact;
  frame_memory& to;
  irg::render_counts stats{};  // of the last frame

  explicit stage(scene s)
      : what(std::move(s)), renderer(what), snapped(renderer.snapped()),
        exact([this] { return find_exact_picture(what, snapped); }), to(frame_memory::of(what)) {}
  stage(const stage&) = delete;
  stage& operator=(const stage&) = delete;

  void draw(int threads, const irg::skip_options& skip = {}) {
    stats = renderer.draw(to.picture, to.depth, skip, threads);
  }

  /// Judges what stands in the picture. Every way of drawing has to leave the same bytes as the first that was judged.
  verdict judge_own();
  /// What the scene is, and what it was meant to be.
  std::string statistics();

private:
  std::vector<irg::rgba8> first_{};
};

/// The stage of a plan, set up when it is first asked for.
using stage_access = std::function<stage&()>;
stage_access stage_of(const scene_plan& plan);

/// Frames of one scene; several threads are a case of their own, without a limit.
struct frame_contest {
  std::string kernel, scene, limit, error_unit;
  double allowed = 0;  // how large irg's error may be

  void enter(int threads, contender who) const;
  /// Who is judged by a verdict. irg must not have a wrong pixel, nor a larger error than `allowed`.
  void enter_judged(int threads, contender who, std::function<verdict()> judge,
                    std::function<std::string()> note = {}) const;
};

/// irg drawing whole frames in colour. IRG_BENCH_PICTURES names a folder that gets the pictures.
void enter_own(const frame_contest& c, const stage_access& on, const std::string& name, int threads,
               const irg::skip_options& skip = {});

/// A limit of frames on one thread.
void enter_limit(const frame_contest& c, const std::string& name, std::function<void()> call,
                 std::function<std::string()> note = {});

/// What llvmpipe is to draw.
enum class drawn { colours, depths };

/// llvmpipe as a contender, where it was found.
void enter_llvmpipe(const frame_contest& c, const stage_access& on, int threads, drawn what);

}  // namespace bench
