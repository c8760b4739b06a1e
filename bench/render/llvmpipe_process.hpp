// SPDX-License-Identifier: MIT
// llvmpipe in a process of its own: the number of its threads is read once per process. The child is forked with the
// scene in its memory and draws when it is told to; pictures come back in shared memory.
#pragma once

#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstring>
#include <string>
#include <vector>

#include "render/clocks.hpp"
#include "render/scenes.hpp"
#include "support/llvmpipe.hpp"

namespace bench {

/// What llvmpipe is to do.
enum class peer_task : char { draw, draw_depth, clear, show_picture, show_depth, show_ids, stop };

class llvmpipe_process {
public:
  /// threads = 1 draws on the calling thread. The scene has to stay.
  llvmpipe_process(const scene& s, int threads) : pixels_(s.pixel_count()) {
    shared_ = mmap(nullptr, bytes(), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    int ends[2];
    if (shared_ == MAP_FAILED || socketpair(AF_UNIX, SOCK_STREAM, 0, ends) != 0) return;
    std::fflush(nullptr);
    child_ = fork();
    if (child_ == 0) {
      close(ends[0]);
      serve(s, threads, ends[1]);
      _exit(0);
    }
    close(ends[1]);
    socket_ = ends[0];
    reply hello{};
    ok_ = child_ > 0 && receive(socket_, hello) && hello.ok;
    renderer_ = ok_ ? hello.renderer : "";
  }
  ~llvmpipe_process() {
    // Closing the socket would not end it: processes that were forked later hold it, too.
    if (socket_ >= 0) (void)!write(socket_, &stop, 1), close(socket_);
    if (child_ > 0) waitpid(child_, nullptr, 0);
    if (shared_ != MAP_FAILED) munmap(shared_, bytes());
  }
  llvmpipe_process(const llvmpipe_process&) = delete;
  llvmpipe_process& operator=(const llvmpipe_process&) = delete;

  bool ok() const { return ok_; }
  const std::string& renderer() const { return renderer_; }

  /// Does it, and returns how long it took.
  elapsed operator()(peer_task task) {
    reply r{};
    ok_ = ok_ && write(socket_, &task, 1) == 1 && receive(socket_, r);
    return r.time;
  }
  /// After show_picture or show_ids; ids are the triangles' numbers plus 1, in the bytes r, g and b.
  const irg::rgba8* picture() const { return static_cast<const irg::rgba8*>(shared_); }
  /// After show_depth.
  const float* depth() const { return static_cast<const float*>(shared_); }

private:
  struct reply {
    bool ok = false;
    elapsed time{};
    char renderer[128] = "";
  };
  template <class T>
  static bool receive(int from, T& value) {
    std::size_t got = 0;
    while (got < sizeof value) {
      const ssize_t n = read(from, reinterpret_cast<char*>(&value) + got, sizeof value - got);
      if (n <= 0) return false;
      got += static_cast<std::size_t>(n);
    }
    return true;
  }
  std::size_t bytes() const { return 4 * pixels_; }
  static constexpr peer_task stop = peer_task::stop;

  // Every triangle with vertices of its own that have its number for a colour.
  static void load_ids(llvmpipe& peer, const scene& s) {
    std::vector<irg::point<float, 3>> positions;
    std::vector<irg::rgb<float>> colours;
    std::vector<irg::triangle_indices> triangles;
    for (std::uint32_t i = 0; i < s.triangles.size(); ++i) {
      const auto byte = [number = i + 1](unsigned shift) { return static_cast<float>(number >> shift & 255u) / 255; };
      for (const std::uint32_t v : s.triangles[i].v) {
        positions.push_back(s.positions[v]);
        colours.push_back({byte(0), byte(8), byte(16)});
      }
      triangles.push_back({{3 * i, 3 * i + 1, 3 * i + 2}});
    }
    peer.load(positions, colours, triangles, s.to_clip);
  }

  void serve(const scene& s, int threads, int socket) {
    if (threads > 1) use_all_processors();
    llvmpipe peer(s.width, s.height, threads > 1 ? threads : 0);
    reply r{.ok = peer.ok()};
    if (r.ok) {
      std::strncpy(r.renderer, peer.renderer().c_str(), sizeof r.renderer - 1);
      peer.load(s.positions, s.colours, s.triangles, s.to_clip);
    }
    const bool cull = s.culling == irg::face_culling::back;
    for (peer_task task{}; write(socket, &r, sizeof r) == sizeof r && r.ok && read(socket, &task, 1) == 1;) {
      const clocks started;
      switch (task) {
        case peer_task::draw: peer.draw(cull, {}); break;
        case peer_task::draw_depth: peer.draw_depth(cull); break;
        case peer_task::clear: peer.clear({}); break;
        case peer_task::stop: return;
        case peer_task::show_picture: peer.draw(cull, {}); break;
        case peer_task::show_depth: peer.draw_depth(cull); break;
        case peer_task::show_ids:
          load_ids(peer, s);
          peer.draw(cull, {});
          peer.load(s.positions, s.colours, s.triangles, s.to_clip);
          break;
      }
      r.time = started.since();
      if (task == peer_task::show_depth) peer.read_depth(static_cast<float*>(shared_));
      if (task == peer_task::show_picture || task == peer_task::show_ids)
        std::memcpy(shared_, peer.picture().data(), bytes());
    }
  }

  std::size_t pixels_;
  void* shared_ = MAP_FAILED;
  int socket_ = -1;
  pid_t child_ = -1;
  bool ok_ = false;
  std::string renderer_;
};

}  // namespace bench
