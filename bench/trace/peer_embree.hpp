// SPDX-License-Identifier: MIT
// Embree with one thread. Where it is not installed, its times are not numbers.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#ifdef IRG_HAVE_EMBREE
#include <embree3/rtcore.h>
#include <xmmintrin.h>
#endif

namespace bench {

struct camera_ray {
  float origin[3], direction[3], low, high;
};

enum class embree_task { closest, any, packets };
enum class embree_quality { low, medium, high };  // by Morton order, by surface area, with spatial splits

#ifdef IRG_HAVE_EMBREE

/// The scene over triangles, and how long building it took.
template <class Triangle, class Clock>
RTCScene embree_scene(const std::vector<Triangle>& triangles, embree_quality chosen, const Clock& now,
                      double& seconds) {
  constexpr unsigned flushes = 0x8040;  // subnormal results and subnormal operands count as zero
  _mm_setcsr(_mm_getcsr() | flushes);
  const RTCDevice device = rtcNewDevice("threads=1");
  const RTCScene scene = rtcNewScene(device);
  const RTCBuildQuality quality = chosen == embree_quality::low      ? RTC_BUILD_QUALITY_LOW
                                  : chosen == embree_quality::medium ? RTC_BUILD_QUALITY_MEDIUM
                                                                     : RTC_BUILD_QUALITY_HIGH;
  rtcSetSceneBuildQuality(scene, quality);
  const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  rtcSetGeometryBuildQuality(geometry, quality);
  auto* const vertex = static_cast<float*>(
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 12, 3 * triangles.size()));
  auto* const index = static_cast<unsigned*>(
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12, triangles.size()));
  for (std::size_t i = 0; i < 3 * triangles.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis) vertex[3 * i + static_cast<std::size_t>(axis)] = triangles[i / 3][i % 3][axis];
    index[i] = static_cast<unsigned>(i);
  }
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene, geometry);
  const double start = now();
  rtcCommitScene(scene);
  seconds = now() - start;
  return scene;
}

template <class Triangle, class Clock>
double embree_build_seconds(const std::vector<Triangle>& triangles, embree_quality chosen, const Clock& now) {
  double seconds = 0;
  embree_scene(triangles, chosen, now, seconds);
  return seconds;
}

template <class R>
void set_ray(R& to, const camera_ray& r) {
  to.org_x = r.origin[0], to.org_y = r.origin[1], to.org_z = r.origin[2];
  to.dir_x = r.direction[0], to.dir_y = r.direction[1], to.dir_z = r.direction[2];
  to.tnear = r.low, to.tfar = r.high;
  to.mask = ~0u, to.flags = 0, to.time = 0;
}

template <class Triangle, class Clock>
double embree_ray_seconds(const std::vector<Triangle>& triangles, const std::vector<camera_ray>& rays,
                          embree_quality chosen, embree_task task, const Clock& now) {
  double seconds = 0;
  const RTCScene scene = embree_scene(triangles, chosen, now, seconds);
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  if (task == embree_task::packets) context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  alignas(64) int valid[16];
  for (int& v : valid) v = -1;
  const auto trace_all = [&] {
    if (task == embree_task::packets) {
      for (std::size_t i = 0; i + 16 <= rays.size(); i += 16) {
        RTCRayHit16 p;
        for (std::size_t k = 0; k < 16; ++k) {
          const camera_ray& r = rays[i + k];
          p.ray.org_x[k] = r.origin[0], p.ray.org_y[k] = r.origin[1], p.ray.org_z[k] = r.origin[2];
          p.ray.dir_x[k] = r.direction[0], p.ray.dir_y[k] = r.direction[1], p.ray.dir_z[k] = r.direction[2];
          p.ray.tnear[k] = r.low, p.ray.tfar[k] = r.high;
          p.ray.mask[k] = ~0u, p.ray.flags[k] = 0, p.ray.time[k] = 0;
          p.hit.geomID[k] = p.hit.instID[0][k] = RTC_INVALID_GEOMETRY_ID;
        }
        rtcIntersect16(valid, scene, &context, &p);
      }
    } else {
      for (const camera_ray& r : rays) {
        if (task == embree_task::any) {
          RTCRay one;
          set_ray(one, r);
          rtcOccluded1(scene, &context, &one);
        } else {
          RTCRayHit one;
          set_ray(one.ray, r);
          one.hit.geomID = one.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
          rtcIntersect1(scene, &context, &one);
        }
      }
    }
  };
  trace_all();  // a process of its own sees each page of the rays for the first time: not the tree's time
  const double start = now();
  trace_all();
  return now() - start;
}

#else

template <class Triangle, class Clock>
double embree_build_seconds(const std::vector<Triangle>&, embree_quality, const Clock&) {
  return std::numeric_limits<double>::quiet_NaN();
}
template <class Triangle, class Clock>
double embree_ray_seconds(const std::vector<Triangle>&, const std::vector<camera_ray>&, embree_quality, embree_task,
                          const Clock&) {
  return std::numeric_limits<double>::quiet_NaN();
}

#endif

}  // namespace bench
