// SPDX-License-Identifier: MIT
// Vectors and matrices of several libraries at the same work, in the same loops: a library enters with its types and
// operations, each kernel runs over arrays of 256 that stay in the first cache, and transformations over longer ones.
#pragma once

#include <array>
#include <cstddef>
#include <cstdlib>
#include <functional>
#include <memory>
#include <string>
#include <type_traits>
#include <vector>

namespace bench {

/// Arrays that begin at a cache line, so that nobody is measured by where the heap put them.
template <class T>
struct line_allocator {
  using value_type = T;
  line_allocator() = default;
  template <class U>
  line_allocator(const line_allocator<U>&) {}
  T* allocate(std::size_t n) { return static_cast<T*>(std::aligned_alloc(64, (n * sizeof(T) + 127) / 64 * 64)); }
  void deallocate(T* p, std::size_t) { std::free(p); }
  bool operator==(const line_allocator&) const { return true; }
};
template <class T>
using line_vector = std::vector<T, line_allocator<T>>;

/// What everybody computes with; matrices row by row, far from singular, their last row 0 0 0 1 in `affine`.
template <class T>
struct vec_mat_input {
  std::vector<std::array<T, 3>> a, b, points_4096, points_million;
  std::vector<std::array<T, 4>> v;
  std::vector<std::array<T, 16>> m, n;
  std::array<T, 16> affine{};
};

/// One implementation of one kernel.
struct vec_mat_entry {
  std::string kernel, name;
  std::size_t items;
  std::function<void()> run;
  std::function<std::vector<double>()> results;  // of the last run, one behind the other
  bool same_work = true;
};
using vec_mat_entries = std::vector<vec_mat_entry>;

/// Nothing that was written before this may be left out.
inline void clobber() { asm volatile("" ::: "memory"); }

/// The results that `out` holds when the run is over; get(out[i], k) is its number k.
template <class Out, class Get>
std::vector<double> numbers_of(const Out& out, int count, Get get) {
  std::vector<double> all;
  for (const auto& o : out)
    for (int k = 0; k < count; ++k) all.push_back(static_cast<double>(get(o, k)));
  return all;
}

/// What the compiler may make of a loop over items: whatever it can, or nothing that works on several at once.
enum class loop { as_compiled, one_at_a_time };

/// A kernel with one result of `count` numbers per item: out[i] = operation(i).
template <class R, loop Kind = loop::as_compiled, class Operation, class Get>
void enter(vec_mat_entries& to, const std::string& kernel, const std::string& name, std::size_t items, int count,
           Operation operation, Get get) {
  auto out = std::make_shared<line_vector<R>>(items);
  to.push_back({kernel, name, items,
                [=] {
                  R* const to_here = out->data();
                  for (std::size_t i = 0; i < items; ++i) {
                    if constexpr (Kind == loop::one_at_a_time) asm("" : "+r"(i));
                    to_here[i] = operation(i);
                  }
                  clobber();
                },
                [=] { return numbers_of(*out, count, get); }});
}

/// The same, all items at once: operation(out).
template <class R, class Operation, class Get>
void enter_batch(vec_mat_entries& to, const std::string& kernel, const std::string& name, std::size_t items, int count,
                 Operation operation, Get get) {
  auto out = std::make_shared<line_vector<R>>(items);
  to.push_back({kernel, name, items,
                [=] {
                  operation(*out);
                  clobber();
                },
                [=] { return numbers_of(*out, count, get); }});
}

template <class To, class From, class Make>
std::shared_ptr<const line_vector<To>> converted(const From& from, Make make) {
  auto all = std::make_shared<line_vector<To>>();
  all->reserve(from.size());
  for (const auto& f : from) all->push_back(make(f));
  return all;
}

/// Enters a library in all kernels. Lib<T> has the types v3, v4, m4; make3, make4, make16 (from arrays), get3, get4,
/// get16; and dot, cross, length, normalize, multiply, apply (matrix and vector), inverse, transform (a position).
template <class Lib, class T>
void enter_library(vec_mat_entries& to, const vec_mat_input<T>& in, const std::string& name) {
  using v3 = typename Lib::v3;
  using v4 = typename Lib::v4;
  using m4 = typename Lib::m4;
  const auto a = converted<v3>(in.a, Lib::make3), b = converted<v3>(in.b, Lib::make3);
  const auto v = converted<v4>(in.v, Lib::make4);
  const auto m = converted<m4>(in.m, Lib::make16), n = converted<m4>(in.n, Lib::make16);
  const std::size_t items = in.a.size();
  enter<T>(
      to, "dot3", name, items, 1, [=](std::size_t i) { return Lib::dot((*a)[i], (*b)[i]); },
      [](T x, int) { return x; });
  enter<v3>(to, "cross", name, items, 3, [=](std::size_t i) { return Lib::cross((*a)[i], (*b)[i]); }, Lib::get3);
  enter<T>(
      to, "length", name, items, 1, [=](std::size_t i) { return Lib::length((*a)[i]); }, [](T x, int) { return x; });
  enter<v3>(to, "normalize", name, items, 3, [=](std::size_t i) { return Lib::normalize((*a)[i]); }, Lib::get3);
  enter<v4, loop::one_at_a_time>(
      to, "mat4*vec4", name, items, 4, [=](std::size_t i) { return Lib::apply((*m)[i], (*v)[i]); }, Lib::get4);
  enter<m4>(
      to, "mat4*mat4", name, items, 16, [=](std::size_t i) { return Lib::multiply((*m)[i], (*n)[i]); }, Lib::get16);
  enter<m4, loop::one_at_a_time>(
      to, "inverse4", name, items, 16, [=](std::size_t i) { return Lib::inverse((*m)[i]); }, Lib::get16);
  const m4 affine = Lib::make16(in.affine);
  const auto transform = [&](const std::string& kernel, const auto& points) {
    const auto p = converted<v3>(points, Lib::make3);
    enter<v3>(
        to, kernel, name, points.size(), 3, [=](std::size_t i) { return Lib::transform(affine, (*p)[i]); }, Lib::get3);
  };
  transform("transform 4096", in.points_4096);
  transform("transform 1000000", in.points_million);
}

void enter_glm(vec_mat_entries& to, const vec_mat_input<float>& in);
void enter_glm(vec_mat_entries& to, const vec_mat_input<double>& in);
void enter_glm_simd(vec_mat_entries& to, const vec_mat_input<float>& in);
void enter_eigen(vec_mat_entries& to, const vec_mat_input<float>& in);
void enter_eigen(vec_mat_entries& to, const vec_mat_input<double>& in);

}  // namespace bench
