// SPDX-License-Identifier: MIT
// What is measured: contests, each of one kernel on one case, and the contenders that do its work. They become the
// benchmarks kernel/case/contender of Google Benchmark, which runs and times them; errors, limits and promises are ours.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace bench {

/// Whether only to see that everything runs: little work, one round (IRG_BENCH_SMOKE).
bool smoke();

/// Keeps a program of one thread on the processor it runs on, so that it keeps its caches.
void stay_on_this_processor();

inline constexpr double not_said = std::numeric_limits<double>::quiet_NaN();

/// How far a contender's results are from the true ones.
struct errors {
  double max = not_said, mean = not_said, wrong = not_said;
  std::string note{};
  std::string worst_input{};
  std::string broken{};  // the promise that the results break, in words: the program ends with an error
  std::vector<std::pair<std::string, double>> more{};  // counters that only this study has
};

/// One implementation of the same work: irg, irg:<variant>, limit:<name>, or the name of a peer.
struct contender {
  std::string name;
  std::function<void()> run;  // all items once
  std::function<errors()> judge{};  // once, after a run and apart from the time
  std::string note{};
  bool same_work = true;
  std::function<double()> seconds{};  // instead of run: does the work and says how long it took; NaN: cannot run here
};

/// What the contenders have in common. No name has a slash, a comma or a tab.
struct contest {
  std::string kernel, test_case, item;
  std::int64_t items = 1;
  std::string error_unit{};
  std::string limit{};  // the contender whose time the share of the limit refers to
};

/// Makes a benchmark of it. Nothing runs before run_benchmarks: what a contender needs is made when it is first asked.
void enter(const contest& c, contender who);

/// Runs what the switches choose (--benchmark_filter and the others of Google Benchmark); for main to return.
int run_benchmarks(int argc, char** argv);

/// Tells the builds of one program apart: irg as a compiler makes it when nobody names a processor.
inline std::string build_suffix() {
#if defined(__x86_64__) && !defined(__SSE3__)
  return " (plain x86-64)";
#else
  return "";
#endif
}

/// A value that is made when it is first asked for, so that a filtered run starts at once.
template <class T>
class lazy {
public:
  explicit lazy(std::function<T()> make) : make_(std::move(make)) {}
  T& operator*() {
    if (!value_) value_.reset(new T(make_()));
    return *value_;
  }
  T* operator->() { return &**this; }

private:
  std::function<T()> make_;
  std::unique_ptr<T> value_{};
};

/// Keeps what contenders refer to until the program ends.
void keep_alive(std::shared_ptr<void> what);
template <class T>
T& keep(T value) {
  auto kept = std::make_shared<T>(std::move(value));
  keep_alive(kept);
  return *kept;
}
template <class Make>
auto& keep_lazy(Make make) {
  return keep(lazy<decltype(make())>(std::move(make)));
}

}  // namespace bench
