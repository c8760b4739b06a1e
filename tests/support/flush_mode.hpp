// SPDX-License-Identifier: MIT
// The processor's mode in which subnormal numbers count as zero, for as long as an object lives; nothing where there is
// no such mode.
#pragma once

namespace test {

class flushing_subnormals {
public:
#if defined(__SSE2__) && defined(__GNUC__)
  flushing_subnormals() : mode_(__builtin_ia32_stmxcsr()) {
    __builtin_ia32_ldmxcsr(mode_ | 0x8040);
    asm volatile("" : : : "memory");
  }
  ~flushing_subnormals() {
    asm volatile("" : : : "memory");
    __builtin_ia32_ldmxcsr(mode_);
  }

private:
  unsigned mode_;
#else
  flushing_subnormals() {}
#endif
  flushing_subnormals(const flushing_subnormals&) = delete;
  flushing_subnormals& operator=(const flushing_subnormals&) = delete;
};

/// f(), called in that mode.
template <class F>
[[gnu::noinline]] auto while_flushing(const F& f) {
  const flushing_subnormals mode;
  return f();
}

}  // namespace test
